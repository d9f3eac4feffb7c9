// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/text.hpp"

#include <optional>
#include <string_view>

namespace wcam::io {

/// A kind of file that is no part, or one that is not read.
struct ForeignFormat {
  Text name;    ///< with its article: "an HTML page"
  Text remedy;  ///< what to do to get a part
};

/// Knows other kinds of files by how they begin. Nothing for parts that are read, and for what is
/// not known.
std::optional<ForeignFormat> foreignFormat(std::string_view bytes);

}  // namespace wcam::io
