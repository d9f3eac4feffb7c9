// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/toolpath/slicing.hpp"

#include <cstddef>
#include <vector>

namespace wcam::branches {

/// In which order the layers of the pieces are deposited.
enum class Order {
  Level,    ///< layer by layer over all pieces
  Bottom,   ///< piece by piece, the lowest that can be built first
  Depth,    ///< piece by piece, upwards along a branch before the next one
  Nearest,  ///< piece by piece, the next one nearest to where the last one ended
};

/// A piece of a part with its layers, lowest first.
struct PieceLayers {
  std::vector<toolpath::SlicedLayer> layers;
  std::vector<double> levels;  ///< of the field that is common to all pieces of the part, ascending
  double from = 0.0;           ///< level at which the piece begins
  std::vector<std::size_t> below;
  std::vector<std::size_t> above;
};

/// Puts the layers of all pieces in order and tells each what it lies on: the layer before in its
/// piece; for the first one the last layers of the pieces below; for pieces on the substrate
/// nothing.
toolpath::SlicedLayers arrange(std::vector<PieceLayers> pieces, Order order);

}  // namespace wcam::branches
