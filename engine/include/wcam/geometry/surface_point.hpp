// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace wcam::geometry {

/// A point of a mesh: a triangle and barycentric weights of its corners (sum 1, none negative).
struct MeshPoint {
  std::uint32_t triangle = 0;
  std::array<double, 3> weights{1.0, 0.0, 0.0};
};

Vec3 position(const TriangleMesh& mesh, const MeshPoint& point);
/// Value of a field of vertices, linear on the triangle.
double valueAt(const TriangleMesh& mesh, const std::vector<double>& field, const MeshPoint& point);

/// Gradient of a field of vertices on each triangle, in the triangle's plane, per mm (Diourté A.4);
/// zero on degenerate triangles, NaN where a corner has no value.
std::vector<Vec3> triangleGradients(const TriangleMesh& mesh, const std::vector<double>& field);

}  // namespace wcam::geometry
