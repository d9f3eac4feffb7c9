// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/motion/speed_law.hpp"

/// Parts of speedLaw. Private to this module.
namespace wcam::motion::detail {

/// Speeds beyond this are none (mm/s): keeps sums and products finite.
inline constexpr double kMostSpeed = 1e6;

/// The path, or a block of it, in pieces: before point i the straight rest of its segment, around
/// it its zone. Entry k is of point first + k.
struct SpeedPieces {
  int width = 8;                 ///< joints, padded
  std::size_t first = 0;         ///< point of the first entry
  std::vector<double> slope;     ///< points × width: q' of the segment over the joint's limit
  std::vector<double> straight;  ///< length of the straight piece before the zone of point i
  std::vector<double> zone;      ///< length 2δ of the zone around point i
  std::vector<double> cap;       ///< greatest x of the segment that ends at i
  std::vector<double> gain;      ///< greatest |s̈| of it
  std::vector<double> zoneCap;   ///< greatest x in the zone of point i

  void resize(std::size_t points);
};

/// The pieces of the whole path: one entry per point.
SpeedPieces makePieces(const SpeedPath& path, const SpeedLimits& limits);

/// All that the points [begin, end) need, begin ≥ 1: the entries of the points beside them are
/// complete as far as these touch them. Memory of `pieces` is used again.
void fillPieces(const SpeedPath& path,
                const SpeedLimits& limits,
                std::size_t begin,
                std::size_t end,
                SpeedPieces& pieces);

/// x at the ends of the zones, before and after each point; as many as points.
struct SpeedNodes {
  std::vector<double> before;
  std::vector<double> after;
};

/// The backward pass over the points [begin, end), from the end of the path (where both nodes are
/// 0) block by block.
void reachBackward(
    const SpeedPieces& pieces, std::size_t begin, std::size_t end, double* before, double* after);

/// The forward pass over them, after the backward pass. `previous`: the node after point begin − 1.
void reachForward(const SpeedPieces& pieces,
                  std::size_t begin,
                  std::size_t end,
                  double previous,
                  double* before,
                  double* after);

/// Both passes over the whole path.
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
