// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "collision_params.hpp"

namespace wcam::motion::detail {

void addCollision(Schema<MotionParams>& schema) {
  schema
      .add(&MotionParams::checkCollisions,
           {.key = "check_collisions",
            .label = "Check collisions",
            .help = "Looks for collisions of torch, robot and positioner with each other, the "
                    "cell, the substrate and the part as it grows. Needs shapes in the cell file.",
            .group = "Collision"})
      .add(&MotionParams::safetyDistance,
           {.key = "safety_distance",
            .label = "Safety distance",
            .help = "What comes nearer gives a warning. Not asked of the material below the "
                    "nozzle, whose distance is the stick-out.",
            .group = "Collision",
            .min = 0,
            .max = 200,
            .enabledIf = "check_collisions=true"})
      .add(&MotionParams::exitRotations,
           {.key = "exit_rotations",
            .label = "Turn the torch out of collisions",
            .help = "Tilts the torch about the TCP where it would touch the part, smoothly along "
                    "the bead and within the tolerances; otherwise the findings tell the tilt that "
                    "would be needed.",
            .group = "Collision",
            .enabledIf = "check_collisions=true"})
      .add(&MotionParams::exitLateral,
           {.key = "exit_lateral",
            .label = "Greatest lateral tilt",
            .help = "Of an exit rotation, about the direction of travel.",
            .group = "Collision",
            .level = ParamLevel::Advanced,
            .min = 0,
            .max = 90,
            .enabledIf = "check_collisions=true"})
      .add(&MotionParams::exitLead,
           {.key = "exit_lead",
            .label = "Greatest lead or lag",
            .help = "Of an exit rotation, about the direction across the travel.",
            .group = "Collision",
            .level = ParamLevel::Advanced,
            .min = 0,
            .max = 90,
            .enabledIf = "check_collisions=true"})
      .add(&MotionParams::exitRate,
           {.key = "exit_rate",
            .label = "Smoothness of exit rotations",
            .help = "Greatest change of an exit rotation, degrees per millimetre of the bead.",
            .group = "Collision",
            .level = ParamLevel::Advanced,
            .min = 0.01,
            .max = 90,
            .enabledIf = "check_collisions=true"});
}

}  // namespace wcam::motion::detail
