// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/substrate.hpp"

#include "wcam/base/error.hpp"
#include "wcam/geometry/aabb_tree.hpp"

namespace wcam::toolpath {

struct Substrate::Query {
  geometry::AabbTree tree;
  double top = 0.0;  ///< highest point of the body along the build direction
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
  auto query = std::make_shared<Query>(Query{geometry::AabbTree(body_->mesh), 0.0});
  geometry::Box box;
  for (const Vec3& v : body_->mesh.vertices) {
    box.add(v);
    query->top = std::max(query->top, up().dot(v));
  }
  size_ = box.empty() ? Vec3::Zero() : Vec3(box.max - box.min);
  query_ = std::move(query);
}

Substrate::~Substrate() = default;

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
