// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/angles.hpp"
#include "wcam/cell/controller.hpp"
#include "wcam/cell/inverse.hpp"
#include "wcam/cell/kinematics.hpp"

#include "../../support/controller_models.hpp"
#include "cells.hpp"
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>

/// "Flange" means the controller's flange at its zero (cell-format.md), and the configurations of
/// an arm are told by where its elbow stands.
namespace wcam::cell {
namespace {

using test::degrees;

/// What a controller shows with all axes at 0, without tool: mm and degrees in its own convention.
struct ZeroPose {
  std::string controller;
  Vec3 position;
  Vec3 angles;  ///< W, P, R; A, B, C; Rx, Ry, Rz: all of the same matrix, Rz·Ry·Rx
};

/// From public models: ROS-Industrial's fanuc_m20ia_support (M-20iA, ARC Mate 120iC), its
/// kuka_kr16_support (KR16-2; the KR360 has the same structure), its motoman_gp12_support (links of
/// the MA1440). Angles as X, Y, Z of Rz·Ry·Rx.
const std::map<std::string, ZeroPose>& zeroPoses() {
  const ZeroPose fanuc{"FANUC", {1085, 0, 1040}, {180, -90, 0}};
  const ZeroPose kr16{"KUKA", {1768, 0, 640}, {0, 90, 0}};
  const ZeroPose kr360{"KUKA", {3250, 0, 990}, {0, 90, 0}};
  const ZeroPose yaskawa{"Yaskawa", {895, 0, 814}, {180, -90, 0}};
  static const std::map<std::string, ZeroPose> kPoses = {{"fanuc_arcmate120ic", fanuc},
                                                         {"fanuc_arcmate120ic_part_carried", fanuc},
                                                         {"kuka_kr16", kr16},
                                                         {"kuka_kr16_part_carried", kr16},
                                                         {"kuka_kr16_positioner", kr16},
                                                         {"kuka_kr360_part_carried", kr360},
                                                         {"kuka_kr360_platter", kr360},
                                                         {"yaskawa_ma1440_mt250", yaskawa},
                                                         {"yaskawa_ma1440_part_carried", yaskawa}};
  return kPoses;
}

/// Machines whose controllers know no flange.
const std::set<std::string>& machines() {
  static const std::set<std::string> kMachines = {"debout_5axis", "debout_7axis"};
  return kMachines;
}

TEST(Flange, EveryShippedCellIsKnown) {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(WCAM_RESOURCES) / "cells")) {
    const std::string name = entry.path().stem().string();
    EXPECT_TRUE(zeroPoses().contains(name) || machines().contains(name)) << name;
    EXPECT_FALSE(controllerOf(test::shippedCell(name).source).empty()) << name;
  }
}

TEST(Flange, IsTheControllersAtItsZero) {
  for (const auto& [name, zero] : zeroPoses()) {
    const Cell cell = test::shippedCell(name);
    EXPECT_EQ(controllerOf(cell.source), zero.controller) << name;
    const Pose flange = T_base_flange(cell, JointVector::Zero(cell.jointCount()));
    EXPECT_LE((flange.translation() - zero.position).norm(), 1e-9) << name;
    const Eigen::Matrix3d expected = rotationZ(degToRad(zero.angles.z())) *
                                     rotationY(degToRad(zero.angles.y())) *
                                     rotationX(degToRad(zero.angles.x()));
    EXPECT_LE((flange.linear() - expected).norm(), 1e-9) << name << "\n" << flange.linear();
  }
}

TEST(Flange, FollowsThePublicModelsEverywhere) {
  std::mt19937_64 random(41);
  for (const auto& [name, zero] : zeroPoses()) {
    if (zero.controller == "Yaskawa") {
      continue;  // the cell counts axis 2 as the article does, not as the controller
    }
    const Cell cell = test::shippedCell(name);
    const ::wcam::test::ControllerModel model = ::wcam::test::controllerModel(name);
    for (int i = 0; i < 100; ++i) {
      const JointVector q = test::randomJoints(random, cell.jointCount());
      std::vector<double> shown;
      for (int j = 0; j < 6; ++j) {
        shown.push_back(radToDeg(q(j)));
      }
      EXPECT_LE(test::poseDifference(T_base_flange(cell, q), Pose(model.flangeAt(shown))), 1e-9)
          << name;
    }
  }
}

/// Chalvin's tool is in the flange of the controller: at zero the wire leaves the flange forward
/// and down, as a torch hangs on an arm.
TEST(Flange, TheTorchOfTheFanucHangsBelowTheFlange) {
  const Cell cell = test::fanuc();
  const Pose tcp = T_base_tcp(cell, JointVector::Zero(8));
  EXPECT_LE((tcp.translation() - Vec3(1085 + 406, 0, 1040 - 86)).norm(), 1e-9);
  const Vec3 wire = -tcp.linear().col(2);
  EXPECT_NEAR(wire.x(), std::cos(degToRad(36)), 1e-12);
  EXPECT_NEAR(wire.z(), -std::sin(degToRad(36)), 1e-12);
}

/// Height of the elbow over the line from shoulder to wrist, in the base; the wrist must be before
/// the shoulder, seen from axis 1.
double elbowHeight(const Cell& cell, const JointVector& q, double& ahead) {
  const ChainAxes axes = chainAxes(cell.robot, q.data());
  const Vec3& shoulder = axes.points[1];
  const Vec3& elbow = axes.points[2];
  const Vec3& wrist = axes.points[4];
  Vec3 forward = shoulder - axes.points[0];
  forward.z() = 0.0;
  forward.normalize();
  ahead = (wrist - shoulder).dot(forward);
  const double share = (elbow - shoulder).dot(forward) / ahead;
  return elbow.z() - (shoulder.z() + share * (wrist.z() - shoulder.z()));
}

TEST(Elbow, IsUpWhereItStandsAboveTheLine) {
  std::mt19937_64 random(42);
  for (const auto& entry : zeroPoses()) {
    const Cell cell = test::shippedCell(entry.first);
    int up = 0;
    int down = 0;
    for (int i = 0; i < 2000; ++i) {
      const JointVector q = test::randomJoints(random, cell.jointCount());
      double ahead = 0.0;
      const double height = elbowHeight(cell, q, ahead);
      if (ahead < 1.0 || std::abs(height) < 1e-3) {
        continue;
      }
      (height > 0.0 ? up : down) += 1;
      ASSERT_EQ(branchOf(*cell.arm, q.data()).elbowDown, height < 0.0) << entry.first;
    }
    EXPECT_GT(up, 200) << entry.first;
    EXPECT_GT(down, 200) << entry.first;
  }
}

TEST(Elbow, OfAKukaFollowsAxis3) {
  for (const char* name : {"kuka_kr16", "kuka_kr360_platter"}) {
    const Cell cell = test::shippedCell(name);
    JointVector q = JointVector::Zero(cell.jointCount());
    for (const double a3 : {89.0, 30.0, 10.0, -10.0, -89.0}) {
      q.head(6) = degrees({0, -70, a3, 0, 45, 0});
      EXPECT_EQ(branchOf(*cell.arm, q.data()).elbowDown, a3 < 0.0) << name << " " << a3;
    }
  }
}

}  // namespace
}  // namespace wcam::cell
