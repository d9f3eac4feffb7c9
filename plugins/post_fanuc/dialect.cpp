// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "dialect.hpp"

namespace fanuc {

namespace {

using wcam::ParamLevel;
using wcam::Schema;

void addOutput(Schema<Dialect>& schema) {
  schema
      .add(&Dialect::mode, {.key = "mode",
                            .label = "Positions",
                            .help = "Joint values fix the configuration of the robot; Cartesian "
                                    "positions can be touched up and moved with a user frame.",
                            .group = "Output",
                            .choices = {{"joint", "Joint values"}, {"cartesian", "Cartesian"}}})
      .add(&Dialect::jointDecimals, {.key = "joint_decimals",
                                     .label = "Decimals of joint values",
                                     .help = "Controllers keep 4 decimals of a degree.",
                                     .group = "Output",
                                     .level = ParamLevel::Expert,
                                     .min = 3,
                                     .max = 6})
      .add(&Dialect::cartesianDecimals, {.key = "cartesian_decimals",
                                         .label = "Decimals of Cartesian positions",
                                         .help = "Of mm and of degrees.",
                                         .group = "Output",
                                         .level = ParamLevel::Expert,
                                         .min = 2,
                                         .max = 5,
                                         .enabledIf = "mode=cartesian"})
      .add(&Dialect::maxPoints,
           {.key = "max_points",
            .label = "Points per program",
            .help = "A longer operation is cut between beads into programs that a main program "
                    "calls; each of them can be started alone.",
            .group = "Output",
            .level = ParamLevel::Advanced,
            .min = 10,
            .max = 15000})
      .add(&Dialect::maxLines,
           {.key = "max_lines",
            .label = "Lines per program",
            .help = "As the points. Line numbers above 9999 need five digits, which many "
                    "controllers do not read. 0: no limit.",
            .group = "Output",
            .level = ParamLevel::Advanced,
            .min = 0,
            .max = 99999})
      .add(&Dialect::programName, {.key = "program_name",
                                   .label = "Program name",
                                   .help = "Empty: the name of the operation.",
                                   .group = "Output"})
      .add(&Dialect::nameLength,
           {.key = "name_length",
            .label = "Length of names",
            .group = "Output",
            .level = ParamLevel::Advanced,
            .choices = {{"long", "Up to 36 characters"}, {"short", "Up to 8 characters"}}})
      .add(&Dialect::comments, {.key = "comments",
                                .label = "Comments",
                                .help = "Of layers and beads. The head of a program always says "
                                        "what it was planned with.",
                                .group = "Output",
                                .choices = {{"none", "None"},
                                            {"layers", "One per layer"},
                                            {"beads", "One per layer and bead"}}});
}

void addFrames(Schema<Dialect>& schema) {
  constexpr double kFrames = 61;
  constexpr double kTools = 29;
  schema
      .add(&Dialect::groupFields, {.key = "group_fields",
                                   .label = "Fields of DEFAULT_GROUP",
                                   .help = "Depends on the generation of the controller.",
                                   .group = "Controller",
                                   .level = ParamLevel::Advanced,
                                   .choices = {{"5", "5"}, {"7", "7"}}})
      .add(&Dialect::userFrame, {.key = "user_frame",
                                 .label = "User frame of the robot (UF)",
                                 .help = "Positions are written in the robot base frame; another "
                                         "frame than 0 must hold that frame.",
                                 .group = "Controller",
                                 .min = 0,
                                 .max = kFrames})
      .add(&Dialect::remoteFrame,
           {.key = "remote_frame",
            .label = "User frame of the fixed torch (UF)",
            .help = "n of UFRAME[n] for programs of a part that the robot carries: it must hold "
                    "the fixed torch, with z from the part towards it. Never 0: RTCP moves "
                    "relative to a user frame, and frame 0 is the robot's own, which cannot be "
                    "set.",
            .group = "Controller",
            .min = 1,
            .max = kFrames,
            .enabledIf = "remote_tool=true"})
      .add(&Dialect::toolFrame, {.key = "tool_frame",
                                 .label = "Tool frame (UT)",
                                 .help = "Holds the torch; of a part that the robot carries, the "
                                         "table with the part. The head of the program says the "
                                         "values that were planned with.",
                                 .group = "Controller",
                                 .min = 1,
                                 .max = kTools})
      .add(&Dialect::positionerUserFrame, {.key = "positioner_user_frame",
                                           .label = "User frame of the positioner",
                                           .group = "Controller",
                                           .level = ParamLevel::Expert,
                                           .min = 0,
                                           .max = kFrames})
      .add(&Dialect::positionerToolFrame, {.key = "positioner_tool_frame",
                                           .label = "Tool frame of the positioner",
                                           .group = "Controller",
                                           .level = ParamLevel::Expert,
                                           .min = 1,
                                           .max = kTools})
      .add(&Dialect::frame, {.key = "position_frame",
                             .label = "Frame of Cartesian positions",
                             .help = "Base: where the torch is with the positioner where it is. "
                                     "Table: in the turning frame of the positioner's table, for a "
                                     "user frame that the controller turns along.",
                             .group = "Controller",
                             .level = ParamLevel::Expert,
                             .enabledIf = "mode=cartesian",
                             .choices = {{"base", "Robot base"}, {"table", "Positioner table"}}})
      .add(&Dialect::turnAxes,
           {.key = "turn_axes",
            .label = "Axes of the turn numbers",
            .help = "The three numbers behind the CONFIG letters.",
            .group = "Controller",
            .level = ParamLevel::Expert,
            .enabledIf = "mode=cartesian",
            .choices = {{"j1_j4_j6", "J1, J4, J6"}, {"j4_j5_j6", "J4, J5, J6"}}})
      .add(&Dialect::payload, {.key = "payload",
                               .label = "Payload schedule",
                               .help = "0 writes none.",
                               .group = "Controller",
                               .level = ParamLevel::Advanced,
                               .min = 0,
                               .max = 10});
}

void addMotion(Schema<Dialect>& schema) {
  schema
      .add(&Dialect::coordinated,
           {.key = "coordinated",
            .label = "Coordinated motion",
            .help = "Adds COORD to linear and circular moves, so that the speed holds on the "
                    "turning part (option J601). Needs a positioner as group 2.",
            .group = "Motion"})
      .add(&Dialect::remoteTool, {.key = "remote_tool",
                                  .label = "Remote tool centre point",
                                  .help = "Adds RTCP to linear and circular moves when the robot "
                                          "carries the part, so that the speed holds at the torch. "
                                          "It excludes coordinated motion.",
                                  .group = "Motion",
                                  .level = ParamLevel::Advanced})
      .add(&Dialect::speedUnit, {.key = "speed_unit",
                                 .label = "Unit of speeds",
                                 .group = "Motion",
                                 .choices = {{"mm_sec", "mm/sec"}, {"cm_min", "cm/min"}}})
      .add(&Dialect::speedDecimals,
           {.key = "speed_decimals",
            .label = "Decimals of speeds",
            .help =
                "Many controllers read one decimal at most: speeds are then off by up to 0.05 of "
                "the unit, which is 0.8 % at 6 mm/sec and 0.14 % at 36 cm/min.",
            .group = "Motion",
            .level = ParamLevel::Advanced,
            .min = 0,
            .max = 3})
      .add(&Dialect::termination,
           {.key = "termination",
            .label = "Points passed",
            .group = "Motion",
            .level = ParamLevel::Advanced,
            .choices = {{"cnt", "With CNT"}, {"fine", "Stop at each (FINE)"}}})
      .add(&Dialect::cnt, {.key = "cnt",
                           .label = "CNT value",
                           .help = "0 passes closest to the point, 100 slows down least.",
                           .group = "Motion",
                           .min = 0,
                           .max = 100,
                           .enabledIf = "termination=cnt"});
}

void addArc(Schema<Dialect>& schema) {
  schema
      .add(&Dialect::arcStart, {.key = "arc_start",
                                .label = "Arc start schedule",
                                .help = "n of Arc Start[n]; 0: the job number of the process.",
                                .group = "Arc",
                                .min = 0,
                                .max = 999})
      .add(&Dialect::arcEnd, {.key = "arc_end",
                              .label = "Arc end schedule",
                              .help = "n of Arc End[n]; 0: the job number of the process.",
                              .group = "Arc",
                              .min = 0,
                              .max = 999})
      .add(&Dialect::crater, {.key = "crater",
                              .label = "Crater fill",
                              .help = "Wait: the torch stands for the crater time before Arc End. "
                                      "Schedule: the arc end schedule holds the time.",
                              .group = "Arc",
                              .level = ParamLevel::Advanced,
                              .choices = {{"wait", "Wait"}, {"schedule", "In the schedule"}}})
      .add(&Dialect::wireRegister, {.key = "wire_register",
                                    .label = "Register for the wire speed",
                                    .help = "n of R[n], in m/min; 0: the job decides alone, and "
                                            "operations whose wire speed changes get no program.",
                                    .group = "Arc",
                                    .level = ParamLevel::Advanced,
                                    .min = 0,
                                    .max = 200});
}

}  // namespace

Schema<Dialect> dialectSchema() {
  Schema<Dialect> schema;
  addOutput(schema);
  addMotion(schema);
  addArc(schema);
  addFrames(schema);
  return schema;
}

}  // namespace fanuc
