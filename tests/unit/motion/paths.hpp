// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/quantity.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/toolpath/toolpath.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace wcam::motion::test {

using geometry::Vec3;

inline cell::Cell shippedCell(const std::string& name) {
  return cell::loadCell(std::string(WCAM_RESOURCES) + "/cells/" + name + ".json");
}

/// Closed circles on the plate, one above the other.
inline toolpath::Toolpath circles(int layers, double radius, int points, const Vec3& centre) {
  toolpath::Toolpath path;
  constexpr double kHeight = 2.0;
  for (int l = 0; l < layers; ++l) {
    toolpath::Layer layer;
    layer.level = kHeight * (l + 1);
    toolpath::Bead bead;
    bead.closed = true;
    for (int i = 0; i <= points; ++i) {
      const double a = 2 * kPi * (i % points) / points;
      toolpath::PathPoint point;
      point.n = Vec3(std::cos(a), std::sin(a), 0);
      point.t = Vec3(-std::sin(a), std::cos(a), 0);
      point.p = centre + radius * point.n + Vec3(0, 0, layer.level);
      point.n = -point.n;
      point.b = point.t.cross(point.n);
      point.b = point.b.z() < 0 ? Vec3(-point.b) : point.b;
      point.axis = Vec3::UnitZ();
      point.up = Vec3::UnitZ();
      point.height = kHeight;
      point.speed = 10.0;
      point.wireSpeed = 80.0;
      bead.points.push_back(point);
    }
    layer.beads.push_back(std::move(bead));
    path.layers.push_back(std::move(layer));
  }
  return path;
}

/// The same with every layer tilted further about x: what a bent tube needs of the positioner.
inline toolpath::Toolpath leaningCircles(int layers, double radius, int points, double stepDeg) {
  toolpath::Toolpath path = circles(layers, radius, points, Vec3::Zero());
  for (int l = 0; l < layers; ++l) {
    const Eigen::Matrix3d r =
        Eigen::AngleAxisd(degToRad(stepDeg * (l + 1)), Vec3::UnitX()).toRotationMatrix();
    for (toolpath::PathPoint& point : path.layers[static_cast<std::size_t>(l)].beads[0].points) {
      point.p = r * point.p;
      point.t = r * point.t;
      point.n = r * point.n;
      point.b = r * point.b;
      point.axis = r * point.axis;
      point.up = r * point.up;
    }
  }
  return path;
}

/// Hollow hemisphere in iso-parametric layers of constant distance (Chalvin A7, Eq. 2.5), the tool
/// axis along the meridian but never inclined by more than 50° (A16c corrected).
inline toolpath::Toolpath hemisphere(double radius, double step, int points, double speed = 6.0) {
  toolpath::Toolpath path;
  const double perLayer = 2.0 * std::asin(step / (2.0 * radius));
  const double steepest = degToRad(50.0);
  for (double u = 0.0; u < kPi / 2; u += perLayer) {
    toolpath::Layer layer;
    layer.level = radius * std::sin(u);
    toolpath::Bead bead;
    bead.closed = true;
    const double lean = std::min(u, steepest);
    for (int i = 0; i <= points; ++i) {
      const double a = 2 * kPi * (i % points) / points;
      const Vec3 out(std::cos(a), std::sin(a), 0);
      toolpath::PathPoint point;
      point.t = Vec3(-std::sin(a), std::cos(a), 0);
      point.p = radius * (std::cos(u) * out + std::sin(u) * Vec3::UnitZ());
      point.n = std::cos(u) * out + std::sin(u) * Vec3::UnitZ();
      point.b = -std::sin(u) * out + std::cos(u) * Vec3::UnitZ();
      point.axis = -std::sin(lean) * out + std::cos(lean) * Vec3::UnitZ();
      point.up = point.b;
      point.height = step;
      point.speed = speed;
      point.wireSpeed = 80.0;
      bead.points.push_back(point);
    }
    layer.beads.push_back(std::move(bead));
    path.layers.push_back(std::move(layer));
  }
  return path;
}

/// A bead on a circle in the plane z = centre.z: so many points evenly over the turn, from an
/// angle on; the last one lies a step before the first.
inline toolpath::Toolpath circleFrom(
    double radius, int points, const Vec3& centre, double startAngle, double speed = 10.0) {
  toolpath::Toolpath path;
  toolpath::Bead bead;
  for (int i = 0; i < points; ++i) {
    const double a = startAngle + 2 * kPi * i / points;
    toolpath::PathPoint point;
    point.n = Vec3(std::cos(a), std::sin(a), 0);
    point.t = Vec3(-std::sin(a), std::cos(a), 0);
    point.p = centre + radius * point.n;
    point.speed = speed;
    bead.points.push_back(point);
  }
  path.layers.emplace_back();
  path.layers[0].beads.push_back(std::move(bead));
  return path;
}

/// Speed of polylines, mm/s.
inline constexpr double kSpeed = 10.0;

/// A bead of straight lines on the plate, with points every `step` mm.
inline toolpath::Toolpath polyline(const std::vector<Vec3>& corners, double step) {
  toolpath::Toolpath path;
  toolpath::Layer layer;
  toolpath::Bead bead;
  const auto add = [&bead](const Vec3& p) {
    toolpath::PathPoint point;
    point.p = p;
    point.axis = Vec3::UnitZ();
    point.up = Vec3::UnitZ();
    point.speed = kSpeed;
    point.wireSpeed = 80.0;
    bead.points.push_back(point);
  };
  add(corners.front());
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const Vec3 way = corners[k] - corners[k - 1];
    const int pieces = std::max(1, static_cast<int>(std::lround(way.norm() / step)));
    for (int i = 1; i <= pieces; ++i) {
      add(corners[k - 1] + way * (static_cast<double>(i) / pieces));
    }
  }
  layer.beads.push_back(bead);
  path.layers.push_back(layer);
  return path;
}

inline std::vector<Vec3> square(double half) {
  return {{half, -half, 2}, {half, half, 2}, {-half, half, 2}, {-half, -half, 2}, {half, -half, 2}};
}

}  // namespace wcam::motion::test
