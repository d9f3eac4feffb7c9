// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/mesh.hpp"

namespace wcam::geometry {

Box TriangleMesh::bounds() const {
  Box box;
  for (const Vec3& p : vertices) {
    box.add(p);
  }
  return box;
}

Vec3 TriangleMesh::normal(std::size_t triangle) const {
  const auto& t = triangles[triangle];
  const Vec3 n = (vertices[t[1]] - vertices[t[0]]).cross(Vec3(vertices[t[2]] - vertices[t[0]]));
  const double length = n.norm();
  return length > 0.0 ? Vec3(n / length) : Vec3(Vec3::Zero());
}

}  // namespace wcam::geometry
