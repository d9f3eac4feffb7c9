// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <vector>

namespace wcam::cli {

/// What the command line says, as CLI11 fills it.
struct Options {
  // camcli --project, check
  std::string project;
  std::string output;  ///< folder; for apply the project file to write
  std::vector<std::string> posts;
  std::vector<std::string> operations;
  std::vector<std::string> settings;
  bool table = false;
  bool allowOutside = false;
  std::string report;
  bool check = false;
  // all verbs
  bool json = false;
  int threads = 0;
  bool quiet = false;
  std::vector<std::string> budget;  ///< KEY=N
  std::vector<std::string> plugins;
  bool noUserPlugins = false;
  // verbs
  std::string file;         ///< new, info, apply, check, edit, speed
  std::string commands;     ///< apply
  std::string part;         ///< new
  std::string cell;         ///< new, speed
  std::string name;         ///< new
  std::string component;    ///< schema
  std::string shell;        ///< completion
  std::string joints;       ///< speed: initial values
  std::string zero;         ///< speed: zero convention of the initial values
  std::string speed;        ///< speed: wanted
  double tolerance = 0.05;  ///< speed
  // place
  std::string placedOperation;
  bool applyPlace = false;
  double placeRange = 200.0;  ///< mm
  double placeHeight = 0.0;   ///< mm
  double placeStep = 50.0;    ///< mm
  double placeTurn = 30.0;    ///< degrees
  std::string map;            ///< CSV file
  // edit
  std::string editedOperation;
  std::string edit;      ///< id
  std::string editType;  ///< add
  bool enable = false;
  bool disable = false;
  int index = -1;  ///< place in the list; -1: at the end
};

}  // namespace wcam::cli
