// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/mesh.hpp"

#include "weld.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace wcam::io {

/// Joins equal vertices of an indexed mesh. @return the number of vertices that were joined
inline std::size_t weldVertices(geometry::TriangleMesh& mesh) {
  PointWelder<double> welder(mesh.vertices.size());
  std::vector<std::uint32_t> index;
  index.reserve(mesh.vertices.size());
  for (const geometry::Vec3& p : mesh.vertices) {
    index.push_back(welder.add({p.x(), p.y(), p.z()}));
  }
  const std::size_t before = mesh.vertices.size();
  mesh.vertices.clear();
  for (const auto& p : welder.points()) {
    mesh.vertices.emplace_back(p[0], p[1], p[2]);
  }
  for (auto& t : mesh.triangles) {
    t = {index[t[0]], index[t[1]], index[t[2]]};
  }
  return before - mesh.vertices.size();
}

}  // namespace wcam::io
