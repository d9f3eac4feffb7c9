// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The optimised motion is never worse than any named mode on that mode's own objective, and turns
// tubes upright without breaking a constraint.

#include "wcam/base/file_io.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/unwrap.hpp"
#include "wcam/motion/plan.hpp"
#include "wcam/process/process.hpp"
#include "wcam/project/pipeline.hpp"
#include "wcam/project/project_file.hpp"

#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace wcam::motion {
namespace {

using geometry::Vec3;

cell::Cell shippedCell(const std::string& name) {
  return cell::loadCell(std::string(WCAM_RESOURCES) + "/cells/" + name + ".json");
}

/// Every named mode against the optimised one with the mode's own objective.
void expectNeverWorse(const toolpath::Toolpath& path, const cell::Cell& cell) {
  std::vector<std::pair<ObjectiveValues, Evaluation>> optimized;
  for (int m = 1; m < kRedundancyModes; ++m) {
    MotionParams params;
    params.mode = static_cast<RedundancyMode>(m);
    params.setWeights(ownObjective(params.mode));
    Evaluation named;
    try {
      named = planMotion(path, cell, params, "op", JobContext()).statistics.evaluation;
    } catch (const Error&) {
      continue;  // refused: the cell has no positioner
    }
    const auto known = std::find_if(optimized.begin(), optimized.end(), [&params](const auto& o) {
      return o.first == params.weights();
    });
    Evaluation best;
    if (known != optimized.end()) {
      best = known->second;
    } else {
      MotionParams own = params;
      own.mode = RedundancyMode::Optimized;
      best = planMotion(path, cell, own, "op", JobContext()).statistics.evaluation;
      optimized.emplace_back(params.weights(), best);
    }
    EXPECT_FALSE(named.betterThan(best))
        << redundancyKey(params.mode) << ": cost " << named.cost << " with " << named.allBroken()
        << " broken, optimized " << best.cost << " with " << best.allBroken();
  }
}

/// The example's first operation with a constant rotation (so that computing it is quick).
project::Document quickExample(const std::string& file) {
  const Value tree = parseJson(readFile(file), file);
  Value operations = Value::array();
  for (Value operation : tree.at("operations").asArray()) {
    operations.push(operation.set("motion", Value::object({{"mode", "constant"}})));
  }
  Value changed = tree;
  return project::Document::parse(changed.set("operations", operations), file);
}

/// A few beads from the beginning, the middle and the end.
toolpath::Toolpath excerpt(const toolpath::Toolpath& path, std::size_t points) {
  toolpath::Toolpath result;
  const std::size_t count = path.layers.size();
  for (const std::size_t l : {std::size_t{0}, count / 2, count - 1}) {
    toolpath::Layer layer = path.layers[l];
    layer.beads.resize(std::min<std::size_t>(layer.beads.size(), 2));
    for (toolpath::Bead& bead : layer.beads) {
      bead.points.resize(std::min(bead.points.size(), points));
    }
    result.layers.push_back(std::move(layer));
  }
  return result;
}

class ExampleProject : public ::testing::TestWithParam<const char*> {};

TEST_P(ExampleProject, OptimizedIsNeverWorseThanANamedMode) {
  const std::string file =
      std::string(WCAM_RESOURCES) + "/projects/" + GetParam() + "/" + GetParam() + ".wcam";
  const auto plugins =
      std::make_shared<const plugin::PluginHost>(plugin::defaultPluginSearch({}, false));
  const project::Document document = quickExample(file);
  const project::Pipeline pipeline(document, file, plugins,
                                   std::make_shared<project::StageCache>());
  const auto result = pipeline.compute(document.project().operations[0].id, JobContext());
  expectNeverWorse(excerpt(*result.path, 50), *result.cell);
}

INSTANTIATE_TEST_SUITE_P(All,
                         ExampleProject,
                         ::testing::Values("elbow", "hemisphere", "branches", "supportless"));

/// Beads of random shapes, leaning at random, with repeated points now and then.
toolpath::Toolpath randomPath(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  toolpath::Toolpath path;
  for (int l = 0; l < 2; ++l) {
    toolpath::Bead bead;
    Vec3 p(80 * unit(random), 80 * unit(random), 5.0 * (l + 1));
    double heading = kPi * unit(random);
    Vec3 up = Vec3(0.4 * unit(random), 0.4 * unit(random), 1.0);
    for (int i = 0; i < 25; ++i) {
      toolpath::PathPoint point;
      heading += 0.4 * unit(random) + (unit(random) > 0.9 ? kPi / 2 : 0.0);
      point.t = Vec3(std::cos(heading), std::sin(heading), 0.0);
      p += (unit(random) > 0.93 ? 0.0 : 3.0 + unit(random)) * point.t;
      up += Vec3(0.03 * unit(random), 0.03 * unit(random), 0.0);
      point.p = p;
      point.up = up.normalized();
      point.axis = point.up;
      point.speed = 8.0;
      bead.points.push_back(point);
    }
    path.layers.emplace_back();
    path.layers.back().beads.push_back(std::move(bead));
  }
  return path;
}

TEST(RandomPaths, OptimizedIsNeverWorseThanANamedMode) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const char* const names[] = {"fanuc_arcmate120ic", "yaskawa_ma1440_mt250",
                                 "fanuc_arcmate120ic_part_carried"};
    expectNeverWorse(randomPath(random), shippedCell(names[seed % 3]));
  }
}

struct Tube {
  const char* file;
  const char* strategy;
  const char* params;
};

class TubeOnThePositioner : public ::testing::TestWithParam<Tube> {};

TEST_P(TubeOnThePositioner, IsBuiltUprightInsideTheLimits) {
  const Tube& tube = GetParam();
  const auto part = io::importPart(std::string(WCAM_TEST_DATA) + "/formula/" + tube.file,
                                   io::ImportOptions{}, geometry::Pose::Identity(), JobContext())
                        .surface;
  const plugin::SliceInput input{{part}, test::plate(), nullptr, {0.05, 4.9}};
  const toolpath::SlicedLayers sliced = test::slice(tube.strategy, input, tube.params);
  toolpath::PathParams pathParams;
  pathParams.chordError = Length(0.05);
  const toolpath::Toolpath path = process::applyProcess(
      toolpath::buildToolpath(sliced, *input.substrate, pathParams, JobContext()),
      process::ProcessParams(), JobContext());
  const cell::Cell cell = shippedCell("fanuc_arcmate120ic");
  JobContext context;
  const PlannedMotion planned = planMotion(path, cell, {}, "op", context);
  const Evaluation& evaluation = planned.statistics.evaluation;
  // Not yet Constraint::Speed: where the build direction passes the table's axis closely the table
  // turns faster than it can, and the torch waits for it (motion.speed_limited).
  EXPECT_EQ(evaluation.allBroken(), evaluation.count(Constraint::Speed));
  EXPECT_EQ(context.diagnostics().count(Severity::Violation), 0U);
  EXPECT_LE(planned.statistics.maxVerticalError, degToRad(1.0));
  EXPECT_GE(planned.statistics.minDexterity, MotionParams().minDexterity);
  for (const Waypoint& point : planned.motion.waypoints) {
    ASSERT_TRUE(point.reachable);
    for (int j = 0; j < cell.jointCount(); ++j) {
      ASSERT_EQ(cell::limitExcess(cell.joint(j), point.joints(j)), 0.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    All,
    TubeOnThePositioner,
    ::testing::Values(Tube{"p4_quarter_torus.wsurf", "wcam.slicing.constant", R"({"step": 3.0})"},
                      Tube{"p6_tube.wsurf", "wcam.slicing.constant", R"({"step": 3.0})"}));

}  // namespace
}  // namespace wcam::motion
