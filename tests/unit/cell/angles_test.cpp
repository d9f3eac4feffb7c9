// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/angles.hpp"

#include "cells.hpp"
#include <gtest/gtest.h>

#include <cmath>

namespace wcam::cell {
namespace {

using test::randomUnit;
using test::uniform;

constexpr std::uint64_t kSeed = 20200709;

Rotation randomRotation(std::mt19937_64& random) {
  return Eigen::AngleAxisd(uniform(random, -kPi, kPi), randomUnit(random)).toRotationMatrix();
}

double roundTripError(const Rotation& m) {
  return std::max({(fromBryant(toBryant(m)) - m).cwiseAbs().maxCoeff(),
                   (fromFanucWpr(toFanucWpr(m)) - m).cwiseAbs().maxCoeff(),
                   (fromKukaAbc(toKukaAbc(m)) - m).cwiseAbs().maxCoeff()});
}

TEST(Angles, roundTripOfRandomMatrices) {
  RecordProperty("seed", static_cast<int>(kSeed));
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 10000; ++i) {
    ASSERT_LE(roundTripError(randomRotation(random)), 1e-12) << "matrix " << i << " seed " << kSeed;
  }
}

TEST(Angles, roundTripAtAndNearGimbalLock) {
  for (const double middle : {kPi / 2, -kPi / 2}) {
    for (const double off : {0.0, 1e-15, 1e-13, 1e-12, 1e-9, 1e-7, 1e-5}) {
      for (const double first : {-2.0, 0.0, 0.7, kPi}) {
        for (const double third : {-1.0, 0.0, 2.5}) {
          const Angles angles(first, middle - off, third);
          EXPECT_LE(roundTripError(fromBryant(angles)), 1e-12) << angles.transpose();
          EXPECT_LE(roundTripError(fromKukaAbc(angles)), 1e-12) << angles.transpose();
        }
      }
    }
  }
}

TEST(Angles, anglesAreRecoveredAwayFromGimbalLock) {
  const Angles angles(0.3, -1.2, 2.9);
  EXPECT_LE((toBryant(fromBryant(angles)) - angles).norm(), 1e-14);
  EXPECT_LE((toFanucWpr(fromFanucWpr(angles)) - angles).norm(), 1e-14);
  EXPECT_LE((toKukaAbc(fromKukaAbc(angles)) - angles).norm(), 1e-14);
}

TEST(Angles, bryantMatrixIsTheClosedForm) {
  const Angles a(0.4, -0.7, 1.9);
  const double cx = std::cos(a.x()), sx = std::sin(a.x());
  const double cy = std::cos(a.y()), sy = std::sin(a.y());
  const double cz = std::cos(a.z()), sz = std::sin(a.z());
  Rotation m;
  m << cy * cz, -cy * sz, sy, cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy,
      sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy;
  EXPECT_LE((fromBryant(a) - m).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Angles, kukaIsFanucReversed) {
  const Angles abc(0.1, 0.2, 0.3);
  EXPECT_EQ(fromKukaAbc(abc), fromFanucWpr(Angles(0.3, 0.2, 0.1)));
}

TEST(Angles, fanucOrderOfThePositionerAndTheTool) {
  const Rotation positioner = fromFanucWpr(Angles(0.412, -0.131, 45.059) * (kPi / 180.0));
  EXPECT_NEAR(positioner(0, 2), 0.00347, 5e-6);
  EXPECT_NEAR(positioner(1, 2), -0.00670, 5e-6);
  EXPECT_NEAR(positioner(2, 2), 0.99997, 5e-6);
  const Rotation tool = fromFanucWpr(Angles(-180, -36, 0) * (kPi / 180.0));
  EXPECT_NEAR(tool(0, 2), 0.5878, 5e-5);
  EXPECT_NEAR(tool(1, 2), 0.0, 1e-12);
  EXPECT_NEAR(tool(2, 2), -0.8090, 5e-5);
}

TEST(Angles, toolAxisBecomesThirdRowOrThirdColumn) {
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 axis = randomUnit(random);
    const double rz = uniform(random, -kPi, kPi);
    const Rotation carried = axisToVertical(axis, rz);
    ASSERT_LE((carried.row(2).transpose() - axis).norm(), 1e-12) << i << " seed " << kSeed;
    ASSERT_LE((carried * axis - Vec3::UnitZ()).norm(), 1e-12);
    const Rotation torch = frameWithZ(axis, rz);
    ASSERT_LE((torch.col(2) - axis).norm(), 1e-12) << i << " seed " << kSeed;
    ASSERT_NEAR(torch.determinant(), 1.0, 1e-12);
  }
}

TEST(Angles, toolAxisInSingularDirections) {
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                           Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
    for (const double rz : {0.0, 0.5, kPi / 2}) {
      EXPECT_LE((axisToVertical(axis, rz) * axis - Vec3::UnitZ()).norm(), 1e-12);
      EXPECT_LE((frameWithZ(axis, rz).col(2) - axis).norm(), 1e-12);
    }
  }
}

TEST(Angles, wrapsIntoHalfOpenTurn) {
  EXPECT_DOUBLE_EQ(wrapAngle(3 * kPi), kPi);
  EXPECT_DOUBLE_EQ(wrapAngle(-kPi), kPi);
  EXPECT_NEAR(wrapAngle(2 * kPi + 0.25), 0.25, 1e-15);
  EXPECT_NEAR(wrapAngle(-7.0), -7.0 + 2 * kPi, 1e-15);
}

}  // namespace
}  // namespace wcam::cell
