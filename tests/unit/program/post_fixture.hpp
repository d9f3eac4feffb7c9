// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/value.hpp"
#include "wcam/program/program.hpp"

#include "read_job.hpp"

#include <string>
#include <utility>
#include <vector>

namespace wcam::test {

using Files = std::vector<std::pair<std::string, std::string>>;

/// Runs a post-processor plugin of the build tree. `params` is JSON.
Files runPost(const std::string& id,
              const program::Program& program,
              const std::string& params = "{}",
              const JobContext& context = JobContext());

/// A move as the program plans it.
struct PlannedMove {
  ReadKind kind = ReadKind::Linear;
  program::Target target;
  double speed = 0.0;  ///< as in ReadMove
  bool stop = false;
  bool arc = false;
};

std::vector<PlannedMove> plannedMoves(const program::Program& program);

/// Angle between two rotations, degrees.
double angleBetween(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);

/// Compares kind, stop and (with `arcs`) arc of every move, and the positioner to `jointTolerance`
/// (degrees). False when a comparison of positions makes no sense.
bool sameStructure(const ReadJob& job,
                   const std::vector<PlannedMove>& planned,
                   double jointTolerance,
                   bool arcs = true);

/// A program of random targets with `moves` linear moves in beads; seeded.
program::Program randomProgram(unsigned seed, int beads, int pointsPerBead);

}  // namespace wcam::test
