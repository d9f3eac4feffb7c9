// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "edit_steps.hpp"
#include "path_split.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath::detail {

namespace {

/// The part of a move that lies inside, as fractions of it; empty when begin >= end. All regions
/// are convex, so that there is one part at most.
struct Piece {
  double begin = 0.0;
  double end = 1.0;

  /// Keeps where a + f·slope >= 0.
  void clip(double a, double slope) {
    if (slope == 0.0) {
      end = a >= 0.0 ? end : begin;
    } else if (slope > 0.0) {
      begin = std::max(begin, -a / slope);
    } else {
      end = std::min(end, -a / slope);
    }
  }
};

Vec3 vectorOf(const std::array<double, 3>& numbers) {
  return Vec3(numbers.data());
}

Piece insideBox(const Vec3& a, const Vec3& step, const EditParams& params) {
  Piece piece;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    piece.clip(a(k) - params.boxMin[i], step(k));
    piece.clip(params.boxMax[i] - a(k), -step(k));
  }
  return piece;
}

Piece insideSphere(const Vec3& a, const Vec3& step, const EditParams& params) {
  // |a + f·step − c|² = r², with f measured from the point nearest to the centre.
  const Vec3 from = a - vectorOf(params.centre);
  const double length2 = step.squaredNorm();
  const double radius = params.radius.value();
  if (!(length2 > 0.0)) {
    return from.norm() <= radius ? Piece{} : Piece{0.0, 0.0};
  }
  const double nearest = -from.dot(step) / length2;
  const double rest = radius * radius - (from + nearest * step).squaredNorm();
  if (rest <= 0.0) {
    return {0.0, 0.0};
  }
  const double half = std::sqrt(rest / length2);
  return {std::max(0.0, nearest - half), std::min(1.0, nearest + half)};
}

/// @param before length from the start of the body to a
Piece insideOf(
    const Vec3& a, const Vec3& b, double before, double length, const EditParams& params) {
  switch (params.region) {
    case EditRegion::Everywhere:
      return {};
    case EditRegion::Box:
      return insideBox(a, b - a, params);
    case EditRegion::Sphere:
      return insideSphere(a, b - a, params);
    case EditRegion::HalfSpace: {
      const Vec3 normal = vectorOf(params.planeNormal).normalized();
      Piece piece;
      piece.clip((a - vectorOf(params.planePoint)).dot(normal), (b - a).dot(normal));
      return piece;
    }
    case EditRegion::Length: {
      Piece piece;
      piece.clip(before - params.from.value(), length);
      if (params.to.value() > 0.0) {
        piece.clip(params.to.value() - before, -length);
      }
      return piece;
    }
  }
  return {};
}

/// Calls visit(i, piece) for every move; the piece is snapped to the ends of the move where it
/// comes nearer to them than a new point may, and empty when it is shorter than that.
template <class Visit>
void forMoves(const std::vector<PathPoint>& points, const EditParams& params, const Visit& visit) {
  const std::size_t first = points.empty() ? 0 : bodyOf(points).first;
  double before = 0.0;
  for (std::size_t i = 1; i <= first; ++i) {
    before -= (points[i].p - points[i - 1].p).norm();
  }
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length = (points[i].p - points[i - 1].p).norm();
    Piece piece = insideOf(points[i - 1].p, points[i].p, before, length, params);
    piece.begin = piece.begin * length > kSamePlace ? piece.begin : 0.0;
    piece.end = (1.0 - piece.end) * length > kSamePlace ? piece.end : 1.0;
    const bool empty = !((piece.end - piece.begin) * length > kSamePlace) &&
                       !(length <= kSamePlace && piece.begin < piece.end);
    visit(i, empty ? Piece{0.0, 0.0} : piece);
    before += length;
  }
}

}  // namespace

std::pair<std::size_t, std::size_t> bodyOf(const std::vector<PathPoint>& points) {
  std::size_t first = 0;
  while (first + 1 < points.size() && points[first + 1].zone == BeadZone::LeadIn) {
    ++first;
  }
  std::size_t last = first;
  while (last + 1 < points.size() && points[last + 1].zone == BeadZone::Body) {
    ++last;
  }
  return {first, last};
}

SplitBead splitAtRegion(const std::vector<PathPoint>& points, const EditParams& params) {
  SplitBead split;
  if (points.empty()) {
    return split;
  }
  const auto put = [&split](PathPoint point, bool inside) {
    split.points.push_back(std::move(point));
    split.inside.push_back(inside);
  };
  put(points.front(), false);
  forMoves(points, params, [&](std::size_t i, const Piece& piece) {
    if (!(piece.begin < piece.end)) {
      put(points[i], false);
      return;
    }
    if (piece.begin > 0.0) {
      put(pointBetween(points[i - 1], points[i], piece.begin), false);
    }
    if (piece.end < 1.0) {
      put(pointBetween(points[i - 1], points[i], piece.end), true);
    }
    put(points[i], piece.end == 1.0);
  });
  return split;
}

}  // namespace wcam::toolpath::detail
