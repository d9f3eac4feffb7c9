// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/param.hpp"
#include "wcam/toolpath/fill.hpp"
#include "wcam/toolpath/plane_field.hpp"
#include "wcam/toolpath/slicing.hpp"

namespace wcam::bulk {

enum class OpenSections { Refuse, Bead };

struct Params {
  Length step = 2.0_mm;
  double firstLayer = 1.0;
  toolpath::LastLayer last = toolpath::LastLayer::Fit;
  Length endHeight = 0.0_mm;
  bool customDirection = false;
  std::array<double, 3> direction{0.0, 0.0, 1.0};
  toolpath::FillPattern pattern = toolpath::FillPattern::Zigzag;
  int walls = 1;
  int insets = 2;
  Length width = 0.0_mm;
  double overlap = 0.667;
  toolpath::BeadReference reference = toolpath::BeadReference::Inside;
  toolpath::InsetOrder order = toolpath::InsetOrder::Automatic;
  Angle angle = 0.0_deg;
  Angle angleStep = 90.0_deg;
  Length minWidth = 0.0_mm;
  Length maxWidth = 0.0_mm;
  Length minLength = 0.0_mm;
  bool fillNarrow = true;
  double minArea = 0.0;
  OpenSections openSections = OpenSections::Refuse;
  double leastCoverage = 0.95;
  double mostFill = 1.15;

  static const Schema<Params>& schema();

  [[nodiscard]] toolpath::PlaneStackOptions planes(const toolpath::BeadRange& process) const;
  /// @param process what the operation's process deposits
  /// @throws Error(InvalidArgument) when the range of widths does not hold the width
  [[nodiscard]] toolpath::FillOptions fill(const toolpath::BeadRange& process,
                                           const toolpath::Sampling& sampling) const;
};

}  // namespace wcam::bulk
