// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fuzz_mesh.hpp"
#include "mesh_repair.hpp"

#include <cstdint>
#include <cstring>

/// Every four bytes are a vertex on a small grid, then triangles: repair leaves indices that exist.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wcam;
  geometry::TriangleMesh mesh;
  if (size < 8) {
    return 0;
  }
  const std::size_t vertices = 3 + data[0] % 30;
  std::size_t at = 1;
  for (std::size_t v = 0; v < vertices && at + 3 <= size; ++v, at += 3) {
    mesh.vertices.emplace_back(data[at] % 16, data[at + 1] % 16, 0.01 * data[at + 2]);
  }
  for (; at + 3 <= size && !mesh.vertices.empty(); at += 3) {
    const auto corner = [&](std::size_t k) {
      return static_cast<std::uint32_t>(data[at + k] % mesh.vertices.size());
    };
    mesh.triangles.push_back({corner(0), corner(1), corner(2)});
  }
  io::dropDegenerate(mesh);
  io::dropDuplicates(mesh);
  fuzz::checkMesh(mesh);
  io::stitchBorders(mesh, geometry::HalfEdges(mesh), 0.05);
  io::dropDegenerate(mesh);
  io::dropUnusedVertices(mesh);
  (void)io::countFlat(mesh);
  fuzz::checkMesh(mesh);
  return 0;
}
