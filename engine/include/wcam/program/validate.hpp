// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/diagnostic.hpp"
#include "wcam/program/program.hpp"

#include <vector>

/// Rules that every program keeps before a post-processor may print it.
namespace wcam::program {

/// Checks a program: at least one move, the first one a joint move; every number finite; rotations
/// orthonormal; joint counts as the cell says; speeds above 0 and speed ratios in (0, 1]; arc on
/// and off in turns, after a move, off at the end; layer and bead marks nested; waiting times and
/// wire speeds not negative. A joint move with the arc on is a warning.
///
/// One finding per rule ("program.<rule>"), at the first place that breaks it, with the number of
/// places as data "count". Cost: O(instructions).
std::vector<Diagnostic> validate(const Program& program);

/// Does nothing for a program without violations. @throws Error(JobFailed) that lists them
void requireValid(const Program& program);

/// Poses and joints are looked at through this, so that no move kind is forgotten.
/// Calls visit(const Target&) for each target of a move (via first); none for other instructions.
template <class Visit>
void forEachTarget(const Action& action, const Visit& visit) {
  if (const auto* joint = std::get_if<MoveJoint>(&action)) {
    visit(joint->target);
  } else if (const auto* linear = std::get_if<MoveLinear>(&action)) {
    visit(linear->target);
  } else if (const auto* circular = std::get_if<MoveCircular>(&action)) {
    visit(circular->via);
    visit(circular->target);
  }
}

}  // namespace wcam::program
