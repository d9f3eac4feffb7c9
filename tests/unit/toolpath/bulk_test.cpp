// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"
#include "wcam/geometry/polygon2d.hpp"
#include "wcam/io/import.hpp"
#include "wcam/process/process.hpp"

#include "error_matchers.hpp"
#include "random_source.hpp"
#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace wcam::test {
namespace {

using geometry::Vec3;
using toolpath::BeadFeature;
using toolpath::Contour;
using toolpath::SlicedLayers;

constexpr const char* kBulk = "wcam.slicing.bulk";

plugin::SliceInput inputOf(std::shared_ptr<const geometry::PartSurface> part, double plateZ = 0.0) {
  plugin::SliceInput input;
  input.parts = {std::move(part)};
  input.substrate = plate(plateZ);
  input.bead = {1.0, 4.0, 6.0};
  return input;
}

std::shared_ptr<const geometry::PartSurface> box() {
  return meshSurface(boxMesh(Vec3(-20, -20, 0), Vec3(20, 20, 10)));
}

std::shared_ptr<const geometry::PartSurface> imported(const std::string& file) {
  return io::importPart(std::string(WCAM_TEST_DATA) + "/" + file, io::ImportOptions{},
                        geometry::Pose::Identity(), JobContext())
      .surface;
}

double lengthOf(const Contour& contour) {
  double length = 0.0;
  for (std::size_t i = 1; i < contour.points.size(); ++i) {
    length += (contour.points[i].p - contour.points[i - 1].p).norm();
  }
  return contour.closed ? length + (contour.points.front().p - contour.points.back().p).norm()
                        : length;
}

/// What every strategy's layers fulfil: on the plane, sampled, n across the travel with t × n = up.
void checkLayers(const SlicedLayers& sliced, double spacing) {
  ASSERT_FALSE(sliced.layers.empty());
  for (const auto& layer : sliced.layers) {
    ASSERT_FALSE(layer.contours.empty());
    for (const Contour& contour : layer.contours) {
      const std::size_t n = contour.points.size();
      ASSERT_GE(n, 2U);
      for (std::size_t i = 0; i < n; ++i) {
        const auto& point = contour.points[i];
        ASSERT_TRUE(point.p.allFinite());
        ASSERT_NEAR(point.n.norm(), 1.0, 1e-9);
        ASSERT_NEAR(point.n.dot(layer.up), 0.0, 1e-9);
        if (i + 1 < n || contour.closed) {
          const Vec3 d = contour.points[(i + 1) % n].p - point.p;
          ASSERT_LE(d.norm(), spacing + 1e-9);
          ASSERT_NEAR(d.dot(layer.up), 0.0, 1e-7);
        }
        if (i > 0 && i + 1 < n) {
          const Vec3 t = (contour.points[i + 1].p - contour.points[i - 1].p);
          if (t.norm() > 1e-6) {
            ASSERT_GT(t.normalized().cross(point.n).dot(layer.up), -1e-6);
          }
        }
      }
    }
  }
}

TEST(Bulk, BoxIsFilledInEveryLayer) {
  const auto input = inputOf(box());
  const JobContext context;
  const SlicedLayers sliced = slice(kBulk, input, R"({"step": 2.0})", context);
  ASSERT_EQ(sliced.layers.size(), 5U);
  checkLayers(sliced, input.sampling.maxSpacing);
  EXPECT_EQ(context.diagnostics().count("slicing.voids"), 0U);
  EXPECT_EQ(context.diagnostics().count("slicing.overfill"), 0U);
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    const auto& contours = sliced.layers[l].contours;
    ASSERT_EQ(contours.size(), 2U);
    EXPECT_EQ(contours[0].feature, BeadFeature::Inset);
    EXPECT_NEAR(lengthOf(contours[0]), 4.0 * 34.0, 1e-6);
    EXPECT_EQ(contours[1].feature, BeadFeature::Fill);
    EXPECT_LT(contours[0].group, contours[1].group);
    for (const Contour& contour : contours) {
      for (const auto& point : contour.points) {
        EXPECT_NEAR(point.p.z(), 2.0 * static_cast<double>(l + 1), 1e-12);
        EXPECT_LE(point.p.head<2>().cwiseAbs().maxCoeff(), 17.0 + 1e-9);
      }
    }
    // The lines turn by 90 degrees from layer to layer.
    const auto& fill = contours[1].points;
    const Vec3 d = (fill[1].p - fill[0].p).normalized();
    EXPECT_NEAR(std::abs(l % 2 == 0 ? d.x() : d.y()), 1.0, 1e-9);
  }
  // The outer wall runs clockwise seen against the build direction, n outward.
  const auto& wall = sliced.layers[0].contours[0].points;
  for (const auto& point : wall) {
    EXPECT_GT(point.n.dot(point.p - Vec3(0, 0, point.p.z())), 0.0);
  }
}

TEST(Bulk, EveryPatternOnABoxBecomesAToolpath) {
  const auto input = inputOf(box());
  for (const char* pattern :
       {"none", "raster", "zigzag", "contour", "spiral", "hybrid", "continuous", "medial"}) {
    SCOPED_TRACE(pattern);
    const JobContext context;
    const SlicedLayers sliced = slice(
        kBulk, input, R"({"step": 2.0, "pattern": ")" + std::string(pattern) + "\"}", context);
    checkLayers(sliced, input.sampling.maxSpacing);
    EXPECT_EQ(context.diagnostics().count("slicing.voids"), 0U);
    const auto path = toolpath::buildToolpath(sliced, *input.substrate, {}, context);
    ASSERT_EQ(path.layers.size(), 5U);
    for (const auto& layer : path.layers) {
      for (const auto& bead : layer.beads) {
        for (const auto& point : bead.points) {
          ASSERT_NEAR(point.b.dot(Vec3::UnitZ()), 1.0, 1e-9);
        }
      }
    }
  }
}

/// Wire that the process feeds into each layer, mm³.
std::vector<double> wireOfLayers(const plugin::SliceInput& input,
                                 const std::string& settings,
                                 const process::ProcessParams& params) {
  const JobContext context;
  const SlicedLayers sliced = slice(kBulk, input, settings, context);
  const toolpath::Toolpath path = process::applyProcess(
      toolpath::buildToolpath(sliced, *input.substrate, {}, context), params, context);
  std::vector<double> volumes;
  for (const toolpath::Layer& layer : path.layers) {
    volumes.push_back(process::processStatistics({{layer}}, params).wireVolume);
  }
  return volumes;
}

constexpr std::array<const char*, 7> kFullPatterns{"raster", "zigzag",     "contour", "spiral",
                                                   "hybrid", "continuous", "medial"};

TEST(BulkVolume, WireOfABoxIsItsVolumeInEveryPattern) {
  const auto input = inputOf(meshSurface(boxMesh(Vec3(-40, -30, 0), Vec3(40, 30, 20))));
  process::ProcessParams params;
  params.beadWidth = 6.0_mm;
  for (const char* pattern : kFullPatterns) {
    SCOPED_TRACE(pattern);
    const std::vector<double> wire =
        wireOfLayers(input, R"({"step": 2.0, "pattern": ")" + std::string(pattern) + "\"}", params);
    ASSERT_EQ(wire.size(), 10U);
    double whole = 0.0;
    for (const double layer : wire) {
      EXPECT_NEAR(layer, 9600.0, 0.05 * 9600.0);
      whole += layer;
    }
    EXPECT_NEAR(whole, 96000.0, 0.03 * 96000.0);
  }
}

/// A closed ring on z = 0.
geometry::TriangleMesh ringMesh(double inner, double outer, double height) {
  geometry::TriangleMesh mesh;
  constexpr std::uint32_t kAround = 96;
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const double a = 2.0 * kPi * i / kAround;
    for (const auto& [r, z] :
         {std::pair{outer, 0.0}, {outer, height}, {inner, height}, {inner, 0.0}}) {
      mesh.vertices.emplace_back(r * std::cos(a), r * std::sin(a), z);
    }
  }
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const std::uint32_t next = (i + 1) % kAround;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t up = (k + 1) % 4;
      mesh.triangles.push_back({4 * i + k, 4 * next + k, 4 * next + up});
      mesh.triangles.push_back({4 * i + k, 4 * next + up, 4 * i + up});
    }
  }
  return mesh;
}

TEST(BulkVolume, NarrowBarsAndRingsAreFilledByEveryPattern) {
  // From one bead to three beads side by side.
  process::ProcessParams params;
  params.beadWidth = 6.0_mm;
  params.speedMin = Speed(0.1);
  for (const double width : {6.0, 8.0, 9.5, 12.5}) {
    for (const bool ring : {false, true}) {
      const auto part = ring ? meshSurface(ringMesh(30.0, 30.0 + width, 6.0))
                             : meshSurface(boxMesh(Vec3(-35, 0, 0), Vec3(35, width, 6)));
      const double outer = 30.0 + width;
      const double section =
          ring ? 48.0 * std::sin(2.0 * kPi / 96) * (outer * outer - 900.0) : 70.0 * width;
      for (const char* pattern : kFullPatterns) {
        SCOPED_TRACE(std::to_string(width) + (ring ? " ring, " : " bar, ") + pattern);
        const auto input = inputOf(part);
        const std::vector<double> wire = wireOfLayers(
            input, R"({"step": 2.0, "pattern": ")" + std::string(pattern) + "\"}", params);
        ASSERT_EQ(wire.size(), 3U);
        for (const double layer : wire) {
          EXPECT_NEAR(layer / (2.0 * section), 1.0, 0.03);
        }
      }
    }
  }
}

TEST(BulkVolume, WallsWithoutAPatternHoldWhatTheyReachOver) {
  process::ProcessParams params;
  params.beadWidth = 6.0_mm;
  const auto input = inputOf(meshSurface(boxMesh(Vec3(-35, -22, 0), Vec3(35, 22, 6))));
  for (const int walls : {1, 2, 3}) {
    SCOPED_TRACE(walls);
    const double reach = 6.0 + (walls - 1) * 0.667 * 6.0;
    const double section = 70.0 * 44.0 - (70.0 - 2.0 * reach) * (44.0 - 2.0 * reach);
    for (const double layer : wireOfLayers(
             input, R"({"step": 2.0, "pattern": "none", "walls": )" + std::to_string(walls) + "}",
             params)) {
      EXPECT_NEAR(layer / (2.0 * section), 1.0, 0.03);
    }
  }
}

TEST(BulkVolume, ALayerThatIsNotFilledHasARemedyThatFillsIt) {
  // Nothing is laid where the bar is narrower than a bead and narrow places stay empty.
  const auto input = inputOf(meshSurface(boxMesh(Vec3(-35, 0, 0), Vec3(35, 13, 6))));
  const JobContext context;
  (void)slice(kBulk, input,
              R"({"step": 2.0, "pattern": "contour", "fill_narrow": false, "max_width": 6.0})",
              context);
  for (const Diagnostic& finding : context.diagnostics().items()) {
    if (finding.code == "slicing.underfill") {
      EXPECT_NE(finding.remedy.str().find("this was tried"), std::string::npos)
          << finding.remedy.str();
    }
  }
  EXPECT_EQ(context.diagnostics().count("slicing.underfill"), 3U);
}

/// A closed frustum on z = 0.
geometry::TriangleMesh frustumMesh(double below, double above, double height, int around) {
  geometry::TriangleMesh mesh;
  const auto index = [](int k) { return static_cast<std::uint32_t>(k); };
  for (int k = 0; k < around; ++k) {
    const double a = 2.0 * kPi * k / around;
    mesh.vertices.emplace_back(below * std::cos(a), below * std::sin(a), 0.0);
    mesh.vertices.emplace_back(above * std::cos(a), above * std::sin(a), height);
  }
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);
  mesh.vertices.emplace_back(0.0, 0.0, height);
  for (int k = 0; k < around; ++k) {
    const int next = (k + 1) % around;
    mesh.triangles.push_back({index(2 * k), index(2 * next), index(2 * k + 1)});
    mesh.triangles.push_back({index(2 * next), index(2 * next + 1), index(2 * k + 1)});
    mesh.triangles.push_back({index(2 * around), index(2 * next), index(2 * k)});
    mesh.triangles.push_back({index(2 * around + 1), index(2 * k + 1), index(2 * next + 1)});
  }
  return mesh;
}

TEST(BulkVolume, WireFollowsSlopes) {
  process::ProcessParams params;
  params.beadWidth = 6.0_mm;
  const auto wholeOf = [&](const plugin::SliceInput& input, const std::string& settings) {
    double whole = 0.0;
    for (const double layer : wireOfLayers(input, settings, params)) {
      whole += layer;
    }
    return whole;
  };
  // A frustum that narrows from 40 to 25 mm over 30 mm, and the same the other way up.
  for (const bool widens : {false, true}) {
    const double below = widens ? 25.0 : 40.0;
    const double above = widens ? 40.0 : 25.0;
    const auto input = inputOf(meshSurface(frustumMesh(below, above, 30.0, 256)));
    const double volume = kPi * 30.0 / 3.0 * (below * below + below * above + above * above);
    for (const char* pattern : kFullPatterns) {
      SCOPED_TRACE(pattern);
      EXPECT_NEAR(wholeOf(input, R"({"step": 2.5, "pattern": ")" + std::string(pattern) + "\"}"),
                  volume, 0.03 * volume);
    }
  }
}

TEST(BulkVolume, StockOutsideTheSectionIsCounted) {
  const auto input = inputOf(meshSurface(boxMesh(Vec3(-40, -30, 0), Vec3(40, 30, 20))));
  process::ProcessParams params;
  params.beadWidth = 6.0_mm;
  const auto wholeOf = [&](const char* reference) {
    double whole = 0.0;
    for (const double layer : wireOfLayers(
             input, R"({"step": 2.0, "reference": ")" + std::string(reference) + "\"}", params)) {
      whole += layer;
    }
    return whole;
  };
  EXPECT_NEAR(wholeOf("centre"), 86.0 * 66.0 * 20.0, 0.03 * 86.0 * 66.0 * 20.0);
  EXPECT_NEAR(wholeOf("outside"), 92.0 * 72.0 * 20.0, 0.03 * 92.0 * 72.0 * 20.0);
}

TEST(Bulk, ResultDoesNotDependOnTriangleOrderOrThreads) {
  const auto ordered = imported("ram/bridge.ply");
  geometry::TriangleMesh mesh = ordered->mesh;
  testing::RandomSource random(5);
  for (std::size_t i = mesh.triangles.size(); i > 1; --i) {
    std::swap(mesh.triangles[i - 1], mesh.triangles[random.below(i)]);
  }
  const std::string params = R"({"step": 2.0, "pattern": "continuous", "bead_width": 3})";
  const double z = ordered->mesh.bounds().min.z();
  const SlicedLayers a = slice(kBulk, inputOf(ordered, z), params);
  SlicedLayers b;
  {
    const ThreadLimit limit(1);
    b = slice(kBulk, inputOf(meshSurface(mesh), z), params);
  }
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t l = 0; l < a.layers.size(); ++l) {
    ASSERT_EQ(a.layers[l].contours.size(), b.layers[l].contours.size());
    for (std::size_t c = 0; c < a.layers[l].contours.size(); ++c) {
      const auto& p = a.layers[l].contours[c].points;
      const auto& q = b.layers[l].contours[c].points;
      ASSERT_EQ(p.size(), q.size());
      for (std::size_t i = 0; i < p.size(); ++i) {
        ASSERT_NEAR((p[i].p - q[i].p).norm(), 0.0, 1e-6);
      }
    }
  }
}

TEST(Bulk, RealPartsAreFilledOrTheFindingSaysWhereNot) {
  for (const char* file : {"ram/bridge.ply", "ram/inversed_pyramid.ply", "ram/dome.ply",
                           "five_axis_slicer/supportless_sample.stp",
                           "compas_slicer/distorted_a_closed_mid_res.stl"}) {
    const auto part = imported(file);
    const auto bounds = part->mesh.bounds();
    const double size = bounds.diagonal();
    auto input = inputOf(part, bounds.min.z());
    // Small parts take a small bead.
    input.bead.width = std::clamp(size / 20.0, 0.5, 6.0);
    const double step = (bounds.max.z() - bounds.min.z()) / 8.0;
    for (const char* pattern : {"zigzag", "spiral", "continuous", "medial"}) {
      SCOPED_TRACE(std::string(file) + " " + pattern);
      const JobContext context;
      const SlicedLayers sliced =
          slice(kBulk, input,
                R"({"first_layer": 0.5, "open_sections": "bead", "pattern": ")" +
                    std::string(pattern) + R"(", "step": )" + std::to_string(step) + "}",
                context);
      checkLayers(sliced, input.sampling.maxSpacing);
      for (const Diagnostic& finding : context.diagnostics().items()) {
        EXPECT_NE(finding.severity, Severity::Violation) << toLine(finding);
      }
    }
  }
}

TEST(Bulk, SectionsThatAreNotClosedAreRefusedOrLaidAsBeads) {
  // Half a tube: every section is an open arc.
  geometry::TriangleMesh mesh = tubeMesh(20.0, 20.0, 60, 10);
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]).y() < 0.0;
  });
  const auto input = inputOf(meshSurface(mesh));
  const std::string text = testing::errorOf(
      ErrorCode::JobFailed, [&] { static_cast<void>(slice(kBulk, input, R"({"step": 2.0})")); });
  EXPECT_NE(text.find("not closed"), std::string::npos) << text;
  EXPECT_NE(text.find("layer 1"), std::string::npos) << text;
  EXPECT_NE(text.find("open_sections=bead"), std::string::npos) << text;
  const JobContext context;
  const SlicedLayers sliced =
      slice(kBulk, input, R"({"step": 2.0, "open_sections": "bead"})", context);
  EXPECT_EQ(sliced.layers.size(), 10U);
  EXPECT_EQ(context.diagnostics().count("slicing.open_section"), 1U);
  EXPECT_NEAR(lengthOf(sliced.layers[4].contours[0]), 20.0 * kPi, 3.0);
}

TEST(Bulk, OpenSurfaceWithClosedSectionsIsFilledAndSaid) {
  const JobContext context;
  const SlicedLayers sliced = slice(kBulk, inputOf(meshSurface(tubeMesh(20.0, 20.0, 100, 10))),
                                    R"({"step": 2.0})", context);
  EXPECT_EQ(sliced.layers.size(), 10U);
  EXPECT_EQ(context.diagnostics().count("slicing.open_surface"), 1U);
}

TEST(Bulk, ThinWallsVoidsAndPilesAreFindings) {
  const auto wall = inputOf(meshSurface(boxMesh(Vec3(-50, -1.75, 0), Vec3(50, 1.75, 4))));
  const JobContext filled;
  EXPECT_FALSE(slice(kBulk, wall, R"({"step": 2.0})", filled).layers.empty());
  EXPECT_EQ(filled.diagnostics().count("slicing.narrow"), 2U);
  testing::errorOf(ErrorCode::JobFailed, [&] {
    static_cast<void>(slice(kBulk, wall, R"({"step": 2.0, "fill_narrow": false})"));
  });
  const auto seven = inputOf(meshSurface(boxMesh(Vec3(-50, -3.5, 0), Vec3(50, 3.5, 4))));
  const JobContext piled;
  // Two beads with 3.5 mm each, none narrower than 5.9 mm, which holds 0.667 times that.
  EXPECT_FALSE(
      slice(kBulk, seven, R"({"step": 2.0, "min_width": 5.9, "fill_narrow": false})", piled)
          .layers.empty());
  EXPECT_EQ(piled.diagnostics().count("slicing.overfill"), 0U);  // 112 %, below most_fill
  const JobContext strict;
  EXPECT_FALSE(slice(kBulk, seven,
                     R"({"step": 2.0, "min_width": 5.9, "fill_narrow": false, "most_fill": 1.1})",
                     strict)
                   .layers.empty());
  EXPECT_EQ(strict.diagnostics().count("slicing.overfill"), 2U);
  const JobContext holes;
  EXPECT_FALSE(slice(kBulk, inputOf(box()), R"({"step": 2.0, "overlap": 1.0, "pattern": "raster",
                                       "least_coverage": 0.999})",
                     holes)
                   .layers.empty());
  const auto items = holes.diagnostics().items();
  ASSERT_EQ(holes.diagnostics().count("slicing.voids"), 5U);
  EXPECT_EQ(items[0].place.layer, 0);
}

TEST(Bulk, TiltedPlanesAreCutAtThePlate) {
  const auto input = inputOf(meshSurface(boxMesh(Vec3(-20, -20, -10), Vec3(20, 20, 20))));
  const SlicedLayers sliced =
      slice(kBulk, input, R"({"step": 3.0, "custom_direction": true, "direction": [1, 0, 1]})");
  checkLayers(sliced, input.sampling.maxSpacing);
  double lowest = 1e9;
  for (const auto& layer : sliced.layers) {
    for (const Contour& contour : layer.contours) {
      for (const auto& point : contour.points) {
        lowest = std::min(lowest, point.p.z());
      }
    }
  }
  // The bead's half width stays above the plate, measured in the tilted plane.
  EXPECT_GE(lowest, 3.0 * std::sqrt(0.5) - 0.05);
}

TEST(Bulk, RefusesAWidthOutsideItsRange) {
  const std::string text = testing::errorOf(ErrorCode::JobFailed, [&] {
    static_cast<void>(slice(kBulk, inputOf(box()), R"({"step": 2.0, "min_width": 20})"));
  });
  EXPECT_NE(text.find("6.00"), std::string::npos) << text;
  EXPECT_NE(text.find("min_width"), std::string::npos) << text;
}

TEST(Bulk, SmallSectionsCanBeLeftOut) {
  geometry::TriangleMesh mesh = boxMesh(Vec3(-20, -20, 0), Vec3(20, 20, 4));
  const geometry::TriangleMesh small = boxMesh(Vec3(30, 0, 0), Vec3(40, 10, 4));
  for (auto triangle : small.triangles) {
    for (auto& v : triangle) {
      v += static_cast<std::uint32_t>(mesh.vertices.size());
    }
    mesh.triangles.push_back(triangle);
  }
  mesh.vertices.insert(mesh.vertices.end(), small.vertices.begin(), small.vertices.end());
  const auto input = inputOf(meshSurface(mesh));
  const auto count = [&](const std::string& params) {
    return slice(kBulk, input, params).layers[0].contours.size();
  };
  EXPECT_GT(count(R"({"step": 2.0})"), count(R"({"step": 2.0, "min_area": 150})"));
}

}  // namespace
}  // namespace wcam::test
