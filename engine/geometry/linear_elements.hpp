// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/mesh.hpp"

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <vector>

namespace wcam::geometry {

/// A triangle laid into its own plane for linear finite elements: gradients of its three hat
/// functions and its area. Flat triangles get a least height, so that every quotient stays bounded.
struct FlatTriangle {
  double area = 0.0;  ///< mm²; zero for a triangle that is a point
  /// Unit axes of the plane. Of a triangle without a plane of its own `second` is zero.
  Vec3 first = Vec3::Zero();
  Vec3 second = Vec3::Zero();
  std::array<Vec2, 3> gradients{};  ///< of the hat functions, per mm

  [[nodiscard]] Vec2 toPlane(const Vec3& direction) const {
    return {first.dot(direction), second.dot(direction)};
  }

  [[nodiscard]] Vec3 toSpace(const Vec2& direction) const {
    return direction.x() * first + direction.y() * second;
  }
};

FlatTriangle flatten(const TriangleMesh& mesh, std::size_t triangle);

/// Column-major; of symmetric matrices the lower half is kept.
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Number of each vertex's connected component, by lowest vertex; vertices of no triangle are
/// components of their own.
std::vector<std::uint32_t> componentsOf(const TriangleMesh& mesh);

}  // namespace wcam::geometry
