// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "dialect.hpp"

namespace kuka {

namespace {

using wcam::ParamLevel;
using wcam::Schema;

void addOutput(Schema<Dialect>& schema) {
  schema
      .add(&Dialect::mode,
           {.key = "mode",
            .label = "Positions",
            .help =
                "Cartesian: LIN with the speed of the tool. Joint values: every move is a PTP to "
                "axis values, whose speed is whole percents of the axis speeds, far above those of "
                "a bead: a dry run that checks the reach, with the arc off.",
            .group = "Output",
            .choices = {{"cartesian", "Cartesian"}, {"joint", "Joint values (dry run)"}}})
      .add(&Dialect::ptp,
           {.key = "ptp_positions",
            .label = "Positions of PTP moves",
            .help = "Axis values say how the robot reaches a point. Cartesian positions carry "
                    "status and turn bits (S and T) instead; where an axis is within 0.001 degrees "
                    "of 0, its turn bit would be chance, and axis values are written all the same.",
            .group = "Output",
            .level = ParamLevel::Advanced,
            .enabledIf = "mode=cartesian",
            .choices = {{"axes", "Axis values"}, {"cartesian", "Cartesian with S and T"}}})
      .add(&Dialect::lengthDecimals, {.key = "length_decimals",
                                      .label = "Decimals of lengths",
                                      .help = "Of mm.",
                                      .group = "Output",
                                      .level = ParamLevel::Expert,
                                      .min = 2,
                                      .max = 6})
      .add(&Dialect::angleDecimals, {.key = "angle_decimals",
                                     .label = "Decimals of angles",
                                     .help = "Of degrees, also of axes.",
                                     .group = "Output",
                                     .level = ParamLevel::Expert,
                                     .min = 2,
                                     .max = 6})
      .add(&Dialect::angleRange,
           {.key = "angle_range",
            .label = "Range of A and C",
            .help = "Wrapped: within 180 degrees to both sides. Continuous: the value next to that "
                    "of the point before, also beyond 180 degrees.",
            .group = "Output",
            .level = ParamLevel::Expert,
            .enabledIf = "mode=cartesian",
            .choices = {{"wrapped", "Wrapped"}, {"continuous", "Continuous"}}})
      .add(
          &Dialect::maxPoints,
          {.key = "max_points",
           .label = "Points per program",
           .help = "0: no limit. A longer operation is cut between beads into programs that a main "
                   "program calls; each of them can be started alone.",
           .group = "Output",
           .level = ParamLevel::Advanced,
           .min = 0,
           .max = 1e6})
      .add(&Dialect::maxLines, {.key = "max_lines",
                                .label = "Lines per program",
                                .help = "As the points. 0: no limit.",
                                .group = "Output",
                                .level = ParamLevel::Advanced,
                                .min = 0,
                                .max = 1e6})
      .add(&Dialect::programName,
           {.key = "program_name",
            .label = "Program name",
            .help = "Empty: the name of the operation. At most 24 characters.",
            .group = "Output"})
      .add(&Dialect::comments, {.key = "comments",
                                .label = "Comments",
                                .help = "Of layers and beads. The head of a program always says "
                                        "what it was planned with.",
                                .group = "Output",
                                .choices = {{"none", "None"},
                                            {"layers", "One per layer"},
                                            {"beads", "One per layer and bead"}}});
}

void addController(Schema<Dialect>& schema) {
  schema
      .add(&Dialect::tool, {.key = "tool",
                            .label = "Tool number",
                            .help = "n of TOOL_DATA[n]: the torch; of a part that the robot "
                                    "carries, the table with the part. The head of the program "
                                    "says the values that were planned with.",
                            .group = "Controller",
                            .min = 1,
                            .max = 32})
      .add(&Dialect::base,
           {.key = "base",
            .label = "Base number",
            .help =
                "n of BASE_DATA[n]; 0 writes $NULLFRAME. Positions are complete: with a coupled "
                "positioner the base must be its table frame, with a part that the robot carries "
                "the fixed torch (never 0), else the robot base.",
            .group = "Controller",
            .min = 0,
            .max = 128})
      .add(&Dialect::coupled,
           {.key = "coupled",
            .label = "Coupled positioner",
            .help =
                "Writes positions in the frame of the turning table, with $BASE = EK(...): the "
                "speed then holds on the part. Without it positions are in the robot base frame.",
            .group = "Controller"})
      .add(&Dialect::machine, {.key = "machine",
                               .label = "Machine number of the positioner",
                               .help = "n of MACHINE_DEF[n].",
                               .group = "Controller",
                               .level = ParamLevel::Advanced,
                               .min = 1,
                               .max = 16,
                               .enabledIf = "coupled=true"})
      .add(&Dialect::externalAxisCount,
           {.key = "act_ex_ax",
            .label = "$ACT_EX_AX",
            .help = "0 does not write it: controllers differ in its meaning.",
            .group = "Controller",
            .level = ParamLevel::Expert,
            .min = 0,
            .max = 6})
      .add(&Dialect::status,
           {.key = "status",
            .label = "Status bits of PTP positions",
            .help =
                "Three binary digits, such as 010; empty: from the configuration of the cell and "
                "the sign of A5.",
            .group = "Controller",
            .level = ParamLevel::Expert,
            .enabledIf = "ptp_positions=cartesian"})
      .add(&Dialect::advance, {.key = "advance",
                               .label = "Advance run",
                               .help = "$ADVANCE: moves read ahead.",
                               .group = "Controller",
                               .level = ParamLevel::Advanced,
                               .min = 0,
                               .max = 5});
}

void addMotion(Schema<Dialect>& schema) {
  schema
      .add(&Dialect::approximation, {.key = "approximation",
                                     .label = "Points passed",
                                     .group = "Motion",
                                     .choices = {{"distance", "Within a distance (C_DIS)"},
                                                 {"velocity", "By velocity (C_VEL)"},
                                                 {"none", "Stop at each"}}})
      .add(&Dialect::approximationDistance, {.key = "approximation_distance",
                                             .label = "Approximation distance",
                                             .help = "$APO.CDIS",
                                             .group = "Motion",
                                             .min = 0.0,
                                             .max = 100.0,
                                             .enabledIf = "approximation=distance"})
      .add(&Dialect::approximationVelocity, {.key = "approximation_velocity",
                                             .label = "Approximation velocity",
                                             .help = "$APO.CVEL, percent",
                                             .group = "Motion",
                                             .min = 0,
                                             .max = 100,
                                             .enabledIf = "approximation=velocity"})
      .add(&Dialect::speedDecimals, {.key = "speed_decimals",
                                     .label = "Decimals of speeds",
                                     .help = "Of $VEL.CP in m/s: 5 decimals are 0.01 mm/s.",
                                     .group = "Motion",
                                     .level = ParamLevel::Expert,
                                     .min = 4,
                                     .max = 8});
}

void addArc(Schema<Dialect>& schema) {
  schema
      .add(&Dialect::arc, {.key = "arc",
                           .label = "Arc on and off",
                           .group = "Arc",
                           .choices = {{"output", "Digital output"},
                                       {"template", "Own KRL lines"},
                                       {"none", "None"}}})
      .add(&Dialect::arcOutput, {.key = "arc_output",
                                 .label = "Arc output",
                                 .help = "n of $OUT[n].",
                                 .group = "Arc",
                                 .min = 1,
                                 .max = 4096,
                                 .enabledIf = "arc=output"})
      .add(&Dialect::arcOn,
           {.key = "arc_on",
            .label = "KRL at arc on",
            .help = "One or several lines separated by '|', such as the inline forms of ArcTech. "
                    "{job} is the job number.",
            .group = "Arc",
            .level = ParamLevel::Advanced,
            .enabledIf = "arc=template"})
      .add(&Dialect::arcOff, {.key = "arc_off",
                              .label = "KRL at arc off",
                              .help = "As at arc on; {crater} is the crater time in s.",
                              .group = "Arc",
                              .level = ParamLevel::Advanced,
                              .enabledIf = "arc=template"})
      .add(&Dialect::wireVariable,
           {.key = "wire_variable",
            .label = "Variable for the wire speed",
            .help = "A variable of the controller that takes m/min; empty: the job decides alone, "
                    "and operations whose wire speed changes get no program.",
            .group = "Arc",
            .level = ParamLevel::Advanced});
}

}  // namespace

Schema<Dialect> dialectSchema() {
  Schema<Dialect> schema;
  addOutput(schema);
  addMotion(schema);
  addArc(schema);
  addController(schema);
  return schema;
}

}  // namespace kuka
