// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/aabb_tree.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <vector>

namespace wcam::geometry {

namespace {
using Kernel = CGAL::Simple_cartesian<double>;
using Triangle = Kernel::Triangle_3;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, std::vector<Triangle>::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 toCgal(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

Vec3 fromCgal(const Kernel::Point_3& p) {
  return {p.x(), p.y(), p.z()};
}
}  // namespace

struct AabbTree::Impl {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> origin;  ///< mesh triangle of each kept triangle
  Tree tree;

  [[nodiscard]] std::uint32_t meshTriangle(std::vector<Triangle>::const_iterator it) const {
    return origin[static_cast<std::size_t>(it - triangles.begin())];
  }
};

AabbTree::AabbTree(const TriangleMesh& mesh) : impl_(std::make_unique<Impl>()) {
  impl_->triangles.reserve(mesh.triangles.size());
  impl_->origin.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Triangle triangle(toCgal(mesh.vertices[a]), toCgal(mesh.vertices[b]),
                            toCgal(mesh.vertices[c]));
    if (!triangle.is_degenerate()) {
      impl_->triangles.push_back(triangle);
      impl_->origin.push_back(static_cast<std::uint32_t>(t));
    }
  }
  impl_->tree.rebuild(impl_->triangles.cbegin(), impl_->triangles.cend());
  if (!impl_->triangles.empty()) {
    // Builds the point search structure now: on demand it would not be thread-safe.
    impl_->tree.accelerate_distance_queries();
    impl_->tree.build();
  }
}

AabbTree::~AabbTree() = default;
AabbTree::AabbTree(AabbTree&&) noexcept = default;
AabbTree& AabbTree::operator=(AabbTree&&) noexcept = default;

std::optional<SurfaceHit> AabbTree::closestPoint(const Vec3& query) const {
  if (impl_->triangles.empty()) {
    return std::nullopt;
  }
  const auto [point, primitive] = impl_->tree.closest_point_and_primitive(toCgal(query));
  const Vec3 p = fromCgal(point);
  return SurfaceHit{p, impl_->meshTriangle(primitive), (p - query).norm()};
}

std::optional<SurfaceHit> AabbTree::firstHit(const Vec3& origin, const Vec3& direction) const {
  if (impl_->triangles.empty()) {
    return std::nullopt;
  }
  const Kernel::Ray_3 ray(toCgal(origin),
                          Kernel::Vector_3(direction.x(), direction.y(), direction.z()));
  const auto hit = impl_->tree.first_intersection(ray);
  if (!hit) {
    return std::nullopt;
  }
  Vec3 p = origin;
  if (const auto* point = boost::get<Kernel::Point_3>(&hit->first)) {
    p = fromCgal(*point);
  } else if (const auto* segment = boost::get<Kernel::Segment_3>(&hit->first)) {
    const Vec3 a = fromCgal(segment->source());
    const Vec3 b = fromCgal(segment->target());
    p = (a - origin).dot(direction) <= (b - origin).dot(direction) ? a : b;
  }
  return SurfaceHit{p, impl_->meshTriangle(hit->second), (p - origin).norm()};
}

}  // namespace wcam::geometry
