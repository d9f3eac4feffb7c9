// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The machines of Debout's thesis: closed forms, the listing of Annex 7, the choice of the
// solution.

#include "wcam/base/error.hpp"
#include "wcam/cell/joint_choice.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/unwrap.hpp"

#include "annex_seven.hpp"
#include "cells.hpp"
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace wcam::cell {
namespace {

using test::degrees;

/// Joints of the 7-axis machine from mm and degrees.
JointVector machine(double x, double y, double z, double c1, double a, double c2) {
  JointVector q(6);
  q << x, y, z, degToRad(c1), degToRad(a), degToRad(c2);
  return q;
}

/// The thesis' part frame has y along the axis of the table, which is z here: (x, y, z) → (z, x,
/// y).
Vec3 fromThesis(const Vec3& v) {
  return {v.z(), v.x(), v.y()};
}

/// Flange pose for a point, its normal and the tangent in the thesis' part frame at a given B
/// (deg).
Pose flangeAt(const Vec3& p, const Vec3& n, const Vec3& t, double b) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(degToRad(b), Vec3::UnitZ()).toRotationMatrix();
  Pose pose = Pose::Identity();
  const Vec3 z = -(turn * fromThesis(n)).normalized();
  Vec3 x = turn * fromThesis(t);
  x = (x - z * z.dot(x)).normalized();
  pose.linear() << x, z.cross(x), z;
  pose.translation() = turn * fromThesis(p);
  return pose;
}

TEST(FiveAxes, chainIsTheClosedForm) {
  const Cell cell = test::shippedCell("debout_5axis");
  std::mt19937_64 random(5);
  for (int i = 0; i < 200; ++i) {
    JointVector q(5);
    q << test::uniform(random, 0, 8500), test::uniform(random, 0, 6500),
        test::uniform(random, 0, 750), test::uniform(random, -3, 3),
        test::uniform(random, -0.5, 0.5);
    const double c = q(3);
    const double a = q(4);
    Pose expected = Pose::Identity();  // pT5 of Annex 3 with a = b = c = 0
    expected.linear() << -std::sin(c) * std::cos(a), std::sin(c) * std::sin(a), std::cos(c),
        std::cos(c) * std::cos(a), -std::cos(c) * std::sin(a), std::sin(c), std::sin(a),
        std::cos(a), 0;
    expected.translation() = q.head<3>();
    const Pose pose = cell.T_world_base * T_base_flange(cell, q);
    EXPECT_LE((pose.linear() - expected.linear()).norm(), 1e-12);
    // 2 bits of a coordinate of 8.5 m.
    EXPECT_LE((pose.translation() - expected.translation()).norm(), 1e-11);
  }
}

/// M19: the roller's axis x5 along a direction t. The same machine with x5 as its tool axis.
TEST(FiveAxes, rollerAlongTheTransverseDirection) {
  Cell cell = test::shippedCell("debout_5axis");
  cell.T_flange_tcp.linear() << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  ASSERT_LE((cell.T_flange_tcp.linear().col(2) - Vec3::UnitX()).norm(), 1e-15);
  prepareArm(cell);
  std::mt19937_64 random(6);
  std::vector<Vec3> directions = {Vec3::UnitY()};
  for (int i = 0; i < 500; ++i) {
    const Vec3 t = test::randomUnit(random);
    directions.push_back(t);
  }
  for (const Vec3& t : directions) {
    const double a = std::asin(t.z());
    const double c = std::atan2(-t.x(), t.y());
    bool found = false;
    for (int branch = 0; branch < 2; ++branch) {
      const InverseSolution solution = solveTool(
          cell, {100, -2000, 3000}, cell.T_world_base.linear().transpose() * t, 0.0, branch);
      ASSERT_TRUE(solution.reachable);
      const double offA = std::remainder(solution.joints(4) - a, 2 * kPi);
      const double offC = std::remainder(solution.joints(3) - c, 2 * kPi);
      found = found || (std::abs(offA) < 1e-7 && std::abs(offC) < 1e-7);
    }
    EXPECT_TRUE(found) << t.transpose();
  }
}

TEST(SevenAxes, chainIsTheClosedForm) {
  const Cell cell = test::shippedCell("debout_7axis");
  std::mt19937_64 random(7);
  for (int i = 0; i < 200; ++i) {
    JointVector q(7);
    for (int j = 0; j < 7; ++j) {
      q(j) = test::uniform(random, j < 3 ? -1000 : -3, j < 3 ? 1000 : 3);
    }
    const double sc = std::sin(q(3)), cc = std::cos(q(3)), sa = std::sin(q(4)), ca = std::cos(q(4));
    const double s2 = std::sin(q(5)), c2 = std::cos(q(5)), sb = std::sin(q(6)), cb = std::cos(q(6));
    constexpr double r7 = 845;
    Pose p = Pose::Identity();  // pT7 of Annex 5 with a = b = c = 0
    const double ux = -cb * sc * ca - sb * sa;
    const double uz = -sb * sc * ca + cb * sa;
    p.linear().col(0) << ux * c2 - cb * cc * s2, cc * ca * c2 - sc * s2, uz * c2 - sb * cc * s2;
    p.linear().col(1) << ux * s2 + cb * cc * c2, cc * ca * s2 + sc * c2, uz * s2 + sb * cc * c2;
    p.linear().col(2) << -cb * sc * sa + sb * ca, cc * sa, -sb * sc * sa - cb * ca;
    p.translation() << p.linear()(0, 2) * r7 + cb * q(0) - sb * q(2), p.linear()(1, 2) * r7 + q(1),
        p.linear()(2, 2) * r7 + cb * q(2) + sb * q(0);
    const Pose mine = T_base_part(cell, q).inverse() * T_base_flange(cell, q);
    Eigen::Matrix3d turned;
    turned << fromThesis(p.linear().col(0)), fromThesis(p.linear().col(1)),
        fromThesis(p.linear().col(2));
    EXPECT_LE((mine.linear() - turned).norm(), 1e-12);
    EXPECT_LE((mine.translation() - fromThesis(p.translation())).norm(), 1e-9);
  }
}

TEST(SevenAxes, listingOfAnnexSeven) {
  const Cell cell = test::shippedCell("debout_7axis");
  for (const wcam::test::AnnexSevenRow& row : wcam::test::kAnnexSeven) {
    // The listing counts B the other way.
    const InverseSolution s =
        cell.inverse->solve(flangeAt(Vec3(row.p), Vec3(row.n), Vec3(row.t), -row.b), 0);
    ASSERT_TRUE(s.reachable);
    EXPECT_NEAR(s.joints(0) - wcam::test::kAnnexSevenX, row.x, 0.25);
    EXPECT_NEAR(s.joints(1), row.y, 0.25);
    EXPECT_NEAR(s.joints(2) - wcam::test::kAnnexSevenZ, row.z, 0.25);
    EXPECT_NEAR(radToDeg(s.joints(3)), row.c1, 0.02);
    EXPECT_NEAR(radToDeg(s.joints(4)), row.a, 0.02);
    EXPECT_NEAR(radToDeg(s.joints(5)), row.c2, 0.02);
    for (int j = 0; j < 6; ++j) {
      EXPECT_EQ(limitExcess(cell.joint(j), s.joints(j)), 0.0) << j;
    }
    // Broken wrist at 30 degrees on every row (AT-31).
    EXPECT_NEAR(std::sin(s.joints(3)) * std::tan(s.joints(4)), std::tan(degToRad(30)), 5e-4);
  }
}

/// AT-29, row 10 with all its digits at the table's angles of several strategies.
TEST(SevenAxes, rowTenAtOtherAnglesOfTheTable) {
  const Cell cell = test::shippedCell("debout_7axis");
  const Vec3 p(806.588, -763.587, 1203.517);
  const Vec3 n(0.665056, 0.277877, 0.693170);
  const Vec3 t(-0.383021, -0.669894, 0.636032);
  const double rows[][6] = {
      {-13.8142, 120.0510, 33.7037, 18.5141, -2104.79, -948.10},
      {-73.8142, -120.0510, 33.7037, -110.0832, -4343.38, -1199.30},
      {-3.8297, 114.2357, 42.6047, 25.8832, -1760.54, -1135.71},
      {0, 112.6764, 46.1184, 28.0632, -1637.98, -1223.12},
      {-11.0571, 118.1297, 36.1134, 20.8564, 1000.0 - wcam::test::kAnnexSevenX,
       2018.504 - wcam::test::kAnnexSevenZ}};
  for (const auto& row : rows) {
    const InverseSolution s = cell.inverse->solve(flangeAt(p, n, t, row[0]), 0);
    ASSERT_TRUE(s.reachable);
    EXPECT_NEAR(radToDeg(s.joints(3)), row[1], 1e-3);
    EXPECT_NEAR(radToDeg(s.joints(4)), row[2], 1e-3);
    EXPECT_NEAR(radToDeg(s.joints(5)), row[3], 1e-3);
    EXPECT_NEAR(s.joints(0) - wcam::test::kAnnexSevenX, row[4], 0.02);
    EXPECT_NEAR(s.joints(1), -528.781, 0.02);
    EXPECT_NEAR(s.joints(2) - wcam::test::kAnnexSevenZ, row[5], 0.02);
  }
}

/// AT-37: u = 0 alone is no singularity, and C1 + C2 stays continuous where A passes 0.
TEST(SevenAxes, onlyAnUprightWristIsSingular) {
  const Cell cell = test::shippedCell("debout_7axis");
  for (const double j : {-0.6, 0.6}) {
    const InverseSolution s = cell.inverse->solve(
        flangeAt(Vec3::Zero(), {0, j, std::sqrt(1 - j * j)}, Vec3::UnitX(), 0), 0);
    EXPECT_FALSE(s.wristSingular);
    EXPECT_NEAR(std::abs(s.joints(3)), j < 0 ? 0.0 : kPi, 1e-12);
    EXPECT_NEAR(std::sin(s.joints(4)), std::abs(j), 1e-12);
  }
  JointVector seed = machine(0, 0, 0, 40, 0, -10);
  double before = 0.0;
  for (int i = 0; i <= 8; ++i) {
    const double a = i < 8 ? std::pow(10.0, -i - 1) : 0.0;
    const InverseSolution s = cell.inverse->solve(
        flangeAt(Vec3::Zero(), {0, -std::sin(a), std::cos(a)}, Vec3::UnitX(), 0), 0, seed.data());
    ASSERT_TRUE(s.joints.allFinite());
    EXPECT_EQ(s.wristSingular, a < 1e-9);
    const double sum = s.joints(3) + s.joints(5);
    if (i > 0) {
      EXPECT_NEAR(std::remainder(sum - before, 2 * kPi), 0.0, 1e-6) << a;
    }
    before = sum;
  }
}

/// Number in Debout's table of the 11 candidates (T12), 0 when it is none of them.
int numberInTable(const JointVector& q, const JointVector& base) {
  const double c1 = radToDeg(q(3) - base(3));
  const double c2 = radToDeg(q(5) - base(5));
  const bool turned = q(4) < 0;
  const double rows[11][3] = {{0, 0, 0},      {0, 0, 360},     {0, 0, -360},   {1, 180, 180},
                              {1, 180, -180}, {1, -180, -180}, {1, -180, 180}, {0, 360, 0},
                              {0, -360, 0},   {0, 360, -360},  {0, -360, 360}};
  for (int k = 0; k < 11; ++k) {
    if ((rows[k][0] != 0) == turned && std::abs(rows[k][1] - c1) < 1e-6 &&
        std::abs(rows[k][2] - c2) < 1e-6) {
      return k + 1;
    }
  }
  return 0;
}

std::set<int> admissibleNumbers(const Cell& cell, const Pose& flange) {
  const JointVector base = cell.inverse->solve(flange, 0).joints;
  std::set<int> numbers;
  for (const JointCandidate& candidate : candidates(cell, flange)) {
    numbers.insert(numberInTable(candidate.joints, base));
  }
  return numbers;
}

Pose testOnePoint(int point) {
  const double half = std::sqrt(0.5);
  const double wide = std::sqrt(0.75);
  switch (point) {
    case 2:
      return flangeAt(Vec3::Zero(), {0.5, half, -0.5}, {-0.8660, 0.4082, -0.2887}, -115);
    case 3:
      return flangeAt(Vec3::Zero(), {0, wide, -0.5}, {-1, 0, 0}, -160);
    default:
      return flangeAt(Vec3::Zero(), {0, wide, -0.5}, {1, 0, 0}, -160);
  }
}

/// The linear axes do not count here: the tests of the thesis tell the rotary ones only.
Cell withFreeLinearAxes() {
  Cell cell = test::shippedCell("debout_7axis");
  for (int j = 0; j < 3; ++j) {
    cell.robot.joints[static_cast<std::size_t>(j)].min = -1e5;
    cell.robot.joints[static_cast<std::size_t>(j)].max = 1e5;
  }
  return cell;
}

TEST(SevenAxes, admissibleCandidates) {
  const Cell cell = withFreeLinearAxes();
  EXPECT_EQ(admissibleNumbers(cell, testOnePoint(2)), (std::set<int>{3, 6}));
  EXPECT_EQ(admissibleNumbers(cell, testOnePoint(3)), (std::set<int>{3, 6}));
  EXPECT_EQ(admissibleNumbers(cell, testOnePoint(4)), (std::set<int>{1, 7}));

  struct Row {
    double c1, a, c2;
    std::set<int> numbers;
  };

  const Row rows[] = {{-61.389, -17.537, 199.449, {1, 7}}, {38.148, -9.062, 108.871, {2, 4}},
                      {55.359, -12.097, 93.803, {2, 4}},   {95.347, 28.983, -5.111, {1, 7}},
                      {97.543, 20.179, -6.989, {1, 7}},    {104.042, 11.743, -13.670, {1, 7}},
                      {138.485, 3.937, -48.829, {1, 7}},   {66.140, -6.910, 22.619, {2, 4}}};
  for (const Row& row : rows) {
    const JointVector q = machine(0, 0, 1000, row.c1, row.a, row.c2);
    EXPECT_EQ(admissibleNumbers(cell, chainPose(cell.robot, q.data())), row.numbers) << row.c1;
  }
}

void expectAngles(const JointVector& q, double c1, double a, double c2) {
  EXPECT_NEAR(radToDeg(q(3)), c1, 2e-3);
  EXPECT_NEAR(radToDeg(q(4)), a, 2e-3);
  EXPECT_NEAR(radToDeg(q(5)), c2, 5e-3);  // N and T are printed with 4 digits
}

/// AT-36: the corrected rules on the tests of Tables 4-3 to 4-8.
TEST(SevenAxes, choiceAmongCandidates) {
  const Cell cell = withFreeLinearAxes();
  const std::vector<bool> rotary = {false, false, false, true, true, true};
  const std::vector<bool> wrist = {false, false, false, true, false, true};
  const auto two = candidates(cell, testOnePoint(2));
  const auto first = smallestJoints(two, wrist);
  ASSERT_TRUE(first.has_value());
  expectAngles(two[*first].joints, -18.882, -48.359, -27.499);
  const auto near = smallestChange(two, machine(0, 0, 0, 0, 5, 0), rotary);
  ASSERT_TRUE(near.has_value());
  EXPECT_EQ(*near, *first);
  const auto three = candidates(cell, testOnePoint(3));
  const auto next = smallestChange(three, two[*near].joints, rotary);
  ASSERT_TRUE(next.has_value());
  expectAngles(three[*next].joints, -11.171, -61.975, -67.204);
  // The tangent turns round: two candidates change by 180 degrees; the smaller sum decides.
  const auto four = candidates(cell, testOnePoint(4));
  const auto last = smallestChange(four, three[*next].joints, rotary);
  ASSERT_TRUE(last.has_value());
  expectAngles(four[*last].joints, -11.171, -61.975, 112.796);
  // Test 2: C2 = 152.501 would be nearest but wraps the hose: C1 + C2 = 313.6.
  EXPECT_FALSE(admissible(cell, machine(0, 0, 0, 161.118, 48.359, 152.501)));
  EXPECT_TRUE(admissible(cell, machine(0, 0, 0, 161.118, 48.359, -207.499)));
  EXPECT_FALSE(smallestChange({}, machine(0, 0, 0, 0, 0, 0), rotary).has_value());
}

}  // namespace
}  // namespace wcam::cell
