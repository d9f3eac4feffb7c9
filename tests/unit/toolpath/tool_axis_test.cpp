// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/tool_axis.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <random>

namespace wcam::toolpath {
namespace {

/// Row vector (0 0 1) times Rodrigues' matrix about k = (tan θt, −tan θn, 0), as the thesis prints
/// it.
Vec3 rodriguesForm(double lead, double lateral) {
  const double tn = std::tan(lead);
  const double tt = std::tan(lateral);
  const double angle = std::atan2(std::hypot(tn, tt), 1.0);
  const Vec3 k = Vec3(tt, -tn, 0.0).normalized();
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, k).toRotationMatrix();
  return (Vec3(0, 0, 1).transpose() * rotation).transpose();
}

TEST(ToolAxis, ClosedFormEqualsRodriguesForm) {
  // Chalvin AT-20.
  std::mt19937 random(42);
  std::uniform_real_distribution<double> angle(-1.3, 1.3);
  for (int i = 0; i < 10000; ++i) {
    const double lead = angle(random);
    const double lateral = angle(random);
    const Vec3 T =
        tiltedAxis(Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), Angle(lead), Angle(lateral));
    EXPECT_NEAR((T - rodriguesForm(lead, lateral)).norm(), 0.0, 1e-12) << "seed 42, run " << i;
    EXPECT_NEAR(T.norm(), 1.0, 1e-12);
    const double total = std::atan2(std::hypot(std::tan(lead), std::tan(lateral)), 1.0);
    EXPECT_NEAR(std::atan2(T.cross(Vec3::UnitZ()).norm(), T.z()), total, 1e-12);
  }
}

TEST(ToolAxis, NoTiltGivesTheBuildDirectionItself) {
  const Vec3 b = Vec3(1, 2, 3).normalized();
  const Vec3 t = b.unitOrthogonal();
  EXPECT_EQ(tiltedAxis(t, b.cross(t), b, Angle(0.0), Angle(0.0)), b);
}

TEST(ToolAxis, PositiveLeadLeansForwardAndPositiveLateralTiltOutwards) {
  const Vec3 forward =
      tiltedAxis(Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), Angle(degToRad(45.0)), Angle(0.0));
  EXPECT_NEAR((forward - Vec3(1, 0, 1).normalized()).norm(), 0.0, 1e-12);
  const Vec3 outward =
      tiltedAxis(Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), Angle(0.0), Angle(degToRad(30.0)));
  EXPECT_NEAR((outward - Vec3(0, 0.5, std::sqrt(3.0) / 2)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace wcam::toolpath
