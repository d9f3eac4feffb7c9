// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/trace.hpp"

#include "wcam/base/error.hpp"
#include "wcam/cell/kinematics.hpp"

#include "paths.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace wcam::motion {
namespace {

using test::shippedCell;
using ::testing::HasSubstr;

cell::Cell yaskawa() {
  return shippedCell("yaskawa_ma1440_mt250");
}

const std::string kHeader = "time_s,S_rpm,L_rpm,U_rpm,R_rpm,B_rpm,T_rpm,E1_rpm,E2_rpm\n";

/// What reading a text complains of: message, place, hint.
std::string complaint(const std::string& text, const cell::Cell& cell) {
  try {
    parseMotorTrace(text, cell, "rec.csv", JobContext());
    return {};
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InputInvalid);
    return std::string(error.what()) + " " + error.hint();
  }
}

/// AT-55, AT-56: only the table turns.
TEST(Trace, onlyTheTableTurns) {
  cell::Cell cell = yaskawa();
  cell.T_table_part = geometry::Pose::Identity();
  // The torch 100 mm beside the table's axis: put the part's frame there.
  JointVector q = JointVector::Zero(8);
  const Vec3 tcp = cell::T_part_tcp(cell, q).translation();
  const double beside = std::hypot(tcp.x(), tcp.y());
  for (const double rpm : {100.0, 716.2}) {
    MotorTrace motors;
    for (int i = 0; i < 3; ++i) {
      motors.time.push_back(0.004 * i);
      motors.rpm.emplace_back(JointVector::Zero(8));
      motors.rpm.back()(7) = rpm;
    }
    const TcpTrace trace = reconstructTcp(motors, cell, q);
    const double turning = rpm * 2 * kPi / 60 / 150;
    EXPECT_NEAR(trace.speed[0], turning * beside, 1e-6);
    EXPECT_NEAR(trace.speed[2], turning * beside, 1e-6);
    EXPECT_NEAR(trace.joints[2](7), turning * 0.008, 1e-12);
    EXPECT_NEAR(turning * 100, rpm == 100.0 ? 6.9813 : 50.0, 1e-3);
  }
}

/// AT-57: the robot follows the table as one body.
TEST(Trace, movingTogetherIsNoMotionInThePart) {
  const cell::Cell cell = yaskawa();
  JointVector q(8);
  q << 0.1, 0.3, -0.2, 0.2, -1.2, 0.3, 0.2, 0.5;
  const Vec3 tcp = cell::T_base_tcp(cell, q).translation();
  const cell::Jacobian table = cell::chainJacobian(cell.positioner, q.data() + 6, tcp);
  Eigen::Matrix<double, 2, 1> turning(0.3, -0.4);
  const Eigen::Matrix<double, 6, 1> twist = table * turning;
  const Eigen::Matrix<double, 6, 6> robot = cell::robotJacobian(cell, q);
  JointVector rate(8);
  rate.head(6) = robot.partialPivLu().solve(twist);
  rate.tail(2) = turning;
  MotorTrace motors;
  for (int i = 0; i < 2; ++i) {
    motors.time.push_back(1e-9 * i);
    motors.rpm.push_back(rate);
    for (int j = 0; j < 8; ++j) {
      motors.rpm.back()(j) *= cell.joint(j).ratio * 60 / (2 * kPi);
    }
  }
  EXPECT_LE(reconstructTcp(motors, cell, q).speed[0], 1e-9);
}

/// AT-58, M44: the integral of the velocity is the way of forward kinematics, over 50 s at 4 ms.
TEST(Trace, velocityIntegratesToThePosition) {
  const cell::Cell cell = yaskawa();
  MotorTrace motors;
  for (int i = 0; i <= 12500; ++i) {
    const double t = 0.004 * i;
    motors.time.push_back(t);
    JointVector rpm(8);
    for (int j = 0; j < 8; ++j) {
      rpm(j) = (20.0 + 5 * j) * std::sin(0.3 * t + j);
    }
    motors.rpm.push_back(rpm);
  }
  JointVector q(8);
  q << 0.1, 0.3, -0.2, 0.2, -1.2, 0.3, 0.2, 0.5;
  const TcpTrace trace = reconstructTcp(motors, cell, q);
  Vec3 p = trace.position[0];
  double worst = 0.0;
  for (std::size_t i = 1; i < trace.time.size(); ++i) {
    p += 0.5 * (trace.time[i] - trace.time[i - 1]) * (trace.velocity[i] + trace.velocity[i - 1]);
    worst = std::max(worst, (p - trace.position[i]).norm());
  }
  EXPECT_LE(worst, 1e-3);
  EXPECT_LE(
      (trace.position.back() - cell::T_part_tcp(cell, trace.joints.back()).translation()).norm(),
      1e-12);
}

TEST(Trace, readsColumnsInAnyOrder) {
  const cell::Cell cell = yaskawa();
  const MotorTrace trace = parseMotorTrace(
      "\xEF\xBB\xBFx-note;E2_rpm;time_s;S_rpm;L_rpm;U_rpm;R_rpm;B_rpm;T_rpm;E1_rpm\r\n"
      "a;8;0;1;2;3;4;5;6;7\r\n\r\nb;80;0.004;10;20;30;40;50;60;70\r\n",
      cell, "rec.csv", JobContext());
  ASSERT_EQ(trace.time.size(), 2U);
  for (int j = 0; j < 8; ++j) {
    EXPECT_EQ(trace.rpm[1](j), 10.0 * (j + 1));
  }
}

TEST(Trace, badRecordingsAreNamed) {
  const cell::Cell cell = yaskawa();
  const std::string row = "0,1,2,3,4,5,6,7,8\n";
  EXPECT_THAT(complaint("", cell), HasSubstr("is empty"));
  EXPECT_THAT(complaint(kHeader, cell), HasSubstr("fewer than 2 rows"));
  EXPECT_THAT(complaint(kHeader + row, cell), HasSubstr("fewer than 2 rows"));
  EXPECT_THAT(
      complaint("time_s,S_rpm\n", cell),
      HasSubstr("the columns L_rpm, U_rpm, R_rpm, B_rpm, T_rpm, E1_rpm, E2_rpm are missing"));
  EXPECT_THAT(complaint("time_s,S_rpn\n", cell), HasSubstr("did you mean 'S_rpm'?"));
  EXPECT_THAT(complaint("time_s,S_rpm,S_rpm\n", cell), HasSubstr("stands twice"));
  EXPECT_THAT(complaint(kHeader + row + "0.1,1,2\n", cell),
              HasSubstr("the row has 3 columns, the header 9"));
  EXPECT_THAT(complaint(kHeader + row + "0.1,1,2,nan,4,5,6,7,8\n", cell),
              HasSubstr("column 4: 'nan' is not a finite number"));
  EXPECT_THAT(complaint(kHeader + row + "0.1,1,2,,4,5,6,7,8\n", cell), HasSubstr("line 3"));
  EXPECT_THAT(complaint(kHeader + row + row, cell), HasSubstr("is not after"));
  EXPECT_THAT(complaint(kHeader + "1,0,0,0,0,0,0,0,0\n0.5,0,0,0,0,0,0,0,0\n", cell),
              HasSubstr("rec.csv, line 3"));
}

TEST(Trace, lostSamplesAreTold) {
  const cell::Cell cell = yaskawa();
  std::string text = kHeader;
  for (const double t : {0.0, 0.004, 0.008, 0.020, 0.024}) {
    text += std::to_string(t) + ",0,0,0,0,0,0,0,0\n";
  }
  JobContext context;
  parseMotorTrace(text, cell, "rec.csv", context);
  ASSERT_EQ(context.diagnostics().count("trace.uneven_time"), 1U);
  EXPECT_NEAR(context.diagnostics().items()[0].data[1].second, 0.008, 1e-12);
}

TEST(Trace, ratiosAndInitialValuesMustBeThere) {
  MotorTrace motors;
  motors.time = {0, 1};
  motors.rpm = {JointVector::Zero(8), JointVector::Zero(8)};
  cell::Cell cell = yaskawa();
  EXPECT_THROW(reconstructTcp(motors, cell, JointVector::Zero(6)), Error);
  cell.robot.joints[1].ratio = 0;
  cell.positioner.joints[0].ratio = 0;
  try {
    reconstructTcp(motors, cell, JointVector::Zero(8));
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("L, E1"));
  }
}

TEST(Trace, eventsAndSummary) {
  const std::vector<double> ratio = {0, 0.5, 1, 1, 0.9, 0.7, 0.9, 1, 1.3, 1.6, 1.02, 1, 0.2};
  const std::vector<SpeedEvent> events = speedEvents(ratio, 0.05);
  ASSERT_EQ(events.size(), 4U);
  EXPECT_TRUE(events[0].atStart && !events[0].peak && events[0].index == 0);
  EXPECT_TRUE(!events[1].peak && events[1].index == 5 && events[1].first == 4 &&
              events[1].last == 6);
  EXPECT_TRUE(events[2].peak && events[2].index == 9);
  EXPECT_TRUE(events[3].atEnd);
  EXPECT_TRUE(speedEvents({}, 0.1).empty());
  TcpTrace trace;
  for (std::size_t i = 0; i < ratio.size(); ++i) {
    trace.time.push_back(0.1 * static_cast<double>(i));
    trace.speed.push_back(8 * ratio[i]);
  }
  const TraceSummary summary = summarise(trace, 0.0, 0.05);
  EXPECT_NEAR(summary.wanted, 8.0, 1e-12);
  EXPECT_NEAR(summary.maxSpeed, 12.8, 1e-12);
  EXPECT_NEAR(summary.maxTime, 0.9, 1e-12);
  EXPECT_EQ(summary.events.size(), 4U);
  EXPECT_TRUE(summarise({}, 0.0, 0.05).events.empty());
}

TEST(Trace, prismaticJointsInMillimetres) {
  cell::Cell cell = shippedCell("debout_5axis");
  for (cell::Joint& joint : cell.robot.joints) {
    joint.ratio = 0.1;  // motor turns per mm
  }
  MotorTrace motors;
  motors.time = {0, 1};
  motors.rpm = {JointVector::Zero(5), JointVector::Zero(5)};
  motors.rpm[0](0) = motors.rpm[1](0) = 60;
  const TcpTrace trace = reconstructTcp(motors, cell, JointVector::Zero(5));
  EXPECT_NEAR(trace.joints[1](0), 10.0, 1e-12);
  EXPECT_NEAR(trace.speed[0], 10.0, 1e-9);
  EXPECT_THAT(traceTable(trace, cell), HasSubstr("time_s,j1_mm,j2_mm,j3_mm,j4_deg,j5_deg,x_mm"));
}

}  // namespace
}  // namespace wcam::motion
