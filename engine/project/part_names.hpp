// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/diagnostic.hpp"

#include <string>
#include <vector>

namespace wcam::project::detail {

/// Findings of strategies, which know the parts of an operation by their numbers alone ("part 2",
/// counted from 1), with the ids that the project gives them: "part 'tube'".
std::vector<Diagnostic> withPartNames(std::vector<Diagnostic> findings,
                                      const std::vector<std::string>& ids);

}  // namespace wcam::project::detail
