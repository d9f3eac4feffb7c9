// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/mesh.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace wcam::geometry {

/// A value that some vertices keep.
struct FixedValues {
  std::vector<std::uint32_t> vertices;
  double value = 0.0;
};

/// Conduction of a triangle for the harmonic field: κ = weight·(I + (along − 1)·d·dᵀ), d the unit
/// `direction` as seen in the triangle's plane (shorter when it leans out of it). Where the
/// conductivity is high the field is flat and its level curves lie far apart.
struct Conductivity {
  double weight = 1.0;            ///< greater than zero
  Vec3 direction = Vec3::Zero();  ///< any length; zero for an isotropic triangle
  double along = 1.0;             ///< factor on the conductivity along the direction
};

/// Solution of div(κ·grad u) = 0 with values fixed on borders or any vertices, by linear finite
/// elements (Diourté M18, Eq. 3.13): between two borders the layers follow both of them. Values
/// stay between the least and the greatest fixed one (obtuse corners of the mesh can break this by
/// little; refineSurface avoids them). Vertices of components without a fixed value get NaN.
/// Flat and point-like triangles count as 1e-7 of their length high. Result independent of threads.
/// @param conductivity per triangle; empty for isotropic
/// @throws Error(InvalidArgument) when nothing is fixed or a vertex has two values,
/// Error(JobFailed) when the mesh is too degenerate
/// Cost: one sparse factorisation, about O(n^1.5): 0.1 s for 50 000 vertices
std::vector<double> harmonicField(const TriangleMesh& mesh,
                                  const HalfEdges& halfEdges,
                                  const std::vector<FixedValues>& fixed,
                                  const std::vector<Conductivity>& conductivity = {},
                                  const JobContext& context = JobContext());

}  // namespace wcam::geometry
