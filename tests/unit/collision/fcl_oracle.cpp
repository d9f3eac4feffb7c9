// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fcl_oracle.hpp"

#include "wcam/cell/kinematics.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace wcam::collision::test {

namespace {

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

Geometry geometryOf(const cell::Shape& shape) {
  switch (shape.kind) {
    case cell::ShapeKind::Sphere:
      return std::make_shared<fcl::Sphered>(shape.radius);
    case cell::ShapeKind::Capsule:
      return std::make_shared<fcl::Capsuled>(shape.radius, shape.length);
    case cell::ShapeKind::Cylinder:
      return std::make_shared<fcl::Cylinderd>(shape.radius, shape.length);
    case cell::ShapeKind::Box:
      return std::make_shared<fcl::Boxd>(shape.size);
    case cell::ShapeKind::Mesh:
      break;
  }
  auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  std::vector<fcl::Triangle> triangles;
  for (const auto& t : shape.mesh->triangles) {
    triangles.emplace_back(t[0], t[1], t[2]);
  }
  model->beginModel();
  model->addSubModel(shape.mesh->vertices, triangles);
  model->endModel();
  return model;
}

bool overlap(const Geometry& a,
             const geometry::Pose& T_a,
             const Geometry& b,
             const geometry::Pose& T_b) {
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide(a.get(), T_a, b.get(), T_b, request, result) > 0;
}

struct Query {
  std::size_t deposited;
  bool hit = false;
};

bool visit(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
  auto* query = static_cast<Query*>(data);
  const auto* rod = static_cast<const DepositRod*>(a->getUserData() != nullptr ? a->getUserData()
                                                                               : b->getUserData());
  if (rod->order <= query->deposited) {
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    query->hit = fcl::collide(a, b, request, result) > 0;
  }
  return query->hit;
}

}  // namespace

struct FclOracle::Impl {
  const CellCollision& collision;
  const cell::Cell& cell;
  std::vector<Geometry> shapes;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> rods;
  fcl::DynamicAABBTreeCollisionManagerd manager;

  bool withDeposit(const Geometry& shape,
                   const geometry::Pose& T_part_shape,
                   std::size_t deposited) {
    fcl::CollisionObjectd object(shape, T_part_shape);
    Query query{deposited};
    manager.collide(&object, &query, &visit);
    return query.hit;
  }
};

FclOracle::FclOracle(const CellCollision& collision, const cell::Cell& cell)
    : impl_(new Impl{collision, cell, {}, {}, {}}) {
  for (const PlacedShape& placed :
       collision.placedShapes(cell::JointVector::Zero(cell.jointCount()))) {
    impl_->shapes.push_back(geometryOf(*placed.shape));
  }
  std::vector<fcl::CollisionObjectd*> objects;
  for (const DepositRod& rod : collision.deposit()) {
    geometry::Pose pose = geometry::Pose::Identity();
    const geometry::Vec3 along = rod.b - rod.a;
    if (along.norm() > 0) {
      pose.linear() =
          Eigen::Quaterniond::FromTwoVectors(geometry::Vec3::UnitZ(), along).toRotationMatrix();
    }
    pose.translation() = 0.5 * (rod.a + rod.b);
    impl_->rods.push_back(std::make_unique<fcl::CollisionObjectd>(
        std::make_shared<fcl::Capsuled>(rod.radius, along.norm()), pose));
    impl_->rods.back()->setUserData(const_cast<DepositRod*>(&rod));
    objects.push_back(impl_->rods.back().get());
  }
  impl_->manager.registerObjects(objects);
  impl_->manager.setup();
}

FclOracle::~FclOracle() = default;

bool FclOracle::collides(const CellState& state, std::string* what) const {
  const std::vector<PlacedShape> placed = impl_->collision.placedShapes(state.joints);
  const geometry::Pose T_part_base = cell::T_base_part(impl_->cell, state.joints).inverse();
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const auto a = static_cast<std::ptrdiff_t>(i);
    for (std::size_t k = i + 1; k < placed.size(); ++k) {
      if (impl_->collision.compares(a, static_cast<std::ptrdiff_t>(k)) &&
          overlap(impl_->shapes[i], placed[i].T_base_shape, impl_->shapes[k],
                  placed[k].T_base_shape)) {
        *what = placed[i].label.str() + " and " + placed[k].label.str();
        return true;
      }
    }
    if (impl_->collision.compares(a, -1) &&
        impl_->withDeposit(impl_->shapes[i], T_part_base * placed[i].T_base_shape,
                           state.deposited)) {
      *what = placed[i].label.str() + " and part";
      return true;
    }
  }
  return false;
}

double FclOracle::shapeDistance(const CellState& state) const {
  const std::vector<PlacedShape> placed = impl_->collision.placedShapes(state.joints);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (std::size_t k = i + 1; k < placed.size(); ++k) {
      if (!impl_->collision.compares(static_cast<std::ptrdiff_t>(i),
                                     static_cast<std::ptrdiff_t>(k))) {
        continue;
      }
      if (overlap(impl_->shapes[i], placed[i].T_base_shape, impl_->shapes[k],
                  placed[k].T_base_shape)) {
        return 0.0;
      }
      const fcl::DistanceRequestd request;
      fcl::DistanceResultd result;
      least = std::min(
          least, fcl::distance(impl_->shapes[i].get(), placed[i].T_base_shape,
                               impl_->shapes[k].get(), placed[k].T_base_shape, request, result));
    }
  }
  return least;
}

bool FclOracle::torchCollides(const ToolState& state) const {
  const cell::JointVector zero = cell::JointVector::Zero(impl_->cell.jointCount());
  const geometry::Pose T_tcp_base = cell::T_base_tcp(impl_->cell, zero).inverse();
  const std::vector<PlacedShape> placed = impl_->collision.placedShapes(zero);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const std::string& frame = placed[i].shape->frame;
    if (placed[i].kind == BodyKind::Torch && (frame == "tcp" || frame == "flange") &&
        impl_->withDeposit(impl_->shapes[i], state.T_part_tcp * T_tcp_base * placed[i].T_base_shape,
                           state.deposited)) {
      return true;
    }
  }
  return false;
}

}  // namespace wcam::collision::test
