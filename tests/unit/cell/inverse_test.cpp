// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/inverse.hpp"

#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/unwrap.hpp"

#include "cells.hpp"
#include <gtest/gtest.h>

#include <cmath>

namespace wcam::cell {
namespace {

using test::degrees;
using test::poseDifference;
using test::uniform;

/// Random values inside the limits of the robot's joints.
JointVector insideLimits(std::mt19937_64& random, const Cell& cell, double share = 1.0) {
  JointVector q(cell.robotJoints());
  for (int j = 0; j < cell.robotJoints(); ++j) {
    const double low = std::max(cell.joint(j).min, -kPi * (cell.joint(j).prismatic() ? 1e3 : 1.0));
    const double high = std::min(cell.joint(j).max, kPi * (cell.joint(j).prismatic() ? 1e3 : 1.0));
    q(j) = uniform(random, low + 0.5 * (1 - share) * (high - low),
                   high - 0.5 * (1 - share) * (high - low));
  }
  return q;
}

/// The FANUC with its wrist's axes 4 and 5 apart: no closed form.
Cell offsetWrist() {
  Cell cell = test::fanuc();
  cell.robot.joints[4].d = 40.0;
  prepareArm(cell);
  return cell;
}

TEST(Inverse, armIsTheClosedFormItself) {
  const Cell cell = test::fanuc();
  ASSERT_EQ(cell.inverse->method(), InverseMethod::Arm);
  EXPECT_EQ(cell.inverse->branches(), 8);
  EXPECT_TRUE(cell.inverse->freeRotation());
  std::mt19937_64 random(1);
  for (int i = 0; i < 200; ++i) {
    const JointVector q = insideLimits(random, cell);
    const Pose flange = chainPose(cell.robot, q.data());
    const int branch = cell.inverse->branchOf(q.data());
    EXPECT_EQ(cell.inverse->branchName(branch), branchOf(*cell.arm, q.data()).name());
    const InverseSolution solution = cell.inverse->solve(flange, branch, q.data());
    const IkSolution direct = inverseArm(*cell.arm, flange, Branch::fromIndex(branch), q.data());
    ASSERT_TRUE(solution.reachable);
    EXPECT_EQ(solution.joints, JointVector(direct.joints));
    EXPECT_EQ(solution.wristSine, direct.wristSine);
    EXPECT_EQ(solution.axisDistance, direct.axisDistance);
  }
}

TEST(Inverse, armToolPoint) {
  const Cell cell = test::yaskawa();
  const Vec3 point(900, 100, -200);
  const Vec3 axis = Vec3(0.2, -0.1, 1).normalized();
  const InverseSolution solution = solveTool(cell, point, axis, 0.3, 0);
  ASSERT_TRUE(solution.reachable);
  JointVector q = JointVector::Zero(cell.jointCount());
  q.head(6) = solution.joints;
  const Pose tcp = T_base_tcp(cell, q);
  EXPECT_LE((tcp.translation() - point).norm(), 1e-9);
  EXPECT_LE((tcp.linear().col(2) - axis).norm(), 1e-12);
}

TEST(Inverse, cartesianMachinesRoundTrip) {
  std::mt19937_64 random(2);
  for (const char* name : {"debout_5axis", "debout_7axis"}) {
    const Cell cell = test::shippedCell(name);
    ASSERT_EQ(cell.inverse->method(), InverseMethod::Cartesian) << name;
    EXPECT_EQ(cell.inverse->branches(), 2);
    EXPECT_EQ(cell.inverse->freeRotation(), cell.robotJoints() == 6);
    double worstRotary = 0.0;
    double worstLinear = 0.0;
    for (int i = 0; i < 2000; ++i) {
      JointVector q = insideLimits(random, cell);
      for (int j = 3; j < q.size(); ++j) {
        q(j) = std::remainder(q(j), 2 * kPi);
      }
      if (std::abs(std::sin(q(4))) < 1e-3) {
        continue;
      }
      const Pose flange = chainPose(cell.robot, q.data());
      const int branch = cell.inverse->branchOf(q.data());
      EXPECT_EQ(branch, q(4) >= 0 ? 0 : 1);
      const InverseSolution solution = cell.inverse->solve(flange, branch);
      ASSERT_TRUE(solution.reachable);
      for (int j = 0; j < q.size(); ++j) {
        const double step = solution.joints(j) - q(j);
        double& worst = j < 3 ? worstLinear : worstRotary;
        worst = std::max(worst, std::abs(j < 3 ? step : std::remainder(step, 2 * kPi)));
      }
      const InverseSolution other = cell.inverse->solve(flange, 1 - branch);
      ASSERT_TRUE(other.reachable);
      const Pose reached = chainPose(cell.robot, other.joints.data());
      EXPECT_LE((reached.translation() - flange.translation()).norm(), 1e-9);
      EXPECT_LE(test::angleBetween(reached.linear() * cell.T_flange_tcp.linear().col(2),
                                   flange.linear() * cell.T_flange_tcp.linear().col(2)),
                1e-12);
    }
    // Rotations to 1e-12 rad; lengths to 1e-12 of their size of 10 m.
    EXPECT_LE(worstRotary, 1e-12) << name;
    EXPECT_LE(worstLinear, 1e-8) << name;
    std::printf("[   INFO   ] %s: round trip %.2g rad, %.2g mm\n", name, worstRotary, worstLinear);
  }
}

TEST(Inverse, fiveAxesTakeTheRotationThatGoesWithTheAxis) {
  const Cell cell = test::shippedCell("debout_5axis");
  const Vec3 axis = Vec3(0.9, 0.2, -0.3).normalized();  // base x is vertical
  const Vec3 point(300, -2000, 4000);
  for (const double rotation : {0.0, 1.0, -2.0}) {
    const InverseSolution solution = solveTool(cell, point, axis, rotation, 0);
    ASSERT_TRUE(solution.reachable);
    const Pose tcp = T_base_tcp(cell, solution.joints);
    EXPECT_LE((tcp.translation() - point).norm(), 1e-9);
    EXPECT_LE((tcp.linear().col(2) - axis).norm(), 1e-12);
    EXPECT_LE((solution.joints - solveTool(cell, point, axis, 0.0, 0).joints).norm(), 1e-9);
  }
}

TEST(Inverse, aVerticalToolLeavesTheFirstRotaryAxisToTheSeed) {
  const Cell cell = test::shippedCell("debout_5axis");
  JointVector seed(5);
  seed << 0, 0, 0, 0.7, 0;
  const InverseSolution solution =
      solveTool(cell, {300, -2000, 4000}, Vec3::UnitX(), 0.0, 0, seed.data());
  ASSERT_TRUE(solution.reachable);
  EXPECT_TRUE(solution.wristSingular);
  EXPECT_LE(solution.wristSine, 1e-9);
  EXPECT_NEAR(solution.joints(3), 0.7, 1e-12);
  EXPECT_NEAR(solution.joints(4), 0.0, 1e-12);
}

TEST(Inverse, numericSolverFindsRandomPosesWithoutASeed) {
  const Cell cell = offsetWrist();
  ASSERT_FALSE(cell.arm.has_value());
  ASSERT_EQ(cell.inverse->method(), InverseMethod::Numeric);
  std::mt19937_64 random(3);
  for (int i = 0; i < 100; ++i) {
    const JointVector q = insideLimits(random, cell, 0.8);
    const Pose flange = chainPose(cell.robot, q.data());
    const InverseSolution solution = cell.inverse->solve(flange, i % 8);
    ASSERT_TRUE(solution.reachable) << i << " missing " << solution.missing;
    EXPECT_LE(poseDifference(chainPose(cell.robot, solution.joints.data()), flange), 1e-5);
    EXPECT_EQ(cell.inverse->solve(flange, i % 8).joints, solution.joints);
  }
}

TEST(Inverse, numericSolverFollowsItsSeed) {
  const Cell cell = offsetWrist();
  JointVector q = degrees({10, 20, -20, 30, -60, 40});
  const JointVector start = q;
  for (int i = 1; i <= 50; ++i) {
    JointVector wanted = start;
    wanted(0) += 0.01 * i;
    wanted(3) -= 0.02 * i;
    const Pose flange = chainPose(cell.robot, wanted.data());
    const InverseSolution solution = cell.inverse->solve(flange, 0, q.data());
    ASSERT_TRUE(solution.reachable);
    ASSERT_LE((solution.joints - wanted).norm(), 1e-7) << i;
    q = solution.joints;
  }
}

TEST(Inverse, numericSolverReportsWhatIsMissing) {
  const Cell cell = offsetWrist();
  Pose far = chainPose(cell.robot, degrees({0, 0, 0, 0, -90, 0}).data());
  far.translation() = Vec3(5000, 0, 1000);
  const InverseSolution solution = cell.inverse->solve(far, 0);
  EXPECT_FALSE(solution.reachable);
  EXPECT_GT(solution.missing, 1000.0);
  EXPECT_TRUE(solution.joints.allFinite());
  Pose bad = far;
  bad.translation().x() = std::nan("");
  for (const Cell& any : {cell, test::fanuc(), test::shippedCell("debout_7axis")}) {
    EXPECT_FALSE(any.inverse->solve(bad, 0).reachable);
  }
}

TEST(Inverse, anArmWithFiveJointsPutsItsToolAxis) {
  Cell cell = test::fanuc();
  cell.robot.joints.pop_back();
  prepareArm(cell);
  ASSERT_EQ(cell.inverse->method(), InverseMethod::Numeric);
  EXPECT_FALSE(cell.inverse->freeRotation());
  const JointVector q = degrees({10, 20, -20, 30, -60});
  const Pose flange = chainPose(cell.robot, q.data());
  const InverseSolution solution = cell.inverse->solve(flange, 0);
  ASSERT_TRUE(solution.reachable);
  const Pose reached = chainPose(cell.robot, solution.joints.data());
  const Pose tcp = cell.T_flange_tcp;
  EXPECT_LE((reached * tcp.translation() - flange * tcp.translation()).norm(), 1e-5);
  EXPECT_LE(test::angleBetween(reached.linear() * tcp.linear().col(2),
                               flange.linear() * tcp.linear().col(2)),
            1e-8);
}

TEST(Inverse, prismaticColumnsOfTheJacobian) {
  const Cell cell = test::shippedCell("debout_7axis");
  std::mt19937_64 random(4);
  JointVector q(7);
  q.head(6) = insideLimits(random, cell);
  q(6) = 0.4;
  const PartJacobian jacobian = partJacobian(cell, q);
  for (int j = 0; j < 7; ++j) {
    const double h = cell.joint(j).prismatic() ? 1e-2 : 1e-6;
    JointVector low = q;
    JointVector high = q;
    low(j) -= h;
    high(j) += h;
    const Vec3 slope =
        (T_part_tcp(cell, high).translation() - T_part_tcp(cell, low).translation()) / (2 * h);
    EXPECT_LE((slope - jacobian.col(j)).norm(), 1e-4) << j;
  }
  EXPECT_NEAR(dexterity(cell, q), 1.0, 1e-12);
  EXPECT_FALSE(periodicJoint(cell, 0));
  EXPECT_TRUE(periodicJoint(cell, 3));
}

}  // namespace
}  // namespace wcam::cell
