// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/plan.hpp"

#include "plan_detail.hpp"
#include "collision_params.hpp"

namespace wcam::motion {

namespace {

void addTorch(Schema<MotionParams>& schema) {
  schema
      .add(&MotionParams::torchRotation,
           {.key = "torch_rotation",
            .label = "Rotation about the torch",
            .help = "Constant third Bryant angle of the tool frame (torch carried) or of the part "
                    "(part carried).",
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
               "the front and the elbow up, and with the largest margin.",
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
  addTorch(schema);
  addTravel(schema);
  addChecks(schema);
  detail::addTimeLaw(schema);
  detail::addCollision(schema);
  return schema;
}

}  // namespace

const Schema<MotionParams>& MotionParams::schema() {
  static const Schema<MotionParams> schema = makeSchema();
  return schema;
}

}  // namespace wcam::motion
