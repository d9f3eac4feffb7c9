// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/positioner.hpp"

#include "wcam/cell/angles.hpp"
#include "wcam/cell/kinematics.hpp"

#include "cells.hpp"
#include <gtest/gtest.h>

#include <cmath>

namespace wcam::cell {
namespace {

using test::degrees;
using test::fanuc;
using test::randomUnit;
using test::uniform;

constexpr std::uint64_t kSeed = 2955;
constexpr std::array<double, 2> kNoSeed{};

/// The thesis's positioner: Ry(q7)·Rz(q8), without the measured pose.
Chain ideal() {
  Chain chain = fanuc().positioner;
  chain.T_root_first = Pose::Identity();
  return chain;
}

/// Smallest angle by brute force over both axes: a grid over all of them, then ever finer ones
/// around the best place.
double bestByGrid(const Chain& chain, const Vec3& b, const Vec3& target) {
  double best = kPi;
  std::array<double, 2> centre{};
  for (double step = degToRad(5); step > degToRad(0.05); step /= 6) {
    const int reach = step == degToRad(5) ? 36 : 12;
    const std::array<double, 2> around = centre;
    for (int i = -reach; i <= reach; ++i) {
      for (int k = -reach; k <= reach; ++k) {
        const double q[2] = {around[0] + i * step, around[1] + k * step};
        const Vec3 v = chainPose(chain, q).linear() * b;
        const double angle = std::atan2(v.cross(target).norm(), v.dot(target));
        if (angle < best) {
          best = angle;
          centre = {q[0], q[1]};
        }
      }
    }
  }
  return best;
}

TEST(Positioner, closedFormOfTheThesis) {
  const Chain chain = ideal();
  const auto find = [&chain](const Vec3& b) {
    const PositionerResult result = alignAxis(chain, b, Vec3::UnitZ(), kNoSeed);
    // The thesis takes the solution with a positive tilt.
    return result.solutions[result.solutions[0].joints[0] > 0 ? 0 : 1];
  };
  const PositionerSolution a = find(Vec3(0.5, 0, std::sqrt(0.75)));
  EXPECT_NEAR(radToDeg(a.joints[0]), 30, 1e-9);
  EXPECT_NEAR(std::abs(radToDeg(a.joints[1])), 180, 1e-9);
  const PositionerSolution b = find(Vec3(0.3, -0.4, std::sqrt(0.75)));
  EXPECT_NEAR(radToDeg(b.joints[0]), 30, 1e-9);
  EXPECT_NEAR(radToDeg(b.joints[1]), -126.8698976, 1e-6);
}

TEST(Positioner, bothSolutionsTurnTheDirectionUp) {
  const Chain chain = ideal();
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 10000; ++i) {
    const Vec3 b = randomUnit(random);
    const PositionerResult result = alignAxis(chain, b, Vec3::UnitZ(), kNoSeed);
    ASSERT_EQ(result.count, 2);
    for (const PositionerSolution& solution : result.solutions) {
      const Vec3 up = rotationY(solution.joints[0]) * rotationZ(solution.joints[1]) * b;
      ASSERT_LE((up - Vec3::UnitZ()).norm(), 1e-12) << i << " seed " << kSeed;
      ASSERT_LE(solution.residual, 1e-12);
    }
  }
}

TEST(Positioner, exactVerticalWithTheMeasuredPose) {
  const Cell cell = fanuc();
  std::mt19937_64 random(kSeed + 1);
  int exact = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vec3 up = randomUnit(random);
    const PositionerResult result = alignToVertical(cell, up, kNoSeed);
    // Directions within 0.5° of the table's axis cannot be turned to the tilted vertical.
    if (std::hypot(up.x(), up.y()) < std::sin(degToRad(0.5))) {
      continue;
    }
    ++exact;
    for (const PositionerSolution& solution : result.solutions) {
      JointVector q = JointVector::Zero(8);
      q(6) = solution.joints[0];
      q(7) = solution.joints[1];
      ASSERT_LE((T_base_part(cell, q).linear() * up - Vec3::UnitZ()).norm(), 1e-12)
          << i << " seed " << kSeed + 1;
    }
  }
  EXPECT_GT(exact, 9900);
}

TEST(Positioner, anyGeometryOfTheAxes) {
  std::mt19937_64 random(kSeed + 2);
  int reachable = 0;
  for (int i = 0; i < 2000; ++i) {
    Chain chain = ideal();
    chain.T_root_first.linear() =
        Eigen::AngleAxisd(uniform(random, -3, 3), randomUnit(random)).toRotationMatrix();
    chain.joints[0].theta = uniform(random, -3, 3);
    chain.joints[1].alpha = uniform(random, 0.2, 2.9);
    chain.joints[1].theta = uniform(random, -3, 3);
    chain.joints[1].sign = -1;
    chain.joints[1].coupling = {i % 2 == 0 ? 0.0 : 1.0};
    const Vec3 b = randomUnit(random);
    const JointVector q = test::randomJoints(random, 2);
    const Vec3 target = chainPose(chain, q.data()).linear() * b;  // certainly reachable
    const PositionerResult result = alignAxis(chain, b, target, kNoSeed);
    bool recovered = false;
    for (const PositionerSolution& solution : result.solutions) {
      ASSERT_LE(solution.residual, 1e-11) << i << " seed " << kSeed + 2;
      recovered = recovered || (std::abs(wrapAngle(solution.joints[0] - q(0))) < 1e-5 &&
                                std::abs(wrapAngle(solution.joints[1] - q(1))) < 1e-5);
    }
    ASSERT_TRUE(recovered) << i << " seed " << kSeed + 2;
    ++reachable;
  }
  EXPECT_EQ(reachable, 2000);
}

TEST(Positioner, unreachableDirectionsGetTheNearestPose) {
  std::mt19937_64 random(kSeed + 3);
  int unreachable = 0;
  for (int i = 0; i < 12; ++i) {
    Chain chain = ideal();
    chain.joints[1].alpha = 0.5;
    const Vec3 b = randomUnit(random);
    const Vec3 target = randomUnit(random);
    const PositionerResult result = alignAxis(chain, b, target, kNoSeed);
    const double grid = bestByGrid(chain, b, target);
    EXPECT_LE(result.solutions[0].residual, grid + 1e-9) << i;
    EXPECT_GE(result.solutions[0].residual, grid - degToRad(0.1)) << i;
    unreachable += result.solutions[0].residual > 1e-6 ? 1 : 0;
  }
  EXPECT_GT(unreachable, 2);
}

TEST(Positioner, keepsTheSecondAxisWhenTheDirectionLiesAlongIt) {
  const PositionerResult result =
      alignAxis(ideal(), Vec3::UnitZ(), Vec3::UnitZ(), {0.3, degToRad(400)});
  EXPECT_EQ(result.count, 1);
  EXPECT_DOUBLE_EQ(result.solutions[0].joints[1], degToRad(400));
  EXPECT_LE(result.solutions[0].residual, 1e-12);
}

TEST(Positioner, flatPartOnTheMeasuredPoseKeepsTheTableAndTellsTheRest) {
  const Cell cell = fanuc();
  const PositionerResult result = alignToVertical(cell, Vec3::UnitZ(), {0, 1.25});
  EXPECT_DOUBLE_EQ(result.solutions[0].joints[1], 1.25);
  // What the tilt axis cannot turn away: the vertical's part along that axis.
  const Vec3 tiltAxis = cell.positioner.T_root_first.linear().col(1);
  EXPECT_NEAR(result.solutions[0].residual, std::asin(std::abs(tiltAxis.z())), 1e-12);
}

TEST(Positioner, oneAxisDoesItsBest) {
  Chain chain = ideal();
  chain.joints.pop_back();
  std::mt19937_64 random(kSeed + 4);
  for (int i = 0; i < 50; ++i) {
    const Vec3 b = randomUnit(random);
    const PositionerResult result = alignAxis(chain, b, Vec3::UnitZ(), kNoSeed);
    EXPECT_EQ(result.count, 1);
    EXPECT_LE(result.solutions[0].residual, bestByGrid(chain, b, Vec3::UnitZ()) + 1e-9);
    // The best leaves the part of b along the axis (z of the table frame at zero values).
    EXPECT_NEAR(result.solutions[0].residual, std::asin(std::abs(b.z())), 1e-9);
  }
}

TEST(Positioner, noAxisTellsTheAngle) {
  Chain chain = ideal();
  chain.joints.clear();
  const Vec3 b(std::sin(0.3), 0, std::cos(0.3));
  const PositionerResult result = alignAxis(chain, b, Vec3::UnitZ(), kNoSeed);
  EXPECT_EQ(result.count, 1);
  EXPECT_NEAR(result.solutions[0].residual, 0.3, 1e-12);
}

}  // namespace
}  // namespace wcam::cell
