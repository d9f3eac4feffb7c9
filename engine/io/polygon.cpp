// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygon.hpp"

namespace wcam::io {

using geometry::Vec2;
using geometry::Vec3;

namespace {

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Corners in the polygon's mean plane (Newell's normal), counter-clockwise.
std::vector<Vec2> project(const std::vector<Vec3>& vertices,
                          const std::vector<std::uint32_t>& corners) {
  Vec3 normal = Vec3::Zero();
  const Vec3& origin = vertices[corners[0]];
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = vertices[corners[i]] - origin;
    const Vec3 b = vertices[corners[(i + 1) % corners.size()]] - origin;
    normal += a.cross(b);
  }
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const double sign = normal[axis] < 0.0 ? -1.0 : 1.0;
  std::vector<Vec2> points;
  points.reserve(corners.size());
  for (const std::uint32_t c : corners) {
    points.emplace_back(sign * (vertices[c][u] - origin[u]), vertices[c][v] - origin[v]);
  }
  return points;
}

/// True when the corner at `i` is convex and no other corner lies in its triangle.
bool isEar(const std::vector<Vec2>& p, const std::vector<std::size_t>& left, std::size_t i) {
  const std::size_t n = left.size();
  const Vec2& a = p[left[(i + n - 1) % n]];
  const Vec2& b = p[left[i]];
  const Vec2& c = p[left[(i + 1) % n]];
  if (turn(a, b, c) <= 0.0) {
    return false;
  }
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2& q = p[left[k]];
    const bool corner = q == a || q == b || q == c;
    if (!corner && turn(a, b, q) >= 0.0 && turn(b, c, q) >= 0.0 && turn(c, a, q) >= 0.0) {
      return false;
    }
  }
  return true;
}

}  // namespace

void dividePolygon(const std::vector<Vec3>& vertices,
                   const std::vector<std::uint32_t>& corners,
                   std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  const std::vector<Vec2> points = project(vertices, corners);
  std::vector<std::size_t> left(corners.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    left[i] = i;
  }
  std::size_t at = 1;
  std::size_t tried = 0;
  while (left.size() > 3) {
    const std::size_t n = left.size();
    at %= n;
    // After a full round without an ear the polygon crosses itself: cut anyway, so that it ends.
    if (tried < n && !isEar(points, left, at)) {
      ++at;
      ++tried;
      continue;
    }
    triangles.push_back(
        {corners[left[(at + n - 1) % n]], corners[left[at]], corners[left[(at + 1) % n]]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    tried = 0;
  }
  triangles.push_back({corners[left[0]], corners[left[1]], corners[left[2]]});
}

}  // namespace wcam::io
