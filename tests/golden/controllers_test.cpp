// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/json.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/project/run.hpp"

#include "controller_models.hpp"
#include "example_project.hpp"
#include "krl_reader.hpp"
#include "ls_reader.hpp"
#include <gtest/gtest.h>

/// What the controllers will make of the programs: joint program and Cartesian program of one plan
/// lead to the same places, through the kinematics of the make and the frames that the programs
/// themselves say they were planned with.
namespace wcam {
namespace {

using Eigen::Isometry3d;

struct Controller {
  std::string cell;
  std::string post;
  std::string other;  ///< a post-processor of another make
};

void PrintTo(const Controller& c, std::ostream* out) {
  *out << c.cell;
}

project::Document withCell(const project::Document& document, const std::string& cell) {
  return project::apply(document, {"cell.set", parseJson(R"({"file": {"path": "wcam:cells/)" +
                                                         cell + R"(.json", "sha256": ""}})")});
}

class Controllers : public ::testing::TestWithParam<Controller> {
protected:
  void SetUp() override {
    project::Document document = withCell(test::exampleDocument("elbow"), GetParam().cell);
    // A torch that leans: no axis rests at 0, where status and turn say nothing.
    for (const char* key : {"lead", "lateral_tilt"}) {
      document = project::apply(
          document,
          {"operation.set_param",
           Value::object({{"id", "planar"}, {"section", "path"}, {"key", key}, {"value", 7.0}})});
    }
    pipeline_.emplace(document, test::exampleFile("elbow"), test::hostOfPlugins());
    result_ = pipeline_->compute("planar", JobContext());
  }

  [[nodiscard]] project::PrintedOutput print(const std::string& post,
                                             const std::string& params) const {
    project::Output output;
    output.id = "test";
    output.post = post;
    output.params = parseJson(params);
    return project::printOutput(*pipeline_, output, result_, JobContext());
  }

  [[nodiscard]] test::ReadJob read(const std::string& params) const {
    const project::PrintedOutput printed = print(GetParam().post, params);
    EXPECT_FALSE(printed.error.has_value()) << printed.error->what();
    std::vector<std::pair<std::string, std::string>> files;
    for (const plugin::OutputFile& file : printed.files) {
      files.emplace_back(file.name, file.content);
    }
    return kuka() ? test::readKrl(files) : test::readLs(files);
  }

  [[nodiscard]] bool kuka() const { return GetParam().post == "wcam.post.kuka"; }

  /// The frame that Cartesian positions are in, in the robot base.
  [[nodiscard]] Isometry3d frameOf(const test::ReadJob& job, const test::ReadMove& move) const {
    const auto found = job.frames.find(move.base);
    const Isometry3d frame = found == job.frames.end() ? Isometry3d::Identity() : found->second;
    if (!move.coupled) {
      return frame;
    }
    return job.frames.at("MACHINE_DEF[2].ROOT") *
           test::tableFromRoot(GetParam().cell, move.external) * frame;
  }

  /// Where the controller's tool frame comes to, in the robot base.
  [[nodiscard]] Isometry3d toolOf(const test::ReadJob& job, const test::ReadMove& move) const {
    if (move.cartesian) {
      return frameOf(job, move) * move.pose;
    }
    return test::controllerModel(GetParam().cell).flangeAt(move.joints) * job.frames.at(move.tool);
  }

  std::optional<project::Pipeline> pipeline_;
  project::OperationResult result_;
};

TEST_P(Controllers, JointAndCartesianProgramMeet) {
  const test::ReadJob joint = read(R"({"mode": "joint"})");
  const test::ReadJob cartesian = read(R"({"mode": "cartesian", "ptp_positions": "cartesian"})");
  EXPECT_EQ(joint.problems, std::vector<std::string>{});
  EXPECT_EQ(cartesian.problems, std::vector<std::string>{});
  ASSERT_EQ(joint.moves.size(), cartesian.moves.size());
  ASSERT_GT(joint.moves.size(), 100U);
  double farthest = 0.0;
  double turned = 0.0;
  std::size_t poses = 0;
  for (std::size_t i = 0; i < joint.moves.size(); ++i) {
    ASSERT_EQ(joint.moves[i].joints.size(), 6U);
    poses += cartesian.moves[i].cartesian ? 1U : 0U;
    const Isometry3d a = toolOf(joint, joint.moves[i]);
    const Isometry3d b = toolOf(cartesian, cartesian.moves[i]);
    farthest = std::max(farthest, (a.translation() - b.translation()).norm());
    turned = std::max(turned, Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle());
  }
  EXPECT_LT(farthest, 0.01);
  EXPECT_LT(radToDeg(turned), 0.01);
  EXPECT_GT(poses, joint.moves.size() / 2);
}

/// The wire's tip on the part, as the joint program leads it there, is the toolpath.
TEST_P(Controllers, TheWireMeetsThePath) {
  const test::ReadJob job = read(R"({"mode": "joint"})");
  const auto& waypoints = result_.motion->motion.waypoints;
  ASSERT_EQ(job.moves.size(), waypoints.size());
  const bool carried = result_.cell->partCarried();
  double farthest = 0.0;
  std::size_t met = 0;
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    if (!waypoints[i].reachable) {
      continue;
    }
    ++met;
    const Isometry3d tool = toolOf(job, job.moves[i]);
    const std::string fixed = kuka() ? "BASE_DATA[1]" : "UFRAME[1]";
    const std::string root = kuka() ? "MACHINE_DEF[2].ROOT" : "Positioner";
    const Isometry3d torch = carried ? job.frames.at(fixed) : tool;
    Isometry3d table = tool;
    if (!carried) {
      // A fixed table stands where the cell has it; a turning one where the program says.
      table = job.moves[i].external.empty()
                  ? Isometry3d(cell::T_base_table(*result_.cell, waypoints[i].joints))
                  : Isometry3d(job.frames.at(root) *
                               test::tableFromRoot(GetParam().cell, job.moves[i].external));
    }
    const Isometry3d T_part_tcp = (table * result_.cell->T_table_part).inverse() * torch;
    farthest = std::max(farthest,
                        (T_part_tcp.translation() - waypoints[i].T_part_tcp.translation()).norm());
  }
  EXPECT_LT(farthest, 0.01);
  EXPECT_GT(met, 100U);
}

class KukaControllers : public Controllers {};

/// S and T of the Cartesian program are those of the joints: bit 1 of S by axis 3, bit 2 by axis 5,
/// bits of T by the signs.
TEST_P(KukaControllers, StatusAndTurnAreThoseOfTheJoints) {
  const test::ReadJob joint = read(R"({"mode": "joint"})");
  const test::ReadJob cartesian = read(R"({"mode": "cartesian", "ptp_positions": "cartesian"})");
  ASSERT_EQ(joint.moves.size(), cartesian.moves.size());
  std::size_t checked = 0;
  for (std::size_t i = 0; i < joint.moves.size(); ++i) {
    const std::string& status = cartesian.moves[i].configuration;
    if (status.empty()) {
      continue;
    }
    ++checked;
    const std::vector<double>& axes = joint.moves[i].joints;
    // Within the angle of the offset between axes 3 and 4 (3 degrees) the arm is stretched.
    if (std::abs(axes[2]) > 4.0) {
      EXPECT_EQ(status[1] == '1', axes[2] > 0.0) << axes[2];
    }
    EXPECT_EQ(status[0] == '1', axes[4] < 0.0) << axes[4];
    ASSERT_EQ(cartesian.moves[i].turns.size(), 6U);
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_EQ(cartesian.moves[i].turns[k] == 1, axes[k] < 0.0) << k << " " << axes[k];
    }
  }
  EXPECT_GT(checked, 0U);
}

TEST_P(Controllers, AnotherMakeIsWarned) {
  const project::PrintedOutput printed = print(GetParam().other, "{}");
  EXPECT_FALSE(printed.error.has_value());
  EXPECT_FALSE(printed.files.empty());
  ASSERT_FALSE(printed.findings.empty());
  EXPECT_EQ(printed.findings[0].code, "post.other_controller");
  EXPECT_EQ(printed.findings[0].severity, Severity::Warning);
  EXPECT_NE(toLine(printed.findings[0]).find(result_.program->cell.controller), std::string::npos);
  for (const Diagnostic& finding : print(GetParam().post, "{}").findings) {
    EXPECT_NE(finding.code, "post.other_controller");
  }
}

INSTANTIATE_TEST_SUITE_P(
    ShippedCells,
    Controllers,
    ::testing::Values(Controller{"fanuc_arcmate120ic", "wcam.post.fanuc", "wcam.post.kuka"},
                      Controller{"fanuc_arcmate120ic_part_carried", "wcam.post.fanuc",
                                 "wcam.post.kuka"},
                      Controller{"kuka_kr16", "wcam.post.kuka", "wcam.post.fanuc"},
                      Controller{"kuka_kr16_part_carried", "wcam.post.kuka", "wcam.post.fanuc"},
                      Controller{"kuka_kr16_positioner", "wcam.post.kuka", "wcam.post.fanuc"},
                      Controller{"kuka_kr360_platter", "wcam.post.kuka", "wcam.post.fanuc"},
                      Controller{"kuka_kr360_part_carried", "wcam.post.kuka", "wcam.post.fanuc"}));

INSTANTIATE_TEST_SUITE_P(
    ShippedCells,
    KukaControllers,
    ::testing::Values(Controller{"kuka_kr16", "wcam.post.kuka", "wcam.post.fanuc"},
                      Controller{"kuka_kr16_part_carried", "wcam.post.kuka", "wcam.post.fanuc"},
                      Controller{"kuka_kr16_positioner", "wcam.post.kuka", "wcam.post.fanuc"},
                      Controller{"kuka_kr360_platter", "wcam.post.kuka", "wcam.post.fanuc"},
                      Controller{"kuka_kr360_part_carried", "wcam.post.kuka", "wcam.post.fanuc"}));

}  // namespace
}  // namespace wcam
