// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/layer_levels.hpp"
#include "wcam/toolpath/slicing.hpp"
#include "wcam/toolpath/substrate.hpp"

#include <memory>
#include <optional>

namespace wcam::toolpath {

/// A line in the part frame.
struct Axis {
  Vec3 point = Vec3::Zero();
  Vec3 direction = Vec3::UnitZ();  ///< unit, the way that the part grows
};

/// The axis about which a part is a body of revolution: along `up` where that fits, else any.
/// Nothing when the part's normals meet no common axis. Cost: O(triangles).
std::optional<Axis> findRevolutionAxis(const geometry::PartSurface& part, const Vec3& up);

struct RevolutionOptions {
  LayerWish layers;          ///< measured along the profile from the base on
  bool arcLength = false;    ///< the step is measured along the profile instead of as its chord
  double leastRadius = 0.0;  ///< no circle smaller than this, mm (the pole)
  std::optional<Axis> axis;  ///< otherwise found
};

/// Parallels of a body of revolution, or of a sector of one, each at the same chord along the
/// profile from the one below: the inter-layer distance is exactly the step everywhere (Chalvin A7,
/// Eq. 2.4). The profile may turn back, have corners and end in a pole. Where the surface ends, at
/// the sides of a sector, at holes and on the substrate, parallels end with it.
/// @throws Error(JobFailed) telling where the part is no body of revolution, or that it does not
/// stand on the substrate
/// Cost: one section of the mesh and O(layers) evaluations.
SlicedLayers sliceRevolution(const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                             const Substrate& substrate,
                             const RevolutionOptions& options,
                             const Sampling& sampling,
                             const JobContext& context = JobContext());

/// Which parameter of the faces leads from layer to layer.
enum class IsoDirection { Auto, U, V };

struct FaceIsoOptions {
  LayerWish layers;  ///< measured along the iso-curves
  IsoDirection direction = IsoDirection::Auto;
};

/// Layers by the faces' own parameters (Chalvin A9): each point of the base climbs along the
/// iso-parametric curve through it, from layer to layer by a chord of the step. So all layers have
/// the same points and the local distance is at most the step. The base is the part's curve on the
/// substrate, planar or not (A10). Curves go on over the edges of faces where the next face has one
/// that continues them; where they end, layers become open arcs.
/// @throws Error(JobFailed) for a mesh, and telling which face has no curves that lead away from
/// the base
SlicedLayers sliceFaceIso(const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                          const Substrate& substrate,
                          const FaceIsoOptions& options,
                          const Sampling& sampling,
                          const JobContext& context = JobContext());

}  // namespace wcam::toolpath
