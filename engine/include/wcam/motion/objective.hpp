// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace wcam::motion {

/// What a joint motion can be good at; each is a cost, smaller is better. Sums run over the steps
/// inside beads, means over their points; "wanted speed" is the toolpath's. Steps and strokes of
/// linear joints count in mm as those of rotary ones do in degrees.
enum class Objective {
  Motion,  ///< Σ γ_j Δq_j² of the robot's joints in degrees, γ_j = 1/stroke, endless 0 (Chalvin
           ///< Eq. 4.3)
  Positioner,    ///< Σ Δq²/360 of the positioner's axes in degrees (γ of a full turn)
  Winding,       ///< Σ Δq²/360 of endless robot joints that carry a torch and its cable
  Transition,    ///< Σ Δq²/max(stroke, 360°) of all moves between beads, in degrees
  Speed,         ///< mean square of joint speed over its maximum, at the wanted speed
  Acceleration,  ///< mean square of joint acceleration over its maximum (file's, else see
                 ///< kRampTime)
  Jerk,          ///< mean square of joint jerk over its maximum
  Gravity,       ///< mean square angle between build direction and vertical, in degrees
  Dexterity,     ///< mean of (1 − dexterity)², dexterity as Chalvin Eq. 1.8, linear block
  Limits,        ///< mean of Σ_j ((q − middle)/(half the stroke))² (Liegeois, Chalvin Eq. 1.4)
  Uncertainty,   ///< mean of I² = trace(J·diag(σ²)·Jᵀ), µm² (Chalvin A34 corrected)
  TcpSpeed  ///< mean of (1 − predicted/wanted TCP speed)²; by the speeds of joints alone in a
            ///< motion without times whose cost does not depend on it
};

inline constexpr std::size_t kObjectiveCount = 12;

/// One number per Objective.
using ObjectiveValues = std::array<double, kObjectiveCount>;

/// Key of an objective in files: "motion", "positioner" …
const char* objectiveKey(Objective objective);

/// What no motion may break.
enum class Constraint {
  Reach,        ///< the robot can take the pose
  Limits,       ///< limits of joints and of sums of joints
  Collision,    ///< clearance (collision::Clearance) not negative
  Speed,        ///< joint speeds at the wanted speed
  Dexterity,    ///< minDexterity
  Singularity,  ///< wrist, elbow and shoulder margins
  Vertical,     ///< verticalTolerance, where the positioner cannot hold it: that above its best
  Cable,        ///< cableLimit
  Tilt          ///< tiltTolerance
};

inline constexpr std::size_t kConstraintCount = 9;
const char* constraintKey(Constraint constraint);

/// How good a motion is.
struct Evaluation {
  ObjectiveValues objectives{};
  double cost = 0.0;                                   ///< weighted sum of the objectives
  std::array<std::size_t, kConstraintCount> broken{};  ///< waypoints that break a constraint
  double excess = 0.0;  ///< sum of all violations, each over its own natural size

  [[nodiscard]] double value(Objective o) const { return objectives[static_cast<std::size_t>(o)]; }

  [[nodiscard]] std::size_t count(Constraint c) const {
    return broken[static_cast<std::size_t>(c)];
  }

  /// Waypoints that make a motion unfit: out of reach, limits, collision, a torch that leans
  /// further than the process allows, a cable twisted beyond its limit.
  [[nodiscard]] std::size_t violations() const;
  /// Waypoints that break any constraint (a waypoint counts once per constraint).
  [[nodiscard]] std::size_t allBroken() const;

  [[nodiscard]] bool feasible() const { return allBroken() == 0; }

  /// Fewer violations, then fewer broken constraints, then less excess, then lower cost.
  [[nodiscard]] bool betterThan(const Evaluation& other) const;
};

}  // namespace wcam::motion
