// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Chalvin's acceptance tests AT-30 to AT-36 (shared/methods, A31–A34).

#include "wcam/base/error.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/unwrap.hpp"
#include "wcam/motion/plan.hpp"

#include "modes.hpp"
#include "paths.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <mutex>

namespace wcam::motion {
namespace {

using detail::FreeChoice;
using detail::Resolution;
using detail::Task;
using geometry::Vec3;
using test::circleFrom;
using test::hemisphere;
using test::shippedCell;

constexpr double kRadius = 45.0;

PlannedMotion plan(const toolpath::Toolpath& path, const cell::Cell& cell, MotionParams params) {
  return planMotion(path, cell, params, "op", JobContext());
}

Task taskOf(const toolpath::Toolpath& path, const cell::Cell& cell, const MotionParams& params) {
  std::vector<detail::Target> targets = detail::makeTargets(path, params, JobContext());
  detail::Runs runs = detail::findRuns(targets);
  std::vector<detail::Positioning> aligned = {detail::positionPart(cell, targets, 0, JobContext())};
  return {cell, params, std::move(targets), std::move(runs), aligned, aligned};
}

double greatestOnBeads(const PlannedMotion& planned, int joint) {
  double greatest = 0.0;
  for (const Waypoint& point : planned.motion.waypoints) {
    if (point.point >= 0) {
      greatest = std::max(greatest, std::abs(point.joints(joint)));
    }
  }
  return greatest;
}

/// Range of a joint over a layer's bead.
double rangeInLayer(const Motion& motion, int layer, int joint) {
  double low = 1e9;
  double high = -1e9;
  for (const Waypoint& point : motion.waypoints) {
    if (point.layer == layer && point.point >= 0) {
      low = std::min(low, point.joints(joint));
      high = std::max(high, point.joints(joint));
    }
  }
  return high - low;
}

TEST(Hemisphere, infeasibleAtConstantRotation) {
  // AT-30: axis 5 needs 167.1° ± 0.5° for every R_Z that is a multiple of 90°.
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic_part_carried");
  const toolpath::Toolpath path = hemisphere(kRadius, 1.0, 72);
  EXPECT_EQ(path.layers.size(), 71U);
  for (const double rotation : {0.0, 90.0, 180.0, 270.0}) {
    MotionParams params;
    params.mode = RedundancyMode::Constant;
    params.branch = BranchChoice::Nut;
    params.torchRotation = Angle(degToRad(rotation));
    JobContext context;
    const PlannedMotion planned = planMotion(path, cell, params, "op", context);
    EXPECT_NEAR(radToDeg(greatestOnBeads(planned, 4)), 167.1, 0.5) << rotation;
    EXPECT_GT(context.diagnostics().count("motion.joint_limit"), 0U);
    EXPECT_GT(planned.statistics.evaluation.count(Constraint::Limits), 0U);
  }
}

TEST(Hemisphere, atTheMovedNozzleAxisFiveIsOnItsLimit) {
  // AT-30 at D_R' (A4.1): J5 135.1° ± 0.3°.
  cell::Cell cell = shippedCell("fanuc_arcmate120ic_part_carried");
  cell.T_base_tcp.translation() = Vec3(988.057, -733.138, 1104.885);
  MotionParams params;
  params.mode = RedundancyMode::Constant;
  params.branch = BranchChoice::Nut;
  const PlannedMotion planned = plan(hemisphere(kRadius, 1.0, 72), cell, params);
  EXPECT_NEAR(radToDeg(greatestOnBeads(planned, 4)), 135.1, 0.3);
}

TEST(Hemisphere, followingTheLayerKeepsFiveJointsConstant) {
  // AT-31: R_Z = −θ + b0 makes J1 … J5 constant (1e-9) and Φ = 0; AT-33: J6 turns at 6/ρ rad/s.
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic_part_carried");
  const toolpath::Toolpath path = hemisphere(kRadius, 5.0, 72, 6.0);
  const MotionParams params;
  const Task task = taskOf(path, cell, params);
  Resolution resolution;
  resolution.branches.assign(task.runs.count(), 0);
  for (const detail::Target& target : task.targets) {
    FreeChoice choice;
    choice.torchRotation = -std::atan2(target.p.y(), target.p.x()) + 0.3;
    resolution.choices.push_back(choice);
  }
  Motion motion = detail::solveMotion(task, resolution, JobContext());
  const Evaluation evaluation = evaluateMotion(motion, cell, params);
  EXPECT_LE(evaluation.value(Objective::Motion), 1e-18);
  for (int layer = 0; layer < static_cast<int>(path.layers.size()); ++layer) {
    for (int joint = 0; joint < 5; ++joint) {
      EXPECT_LE(rangeInLayer(motion, layer, joint), 1e-9) << "layer " << layer;
    }
  }
  applyTimeLaw(motion, cell, params, params.jointSpeedRatio);
  for (std::size_t i = 1; i < motion.waypoints.size(); ++i) {
    const Waypoint& point = motion.waypoints[i];
    if (point.point > 0) {
      const double step =
          (point.T_part_tcp.translation() - motion.waypoints[i - 1].T_part_tcp.translation())
              .norm();
      const double rho = point.T_part_tcp.translation().head<2>().norm();
      // The polygon's sides are shorter than its arcs.
      const double perChord = 2.0 * kPi / 72.0 / step * rho;
      EXPECT_NEAR(std::abs(point.joints(5) - motion.waypoints[i - 1].joints(5)) /
                      (point.time - motion.waypoints[i - 1].time),
                  6.0 / rho * perChord, 1e-6);
    }
  }
  EXPECT_NEAR(radToDeg(6.0 / kRadius), 7.64, 0.005);
}

TEST(Hemisphere, polynomialOfDegreeOneFindsTheLaw) {
  // AT-31: b1 = −1 ± 1e-3 per radian of θ, Φ < 1e-8, for every degree.
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic_part_carried");
  toolpath::Toolpath path = hemisphere(kRadius, 1.0, 72);
  path.layers.erase(path.layers.begin(), path.layers.begin() + 20);
  path.layers.resize(1);
  for (int degree = 1; degree <= 4; ++degree) {
    MotionParams params;
    params.mode = RedundancyMode::Polynomial;
    params.polynomialDegree = degree;
    const Task task = taskOf(path, cell, params);
    const Resolution resolution = detail::resolvePolynomial(task, JobContext());
    const detail::Segment& segment = task.runs.segments[0];
    const double turned = resolution.choices[segment.last].torchRotation -
                          resolution.choices[segment.first].torchRotation;
    EXPECT_NEAR(turned / (2.0 * kPi), -1.0, 1e-3) << "degree " << degree;
    const Motion motion = detail::solveMotion(task, resolution, JobContext());
    EXPECT_LT(evaluateMotion(motion, cell, params).value(Objective::Motion), 1e-8);
    for (int joint = 0; joint < 5; ++joint) {
      EXPECT_LE(rangeInLayer(motion, 0, joint), 1e-4);
    }
  }
}

TEST(Hemisphere, optimizedKeepsEveryConstraint) {
  // AT-32 over all 71 layers, and joints 1 to 5 constant in each layer.
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic_part_carried");
  const toolpath::Toolpath path = hemisphere(kRadius, 1.0, 72);
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, {}, "op", context);
  EXPECT_TRUE(planned.statistics.evaluation.feasible());
  EXPECT_EQ(planned.statistics.mode, "optimized");
  EXPECT_LE(greatestOnBeads(planned, 4), degToRad(135.0));
  EXPECT_LT(planned.statistics.evaluation.value(Objective::Motion), 1e-5);
  for (int layer = 0; layer < 71; ++layer) {
    for (int joint = 0; joint < 5; ++joint) {
      EXPECT_LE(radToDeg(rangeInLayer(planned.motion, layer, joint)), 1e-2)
          << "layer " << layer << " joint " << joint + 1;
    }
  }
  for (const Waypoint& point : planned.motion.waypoints) {
    ASSERT_TRUE(point.reachable);
    ASSERT_LE((cell::T_part_tcp(cell, point.joints).matrix() - point.T_part_tcp.matrix()).norm(),
              1e-8);
  }
  EXPECT_EQ(context.diagnostics().count(Severity::Violation), 0U);
  EXPECT_EQ(context.diagnostics().count(Severity::Warning), 0U);
}

/// Circle P8 over the positioner, fitted set-up of A33: nominal lengths, level table, R_Z measured
/// from 180°, start at +Y, counter-clockwise.
cell::Cell circleCell() {
  cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  cell.positioner.joints.clear();
  cell.positioner.T_root_first = geometry::Pose::Identity();
  cell.positioner.T_root_first.translation() = Vec3(920.588, 820.862, -254.408);
  cell.positioner.T_last_tip = geometry::Pose::Identity();
  cell.T_table_part = geometry::Pose::Identity();
  return cell;
}

MotionParams circleParams(RedundancyMode mode) {
  MotionParams params;
  params.mode = mode;
  params.branch = BranchChoice::Nut;
  params.torchRotation = Angle(kPi);
  // The published plans know no cable.
  params.cableLimit = Angle(100.0 * kPi);
  params.setWeights(ownObjective(RedundancyMode::Polynomial));
  return params;
}

TEST(CircleOverThePositioner, objectiveOfConstantAndPublishedRotation) {
  // AT-34: 0.172 ± 0.003 and 0.099 ± 0.003.
  const cell::Cell cell = circleCell();
  const toolpath::Toolpath path = circleFrom(300, 385, Vec3::Zero(), kPi / 2);
  const MotionParams params = circleParams(RedundancyMode::Constant);
  EXPECT_NEAR(plan(path, cell, params).statistics.evaluation.value(Objective::Motion), 0.172,
              0.003);
  const Task task = taskOf(path, cell, params);
  Resolution resolution = detail::resolveConstant(task, JobContext());
  for (std::size_t i = task.runs.segments[0].first; i <= task.runs.segments[0].last; ++i) {
    const double m = task.targets[i].waypoint.point + 1.0;
    resolution.choices[i].torchRotation =
        kPi + degToRad(((5.7938e-6 * m - 0.0033) * m + 0.4343) * m - 31.7134);
  }
  const Motion motion = detail::solveMotion(task, resolution, JobContext());
  EXPECT_NEAR(evaluateMotion(motion, cell, params).value(Objective::Motion), 0.099, 0.003);
}

TEST(CircleOverThePositioner, polynomialsByMultiStart) {
  // AT-34: ≤ 0.136 / 0.132 / 0.108 / 0.087 / 0.085, not increasing with the degree.
  const cell::Cell cell = circleCell();
  const toolpath::Toolpath path = circleFrom(300, 385, Vec3::Zero(), kPi / 2);
  constexpr double kBounds[] = {0.136, 0.132, 0.108, 0.087, 0.085};
  double before = 1e9;
  for (int degree = 0; degree <= 4; ++degree) {
    MotionParams params = circleParams(RedundancyMode::Polynomial);
    params.polynomialDegree = degree;
    const Evaluation evaluation = plan(path, cell, params).statistics.evaluation;
    EXPECT_LE(evaluation.value(Objective::Motion), kBounds[degree]) << "degree " << degree;
    EXPECT_LE(evaluation.value(Objective::Motion), before * (1.0 + 1e-9));
    EXPECT_EQ(evaluation.violations(), 0U);
    before = evaluation.value(Objective::Motion);
  }
  // The graph search with splines is at least as good as the best polynomial.
  const Evaluation optimized =
      plan(path, cell, circleParams(RedundancyMode::Optimized)).statistics.evaluation;
  EXPECT_LE(optimized.value(Objective::Motion), before);
  EXPECT_TRUE(optimized.feasible());
}

TEST(CircleOverThePositioner, constraintsHoldWithTheCableLimit) {
  // AT-34 with ψ active: every ψ ≤ 0 and Φ ≤ Φ of the best feasible constant rotation. The cable's
  // zero is the middle of its twist at constant rotation.
  const cell::Cell cell = circleCell();
  const toolpath::Toolpath path = circleFrom(300, 129, Vec3::Zero(), kPi / 2);
  MotionParams params = circleParams(RedundancyMode::Constant);
  const PlannedMotion constant = plan(path, cell, params);
  double low = 1e9;
  double high = -1e9;
  for (const Waypoint& point : constant.motion.waypoints) {
    if (point.point >= 0) {
      low = std::min(low, point.joints(3) + point.joints(5));
      high = std::max(high, point.joints(3) + point.joints(5));
    }
  }
  params.cableZero = Angle(0.5 * (low + high));
  params.cableLimit = Angle(degToRad(120.0));
  double bestConstant = 1e9;
  for (int k = 0; k < 36; ++k) {
    params.torchRotation = Angle(degToRad(10.0 * k));
    const Evaluation own = plan(path, cell, params).statistics.evaluation;
    if (own.feasible()) {
      bestConstant = std::min(bestConstant, own.value(Objective::Motion));
    }
  }
  ASSERT_LT(bestConstant, 1e9);
  params.mode = RedundancyMode::Optimized;
  params.torchRotation = Angle(kPi);
  const PlannedMotion optimized = plan(path, cell, params);
  EXPECT_TRUE(optimized.statistics.evaluation.feasible());
  EXPECT_LE(optimized.statistics.maxCableTwist, degToRad(120.0));
  EXPECT_LE(optimized.statistics.evaluation.value(Objective::Motion), bestConstant);
}

TEST(Optimized, tellsHowFarItIs) {
  std::vector<double> told;
  std::mutex mutex;
  const JobContext context({}, [&](double fraction, const std::string& /*label*/) {
    const std::lock_guard lock(mutex);
    told.push_back(fraction);
  });
  (void)planMotion(test::circles(3, 60, 40, Vec3(0, 0, 0)), shippedCell("fanuc_arcmate120ic"), {},
                   "op", context);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  // While the candidates are planned, from 0.1 to 0.8 of the whole.
  const auto between = std::count_if(
      told.begin(), told.end(), [](double fraction) { return fraction > 0.11 && fraction < 0.79; });
  EXPECT_GE(between, 5);
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.back(), 1.0);
}

TEST(Uncertainty, isTheRootOfTheTraceAndScalesWithSigma) {
  // AT-35.
  cell::Cell cell = circleCell();
  const toolpath::Toolpath path = circleFrom(300, 49, Vec3::Zero(), kPi / 2);
  MotionParams params = circleParams(RedundancyMode::Constant);
  params.jointResolution = Angle(degToRad(1e-4));
  const PlannedMotion planned = plan(path, cell, params);
  double mean = 0.0;
  std::size_t count = 0;
  for (const Waypoint& point : planned.motion.waypoints) {
    if (point.point >= 0) {
      const Eigen::Matrix<double, 3, 6> j =
          cell::robotJacobian(cell, point.joints).topRows<3>() * degToRad(1e-4) * 1e3;
      mean += (j * j.transpose()).trace();
      ++count;
    }
  }
  mean /= static_cast<double>(count);
  const double value = planned.statistics.evaluation.value(Objective::Uncertainty);
  EXPECT_NEAR(value, mean, 1e-9 * mean);
  params.jointResolution = Angle(degToRad(3e-4));
  EXPECT_NEAR(plan(path, cell, params).statistics.evaluation.value(Objective::Uncertainty),
              9.0 * value, 1e-9 * value);
  // The whole cell turned: the same joints, the same uncertainty.
  const geometry::Pose turned(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  const Motion motion = planned.motion;
  cell.robot.T_root_first = turned * cell.robot.T_root_first;
  cell::prepareArm(cell);
  params.jointResolution = Angle(degToRad(1e-4));
  EXPECT_NEAR(evaluateMotion(motion, cell, params).value(Objective::Uncertainty), value,
              1e-9 * value);
}

TEST(Uncertainty, optimisingDoesNotIncreaseIt) {
  const cell::Cell cell = circleCell();
  const toolpath::Toolpath path = circleFrom(300, 97, Vec3::Zero(), kPi / 2);
  MotionParams params = circleParams(RedundancyMode::Constant);
  ObjectiveValues weights{};
  weights[static_cast<std::size_t>(Objective::Uncertainty)] = 1.0;
  params.setWeights(weights);
  const double before = plan(path, cell, params).statistics.evaluation.cost;
  params.mode = RedundancyMode::Optimized;
  const Evaluation after = plan(path, cell, params).statistics.evaluation;
  EXPECT_LE(after.cost, before);
  EXPECT_TRUE(after.feasible());
}

TEST(PointByPoint, isRougherThanTheLayerAsAWhole) {
  // AT-36: both inside all limits; the greatest second difference of each axis is smaller by layer.
  const cell::Cell cell = circleCell();
  const toolpath::Toolpath path = circleFrom(300, 193, Vec3::Zero(), kPi / 2);
  const auto roughest = [](const PlannedMotion& planned) {
    double worst = 0.0;
    const auto& points = planned.motion.waypoints;
    for (std::size_t i = 2; i < points.size(); ++i) {
      if (points[i].point >= 2) {
        worst =
            std::max(worst, (points[i].joints - 2.0 * points[i - 1].joints + points[i - 2].joints)
                                .cwiseAbs()
                                .maxCoeff());
      }
    }
    return worst;
  };
  const PlannedMotion byPoint = plan(path, cell, circleParams(RedundancyMode::PointByPoint));
  const PlannedMotion byLayer = plan(path, cell, circleParams(RedundancyMode::Polynomial));
  EXPECT_EQ(byPoint.statistics.evaluation.violations(), 0U);
  EXPECT_EQ(byLayer.statistics.evaluation.violations(), 0U);
  EXPECT_LT(roughest(byLayer), roughest(byPoint));
  EXPECT_LE(byLayer.statistics.evaluation.value(Objective::Motion),
            byPoint.statistics.evaluation.value(Objective::Motion));
}

}  // namespace
}  // namespace wcam::motion
