// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/param.hpp"
#include "wcam/toolpath/toolpath.hpp"

namespace wcam::process {

/// Wire, feed and windows of a wire-arc process with constant wire feed.
struct ProcessParams {
  Length wireDiameter = 1.2_mm;
  WireSpeed wireSpeed = 6.0_m_min;
  WireSpeed wireSpeedMin = 2.0_m_min;
  Length beadWidth = 8.0_mm;
  Speed speedMin = 1.5_mm_s;
  Speed speedMax = 10.0_mm_s;  ///< humping of wires of 0.8 and 1.2 mm (Chalvin A1)
  Length heightMin = 1.0_mm;
  Length heightMax = 7.0_mm;
  double density = 7.85;  ///< g/cm³
  int job = 1;
  Duration craterTime = 0.5_s;

  static const Schema<ProcessParams>& schema();
};

/// Section of one layer of a wall of stacked discs of diameter `width`, pitch `height`:
/// S = h·√(R² − h²/4) + 2R²·asin(h/2R), R = width/2, mm² (Diourté M27). Defined for 0 ≤ height ≤
/// width; larger heights give the section at height = width, where the discs only touch.
double wallSection(double height, double width) noexcept;

/// Section of a bead at a point, mm²: fillWidth·height beside neighbours that share the layer,
/// else wallSection(height, width).
double beadSection(const toolpath::PathPoint& point) noexcept;

/// Travel speed that deposits the section of a height: v = (π d²/4)·v_wire / S(h), mm/s (Diourté
/// M26).
double travelSpeed(double height, const ProcessParams& params) noexcept;

/// The same for a bead of another width than the process's, mm/s.
double travelSpeed(double height, double width, const ProcessParams& params) noexcept;

/// Height that a travel speed deposits, the inverse of travelSpeed, mm; limited to the bead width.
double depositedHeight(double speed, const ProcessParams& params) noexcept;

/// Wire feed of the whole operation, mm/s: the process's, or less where beads would get too much at
/// the maximum travel speed: the highest feed that deposits at most 1 % too much, in hundredths of
/// a m/min, not below wireSpeedMin, nor where more would then be missing at the minimum speed. One
/// feed, since it usually belongs to the job
/// of the welding source.
/// @param path with the widths that its beads fill
double operationWireSpeed(const toolpath::Toolpath& path, const ProcessParams& params);

struct ProcessStatistics {
  double length = 0.0;        ///< of the beads, mm
  double time = 0.0;          ///< with the arc on, s
  double wireLength = 0.0;    ///< mm
  double wireVolume = 0.0;    ///< mm³: what the torch deposits
  double wantedVolume = 0.0;  ///< mm³: section that the layer needs, times length
  double mass = 0.0;          ///< g
  std::size_t clampedPoints = 0;
};

ProcessStatistics processStatistics(const toolpath::Toolpath& path, const ProcessParams& params);

/// Sets width, wire speed and travel speed of every point: the speed of the move that ends at a
/// point follows its height and its width, clamped to the speed window. A width that the path
/// brings along is kept; 0 becomes the process's. Factors of ramps apply to the clamped speed,
/// inside the window, and to the wire; moves with the arc off get no wire.
///
/// Beads that lie nearer together than their width share what is between them: their sections are
/// those that they have to fill (PathPoint::fillWidth; strategies that fill areas set it, all
/// others get it here, see shareTouchingBeads). The wire feed is that of operationWireSpeed.
///
/// Where edits change a move (PathPoint::change) the section of the bead stays consistent: either
/// the other of speed and wire follows so that the section of the local height is deposited, or the
/// width becomes that of the section which speed and wire make. Ramps change no width.
///
/// Findings, one per layer with the worst value and the count: process.speed_clamped,
/// process.height_out_of_range, process.section_too_small, process.wire_lowered.
/// @throws Error(InvalidArgument) when the windows contradict each other
toolpath::Toolpath applyProcess(toolpath::Toolpath path,
                                const ProcessParams& params,
                                const JobContext& context);

}  // namespace wcam::process
