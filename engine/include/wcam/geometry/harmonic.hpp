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

/// Conduction of a triangle for the harmonic field: 1 is isotropic. With a direction the
/// conductivity along it (in the triangle's plane) is multiplied by `along`.
struct Conductivity {
  double weight = 1.0;
  Vec3 direction = Vec3::Zero();
  double along = 1.0;
};

/// Solution of div(κ·grad u) = 0 with values fixed on borders or any vertices, by linear finite
/// elements (Diourté M18, Eq. 3.13): between two borders the layers follow both of them. Values
/// stay between the least and the greatest fixed one (obtuse corners of the mesh can break this by
/// little; refineSurface avoids them). Vertices of components without a fixed value get NaN.
/// @param conductivity per triangle; empty for isotropic
/// @throws Error(InvalidArgument) when nothing is fixed, JobFailed when the mesh is too degenerate
std::vector<double> harmonicField(const TriangleMesh& mesh,
                                  const HalfEdges& halfEdges,
                                  const std::vector<FixedValues>& fixed,
                                  const std::vector<Conductivity>& conductivity = {},
                                  const JobContext& context = JobContext());

}  // namespace wcam::geometry
