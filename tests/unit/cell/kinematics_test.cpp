// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/kinematics.hpp"

#include "wcam/base/error.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/cell/chain.hpp"

#include "cells.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace wcam::cell {
namespace {

using test::degrees;
using test::fanuc;
using test::fanucPartCarried;
using test::poseDifference;
using test::randomJoints;
using test::yaskawa;

void expectVector(const Vec3& actual, const Vec3& expected, double tolerance) {
  EXPECT_LE((actual - expected).cwiseAbs().maxCoeff(), tolerance)
      << actual.transpose() << " instead of " << expected.transpose();
}

Pose block(const Rotation& rotation, const Vec3& translation) {
  Pose pose = Pose::Identity();
  pose.linear() = rotation;
  pose.translation() = translation;
  return pose;
}

/// The FANUC's chain as explicit matrices (Chalvin A23, corrected; the flange of the controller is
/// turned by half a turn against it, as A23 says).
Pose fanucMatrices(const double* j) {
  const double t3 = kPi / 2 - j[2] - j[1];
  return block(rotationZ(j[0]), {150 * std::cos(j[0]), 150 * std::sin(j[0]), 0}) *
         block(rotationY(j[1]), {790 * std::sin(j[1]), 0, 790 * std::cos(j[1])}) *
         block(rotationY(t3), {-250 * std::cos(t3), 0, 250 * std::sin(t3)}) *
         block(rotationZ(-j[3]), {0, 0, 835}) *
         block(rotationY(-j[4]), {-100 * std::sin(j[4]), 0, 100 * std::cos(j[4])}) *
         block(rotationZ(-j[5]) * rotationZ(kPi), Vec3::Zero());
}

TEST(Kinematics, fanucReferenceVectors) {
  const Cell cell = fanuc();
  const Pose zero = T_base_flange(cell, degrees({0, 0, 0, 0, 0, 0, 0, 0}));
  expectVector(zero.translation(), {1085, 0, 1040}, 1e-3);
  expectVector(zero.linear().col(2), {1, 0, 0}, 1e-12);
  expectVector(zero.linear().col(0), {0, 0, 1}, 1e-12);
  const Pose down = T_base_flange(cell, degrees({0, 0, 0, 0, -90, 0, 0, 0}));
  expectVector(down.translation(), {985, 0, 940}, 1e-3);
  expectVector(down.linear().col(2), {0, 0, -1}, 1e-12);
  const Pose general = T_base_flange(cell, degrees({30, 20, -10, 40, 50, 60, 0, 0}));
  expectVector(general.translation(), {1152.668, 722.351, 890.192}, 1e-3);
  expectVector(general.linear().col(2), {0.39026, 0.79390, 0.46629}, 1e-5);
  expectVector(general.linear().col(0), {-0.80836, 0.53789, -0.23924}, 1e-5);
  const Pose other = T_base_flange(cell, degrees({-30, 15, -28, 0, 100, 0, 0, 0}));
  expectVector(other.translation(), {1073.870, -619.999, 686.915}, 1e-3);
  expectVector(other.linear().col(2), {0.26762, -0.15451, 0.95106}, 1e-5);
}

TEST(Kinematics, fanucTableIsTheMatrixForm) {
  const Cell cell = fanuc();
  std::mt19937_64 random(23);
  for (int i = 0; i < 1000; ++i) {
    const JointVector q = randomJoints(random, 8);
    ASSERT_LE(poseDifference(T_base_flange(cell, q), fanucMatrices(q.data())), 1e-9) << i;
  }
}

TEST(Kinematics, positionerChainIsTheMatrixForm) {
  const Cell cell = fanuc();
  const Pose T_v = cell.positioner.T_root_first;
  std::mt19937_64 random(24);
  for (int i = 0; i < 100; ++i) {
    const JointVector q = randomJoints(random, 8);
    const Pose expected =
        T_v * block(rotationY(q(6)), {149.631 * std::sin(q(6)), 0, 149.631 * std::cos(q(6))}) *
        block(rotationZ(q(7)), Vec3::Zero());
    ASSERT_LE(poseDifference(T_base_table(cell, q), expected), 1e-9);
  }
}

TEST(Kinematics, reachOfTheArmIsWhatItReaches) {
  // The maker's 1811 mm: from axis 1 to the wrist centre with the arm stretched level.
  const Cell cell = fanuc();
  EXPECT_NEAR(150 + armReach(*cell.arm), 1811.6, 0.05);
  // By forward kinematics: no posture takes the wrist centre farther from axis 2, one as far.
  double farthest = 0.0;
  JointVector q = degrees({0, 0, 0, 0, 0, 0, 0, 0});
  for (double elbow = -170.0; elbow <= 170.0; elbow += 0.05) {
    q(2) = degToRad(elbow);
    std::array<Pose, 7> frames;
    chainFrames(cell.robot, q.data(), frames.data());
    farthest = std::max(farthest, (frames[4].translation() - frames[1].translation()).norm());
  }
  EXPECT_NEAR(farthest, armReach(*cell.arm), 1e-3);
}

/// The article's reference positions use the true inverse of the 4x4 matrix with the corrected sign
/// of the second component of z (article, J_z).
Vec3 articlePosition(const JointVector& q, double alpha6) {
  Cell cell = yaskawa();
  cell.robot.joints[5].alpha = alpha6;
  Eigen::Matrix4d printed;
  printed << 0.99999, 0.00013, -0.00014, 0.137,  //
      -0.00013, 0.99999, -0.00008, 0.044,        //
      0.00015, 0.00008, 0.99999, 45.953,         //
      0, 0, 0, 1;
  const Eigen::Vector4d tcp = T_base_tcp(cell, q).translation().homogeneous();
  const Eigen::Vector4d p = printed.inverse() * (T_base_table(cell, q).inverse().matrix() * tcp);
  return p.head<3>();
}

TEST(Kinematics, articlePosesWithTheTrueInverse) {
  const JointVector zero = degrees({0, 0, 0, 0, 0, 0, 0, 0});
  const JointVector general = degrees({10, 20, -30, 15, -60, 25, 20, 40});
  expectVector(articlePosition(zero, kPi / 2), {405.606, 9.185, 1130.650}, 1e-3);
  expectVector(articlePosition(zero, -kPi / 2), {-810.732, 9.723, 1130.832}, 1e-3);
  expectVector(articlePosition(general, kPi / 2), {220.903, 192.976, 448.491}, 1e-3);
  expectVector(articlePosition(general, -kPi / 2), {22.234, -94.938, 1613.466}, 1e-3);
}

TEST(Kinematics, articlePosesOfTheShippedCell) {
  // The article's axes with five digits, made a rotation: 1.6e-5 rad at a lever of 1.1 m.
  const Cell cell = yaskawa();
  const JointVector zero = degrees({0, 0, 0, 0, 0, 0, 0, 0});
  const JointVector general = degrees({10, 20, -30, 15, -60, 25, 20, 40});
  expectVector(T_part_tcp(cell, zero).translation(), {405.606, 9.185, 1130.650}, 0.05);
  expectVector(T_part_tcp(cell, general).translation(), {220.903, 192.976, 448.491}, 0.05);
}

TEST(Kinematics, articleTorchPoses) {
  const Cell cell = yaskawa();
  const Pose zero = T_base_tcp(cell, degrees({0, 0, 0, 0, 0, 0, 0, 0}));
  expectVector(zero.translation(), {1403.163, -0.348, 822.916}, 1e-3);
  const Pose down = T_base_tcp(cell, degrees({0, 0, 0, 0, -90, 0, 0, 0}));
  expectVector(down.translation(), {803.916, -0.348, 205.837}, 1e-3);
  expectVector(down.linear().col(2), {0, 0, 1}, 1e-12);  // from the part towards the torch
}

TEST(Kinematics, articleTableAxes) {
  const Cell cell = yaskawa();
  const JointVector tilted = degrees({0, 0, 0, 0, 0, 0, 30, 0});
  const Pose table = T_base_table(cell, tilted);
  expectVector(table.linear().col(2), {-0.5, 0, 0.866025}, 1e-6);
  expectVector(table.translation(), {882.581, -9.434, -384.551}, 1e-3);
  const Pose part = T_base_part(cell, degrees({0, 0, 0, 0, 0, 0, 0, 0}));
  expectVector(part.translation(), {997.718, -9.390, -307.784}, 1e-3);
}

TEST(Kinematics, reductionRatiosOfTheArticle) {
  // Motor speed, joint speed and ratio of Table C-5; axis 2 differs in print by 0.01 %.
  const double motor[8] = {241.318, 190.1757, 237.156, 304.876, 616.220, 209.231, 100, 100};
  const double joint[8] = {11.3, 10.124, 11.429, 21.281, 42.872, 31.284, 5.135, 4};
  const Cell cell = yaskawa();
  JointVector rpm(8);
  for (int j = 0; j < 8; ++j) {
    rpm(j) = motor[j];
  }
  const JointVector speeds = jointSpeedsFromMotors(cell, rpm);
  for (int j = 0; j < 8; ++j) {
    EXPECT_NEAR(radToDeg(speeds(j)) / joint[j], 1.0, 2e-4) << "axis " << j + 1;
    EXPECT_NEAR(cell.joint(j).ratio / (6 * motor[j] / joint[j]), 1.0, 2e-4) << "axis " << j + 1;
  }
  const double at100[8] = {4.6826, 5.3240, 4.8192, 6.9802, 6.9573, 14.9522, 5.1350, 4.0};
  const JointVector hundred = jointSpeedsFromMotors(cell, JointVector::Constant(8, 100.0));
  for (int j = 0; j < 8; ++j) {
    EXPECT_NEAR(radToDeg(hundred(j)), at100[j], 6e-4) << "axis " << j + 1;
  }
}

TEST(Kinematics, motorSpeedsNeedRatiosAndTheRightNumber) {
  EXPECT_THROW(jointSpeedsFromMotors(fanuc(), JointVector::Constant(8, 1.0)), Error);
  EXPECT_THROW(jointSpeedsFromMotors(yaskawa(), JointVector::Constant(6, 1.0)), Error);
}

TEST(Kinematics, eighthJacobianColumnOfTheArticle) {
  const PartJacobian jacobian =
      partJacobian(yaskawa(), degrees({10, 20, -30, 15, -60, 25, 20, 40}));
  // 0.05 mm/rad: the nearest rotation differs from the printed axes by up to 8e-5 rad.
  expectVector(jacobian.col(7), {192.986, -220.980, -0.009}, 0.05);
}

void checkJacobians(const Cell& cell, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 50; ++i) {
    const JointVector q = randomJoints(random, cell.jointCount(), 2.5);
    const PartJacobian jacobian = partJacobian(cell, q);
    const Jacobian robot = robotJacobian(cell, q);
    ASSERT_EQ(jacobian.cols(), cell.jointCount());
    ASSERT_EQ(robot.cols(), cell.robotJoints());
    const Vec3 reference = T_base_tcp(cell, q).translation();
    const Vec3 inFlange = T_base_flange(cell, q).inverse() * reference;
    for (int j = 0; j < cell.jointCount(); ++j) {
      JointVector plus = q;
      JointVector minus = q;
      plus(j) += kStep;
      minus(j) -= kStep;
      const Vec3 velocity =
          (T_part_tcp(cell, plus).translation() - T_part_tcp(cell, minus).translation()) /
          (2 * kStep);
      ASSERT_LE((jacobian.col(j) - velocity).norm(), 1e-3) << "joint " << j << " seed " << seed;
      if (j >= cell.robotJoints()) {
        continue;
      }
      const Pose a = T_base_flange(cell, plus);
      const Pose b = T_base_flange(cell, minus);
      const Vec3 linear = (a * inFlange - b * inFlange) / (2 * kStep);
      const Eigen::Matrix3d spin =
          (a.linear() - b.linear()) / (2 * kStep) * T_base_flange(cell, q).linear().transpose();
      const Vec3 angular(spin(2, 1), spin(0, 2), spin(1, 0));
      ASSERT_LE((robot.col(j).head<3>() - linear).norm(), 1e-3) << j;
      ASSERT_LE((robot.col(j).tail<3>() - angular).norm(), 1e-6) << j;
    }
  }
}

TEST(Kinematics, jacobiansAreTheDerivatives) {
  checkJacobians(fanuc(), 1);
  checkJacobians(yaskawa(), 2);
  checkJacobians(fanucPartCarried(), 3);
}

TEST(Kinematics, partCarriedControlledPoint) {
  // Chalvin A20: deposition point = controlled point + A·P, with the part's rotation A.
  const Cell cell = fanucPartCarried();
  std::mt19937_64 random(26);
  for (int i = 0; i < 100; ++i) {
    const JointVector q = randomJoints(random, 6);
    const Pose part = T_base_part(cell, q);
    const Vec3 p = T_part_tcp(cell, q).translation();
    expectVector(part.translation() + part.linear() * p, {1045.747, -630.155, 653.167}, 1e-9);
  }
}

TEST(Kinematics, dexterityIsTheRatioOfSingularValues) {
  const Cell cell = fanuc();
  const JointVector q = degrees({10, 20, -10, 40, 50, 60, 5, 7});
  const Eigen::MatrixXd block = partJacobian(cell, q).leftCols(6);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(block);
  EXPECT_NEAR(dexterity(cell, q), svd.singularValues()(2) / svd.singularValues()(0), 1e-9);
}

TEST(Kinematics, wrongNumberOfJointsIsADefect) {
  EXPECT_DEATH(T_part_tcp(fanuc(), JointVector::Zero(6)), "jointCount");
}

}  // namespace
}  // namespace wcam::cell
