// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Edits of toolpaths on whole projects: file, commands, pipeline, programs.
#include "wcam/toolpath/edits.hpp"

#include "wcam/base/json.hpp"
#include "wcam/base/sha256.hpp"
#include "wcam/base/text.hpp"
#include "wcam/project/history.hpp"
#include "wcam/project/report.hpp"
#include "wcam/project/run.hpp"

#include "example_project.hpp"
#include "krl_reader.hpp"
#include "ls_reader.hpp"
#include "random_source.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wcam::project {
namespace {

using ::testing::HasSubstr;
using toolpath::EditTypeInfo;
using toolpath::Toolpath;

Document with(const Document& document, const std::string& command, const std::string& args) {
  return apply(document, {command, parseJson(args)});
}

Document edited(const Document& document,
                const std::string& operation,
                const std::string& id,
                const std::string& type,
                const std::string& params) {
  return with(document, "edit.add",
              "{\"operation\": \"" + operation + "\", \"id\": \"" + id + "\", \"type\": \"" + type +
                  "\", \"params\": " + params + "}");
}

OperationResult compute(const Document& document,
                        const std::string& operation = "planar",
                        const std::shared_ptr<StageCache>& cache = std::make_shared<StageCache>()) {
  return Pipeline(document, test::exampleFile("elbow"), test::hostOfPlugins(), cache)
      .compute(operation, JobContext());
}

std::size_t count(const OperationResult& result, const std::string& code) {
  return static_cast<std::size_t>(
      std::count_if(result.findings.begin(), result.findings.end(),
                    [&](const Diagnostic& finding) { return finding.code == code; }));
}

/// Three of each kind, on the elbow.
Document manyEdits() {
  Document document = test::exampleDocument("elbow");
  document = edited(document, "planar", "seam", "move_seam",
                    R"({"first_layer": 2, "last_layer": 4, "length": 25.0})");
  document = edited(document, "planar", "slow", "set_speed",
                    R"({"factor": 0.8, "region": "half_space", "plane_point": [0, 3.3, 0],
                        "plane_normal": [0, 1, 0]})");
  document = edited(document, "planar", "cool", "pause", R"({"first_layer": 5, "time": 20.0})");
  document = edited(document, "planar", "taller", "repeat_layers",
                    R"({"first_layer": 1, "last_layer": 1, "count": 2})");
  return edited(document, "planar", "lean", "set_lead",
                R"({"first_layer": 3, "last_layer": 3, "angle": 6.0, "region": "length",
                    "from": 20.0, "to": 60.0})");
}

TEST(EditsOfProjects, AnEditDoesNotSliceAgain) {
  const auto cache = std::make_shared<StageCache>();
  const Document document = test::exampleDocument("elbow");
  (void)compute(document, "planar", cache);
  const Document slow = edited(document, "planar", "slow", "set_speed", R"({"factor": 0.5})");
  (void)compute(slow, "planar", cache);
  EXPECT_EQ(cache->runs("slice"), 1U);
  EXPECT_EQ(cache->runs("path"), 1U);
  EXPECT_EQ(cache->runs("edits"), 1U);
  EXPECT_EQ(cache->runs("process"), 2U);
  // Switched off it is as if it were not there; writing a default out changes nothing.
  (void)compute(
      with(slow, "edit.set", R"({"operation": "planar", "id": "slow", "enabled": false})"),
      "planar", cache);
  (void)compute(with(slow, "edit.set_param",
                     R"({"operation": "planar", "id": "slow", "key": "bead", "value": -1})"),
                "planar", cache);
  EXPECT_EQ(cache->runs("edits"), 1U);
  EXPECT_EQ(cache->runs("motion"), 2U);
}

TEST(EditsOfProjects, SurviveARegeneration) {
  Document document = edited(test::exampleDocument("elbow"), "planar", "cool", "pause",
                             R"({"first_layer": -1, "time": 33.0})");
  document =
      edited(document, "planar", "seam", "move_seam",
             R"({"first_layer": 1, "last_layer": 1, "seam": "point", "point": [0, 900, 0]})");
  for (const double step : {5.0, 4.0, 9.0}) {
    document =
        apply(document, {"operation.set_param",
                         Value::object({{"id", "planar"}, {"key", "step"}, {"value", step}})});
    const OperationResult result = compute(document);
    const auto& layers = result.path->layers;
    EXPECT_EQ(layers.back().beads[0].pauseBefore, 33.0);
    double pauses = 0.0;
    for (const motion::Waypoint& point : result.motion->motion.waypoints) {
      pauses += point.pause;
    }
    EXPECT_EQ(pauses, 33.0) << step;
    const auto& points = layers[1].beads[0].points;
    double greatest = -1e9;
    for (const toolpath::PathPoint& point : points) {
      greatest = std::max(greatest, point.p.y());
    }
    EXPECT_NEAR(points.front().p.y(), greatest, 0.05) << step;
    EXPECT_EQ(count(result, "edit.selects_nothing"), 0U);
  }
}

TEST(EditsOfProjects, OneWireSpeedForAllIsThatOfTheProgram) {
  const Document plain = test::exampleDocument("elbow");
  const double before = compute(plain).program->process.wireSpeed;
  const OperationResult result =
      compute(edited(plain, "planar", "more", "set_wire", R"({"factor": 1.25})"));
  EXPECT_NEAR(result.program->process.wireSpeed, 1.25 * before, 1e-9);
}

TEST(EditsOfProjects, WhatFindsNothingIsTold) {
  const Document document = edited(test::exampleDocument("elbow"), "planar", "high", "set_speed",
                                   R"({"first_layer": 500, "last_layer": 501, "factor": 0.5})");
  const OperationResult result = compute(document);
  ASSERT_EQ(count(result, "edit.selects_nothing"), 1U);
  for (const Diagnostic& finding : result.findings) {
    if (finding.code == "edit.selects_nothing") {
      EXPECT_THAT(finding.message, HasSubstr("'high' (set_speed)"));
      EXPECT_EQ(finding.place.operation, "planar");
      EXPECT_EQ(finding.severity, Severity::Warning);
      EXPECT_FALSE(finding.remedy.empty());
    }
  }
  EXPECT_FALSE(result.program->instructions.empty());
}

TEST(EditsOfProjects, ThePauseReachesEveryPost) {
  Document document = edited(test::exampleDocument("elbow"), "planar", "cool", "pause",
                             R"({"first_layer": 3, "last_layer": 5, "time": 17.25})");
  document = edited(document, "planar", "cut", "pause",
                    R"({"first_layer": 7, "last_layer": 7, "where": "at_length", "length": 40.0,
                        "time": 2.5})");
  const Pipeline pipeline(document, test::exampleFile("elbow"), test::hostOfPlugins());
  const OperationResult plain = compute(test::exampleDocument("elbow"));
  const OperationResult result = pipeline.compute("planar", JobContext());
  const auto filesOf = [&](const std::string& post, const OperationResult& of) {
    std::vector<std::pair<std::string, std::string>> files;
    for (const plugin::OutputFile& file :
         pipeline.post({post, post, {}, Value::object(), {}}, of, JobContext())) {
      files.emplace_back(file.name, file.content);
    }
    return files;
  };
  const auto pausesIn = [](const std::vector<double>& waits, double seconds) {
    return std::count_if(waits.begin(), waits.end(),
                         [&](double wait) { return std::abs(wait - seconds) < 0.011; });
  };
  const test::ReadJob ls = test::readLs(filesOf("wcam.post.fanuc", result));
  const test::ReadJob krl = test::readKrl(filesOf("wcam.post.kuka", result));
  for (const test::ReadJob* job : {&ls, &krl}) {
    EXPECT_TRUE(job->problems.empty()) << joinText(job->problems, "\n");
    EXPECT_EQ(pausesIn(job->waits, 17.25), 3);
    EXPECT_EQ(pausesIn(job->waits, 2.5), 1);
  }
  const auto arcs = [](const OperationResult& of) {
    std::size_t starts = 0;
    for (const program::Instruction& instruction : of.program->instructions) {
      starts += std::holds_alternative<program::ArcOn>(instruction.action) ? 1U : 0U;
    }
    return starts;
  };
  EXPECT_EQ(arcs(result), arcs(plain) + 1);
  // The arc never burns while the torch waits, and time passes.
  bool burning = false;
  for (const program::Instruction& instruction : result.program->instructions) {
    burning = (burning || std::holds_alternative<program::ArcOn>(instruction.action)) &&
              !std::holds_alternative<program::ArcOff>(instruction.action);
    EXPECT_FALSE(burning && std::holds_alternative<program::Wait>(instruction.action));
  }
  EXPECT_NEAR(
      result.motion->statistics.totalTime,
      result.motion->motion.waypoints.back().time + result.motion->motion.waypoints.back().pause,
      1e-9);
  EXPECT_GT(result.motion->statistics.totalTime,
            plain.motion->statistics.totalTime + 3 * 17.25 + 2.5);
}

TEST(EditsOfProjects, TheResultIsAlwaysTheSame) {
  const OperationResult first = compute(manyEdits());
  const OperationResult again = compute(manyEdits());
  EXPECT_EQ(operationTable(first), operationTable(again));
  EXPECT_EQ(count(first, "edit.selects_nothing"), 0U);
  const OperationResult plain = compute(test::exampleDocument("elbow"));
  EXPECT_EQ(first.path->layers.size(), plain.path->layers.size() + 2);
  // In numbers that do not change: what the edits make of the example.
  const process::ProcessStatistics s = process::processStatistics(*first.path, first.process);
  EXPECT_EQ(first.path->layers.size(), 14U);
  EXPECT_EQ(first.path->beadCount(), 14U);
  EXPECT_NEAR(s.length, 1385.1361212, 1e-6);
  EXPECT_NEAR(s.wireVolume, 61376.240346, 1e-5);
}

TEST(EditsOfProjects, UndoAndRedoGiveTheSameBytes) {
  History history(test::exampleDocument("elbow"));
  std::vector<std::string> states = {toCanonicalJson(history.current().tree())};
  for (const Command& command : std::vector<Command>{
           {"edit.add", parseJson(R"({"operation": "planar", "id": "a", "type": "reverse"})")},
           {"edit.add", parseJson(R"({"operation": "planar", "id": "b", "type": "pause",
                                      "index": 0, "params": {"time": 3}})")},
           {"edit.set", parseJson(R"({"operation": "planar", "id": "a", "enabled": false})")},
           {"edit.set_param",
            parseJson(R"({"operation": "planar", "id": "b", "key": "time", "value": 4})")},
           {"edit.move", parseJson(R"({"operation": "planar", "id": "a", "index": 0})")},
           {"edit.rename", parseJson(R"({"operation": "planar", "id": "a", "to": "c"})")},
           {"edit.remove", parseJson(R"({"operation": "planar", "id": "b"})")}}) {
    EXPECT_TRUE(history.apply(command)) << command.id;
    states.push_back(toCanonicalJson(history.current().tree()));
  }
  EXPECT_EQ(history.current().project().operation("planar")->edits[0].id, "c");
  EXPECT_FALSE(history.current().project().operation("planar")->edits[0].enabled);
  for (std::size_t i = states.size() - 1; i-- > 0;) {
    EXPECT_TRUE(history.undo());
    EXPECT_EQ(toCanonicalJson(history.current().tree()), states[i]);
  }
  for (std::size_t i = 1; i < states.size(); ++i) {
    EXPECT_TRUE(history.redo());
    EXPECT_EQ(toCanonicalJson(history.current().tree()), states[i]);
  }
}

/// Some of the parameters of a type, each in its range, not always with a sense together.
Value randomParams(toolpath::EditType type, wcam::testing::RandomSource& random) {
  Value values = Value::object();
  const auto integer = [&random](int from, int to) {
    return static_cast<std::int64_t>(random.below(static_cast<std::size_t>(to - from + 1))) + from;
  };
  const ParamSchema schema = toolpath::editSchema(type).params();
  for (const ParamDef& def : schema.defs()) {
    const std::string& key = def.info.key;
    if (random.chance(0.5)) {
      continue;
    }
    if (def.type == ParamType::Choice) {
      values.set(key, random.pick(def.info.choices).key);
    } else if (key == "first_layer" || key == "last_layer") {
      values.set(key, integer(-8, 15));
    } else if (key == "bead") {
      values.set(key, integer(-1, 1));
    } else if (key == "count") {
      values.set(key, integer(1, 3));
    } else if (def.type == ParamType::Vector3) {
      Value::Array vector;
      for (int i = 0; i < 3; ++i) {
        vector.emplace_back(random.real(-80.0, 80.0));
      }
      values.set(key, Value(vector));
    } else if (def.type == ParamType::Real) {
      values.set(key, random.real(std::max(def.info.min, -70.0), std::min(def.info.max, 90.0)));
    }
  }
  return values;
}

double lengthOf(const Toolpath& path) {
  double length = 0.0;
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::Bead& bead : layer.beads) {
      length += bead.length();
    }
  }
  return length;
}

void expectFit(const Toolpath& path) {
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::Bead& bead : layer.beads) {
      ASSERT_GE(bead.points.size(), 2U);
      for (const toolpath::PathPoint& point : bead.points) {
        ASSERT_TRUE(point.p.allFinite());
        ASSERT_NEAR(point.axis.norm(), 1.0, 1e-9);
        ASSERT_NEAR((point.t.cross(point.n) - point.b).norm(), 0.0, 1e-9);
        ASSERT_GT(point.speed, 0.0);
        ASSERT_TRUE(std::isfinite(point.wireSpeed) && point.wireSpeed >= 0.0);
        ASSERT_GT(point.width, 0.0);
      }
    }
  }
}

/// Random edits leave a path that can be built; those that leave the layers alone keep its length.
TEST(EditsOfProjects, RandomEditsStayValid) {
  const Document elbow = test::exampleDocument("elbow");
  for (const std::string operation : {"planar", "guide"}) {
    const OperationResult plain = compute(elbow, operation);
    const toolpath::PathParams params =
        toolpath::PathParams::schema().read(elbow.project().operation(operation)->path);
    for (const std::uint64_t seed : wcam::testing::testSeeds(60)) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      wcam::testing::RandomSource random(seed);
      Toolpath path = *plain.path;
      for (int k = 0; k < 4; ++k) {
        const EditTypeInfo& info = random.pick(toolpath::editTypes());
        const Value values = randomParams(info.type, random);
        if (!toolpath::validateEdit(info.type, values).empty()) {
          continue;
        }
        const double before = lengthOf(path);
        path = toolpath::applyEdit(path, toolpath::readEdit("random", info.type, values),
                                   params.zones(), JobContext());
        if (info.type != toolpath::EditType::DeleteLayers &&
            info.type != toolpath::EditType::RepeatLayers) {
          ASSERT_NEAR(lengthOf(path), before, 1e-9 * std::max(1.0, before))
              << info.key << " " << toCompactJson(values);
        }
      }
      ASSERT_NO_FATAL_FAILURE(
          expectFit(process::applyProcess(std::move(path), plain.process, JobContext())));
    }
  }
}

TEST(EditsOfProjects, NothingLeftIsNoCrash) {
  const Document document =
      edited(test::exampleDocument("elbow"), "planar", "none", "delete_layers", "{}");
  const OperationResult result = compute(document);
  EXPECT_TRUE(result.path->layers.empty());
  EXPECT_EQ(count(result, "edit.nothing_left"), 1U);
}

std::string errorOf(const std::string& edits) {
  Value tree = test::exampleDocument("elbow").tree();
  tree.findMutable("operations")->mutableArray()[0].set("edits", parseJson(edits));
  try {
    const Document document = Document::parse(std::move(tree));
    (void)Pipeline(document, test::exampleFile("elbow"), test::hostOfPlugins()).validate();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ProjectInvalid);
    return error.what();
  }
  return {};
}

TEST(EditsOfProjects, BadOnesAreRefusedWithTheirPlace) {
  EXPECT_EQ(errorOf(R"([{"id": "a", "type": "reverse", "x_note": 1, "params": {"x_own": 2}}])"),
            "");
  EXPECT_THAT(errorOf("{}"), HasSubstr("operations[0].edits: expected a list"));
  EXPECT_THAT(errorOf("[3]"), HasSubstr("operations[0].edits[0]: expected an object"));
  EXPECT_THAT(errorOf(R"([{"type": "reverse"}])"), HasSubstr("the key 'id' is missing"));
  EXPECT_THAT(errorOf(R"([{"id": "A b", "type": "reverse"}])"), HasSubstr("is no id"));
  EXPECT_THAT(errorOf(R"([{"id": "a"}])"), HasSubstr("the key 'type' is missing"));
  EXPECT_THAT(errorOf(R"([{"id": "a", "type": "revers"}])"),
              HasSubstr("operations[0].edits[0].type: 'revers' is no type of edit; did you mean "
                        "'reverse'?"));
  EXPECT_THAT(errorOf(R"([{"id": "a", "type": "reverse"}, {"id": "a", "type": "pause"}])"),
              HasSubstr("operations[0].edits[1].id"));
  EXPECT_THAT(errorOf(R"([{"id": "a", "type": "reverse", "enabled": 1}])"), HasSubstr("enabled"));
  EXPECT_THAT(errorOf(R"([{"id": "a", "type": "repeat_layers", "params": {"count": 0}}])"),
              HasSubstr("operations[0].edits[0].params.count"));
  EXPECT_THAT(errorOf(R"([{"id": "a", "type": "pause",
                           "params": {"first_layer": 9, "last_layer": 3}}])"),
              HasSubstr("operations[0].edits[0].params.last_layer: the range ends before"));
}

}  // namespace
}  // namespace wcam::project
