// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace wcam {

/// One comparison of ParamInfo::enabledIf. The views point into the text that was read.
struct ParamCondition {
  std::string_view text;   ///< the whole comparison
  std::string_view key;    ///< of the other parameter; empty when nothing is compared
  std::string_view value;  ///< as the file writes it
  bool negated = false;    ///< "!=" instead of "="
};

/// Reads "key=value", "key!=value" and several of them joined by " and ". What is none of them
/// comes out with an empty key.
std::vector<ParamCondition> parseConditions(std::string_view enabledIf);

}  // namespace wcam
