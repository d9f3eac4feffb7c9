// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/joints.hpp"

#include <cstddef>
#include <span>

namespace wcam::collision {

/// A state of the cell at a moment of the build.
struct CellState {
  cell::JointVector joints;   ///< robot, then positioner
  std::size_t deposited = 0;  ///< how many points of the toolpath (all layers and beads, in order)
                              ///< are deposited by then
};

/// How far everything that moves keeps from everything that it must not touch: torch and arm from
/// the cell, the positioner, the substrate and what is deposited by then.
class Clearance {
public:
  Clearance() = default;
  Clearance(const Clearance&) = delete;
  Clearance& operator=(const Clearance&) = delete;
  virtual ~Clearance() = default;

  /// Lower bound of the distance of each state less the safety distance, mm: free where it is not
  /// negative. Conservative: a state that touches is never called free. Thread-safe, made for many
  /// states per call; values above the reach of the search are cut off.
  virtual void evaluate(std::span<const CellState> states, std::span<float> clearance) const = 0;
};

}  // namespace wcam::collision
