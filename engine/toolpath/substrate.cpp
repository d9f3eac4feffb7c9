// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/substrate.hpp"

#include "wcam/base/error.hpp"
#include "wcam/geometry/aabb_tree.hpp"

#include <Eigen/LU>

#include <mutex>
#include <vector>

namespace wcam::toolpath {

struct Substrate::Query {
  geometry::AabbTree tree;
  double top = 0.0;  ///< highest point of the body along the build direction
  /// Evaluators that no thread uses at the moment.
  std::mutex mutex;
  std::vector<std::unique_ptr<geometry::BrepEvaluator>> idle;

  explicit Query(const geometry::TriangleMesh& mesh) : tree(mesh) {}

  /// Calls a function with an evaluator of the body's exact surface that no other thread uses.
  template <class Function>
  auto withEvaluator(const geometry::Brep& brep, const Function& function) {
    std::unique_ptr<geometry::BrepEvaluator> evaluator;
    {
      const std::lock_guard lock(mutex);
      if (!idle.empty()) {
        evaluator = std::move(idle.back());
        idle.pop_back();
      }
    }
    if (evaluator == nullptr) {
      evaluator = std::make_unique<geometry::BrepEvaluator>(brep);
    }
    const auto result = function(*evaluator);
    const std::lock_guard lock(mutex);
    idle.push_back(std::move(evaluator));
    return result;
  }
};

Substrate::Substrate(const Pose& T_part_substrate, const Vec3& size)
    : T_part_substrate_(T_part_substrate), size_(size) {
  if (!(size.minCoeff() > 0.0)) {
    throw Error(ErrorCode::InvalidArgument,
                "the plate needs a positive length, width and thickness", "substrate");
  }
}

Substrate::Substrate(const Pose& T_part_substrate,
                     std::shared_ptr<const geometry::PartSurface> body)
    : T_part_substrate_(T_part_substrate), body_(std::move(body)) {
  auto query = std::make_shared<Query>(body_->mesh);
  geometry::Box box;
  for (const Vec3& v : body_->mesh.vertices) {
    box.add(v);
    query->top = std::max(query->top, up().dot(v));
  }
  size_ = box.empty() ? Vec3::Zero() : Vec3(box.max - box.min);
  query_ = std::move(query);
}

Substrate::~Substrate() = default;

namespace {

/// Newton on a smooth face is quadratic from a start on the same triangle.
constexpr int kNewtonSteps = 12;

/// Parameters of a point of a triangle on the triangle's exact face.
geometry::Vec2 uvOf(const geometry::PartSurface& body, const geometry::SurfaceHit& hit) {
  const auto& triangle = body.mesh.triangles[hit.triangle];
  const Vec3& a = body.mesh.vertices[triangle[0]];
  Eigen::Matrix<double, 3, 2> edges;
  edges << body.mesh.vertices[triangle[1]] - a, body.mesh.vertices[triangle[2]] - a;
  const geometry::Vec2 w =
      (edges.transpose() * edges).inverse() * (edges.transpose() * (hit.p - a));
  const auto& corners = body.binding.uv[hit.triangle];
  return corners[0] + w[0] * (corners[1] - corners[0]) + w[1] * (corners[2] - corners[0]);
}

/// Foot of the perpendicular from p on the exact face of the nearest triangle; the foot on the mesh
/// where there is none near it (beyond the edge of the face).
Vec3 footOnFace(const geometry::BrepEvaluator& evaluator,
                const geometry::PartSurface& body,
                const geometry::SurfaceHit& hit,
                const Vec3& p) {
  const std::int32_t face = body.binding.face[hit.triangle];
  geometry::Vec2 uv = uvOf(body, hit);
  double height = (p - hit.p).dot(body.mesh.normal(hit.triangle));
  // A foot farther from the mesh than this part of the distance to it belongs to another place.
  constexpr double kSamePlace = 0.5;
  // The normal follows from step to step: linear, with the distance over the radius of curvature.
  constexpr int kSteps = 40;
  constexpr double kNear = 1e-10;
  for (int i = 0; i < kSteps; ++i) {
    const geometry::SurfacePoint s = evaluator.surface(face, uv);
    const Vec3 n = s.du.cross(s.dv).normalized();
    const Vec3 gap = p - s.p - height * n;
    Eigen::Matrix3d m;
    m << s.du, s.dv, n;
    const Vec3 step = m.fullPivLu().solve(gap);
    if (!step.allFinite()) {
      break;
    }
    uv += step.head<2>();
    height += step[2];
    if (gap.norm() <= kNear * (1.0 + p.norm())) {
      return (s.p - hit.p).norm() <= kSamePlace * (p - hit.p).norm() ? s.p : hit.p;
    }
  }
  return hit.p;
}

/// Place on the exact face of a triangle straight above or below p.
Substrate::Height heightOnFace(const geometry::BrepEvaluator& evaluator,
                               const geometry::PartSurface& body,
                               const geometry::SurfaceHit& hit,
                               const Vec3& p,
                               const Vec3& up,
                               const Substrate::Height& otherwise) {
  const std::int32_t face = body.binding.face[hit.triangle];
  geometry::Vec2 uv = uvOf(body, hit);
  double height = up.dot(p - hit.p);
  constexpr double kConverged = 1e-14;
  for (int i = 0; i < kNewtonSteps; ++i) {
    const geometry::SurfacePoint s = evaluator.surface(face, uv);
    const Vec3 gap = p - s.p - height * up;
    Eigen::Matrix3d m;
    m << s.du, s.dv, up;
    const Vec3 step = m.fullPivLu().solve(gap);
    if (!step.allFinite()) {
      return otherwise;
    }
    uv += step.head<2>();
    height += step[2];
    if (gap.norm() <= kConverged * (1.0 + p.norm())) {
      const Vec3 n = evaluator.normal(face, uv);
      const double slope = n.dot(up);
      return {height, slope != 0.0 ? Vec3(n / slope) : up};
    }
  }
  return otherwise;
}

}  // namespace

Substrate::Height Substrate::exactHeightAbove(const Vec3& p) const {
  const double abovePlane = up().dot(p - T_part_substrate_.translation());
  if (isPlate()) {
    return {abovePlane, up()};
  }
  const double lift = std::max(0.0, query_->top - up().dot(p)) + 1.0;
  const auto hit = query_->tree.firstHit(p + lift * up(), -up());
  if (!hit) {
    return {abovePlane, up()};
  }
  const Vec3 n = body_->mesh.normal(hit->triangle);
  const double slope = n.dot(up());
  const Height onMesh{up().dot(p - hit->p), slope != 0.0 ? Vec3(n / slope) : up()};
  if (!body_->exact()) {
    return onMesh;
  }
  return query_->withEvaluator(*body_->brep, [&](const geometry::BrepEvaluator& evaluator) {
    return heightOnFace(evaluator, *body_, *hit, p, up(), onMesh);
  });
}

Substrate::Foot Substrate::nearest(const Vec3& p) const {
  if (isPlate()) {
    return {up().dot(p - T_part_substrate_.translation()), up()};
  }
  const auto hit = query_->tree.closestPoint(p);
  if (!hit) {
    return {up().dot(p - T_part_substrate_.translation()), up()};
  }
  const Vec3 foot = body_->exact()
                        ? query_->withEvaluator(*body_->brep,
                                                [&](const geometry::BrepEvaluator& evaluator) {
                                                  return footOnFace(evaluator, *body_, *hit, p);
                                                })
                        : hit->p;
  const Vec3 n = body_->mesh.normal(hit->triangle);
  const Vec3 away = p - foot;
  const double distance = away.norm();
  const double side = away.dot(n) < 0.0 ? -1.0 : 1.0;
  // On the surface itself the triangle tells the direction.
  constexpr double kOnSurface = 1e-9;
  return {side * distance, distance > kOnSurface ? Vec3(side / distance * away) : n};
}

double Substrate::heightAbove(const Vec3& p) const {
  const double abovePlane = up().dot(p - T_part_substrate_.translation());
  if (isPlate()) {
    return abovePlane;
  }
  // Looks down from above everything: below the topmost surface counts as below.
  const double lift = std::max(0.0, query_->top - up().dot(p)) + 1.0;
  const auto hit = query_->tree.firstHit(p + lift * up(), -up());
  return hit ? up().dot(p - hit->p) : abovePlane;
}

}  // namespace wcam::toolpath
