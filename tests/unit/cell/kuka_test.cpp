// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// KUKA KR360 with platter (Carrière) and KUKA KR16 (Diourté).

#include "wcam/base/error.hpp"
#include "wcam/cell/inverse.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/unwrap.hpp"

#include "cells.hpp"
#include <gtest/gtest.h>

#include <cmath>

namespace wcam::cell {
namespace {

using test::degrees;

/// 0T7 for axes in KUKA's convention, and in that of the thesis' scripts.
Pose kr360(const Cell& cell, std::initializer_list<double> axes) {
  JointVector q = JointVector::Zero(7);
  q.head(6) = degrees(axes);
  return T_base_tcp(cell, q);
}

Pose kr360Script(const Cell& cell, std::initializer_list<double> axes) {
  JointVector q = JointVector::Zero(7);
  q.head(6) = cell.fromConvention("script", degrees(axes));
  return T_base_tcp(cell, q);
}

void expectPose(const Pose& pose, const Vec3& position, const double (&rows)[9], double mm) {
  EXPECT_LE((pose.translation() - position).cwiseAbs().maxCoeff(), mm);
  for (int i = 0; i < 9; ++i) {
    EXPECT_NEAR(pose.linear()(i / 3, i % 3), rows[i], 1e-5) << i;
  }
}

TEST(Kr360, referencePosesInBothConventions) {
  const Cell cell = test::shippedCell("kuka_kr360_platter");
  const Pose zero = kr360Script(cell, {0, 0, 0, 0, 0, 0});
  EXPECT_LE((zero.translation() - Vec3(1950, 0, 2080)).norm(), 1e-9);
  EXPECT_LE((zero.linear() - Eigen::Matrix3d::Identity()).norm(), 1e-9);
  EXPECT_LE(test::poseDifference(kr360(cell, {0, -90, 90, 0, 0, 0}), zero), 1e-9);
  expectPose(
      kr360Script(cell, {20, 40, -60, -20, 40, -30}), {2557.147071, -675.587092, 2080.612238},
      {0.945755, 0.306455, 0.107854, -0.110271, 0.615076, -0.780718, -0.305593, 0.726475, 0.615505},
      1e-4);
  expectPose(kr360(cell, {-79.1152, -60.0742, 77.4188, -16.6401, 24.8034, 13.0352}),
             {374.41924, 2258.78496, 1378.32734},
             {0.02303, -0.98661, 0.16148, 0.75590, 0.12289, 0.64305, -0.65428, 0.10725, 0.74861},
             1e-4);
  expectPose(kr360(cell, {-41.3513, -80.2946, 103.9549, -14.0157, 68.6765, -29.5871}),
             {949.33828, 1118.68850, 1483.07757},
             {-0.17131, -0.09652, 0.98048, 0.14977, 0.98107, 0.12275, -0.97377, 0.16788, -0.15361},
             1e-4);
  expectPose(
      kr360(cell, {11.6963, -35.9688, 67.5326, -58.8049, 80.1073, -85.2272}),
      {2468.40605, -31.96489, 1162.37038},
      {0.05264, 0.88009, -0.47187, 0.84966, -0.28775, -0.44190, -0.52469, -0.37767, -0.76293},
      1e-4);
}

TEST(Kr360, unknownConventionIsNamed) {
  const Cell cell = test::shippedCell("kuka_kr360_platter");
  try {
    (void)cell.fromConvention("fanuc", JointVector::Zero(6));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(error.hint().find("kuka, script"), std::string::npos) << error.hint();
  }
}

TEST(Kr360, theFirstAxisTurnsAgainstZ) {
  const Cell cell = test::shippedCell("kuka_kr360_platter");
  JointVector q = JointVector::Zero(7);
  q.head(6) = degrees({0, -60, 80, 10, 40, 30});
  const Vec3 start = T_base_tcp(cell, q).translation();
  for (const double phi : {0.3, -1.2, 2.5}) {
    q(0) = phi;
    const Vec3 turned = Eigen::AngleAxisd(-phi, Vec3::UnitZ()) * start;
    EXPECT_LE((T_base_tcp(cell, q).translation() - turned).norm(), 1e-9);
  }
}

TEST(Kr360, everyJointTransformIsARigidMotion) {
  std::mt19937_64 random(8);
  for (int i = 0; i < 1000; ++i) {
    const Pose pose = dhTransform(test::uniform(random, -4, 4), test::uniform(random, -2e3, 2e3),
                                  test::uniform(random, -4, 4), test::uniform(random, -2e3, 2e3));
    EXPECT_LE((pose.linear().transpose() * pose.linear() - Eigen::Matrix3d::Identity()).norm(),
              1e-12);
    EXPECT_NEAR(pose.linear().determinant(), 1.0, 1e-12);
    EXPECT_EQ(pose.matrix().row(3), Eigen::RowVector4d(0, 0, 0, 1));
  }
}

TEST(Kr360, closedFormWithinLimitsOfTheMeasuredPostures) {
  const Cell cell = test::shippedCell("kuka_kr360_platter");
  ASSERT_TRUE(cell.arm.has_value()) << cell.armProblem;
  const std::initializer_list<double> rows[] = {
      {-79.1152, -60.0742, 77.4188, -16.6401, 24.8034, 13.0352},
      {16.487, -30.1371, 67.9595, -20.7368, 97.0453, -168.0554},
      {61.0145, -12.0131, 50.5937, -176.8568, -55.418, 89.6466},
      {64.1478, -90.562, 119.2971, 39.1088, 70.4469, 100.2753},
      {-17.3058, 6.7419, -45.6892, 7.9836, -45.0453, -60.0594}};
  for (const auto& row : rows) {
    const JointVector q = degrees(row);
    for (int j = 0; j < 6; ++j) {
      EXPECT_EQ(limitExcess(cell.joint(j), q(j)), 0.0) << j;
    }
    const Pose flange = chainPose(cell.robot, q.data());
    EXPECT_GT(flange.translation().x(), 200.0);  // in front of the robot, as the thesis demands
    const InverseSolution s =
        cell.inverse->solve(flange, cell.inverse->branchOf(q.data()), q.data());
    ASSERT_TRUE(s.reachable);
    for (int j = 0; j < 6; ++j) {
      EXPECT_NEAR(std::remainder(s.joints(j) - q(j), 2 * kPi), 0.0, 1e-11);
    }
  }
}

/// The published table in standard Denavit–Hartenberg form (a, alpha, d, theta, sense).
Pose kr16Published(const JointVector& q) {
  const double rows[6][5] = {{260, -90, 675, 0, -1}, {680, 0, 0, 0, 1}, {-35, 90, 0, -90, 1},
                             {0, -90, -670, 0, 1},   {0, 90, 0, 0, 1},  {0, 180, -158, 180, 1}};
  Pose pose = Pose::Identity();
  for (int j = 0; j < 6; ++j) {
    const double* row = rows[j];
    pose = pose * Eigen::AngleAxisd(degToRad(row[3]) + row[4] * q(j), Vec3::UnitZ()) *
           Eigen::Translation3d(row[0], 0, row[2]) *
           Eigen::AngleAxisd(degToRad(row[1]), Vec3::UnitX());
  }
  return pose;
}

TEST(Kr16, isThePublishedTable) {
  std::mt19937_64 random(9);
  for (const char* name : {"kuka_kr16", "kuka_kr16_positioner", "kuka_kr16_part_carried"}) {
    const Cell cell = test::shippedCell(name);
    ASSERT_TRUE(cell.arm.has_value()) << cell.armProblem;
    EXPECT_NEAR(260 + armReach(*cell.arm), 1611, 0.5);
    for (int i = 0; i < 100; ++i) {
      const JointVector q = test::randomJoints(random, cell.jointCount());
      EXPECT_LE(test::poseDifference(T_base_flange(cell, q), kr16Published(q)), 1e-9);
    }
    JointVector home = JointVector::Zero(cell.jointCount());
    home.head(6) = degrees({0, -90, 90, 0, 0, 0});
    EXPECT_LE((T_base_flange(cell, home).translation() - Vec3(1088, 0, 1320)).norm(), 1e-9);
  }
}

TEST(Kr16, theTableIsInReach) {
  for (const char* name : {"kuka_kr16", "kuka_kr16_positioner", "kuka_kr360_platter"}) {
    const Cell cell = test::shippedCell(name);
    JointVector q = JointVector::Zero(cell.jointCount());
    const Pose table = T_base_table(cell, q);
    const InverseSolution s =
        solveTool(cell, table * Vec3(0, 0, 20), table.linear().col(2), 0.0, 0);
    EXPECT_TRUE(s.reachable) << name;
    bool inside = false;
    for (int branch = 0; branch < 8; ++branch) {
      for (const double rotation : {0.0, 1.57, 3.14, -1.57}) {
        const InverseSolution any =
            solveTool(cell, table * Vec3(0, 0, 20), table.linear().col(2), rotation, branch);
        bool fits = any.reachable;
        for (int j = 0; j < 6; ++j) {
          const double nearest = turnInLimits(cell.joint(j), any.joints(j), 0.0);
          fits = fits && limitExcess(cell.joint(j), nearest) == 0.0;
        }
        inside = inside || fits;
      }
    }
    EXPECT_TRUE(inside) << name;
  }
}

}  // namespace
}  // namespace wcam::cell
