// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/surface_projector.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wcam::geometry {

namespace {

/// Facets that meet at a smaller angle count as one smooth surface.
const double kSmoothFacetCosine = std::cos(0.7);
/// Newton is quadratic from a start within a mesh chord.
constexpr int kNewtonSteps = 16;
/// Rounding of a surface evaluation, in parts of the part's size.
constexpr double kRounding = 1e-15;
/// The nearest exact point is no farther from the start than this many triangle sizes.
constexpr double kReach = 2.0;
constexpr std::size_t kGrain = 256;

std::array<double, 3> barycentric(const std::array<Vec3, 3>& corner, const Vec3& p) {
  const Vec3 e1 = corner[1] - corner[0];
  const Vec3 e2 = corner[2] - corner[0];
  const Vec3 d = p - corner[0];
  const double a = e1.dot(e1);
  const double b = e1.dot(e2);
  const double c = e2.dot(e2);
  const double det = a * c - b * b;
  if (!(det > 0.0)) {
    return {1.0, 0.0, 0.0};
  }
  const double v = (c * d.dot(e1) - b * d.dot(e2)) / det;
  const double w = (a * d.dot(e2) - b * d.dot(e1)) / det;
  return {1.0 - v - w, v, w};
}

std::array<Vec3, 3> cornersOf(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& t = mesh.triangles[triangle];
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

/// Angle-weighted normals per corner over the facets of the vertex that are smooth with the
/// corner's.
std::vector<std::array<Vec3, 3>> smoothNormals(const TriangleMesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  std::vector<Vec3> facet(count);
  std::vector<std::array<double, 3>> angle(count);
  std::vector<std::uint32_t> first(mesh.vertices.size() + 1, 0);
  for (std::size_t t = 0; t < count; ++t) {
    facet[t] = mesh.normal(t);
    const auto corner = cornersOf(mesh, static_cast<std::uint32_t>(t));
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 a = corner[(c + 1) % 3] - corner[c];
      const Vec3 b = corner[(c + 2) % 3] - corner[c];
      angle[t][c] = std::atan2(a.cross(b).norm(), a.dot(b));
      ++first[mesh.triangles[t][c] + 1];
    }
  }
  for (std::size_t v = 1; v < first.size(); ++v) {
    first[v] += first[v - 1];
  }
  std::vector<std::uint32_t> around(3 * count);
  std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      around[fill[mesh.triangles[t][c]]++] = static_cast<std::uint32_t>(3 * t + c);
    }
  }
  std::vector<std::array<Vec3, 3>> normals(count);
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = mesh.triangles[t][c];
      Vec3 sum = Vec3::Zero();
      for (std::uint32_t i = first[v]; i < first[v + 1]; ++i) {
        const std::uint32_t other = around[i] / 3;
        if (facet[other].dot(facet[t]) > kSmoothFacetCosine) {
          sum += angle[other][around[i] % 3] * facet[other];
        }
      }
      normals[t][c] = sum.norm() > 0.0 ? Vec3(sum.normalized()) : facet[t];
    }
  }
  return normals;
}

/// Closest point of the face by Gauss-Newton from a start in (u,v); nothing when it runs away.
std::optional<ProjectedPoint> closestOnFace(
    const BrepEvaluator& evaluator, int face, Vec2 uv, const Vec3& q, double reach) {
  SurfacePoint at = evaluator.surface(face, uv);
  const Vec3 begin = at.p;
  for (int i = 0; i < kNewtonSteps; ++i) {
    const Vec3 error = q - at.p;
    const double uu = at.du.squaredNorm();
    const double uv2 = at.du.dot(at.dv);
    const double vv = at.dv.squaredNorm();
    const double gu = at.du.dot(error);
    const double gv = at.dv.dot(error);
    const double det = uu * vv - uv2 * uv2;
    constexpr double kParallel = 1e-14;
    Vec2 step;
    if (det > kParallel * uu * vv) {
      step = Vec2((vv * gu - uv2 * gv) / det, (uu * gv - uv2 * gu) / det);
    } else if (uu > 0.0 || vv > 0.0) {
      step = uu >= vv ? Vec2(gu / uu, 0.0) : Vec2(0.0, gv / vv);
    } else {
      break;
    }
    uv += step;
    const Vec3 before = at.p;
    at = evaluator.surface(face, uv);
    if (!at.p.allFinite() || (at.p - begin).norm() > reach) {
      return std::nullopt;
    }
    if ((at.p - before).norm() <= kRounding * (1.0 + q.norm())) {
      break;
    }
  }
  return ProjectedPoint{at.p, evaluator.normal(face, uv, at), 0};
}

}  // namespace

SurfaceProjector::SurfaceProjector(const PartSurface& part) : part_(&part), tree_(part.mesh) {
  if (part.mesh.triangles.empty()) {
    throw Error(ErrorCode::InvalidArgument, "the part has no triangles", "projection", "");
  }
  if (!part.exact()) {
    cornerNormals_ = smoothNormals(part.mesh);
  }
}

ProjectedPoint SurfaceProjector::onMesh(const SurfaceHit& hit) const {
  ProjectedPoint result{hit.p, part_->mesh.normal(hit.triangle), hit.triangle};
  if (!cornerNormals_.empty()) {
    const auto w = barycentric(cornersOf(part_->mesh, hit.triangle), hit.p);
    const auto& n = cornerNormals_[hit.triangle];
    const Vec3 sum = w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
    if (sum.norm() > 0.0) {
      result.n = sum.normalized();
    }
  }
  return result;
}

std::vector<ProjectedPoint> SurfaceProjector::project(const std::vector<Vec3>& points,
                                                      const JobContext& context) const {
  std::vector<ProjectedPoint> result(points.size());
  parallelForChunks(
      points.size(), kGrain,
      [&](std::size_t from, std::size_t to) {
        std::optional<BrepEvaluator> evaluator;
        if (part_->exact()) {
          evaluator.emplace(*part_->brep);
        }
        context.check();
        for (std::size_t i = from; i < to; ++i) {
          const auto hit = tree_.closestPoint(points[i]);
          if (!hit) {
            throw Error(ErrorCode::InvalidArgument, "the part has only degenerate triangles",
                        "projection", "repair the part");
          }
          result[i] = onMesh(*hit);
          if (!evaluator) {
            continue;
          }
          const auto corner = cornersOf(part_->mesh, hit->triangle);
          const auto w = barycentric(corner, hit->p);
          const auto& uv = part_->binding.uv[hit->triangle];
          const double size =
              std::max({(corner[1] - corner[0]).norm(), (corner[2] - corner[0]).norm(),
                        (corner[2] - corner[1]).norm()});
          const auto exact = closestOnFace(*evaluator, part_->binding.face[hit->triangle],
                                           w[0] * uv[0] + w[1] * uv[1] + w[2] * uv[2], points[i],
                                           kReach * size + hit->distance);
          if (exact) {
            result[i].p = exact->p;
            if (exact->n.norm() > 0.0) {
              result[i].n = exact->n;
            }
          }
        }
      },
      context);
  return result;
}

}  // namespace wcam::geometry
