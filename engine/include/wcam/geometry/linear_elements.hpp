// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/mesh.hpp"

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace wcam::geometry {

/// A triangle laid into its own plane for linear finite elements: gradients of its three hat
/// functions and its area. Flat triangles get a least height (1e-7 of their length), so that every
/// quotient stays bounded.
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

/// Column-major.
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Cotangent Laplacian −L_C of a mesh (Diourté A.2 with the sign of a stiffness): symmetric,
/// positive semi-definite, rows sum to zero. Both halves are stored.
SparseMatrix stiffnessMatrix(const TriangleMesh& mesh);
/// A third of the area of the triangles about each vertex, mm² (Diourté A.2).
std::vector<double> vertexAreas(const TriangleMesh& mesh);
/// Divergence of one vector per triangle, integrated over each vertex's cell (Diourté A.5). Sums to
/// zero.
Eigen::VectorXd divergence(const TriangleMesh& mesh, const std::vector<Vec3>& vectors);

/// Number of each vertex's connected component, by lowest vertex; vertices of no triangle are
/// components of their own.
std::vector<std::uint32_t> componentsOf(const TriangleMesh& mesh);

}  // namespace wcam::geometry
