// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "path_split.hpp"

namespace wcam::toolpath {

namespace {

/// Direction between two unit vectors that are not opposite.
Vec3 mixed(const Vec3& a, const Vec3& b, double fraction) {
  const Vec3 sum = (1.0 - fraction) * a + fraction * b;
  return sum.norm() > 0.0 ? Vec3(sum.normalized()) : a;
}

}  // namespace

PathPoint pointBetween(const PathPoint& a, const PathPoint& b, double fraction) {
  PathPoint point = b;
  const auto mix = [fraction](double x, double y) { return (1.0 - fraction) * x + fraction * y; };
  point.p = (1.0 - fraction) * a.p + fraction * b.p;
  point.t = mixed(a.t, b.t, fraction);
  Vec3 n = mixed(a.n, b.n, fraction);
  n -= n.dot(point.t) * point.t;
  point.n = n.norm() > 0.0 ? Vec3(n.normalized()) : point.t.unitOrthogonal();
  point.b = point.t.cross(point.n);
  point.axis = mixed(a.axis, b.axis, fraction);
  point.up = mixed(a.up, b.up, fraction);
  point.distance = mix(a.distance, b.distance);
  point.height = mix(a.height, b.height);
  point.width = mix(a.width, b.width);
  point.fillWidth = a.fillWidth > 0.0 && b.fillWidth > 0.0 ? mix(a.fillWidth, b.fillWidth) : 0.0;
  return point;
}

void splitAt(std::vector<PathPoint>& points, double length) {
  double before = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double piece = (points[i].p - points[i - 1].p).norm();
    if (before + piece > length + kSamePlace) {
      if (length > before + kSamePlace) {
        points.insert(points.begin() + static_cast<std::ptrdiff_t>(i),
                      pointBetween(points[i - 1], points[i], (length - before) / piece));
      }
      return;
    }
    before += piece;
  }
}

double lengthOf(const std::vector<PathPoint>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += (points[i].p - points[i - 1].p).norm();
  }
  return length;
}

}  // namespace wcam::toolpath
