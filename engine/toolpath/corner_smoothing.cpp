// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "corner_smoothing.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {

using geometry::Vec2;

namespace {

/// Points of a parabola per radian of turning, and at least.
constexpr double kPointsPerRadian = 8.0;
constexpr int kLeastPoints = 4;
/// A corner may take this part of an open contour's ends or of a ring.
constexpr double kLargestShare = 0.2;
/// Turns below this are no corners, rad.
constexpr double kNoCorner = 0.02;

/// A place on a polyline at some length before (−1) or after (+1) a point, and the first point
/// beyond it.
struct Place {
  ContourPoint point;
  std::size_t beyond = 0;  ///< index of the first point that stays
};

std::optional<Place> walk(const Contour& contour, std::size_t from, int way, double length) {
  const auto n = static_cast<std::ptrdiff_t>(contour.points.size());
  auto at = static_cast<std::ptrdiff_t>(from);
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    std::ptrdiff_t next = at + way;
    if (contour.closed) {
      next = (next + n) % n;
    } else if (next < 0 || next >= n) {
      return std::nullopt;
    }
    const ContourPoint& a = contour.points[static_cast<std::size_t>(at)];
    const ContourPoint& b = contour.points[static_cast<std::size_t>(next)];
    const double chord = (b.p - a.p).norm();
    if (chord >= length) {
      Place place{a, static_cast<std::size_t>(next)};
      place.point.p = a.p + (length / chord) * (b.p - a.p);
      return place;
    }
    length -= chord;
    at = next;
  }
  return std::nullopt;
}

double lengthOf(const Contour& contour) {
  double length = 0.0;
  for (std::size_t i = 1; i < contour.points.size(); ++i) {
    length += (contour.points[i].p - contour.points[i - 1].p).norm();
  }
  return length;
}

}  // namespace

CornerSmoothing::CornerSmoothing(const SurfacePatch& patch, double bound)
    : patch_(&patch), tree_(patch.part().mesh), bound_(bound) {}

std::optional<ContourPoint> CornerSmoothing::onSurface(const Vec3& p, double reach) const {
  const auto hit = tree_.closestPoint(p);
  if (!hit) {
    return std::nullopt;
  }
  if (!patch_->exact()) {
    return ContourPoint{hit->p, patch_->part().mesh.normal(hit->triangle)};
  }
  const auto& c = patch_->part().mesh.triangles[hit->triangle];
  const Vec3& a = patch_->part().mesh.vertices[c[0]];
  const Vec3 e1 = patch_->part().mesh.vertices[c[1]] - a;
  const Vec3 e2 = patch_->part().mesh.vertices[c[2]] - a;
  const auto w = solveMetric({a, e1, e2}, Vec2((hit->p - a).dot(e1), (hit->p - a).dot(e2)));
  const Vec2 o = patch_->corner(hit->triangle, 0);
  Vec2 uv = o;
  if (w) {
    uv += (*w)[0] * (patch_->corner(hit->triangle, 1) - o) +
          (*w)[1] * (patch_->corner(hit->triangle, 2) - o);
  }
  uv = patch_->project(hit->triangle, uv, p);
  const geometry::SurfacePoint s = patch_->surface(hit->triangle, uv);
  if ((s.p - p).norm() > reach) {
    return std::nullopt;
  }
  return ContourPoint{s.p, patch_->normal(hit->triangle, uv, s)};
}

bool CornerSmoothing::roundOne(Contour& contour, std::size_t index) const {
  const std::size_t n = contour.points.size();
  if (!contour.closed && (index == 0 || index + 1 == n)) {
    return false;
  }
  const Vec3 corner = contour.points[index].p;
  const Vec3 in = (corner - contour.points[(index + n - 1) % n].p).normalized();
  const Vec3 out = (contour.points[(index + 1) % n].p - corner).normalized();
  const double turn = std::atan2(in.cross(out).norm(), in.dot(out));
  if (turn < kNoCorner) {
    return false;
  }
  // The parabola's middle is L·sin(θ/2)/2 away from the corner.
  const double length =
      std::min(2.0 * bound_ / std::sin(0.5 * turn), kLargestShare * lengthOf(contour));
  const auto before = walk(contour, index, -1, length);
  const auto after = walk(contour, index, 1, length);
  if (!before || !after) {
    return false;
  }
  const int count = std::max(kLeastPoints, static_cast<int>(std::ceil(kPointsPerRadian * turn)));
  std::vector<ContourPoint> rounded;
  for (int i = 0; i <= count; ++i) {
    const double s = static_cast<double>(i) / count;
    const Vec3 p = (1.0 - s) * (1.0 - s) * before->point.p + 2.0 * s * (1.0 - s) * corner +
                   s * s * after->point.p;
    const auto point = onSurface(p, bound_);
    if (!point) {
      return false;
    }
    rounded.push_back(*point);
  }
  if (contour.closed) {
    // From the point beyond the corner round to the one before it.
    for (std::size_t i = after->beyond;; i = (i + 1) % n) {
      rounded.push_back(contour.points[i]);
      if (i == before->beyond) {
        break;
      }
    }
    contour.points = std::move(rounded);
    return true;
  }
  std::vector<ContourPoint> points(
      contour.points.begin(),
      contour.points.begin() + static_cast<std::ptrdiff_t>(before->beyond) + 1);
  points.insert(points.end(), rounded.begin(), rounded.end());
  points.insert(points.end(), contour.points.begin() + static_cast<std::ptrdiff_t>(after->beyond),
                contour.points.end());
  contour.points = std::move(points);
  return true;
}

std::size_t CornerSmoothing::apply(Contour& contour, const std::vector<Vec3>& corners) const {
  std::size_t rounded = 0;
  for (const Vec3& corner : corners) {
    const auto found = std::find_if(contour.points.begin(), contour.points.end(),
                                    [&](const ContourPoint& point) { return point.p == corner; });
    if (found != contour.points.end() &&
        roundOne(contour, static_cast<std::size_t>(found - contour.points.begin()))) {
      ++rounded;
    }
  }
  return rounded;
}

}  // namespace wcam::toolpath
