// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "table_support.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace wcam::motion::detail {

namespace {

using geometry::Pose;
using geometry::Vec2;
using geometry::Vec3;

/// Points whose convex hull stands for a shape, its own frame. Round shapes as polygons around
/// them.
std::vector<Vec3> cornersOf(const cell::Shape& shape) {
  constexpr int kSides = 32;
  std::vector<Vec3> points;
  const double half = 0.5 * shape.length;
  switch (shape.kind) {
    case cell::ShapeKind::Box:
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 sign((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
                        (corner & 4) != 0 ? 0.5 : -0.5);
        points.push_back(shape.size.cwiseProduct(sign));
      }
      break;
    case cell::ShapeKind::Mesh:
      points = shape.mesh->vertices;
      break;
    case cell::ShapeKind::Sphere:
    case cell::ShapeKind::Capsule:
    case cell::ShapeKind::Cylinder: {
      const double around = shape.radius / std::cos(kPi / kSides);
      for (int i = 0; i < kSides; ++i) {
        const double a = 2.0 * kPi * i / kSides;
        for (const double z : {-half, half}) {
          points.emplace_back(around * std::cos(a), around * std::sin(a), z);
        }
      }
      if (shape.kind != cell::ShapeKind::Cylinder) {
        points.emplace_back(0.0, 0.0, half + shape.radius);
        points.emplace_back(0.0, 0.0, -half - shape.radius);
      }
      break;
    }
  }
  return points;
}

std::vector<Vec3> cornersOf(const toolpath::Substrate& substrate) {
  if (!substrate.isPlate()) {
    return substrate.body()->mesh.vertices;
  }
  std::vector<Vec3> points;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      points.push_back(substrate.pose() *
                       Vec3(x * substrate.size().x(), y * substrate.size().y(), 0.0));
    }
  }
  return points;
}

/// How far two sets of points lie apart in the plane, by their convex hulls; 0 where these meet.
/// The greatest gap over directions: exact where an edge or two corners face each other.
double gapBetween(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  constexpr int kDirections = 360;
  double gap = 0.0;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2.0 * kPi * k / kDirections;
    const Vec2 direction(std::cos(angle), std::sin(angle));
    double high = -std::numeric_limits<double>::infinity();
    double low = std::numeric_limits<double>::infinity();
    for (const Vec2& p : a) {
      high = std::max(high, direction.dot(p));
    }
    for (const Vec2& p : b) {
      low = std::min(low, direction.dot(p));
    }
    gap = std::max(gap, low - high);
  }
  return gap;
}

std::vector<Vec2> inPlane(const std::vector<Vec3>& points, const Pose& pose) {
  std::vector<Vec2> result;
  result.reserve(points.size());
  for (const Vec3& p : points) {
    result.push_back((pose * p).head<2>());
  }
  return result;
}

}  // namespace

void checkTable(const cell::Cell& cell,
                const toolpath::Substrate& substrate,
                const JobContext& context) {
  const std::vector<Vec2> footprint = inPlane(cornersOf(substrate), cell.T_table_part);
  double gap = std::numeric_limits<double>::infinity();
  for (const cell::Shape& shape : cell.shapes.positioner) {
    if (shape.frame == "table") {
      gap = std::min(gap, gapBetween(inPlane(cornersOf(shape), shape.T_frame_shape), footprint));
    }
  }
  if (!std::isfinite(gap) || gap <= 0.0) {
    return;
  }
  context.add(
      {Severity::Violation,
       "motion.beside_table",
       text("the substrate lies beside the table that carries it, by %1 mm", {formatFixed(gap, 1)}),
       "move part and substrate onto the table, or describe what carries them in the cell "
       "file (positioner, collision, frame table)",
       {},
       {{"gap_mm", gap}}});
}

}  // namespace wcam::motion::detail
