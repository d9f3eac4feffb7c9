// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace wcam::collision::detail {

namespace {

/// Directions over the sphere from which the best one is refined.
constexpr int kDirections = 128;
/// The step of the refinement begins with about the angle between these and halves to its end, rad.
constexpr double kFirstStep = 0.15;
constexpr double kLastStep = 1e-7;
constexpr double kShrink = 0.6;
constexpr int kAround = 8;   ///< directions of a step
constexpr int kRounds = 12;  ///< steps of one size at most
constexpr std::size_t kStarts = 6;
/// Angle between neighbours of a spread that repeats nothing, rad.
const double kGolden = kPi * (3.0 - std::sqrt(5.0));

/// How far the solid reaches from its centre in a direction of its own frame, a unit vector. All
/// solids are the same both ways.
double reachOf(const Primitive& solid, const Vec3& d) {
  switch (solid.kind) {
    case ShapeKind::Sphere:
      return solid.radius;
    case ShapeKind::Capsule:
      return solid.radius + solid.half * std::abs(d.z());
    case ShapeKind::Cylinder:
      return solid.radius * std::sqrt(d.x() * d.x() + d.y() * d.y()) + solid.half * std::abs(d.z());
    case ShapeKind::Box:
      return solid.halves.dot(d.cwiseAbs());
    case ShapeKind::Mesh:
      break;
  }
  WCAM_ASSERT(false);
}

class Search {
public:
  Search(const Primitive& a, const Pose& T_a, const Primitive& b, const Pose& T_b)
      : a_(a),
        b_(b),
        turnA_(T_a.linear().transpose()),
        turnB_(T_b.linear().transpose()),
        apart_(T_a.translation() - T_b.translation()) {}

  /// Compares a direction; the best ones are where the refinement begins.
  void look(Vec3 d) {
    const double length = d.norm();
    if (!(length > 1e-9)) {
      return;  // parallel edges have no direction across
    }
    d /= length;
    d = d.dot(apart_) < 0.0 ? Vec3(-d) : d;
    const Overlap own{widthAlong(d), d, Vec3::Zero()};
    const auto place =
        std::upper_bound(starts_.begin(), starts_.end(), own,
                         [](const Overlap& x, const Overlap& y) { return x.depth < y.depth; });
    if (place != starts_.end() || starts_.size() < kStarts) {
      starts_.insert(place, own);
      starts_.resize(std::min(starts_.size(), kStarts));
    }
  }

  [[nodiscard]] const Overlap& first() const { return starts_.front(); }

  [[nodiscard]] double least() const { return starts_.front().depth; }

  void refine() {
    best_ = starts_.front();
    for (const Overlap& start : starts_) {
      const Overlap own = refined(start);
      best_ = own.depth < best_.depth ? own : best_;
    }
  }

  [[nodiscard]] const Overlap& best() const { return best_; }

private:
  /// Downhill in ever smaller steps, the directions turned on with each, so that none of the folds
  /// of the widths holds it up.
  [[nodiscard]] Overlap refined(Overlap best) const {
    double turn = 0.0;
    for (double step = kFirstStep; step > kLastStep; step *= kShrink) {
      for (int round = 0; round < kRounds; ++round) {
        const Vec3 u = best.way.unitOrthogonal();
        const Vec3 v = best.way.cross(u);
        const Vec3 centre = best.way;
        const double before = best.depth;
        turn += kGolden;
        for (int k = 0; k < kAround; ++k) {
          const double angle = turn + 2.0 * kPi * k / kAround;
          const Vec3 d = (centre + step * (std::cos(angle) * u + std::sin(angle) * v)).normalized();
          const double depth = widthAlong(d);
          if (depth < best.depth) {
            best.depth = depth;
            best.way = d;
          }
        }
        if (!(best.depth < before)) {
          break;
        }
      }
    }
    return best;
  }

  [[nodiscard]] double widthAlong(const Vec3& d) const {
    return reachOf(a_, turnA_ * d) + reachOf(b_, turnB_ * d) - d.dot(apart_);
  }

  const Primitive& a_;
  const Primitive& b_;
  Eigen::Matrix3d turnA_;
  Eigen::Matrix3d turnB_;
  Vec3 apart_;
  std::vector<Overlap> starts_;
  Overlap best_{std::numeric_limits<double>::infinity(), Vec3::UnitZ(), Vec3::Zero()};
};

}  // namespace

Overlap leastTranslation(
    const Primitive& a, const Pose& T_a, const Primitive& b, const Pose& T_b, double enough) {
  Search search(a, T_a, b, T_b);
  const Eigen::Matrix3d axesA = T_a.linear();
  const Eigen::Matrix3d axesB = T_b.linear();
  const Vec3 apart = T_a.translation() - T_b.translation();
  search.look(apart);
  for (int i = 0; i < 3; ++i) {
    search.look(axesA.col(i));
    search.look(axesB.col(i));
    for (int k = 0; k < 3; ++k) {
      search.look(axesA.col(i).cross(axesB.col(k)));
    }
  }
  // Round solids leave square to their axes.
  search.look(apart - axesA.col(2) * axesA.col(2).dot(apart));
  search.look(apart - axesB.col(2) * axesB.col(2).dot(apart));
  if (search.least() <= enough) {
    return search.first();
  }
  for (int k = 0; k < kDirections; ++k) {
    const double z = 1.0 - (2.0 * k + 1.0) / kDirections;
    const double r = std::sqrt(1.0 - z * z);
    search.look(Vec3(r * std::cos(kGolden * k), r * std::sin(kGolden * k), z));
  }
  search.refine();
  Overlap found = search.best();
  // From the face of the second that the first has passed, half the depth inwards.
  const Vec3 inB = T_b.linear().transpose() * found.way;
  const Vec3 inA = T_a.linear().transpose() * found.way;
  const double top = found.way.dot(T_b.translation()) + reachOf(b, inB);
  const double bottom = found.way.dot(T_a.translation()) - reachOf(a, inA);
  const Vec3 centre = outerRadius(a) <= outerRadius(b) ? T_a.translation() : T_b.translation();
  found.point = centre + found.way * (0.5 * (top + bottom) - found.way.dot(centre));
  return found;
}

Primitive primitiveOf(const Rod& rod) {
  Primitive solid;
  solid.kind = ShapeKind::Capsule;
  solid.radius = rod.radius;
  solid.half = 0.5 * (rod.b - rod.a).norm();
  return solid;
}

}  // namespace wcam::collision::detail
