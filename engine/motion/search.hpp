// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "search_states.hpp"

#include <map>

namespace wcam::motion::detail {

/// Extra costs of states by rung: lane + kLanes·table (in the order of RungStates::tables).
using ExtraCosts = std::map<std::size_t, std::vector<float>>;

/// The best path through the states of all rungs.
struct SearchPath {
  double cost = 0.0;
  bool tableFree = false;           ///< a rung had more than one table sample
  std::vector<double> tableOffset;  ///< of the table from its reference, per rung, rad
  std::vector<double> torchSample;  ///< continuous inside runs (whole numbers, any turn)
  std::vector<int> branch;          ///< per rung
  std::vector<std::size_t> state;   ///< lane + kLanes·table index
};

/// Dynamic programming over the rungs (PERFORMANCE g1): one column of costs, 16-bit back pointers,
/// no stored edges. Inside a bead the branch stays and torch and table move by a band of samples
/// around standing still; the cost is that of Objective for steps (motion, positioner, winding,
/// speed) and for states (limits, gravity) with penalties for broken constraints. At a joint move
/// every branch and rotation may follow. Exact for the sampled states and the band, but for a joint
/// move from more than 512 states, which starts from the best of each branch and table sample.
/// About 0.3 ms per rung of 6912 states.
SearchPath searchGraph(const Task& task,
                       const SearchFrame& frame,
                       const ExtraCosts& extra,
                       const JobContext& context);

/// Free choices of all targets from a path: between rungs in proportion to the way.
Resolution resolutionOf(const Task& task, const SearchFrame& frame, const SearchPath& path);

/// Gauges of the torch rotation: constant, or following the tool's path (the third Bryant angle
/// that keeps the tool's x along the travel).
std::vector<double> constantGauge(const Task& task);
std::vector<double> followingGauge(const Task& task, std::size_t family);

}  // namespace wcam::motion::detail
