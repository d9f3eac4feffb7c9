// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/refine.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/sha256.hpp"
#include "wcam/base/text.hpp"

#include "refine_patch.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::geometry {

namespace {

constexpr double kMostTriangles = 20e6;
/// Halving from any usable size to any usable edge takes fewer passes.
constexpr int kMostPasses = 64;
/// (u,v) of two corners count as the same below this part of the face's range.
constexpr double kSameUv = 1e-9;
/// Triangles that fields of parts get: enough for 0.1 % of a distance, few enough for a second.
constexpr double kLeastFieldTriangles = 20e3;
constexpr double kMostFieldTriangles = 400e3;
/// A layer crosses so many edges of the field's mesh.
constexpr double kEdgesPerStep = 2.0;

double areaOf(const TriangleMesh& mesh) {
  double twice = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[1]] - mesh.vertices[t[0]];
    const Vec3 b = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    twice += a.cross(b).norm();
  }
  return 0.5 * twice;
}

/// Triangles that splitting is expected to give, from above: halving leaves edges between half of
/// maxEdge and maxEdge, and a triangle's long edges are split without its short ones.
double triangleEstimate(const TriangleMesh& mesh, double maxEdge) {
  double count = 0.0;
  const auto halvings = [maxEdge](double length) {
    return std::max(0.0, std::ceil(std::log2(length / maxEdge)));
  };
  for (const auto& t : mesh.triangles) {
    std::array<double, 3> length{};
    for (std::size_t c = 0; c < 3; ++c) {
      length[c] = (mesh.vertices[t[(c + 1) % 3]] - mesh.vertices[t[c]]).norm();
    }
    std::sort(length.begin(), length.end());
    count += std::exp2(halvings(length[2]) + halvings(length[0]));
  }
  return count;
}

[[noreturn]] void throwTooMany(const TriangleMesh& mesh, double maxEdge) {
  double working = maxEdge;
  // A quarter leaves room for what the estimate does not see: curved edges, flips.
  do {
    working *= 2.0;
  } while (triangleEstimate(mesh, working) > 0.25 * kMostTriangles &&
           working < mesh.bounds().diagonal());
  throw Error(ErrorCode::InvalidArgument,
              text("an edge length of %1 mm would give more than 20 million triangles",
                   {formatFixed(maxEdge, 6)}),
              "surface refinement",
              text("use an edge length of %1 mm or more", {formatFixed(working, 6)}));
}

/// Marks vertices at non-manifold edges and vertices with several fans of triangles.
std::vector<std::uint8_t> irregularVertices(const TriangleMesh& mesh, const HalfEdges& halfEdges) {
  std::vector<std::uint8_t> borderStarts(mesh.vertices.size(), 0);
  for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
    std::uint8_t& starts = borderStarts[mesh.triangles[h / 3][h % 3]];
    if (halfEdges.twin(h) == HalfEdges::kNone && starts < 2) {
      ++starts;
    }
  }
  std::vector<std::uint8_t> irregular(mesh.vertices.size(), 0);
  for (std::size_t v = 0; v < irregular.size(); ++v) {
    irregular[v] = borderStarts[v] > 1 ? 1 : 0;
  }
  for (const std::uint32_t edge : halfEdges.nonManifoldEdges()) {
    for (const std::uint32_t v : halfEdges.edgeVertices(edge)) {
      irregular[v] = 1;
    }
  }
  return irregular;
}

double uvRange(const BrepFaceInfo& face, int parameter) {
  const auto& b = face.uvBounds;
  return parameter == 0 ? b[1] - b[0] : b[3] - b[2];
}

/// A pole shows itself by triangles of one face that give it different parameters across an edge
/// inside the face.
std::vector<std::int8_t> findPoles(const RefinePatch& patch) {
  std::vector<std::int8_t> pole(patch.mesh.vertices.size(), -1);
  if (!patch.exact()) {
    return pole;
  }
  const BrepBinding& binding = patch.binding;
  for (std::uint32_t h = 0; h < patch.twin.size(); ++h) {
    const std::uint32_t other = patch.twin[h];
    if (other == HalfEdges::kNone || binding.edge[h] >= 0 ||
        binding.face[h / 3] != binding.face[other / 3]) {
      continue;
    }
    const BrepFaceInfo& face = patch.brep->face(binding.face[h / 3]);
    const Vec2 difference = binding.uv[h / 3][h % 3] - binding.uv[other / 3][(other % 3 + 1) % 3];
    for (const int parameter : {0, 1}) {
      if (std::abs(difference[parameter]) > kSameUv * uvRange(face, parameter)) {
        pole[patch.startOf(h)] = static_cast<std::int8_t>(parameter);
      }
    }
  }
  return pole;
}

std::vector<double> uvSigns(const RefinePatch& patch) {
  std::vector<double> sign;
  if (patch.exact()) {
    sign.assign(static_cast<std::size_t>(patch.brep->faceCount()), 0.0);
    for (std::size_t t = 0; t < patch.mesh.triangles.size(); ++t) {
      const auto& uv = patch.binding.uv[t];
      const Vec2 a = uv[1] - uv[0];
      const Vec2 b = uv[2] - uv[0];
      sign[static_cast<std::size_t>(patch.binding.face[t])] += a.x() * b.y() - a.y() * b.x();
    }
    for (double& s : sign) {
      s = s < 0.0 ? -1.0 : 1.0;
    }
  }
  return sign;
}

RefinePatch patchOf(const PartSurface& surface) {
  RefinePatch patch;
  patch.mesh = surface.mesh;
  patch.brep = surface.brep.get();
  patch.binding = surface.binding;
  patch.twin.resize(3 * surface.mesh.triangles.size());
  for (std::uint32_t h = 0; h < patch.twin.size(); ++h) {
    patch.twin[h] = surface.halfEdges.twin(h);
  }
  patch.irregular = irregularVertices(surface.mesh, surface.halfEdges);
  patch.freeParameter = findPoles(patch);
  patch.uvSign = uvSigns(patch);
  return patch;
}

}  // namespace

bool pointLess(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

double RefinePatch::uvArea(std::int32_t face, const Vec2& a, const Vec2& b, const Vec2& c) const {
  const Vec2 ab = b - a;
  const Vec2 ac = c - a;
  return uvSign[static_cast<std::size_t>(face)] * (ab.x() * ac.y() - ab.y() * ac.x());
}

void RefinePatch::freePoles(std::uint32_t triangle) {
  auto& uv = binding.uv[triangle];
  for (std::size_t c = 0; c < 3; ++c) {
    if (const int free = freeParameter[mesh.triangles[triangle][c]]; free >= 0) {
      uv[c][free] = 0.5 * (uv[(c + 1) % 3][free] + uv[(c + 2) % 3][free]);
    }
  }
}

PartSurface refineSurface(const PartSurface& surface, double maxEdge, const JobContext& context) {
  if (!(maxEdge > 0.0) || !std::isfinite(maxEdge)) {
    throw Error(ErrorCode::InvalidArgument, "the greatest edge length must be positive",
                "surface refinement");
  }
  if (triangleEstimate(surface.mesh, maxEdge) > 4.0 * kMostTriangles) {
    throwTooMany(surface.mesh, maxEdge);
  }
  RefinePatch patch = patchOf(surface);
  flipToDelaunay(patch, maxEdge, context);
  for (int pass = 0; pass < kMostPasses; ++pass) {
    context.check();
    if (splitLongEdges(patch, maxEdge, context) == 0) {
      break;
    }
    if (static_cast<double>(patch.mesh.triangles.size()) > kMostTriangles) {
      throwTooMany(surface.mesh, maxEdge);
    }
    flipToDelaunay(patch, maxEdge, context);
  }
  PartSurface refined;
  refined.mesh = std::move(patch.mesh);
  refined.halfEdges = HalfEdges(refined.mesh);
  refined.brep = surface.brep;
  refined.binding = std::move(patch.binding);
  refined.hash = Sha256().text("refined").text(surface.hash).number(maxEdge).hex();
  return refined;
}

double fieldEdgeLength(const PartSurface& surface, double step) {
  const double area = areaOf(surface.mesh);
  if (!(area > 0.0)) {
    return step / kEdgesPerStep;
  }
  // Halving leaves edges of some 3/4 of the greatest; equilateral ones have this area.
  const auto edgeFor = [area](double triangles) {
    constexpr double kMeanEdge = 0.75;
    return std::sqrt(4.0 * area / (std::sqrt(3.0) * triangles)) / kMeanEdge;
  };
  return std::clamp(step / kEdgesPerStep, edgeFor(kMostFieldTriangles),
                    edgeFor(kLeastFieldTriangles));
}

}  // namespace wcam::geometry
