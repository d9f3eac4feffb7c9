// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The search of exit rotations against the closed form of Diourté (M34, Eq. 4.8 generalised).

#include "exit_search.hpp"

#include "wcam/base/quantity.hpp"

#include "paths.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace wcam::motion {
namespace {

using geometry::Vec3;

/// Radius of the deposit that stands for a point, mm.
constexpr double kSpeck = 0.01;

/// A nozzle alone: a cylinder about the tool axis that begins `standOff` above the TCP.
cell::Cell nozzleCell(double standOff, double radius) {
  constexpr double kLength = 80.0;
  cell::Cell cell = test::shippedCell("fanuc_arcmate120ic");
  cell.shapes = {};
  cell::Shape nozzle;
  nozzle.name = "nozzle";
  nozzle.kind = cell::ShapeKind::Cylinder;
  nozzle.frame = "tcp";
  nozzle.radius = radius;
  nozzle.length = kLength;
  nozzle.T_frame_shape.translation() = Vec3(0, 0, standOff + 0.5 * kLength);
  cell.shapes.torch.push_back(nozzle);
  return cell;
}

/// Rotation about the travel direction (x) that frees the point (x, y, z) of the tool frame, out
/// through the end of the nozzle or through its side, whichever comes first.
double closedForm(const Vec3& p, double radius, double standOff) {
  const double half = std::sqrt(radius * radius - p.x() * p.x());
  const double r = std::hypot(p.y(), p.z());
  const double psi = std::atan2(std::abs(p.y()), p.z());
  double free = std::acos(std::clamp(standOff / r, -1.0, 1.0));
  if (r >= half) {
    free = std::min(free, std::asin(half / r));
  }
  return std::max(free - psi, 0.0);
}

/// Two beads: a speck at p, and the point that the torch stands on.
toolpath::Toolpath speckAt(const Vec3& p) {
  toolpath::Toolpath path;
  path.layers.emplace_back();
  const auto add = [&path](const Vec3& at, double width) {
    toolpath::Bead bead;
    for (const double x : {-0.5 * width, 0.5 * width}) {
      toolpath::PathPoint point;
      // The path is the top of a bead.
      point.p = at + Vec3(x, 0, kSpeck);
      point.t = Vec3::UnitX();
      point.b = point.axis = point.up = Vec3::UnitZ();
      point.n = point.b.cross(point.t);
      point.width = point.height = 2 * kSpeck;
      point.speed = 5.0;
      bead.points.push_back(point);
    }
    path.layers[0].beads.push_back(bead);
  };
  add(p, 2e-3);
  add(Vec3::Zero(), 2e-3);
  return path;
}

TEST(ExitSearch, isTheClosedFormInWholeDegrees) {
  std::mt19937_64 random(5);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
  };
  int tried = 0;
  for (int run = 0; run < 120; ++run) {
    const double radius = uniform(6, 18);
    const double standOff = run % 3 == 0 ? 0.0 : uniform(1, 15);
    const double x = uniform(-0.8, 0.8) * radius;
    const double y =
        (run % 2 == 0 ? 1 : -1) * uniform(0.1, 0.9) * std::sqrt(radius * radius - x * x);
    const Vec3 p(x, y, standOff + uniform(0.5, 10));
    const toolpath::Toolpath path = speckAt(p);
    collision::CollisionSettings settings;
    settings.safetyDistance = 0.0;
    const collision::CellCollision collision(nozzleCell(standOff, radius), path, nullptr, settings);
    const collision::ToolState tool{geometry::Pose::Identity(), 2};
    float upright = 0.0F;
    collision.evaluateTorch(std::span(&tool, 1), std::span(&upright, 1));
    ASSERT_LT(upright, 0.0F) << run;
    const detail::ExitSearch search(collision, path.layers[0].beads[1].points[0], tool, {});
    const double expected = closedForm(p, radius, standOff);
    if (expected > degToRad(80.0)) {
      continue;
    }
    // A positive turn about the travel leads the nozzle to −y.
    const auto tilt = search.smallest({degToRad(85.0), 0.0}, y > 0.0 ? 1.0 : -1.0);
    ASSERT_TRUE(tilt.has_value()) << run;
    EXPECT_EQ(tilt->lead, 0.0);
    EXPECT_GT(tilt->lateral * y, 0.0);
    EXPECT_GE(std::abs(tilt->lateral), expected - degToRad(0.1)) << run;
    EXPECT_LE(std::abs(tilt->lateral), expected + degToRad(1.3)) << run;
    ++tried;
  }
  EXPECT_GT(tried, 80);
}

}  // namespace
}  // namespace wcam::motion
