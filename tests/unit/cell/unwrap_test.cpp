// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/unwrap.hpp"

#include "cells.hpp"
#include <gtest/gtest.h>

namespace wcam::cell {
namespace {

using test::degrees;
using test::fanuc;

Joint limited(double min, double max) {
  Joint joint;
  joint.min = degToRad(min);
  joint.max = degToRad(max);
  return joint;
}

TEST(Unwrap, HalfwayRoundingDoesNotChoose) {
  for (const double noise : {0.0, 1e-9, -1e-9}) {
    EXPECT_NEAR(nearestTurn(kPi + noise, 0.0), -kPi, 1e-8);
    EXPECT_NEAR(nearestTurn(-kPi + noise, 0.0), -kPi, 1e-8);
    EXPECT_NEAR(nearestTurn(noise, 7.0 * kPi), 6.0 * kPi, 1e-8);
    EXPECT_NEAR(nearestPeriod(noise, 1.5 * kPi, kPi), kPi, 1e-8);
  }
}

TEST(Unwrap, nearestTurn) {
  EXPECT_NEAR(radToDeg(nearestTurn(degToRad(-170), degToRad(175))), 190, 1e-9);
  EXPECT_NEAR(radToDeg(nearestTurn(degToRad(10), degToRad(725))), 730, 1e-9);
}

TEST(Unwrap, turnsStayInsideLimits) {
  const Joint j4 = limited(-200, 200);
  const auto turn = [&j4](double value, double reference) {
    return radToDeg(turnInLimits(j4, degToRad(value), degToRad(reference)));
  };
  EXPECT_NEAR(turn(-170, 175), 190, 1e-9);   // continues over 180°
  EXPECT_NEAR(turn(-150, 195), -150, 1e-9);  // 210° would be outside
  EXPECT_NEAR(turn(150, -195), 150, 1e-9);
  EXPECT_NEAR(turn(190 - 360, 900), 190, 1e-9);
  EXPECT_NEAR(turn(200, 200), 200, 1e-9);
  const Joint narrow = limited(-90, 90);
  EXPECT_NEAR(radToDeg(turnInLimits(narrow, degToRad(120), 0)), 120, 1e-9);  // none inside
  EXPECT_NEAR(radToDeg(turnInLimits(narrow, degToRad(120), degToRad(500))), 120, 1e-9);
}

TEST(Unwrap, limitsWithRounding) {
  const Joint j5 = limited(-135, 135);
  EXPECT_EQ(limitExcess(j5, degToRad(135)), 0.0);
  EXPECT_NEAR(radToDeg(limitExcess(j5, degToRad(-140))), 5, 1e-9);
  EXPECT_NEAR(radToDeg(limitMargin(j5, degToRad(100))), 35, 1e-9);
  Joint endless;
  EXPECT_EQ(limitExcess(endless, 1e6), 0.0);
  EXPECT_TRUE(std::isinf(limitMargin(endless, 1e6)));
}

TEST(Unwrap, wholeVectorFollowsThePreviousOne) {
  const Cell cell = fanuc();
  const JointVector previous = degrees({160, 0, 0, 190, 50, 900, 20, -1000});
  const JointVector wrapped = degrees({165, 1, 2, -169, 50, 181, 21, 79});
  const JointVector q = unwrapJoints(cell, wrapped, previous);
  EXPECT_LE((q - degrees({165, 1, 2, 191, 50, 901, 21, -1001})).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Unwrap, aJointThatDrivesAnotherByAFractionKeepsItsTurn) {
  Cell cell = fanuc();
  EXPECT_TRUE(periodicJoint(cell, 3));
  cell.robot.joints[4].coupling = {0, 0, 0, 1.0 / 80};
  EXPECT_FALSE(periodicJoint(cell, 3));
  EXPECT_TRUE(periodicJoint(cell, 5));
  EXPECT_TRUE(periodicJoint(cell, 7));
}

TEST(Unwrap, neutralVectorIsInsideLimits) {
  Cell cell = fanuc();
  cell.robot.joints[1].min = 0.5;
  const JointVector q = neutralJoints(cell);
  for (int j = 0; j < cell.jointCount(); ++j) {
    EXPECT_TRUE(cell.joint(j).within(q(j)));
  }
  EXPECT_EQ(q(1), 0.5);
}

}  // namespace
}  // namespace wcam::cell
