// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "parallels.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/geometry/level_set.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {

namespace {

constexpr double kTurn = 2.0 * kPi;
constexpr int kBisections = 60;
/// Angles nearer than this are one crossing, rad.
constexpr double kSameAngle = 1e-9;
/// A parallel's height over the substrate is looked at in so many places.
constexpr int kPlaces = 256;
/// The substrate's surface up to this, mm.
constexpr double kOnSubstrate = 1e-6;
/// Facets of a coarse mesh lie inside their circle by this part of its radius at most.
constexpr double kFacet = 0.1;

double normalised(double angle) {
  const double a = angle - kTurn * std::floor(angle / kTurn);
  return a < kTurn ? a : 0.0;
}

/// Place in the meridian plane relative to a parallel: along the profile and across it.
struct MeridianOffset {
  double along;
  double across;
};

MeridianOffset offsetOf(const Axis& axis, const Parallel& parallel, const Vec3& p) {
  const Vec3 d = p - parallel.centre;
  const double z = d.dot(axis.direction);
  const double r = (d - z * axis.direction).norm() - parallel.radius;
  return {z * parallel.alongAxis + r * parallel.alongSpoke,
          r * parallel.alongAxis - z * parallel.alongSpoke};
}

double angleOf(const Parallel& parallel, const Vec3& p) {
  const Vec3 d = p - parallel.centre;
  return normalised(std::atan2(d.dot(parallel.e2), d.dot(parallel.e1)));
}

}  // namespace

ParallelCutter::ParallelCutter(const geometry::PartSurface& part,
                               const Axis& axis,
                               const Substrate& substrate,
                               double roundness)
    : part_(part),
      axis_(axis),
      substrate_(substrate),
      roundness_(roundness),
      tolerance_(geometry::flatTolerance(part.mesh)) {
  for (std::uint32_t h = 0; h < 3 * part.mesh.triangles.size(); ++h) {
    if (part.halfEdges.twin(h) == geometry::HalfEdges::kNone) {
      borders_.push_back(h);
    }
  }
  constexpr double kParallel = 1e-9;
  level_ = substrate.isPlate() && axis.direction.cross(substrate.up()).norm() < kParallel;
  if (part.exact()) {
    evaluator_.emplace(*part.brep);
  }
  if (!borders_.empty() || !level_) {
    tree_.emplace(part.mesh);
  }
}

Vec3 ParallelCutter::onBorder(std::uint32_t halfEdge, double w) const {
  if (evaluator_ && part_.binding.edge[halfEdge] >= 0) {
    const auto& t = part_.binding.edgeParam[halfEdge];
    return evaluator_->curve(part_.binding.edge[halfEdge], t[0] + w * (t[1] - t[0])).p;
  }
  const auto& c = part_.mesh.triangles[halfEdge / 3];
  const Vec3& a = part_.mesh.vertices[c[halfEdge % 3]];
  const Vec3& b = part_.mesh.vertices[c[(halfEdge % 3 + 1) % 3]];
  return a + w * (b - a);
}

void ParallelCutter::addBorderCrossings(const Parallel& parallel,
                                        double tolerance,
                                        std::vector<double>& angles) const {
  const auto along = [&](std::uint32_t h, double w) {
    return offsetOf(axis_, parallel, onBorder(h, w)).along;
  };
  for (const std::uint32_t h : borders_) {
    const double start = along(h, 0.0);
    const double end = along(h, 1.0);
    // Borders that are parallels themselves are not crossed by a parallel on them; what leads away
    // from them is crossed at its end.
    const bool crossed =
        (start < -tolerance) != (end < -tolerance) || (start < tolerance) != (end < tolerance);
    if (!crossed) {
      continue;
    }
    double at = std::abs(start) < std::abs(end) ? 0.0 : 1.0;
    if ((start < 0.0) != (end < 0.0)) {
      double low = 0.0;
      double high = 1.0;
      for (int i = 0; i < kBisections; ++i) {
        const double middle = 0.5 * (low + high);
        ((along(h, middle) < 0.0) == (start < 0.0) ? low : high) = middle;
      }
      at = high;
    }
    const Vec3 p = onBorder(h, at);
    if (std::abs(offsetOf(axis_, parallel, p).across) <= roundness_) {
      angles.push_back(angleOf(parallel, p));
    }
  }
}

void ParallelCutter::addSubstrateCrossings(const Parallel& parallel,
                                           std::vector<double>& angles) const {
  const auto below = [&](double angle) {
    return substrate_.heightAbove(parallel.at(angle)) < -kOnSubstrate;
  };
  bool last = below(0.0);
  for (int i = 1; i <= kPlaces; ++i) {
    const bool next = below(kTurn * i / kPlaces);
    if (next != last) {
      double low = kTurn * (i - 1) / kPlaces;
      double high = kTurn * i / kPlaces;
      for (int k = 0; k < kBisections; ++k) {
        const double middle = 0.5 * (low + high);
        (below(middle) == last ? low : high) = middle;
      }
      angles.push_back(normalised(last ? high : low));
    }
    last = next;
  }
}

bool ParallelCutter::onPart(const Parallel& parallel, double from, double to) const {
  const Vec3 p = parallel.at(0.5 * (from + to));
  if (!level_ && substrate_.heightAbove(p) < -kOnSubstrate) {
    return false;
  }
  const auto hit = tree_->closestPoint(p);
  if (!hit || hit->distance > roundness_ + kFacet * parallel.radius) {
    return false;
  }
  // Facets lie across the profile; what is nearest along it is the border of a hole.
  if (std::abs(offsetOf(axis_, parallel, hit->p).along) > roundness_ + tolerance_) {
    return false;
  }
  // Beyond a border the nearest point of the part lies aside, on the border.
  const Vec3 travel = axis_.direction.cross(Vec3(p - parallel.centre)).normalized();
  constexpr double kAside = 0.5;
  return std::abs((hit->p - p).dot(travel)) < kAside * 0.5 * (to - from) * parallel.radius;
}

std::vector<ParallelArc> ParallelCutter::arcs(const Parallel& parallel, bool onEnd) const {
  std::vector<double> angles;
  addBorderCrossings(parallel, onEnd ? roundness_ : tolerance_, angles);
  if (!level_) {
    addSubstrateCrossings(parallel, angles);
  }
  std::sort(angles.begin(), angles.end());
  angles.erase(std::unique(angles.begin(), angles.end(),
                           [](double a, double b) { return b - a < kSameAngle; }),
               angles.end());
  if (angles.size() < 2) {
    return {{0.0, kTurn, true}};
  }
  const std::size_t n = angles.size();
  std::vector<bool> on(n);
  bool all = true;
  for (std::size_t i = 0; i < n; ++i) {
    on[i] = onPart(parallel, angles[i], i + 1 < n ? angles[i + 1] : angles[0] + kTurn);
    all = all && on[i];
  }
  if (all) {
    return {{0.0, kTurn, true}};
  }
  std::size_t first = 0;
  while (on[first]) {
    ++first;
  }
  std::vector<ParallelArc> arcs;
  for (std::size_t k = 1; k < n; ++k) {
    const std::size_t i = (first + k) % n;
    if (!on[i]) {
      continue;
    }
    const double shift = first + k >= n ? kTurn : 0.0;
    const double from = angles[i] + shift;
    const double to = i + 1 < n ? angles[i + 1] + shift : angles[0] + kTurn + shift;
    if (!arcs.empty() && std::abs(arcs.back().to - from) < kSameAngle) {
      arcs.back().to = to;
    } else {
      arcs.push_back({from, to, false});
    }
  }
  return arcs;
}

}  // namespace wcam::toolpath
