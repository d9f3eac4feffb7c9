// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/slicing.hpp"
#include "wcam/toolpath/substrate.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace wcam::toolpath {

/// Where a part is cut off: what lies on the side of the normal is not built (Chalvin A13).
struct CutPlane {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  ///< outward unit normal of the material
};

struct ConstantDistanceOptions {
  double step = 1.0;        ///< distance of each layer to the one below, mm
  double firstLayer = 1.0;  ///< distance of the first layer from the base, in steps; 0: on the base
  std::optional<CutPlane> end;
  /// Corners where fronts meet are rounded; the distance between layers then differs from the step
  /// by at most this, mm. 0 keeps the corners.
  double cornerBound = 0.0;
  double meshEdge = 0.0;  ///< edge length of the mesh that carries the fronts, mm; 0 chooses one
};

/// Layers at constant distance (Chalvin A11, A12): each layer is the set of points of the surface
/// whose Euclidean distance to the layer below, measured along the near side of the surface, is the
/// step. So the inter-layer distance δ (A4) is the step at every point, on any mesh or exact
/// surface; where fronts meet, the layers keep a corner, and its place is exact.
///
/// The base is where the part stands on the substrate: its border loops there, the rim of its flat
/// bottom, or the curve in which a part that goes through the substrate leaves it (A10); that curve
/// is layer 0 and stays as it is. Layers split, merge and end with the part; on a slanted end they
/// are open arcs.
///
/// Findings: slicing.not_reached (a piece of the part that no path on the surface joins to the
/// base), slicing.distance_not_kept (with
/// the place: sharp edges of coarse meshes), slicing.corners_rounded, slicing.refinement_failed.
/// @throws Error(JobFailed) when the part does not touch the substrate or no layer fits;
/// Error(InvalidArgument) for a step that is not positive
/// Cost: per layer proportional to the triangles between it and the layer below.
SlicedLayers sliceConstantDistance(
    const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
    const Substrate& substrate,
    const ConstantDistanceOptions& options,
    const Sampling& sampling,
    const JobContext& context = JobContext());

}  // namespace wcam::toolpath
