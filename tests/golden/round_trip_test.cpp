// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/json.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/cell/inverse.hpp"
#include "wcam/cell/kinematics.hpp"

#include "example_project.hpp"
#include "krl_reader.hpp"
#include "ls_reader.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

/// Programs of the example projects, read back by readers that share nothing with the posts:
/// forward kinematics of what the text says must be what was planned (DESIGN 9).
namespace wcam {
namespace {

using project::OperationResult;

struct Case {
  std::string project;
  std::string operation;
  std::string cell;  ///< shipped cell file; empty: the project's own
  std::string mode = "constant";
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.project << "/" << c.operation << " " << c.cell;
}

class RoundTrip : public ::testing::TestWithParam<Case> {
protected:
  void SetUp() override {
    project::Document document = test::exampleDocument(GetParam().project);
    if (!GetParam().cell.empty()) {
      document = project::apply(
          document, {"cell.set", parseJson(R"({"file": {"path": "wcam:cells/)" + GetParam().cell +
                                           R"(.json", "sha256": ""}})")});
    }
    document = project::apply(document,
                              {"operation.set_param", Value::object({{"id", GetParam().operation},
                                                                     {"section", "motion"},
                                                                     {"key", "mode"},
                                                                     {"value", GetParam().mode}})});
    pipeline_.emplace(document, test::exampleFile(GetParam().project), test::hostOfPlugins());
    result_ = pipeline_->compute(GetParam().operation, JobContext());
    ASSERT_EQ(result_.motion->statistics.unreachableWaypoints, 0U);
  }

  std::vector<std::pair<std::string, std::string>> files(const std::string& post,
                                                         const std::string& params) const {
    project::Output output;
    output.id = "test";
    output.post = post;
    output.params = parseJson(params);
    std::vector<std::pair<std::string, std::string>> named;
    for (const plugin::OutputFile& file : pipeline_->post(output, result_, JobContext())) {
      named.emplace_back(file.name, file.content);
    }
    return named;
  }

  [[nodiscard]] cell::JointVector jointsOf(const test::ReadMove& move) const {
    cell::JointVector q(result_.cell->jointCount());
    for (std::size_t j = 0; j < move.joints.size(); ++j) {
      q[static_cast<Eigen::Index>(j)] = degToRad(move.joints[j]);
    }
    for (std::size_t j = 0; j < move.external.size(); ++j) {
      q[static_cast<Eigen::Index>(move.joints.size() + j)] = degToRad(move.external[j]);
    }
    return q;
  }

  /// Joint mode: both cells, all axes.
  void expectJointsReturnThePlan(const test::ReadJob& job, bool dryRun = false) const {
    const auto& waypoints = result_.motion->motion.waypoints;
    EXPECT_EQ(job.problems, std::vector<std::string>{});
    ASSERT_EQ(job.moves.size(), waypoints.size());
    double worstPosition = 0.0;
    double worstAngle = 0.0;
    for (std::size_t i = 0; i < waypoints.size(); ++i) {
      ASSERT_EQ(job.moves[i].joints.size() + job.moves[i].external.size(),
                static_cast<std::size_t>(result_.cell->jointCount()));
      const geometry::Pose read = cell::T_part_tcp(*result_.cell, jointsOf(job.moves[i]));
      worstPosition = std::max(worstPosition,
                               (read.translation() - waypoints[i].T_part_tcp.translation()).norm());
      worstAngle = std::max(
          worstAngle,
          Eigen::AngleAxisd(read.linear().transpose() * waypoints[i].T_part_tcp.linear()).angle());
      EXPECT_EQ(job.moves[i].arc, waypoints[i].arc && !dryRun) << "move " << i;
    }
    EXPECT_LT(worstPosition, 0.01);
    EXPECT_LT(radToDeg(worstAngle), 0.001);
    EXPECT_EQ(job.fewestJointDecimals, 4);
  }

  /// The posture that a move's configuration has to name, per FANUC; empty beside a singularity,
  /// where both are the same.
  [[nodiscard]] std::string postureOf(const motion::Waypoint& waypoint) const {
    const cell::SingularityMeasures near = result_.cell->inverse->measures(waypoint.joints.data());
    const bool alike = near.wristSine < 1e-5 || near.elbowSine < 1e-5 || near.axisDistance < 1e-2;
    return alike ? "" : cell::branchOf(*result_.cell->arm, waypoint.joints.data()).name();
  }

  std::optional<project::Pipeline> pipeline_;
  OperationResult result_;
};

TEST_P(RoundTrip, PlannedTcpIsTheToolpath) {
  for (const motion::Waypoint& waypoint : result_.motion->motion.waypoints) {
    const geometry::Pose forward = cell::T_part_tcp(*result_.cell, waypoint.joints);
    EXPECT_LT((forward.translation() - waypoint.T_part_tcp.translation()).norm(), 1e-6);
    if (waypoint.point >= 0) {
      const toolpath::PathPoint& point =
          result_.path->layers[static_cast<std::size_t>(waypoint.layer)]
              .beads[static_cast<std::size_t>(waypoint.bead)]
              .points[static_cast<std::size_t>(waypoint.point)];
      EXPECT_LT((forward.translation() - point.p).norm(), 1e-6);
      EXPECT_LT((forward.linear().col(2) - point.axis).norm(), 1e-9);
    }
  }
}

TEST_P(RoundTrip, FanucJointMode) {
  expectJointsReturnThePlan(test::readLs(files("wcam.post.fanuc", R"({"mode": "joint"})")));
}

TEST_P(RoundTrip, KukaJointMode) {
  const test::ReadJob job = test::readKrl(files("wcam.post.kuka", R"({"mode": "joint"})"));
  expectJointsReturnThePlan(job, true);
}

TEST_P(RoundTrip, FanucCartesianMode) {
  const test::ReadJob job = test::readLs(files("wcam.post.fanuc", R"({"mode": "cartesian"})"));
  const auto& waypoints = result_.motion->motion.waypoints;
  EXPECT_EQ(job.problems, std::vector<std::string>{});
  ASSERT_EQ(job.moves.size(), waypoints.size());
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    if (!job.moves[i].cartesian) {
      EXPECT_EQ(job.moves[i].kind, test::ReadKind::Joint);  // beside a border of the turns
      continue;
    }
    // The language's rounding: 3 decimals of mm and degrees for the robot, of degrees for the
    // positioner's lever.
    const geometry::Pose planned = cell::T_base_tcp(*result_.cell, waypoints[i].joints);
    EXPECT_LT((job.moves[i].pose.translation() - planned.translation()).norm(), 0.001);
    EXPECT_LT(
        radToDeg(
            Eigen::AngleAxisd(job.moves[i].pose.linear().transpose() * planned.linear()).angle()),
        0.002);
    for (std::size_t j = 0; j < job.moves[i].external.size(); ++j) {
      EXPECT_NEAR(degToRad(job.moves[i].external[j]),
                  waypoints[i].joints[static_cast<Eigen::Index>(6 + j)], degToRad(0.00051));
    }
    const std::string posture = postureOf(waypoints[i]);
    if (!posture.empty()) {
      ASSERT_EQ(job.moves[i].configuration, posture) << "move " << i;
    }
  }
}

TEST_P(RoundTrip, KukaCartesianMode) {
  const test::ReadJob job = test::readKrl(
      files("wcam.post.kuka", R"({"mode": "cartesian", "ptp_positions": "cartesian"})"));
  const auto& waypoints = result_.motion->motion.waypoints;
  EXPECT_EQ(job.problems, std::vector<std::string>{});
  ASSERT_EQ(job.moves.size(), waypoints.size());
  int statuses = 0;
  int byAxes = 0;
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    if (!job.moves[i].cartesian) {
      // An axis at 0, whose turn bit would be chance.
      EXPECT_EQ(job.moves[i].kind, test::ReadKind::Joint);
      const auto& axes = job.moves[i].joints;
      EXPECT_TRUE(std::any_of(axes.begin(), axes.end(),
                              [](double value) { return std::abs(value) <= 0.00105; }));
      ++byAxes;
      continue;
    }
    // In the frame of the turning table, or of the robot where no table turns.
    const geometry::Pose T_base_frame = result_.cell->positionerJoints() > 0
                                            ? cell::T_base_table(*result_.cell, waypoints[i].joints)
                                            : geometry::Pose::Identity();
    const geometry::Pose planned =
        T_base_frame.inverse() * cell::T_base_tcp(*result_.cell, waypoints[i].joints);
    EXPECT_LT((job.moves[i].pose.translation() - planned.translation()).norm(), 0.001);
    EXPECT_LT(
        radToDeg(
            Eigen::AngleAxisd(job.moves[i].pose.linear().transpose() * planned.linear()).angle()),
        0.002);
    const std::string posture = postureOf(waypoints[i]);
    if (!job.moves[i].configuration.empty() && !posture.empty()) {
      ++statuses;
      EXPECT_EQ(job.moves[i].configuration.substr(1),
                std::string(posture[1] == 'U' ? "1" : "0") + (posture[2] == 'B' ? "1" : "0"))
          << "move " << i;
    }
  }
  EXPECT_GT(statuses + byAxes, 0);
}

TEST_P(RoundTrip, SpeedsAndArcsAreThoseOfTheProcess) {
  const test::ReadJob job = test::readLs(files("wcam.post.fanuc", R"({"mode": "joint"})"));
  const auto& waypoints = result_.motion->motion.waypoints;
  ASSERT_EQ(job.moves.size(), waypoints.size());
  EXPECT_EQ(job.arcSchedules.size(), result_.path->beadCount());
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    if (waypoints[i].arc) {
      EXPECT_NEAR(job.moves[i].speed, waypoints[i].speed, 0.0501);  // one decimal of mm/sec
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Examples,
                         RoundTrip,
                         ::testing::Values(Case{"elbow", "planar", ""},
                                           Case{"elbow", "guide", ""},
                                           Case{"elbow", "guide", "yaskawa_ma1440_mt250"},
                                           Case{"elbow", "guide", "kuka_kr16"},
                                           Case{"hemisphere", "hemisphere", ""},
                                           Case{"supportless", "supportless", ""}));

/// The best motion of this robot takes another configuration in some layers.
class ChangingRoundTrip : public RoundTrip {};

TEST_P(ChangingRoundTrip, FanucNamesTheConfigurationOfEachPosition) {
  const test::ReadJob job = test::readLs(files("wcam.post.fanuc", R"({"mode": "cartesian"})"));
  const auto& waypoints = result_.motion->motion.waypoints;
  EXPECT_EQ(job.problems, std::vector<std::string>{});
  ASSERT_EQ(job.moves.size(), waypoints.size());
  std::set<std::string> seen;
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const std::string posture = postureOf(waypoints[i]);
    if (!posture.empty() && job.moves[i].cartesian) {
      seen.insert(posture);
      ASSERT_EQ(job.moves[i].configuration, posture) << "move " << i;
    }
  }
  EXPECT_GT(seen.size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Examples,
                         ChangingRoundTrip,
                         ::testing::Values(Case{"elbow", "guide", "kuka_kr16", "optimized"}));

/// The robot carries the part under a fixed torch.
class PartCarriedRoundTrip : public RoundTrip {};

TEST_P(PartCarriedRoundTrip, FanucJointMode) {
  ASSERT_TRUE(result_.cell->partCarried());
  expectJointsReturnThePlan(test::readLs(files("wcam.post.fanuc", R"({"mode": "joint"})")));
}

INSTANTIATE_TEST_SUITE_P(
    Examples,
    PartCarriedRoundTrip,
    ::testing::Values(Case{"elbow", "planar", "fanuc_arcmate120ic_part_carried"},
                      Case{"elbow", "guide", "fanuc_arcmate120ic_part_carried"}));

}  // namespace
}  // namespace wcam
