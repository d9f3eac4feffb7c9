// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/part_surface.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/sha256.hpp"

#include <algorithm>

namespace wcam::geometry {

namespace {

/// Flags of the wanted faces. @throws Error(InvalidArgument)
std::vector<bool> faceFlags(const PartSurface& surface, const std::vector<int>& faces) {
  if (!surface.exact()) {
    throw Error(ErrorCode::InvalidArgument, "faces cannot be selected: the part is a mesh",
                "face selection", "import the part from STEP, IGES or BREP");
  }
  if (faces.empty()) {
    throw Error(ErrorCode::InvalidArgument, "no face is selected", "face selection",
                "name at least one face");
  }
  const int count = surface.brep->faceCount();
  std::vector<bool> wanted(static_cast<std::size_t>(count), false);
  for (const int face : faces) {
    if (face < 0 || face >= count) {
      throw Error(ErrorCode::InvalidArgument,
                  text("face %1 does not exist; the part has faces 0 to %2",
                       {std::to_string(face), std::to_string(count - 1)}),
                  "face selection");
    }
    wanted[static_cast<std::size_t>(face)] = true;
  }
  return wanted;
}

void copyTriangle(const PartSurface& from, std::size_t triangle, PartSurface& to) {
  to.mesh.triangles.push_back(from.mesh.triangles[triangle]);
  to.binding.face.push_back(from.binding.face[triangle]);
  to.binding.uv.push_back(from.binding.uv[triangle]);
  for (std::size_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
    to.binding.edge.push_back(from.binding.edge[h]);
    to.binding.edgeParam.push_back(from.binding.edgeParam[h]);
  }
}

/// Keeps the vertices that triangles use, in their order.
void dropUnusedVertices(const std::vector<Vec3>& all, TriangleMesh& mesh) {
  std::vector<std::uint32_t> newIndex(all.size(), HalfEdges::kNone);
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      newIndex[v] = 0;
    }
  }
  for (std::size_t v = 0; v < all.size(); ++v) {
    if (newIndex[v] != HalfEdges::kNone) {
      newIndex[v] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(all[v]);
    }
  }
  for (auto& t : mesh.triangles) {
    for (std::uint32_t& v : t) {
      v = newIndex[v];
    }
  }
}

}  // namespace

PartSurface selectFaces(const PartSurface& surface, const std::vector<int>& faces) {
  const std::vector<bool> wanted = faceFlags(surface, faces);
  PartSurface result;
  result.brep = surface.brep;
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    if (wanted[static_cast<std::size_t>(surface.binding.face[t])]) {
      copyTriangle(surface, t, result);
    }
  }
  dropUnusedVertices(surface.mesh.vertices, result.mesh);
  result.halfEdges = HalfEdges(result.mesh);
  Sha256 hash;
  hash.text("faces").text(surface.hash);
  for (std::size_t f = 0; f < wanted.size(); ++f) {
    if (wanted[f]) {
      hash.integer(static_cast<std::int64_t>(f));
    }
  }
  result.hash = hash.hex();
  return result;
}

}  // namespace wcam::geometry
