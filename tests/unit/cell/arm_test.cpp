// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/arm.hpp"

#include "wcam/base/error.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/cell/kinematics.hpp"

#include "cells.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace wcam::cell {
namespace {

using test::degrees;
using test::fanuc;
using test::poseDifference;
using test::randomJoints;
using test::uniform;
using test::yaskawa;
using ::testing::HasSubstr;

constexpr std::uint64_t kSeed = 2832;
constexpr double kPoseTolerance = 1e-9;

/// True when the solution's joints are those given, up to full turns.
bool sameJoints(const Vector6& a, const double* b) {
  for (int j = 0; j < 6; ++j) {
    if (std::abs(wrapAngle(a(j) - b[j])) > 1e-6) {
      return false;
    }
  }
  return true;
}

/// A chain like the FANUC's with other zero offsets, senses, frame choices and a lateral offset.
Chain oddChain() {
  Chain chain;
  chain.T_root_first =
      Pose(Eigen::Translation3d(10, -20, 300) * Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()));
  const double h = kPi / 2;
  const auto add = [&chain](double alpha, double d, double theta, double r, double sign) {
    Joint joint;
    joint.alpha = alpha;
    joint.d = d;
    joint.theta = theta;
    joint.r = r;
    joint.sign = sign;
    joint.maxSpeed = 1.0;
    chain.joints.push_back(joint);
  };
  add(kPi, 0, 0.3, -450, -1);  // axis 1 points down, as KUKA draws it
  add(h, 260, -0.7, 20, 1);    // lateral offset of 20 mm, part of it taken back on axis 3
  add(kPi, 680, 0.2, 5, -1);   // axis 3 antiparallel to axis 2
  add(-h, -35, 1.1, -670, 1);  // forearm against z of axis 4
  add(h, 0, 2.5, 0, -1);
  add(h, 0, -1.0, -115, 1);
  chain.joints[2].coupling = {0.0, 1.0};
  chain.T_last_tip =
      Pose(Eigen::Translation3d(3, 4, -50) * Eigen::AngleAxisd(0.9, Vec3(0, 1, 1).normalized()));
  return chain;
}

void checkAllBranches(const Chain& chain, int poses, std::uint64_t seed) {
  const Arm arm = reduceArm(chain);
  std::mt19937_64 random(seed);
  int solutions = 0;
  double worst = 0.0;
  for (int i = 0; i < poses; ++i) {
    const JointVector q = randomJoints(random, 6);
    const Pose target = chainPose(chain, q.data());
    const IkResult result = inverseArm(arm, target);
    bool recovered = false;
    std::set<int> branches;
    for (int k = 0; k < Branch::kCount; ++k) {
      const IkSolution& solution = result[static_cast<std::size_t>(k)];
      if (!solution.reachable) {
        continue;
      }
      ++solutions;
      const double error = poseDifference(chainPose(chain, solution.joints.data()), target);
      worst = std::max(worst, error);
      ASSERT_LE(error, kPoseTolerance) << "pose " << i << " branch " << k << " seed " << seed;
      ASSERT_EQ(branchOf(arm, solution.joints.data()).index(), k)
          << "pose " << i << " seed " << seed;
      recovered = recovered || sameJoints(solution.joints, q.data());
      const IkSolution alone = inverseArm(arm, target, Branch::fromIndex(k));
      ASSERT_EQ(alone.joints, solution.joints);
    }
    ASSERT_TRUE(recovered) << "pose " << i << " seed " << seed;
    const IkSolution& own = result[static_cast<std::size_t>(branchOf(arm, q.data()).index())];
    ASSERT_TRUE(own.reachable && sameJoints(own.joints, q.data())) << "pose " << i;
  }
  EXPECT_GE(solutions, poses * 4);
  std::printf("[   INFO   ] %d poses, %d solutions, worst FK(IK) error %.2e\n", poses, solutions,
              worst);
}

TEST(Arm, fanucAllBranchesOf3000RandomPoses) {
  checkAllBranches(fanuc().robot, 3000, kSeed);
}

TEST(Arm, yaskawaAllBranchesOf3000RandomPoses) {
  checkAllBranches(yaskawa().robot, 3000, kSeed + 1);
}

TEST(Arm, anyConventionOfTheSameKindOfArm) {
  checkAllBranches(oddChain(), 3000, kSeed + 2);
}

TEST(Arm, canonicalLengthsOfTheFanuc) {
  const Arm arm = reduceArm(fanuc().robot);
  EXPECT_NEAR(arm.a1, 150.0, 1e-9);
  EXPECT_NEAR(arm.a2, 790.0, 1e-9);
  EXPECT_NEAR(arm.d4, 250.0, 1e-9);
  EXPECT_NEAR(arm.r4, 835.0, 1e-9);
  EXPECT_NEAR(arm.b, 0.0, 1e-9);
  EXPECT_NEAR(arm.a1 + armReach(arm), 1811.6, 0.05);
}

TEST(Arm, configurationNames) {
  const Arm arm = reduceArm(fanuc().robot);
  EXPECT_EQ(branchOf(arm, degrees({0, 0, 0, 0, -90, 0}).data()).name(), "NUT");
  EXPECT_EQ(branchOf(arm, degrees({0, 0, 0, 0, 90, 0}).data()).name(), "FUT");
  EXPECT_EQ(branchOf(arm, degrees({0, -120, 200, 0, -90, 0}).data()).name().substr(2), "B");
  // The same posture has the same name though the Yaskawa's axis 2 points the other way.
  const Arm other = reduceArm(yaskawa().robot);
  EXPECT_EQ(branchOf(other, degrees({0, 0, 0, 0, -90, 0}).data()).name(), "NUT");
  EXPECT_EQ(branchOf(other, degrees({0, 0, 0, 0, 90, 0}).data()).name(), "FUT");
  EXPECT_NEAR(other.a1, 155.0, 1e-9);
  std::set<std::string> names;
  for (int k = 0; k < Branch::kCount; ++k) {
    EXPECT_EQ(Branch::fromIndex(k).index(), k);
    names.insert(Branch::fromIndex(k).name());
  }
  EXPECT_EQ(names.size(), 8U);
}

TEST(Arm, unreachablePoseTellsTheMissingDistance) {
  const Cell cell = fanuc();
  const Arm& arm = *cell.arm;
  Pose target = Pose::Identity();
  target.linear() = rotationY(kPi / 2);                                 // flange z = base x
  target.translation() = Vec3(150 + armReach(arm) + 100 + 37.5, 0, 0);  // 37.5 mm too far
  const IkResult result = inverseArm(arm, target);
  for (const IkSolution& solution : result) {
    EXPECT_FALSE(solution.reachable);
    EXPECT_TRUE(solution.joints.allFinite());
  }
  EXPECT_NEAR(result[0].missing, 37.5, 1e-9);
  // The stretched arm points there.
  const Pose nearest = chainPose(cell.robot, result[0].joints.data());
  EXPECT_NEAR((target.translation() - nearest.translation()).norm(), 37.5, 1e-6);
}

TEST(Arm, tooNearTellsTheMissingDistance) {
  const Cell cell = fanuc();
  Pose target = Pose::Identity();
  target.translation() = Vec3(150, 0, 10 + 100);  // wrist centre 10 mm above axis 2
  const double inner = std::abs(790.0 - std::hypot(250.0, 835.0));
  const IkSolution solution = inverseArm(*cell.arm, target, Branch{});
  EXPECT_FALSE(solution.reachable);
  EXPECT_NEAR(solution.missing, inner - 10.0, 1e-9);
  const Pose nearest = chainPose(cell.robot, solution.joints.data());
  EXPECT_NEAR((target.translation() - nearest.translation()).norm(), inner - 10.0, 1e-6);
}

TEST(Arm, stretchedArmIsReachableAndFlagged) {
  const Cell cell = fanuc();
  // J3 puts wrist centre, axis 3 and axis 2 in one line.
  const double stretch = std::atan2(250.0, 835.0);
  JointVector q = degrees({20, 30, 0, 40, -50, 60});
  q(2) = kPi / 2 - q(1) - stretch;
  const Pose target = chainPose(cell.robot, q.data());
  const IkSolution solution = inverseArm(*cell.arm, target, branchOf(*cell.arm, q.data()));
  ASSERT_TRUE(solution.reachable);
  EXPECT_LE(solution.elbowSine, 1e-6);
  EXPECT_LE(poseDifference(chainPose(cell.robot, solution.joints.data()), target), 1e-6);
}

TEST(Arm, wristSingularityKeepsAxis4OfTheSeed) {
  const Cell cell = fanuc();
  const JointVector q = degrees({10, 20, -10, 35, 0, 25});
  const Pose target = chainPose(cell.robot, q.data());
  const IkSolution seeded = inverseArm(*cell.arm, target, Branch{}, q.data());
  ASSERT_TRUE(seeded.reachable);
  EXPECT_TRUE(seeded.wristSingular);
  EXPECT_TRUE(sameJoints(seeded.joints, q.data()));
  const IkSolution free = inverseArm(*cell.arm, target, Branch{});
  EXPECT_TRUE(free.wristSingular);
  EXPECT_LE(poseDifference(chainPose(cell.robot, free.joints.data()), target), kPoseTolerance);
}

TEST(Arm, accurateNextToTheWristSingularity) {
  const Cell cell = fanuc();
  for (const double j5 : {1e-3, 1e-6, 1e-9, 1e-11, -1e-7}) {
    JointVector q = degrees({10, 20, -10, 35, 0, 25});
    q(4) = j5;
    const Pose target = chainPose(cell.robot, q.data());
    for (const IkSolution& solution : inverseArm(*cell.arm, target)) {
      if (solution.reachable) {
        EXPECT_LE(poseDifference(chainPose(cell.robot, solution.joints.data()), target),
                  kPoseTolerance)
            << j5;
      }
    }
  }
}

TEST(Arm, shoulderSingularityKeepsAxis1OfTheSeed) {
  const Cell cell = fanuc();
  // Wrist centre on axis 1, found from the triangle of axis 2, axis 3 and the wrist centre.
  Pose target = Pose::Identity();
  target.linear() = rotationX(0.4) * rotationY(0.3);
  target.translation() = Vec3(0, 0, 900) + 100.0 * target.linear().col(2);
  const JointVector seed = degrees({33, 0, 0, 0, -60, 0});
  const IkSolution solution = inverseArm(*cell.arm, target, Branch{}, seed.data());
  ASSERT_TRUE(solution.reachable);
  EXPECT_TRUE(solution.shoulderSingular);
  EXPECT_NEAR(radToDeg(solution.joints(0)), 33.0, 1e-9);
  EXPECT_LE(poseDifference(chainPose(cell.robot, solution.joints.data()), target), kPoseTolerance);
}

TEST(Arm, refusesAWristThatIsNotSpherical) {
  Chain chain = fanuc().robot;
  chain.joints[4].d = 3.0;
  try {
    reduceArm(chain);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ProjectInvalid);
    EXPECT_THAT(error.what(), HasSubstr("wrist is not spherical"));
    EXPECT_THAT(error.what(), HasSubstr("3.000000 mm"));
  }
}

TEST(Arm, refusesAxes2And3ThatAreNotParallel) {
  Chain chain = fanuc().robot;
  chain.joints[2].alpha = degToRad(0.009);
  try {
    reduceArm(chain);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("axes 2 and 3 are not parallel"));
    EXPECT_THAT(error.what(), HasSubstr("0.009000 deg"));
  }
}

TEST(Arm, refusesAnotherNumberOfJoints) {
  Chain chain = fanuc().robot;
  chain.joints.pop_back();
  EXPECT_THROW(reduceArm(chain), Error);
}

TEST(Arm, notAFinitePoseIsUnreachable) {
  const Cell cell = fanuc();
  Pose target = Pose::Identity();
  target.translation() = Vec3(std::nan(""), 0, 0);
  for (const IkSolution& solution : inverseArm(*cell.arm, target)) {
    EXPECT_FALSE(solution.reachable);
  }
}

}  // namespace
}  // namespace wcam::cell
