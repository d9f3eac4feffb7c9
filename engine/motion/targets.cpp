// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "plan_detail.hpp"

#include <algorithm>
#include <limits>

namespace wcam::motion::detail {

namespace {

using toolpath::Bead;
using toolpath::PathPoint;

/// Two directions closer than this (norm of the difference) share their greatest height.
constexpr double kSameDirection = 1e-12;

/// Greatest height of everything deposited so far along a direction. Exact: boxes of beads rule out
/// most of them, and a direction that stays the same costs only the new beads.
class Deposit {
public:
  void add(const Bead& bead) {
    geometry::Box box;
    for (const PathPoint& point : bead.points) {
      box.add(point.p);
    }
    beads_.push_back(&bead);
    boxes_.push_back(box);
  }

  double height(const Vec3& direction) {
    if (!((direction - direction_).norm() <= kSameDirection)) {
      direction_ = direction;
      greatest_ = -std::numeric_limits<double>::infinity();
      seen_ = 0;
    }
    for (; seen_ < beads_.size(); ++seen_) {
      const geometry::Box& box = boxes_[seen_];
      const Vec3 corner(direction.x() > 0 ? box.max.x() : box.min.x(),
                        direction.y() > 0 ? box.max.y() : box.min.y(),
                        direction.z() > 0 ? box.max.z() : box.min.z());
      if (box.empty() || corner.dot(direction) <= greatest_) {
        continue;
      }
      for (const PathPoint& point : beads_[seen_]->points) {
        greatest_ = std::max(greatest_, point.p.dot(direction));
      }
    }
    return greatest_;
  }

private:
  std::vector<const Bead*> beads_;
  std::vector<geometry::Box> boxes_;
  Vec3 direction_ = Vec3::Zero();
  double greatest_ = -std::numeric_limits<double>::infinity();
  std::size_t seen_ = 0;
};

Target targetAt(const PathPoint& point, int layer, int bead) {
  Target target;
  target.p = point.p;
  target.axis = point.axis;
  target.up = point.up;
  target.waypoint.layer = layer;
  target.waypoint.bead = bead;
  return target;
}

/// A move with the arc off, by an offset from a bead's end.
Target travelAt(
    const PathPoint& point, const Vec3& offset, MoveKind kind, int layer, int bead, double speed) {
  Target target = targetAt(point, layer, bead);
  target.p += offset;
  target.waypoint.kind = kind;
  target.waypoint.speed = speed;
  return target;
}

/// Offset along `up` from a point (already lifted by `base`) to the safe height above the deposit.
Vec3 liftOffset(Deposit& deposit, const PathPoint& point, const Vec3& base, double safeHeight) {
  const double top = std::max(deposit.height(point.up), point.p.dot(point.up));
  const double missing = top + safeHeight - (point.p + base).dot(point.up);
  return base + point.up * std::max(missing, 0.0);
}

void addBead(
    const Bead& bead, int layer, int index, double travelSpeed, std::vector<Target>& targets) {
  for (std::size_t i = 0; i < bead.points.size(); ++i) {
    const PathPoint& point = bead.points[i];
    const bool travels = i == 0 || point.zone == toolpath::BeadZone::Wipe;
    Target target = targetAt(point, layer, index);
    target.waypoint.point = static_cast<int>(i);
    target.waypoint.arc = i > 0 && point.arc;
    target.waypoint.speed = travels ? travelSpeed : point.speed;
    target.waypoint.wireSpeed = target.waypoint.arc ? point.wireSpeed : 0.0;
    targets.push_back(target);
  }
}

}  // namespace

std::vector<Target> makeTargets(const toolpath::Toolpath& path,
                                const MotionParams& params,
                                const JobContext& context) {
  std::vector<Target> targets;
  Deposit deposit;
  const double travel = params.travelSpeed.value();
  for (std::size_t l = 0; l < path.layers.size(); ++l) {
    const auto layer = static_cast<int>(l);
    for (std::size_t k = 0; k < path.layers[l].beads.size(); ++k) {
      context.check();
      const Bead& bead = path.layers[l].beads[k];
      const auto index = static_cast<int>(k);
      if (bead.points.empty()) {
        continue;
      }
      const PathPoint& first = bead.points.front();
      const PathPoint& last = bead.points.back();
      const Vec3 before = first.axis * params.approachHeight.value();
      const Vec3 above = liftOffset(deposit, first, before, params.safeHeight.value());
      targets.push_back(travelAt(first, above, MoveKind::Joint, layer, index, travel));
      targets.push_back(travelAt(first, before, MoveKind::Linear, layer, index, travel));
      addBead(bead, layer, index, travel, targets);
      deposit.add(bead);
      const Vec3 after = last.axis * params.approachHeight.value();
      const Vec3 away = liftOffset(deposit, last, after, params.safeHeight.value());
      targets.push_back(travelAt(last, after, MoveKind::Linear, layer, index, travel));
      targets.push_back(travelAt(last, away, MoveKind::Linear, layer, index, travel));
    }
  }
  return targets;
}

}  // namespace wcam::motion::detail
