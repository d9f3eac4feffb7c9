// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/toolpath/spiral_law.hpp"

/// Findings that both kinds of spirals make. Private to this module.
namespace wcam::toolpath {

/// slicing.spiral_height where any point lies outside of the wished range; heights in mm.
/// @param outside number of such points
void reportSpiralHeights(const SpiralWish& wish,
                         std::size_t outside,
                         double least,
                         double greatest,
                         const JobContext& context);

}  // namespace wcam::toolpath
