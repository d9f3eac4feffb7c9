// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/guide_curve.hpp"
#include "wcam/geometry/part_surface.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace wcam::geometry {

/// The axis lines of a part: nodes inside it, joined by edges. mm.
struct Skeleton {
  std::vector<Vec3> nodes;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::size_t> degree;  ///< per node

  /// One line without forks: a single spiral can cover the part (Diourté M11).
  [[nodiscard]] bool singleBranch() const;
};

/// Skeleton from the level curves of a field that grows from the lower end of the part to all
/// others (partEnds): each branch of the field gives a line through the centres of its curves, and
/// its saddles are the forks. Works on open and closed surfaces alike, and the same surface always
/// gives the same skeleton. Bumps lower than a twentieth of the field make no branch.
/// @param up tells the lower end from the upper ones
/// @throws Error(InvalidArgument) for a surface without triangles
/// Cost: one sparse factorisation.
Skeleton skeletonOf(const TriangleMesh& mesh,
                    const HalfEdges& halfEdges,
                    const Vec3& up,
                    const JobContext& context = JobContext());

/// A guide along the axis of a tube: the C² spline through the centres of level curves of the same
/// field, from the centre of the lower border to that of the upper one, or to the top of a closed
/// part. Centres of whole loops are integrals over the mesh: smooth without smoothing, and the
/// borders belong to them, so that the guide ends in the border planes.
/// @throws Error(JobFailed) when the part branches (tells into how many), has no lower border or is
/// too short
std::shared_ptr<const GuideCurve> automaticGuide(const PartSurface& surface,
                                                 const Vec3& up,
                                                 const JobContext& context = JobContext());

}  // namespace wcam::geometry
