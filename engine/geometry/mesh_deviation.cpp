// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/mesh_deviation.hpp"

#include "wcam/base/quantity.hpp"

#include <cmath>

namespace wcam::geometry {

namespace {

/// Two triangles that meet at less are one plane but for rounding of single precision.
const double kFlat = degToRad(0.05);
/// Two that meet at more make an edge of the shape. Coarser meshes of curved shapes are seldom.
const double kSharp = degToRad(30.0);

}  // namespace

double meshDeviation(const PartSurface& part) {
  if (part.exact()) {
    return 0.0;
  }
  const TriangleMesh& mesh = part.mesh;
  const HalfEdges& halfEdges = part.halfEdges;
  const auto doubleArea = [&mesh](std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  };
  double sum = 0.0;
  double weight = 0.0;
  for (std::uint32_t e = 0; e < halfEdges.edgeCount(); ++e) {
    const std::uint32_t h = halfEdges.halfEdgeOf(e);
    const std::uint32_t twin = halfEdges.twin(h);
    if (twin == HalfEdges::kNone) {
      continue;
    }
    const auto [from, to] = halfEdges.edgeVertices(e);
    const double length = (mesh.vertices[to] - mesh.vertices[from]).norm();
    const Vec3 n1 = mesh.normal(h / 3);
    const Vec3 n2 = mesh.normal(twin / 3);
    const double angle = std::atan2(n1.cross(n2).norm(), n1.dot(n2));
    if (!(length > 0.0) || !(angle > kFlat) || !(angle < kSharp)) {
      continue;
    }
    // The mean of both heights above the edge.
    const double extent = 0.5 * (doubleArea(h / 3) + doubleArea(twin / 3)) / length;
    sum += length * extent * angle / 8.0;
    weight += length;
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

}  // namespace wcam::geometry
