// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/motion/speed_law.hpp"

/// Parts of speedLaw. Private to this module.
namespace wcam::motion::detail {

/// The path in pieces: before point i the straight rest of its segment, around it its zone.
struct SpeedPieces {
  int width = 8;                 ///< joints, padded
  std::vector<double> slope;     ///< points × width: q' of the segment over the joint's limit
  std::vector<double> straight;  ///< length of the straight piece before the zone of point i
  std::vector<double> zone;      ///< length 2δ of the zone around point i
  std::vector<double> cap;       ///< greatest x of the segment that ends at i
  std::vector<double> gain;      ///< greatest |s̈| of it
  std::vector<double> zoneCap;   ///< greatest x in the zone of point i
};

/// x at the ends of the zones, before and after each point.
struct SpeedNodes {
  std::vector<double> before;
  std::vector<double> after;
};

/// Both passes. `nodes` must have the size of the path.
void reachSpeeds(const SpeedPieces& pieces, SpeedNodes& nodes);

/// A time in which s̈ is constant.
struct SpeedInterval {
  double time = 0.0;
  double speed = 0.0;  ///< at its start
  double acceleration = 0.0;
};

/// Intervals of the whole law in their order; `marks[i]` is the number of intervals before point i.
void speedIntervals(const SpeedPieces& pieces,
                    const SpeedNodes& nodes,
                    std::vector<SpeedInterval>& intervals,
                    std::vector<std::size_t>& marks);

/// The law averaged over `window` seconds, with the figures that tell how far it stays in the
/// limits.
struct FilteredLaw {
  SpeedLaw law;
  double accelerationShare = 0.0;  ///< greatest joint acceleration over its limit
  double jerkShare = 0.0;
  double speedShare = 0.0;
};

FilteredLaw averageLaw(const SpeedPath& path,
                       const SpeedLimits& limits,
                       const SpeedPieces& pieces,
                       const std::vector<SpeedInterval>& intervals,
                       double window,
                       const JobContext& context);

}  // namespace wcam::motion::detail
