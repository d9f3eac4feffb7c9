// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace kuka {

/// Keywords, types and functions of KRL, and programs of the system: none of them is a name for a
/// program.
inline constexpr auto kWords = std::to_array<std::string_view>(
    {"A10",       "A10_INI",   "A20",        "A50",      "ABS",       "ACOS",      "AND",
     "ANIN",      "ANOUT",     "ARCMAINNG",  "ATAN2",    "AXIS",      "BAS",       "BASISTECH",
     "BOOL",      "BRAKE",     "B_AND",      "B_EXOR",   "B_NOT",     "B_OR",      "CASE",
     "CAST_FROM", "CAST_TO",   "CCLOSE",     "CELL",     "CHANNEL",   "CHAR",      "CIRC",
     "CIRC_REL",  "CONFIG",    "CONFIRM",    "CONST",    "CONTINUE",  "COPEN",     "COS",
     "CREAD",     "CWRITE",    "C_DIS",      "C_ORI",    "C_PTP",     "C_SPL",     "C_VEL",
     "DECL",      "DEF",       "DEFAULT",    "DEFDAT",   "DEFFCT",    "DELAY",     "DIGIN",
     "DISTANCE",  "DO",        "E6AXIS",     "E6POS",    "EB",        "EK",        "ELSE",
     "END",       "ENDDAT",    "ENDFCT",     "ENDFOR",   "ENDIF",     "ENDLOOP",   "ENDSPLINE",
     "ENDSWITCH", "ENDWHILE",  "ENUM",       "EO",       "ERR_RAISE", "EXIT",      "EXOR",
     "EXT",       "EXTFCT",    "FALSE",      "FLT_SERV", "FOR",       "FORWARD",   "FRAME",
     "FRAMES",    "GLOBAL",    "GOTO",       "H50",      "HALT",      "HOME",      "IF",
     "IMPORT",    "INI",       "INITIALIZE", "INT",      "INTERRUPT", "INVERSE",   "INV_POS",
     "IR_STOPM",  "IS",        "LIN",        "LIN_REL",  "LOADDATA",  "LOAD_DATA", "LOOP",
     "MACHINE",   "MAXIMUM",   "MINIMUM",    "MSG",      "NEW_SERV",  "NOT",       "OFF",
     "ON",        "OR",        "P00",        "PATH",     "POS",       "PRIO",      "PTP",
     "PTP_REL",   "PUBLIC",    "PULSE",      "REAL",     "REPEAT",    "RESUME",    "RETURN",
     "ROBCOR",    "SCIRC",     "SCIRC_REL",  "SEC",      "SIGNAL",    "SIN",       "SLIN",
     "SLIN_REL",  "SPL",       "SPLINE",     "SPL_REL",  "SPS",       "SPTP",      "SPTP_REL",
     "SQRT",      "SREAD",     "STRUC",      "SWITCH",   "SWRITE",    "SYNC",      "TAN",
     "THEN",      "TO",        "TOOL",       "TRIGGER",  "TRUE",      "UNTIL",     "USER_GLUE",
     "USER_GRP",  "USER_SPOT", "VAR",        "VARSTATE", "WAIT",      "WEAV_DEF",  "WHEN",
     "WHILE",     "WITH"});

}  // namespace kuka
