// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "plan_detail.hpp"

namespace wcam::motion::detail {

namespace {

/// A field of the base class as one of the whole struct, which the schema wants.
template <class M>
M MotionParams::*field(M TimeLawParams::*member) {
  return member;
}

}  // namespace

void addTimeLaw(Schema<MotionParams>& schema) {
  schema
      .add(field(&TimeLawParams::cornerRadius),
           {.key = "corner_radius",
            .label = "Rounding of corners",
            .help = "Greatest distance from a corner at which the controller begins to round it "
                    "(CNT, C_DIS, zone). 0 stops at every corner.",
            .group = "Speed prediction",
            .min = 0,
            .max = 100})
      .add(field(&TimeLawParams::tcpAcceleration),
           {.key = "tcp_acceleration",
            .label = "Acceleration of the torch",
            .help = "Greatest acceleration of the deposition point in the part, mm/s²; 0 sets no "
                    "limit beside those of the joints.",
            .group = "Speed prediction",
            .level = ParamLevel::Advanced,
            .min = 0,
            .max = 1e6})
      .add(field(&TimeLawParams::accelerationTime),
           {.key = "acceleration_time",
            .label = "Acceleration time of joints",
            .help = "A joint whose acceleration is not in the cell file reaches its greatest speed "
                    "in this time, s; 0 means at once.",
            .group = "Speed prediction",
            .min = 0,
            .max = 10},
           ParamType::Real, QuantityKind::Time)
      .add(field(&TimeLawParams::speedTolerance),
           {.key = "speed_tolerance",
            .label = "Tolerance of the speed",
            .help = "Part of the wanted speed by which the predicted speed may be lower or higher "
                    "before a finding is given.",
            .group = "Speed prediction",
            .min = 0.001,
            .max = 1},
           ParamType::Real, QuantityKind::Ratio)
      .add(field(&TimeLawParams::minSpeedRatio),
           {.key = "min_speed_ratio",
            .label = "Minimum speed",
            .help = "Part of the wanted speed below which the torch must not fall with the arc on, "
                    "as a mean over a bead's width: what passes within that, as the slow-down at "
                    "ends and corners, melts into one pool. Below is a violation.",
            .group = "Speed prediction",
            .min = 0.01,
            .max = 1},
           ParamType::Real, QuantityKind::Ratio)
      .add(field(&TimeLawParams::wireFollowsSpeed),
           {.key = "wire_follows_speed",
            .label = "Wire feed follows the speed",
            .help = "Where the torch is predicted to be slower than wanted, the wire feed is "
                    "lowered alike. The welding source must allow it.",
            .group = "Speed prediction"})
      .add(field(&TimeLawParams::leastWireRatio),
           {.key = "least_wire_ratio",
            .label = "Least wire feed",
            .help = "Part of the wanted wire feed below which it is not lowered.",
            .group = "Speed prediction",
            .level = ParamLevel::Advanced,
            .min = 0.01,
            .max = 1,
            .enabledIf = "wire_follows_speed=true"},
           ParamType::Real, QuantityKind::Ratio)
      .add(field(&TimeLawParams::reversalEffect),
           {.key = "reversal_effect",
            .label = "Effect of joint reversals",
            .help = "Step of the torch by the backlash of a joint that turns round above which it "
                    "is told. Backlash stands in the cell file.",
            .group = "Checks",
            .level = ParamLevel::Advanced,
            .min = 0,
            .max = 100});
}

}  // namespace wcam::motion::detail
