// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/param.hpp"
#include "wcam/geometry/mesh.hpp"
#include "wcam/toolpath/base_curve.hpp"
#include "wcam/toolpath/slice_field.hpp"

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace wcam::toolpath {

/// What happens where the height of a part is no whole number of steps.
enum class LastLayer {
  Fit,   ///< the step is changed a little, so that the last layer is the part's end
  Leave  ///< the step is kept, and the rest above the last layer is left
};

/// Declares the parameter `last_layer` of a strategy whose layers follow each other in equal steps.
/// @param enabledIf as in ParamInfo
template <class T>
void addLastLayer(Schema<T>& schema, LastLayer T::*field, const std::string& enabledIf = {}) {
  schema.add(field,
             {.key = "last_layer",
              .label = "Last layer",
              .help = "Where the part's height is no whole number of steps: fit changes the step a "
                      "little, so that the last layer lies on the part's end; leave keeps the step "
                      "and says how much of the part is left above the last layer.",
              .group = "Layers",
              .enabledIf = enabledIf,
              .choices = {{"fit", "Fit the step to the height"}, {"leave", "Leave the rest"}}});
}

/// What is asked of a stack of layers. Lengths in mm.
struct LayerWish {
  double step = 2.0;
  double firstLayer = 1.0;  ///< place of the first layer above the base, in steps
  LastLayer last = LastLayer::Leave;
  /// Layer heights of the process: where the nearest number of layers leaves them and the next one
  /// does not, that one is taken.
  double heightMin = 0.0;
  double heightMax = std::numeric_limits<double>::infinity();
};

/// Layers at (first + k)·step, k = 0 … count − 1.
struct LayerSteps {
  double step = 0.0;
  std::size_t count = 0;
};

/// The layers up to a height. One that misses the height by less than the tolerance lies on it.
/// Heights below half a step are not fitted.
/// @throws Error(InvalidArgument) for a step that gives over a million layers
LayerSteps layersUpTo(double height, const LayerWish& wish, double tolerance);

/// Whether a part ends in a face or a border on which the last layer can lie: all vertices of a
/// triangle or of a border edge are as high as the greatest value, within the tolerance.
bool endsFlat(const geometry::TriangleMesh& mesh,
              const geometry::HalfEdges& halfEdges,
              std::span<const double> values,
              double tolerance);

/// The border at which a part ends, where the distances along it are so even that it can be a
/// layer.
struct EndBorder {
  double distance = std::numeric_limits<double>::quiet_NaN();  ///< in the mean, mm
  double spread = 0.0;                                         ///< to both sides, mm
};

/// @param distance per vertex, from the base
EndBorder endBorderOf(const PartBase& base, const std::vector<double>& distance, double step);

/// Findings slicing.step_fitted (by how much the step was changed) and slicing.rest (how far a part
/// goes on above its last layer, and a step that would do).
/// @param ends per part the value at which it ends in a face or a border; NaN where it does not
/// @param step that the layers got, mm
void reportSteps(const std::vector<double>& ends,
                 const std::vector<LayerLevel>& levels,
                 const LayerWish& wish,
                 double step,
                 double tolerance,
                 const JobContext& context);

}  // namespace wcam::toolpath
