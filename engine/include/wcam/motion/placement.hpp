// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/collision/cell_collision.hpp"
#include "wcam/motion/plan.hpp"

#include <string>
#include <vector>

namespace wcam::motion {

/// Where places of the part are looked for: a grid about the present one, then finer around the
/// best.
struct PlacementSearch {
  double rangeX = 200.0;  ///< either way in the part frame, mm
  double rangeY = 200.0;
  double rangeZ = 0.0;
  double step = 50.0;                    ///< mm
  double turnStep = degToRad(30.0);      ///< about the part's z; a full turn is looked at
  int refinements = 3;                   ///< halvings of the steps
  std::size_t samples = 48;              ///< points of the path that a place is judged by
  double rotationStep = degToRad(30.0);  ///< of the torch about its axis
};

/// A place of the part: what it is moved by, and what it offers at the sampled points with the
/// configuration and constant rotation about the torch that suit it best.
struct PartPlace {
  geometry::Vec3 move = geometry::Vec3::Zero();  ///< mm, part frame
  double turn = 0.0;                             ///< rad, about the part's z, before the move
  std::size_t failing = 0;     ///< points out of reach, outside limits or margins, or colliding
  double reachMissing = 0.0;   ///< greatest, mm
  double limitMargin = 0.0;    ///< smallest to a joint limit, rad, or mm/100; negative outside
  double wristBend = 0.0;      ///< smallest, rad
  double elbowBend = 0.0;      ///< smallest, rad: also the margin of reach
  double axisDistance = 0.0;   ///< smallest of the wrist centre to axis 1, mm
  double dexterity = 0.0;      ///< smallest
  double clearance = 0.0;      ///< smallest less the safety distance, mm
  std::string branch;          ///< cell::InverseKinematics::branchName
  double torchRotation = 0.0;  ///< rad
  /// Smallest of the margins, each against what is comfortable (1): 30° to limits and
  /// singularities, 200 mm from axis 1, 0.3 of dexterity and 20 mm of clearance more than the
  /// parameters ask for. Negative when a point fails or comes nearer than the safety distance.
  double score = 0.0;

  [[nodiscard]] bool betterThan(const PartPlace& other) const;
  /// What moves the part frame's content.
  [[nodiscard]] geometry::Pose pose() const;
};

struct PlacementMap {
  std::vector<PartPlace> places;  ///< in the order of the search; the first is the present place
  std::size_t best = 0;
};

/// Searches a feasible place of the part on its table. Every place is judged by itself: positioner
/// by gravity, one configuration and one rotation about the torch for all points. What planning
/// then finds is at least as good. About 2 ms per place and 48 samples; deterministic.
/// @param collision of the path at the present place; may be null
/// @throws Error(JobFailed) when the robot has no closed-form inverse kinematics,
/// Error(InvalidArgument) for steps that are not positive; CancelledError
PlacementMap searchPlacement(const toolpath::Toolpath& path,
                             const cell::Cell& cell,
                             const collision::CellCollision* collision,
                             const MotionParams& params,
                             const PlacementSearch& search,
                             const JobContext& context);

}  // namespace wcam::motion
