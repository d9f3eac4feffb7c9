// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/surface_point.hpp"

#include "wcam/base/error.hpp"

namespace wcam::geometry {

Vec3 position(const TriangleMesh& mesh, const MeshPoint& point) {
  const auto& t = mesh.triangles[point.triangle];
  return point.weights[0] * mesh.vertices[t[0]] + point.weights[1] * mesh.vertices[t[1]] +
         point.weights[2] * mesh.vertices[t[2]];
}

double valueAt(const TriangleMesh& mesh, const std::vector<double>& field, const MeshPoint& point) {
  const auto& t = mesh.triangles[point.triangle];
  double value = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    // A corner without weight may lie outside the field.
    if (point.weights[c] != 0.0) {
      value += point.weights[c] * field[t[c]];
    }
  }
  return value;
}

std::vector<Vec3> triangleGradients(const TriangleMesh& mesh, const std::vector<double>& field) {
  WCAM_ASSERT(field.size() == mesh.vertices.size());
  std::vector<Vec3> gradients(mesh.triangles.size());
  for (std::size_t i = 0; i < gradients.size(); ++i) {
    const auto& t = mesh.triangles[i];
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3 ab = mesh.vertices[t[1]] - a;
    const Vec3 ac = mesh.vertices[t[2]] - a;
    const Vec3 n = ab.cross(ac);
    const double twiceAreaSquared = n.squaredNorm();
    if (twiceAreaSquared > 0.0) {
      const double fb = field[t[1]] - field[t[0]];
      const double fc = field[t[2]] - field[t[0]];
      // The differences are the gradient's products with the two edges.
      gradients[i] = n.cross(Vec3(fc * ab - fb * ac)) / twiceAreaSquared;
    } else {
      gradients[i] = Vec3::Zero();
    }
  }
  return gradients;
}

}  // namespace wcam::geometry
