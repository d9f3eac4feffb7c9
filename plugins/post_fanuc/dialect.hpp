// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/param.hpp"

#include <string>

namespace fanuc {

enum class Mode { Joint, Cartesian };
enum class NameLength { Long, Short };
enum class GroupFields { Five, Seven };
enum class SpeedUnit { MmPerSecond, CmPerMinute };
enum class Termination { Cnt, Fine };
enum class Frame { Base, Table };
enum class TurnAxes { J1J4J6, J4J5J6 };
enum class Comments { None, Layers, Beads };
enum class Crater { Wait, Schedule };

/// What differs between controllers and shops. One parameter each.
struct Dialect {
  Mode mode = Mode::Joint;
  int jointDecimals = 4;
  int cartesianDecimals = 3;
  int maxPoints = 15000;
  int maxLines = 9999;
  std::string programName;
  NameLength nameLength = NameLength::Long;
  GroupFields groupFields = GroupFields::Five;
  int userFrame = 0;
  int remoteFrame = 1;
  int toolFrame = 1;
  int positionerUserFrame = 0;
  int positionerToolFrame = 1;
  Frame frame = Frame::Base;
  bool coordinated = true;
  bool remoteTool = true;
  TurnAxes turnAxes = TurnAxes::J1J4J6;
  SpeedUnit speedUnit = SpeedUnit::MmPerSecond;
  int speedDecimals = 1;
  Termination termination = Termination::Cnt;
  int cnt = 100;
  int arcStart = 0;
  int arcEnd = 0;
  Crater crater = Crater::Wait;
  int wireRegister = 0;
  int payload = 0;
  Comments comments = Comments::Layers;

  [[nodiscard]] std::size_t longestName() const {
    // R-30iA and older take 8 characters, R-30iB 36.
    return nameLength == NameLength::Long ? 36 : 8;
  }

  [[nodiscard]] int groups() const { return groupFields == GroupFields::Five ? 5 : 7; }
};

wcam::Schema<Dialect> dialectSchema();

}  // namespace fanuc
