// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_patch.hpp"

#include <Eigen/LU>

#include <algorithm>

namespace wcam::toolpath {

using geometry::SurfacePoint;
using geometry::Vec2;

namespace {
/// Gauss-Newton is quadratic from a start on the same triangle.
constexpr int kProjectionSteps = 8;
/// Determinant of the metric, relative, below which du and dv count as parallel (a pole).
constexpr double kParallel = 1e-14;
}  // namespace

std::optional<Vec2> solveMetric(const SurfacePoint& point, const Vec2& g) {
  const double uu = point.du.squaredNorm();
  const double uv = point.du.dot(point.dv);
  const double vv = point.dv.squaredNorm();
  const double det = uu * vv - uv * uv;
  if (!(det > kParallel * uu * vv)) {
    if (!(uu > 0.0) && !(vv > 0.0)) {
      return std::nullopt;
    }
    return uu >= vv ? Vec2(g[0] / uu, 0.0) : Vec2(0.0, g[1] / vv);
  }
  return Vec2((vv * g[0] - uv * g[1]) / det, (uu * g[1] - uv * g[0]) / det);
}

SurfacePatch::SurfacePatch(const geometry::PartSurface& part) : part_(&part) {
  if (part.exact()) {
    evaluator_.emplace(*part.brep);
  }
}

SurfacePoint SurfacePatch::surface(std::uint32_t triangle, const Vec2& uv) const {
  if (evaluator_) {
    return evaluator_->surface(part_->binding.face[triangle], uv);
  }
  const auto& t = part_->mesh.triangles[triangle];
  const Vec3& o = part_->mesh.vertices[t[0]];
  SurfacePoint point;
  point.du = part_->mesh.vertices[t[1]] - o;
  point.dv = part_->mesh.vertices[t[2]] - o;
  point.p = o + uv[0] * point.du + uv[1] * point.dv;
  return point;
}

Vec3 SurfacePatch::normal(std::uint32_t triangle, const Vec2& uv, const SurfacePoint& point) const {
  return evaluator_ ? evaluator_->normal(part_->binding.face[triangle], uv, point)
                    : part_->mesh.normal(triangle);
}

Vec2 SurfacePatch::corner(std::uint32_t triangle, std::size_t corner) const {
  if (evaluator_) {
    return part_->binding.uv[triangle][corner];
  }
  return {corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0};
}

Vec2 SurfacePatch::onHalfEdge(std::uint32_t triangle,
                              std::uint32_t halfEdge,
                              double fraction) const {
  const auto& tri = part_->mesh.triangles[triangle];
  const auto& other = part_->mesh.triangles[halfEdge / 3];
  const auto find = [&tri](std::uint32_t vertex) {
    return static_cast<std::size_t>(std::find(tri.begin(), tri.end(), vertex) - tri.begin());
  };
  const std::size_t i = find(other[halfEdge % 3]);
  const std::size_t j = find(other[(halfEdge % 3 + 1) % 3]);
  if (i < 3 && j < 3) {
    return corner(triangle, i) + fraction * (corner(triangle, j) - corner(triangle, i));
  }
  // The node is a vertex that the triangle shares, reached over another edge.
  if (i < 3 || j < 3) {
    return corner(triangle, i < 3 ? i : j);
  }
  return (corner(triangle, 0) + corner(triangle, 1) + corner(triangle, 2)) / 3.0;
}

Vec2 SurfacePatch::project(std::uint32_t triangle, Vec2 uv, const Vec3& p) const {
  SurfacePoint at = surface(triangle, uv);
  double distance = (p - at.p).norm();
  for (int i = 0; i < kProjectionSteps && distance > 0.0; ++i) {
    const Vec3 error = p - at.p;
    const auto step = solveMetric(at, Vec2(error.dot(at.du), error.dot(at.dv)));
    if (!step || !step->allFinite()) {
      break;
    }
    const SurfacePoint next = surface(triangle, uv + *step);
    const double nextDistance = (p - next.p).norm();
    if (!(nextDistance < distance)) {
      break;
    }
    uv += *step;
    at = next;
    distance = nextDistance;
  }
  return uv;
}

Vec3 SurfacePatch::edgePoint(std::uint32_t halfEdge, double fraction) const {
  if (evaluator_ && part_->binding.edge[halfEdge] >= 0) {
    const auto& t = part_->binding.edgeParam[halfEdge];
    return evaluator_->curve(part_->binding.edge[halfEdge], t[0] + fraction * (t[1] - t[0])).p;
  }
  return surface(halfEdge / 3, onHalfEdge(halfEdge / 3, halfEdge, fraction)).p;
}

Vec3 SurfacePatch::weights(std::uint32_t triangle, const Vec2& uv) const {
  const Vec2 o = corner(triangle, 0);
  Eigen::Matrix2d m;
  m.col(0) = corner(triangle, 1) - o;
  m.col(1) = corner(triangle, 2) - o;
  const Vec2 w = m.inverse() * (uv - o);
  return {1.0 - w[0] - w[1], w[0], w[1]};
}

}  // namespace wcam::toolpath
