// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "exact.hpp"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

namespace wcam::collision::detail {

struct ExactShape::Impl {
  std::shared_ptr<const fcl::CollisionGeometryd> geometry;
};

namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<const fcl::CollisionGeometryd> modelOf(const geometry::TriangleMesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    triangles.emplace_back(t[0], t[1], t[2]);
  }
  auto model = std::make_shared<Model>();
  model->beginModel();
  model->addSubModel(mesh.vertices, triangles);
  model->endModel();
  return model;
}

std::shared_ptr<const fcl::CollisionGeometryd> geometryOf(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::Sphere:
      return std::make_shared<fcl::Sphered>(shape.radius);
    case ShapeKind::Capsule:
      return std::make_shared<fcl::Capsuled>(shape.radius, shape.length);
    case ShapeKind::Cylinder:
      return std::make_shared<fcl::Cylinderd>(shape.radius, shape.length);
    case ShapeKind::Box:
      return std::make_shared<fcl::Boxd>(shape.size);
    case ShapeKind::Mesh:
      return modelOf(*shape.mesh);
  }
  return nullptr;
}

/// The deepest contact; nothing when they do not touch.
bool deepest(const fcl::CollisionGeometryd* a,
             const Pose& T_a,
             const fcl::CollisionGeometryd* b,
             const Pose& T_b,
             ExactDistance& result) {
  constexpr std::size_t kContacts = 64;
  const fcl::CollisionRequestd request(kContacts, true);
  fcl::CollisionResultd found;
  if (fcl::collide(a, T_a, b, T_b, request, found) == 0) {
    return false;
  }
  result.value = 0.0;
  for (std::size_t i = 0; i < found.numContacts(); ++i) {
    const fcl::Contactd& contact = found.getContact(i);
    if (i == 0 || -std::abs(contact.penetration_depth) < result.value) {
      result.value = -std::abs(contact.penetration_depth);
      result.point = contact.pos;
    }
  }
  return true;
}

}  // namespace

ExactShape::ExactShape(const Shape& shape)
    : impl_(std::make_shared<const Impl>(Impl{geometryOf(shape)})) {}

ExactShape::ExactShape(const Rod& rod)
    : impl_(std::make_shared<const Impl>(
          Impl{std::make_shared<fcl::Capsuled>(rod.radius, (rod.b - rod.a).norm())})) {}

Pose poseOf(const Rod& rod) {
  Pose pose = Pose::Identity();
  const Vec3 along = rod.b - rod.a;
  if (along.squaredNorm() > 0.0) {
    pose.linear() = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), along).toRotationMatrix();
  }
  pose.translation() = 0.5 * (rod.a + rod.b);
  return pose;
}

ExactDistance exactDistance(const ExactShape& a,
                            const Pose& T_a,
                            const ExactShape& b,
                            const Pose& T_b) {
  const fcl::CollisionGeometryd* first = a.impl().geometry.get();
  const fcl::CollisionGeometryd* second = b.impl().geometry.get();
  ExactDistance result;
  try {
    if (deepest(first, T_a, second, T_b, result)) {
      return result;
    }
    const fcl::DistanceRequestd request(true);
    fcl::DistanceResultd found;
    result.value = std::max(fcl::distance(first, T_a, second, T_b, request, found), 0.0);
    result.point = 0.5 * (found.nearest_points[0] + found.nearest_points[1]);
  } catch (const std::exception&) {
    // FCL gives up on degenerate positions of touching solids: taken as touching.
    result.value = 0.0;
    result.point = T_b.translation();
  }
  return result;
}

}  // namespace wcam::collision::detail
