// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "path_model.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace wcam::gui {

/// Colour of a fraction 0..1 of a scale.
viewport::Colour scaleColour(double fraction);
/// Colour of one of several kinds.
viewport::Colour kindColour(int kind);
/// Kinds are told apart, other quantities lie on a scale.
bool isKind(Quantity quantity);

/// How the values of a path are coloured, and what a legend needs to say so.
struct Coloured {
  std::vector<std::uint8_t> rgb;  ///< three bytes per move
  float low = 0.0F;
  float high = 0.0F;
  std::vector<int> kinds;  ///< of a quantity of kinds: those that occur, ascending
  bool empty = true;       ///< no move has a value
};

/// @param range limits of the scale; none: those of the values
Coloured colourPath(const PathModel& path,
                    Quantity quantity,
                    const std::optional<std::pair<float, float>>& range);

}  // namespace wcam::gui
