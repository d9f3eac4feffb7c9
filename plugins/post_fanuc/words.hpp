// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace fanuc {

/// Words of TP programs and reserved words of KAREL, which runs on the same controller: none of
/// them is a name for a program.
inline constexpr auto kWords = std::to_array<std::string_view>(
    {"ABORT",        "ABS",          "ACC",      "AFTER",      "ALONG",      "AND",
     "ARC",          "ARRAY",        "AT",       "ATTACH",     "AWAY",       "AXIS",
     "BEFORE",       "BEGIN",        "BOOLEAN",  "BY",         "BYNAME",     "BYTE",
     "CALL",         "CANCEL",       "CASE",     "CLOSE",      "CMOS",       "CNT",
     "COMMAND",      "CONDITION",    "CONFIG",   "CONNECT",    "CONST",      "CONTINUE",
     "COORD",        "COORDINATED",  "CR",       "DELAY",      "DISABLE",    "DISCONNECT",
     "DIV",          "DO",           "DOWNTO",   "DRAM",       "ELSE",       "ENABLE",
     "END",          "ENDCONDITION", "ENDFOR",   "ENDIF",      "ENDMOVE",    "ENDSELECT",
     "ENDSTRUCTURE", "ENDUSING",     "ENDWHILE", "ERROR",      "EVAL",       "EVENT",
     "EXECUTE",      "FILE",         "FINE",     "FOR",        "FROM",       "GET_VAR",
     "GO",           "GOTO",         "GROUP",    "HAND",       "HOLD",       "IF",
     "IN",           "INDEPENDENT",  "INTEGER",  "JMP",        "JOINTPOS",   "LBL",
     "MESSAGE",      "MOD",          "MODEL",    "MONITOR",    "MOVE",       "NEAR",
     "NOABORT",      "NODE",         "NODEDATA", "NOMESSAGE",  "NOPAUSE",    "NOT",
     "NOWAIT",       "OF",           "OFF",      "OFFSET",     "ON",         "OPEN",
     "OR",           "OVERRIDE",     "PATH",     "PATHHEADER", "PAUSE",      "PAYLOAD",
     "POSITION",     "POWERUP",      "PROGRAM",  "PULSE",      "PURGE",      "READ",
     "REAL",         "RELATIVE",     "RELAX",    "RELEASE",    "REPEAT",     "RESTORE",
     "RESUME",       "RETURN",       "ROUTINE",  "RTCP",       "RUN",        "SELECT",
     "SEMAPHORE",    "SET_VAR",      "SHORT",    "SIGNAL",     "SKIP",       "STOP",
     "STRING",       "STRUCTURE",    "THEN",     "TIME",       "TIMER",      "TO",
     "TPENABLE",     "TYPE",         "UALM",     "UFRAME",     "UFRAME_NUM", "UNHOLD",
     "UNINIT",       "UNPAUSE",      "UNTIL",    "USING",      "UTOOL",      "UTOOL_NUM",
     "VAR",          "VECTOR",       "VIA",      "WAIT",       "WEAVE",      "WHEN",
     "WHILE",        "WITH",         "WRITE",    "XYZWPR",     "XYZWPREXT"});

}  // namespace fanuc
