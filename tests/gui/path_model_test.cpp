// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/kinematics.hpp"
#include "wcam/geometry/segment_tree.hpp"
#include "wcam/plugin/host.hpp"
#include "wcam/project/project_file.hpp"

#include "model/generation.hpp"
#include "model/program_text.hpp"
#include "model/shapes.hpp"
#include "quick_motion.hpp"
#include "sample_path.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace wcam::gui {
namespace {

/// The elbow example, computed once.
const Generated& elbow() {
  static const Generated result = [] {
    const std::filesystem::path file =
        std::filesystem::path(WCAM_RESOURCES) / "projects/elbow/elbow.wcam";
    const auto plugins =
        std::make_shared<const plugin::PluginHost>(plugin::defaultPluginSearch({}, false));
    const project::Pipeline pipeline(
        wcam::test::withQuickMotion(project::loadProject(file).document), file, plugins);
    return generate(pipeline, "guide", Generated(), JobContext(), [](const Generated&) {});
  }();
  return result;
}

const PathModel& planar() {
  return *elbow().operation("planar")->path;
}

TEST(Generation, GivesPartsAndOperationsTheWantedOneFirst) {
  const Generated& result = elbow();
  EXPECT_FALSE(result.error);
  ASSERT_EQ(result.parts.size(), 1U);
  EXPECT_TRUE(result.parts[0].mesh != nullptr);
  const viewport::MeshData mesh = meshOf(*result.parts[0].part->surface);
  EXPECT_FALSE(mesh.empty());
  EXPECT_GT(mesh.edgeBegin.size(), 1U) << "CAD edges are drawn";
  ASSERT_EQ(result.operations.size(), 2U);
  EXPECT_EQ(result.operations[0].id, "guide");
  EXPECT_TRUE(result.cell != nullptr);
}

TEST(PathModel, HasOneMovePerWaypointInOrder) {
  const PathModel& path = planar();
  const auto& waypoints = path.result().motion->motion.waypoints;
  ASSERT_EQ(path.size(), waypoints.size());
  EXPECT_EQ(path.layerCount(), static_cast<int>(path.result().path->layers.size()));
  EXPECT_EQ(path.layerBegin(0), 0U);
  EXPECT_EQ(path.layerBegin(path.layerCount()), path.size());
  std::size_t points = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    points += path.point(i) >= 0 ? 1 : 0;
    if (i > 0) {
      EXPECT_GE(path.layer(i), path.layer(i - 1));
      EXPECT_GE(path.time(i), path.time(i - 1));
    }
  }
  EXPECT_EQ(points, path.result().path->pointCount());
}

TEST(PathModel, FindsMovesByPlaceAndByTime) {
  const PathModel& path = planar();
  const std::size_t move = path.layerBegin(3) + 10;
  ASSERT_GE(path.point(move), 0);
  EXPECT_EQ(path.find(path.layer(move), path.bead(move), path.point(move)), move);
  EXPECT_EQ(path.layer(*path.find(3, -1, -1)), 3);
  EXPECT_FALSE(path.find(100000, 0, 0));
  EXPECT_FALSE(path.find(-1, 0, 0));
  const double time = path.time(move);
  EXPECT_EQ(path.time(path.moveAt(time)), time);
  EXPECT_EQ(path.moveAt(1e12), path.size() - 1);
  EXPECT_EQ(path.moveAt(-1.0), 0U);
}

TEST(PathModel, EveryQuantityOfThePlanHasFiniteValuesAtItsPoints) {
  const PathModel& path = planar();
  for (int q = 0; q < kQuantityCount; ++q) {
    const std::vector<float> values = path.values(static_cast<Quantity>(q));
    ASSERT_EQ(values.size(), path.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (path.point(i) >= 0) {
        ASSERT_TRUE(std::isfinite(values[i])) << "quantity " << q << " move " << i;
      }
    }
  }
  // The margins are those of the engine.
  const auto& statistics = path.result().motion->statistics;
  double margin = 1e9;
  for (const auto& joint : statistics.joints) {
    margin = std::min(margin, joint.margin);
  }
  const std::vector<float> margins = path.values(Quantity::LimitMargin);
  float least = 1e9F;
  for (const float m : margins) {
    least = std::isfinite(m) ? std::min(least, m) : least;
  }
  EXPECT_GE(least, static_cast<float>(margin * 180.0 / 3.14159265358979) - 1e-3F);
}

TEST(PathModel, DepositsExactlyWhereTheArcBurnsBetweenPointsOfABead) {
  const PathModel& path = planar();
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (path.data()->deposits[i] != 0) {
      ASSERT_EQ(path.bead(i), path.bead(i - 1));
      ASSERT_EQ(path.layer(i), path.layer(i - 1));
      length += (path.pathPoint(i)->p - path.pathPoint(i - 1)->p).norm();
    }
  }
  double wanted = 0.0;
  for (const auto& layer : path.result().path->layers) {
    for (const auto& bead : layer.beads) {
      wanted += bead.length();
    }
  }
  EXPECT_NEAR(length, wanted, 1e-6 * wanted);
}

TEST(ProgramText, TiesEveryMotionLineOfTheExportedLanguagesToItsMove) {
  const std::filesystem::path file =
      std::filesystem::path(WCAM_RESOURCES) / "projects/elbow/elbow.wcam";
  const auto plugins =
      std::make_shared<const plugin::PluginHost>(plugin::defaultPluginSearch({}, false));
  const project::Document document =
      wcam::test::withQuickMotion(project::loadProject(file).document);
  const project::Pipeline pipeline(document, file, plugins);
  for (const project::Output& output : document.project().outputs) {
    const ProgramText text =
        linkProgram(pipeline.post(output, planar().result(), JobContext()), planar());
    EXPECT_TRUE(text.linked) << output.id;
    std::int32_t last = -1;
    std::size_t lines = 0;
    for (const ProgramText::File& program : text.files) {
      for (const std::int32_t move : program.moveOfLine) {
        if (move >= 0) {
          EXPECT_GE(move, last) << output.id;
          last = move;
          ++lines;
        }
      }
    }
    EXPECT_EQ(lines, planar().size()) << output.id;
  }
}

TEST(ProgramText, AnUnknownLanguageIsNotTied) {
  const ProgramText text = linkProgram({{"a.txt", "hello\nworld\n"}, {"empty", ""}}, planar());
  EXPECT_FALSE(text.linked);
  ASSERT_EQ(text.files.size(), 2U);
  EXPECT_EQ(text.files[0].moveOfLine, (std::vector<std::int32_t>{-1, -1, -1}));
  // A program whose motion lines are too few is not tied to wrong moves.
  EXPECT_FALSE(linkProgram({{"a.ls", "   1:J P[1] 10% FINE ;\n"}}, planar()).linked);
  EXPECT_FALSE(linkProgram({}, *test::samplePath(2, 3)).linked);
}

TEST(Shapes, BodiesStandWhereTheKinematicsPutTheLinks) {
  const cell::Cell& cell = *elbow().cell;
  const auto& q = planar().result().motion->motion.waypoints[planar().size() / 2].joints;
  const auto bodies = bodiesOf(cell);
  const auto poses = bodyPoses(cell, q);
  ASSERT_EQ(bodies.size(), poses.size());
  const auto last = static_cast<std::size_t>(cell.robotJoints() - 1);
  const geometry::Pose T_base_flange = poses[last] * cell.robot.T_last_tip;
  EXPECT_TRUE(T_base_flange.isApprox(cell::T_base_flange(cell, q), 1e-12));
  EXPECT_TRUE(poses[poses.size() - 4].isApprox(cell::T_base_table(cell, q), 1e-12));
  EXPECT_TRUE(poses.back().isApprox(cell::T_base_tcp(cell, q), 1e-12));
  std::size_t drawn = 0;
  for (const viewport::Body& body : bodies) {
    drawn += body.solids.size() + body.meshes.size();
  }
  EXPECT_GT(drawn, 6U);
  // Without shapes of its own the cell is drawn along its links: each ends at the next joint.
  cell::Cell bare = cell;
  bare.shapes = {};
  const auto links = bodiesOf(bare);
  ASSERT_EQ(links.size(), poses.size());
  for (std::size_t i = 0; i < last; ++i) {
    const viewport::Solid& solid = links[i].solids.back();
    if (solid.kind == viewport::Solid::Kind::Capsule) {
      const geometry::Vec3 end = poses[i] * geometry::Vec3(solid.to[0], solid.to[1], solid.to[2]);
      EXPECT_NEAR((end - poses[i + 1].translation()).norm(), 0.0, 1e-9) << "joint " << i;
    }
  }
}

TEST(Shapes, RailsOfLinearJointsHoldTheirCarriagesAtAllValues) {
  for (const char* name : {"debout_5axis", "debout_7axis"}) {
    const cell::Cell cell =
        cell::loadCell(std::string(WCAM_RESOURCES) + "/cells/" + name + ".json");
    const auto bodies = bodiesOf(cell);
    const auto base = std::find_if(bodies.begin(), bodies.end(),
                                   [](const viewport::Body& b) { return b.name == "base"; });
    ASSERT_NE(base, bodies.end());
    for (const double part : {0.0, 0.3, 0.8, 1.0}) {
      cell::JointVector q = cell::JointVector::Zero(cell.jointCount());
      for (int j = 0; j < cell.robotJoints(); ++j) {
        const cell::Joint& joint = cell.joint(j);
        q(j) = joint.endless ? part : joint.min + part * (joint.max - joint.min);
      }
      const auto poses = bodyPoses(cell, q);
      for (int j = 0; j < cell.robotJoints(); ++j) {
        if (!cell.joint(j).prismatic()) {
          continue;
        }
        // The carriage lies on a capsule of the body before it.
        const viewport::Body& before = j == 0 ? *base : bodies[static_cast<std::size_t>(j - 1)];
        const geometry::Pose T_before =
            j == 0 ? geometry::Pose::Identity() : poses[static_cast<std::size_t>(j - 1)];
        const geometry::Vec3 at =
            T_before.inverse() * poses[static_cast<std::size_t>(j)].translation();
        double nearest = 1e9;
        for (const viewport::Solid& solid : before.solids) {
          if (solid.kind == viewport::Solid::Kind::Capsule) {
            nearest = std::min(nearest,
                               geometry::distanceToSegment(
                                   at, geometry::Vec3(solid.from[0], solid.from[1], solid.from[2]),
                                   geometry::Vec3(solid.to[0], solid.to[1], solid.to[2])));
            EXPECT_GT(solid.radius, 1.0);
          }
        }
        EXPECT_LT(nearest, 1e-6) << name << " joint " << j << " at " << part;
      }
    }
  }
}

TEST(Generation, KeepsTheErrorOfABrokenPartWithIt) {
  const std::filesystem::path file =
      std::filesystem::path(WCAM_RESOURCES) / "projects/elbow/other.wcam";
  const auto plugins =
      std::make_shared<const plugin::PluginHost>(plugin::defaultPluginSearch({}, false));
  const auto loaded =
      project::loadProject(std::filesystem::path(WCAM_RESOURCES) / "projects/elbow/elbow.wcam");
  const project::Document document = project::apply(
      loaded.document,
      {"part.set",
       Value::object({{"id", "elbow"},
                      {"file", Value::object({{"path", "missing.step"}, {"sha256", ""}})}})});
  const Generated result = generate(project::Pipeline(document, file, plugins), {}, Generated(),
                                    JobContext(), [](const Generated&) {});
  ASSERT_TRUE(result.error);
  EXPECT_EQ(result.error->code(), ErrorCode::InputNotFound);
  ASSERT_TRUE(result.parts[0].error);
  EXPECT_EQ(result.operations.size(), 2U);
  EXPECT_TRUE(result.operations[0].error);
}

TEST(Generation, KeepsWhatIsTheSame) {
  const std::filesystem::path file =
      std::filesystem::path(WCAM_RESOURCES) / "projects/elbow/elbow.wcam";
  const auto plugins =
      std::make_shared<const plugin::PluginHost>(plugin::defaultPluginSearch({}, false));
  const auto cache = std::make_shared<project::StageCache>();
  project::Document document = wcam::test::withQuickMotion(project::loadProject(file).document);
  const auto run = [&](const Generated& before) {
    return generate(project::Pipeline(document, file, plugins, cache), {}, before, JobContext(),
                    [](const Generated&) {});
  };
  const Generated first = run({});
  document = project::apply(
      document,
      {"operation.set_param", Value::object({{"id", "planar"}, {"key", "step"}, {"value", 9.0}})});
  const Generated second = run(first);
  EXPECT_EQ(second.parts[0].mesh, first.parts[0].mesh);
  EXPECT_EQ(second.operation("guide")->path, first.operation("guide")->path);
  EXPECT_NE(second.operation("planar")->path, first.operation("planar")->path);
}

TEST(Generation, KeepsTheLastPathOfAnOperationThatFails) {
  const std::filesystem::path file =
      std::filesystem::path(WCAM_RESOURCES) / "projects/elbow/elbow.wcam";
  const auto plugins =
      std::make_shared<const plugin::PluginHost>(plugin::defaultPluginSearch({}, false));
  const auto cache = std::make_shared<project::StageCache>();
  const project::Document good = wcam::test::withQuickMotion(project::loadProject(file).document);
  const auto run = [&](const project::Document& document, const Generated& before) {
    return generate(project::Pipeline(document, file, plugins, cache), {}, before, JobContext(),
                    [](const Generated&) {});
  };
  const auto with = [&](const char* section, const char* key, const Value& value) {
    return project::apply(
        good,
        {"operation.set_param",
         Value::object({{"id", "planar"}, {"section", section}, {"key", key}, {"value", value}})});
  };
  const Generated first = run(good, {});
  EXPECT_FALSE(first.operation("planar")->outdated);
  ASSERT_EQ(first.plates.size(), 1U);
  EXPECT_EQ(first.operation("planar")->substrate, first.plates[0].mesh);
  // No layers at all.
  const Generated second = run(with("params", "step", Value(-3.0)), first);
  EXPECT_TRUE(second.operation("planar")->error);
  EXPECT_EQ(second.operation("planar")->path, first.operation("planar")->path);
  EXPECT_TRUE(second.operation("planar")->outdated);
  EXPECT_FALSE(second.operation("guide")->outdated);
  // Twice in a row it is still the last one that there was.
  const Generated third = run(with("params", "step", Value(-4.0)), second);
  EXPECT_EQ(third.operation("planar")->path, first.operation("planar")->path);
  EXPECT_TRUE(third.operation("planar")->outdated);
  // The same beads without a motion: what was found of the motion is old.
  const Generated fourth = run(with("motion", "safe_height", Value(-1.0)), first);
  EXPECT_TRUE(fourth.operation("planar")->error);
  EXPECT_TRUE(fourth.operation("planar")->outdated);
  // New beads stand for themselves.
  project::Document noCell =
      project::apply(with("params", "step", Value(7.0)), {"cell.remove", Value::object({})});
  const Generated fifth = run(noCell, first);
  EXPECT_TRUE(fifth.operation("planar")->error);
  EXPECT_NE(fifth.operation("planar")->path, first.operation("planar")->path);
  EXPECT_FALSE(fifth.operation("planar")->outdated);
  // And it is over when the operation can be computed again.
  const Generated last = run(good, third);
  EXPECT_EQ(last.operation("planar")->path, first.operation("planar")->path);
  EXPECT_FALSE(last.operation("planar")->outdated);
}

TEST(Generation, ShowsBeadsBeforeTheirMotionAndWithoutACell) {
  const std::filesystem::path file =
      std::filesystem::path(WCAM_RESOURCES) / "projects/elbow/elbow.wcam";
  const auto plugins =
      std::make_shared<const plugin::PluginHost>(plugin::defaultPluginSearch({}, false));
  const project::Document whole = wcam::test::withQuickMotion(project::loadProject(file).document);
  std::vector<bool> motions;
  const auto record = [&](const Generated& partial) {
    if (const GeneratedOperation* shown = partial.operation("planar")) {
      ASSERT_TRUE(shown->path);
      EXPECT_GT(shown->path->size(), 100U);
      motions.push_back(shown->path->result().motion != nullptr);
    }
  };
  generate(project::Pipeline(whole, file, plugins), "planar", Generated(), JobContext(), record);
  ASSERT_GE(motions.size(), 2U);
  EXPECT_FALSE(motions.front()) << "the beads are there first";
  EXPECT_TRUE(motions.back());

  const project::Document document = project::apply(whole, {"cell.remove", Value::object({})});
  const Generated result = generate(project::Pipeline(document, file, plugins), {}, Generated(),
                                    JobContext(), [](const Generated&) {});
  const GeneratedOperation* shown = result.operation("planar");
  ASSERT_TRUE(shown != nullptr && shown->path);
  EXPECT_GT(shown->path->size(), 100U);
  ASSERT_TRUE(shown->error);
  EXPECT_NE(std::string(shown->error->what()).find("no cell"), std::string::npos);
}

}  // namespace
}  // namespace wcam::gui
