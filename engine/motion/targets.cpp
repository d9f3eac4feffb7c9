// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"

#include "plan_detail.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::motion::detail {

namespace {

using geometry::Vec2;
using toolpath::Bead;
using toolpath::PathPoint;

/// Two directions closer than this (norm of the difference) share their greatest height.
constexpr double kSameDirection = 1e-12;

double pointToSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 ab = b - a;
  const double length2 = ab.squaredNorm();
  const double s = length2 > 0.0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return (p - (a + s * ab)).norm();
}

double segmentToSegment(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto side = [](const Vec2& p, const Vec2& q, const Vec2& r) {
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  };
  if (side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0) {
    return 0.0;
  }
  return std::min({pointToSegment(a, c, d), pointToSegment(b, c, d), pointToSegment(c, a, b),
                   pointToSegment(d, a, b)});
}

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

  /// True when nothing that was deposited within `radius` beside the line from a to b is higher
  /// than a limit, both seen along a direction.
  [[nodiscard]] bool clear(
      const Vec3& a, const Vec3& b, const Vec3& direction, double limit, double radius) const {
    const Vec3 e1 = direction.unitOrthogonal();
    const Vec3 e2 = direction.cross(e1);
    const auto flat = [&](const Vec3& p) { return Vec2(p.dot(e1), p.dot(e2)); };
    for (std::size_t k = 0; k < beads_.size(); ++k) {
      const geometry::Box& box = boxes_[k];
      const Vec3 middle = 0.5 * (box.min + box.max);
      const double reach = 0.5 * box.diagonal();
      const double beside = pointToSegment(flat(middle), flat(a), flat(b));
      if (middle.dot(direction) + reach <= limit || beside - reach > radius) {
        continue;
      }
      const std::vector<PathPoint>& points = beads_[k]->points;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3& p = points[i].p;
        const Vec3& q = points[i > 0 ? i - 1 : 0].p;
        if (std::max(p.dot(direction), q.dot(direction)) > limit &&
            segmentToSegment(flat(q), flat(p), flat(a), flat(b)) <= radius) {
          return false;
        }
      }
    }
    return true;
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
  target.along = point.t;
  target.waypoint.layer = layer;
  target.waypoint.bead = bead;
  return target;
}

/// A bead with its place in the operation.
struct Placed {
  const Bead* bead;
  int layer;
  int index;
};

/// A move with the arc off, by an offset from a bead's end.
Target travelAt(const PathPoint& point,
                const Vec3& offset,
                MoveKind kind,
                const Placed& placed,
                std::size_t deposited,
                double speed) {
  Target target = targetAt(point, placed.layer, placed.index);
  target.waypoint.deposited = deposited;
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

void addBead(const Bead& bead,
             int layer,
             int index,
             double travelSpeed,
             std::size_t deposited,
             std::vector<Target>& targets) {
  for (std::size_t i = 0; i < bead.points.size(); ++i) {
    const PathPoint& point = bead.points[i];
    const bool travels = i == 0 || point.zone == toolpath::BeadZone::Wipe;
    Target target = targetAt(point, layer, index);
    target.waypoint.point = static_cast<int>(i);
    // The point itself lies under the arc: what is before it stands.
    target.waypoint.deposited = deposited + i;
    target.waypoint.arc = i > 0 && point.arc;
    target.waypoint.speed = travels ? travelSpeed : point.speed;
    target.waypoint.wireSpeed = target.waypoint.arc ? point.wireSpeed : 0.0;
    targets.push_back(target);
  }
}

std::vector<Placed> beadsInOrder(const toolpath::Toolpath& path) {
  std::vector<Placed> beads;
  for (std::size_t l = 0; l < path.layers.size(); ++l) {
    for (std::size_t k = 0; k < path.layers[l].beads.size(); ++k) {
      if (!path.layers[l].beads[k].points.empty()) {
        beads.push_back({&path.layers[l].beads[k], static_cast<int>(l), static_cast<int>(k)});
      }
    }
  }
  return beads;
}

/// Beyond this change of the build direction the part turns so far below the torch that the
/// straight line says little about the way of the torch's body, rad.
const double kSameUp = degToRad(5.0);

/// May the torch go straight from above the end of a bead to above the start of the next one?
bool linksDirectly(const Deposit& deposit,
                   const PathPoint& from,
                   const PathPoint& to,
                   const MotionParams& params) {
  if (params.link != LinkMode::Direct ||
      std::atan2(from.up.cross(to.up).norm(), from.up.dot(to.up)) > kSameUp) {
    return false;
  }
  const double lift = params.approachHeight.value();
  const Vec3 a = from.p + lift * from.axis;
  const Vec3 b = to.p + lift * to.axis;
  const Vec3 up = (from.up + to.up).normalized();
  const double limit = std::min(a.dot(up), b.dot(up)) - params.linkClearance.value();
  return deposit.clear(a, b, up, limit, params.torchRadius.value());
}

}  // namespace

std::vector<Target> makeTargets(const toolpath::Toolpath& path,
                                const MotionParams& params,
                                const JobContext& context) {
  std::vector<Target> targets;
  Deposit deposit;
  const double travel = params.travelSpeed.value();
  const std::vector<Placed> beads = beadsInOrder(path);
  bool linked = false;
  std::size_t deposited = 0;
  for (std::size_t i = 0; i < beads.size(); ++i) {
    context.check();
    const Placed& placed = beads[i];
    const Bead* bead = placed.bead;
    const auto travelTo = [&](const PathPoint& point, const Vec3& offset, MoveKind kind) {
      targets.push_back(travelAt(point, offset, kind, placed, deposited, travel));
    };
    const PathPoint& first = bead->points.front();
    const PathPoint& last = bead->points.back();
    const Vec3 before = first.axis * params.approachHeight.value();
    if (!linked) {
      const Vec3 above = liftOffset(deposit, first, before, params.safeHeight.value());
      travelTo(first, above, MoveKind::Joint);
    }
    travelTo(first, before, MoveKind::Linear);
    addBead(*bead, placed.layer, placed.index, travel, deposited, targets);
    deposit.add(*bead);
    deposited += bead->points.size();
    const Vec3 after = last.axis * params.approachHeight.value();
    travelTo(last, after, MoveKind::Linear);
    linked = i + 1 < beads.size() &&
             linksDirectly(deposit, last, beads[i + 1].bead->points.front(), params);
    if (!linked) {
      const Vec3 away = liftOffset(deposit, last, after, params.safeHeight.value());
      travelTo(last, away, MoveKind::Linear);
    }
  }
  return targets;
}

Runs findRuns(const std::vector<Target>& targets) {
  Runs runs;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const WantedMove& point = targets[i].waypoint;
    if (i == 0 || point.kind == MoveKind::Joint) {
      runs.begins.push_back(i);
    }
    const bool newBead = i == 0 || point.layer != targets[i - 1].waypoint.layer ||
                         point.bead != targets[i - 1].waypoint.bead;
    if (newBead) {
      runs.segments.push_back({i, i, i, i, runs.begins.size() - 1});
    }
    Segment& segment = runs.segments.back();
    if (point.point == 0) {
      segment.first = i;
    }
    if (point.point >= 0) {
      segment.last = i;
    }
    segment.end = i + 1;
  }
  runs.begins.push_back(targets.size());
  return runs;
}

}  // namespace wcam::motion::detail
