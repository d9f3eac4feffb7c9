// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/value.hpp"

#include <string>
#include <string_view>

namespace wcam {

/// Parses UTF-8 JSON. Duplicate keys, trailing text, non-finite numbers and nesting deeper than 200
/// are errors. @throws Error(InputInvalid) naming `context` and the line.
Value parseJson(std::string_view text, const std::string& context = "JSON");

/// Canonical text (DESIGN 5): the keys' own order, 2-space indent, LF, shortest round-trip numbers,
/// a line feed at the end. Arrays of scalars stay on one line. @throws Error(Internal) for a
/// non-finite number.
std::string toCanonicalJson(const Value& value);

/// The same value on one line, without a line feed (JSON lines).
std::string toCompactJson(const Value& value);

/// Shortest text that reads back as the same double; always has '.', 'e' or is an integer plus
/// ".0".
std::string formatReal(double number);

}  // namespace wcam
