// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/plan.hpp"

#include "collision_params.hpp"
#include "plan_detail.hpp"

#include <array>

namespace wcam::motion {

namespace {

void addRedundancy(Schema<MotionParams>& schema) {
  schema
      .add(&MotionParams::mode,
           {.key = "mode",
            .label = "Redundancy",
            .help = "How the rotation about the torch, the positioner's axes and the robot's "
                    "configuration are chosen. Optimized is never worse than the others by the "
                    "weights of the objectives.",
            .group = "Redundancy",
            .choices = {{"optimized", "Optimized over the operation"},
                        {"constant", "Constant rotation about the torch"},
                        {"point_by_point", "Point by point"},
                        {"polynomial", "Polynomial in each bead"},
                        {"fixed", "Positioner at rest"},
                        {"constant_tool_axis", "Table turns the tool axis to one azimuth"},
                        {"fixed_tool_tip", "Table turns the point to one azimuth"},
                        {"homogeneous", "Table turns evenly along the bead"},
                        {"planar_vertical", "Robot in one plane, torch vertical"}}})
      .add(&MotionParams::polynomialDegree, {.key = "polynomial_degree",
                                             .label = "Degree of the polynomial",
                                             .help = "Of the rotation about the torch.",
                                             .group = "Redundancy",
                                             .level = ParamLevel::Advanced,
                                             .min = 0,
                                             .max = 8,
                                             .enabledIf = "mode=polynomial"})
      .add(
          &MotionParams::tableAngle,
          {.key = "table_angle",
           .label = "Angle of the table",
           .help = "Value of the table's axis at rest (fixed) or at the start of a bead "
                   "(homogeneous); azimuth in the table's frame at zero (constant tool axis, fixed "
                   "tool tip).",
           .group = "Redundancy",
           .level = ParamLevel::Advanced,
           .min = -360,
           .max = 360})
      .add(&MotionParams::tableTurn, {.key = "table_turn",
                                      .label = "Turn of the table per bead",
                                      .help = "Its sign is the sense.",
                                      .group = "Redundancy",
                                      .level = ParamLevel::Advanced,
                                      .min = -36000,
                                      .max = 36000,
                                      .enabledIf = "mode=homogeneous"})
      .add(&MotionParams::tiltTolerance,
           {.key = "tilt_tolerance",
            .label = "Tolerance of lead and lateral tilt",
            .help = "How far the tool axis may lean from the toolpath's. The mode planar_vertical "
                    "leans it until it is vertical; more than this is a violation.",
            .group = "Redundancy",
            .level = ParamLevel::Advanced,
            .min = 0,
            .max = 60})
      .add(&MotionParams::cableLimit,
           {.key = "cable_limit",
            .label = "Limit of the cable's twist",
            .help =
                "Of |J4 + J6|, from the untwisted cable's value; more is a violation. 0 takes the "
                "limit "
                "and the zero of the cell file, if it has them. 120 deg is usual for torch cables "
                "(Chalvin A33); a large value lifts the limit.",
            .group = "Redundancy",
            .min = 0,
            .max = 3600})
      .add(&MotionParams::cableZero, {.key = "cable_zero",
                                      .label = "Untwisted cable",
                                      .help = "J4 + J6 where the cable is not twisted; counts "
                                              "with a cable_limit of its own.",
                                      .group = "Redundancy",
                                      .level = ParamLevel::Advanced,
                                      .min = -360,
                                      .max = 360})
      .add(&MotionParams::jointResolution,
           {.key = "joint_resolution",
            .label = "Resolution of the joints",
            .help = "Standard deviation of joints whose resolution the cell file does not tell.",
            .group = "Redundancy",
            .level = ParamLevel::Advanced,
            .min = 0,
            .max = 1});
}

void addWeights(Schema<MotionParams>& schema) {
  const auto add = [&schema](double MotionParams::*field, const char* key, const char* label,
                             const char* help) {
    schema.add(field,
               {.key = key,
                .label = label,
                .help = help,
                .group = "Objectives",
                .level = ParamLevel::Advanced,
                .min = 0,
                .max = 1e6},
               ParamType::Real, QuantityKind::Ratio);
  };
  add(&MotionParams::weightMotion, "weight_motion", "Weight of the robot's motion",
      "Sum of squared joint steps over strokes, in degrees (Chalvin Eq. 4.3).");
  add(&MotionParams::weightPositioner, "weight_positioner", "Weight of the positioner's motion",
      "Sum of squared steps over 360 degrees.");
  add(&MotionParams::weightWinding, "weight_winding", "Weight of winding the cable",
      "Sum of squared steps of endless robot joints over 360 degrees; torch carried only.");
  add(&MotionParams::weightTransition, "weight_transition", "Weight of moves between beads",
      "Sum of squared joint moves over strokes, in degrees.");
  add(&MotionParams::weightSpeed, "weight_speed", "Weight of joint speeds",
      "Mean square of speed over its maximum, at the wanted travel speed.");
  add(&MotionParams::weightAcceleration, "weight_acceleration", "Weight of joint accelerations",
      "Mean square of acceleration over its maximum, at the wanted travel speed.");
  add(&MotionParams::weightJerk, "weight_jerk", "Weight of joint jerks",
      "Mean square of jerk over its maximum, at the wanted travel speed.");
  add(&MotionParams::weightGravity, "weight_gravity", "Weight of the vertical",
      "Mean square angle between build direction and vertical, in degrees.");
  add(&MotionParams::weightDexterity, "weight_dexterity", "Weight of dexterity",
      "Mean of (1 - dexterity) squared.");
  add(&MotionParams::weightLimits, "weight_limits", "Weight of the distance to limits",
      "Mean of the squared distance from the middle over half the stroke, all joints.");
  add(&MotionParams::weightUncertainty, "weight_uncertainty", "Weight of positioning uncertainty",
      "Mean square in micrometres (Chalvin A34).");
  add(&MotionParams::weightTcpSpeed, "weight_tcp_speed", "Weight of constant TCP speed",
      "Mean of (1 - predicted over wanted speed) squared, by the prediction of time and speed.");
}

void addTorch(Schema<MotionParams>& schema) {
  schema
      .add(&MotionParams::torchRotation,
           {.key = "torch_rotation",
            .label = "Rotation about the torch",
            .help = "Third Bryant angle of the tool frame (torch carried) or of the part (part "
                    "carried), where it is constant; start of point by point.",
            .group = "Torch",
            .min = -360,
            .max = 360})
      .add(
          &MotionParams::branch,
          {.key = "branch",
           .label = "Robot configuration",
           .help =
               "Wrist N or F, elbow up or down, shoulder to the front or back. Automatic takes one "
               "that reaches all points inside the limits, if it can with the shoulder to "
               "the front and the elbow up, and with the largest margin; where that one collides, "
               "breaks limits or twists the cable too far, the first one without violations.",
           .group = "Torch",
           .choices = {{"auto", "Automatic"},
                       {"nut", "N U T"},
                       {"nub", "N U B"},
                       {"ndt", "N D T"},
                       {"ndb", "N D B"},
                       {"fut", "F U T"},
                       {"fub", "F U B"},
                       {"fdt", "F D T"},
                       {"fdb", "F D B"}}});
}

void addTravel(Schema<MotionParams>& schema) {
  schema
      .add(&MotionParams::approachHeight,
           {.key = "approach_height",
            .label = "Approach height",
            .help = "Distance along the tool axis at which the torch leaves and meets the bead.",
            .group = "Travel",
            .min = 0,
            .max = 1000})
      .add(&MotionParams::safeHeight,
           {.key = "safe_height",
            .label = "Safe height",
            .help = "Height of travel moves above everything deposited so far.",
            .group = "Travel",
            .min = 0,
            .max = 5000})
      .add(&MotionParams::link,
           {.key = "link",
            .label = "Links between beads",
            .help = "Direct links are short, but joints that have turned far cannot turn back in "
                    "them.",
            .group = "Travel",
            .choices = {{"retract", "Always over the safe height"},
                        {"direct", "Straight where it is clear"}}})
      .add(&MotionParams::linkClearance,
           {.key = "link_clearance",
            .label = "Clearance of direct links",
            .help = "Height of a direct link above everything deposited below the torch.",
            .group = "Travel",
            .level = ParamLevel::Advanced,
            .min = 0,
            .max = 1000,
            .enabledIf = "link=direct"})
      .add(&MotionParams::torchRadius,
           {.key = "torch_radius",
            .label = "Radius of the torch",
            .help = "What is higher than a direct link must be this far beside it.",
            .group = "Travel",
            .level = ParamLevel::Advanced,
            .min = 0,
            .max = 1000,
            .enabledIf = "link=direct"})
      .add(&MotionParams::travelSpeed, {.key = "travel_speed",
                                        .label = "Travel speed",
                                        .help = "Speed of retract and approach moves.",
                                        .group = "Travel",
                                        .min = 0.1,
                                        .max = 5000})
      .add(&MotionParams::jointSpeedRatio,
           {.key = "joint_speed_ratio",
            .label = "Joint speed of travel moves",
            .help = "Part of the greatest joint speed.",
            .group = "Travel",
            .min = 0.001,
            .max = 1},
           ParamType::Real, QuantityKind::Ratio);
}

void addChecks(Schema<MotionParams>& schema) {
  schema
      .add(&MotionParams::minDexterity,
           {.key = "min_dexterity",
            .label = "Least dexterity",
            .help = "Ratio of the smallest to the largest singular value of the robot's linear "
                    "Jacobian below which a finding is given.",
            .group = "Checks",
            .level = ParamLevel::Advanced,
            .min = 0,
            .max = 1},
           ParamType::Real, QuantityKind::Ratio)
      .add(&MotionParams::wristMargin, {.key = "wrist_margin",
                                        .label = "Wrist singularity margin",
                                        .help = "Least bend of the wrist between axes 4 and 6.",
                                        .group = "Checks",
                                        .level = ParamLevel::Advanced,
                                        .min = 0,
                                        .max = 90})
      .add(&MotionParams::elbowMargin, {.key = "elbow_margin",
                                        .label = "Elbow singularity margin",
                                        .help = "Least bend of the stretched or folded elbow.",
                                        .group = "Checks",
                                        .level = ParamLevel::Advanced,
                                        .min = 0,
                                        .max = 90})
      .add(&MotionParams::shoulderMargin,
           {.key = "shoulder_margin",
            .label = "Shoulder singularity margin",
            .help = "Least distance of the wrist centre from axis 1.",
            .group = "Checks",
            .level = ParamLevel::Advanced,
            .min = 0,
            .max = 10000})
      .add(&MotionParams::maxJointStep,
           {.key = "max_joint_step",
            .label = "Largest joint step",
            .help = "Change of a joint between neighbouring points of a bead above which a finding "
                    "is given.",
            .group = "Checks",
            .level = ParamLevel::Advanced,
            .min = 0.1,
            .max = 360})
      .add(&MotionParams::verticalTolerance,
           {.key = "vertical_tolerance",
            .label = "Tolerance of the vertical",
            .help = "Angle between build direction and vertical above which a finding is given.",
            .group = "Checks",
            .level = ParamLevel::Advanced,
            .min = 0,
            .max = 180});
}

Schema<MotionParams> makeSchema() {
  Schema<MotionParams> schema;
  addRedundancy(schema);
  addTorch(schema);
  addTravel(schema);
  addChecks(schema);
  addWeights(schema);
  detail::addTimeLaw(schema);
  detail::addCollision(schema);
  return schema;
}

/// The weight's field of each objective, in the order of Objective.
constexpr std::array<double MotionParams::*, kObjectiveCount> kWeightFields = {
    &MotionParams::weightMotion,      &MotionParams::weightPositioner,
    &MotionParams::weightWinding,     &MotionParams::weightTransition,
    &MotionParams::weightSpeed,       &MotionParams::weightAcceleration,
    &MotionParams::weightJerk,        &MotionParams::weightGravity,
    &MotionParams::weightDexterity,   &MotionParams::weightLimits,
    &MotionParams::weightUncertainty, &MotionParams::weightTcpSpeed};

}  // namespace

ObjectiveValues MotionParams::weights() const {
  ObjectiveValues values{};
  for (std::size_t k = 0; k < kObjectiveCount; ++k) {
    values[k] = this->*kWeightFields[k];
  }
  return values;
}

void MotionParams::setWeights(const ObjectiveValues& weights) {
  for (std::size_t k = 0; k < kObjectiveCount; ++k) {
    this->*kWeightFields[k] = weights[k];
  }
}

MotionParams detail::withCable(const MotionParams& params, const Cell& cell) {
  MotionParams result = params;
  if (!(params.cableLimit.value() > 0.0) && cell.cable) {
    result.cableLimit = Angle(cell.cable->limit);
    result.cableZero = Angle(cell.cable->zero);
  }
  return result;
}

const Schema<MotionParams>& MotionParams::schema() {
  static const Schema<MotionParams> schema = makeSchema();
  return schema;
}

}  // namespace wcam::motion
