// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/plugin/slicing.hpp"
#include "wcam/toolpath/layer_levels.hpp"

#include "piece_order.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace wcam::branches {

/// What the layers of each piece follow.
enum class Field {
  Height,     ///< planes across the build direction
  Geodesic,   ///< distance from the base along the wall
  IsoValues,  ///< the borders and cuts of the piece
};

/// How a piece is sliced: as the common field says, or by a strategy of its own.
enum class Method {
  Common,     ///< as all pieces
  Geodesic,   ///< distance from the piece's own lower end
  IsoValues,  ///< the borders and cuts of the piece
  Spiral      ///< one bead through all revolutions (Diourté M35)
};

/// Methods of single pieces, by their number; the others take `rest`.
struct PieceMethods {
  Method rest = Method::Common;
  std::map<std::size_t, Method> own;

  [[nodiscard]] Method of(std::size_t piece) const;
  /// True when all pieces are sliced by the common field.
  [[nodiscard]] bool common() const;
};

/// Reads "1=spiral, 3=isovalues" or "*=spiral". @throws Error(InvalidArgument) naming the item
PieceMethods parsePieceMethods(const std::string& text);

struct PieceOptions {
  Field field = Field::Height;
  toolpath::LayerWish layers;  ///< of heights, the step fits already
  double leastBranch = 2.0;    ///< what spans less of the field makes no branch, mm
  double edge = 0.0;           ///< mesh edge length of fields on vertices; 0: from the step
  PieceMethods methods;
};

/// Cuts a part at the saddles of its field and slices every piece. Contours carry the part's index;
/// the first layer on two or more branches is a junction.
/// Finding slicing.branches: into how many pieces and where.
/// @throws Error(JobFailed) with the place and the remedy
std::vector<PieceLayers> slicePieces(const plugin::SliceInput& input,
                                     std::size_t part,
                                     const PieceOptions& options,
                                     const JobContext& context);

}  // namespace wcam::branches
