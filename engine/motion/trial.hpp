// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/collision/cell_collision.hpp"
#include "wcam/motion/plan.hpp"

#include "cell_model.hpp"

#include <optional>

namespace wcam::motion::detail {

/// A position of the motion that is looked at alone.
struct TrialPoint {
  const toolpath::PathPoint* point = nullptr;  ///< null for a travel move
  geometry::Pose T_part_tcp = geometry::Pose::Identity();
  cell::JointVector joints;  ///< as planned
  std::size_t deposited = 0;
};

/// What is changed at a trial.
struct Change {
  double rotation = 0.0;  ///< about the tool axis, rad
  double lateral = 0.0;   ///< tilt, rad
  double lead = 0.0;      ///< rad
  int branch = -1;        ///< −1: that of the planned joints
  int positioner = 0;     ///< 1: the positioner's other solution
  /// In the cell's other configuration: only rotation, branch and positioner count.
  bool other = false;
  geometry::Vec3 onTable = geometry::Vec3::Zero();  ///< of the part, table frame, mm
  double turn = 0.0;                                ///< of the part about the table's z, rad
  geometry::Vec3 inBase = geometry::Vec3::Zero();   ///< of the positioner, base frame, mm
};

/// What a position offers; margins are negative where it fails.
struct TrialResult {
  bool reachable = false;
  double missing = 0.0;      ///< of the reach, mm
  double limitMargin = 0.0;  ///< smallest, rad (of linear joints over kLengthPerRadian); infinite
                             ///< when all joints are endless
  int limitJoint = -1;
  double wrist = 0.0;      ///< bend of the wrist, rad
  double elbow = 0.0;      ///< rad
  double shoulder = 0.0;   ///< wrist centre to axis 1, mm
  double cable = 0.0;      ///< twist of the torch's cable beyond its limit, rad; 0 inside
  double clearance = 0.0;  ///< less the safety distance, mm; 0 when it is not looked at
  cell::JointVector joints;

  /// Reachable, inside limits and margins, free.
  [[nodiscard]] bool right(const MotionParams& params) const;
};

/// Tries positions with changes. Thread-safe.
class Trial {
public:
  Trial(const cell::Cell& cell,
        const collision::CellCollision* collision,
        const MotionParams& params);  ///< with the cell's cable limit (withCable)

  /// @param withCollision ask the model as well (only when all else is right)
  [[nodiscard]] TrialResult at(const TrialPoint& point,
                               const Change& change,
                               bool withCollision) const;

  /// Another configuration can be tried.
  [[nodiscard]] bool hasOther() const { return cell_.other != nullptr; }

private:
  [[nodiscard]] TrialResult inOther(const TrialPoint& point, const Change& change) const;

  const cell::Cell& cell_;
  CellModel model_;
  const collision::CellCollision* collision_;
  const MotionParams& params_;
};

}  // namespace wcam::motion::detail
