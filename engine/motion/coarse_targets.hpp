// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plan_detail.hpp"

#include <cstddef>
#include <vector>

/// The search of the optimized mode costs some 100 µs per target. Its course follows the shape of
/// the path, not its sampling: on long paths it is searched on some of the targets and spread over
/// all of them. Private to this module.
namespace wcam::motion::detail {

/// Paths up to this many targets are searched on all of them.
inline constexpr std::size_t kSearchedTargets = 50000;

/// Targets that stand for all others, ascending: every travel move, both ends of each bead, where
/// the arc starts or stops, and points at most a spacing apart that makes about kSearchedTargets of
/// them, nearer where tool axis, build direction or travel direction turn. Empty where all of them
/// are to be used. O(n).
std::vector<std::size_t> coarseTargets(const std::vector<Target>& targets,
                                       std::size_t wanted = kSearchedTargets);

/// Operations with more beads are not searched at all: every bead has choices of its own, and its
/// travel moves cost as much as a bead of 20 points.
inline constexpr std::size_t kSearchedBeads = 10000;

/// Targets of beads evenly spread over the operation, on which its modes are compared: about
/// `wanted` beads.
std::vector<std::size_t> sampledBeads(const Runs& runs, std::size_t wanted = kSearchedBeads / 5);

/// The choices of all targets from those of the kept ones: cubics along each bead that do not
/// overshoot; where the free angle turns far between two kept targets, the tool frame turns evenly
/// instead. The branches of the runs stay. O(n).
Resolution spreadOverTargets(const Task& task,
                             const std::vector<std::size_t>& kept,
                             const Resolution& coarse,
                             const JobContext& context);

}  // namespace wcam::motion::detail
