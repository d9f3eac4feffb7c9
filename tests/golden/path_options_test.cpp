// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/project/report.hpp"

#include "example_project.hpp"
#include "krl_reader.hpp"
#include "ls_reader.hpp"
#include "test_folder.hpp"
#include <gtest/gtest.h>

/// Options of the path that must arrive in the robot program, and a path that comes back from its
/// own table.
namespace wcam::project {
namespace {

Document withOptions(const std::string& path, const std::string& motion = "{}") {
  return apply(test::exampleDocument("elbow"),
               {"operation.set", parseJson(R"({"id": "guide", "path": )" + path +
                                           R"(, "motion": )" + motion + "}")});
}

std::vector<std::pair<std::string, std::string>> filesOf(const Pipeline& pipeline,
                                                         const OperationResult& result,
                                                         const std::string& post) {
  Output output;
  output.id = "test";
  output.post = post;
  // KUKA's joint mode is a dry run.
  output.params = parseJson(R"({"mode": ")" +
                            std::string(post == "wcam.post.kuka" ? "cartesian" : "joint") + "\"}");
  std::vector<std::pair<std::string, std::string>> files;
  for (const plugin::OutputFile& file : pipeline.post(output, result, JobContext())) {
    files.emplace_back(file.name, file.content);
  }
  return files;
}

void expectArcs(const test::ReadJob& job, const OperationResult& result) {
  const auto& waypoints = result.motion->motion.waypoints;
  EXPECT_EQ(job.problems, std::vector<std::string>{});
  ASSERT_EQ(job.moves.size(), waypoints.size());
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    EXPECT_EQ(job.moves[i].arc, waypoints[i].arc) << "move " << i;
    // Joint moves of a bead say a part of the axes' speeds instead.
    if (waypoints[i].arc && job.moves[i].kind == test::ReadKind::Linear) {
      EXPECT_NEAR(job.moves[i].speed, waypoints[i].speed, 0.06) << "move " << i;
    }
  }
  EXPECT_EQ(job.arcSchedules.size(), result.path->beadCount());
}

TEST(PathOptions, ZonesArriveInTheRobotPrograms) {
  const Pipeline pipeline(
      withOptions(R"({"lead_in": 6, "lead_out": 4, "overlap": 5, "wipe": 10, "ramp_in": 8,
                      "ramp_in_speed": 0.7, "ramp_in_wire": 0.8, "ramp_out": 6,
                      "ramp_out_speed": 1.2})"),
      test::exampleFile("elbow"), test::hostOfPlugins());
  const OperationResult result = pipeline.compute("guide", JobContext());
  std::size_t offInBeads = 0;
  for (const motion::Waypoint& point : result.motion->motion.waypoints) {
    offInBeads += point.point > 0 && !point.arc ? 1U : 0U;
  }
  EXPECT_GE(offInBeads, 3 * result.path->beadCount());
  bool arc = false;
  std::size_t changes = 0;
  for (const program::Instruction& instruction : result.program->instructions) {
    arc = std::holds_alternative<program::ArcOn>(instruction.action) ||
          (arc && !std::holds_alternative<program::ArcOff>(instruction.action));
    changes += arc && std::holds_alternative<program::SetProcess>(instruction.action) ? 1U : 0U;
  }
  EXPECT_GE(changes, 5 * result.path->beadCount());
  expectArcs(test::readLs(filesOf(pipeline, result, "wcam.post.fanuc")), result);
  expectArcs(test::readKrl(filesOf(pipeline, result, "wcam.post.kuka")), result);
}

TEST(PathOptions, DirectLinksArriveInTheRobotPrograms) {
  const Pipeline pipeline(withOptions(R"({"axis": "global"})", R"({"link": "direct"})"),
                          test::exampleFile("elbow"), test::hostOfPlugins());
  const OperationResult result = pipeline.compute("guide", JobContext());
  std::size_t joints = 0;
  for (const motion::Waypoint& point : result.motion->motion.waypoints) {
    joints += point.kind == motion::MoveKind::Joint ? 1U : 0U;
  }
  EXPECT_LT(joints, result.path->beadCount());
  expectArcs(test::readLs(filesOf(pipeline, result, "wcam.post.fanuc")), result);
}

TEST(PathOptions, APathComesBackFromItsOwnTable) {
  const testing::TestFolder folder;
  const Pipeline pipeline(
      withOptions(R"({"axis": "local", "lead_in": 5, "wipe": 5, "seam": "golden"})"),
      test::exampleFile("elbow"), test::hostOfPlugins());
  const OperationResult first = pipeline.compute("guide", JobContext());
  writeFileAtomically(folder / "guide.csv", operationTable(first));
  const Document document =
      apply(test::exampleDocument("elbow"),
            {"operation.add", parseJson(R"({"id": "again", "strategy": "wcam.slicing.import",
                "parts": [], "substrate": "plate", "process": "steel",
                "file": {"path": ")" + (folder / "guide.csv").string() +
                                        R"("}})")});
  const Pipeline importing(document, test::exampleFile("elbow"), test::hostOfPlugins());
  (void)importing.validate();
  const OperationResult again = importing.compute("again", JobContext());
  ASSERT_EQ(again.path->layers.size(), first.path->layers.size());
  for (std::size_t l = 0; l < first.path->layers.size(); ++l) {
    ASSERT_EQ(again.path->layers[l].beads.size(), first.path->layers[l].beads.size());
    const toolpath::Bead& read = again.path->layers[l].beads[0];
    EXPECT_TRUE(read.closed);
    EXPECT_EQ(read.feature, toolpath::BeadFeature::Imported);
    std::vector<toolpath::PathPoint> body;
    for (const toolpath::PathPoint& point : first.path->layers[l].beads[0].points) {
      if (point.zone == toolpath::BeadZone::Body || point.zone == toolpath::BeadZone::LeadIn) {
        body.push_back(point);
      }
    }
    body.erase(body.begin());  // where the lead-in begins
    ASSERT_EQ(read.points.size(), body.size());
    for (std::size_t i = 0; i < body.size(); ++i) {
      EXPECT_EQ(read.points[i].p, body[i].p);
      EXPECT_LT((read.points[i].axis - body[i].axis).norm(), 2e-9);
      EXPECT_LT((read.points[i].n - body[i].n).norm(), 2e-9);
      EXPECT_NEAR(read.points[i].height, body[i].height, 1e-6);
      EXPECT_NEAR(read.points[i].distance, body[i].distance, 1e-6);
      EXPECT_NEAR(read.points[i].speed, body[i].speed, 1e-5);
    }
  }
}

TEST(PathOptions, ImportNeedsItsFileAndOthersNeedAPart) {
  const auto refused = [](const std::string& operation) {
    try {
      const Document document =
          apply(test::exampleDocument("elbow"), {"operation.add", parseJson(operation)});
      (void)Pipeline(document, test::exampleFile("elbow"), test::hostOfPlugins()).validate();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refused(R"({"id": "a", "strategy": "wcam.slicing.import", "parts": ["elbow"],
                        "substrate": "plate", "process": "steel"})")
                .find("needs a file"),
            std::string::npos);
  EXPECT_NE(refused(R"({"id": "a", "strategy": "wcam.slicing.planar", "parts": [],
                        "substrate": "plate", "process": "steel",
                        "file": {"path": "elbow.step"}})")
                .find("needs a part"),
            std::string::npos);
  EXPECT_NE(refused(R"({"id": "a", "strategy": "wcam.slicing.planar", "parts": [],
                        "substrate": "plate", "process": "steel"})")
                .find("at least one part"),
            std::string::npos);
}

}  // namespace
}  // namespace wcam::project
