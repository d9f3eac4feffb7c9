// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/angles.hpp"
#include "wcam/cell/arm.hpp"

#include "cells.hpp"
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>

namespace wcam::cell {
namespace {

using test::poseDifference;
using test::randomJoints;

void compareWithSingleSolver(const Chain& chain, std::uint64_t seed) {
  const Arm arm = reduceArm(chain);
  std::mt19937_64 random(seed);
  auto poses = std::make_unique<PoseBlock>();
  auto result = std::make_unique<JointBlock>();
  double worst = 0.0;
  for (int block = 0; block < 40; ++block) {
    const int count = block == 0 ? 5 : PoseBlock::kSize;
    std::vector<Pose> targets;
    for (int n = 0; n < count; ++n) {
      targets.push_back(chainPose(chain, randomJoints(random, 6).data()));
      poses->set(n, targets.back());
    }
    inverseBlock(arm, *poses, count, *result);
    for (int n = 0; n < count; ++n) {
      const Pose& target = targets[static_cast<std::size_t>(n)];
      const IkResult single = inverseArm(arm, target);
      for (int k = 0; k < Branch::kCount; ++k) {
        const IkSolution& solution = single[static_cast<std::size_t>(k)];
        const bool reachable = result->reachable[k % 2][n] != 0.0;
        if (std::abs(solution.missing) > 1e-6 || solution.reachable) {
          ASSERT_EQ(reachable, solution.reachable) << block << " " << n << " " << k;
        }
        if (!solution.reachable) {
          continue;
        }
        Vector6 q;
        for (int j = 0; j < 6; ++j) {
          q(j) = result->joints[k][j][n];
          ASSERT_LE(std::abs(q(j)), kPi + 1e-9);
        }
        const double error = poseDifference(chainPose(chain, q.data()), target);
        worst = std::max(worst, error);
        // At a stretched elbow or a straight wrist the joints of nearly equal poses differ.
        if (solution.elbowSine > 1e-4 && solution.wristSine > 1e-4) {
          ASSERT_LE(error, 1e-8) << block << " " << n << " " << k << " seed " << seed;
        }
      }
    }
  }
  std::printf("[   INFO   ] worst FK(IK) error of the block kernel %.2e\n", worst);
}

TEST(InverseBlock, agreesWithTheSingleSolverForTheFanuc) {
  compareWithSingleSolver(test::fanuc().robot, 11);
}

TEST(InverseBlock, agreesWithTheSingleSolverForTheYaskawa) {
  compareWithSingleSolver(test::yaskawa().robot, 12);
}

TEST(InverseBlock, straightWristGivesTheRightPose) {
  const Cell cell = test::fanuc();
  auto poses = std::make_unique<PoseBlock>();
  auto result = std::make_unique<JointBlock>();
  const Pose target = chainPose(cell.robot, test::degrees({10, 20, -10, 35, 0, 25}).data());
  poses->set(0, target);
  inverseBlock(*cell.arm, *poses, 1, *result);
  Vector6 q;
  for (int j = 0; j < 6; ++j) {
    q(j) = result->joints[0][j][0];
  }
  EXPECT_LE(poseDifference(chainPose(cell.robot, q.data()), target), 1e-8);
}

TEST(InverseBlock, emptyBlockIsHarmless) {
  const Cell cell = test::fanuc();
  auto poses = std::make_unique<PoseBlock>();
  auto result = std::make_unique<JointBlock>();
  // Nothing is asked: whatever the poses hold (here NaN), no lane computes with it.
  std::memset(static_cast<void*>(poses.get()), 0xFF, sizeof(PoseBlock));
  std::memset(static_cast<void*>(result.get()), 0xFF, sizeof(JointBlock));
  inverseBlock(*cell.arm, *poses, 0, *result);
  for (const auto& branch : result->joints) {
    for (const auto& joint : branch) {
      for (const double value : joint) {
        ASSERT_EQ(std::fpclassify(value) == FP_NAN, false);
      }
    }
  }
}

}  // namespace
}  // namespace wcam::cell
