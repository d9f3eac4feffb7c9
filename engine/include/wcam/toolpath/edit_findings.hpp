// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/toolpath/edits.hpp"

#include <cstddef>
#include <vector>

namespace wcam::toolpath {

/// Findings about a toolpath as they stand after its edits: those of deleted layers are gone, the
/// layers above deleted and repeated ones have other numbers, and the place inside a bead that
/// starts elsewhere or is cut is left open.
/// @param layers of the toolpath that the findings are about
std::vector<Diagnostic> findingsAfter(std::vector<Diagnostic> findings,
                                      std::size_t layers,
                                      const std::vector<Edit>& edits);

}  // namespace wcam::toolpath
