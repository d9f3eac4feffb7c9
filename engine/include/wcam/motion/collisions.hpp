// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/collision/cell_collision.hpp"
#include "wcam/motion/plan.hpp"

#include <vector>

namespace wcam::motion {

/// Figures of the collision check of a motion.
struct CollisionStatistics {
  bool checked = false;        ///< false without shapes in the cell, or when it is switched off
  double leastDistance = 0.0;  ///< mm, negative: depth; cut off at the reach of the search
  std::size_t states = 0;      ///< looked at, with those between the points of travel moves
  std::size_t collidingPoints = 0;  ///< waypoints in collision, or on the way to them
  std::size_t nearPoints = 0;       ///< below the safety distance, without the colliding ones
  std::size_t turnedPoints = 0;     ///< by exit rotations
  double greatestExit = 0.0;        ///< rad
  /// Least distance on the way to each waypoint and at it, mm, negative: depth; cut off like
  /// leastDistance. NaN where the waypoint is not reached; empty when nothing was checked.
  std::vector<float> distance;
};

/// States of a motion with what is deposited by then. The moves between beads are followed in steps
/// of joints, so that nothing is passed through.
struct MotionStates {
  std::vector<collision::CellState> states;
  std::vector<std::size_t> waypoint;  ///< the one that each state leads to
};

MotionStates motionStates(const Motion& motion, const toolpath::Toolpath& path);

/// Compares every state of a motion with the model of the cell.
///
/// Findings, one per bead, with the worst place: motion.collision (violation: what against what,
/// how deep, which bead it touches), motion.near_collision (warning: below the safety distance).
/// Unreachable waypoints are left out.
CollisionStatistics checkCollisions(const Motion& motion,
                                    const toolpath::Toolpath& path,
                                    const collision::CellCollision& collision,
                                    const std::string& operationId,
                                    const JobContext& context);

/// What stands inside something else and no motion changes it, at the positions that the motion
/// reaches: substrate and beads with what carries them and what is fixed beside them.
/// motion.standing_collision, a violation for each pair.
/// @param statistics its least distance becomes negative
void checkStanding(const Motion& motion,
                   const toolpath::Toolpath& path,
                   const collision::CellCollision& collision,
                   const std::string& operationId,
                   CollisionStatistics& statistics,
                   const JobContext& context);

/// Tilt of the torch about its TCP, rad: about the direction of travel, and before that about the
/// direction across (build direction × travel).
struct Tilt {
  double lateral = 0.0;
  double lead = 0.0;

  [[nodiscard]] bool none() const { return lateral == 0.0 && lead == 0.0; }
};

/// Exit rotations of a toolpath, per point in order over all layers and beads.
struct ExitRotations {
  std::vector<Tilt> needed;   ///< by the points that would collide, none elsewhere
  std::vector<Tilt> applied;  ///< the smooth course along each bead
  std::size_t unsolved = 0;   ///< points that no tilt within the tolerances frees
  bool changed = false;       ///< by the last call
};

/// Turns the torch out of the part (Diourté M34, general): where the torch at a waypoint comes
/// nearer to part or substrate than the safety distance, the tool turns about the TCP by the
/// smallest lateral, else lead, else combined tilt within the tolerances that frees it on all
/// sides. Along a bead the tilts rise and fall by at most params.exitRate, around a closed bead
/// without a jump; points that touch nothing lean along with their neighbours.
/// @param motion planned with the axes of `before`
/// @param path with the axes before any exit rotation
ExitRotations findExits(const Motion& motion,
                        const toolpath::Toolpath& path,
                        const collision::CellCollision& collision,
                        const MotionParams& params,
                        const ExitRotations& before,
                        const JobContext& context);

/// The path with its axes turned; positions, `up` and everything else stay as they are.
toolpath::Toolpath applyExits(const toolpath::Toolpath& path, const ExitRotations& exits);

/// Motion, its figures, and the path with what exit rotations changed.
struct CheckedMotion {
  PlannedMotion planned;
  CollisionStatistics collisions;
  toolpath::Toolpath path;  ///< empty when it is the one that was given
  bool pathChanged = false;
};

/// planMotion with everything around it: collision model, exit rotations where they are wanted (and
/// the motion planned again, until nothing changes or kExitPasses), checks, and findings whose
/// remedies are tried out (explain.hpp). Where the branch is automatic and the one that it takes
/// breaks limits of joints or cable or collides, the first one without any violation is taken
/// instead, if there is one: motion.configuration_chosen tells it.
/// @param substrate may be null
CheckedMotion planCheckedMotion(const toolpath::Toolpath& path,
                                const cell::Cell& cell,
                                const toolpath::Substrate* substrate,
                                const MotionParams& params,
                                const std::string& operationId,
                                const JobContext& context);

}  // namespace wcam::motion
