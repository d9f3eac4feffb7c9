// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Positioner strategies of Debout (§2.H M30) and the planar rule of the TCP-velocity article (M46);
// gradients; paths that no motion can follow.

#include "wcam/base/error.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/unwrap.hpp"
#include "wcam/motion/plan.hpp"

#include "gradient.hpp"
#include "modes.hpp"
#include "paths.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace wcam::motion {
namespace {

using geometry::Vec3;
using test::circles;
using test::shippedCell;

PlannedMotion plan(const toolpath::Toolpath& path,
                   const cell::Cell& cell,
                   MotionParams params,
                   RedundancyMode mode) {
  params.mode = mode;
  return planMotion(path, cell, params, "op", JobContext());
}

/// The FANUC arm with Debout's table: vertical axis y of the part, x of the table along z of the
/// part, so that azimuths are atan2(x, z).
cell::Cell tableCell() {
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  cell::Chain table;
  table.T_root_first.translation() = Vec3(1000, 0, -200);
  cell::Joint joint = cell.positioner.joints[1];
  joint.alpha = 0.0;
  joint.d = 0.0;
  joint.r = 0.0;
  joint.theta = 0.0;
  joint.coupling.clear();
  table.joints = {joint};
  cell.positioner = table;
  cell.T_table_part = geometry::Pose::Identity();
  cell.T_table_part.linear() << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  return cell;
}

toolpath::PathPoint pointAt(const Vec3& p, const Vec3& axis) {
  toolpath::PathPoint point;
  point.p = p;
  point.axis = axis;
  point.up = axis;
  point.speed = 10.0;
  return point;
}

toolpath::Toolpath pathOf(std::vector<toolpath::PathPoint> points) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec3 along = points[i + 1].p - points[i].p;
    if (along.norm() > 0.0) {
      points[i].t = along.normalized();
      points[i + 1].t = points[i].t;
    }
  }
  toolpath::Toolpath path;
  path.layers.emplace_back();
  path.layers[0].beads.emplace_back();
  path.layers[0].beads[0].points = std::move(points);
  return path;
}

/// A wavy path on the table of tableCell: axis mostly along y of the part.
toolpath::Toolpath wavyPath(int points) {
  std::vector<toolpath::PathPoint> all;
  for (int i = 0; i < points; ++i) {
    const double a = 0.5 + 2.0 * i / points;
    all.push_back(pointAt(Vec3(120 * std::sin(a), 30 + 10 * std::cos(3 * a), 120 * std::cos(a)),
                          Vec3(0.4 * std::sin(1.3 * a), 1.0, 0.3 * std::cos(a)).normalized()));
  }
  return pathOf(all);
}

TEST(Debout, constantToolAxis) {
  // (4-4) B = α − ω, ω = atan2(I, K): the axis keeps the azimuth α in the cell. The row 10 of the
  // listing in Annex 7: B = −13.8142° at α = 30°.
  const cell::Cell cell = tableCell();
  MotionParams params;
  params.tableAngle = Angle(degToRad(30.0));
  const auto& row10 =
      pointAt(Vec3(80.6588, 76.3587, 120.3517), Vec3(0.665056, 0.277877, 0.693170).normalized());
  auto planned = plan(pathOf({row10, row10}), cell, params, RedundancyMode::ConstantToolAxis);
  EXPECT_NEAR(radToDeg(planned.motion.waypoints[0].joints(6)), -13.8142, 1e-3);
  params.tableAngle = Angle(degToRad(-30.0));
  planned = plan(pathOf({row10, row10}), cell, params, RedundancyMode::ConstantToolAxis);
  EXPECT_NEAR(radToDeg(planned.motion.waypoints[0].joints(6)), -73.8142, 1e-3);
  planned = plan(wavyPath(60), cell, params, RedundancyMode::ConstantToolAxis);
  for (const Waypoint& point : planned.motion.waypoints) {
    const Vec3 axis =
        cell::T_base_part(cell, point.joints).linear() * point.T_part_tcp.linear().col(2);
    EXPECT_NEAR(std::atan2(axis.y(), axis.x()), degToRad(-30.0), 1e-9);
  }
}

TEST(Debout, fixedToolTip) {
  // (4-5) B = α − atan2(Xp, Zp): the point keeps the azimuth α; row 10: B = −3.8297°.
  const cell::Cell cell = tableCell();
  MotionParams params;
  params.tableAngle = Angle(degToRad(30.0));
  const auto row10 = pointAt(Vec3(806.588, -763.587, 1203.517) * 0.1, Vec3::UnitY());
  auto planned = plan(pathOf({row10, row10}), cell, params, RedundancyMode::FixedToolTip);
  EXPECT_NEAR(radToDeg(planned.motion.waypoints[2].joints(6)), -3.8297, 1e-3);
  planned = plan(wavyPath(60), cell, params, RedundancyMode::FixedToolTip);
  for (const Waypoint& point : planned.motion.waypoints) {
    if (point.point >= 0) {
      const Vec3 tip = cell::T_base_tcp(cell, point.joints).translation() - Vec3(1000, 0, -200);
      EXPECT_NEAR(std::atan2(tip.y(), tip.x()), degToRad(30.0), 1e-9);
    }
  }
}

TEST(Debout, homogeneousTurn) {
  // (4-6) ΔB/Δs constant to 1e-12, monotone, B_total over the bead.
  const cell::Cell cell = tableCell();
  MotionParams params;
  params.tableAngle = Angle(0.2);
  params.tableTurn = Angle(-2.5);
  const auto planned = plan(wavyPath(60), cell, params, RedundancyMode::Homogeneous);
  const auto& points = planned.motion.waypoints;
  double length = 0.0;
  for (std::size_t i = 3; i < 2 + 60; ++i) {
    length += (points[i].T_part_tcp.translation() - points[i - 1].T_part_tcp.translation()).norm();
  }
  EXPECT_NEAR(points[2].joints(6), 0.2, 1e-12);
  EXPECT_NEAR(points[61].joints(6), 0.2 - 2.5, 1e-12);
  for (std::size_t i = 3; i < 2 + 60; ++i) {
    const double step =
        (points[i].T_part_tcp.translation() - points[i - 1].T_part_tcp.translation()).norm();
    EXPECT_NEAR((points[i].joints(6) - points[i - 1].joints(6)) / step, -2.5 / length, 1e-12);
  }
}

TEST(Debout, fixedTable) {
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  MotionParams params;
  params.tableAngle = Angle(0.4);
  const auto planned = plan(circles(2, 40, 30, Vec3::Zero()), cell, params, RedundancyMode::Fixed);
  for (const Waypoint& point : planned.motion.waypoints) {
    EXPECT_EQ(point.joints(6), planned.motion.waypoints[0].joints(6));
    EXPECT_NEAR(point.joints(7), 0.4, 1e-12);
  }
  EXPECT_LE(planned.statistics.maxVerticalError, degToRad(0.5));
  EXPECT_EQ(planned.statistics.evaluation.value(Objective::Positioner), 0.0);
}

TEST(Debout, axesThatTheCellLacksAreRefused) {
  cell::Cell bare = shippedCell("fanuc_arcmate120ic");
  bare.positioner.joints.clear();
  const cell::Cell carried = shippedCell("fanuc_arcmate120ic_part_carried");
  for (const RedundancyMode mode : {RedundancyMode::ConstantToolAxis, RedundancyMode::FixedToolTip,
                                    RedundancyMode::Homogeneous, RedundancyMode::PlanarVertical}) {
    for (const cell::Cell* cell : {static_cast<const cell::Cell*>(&bare), &carried}) {
      try {
        plan(circles(1, 30, 20, Vec3::Zero()), *cell, {}, mode);
        FAIL() << redundancyKey(mode);
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::JobFailed);
        EXPECT_THAT(error.what(), ::testing::HasSubstr(redundancyKey(mode)));
      }
    }
  }
  // The others work with any positioner.
  for (const RedundancyMode mode :
       {RedundancyMode::Optimized, RedundancyMode::Constant, RedundancyMode::PointByPoint,
        RedundancyMode::Polynomial, RedundancyMode::Fixed}) {
    for (const cell::Cell* cell : {static_cast<const cell::Cell*>(&bare), &carried}) {
      EXPECT_FALSE(
          plan(circles(1, 30, 20, Vec3::Zero()), *cell, {}, mode).motion.waypoints.empty());
    }
  }
}

TEST(PlanarVertical, closedForm) {
  // AT-59: q8 = −atan2(p'y, p'x), q7 = atan2(b'x, b'z), x = xr + ρ·cos q7 − (p'z + 230)·sin q7,
  // z = zr + ρ·sin q7 + (p'z + 230)·cos q7, y = yr; the torch is vertical.
  const cell::Cell cell = shippedCell("yaskawa_ma1440_mt250");
  const Vec3 r = cell.positioner.T_root_first.translation();
  for (const Vec3& inTable : {Vec3(80, 30, 50), Vec3(120, -60, 70), Vec3(40, 5, 90)}) {
    for (const double tilt : {-0.2, 0.1, 0.35}) {
      const double q8 = -std::atan2(inTable.y(), inTable.x());
      // A build direction that leans in the plane of the point by the tilt, and a little across it.
      const Vec3 turned = Vec3(std::sin(tilt), 0.15, std::cos(tilt)).normalized();
      const Vec3 up = Eigen::AngleAxisd(-q8, Vec3::UnitZ()) * turned;
      const geometry::Pose T_part_table = cell.T_table_part.inverse();
      const auto point = pointAt(T_part_table * inTable, T_part_table.linear() * up);
      const auto planned = plan(pathOf({point, point}), cell, {}, RedundancyMode::PlanarVertical);
      const Waypoint& at = planned.motion.waypoints[2];
      EXPECT_NEAR(at.joints(7), q8, 1e-9);
      EXPECT_NEAR(at.joints(6), tilt, 1e-9);
      const double rho = inTable.head<2>().norm();
      const double height = inTable.z() + 230.0;
      const geometry::Pose tcp = cell::T_base_tcp(cell, at.joints);
      EXPECT_NEAR(tcp.translation().x(), r.x() + rho * std::cos(tilt) - height * std::sin(tilt),
                  1e-9);
      EXPECT_NEAR(tcp.translation().y(), r.y(), 1e-9);
      EXPECT_NEAR(tcp.translation().z(), r.z() + rho * std::sin(tilt) + height * std::cos(tilt),
                  1e-9);
      EXPECT_LE((tcp.linear().col(2) - Vec3::UnitZ()).norm(), 1e-9);
      // What is left of lead or lag: asin|b'y|.
      EXPECT_NEAR(at.tilt, std::asin(turned.y()), 1e-9);
    }
  }
}

TEST(PlanarVertical, pathLengthIsTheMaster) {
  // AT-60: with the table at constant speed a square bead is twice as fast at its corners as in the
  // middle of its sides; with the path's length as the master the speed is even.
  const cell::Cell cell = shippedCell("yaskawa_ma1440_mt250");
  const double half = 60.0;
  std::vector<toolpath::PathPoint> points;
  constexpr int kSide = 4000;
  for (int i = 0; i <= kSide; ++i) {
    // One side, seen from the middle of the table; from corner to corner.
    const Vec3 inTable(half, -half + 2.0 * half * i / kSide, 50.0);
    points.push_back(pointAt(cell.T_table_part.inverse() * inTable,
                             cell.T_table_part.linear().transpose() * Vec3::UnitZ()));
  }
  const auto planned = plan(pathOf(points), cell, {}, RedundancyMode::PlanarVertical);
  double slowest = 1e9;
  double fastest = 0.0;
  double slowestMaster = 1e9;
  double fastestMaster = 0.0;
  for (std::size_t i = 1; i < planned.motion.waypoints.size(); ++i) {
    const Waypoint& at = planned.motion.waypoints[i];
    const Waypoint& before = planned.motion.waypoints[i - 1];
    if (at.point > 0) {
      const double way = (at.T_part_tcp.translation() - before.T_part_tcp.translation()).norm();
      const double perTurn = way / std::abs(at.joints(7) - before.joints(7));
      slowest = std::min(slowest, perTurn);
      fastest = std::max(fastest, perTurn);
      slowestMaster = std::min(slowestMaster, at.tcpSpeed);
      fastestMaster = std::max(fastestMaster, at.tcpSpeed);
    }
  }
  // The steps nearest to a corner lie 1/8000 of the side beside it.
  EXPECT_NEAR(fastest / slowest, 2.0, 1e-3);
  EXPECT_NEAR(fastestMaster / slowestMaster, 1.0, 1e-3);
}

TEST(Gradient, agreesWithDifferenceQuotients) {
  constexpr unsigned kSeed = 11;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const char* name :
       {"fanuc_arcmate120ic", "yaskawa_ma1440_mt250", "fanuc_arcmate120ic_part_carried"}) {
    const cell::Cell cell = shippedCell(name);
    const detail::CellModel model(cell);
    for (int k = 0; k < 200; ++k) {
      detail::Target target;
      target.p = 60.0 * Vec3(unit(random), unit(random), unit(random) + 1.0);
      target.axis = Vec3(0.5 * unit(random), 0.5 * unit(random), 1.0).normalized();
      target.along = Vec3(unit(random), unit(random), 0.3 * unit(random)).normalized();
      detail::FreeChoice choice;
      choice.torchRotation = 3.0 * unit(random);
      choice.positioner = {0.4 * unit(random), 3.0 * unit(random)};
      choice.lead = 0.2 * unit(random);
      choice.lateral = 0.2 * unit(random);
      geometry::Pose T_part_tcp;
      const auto solve = [&](const detail::FreeChoice& c) {
        const auto flange = detail::flangePose(cell, target, c, &T_part_tcp);
        return cell::inverseArm(*cell.arm, flange, cell::Branch::fromIndex(0));
      };
      const cell::IkSolution at = solve(choice);
      if (!at.reachable || at.wristSine < 0.1 || at.elbowSine < 0.1 || at.axisDistance < 100) {
        continue;
      }
      cell::JointVector q(cell.jointCount());
      q.head<6>() = at.joints;
      for (int j = 0; j < cell.positionerJoints(); ++j) {
        q(6 + j) = choice.positioner[static_cast<std::size_t>(j)];
      }
      (void)solve(choice);
      const auto gradient =
          detail::freeGradient(model, target, choice, T_part_tcp, model.armState(q), true);
      for (int s = 0; s < detail::kFreeScalars; ++s) {
        constexpr double kStep = 1e-6;
        const auto moved = [&](double step) {
          detail::FreeChoice c = choice;
          switch (static_cast<detail::FreeScalar>(s)) {
            case detail::FreeScalar::Torch:
              c.torchRotation += step;
              break;
            case detail::FreeScalar::Table:
              c.positioner[static_cast<std::size_t>(std::max(cell.positionerJoints() - 1, 0))] +=
                  step;
              break;
            case detail::FreeScalar::Lead:
              c.lead += step;
              break;
            case detail::FreeScalar::Lateral:
              c.lateral += step;
              break;
          }
          return solve(c).joints;
        };
        if (s == 1 && cell.positionerJoints() == 0) {
          continue;
        }
        cell::Vector6 difference = moved(kStep) - moved(-kStep);
        for (int j = 0; j < 6; ++j) {
          difference(j) = cell::nearestTurn(difference(j), 0.0) / (2.0 * kStep);
        }
        EXPECT_LE((difference - gradient.col(s)).norm(), 1e-5 * (1.0 + difference.norm()))
            << name << " scalar " << s << " case " << k << " seed " << kSeed;
      }
    }
  }
}

void expectFinite(const PlannedMotion& planned, const std::string& what) {
  for (const Waypoint& point : planned.motion.waypoints) {
    ASSERT_TRUE(point.joints.allFinite()) << what;
    ASSERT_TRUE(point.T_part_tcp.matrix().allFinite()) << what;
    ASSERT_TRUE(std::isfinite(point.time)) << what;
  }
  ASSERT_TRUE(std::isfinite(planned.statistics.evaluation.cost)) << what;
}

TEST(BadPaths, neitherCrashNorGiveNumbersThatAreNone) {
  std::vector<std::pair<std::string, toolpath::Toolpath>> paths;
  const auto at = [](double x, double y, double z) {
    return pointAt(Vec3(x, y, z), Vec3::UnitZ());
  };
  paths.emplace_back("single point", pathOf({at(0, 0, 5)}));
  paths.emplace_back("zero length", pathOf({at(0, 0, 5), at(0, 0, 5), at(0, 0, 5)}));
  paths.emplace_back("repeated points",
                     pathOf({at(0, 0, 5), at(10, 0, 5), at(10, 0, 5), at(20, 0, 5), at(20, 0, 5)}));
  paths.emplace_back("jump", pathOf({at(0, 0, 5), at(1, 0, 5), at(400, 300, 5), at(401, 300, 5)}));
  paths.emplace_back("leaves the workspace", pathOf({at(0, 0, 5), at(1500, 0, 5), at(4000, 0, 5)}));
  paths.emplace_back("out of reach", pathOf({at(9000, 0, 5), at(9001, 0, 5)}));
  paths.emplace_back("axis turned over",
                     pathOf({at(0, 0, 5), pointAt(Vec3(1, 0, 5), -Vec3::UnitZ()), at(2, 0, 5)}));
  toolpath::Toolpath still = pathOf({at(0, 0, 5), at(10, 0, 5)});
  still.layers[0].beads[0].points[1].speed = 0.0;
  paths.emplace_back("no speed", still);
  toolpath::Toolpath wild = pathOf({at(0, 0, 5), at(10, 0, 5), at(20, 0, 5)});
  wild.layers[0].beads[0].points[1].up = -Vec3::UnitZ();
  paths.emplace_back("build direction turned over", wild);
  for (const char* name :
       {"fanuc_arcmate120ic", "fanuc_arcmate120ic_part_carried", "debout_5axis", "debout_7axis"}) {
    const cell::Cell cell = shippedCell(name);
    for (const auto& [what, path] : paths) {
      for (int m = 0; m < kRedundancyModes; ++m) {
        const auto mode = static_cast<RedundancyMode>(m);
        if (detail::lacksPositioner(mode, cell)) {
          continue;
        }
        JobContext context;
        MotionParams params;
        params.mode = mode;
        const PlannedMotion planned = planMotion(path, cell, params, "op", context);
        expectFinite(planned, std::string(name) + ", " + what + ", " + redundancyKey(mode));
        const bool told = context.diagnostics().count(Severity::Violation) > 0;
        // Leans beyond the tolerance and a torch that crawls are violations as well.
        EXPECT_EQ(told, planned.statistics.evaluation.count(Constraint::Reach) +
                                planned.statistics.evaluation.count(Constraint::Limits) +
                                planned.statistics.evaluation.count(Constraint::Tilt) +
                                planned.statistics.evaluation.count(Constraint::Cable) +
                                context.diagnostics().count("motion.too_slow") >
                            0)
            << what << ", " << redundancyKey(mode);
      }
    }
  }
}

TEST(BadPaths, toolAxisExactlyAtTheWristSingularity) {
  // A straight torch on a fixed table: constant rotation or not, the axis along the forearm is
  // singular; the search cannot avoid what every branch and rotation meets, and says so.
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  cell.T_flange_tcp = geometry::Pose::Identity();
  cell.T_flange_tcp.translation() = Vec3(0, 0, 300);
  cell.positioner.joints.clear();
  cell.positioner.T_root_first = geometry::Pose::Identity();
  cell.positioner.T_root_first.translation() = Vec3(1200, 0, 0);
  cell.positioner.T_last_tip = geometry::Pose::Identity();
  cell.T_table_part = geometry::Pose::Identity();
  const cell::JointVector straight =
      (cell::JointVector(6) << 0.0, 0.3, 0.2, 0.0, 0.0, 0.0).finished();
  const geometry::Pose tcp = cell::T_part_tcp(cell, straight);
  std::vector<toolpath::PathPoint> points;
  for (int i = -10; i <= 10; ++i) {
    points.push_back(pointAt(tcp.translation() + Vec3(0, 1.0 * i, 0), tcp.linear().col(2)));
  }
  MotionParams params;
  params.branch = BranchChoice::Nut;
  JobContext context;
  const PlannedMotion planned = planMotion(pathOf(points), cell, params, "op", context);
  expectFinite(planned, "singular");
  EXPECT_GT(planned.statistics.evaluation.count(Constraint::Singularity), 0U);
  EXPECT_GT(context.diagnostics().count("motion.singularity"), 0U);
}

}  // namespace
}  // namespace wcam::motion
