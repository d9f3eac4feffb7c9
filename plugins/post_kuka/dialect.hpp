// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/param.hpp"

#include <string>

namespace kuka {

enum class Mode { Cartesian, Joint };
enum class Ptp { Axes, Cartesian };
enum class Arc { Output, Template, None };
enum class Approximation { Distance, Velocity, None };
enum class AngleRange { Wrapped, Continuous };
enum class Comments { None, Layers, Beads };

/// What differs between controllers and shops. One parameter each.
struct Dialect {
  Mode mode = Mode::Cartesian;
  Ptp ptp = Ptp::Axes;
  int lengthDecimals = 3;
  int angleDecimals = 4;
  AngleRange angleRange = AngleRange::Wrapped;
  int maxPoints = 0;
  int maxLines = 9999;
  std::string programName;
  Comments comments = Comments::Layers;
  bool coupled = true;
  int machine = 2;
  int base = 1;
  int tool = 1;
  int externalAxisCount = 0;
  std::string status;
  int advance = 3;
  Approximation approximation = Approximation::Distance;
  wcam::Length approximationDistance{1.0};
  int approximationVelocity = 50;
  int speedDecimals = 5;
  Arc arc = Arc::Output;
  int arcOutput = 1;
  std::string arcOn = "ARC_ON({job})";
  std::string arcOff = "ARC_OFF()";
  std::string wireVariable;
};

/// Longest name of a KRL program.
inline constexpr std::size_t kLongestName = 24;

wcam::Schema<Dialect> dialectSchema();

}  // namespace kuka
