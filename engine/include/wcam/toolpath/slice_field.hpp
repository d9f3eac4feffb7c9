// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/slicing.hpp"
#include "wcam/toolpath/substrate.hpp"

#include <memory>
#include <vector>

namespace wcam::toolpath {

/// The scalar field whose level sets are the layers (DESIGN 3). A strategy is such a field plus its
/// levels. All members are const and thread-safe.
class LayerField {
public:
  virtual ~LayerField();
  /// Field value at a point of the part; NaN where the field is not defined.
  [[nodiscard]] virtual double scalar(const Vec3& p) const = 0;
  /// Signed residual of level k, mm: zero on the layer, growing in the build direction. For planes
  /// the distance.
  [[nodiscard]] virtual double residual(const Vec3& p, std::size_t level) const = 0;
  /// Gradient of the residual.
  [[nodiscard]] virtual Vec3 gradient(const Vec3& p, std::size_t level) const = 0;
  /// Largest jump of scalar() between the ends of a mesh edge of this length, beyond which the
  /// field is torn there and the triangle carries no curve; infinity for a continuous field.
  [[nodiscard]] virtual double largestJump(double edgeLength) const;
  /// Values at the vertices of a part's mesh where they are not those of scalar(): where facets
  /// stand for a round surface. Empty, as by default: they are.
  [[nodiscard]] virtual std::vector<double> vertexValues(std::size_t part) const;
};

/// One wanted layer.
struct LayerLevel {
  double value = 0.0;          ///< of the field; ascending from layer to layer
  Vec3 up = Vec3::UnitZ();     ///< build direction of the layer
  double nominalHeight = 0.0;  ///< mm
};

/// Traces the layers of a field on the parts: level sets on the mesh, moved onto the exact surface
/// where there is one (Newton in (u,v), on CAD edges along the edge), cut where they lie below the
/// substrate, sampled by chord error and spacing together with corners kept.
///
/// Findings: slicing.refinement_failed (a node kept its mesh position), slicing.degenerate_contour
/// (contours that are points were dropped, one finding per layer), slicing.empty_layer,
/// slicing.below_substrate.
/// @throws Error(JobFailed) when no layer meets the part.
/// Cost: one field value per vertex, O(nodes) tracing, a few surface evaluations per point;
/// parallel over levels.
SlicedLayers sliceByField(const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                          const LayerField& field,
                          const std::vector<LayerLevel>& levels,
                          const Substrate& substrate,
                          const Sampling& sampling,
                          const JobContext& context);

/// A field known at the vertices of the parts' meshes, linear on each triangle: distances, harmonic
/// fields. NaN marks a vertex outside the field: its triangles carry no layer.
struct VertexField {
  std::vector<std::vector<double>> values;  ///< per part, per vertex
  /// How far the values on a border that is a level may miss it, mm, where that is more than the
  /// noise of the part's mesh.
  double borderTolerance = 0.0;
};

/// The same for a field of vertices: nodes lie where the linear field has the level and on the
/// exact surface (its (u,v) interpolated), so that a finer mesh gives a more exact level, never a
/// point off the surface. Levels ascend strictly.
/// @throws Error(InvalidArgument) when the field does not fit the parts, Error(JobFailed) as above
SlicedLayers sliceByField(const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                          const VertexField& field,
                          const std::vector<LayerLevel>& levels,
                          const Substrate& substrate,
                          const Sampling& sampling,
                          const JobContext& context);

/// Number of chords on a full circle so that no sagitta exceeds the chord error: ceil(π / acos(1 −
/// e/ρ)) (Chalvin A3); `rounded` gives the thesis' own count, whose sagitta may exceed e.
int chordCount(double radius, double chordError, bool rounded = false);

}  // namespace wcam::toolpath
