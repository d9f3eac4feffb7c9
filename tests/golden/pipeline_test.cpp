// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/pipeline.hpp"

#include "wcam/base/json.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/project/report.hpp"
#include "wcam/project/run.hpp"

#include "example_project.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

namespace wcam::project {
namespace {

Document with(const Document& document, const std::string& command, const std::string& args) {
  return apply(document, {command, parseJson(args)});
}

OperationResult compute(const Document& document,
                        const std::shared_ptr<StageCache>& cache,
                        const std::string& operation = "guide") {
  return Pipeline(document, test::exampleFile("elbow"), test::hostOfPlugins(), cache)
      .compute(operation, JobContext());
}

TEST(Pipeline, NothingIsComputedTwice) {
  const auto cache = std::make_shared<StageCache>();
  const Document document = test::exampleDocument("elbow");
  const OperationResult first = compute(document, cache);
  const OperationResult again = compute(document, cache);
  for (const char* stage : {"part", "slice", "path", "process", "cell", "motion", "program"}) {
    EXPECT_EQ(cache->runs(stage), 1U) << stage;
  }
  EXPECT_EQ(first.program, again.program);
  EXPECT_EQ(operationTable(first), operationTable(again));
  EXPECT_EQ(first.findings.size(),
            again.findings.size());  // findings come back with a stored result
}

TEST(Pipeline, JobsOnSeveralThreadsShareTheCache) {
  const Document document = test::exampleDocument("elbow");
  const auto cache = std::make_shared<StageCache>();
  const OperationResult part = compute(document, cache, "planar");
  std::vector<OperationResult> results(4);
  {
    // The operations share the part, whose faces and edges both evaluate.
    std::vector<std::jthread> jobs;
    for (std::size_t i = 0; i < results.size(); ++i) {
      jobs.emplace_back(
          [&, i] { results[i] = compute(document, cache, i % 2 == 0 ? "guide" : "planar"); });
    }
  }
  const OperationResult alone = compute(document, std::make_shared<StageCache>());
  EXPECT_EQ(operationTable(results[0]), operationTable(alone));
  EXPECT_EQ(operationTable(results[2]), operationTable(alone));
  EXPECT_EQ(operationTable(results[1]), operationTable(part));
}

TEST(Pipeline, ChangingTheSeamDoesNotSliceAgain) {
  const auto cache = std::make_shared<StageCache>();
  const Document document = test::exampleDocument("elbow");
  (void)compute(document, cache);
  const Document changed =
      with(document, "operation.set", R"({"id": "guide", "path": {"seam": "golden"}})");
  (void)compute(changed, cache);
  EXPECT_EQ(cache->runs("part"), 1U);
  EXPECT_EQ(cache->runs("slice"), 1U);
  EXPECT_EQ(cache->runs("path"), 2U);
  EXPECT_EQ(cache->runs("motion"), 2U);
}

TEST(Pipeline, ChangingTheStepKeepsTheImport) {
  const auto cache = std::make_shared<StageCache>();
  const Document document = test::exampleDocument("elbow");
  (void)compute(document, cache);
  (void)compute(with(document, "operation.set", R"({"id": "guide", "params": {"step": 4.0}})"),
                cache);
  EXPECT_EQ(cache->runs("part"), 1U);
  EXPECT_EQ(cache->runs("slice"), 2U);
}

TEST(Pipeline, WritingADefaultOutChangesNothing) {
  const auto cache = std::make_shared<StageCache>();
  const Document document = test::exampleDocument("elbow");
  (void)compute(document, cache);
  (void)compute(with(document, "operation.set", R"({"id": "guide", "path": {"lead": 0.0}})"),
                cache);
  EXPECT_EQ(cache->runs("path"), 1U);
}

TEST(Pipeline, SmallCacheForgetsTheOldest) {
  const auto cache = std::make_shared<StageCache>(1);
  const Document document = test::exampleDocument("elbow");
  (void)compute(document, cache);
  (void)compute(document, cache);
  EXPECT_EQ(cache->runs("slice"), 2U);
}

TEST(Pipeline, ResultsDoNotDependOnThreads) {
  std::vector<std::string> tables;
  std::vector<std::string> programs;
  const Document document = test::exampleDocument("elbow");
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    const Pipeline pipeline(document, test::exampleFile("elbow"), test::hostOfPlugins());
    const OperationResult result = pipeline.compute("planar", JobContext());
    tables.push_back(operationTable(result));
    programs.push_back(
        pipeline.post(document.project().outputs[0], result, JobContext())[0].content);
  }
  EXPECT_EQ(tables[0], tables[1]);
  EXPECT_EQ(tables[0], tables[2]);
  EXPECT_EQ(programs[0], programs[1]);
  EXPECT_EQ(programs[0], programs[2]);
}

TEST(Pipeline, ErrorsNameTheOperationAndTheRemedy) {
  const Document document = with(test::exampleDocument("elbow"), "operation.set",
                                 R"({"id": "planar", "params": {"step": 500.0}})");
  try {
    (void)compute(document, std::make_shared<StageCache>(), "planar");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::CheckFailed);
    EXPECT_NE(std::string(error.what()).find("operation 'planar'"), std::string::npos);
    EXPECT_FALSE(error.hint().empty());
  }
}

TEST(Pipeline, AllWrongParametersAreToldAtOnce) {
  Document document = with(test::exampleDocument("elbow"), "operation.set",
                           R"({"id": "planar", "params": {"step": -1.0, "first_layer": 1e9}})");
  document =
      with(document, "operation.set",
           R"({"id": "guide", "path": {"seam": "nowhere"}, "motion": {"travel_speed": "fast"}})");
  try {
    (void)Pipeline(document, test::exampleFile("elbow"), test::hostOfPlugins()).validate();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ProjectInvalid);
    for (const char* path : {"operations[0].params.step", "operations[0].params.first_layer",
                             "operations[1].path.seam", "operations[1].motion.travel_speed"}) {
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << path;
    }
  }
}

TEST(Pipeline, ProcessFileAndInlineParameters) {
  // The file's parameters hold, inline ones win.
  const Document document = with(
      test::exampleDocument("elbow"), "process.set",
      R"({"id": "steel", "file": {"path": "wcam:processes/steel_1.0mm.json", "sha256": ""}, "params": {"bead_width": 9.0}})");
  const OperationResult result = compute(document, std::make_shared<StageCache>());
  EXPECT_DOUBLE_EQ(result.process.wireDiameter.value(), 1.0);
  EXPECT_NEAR(result.process.wireSpeed.value(), 2300.0 / 60.0, 1e-9);
}

TEST(Pipeline, UnreachablePartIsAViolationAndGetsNoProgram) {
  const Document document =
      with(test::exampleDocument("elbow"), "part.set",
           R"({"id": "elbow", "placement": {"position_mm": [3000.0, 0.0, 0.0]}})");
  const Pipeline pipeline(document, test::exampleFile("elbow"), test::hostOfPlugins());
  RunRequest request;
  request.operations = {"planar"};
  request.folder = std::filesystem::path(::testing::TempDir()) / "unreachable";
  const RunResult result = runProject(pipeline, request, JobContext());
  EXPECT_EQ(result.exitCode(), 5);
  EXPECT_EQ(result.violations, 1U);
  EXPECT_TRUE(result.files.empty());
  EXPECT_TRUE(std::any_of(result.operations[0].findings.begin(),
                          result.operations[0].findings.end(),
                          [](const Diagnostic& d) { return d.code == "motion.unreachable"; }));
  std::filesystem::remove_all(request.folder);
}

TEST(Pipeline, MiddleOfASolidWallIsTheWorkingSurface) {
  Document document = test::exampleDocument("elbow");
  const std::string cup = std::string(WCAM_TEST_DATA) + "/step/cup.step";
  document = with(document, "part.add",
                  R"({"id": "cup", "file": {"path": ")" + cup + R"("}, "surface": "middle"})");
  document = with(document, "operation.add",
                  R"({"id": "wall", "strategy": "wcam.slicing.planar", "parts": ["cup"],
                      "substrate": "plate", "process": "steel", "params": {"step": 4}})");
  const OperationResult result = compute(document, std::make_shared<StageCache>(), "wall");
  const auto count = [&](const char* code) {
    return std::count_if(result.findings.begin(), result.findings.end(),
                         [&](const Diagnostic& finding) { return finding.code == code; });
  };
  EXPECT_EQ(count("part.wall_thickness"), 1);
  ASSERT_FALSE(result.path->layers.empty());
  for (const toolpath::Layer& layer : result.path->layers) {
    for (const toolpath::Bead& bead : layer.beads) {
      for (const toolpath::PathPoint& point : bead.points) {
        if (point.p.z() > 12.0) {
          // Halfway across the 6 mm of the cone, within the facets of the tessellation.
          EXPECT_NEAR(std::hypot(point.p.x(), point.p.y()), 30.0 + point.p.z() / 8.0 - 3.0, 0.1);
        }
      }
    }
  }
  // Words that are none, and both ways at once, are refused with their place.
  for (const char* wrong : {R"({"id": "cup", "surface": "left"})",
                            R"({"id": "cup", "surface": "outer", "faces": [0]})"}) {
    try {
      (void)with(document, "part.set", wrong);
      ADD_FAILURE() << wrong;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(".surface"), std::string::npos) << error.what();
    }
  }
}

TEST(Report, HasEveryFigureOfAnOperation) {
  const OperationResult result =
      compute(test::exampleDocument("elbow"), std::make_shared<StageCache>());
  const Value report = operationReport(result);
  // A quarter circle of 50 mm in steps of 5 mm: 16 of 4.909 mm end on its end.
  EXPECT_EQ(report.at("layers").asInteger(), 16);
  EXPECT_EQ(report.at("arc_starts").asInteger(), 16);
  const double step = 25.0 * kPi / 16.0;
  EXPECT_NEAR(report.at("layer_distance_mm").at("min").asReal(), 0.7 * step, 0.005);
  EXPECT_NEAR(report.at("layer_distance_mm").at("max").asReal(), 1.3 * step, 0.005);
  EXPECT_NEAR(report.at("deposited_volume_mm3").asReal() / report.at("wanted_volume_mm3").asReal(),
              1.0, 1e-9);
  EXPECT_EQ(report.at("joints").size(), 8U);
  EXPECT_GT(report.at("min_dexterity").asReal(), 0.05);
  EXPECT_GT(report.at("time_s").asReal(), report.at("arc_time_s").asReal());
}

}  // namespace
}  // namespace wcam::project
