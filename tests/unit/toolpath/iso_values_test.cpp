// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/aabb_tree.hpp"
#include "wcam/toolpath/field_heights.hpp"
#include "wcam/toolpath/iso_field.hpp"

#include "error_matchers.hpp"
#include "field_meshes.hpp"
#include "implicit_mesh.hpp"
#include "slicing_fixture.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {
namespace {

using geometry::PartSurface;
using wcam::testing::errorOf;

plugin::SliceInput inputOf(geometry::TriangleMesh mesh) {
  plugin::SliceInput input;
  input.parts = {test::meshSurface(std::move(mesh))};
  input.substrate = test::plate();
  input.bead = {0.5, 10.0, 8.0};
  return input;
}

const std::string kIso = "wcam.slicing.isovalues";

std::pair<double, double> heightRange(const SlicedLayers& sliced) {
  double low = 1e9;
  double high = 0.0;
  for (const SlicedLayer& layer : sliced.layers) {
    for (const Contour& contour : layer.contours) {
      for (const ContourPoint& point : contour.points) {
        low = std::min(low, point.height);
        high = std::max(high, point.height);
      }
    }
  }
  return {low, high};
}

TEST(IsoValues, ElbowOfTheThesis) {  // Diourté A8, Table 3.3
  const double r = 19.0;
  const double R = 241.2;
  const double bend = 13.0 / 19.0;
  plugin::SliceInput input = inputOf(test::elbowMesh(r, R, bend, 120, 160));
  input.bead = {1.8, 2.2, 8.0};
  const JobContext context;
  const SlicedLayers sliced = test::slice(kIso, input, R"({"step": 2.0})", context);
  // 165 mm of axis; the mean along the faceted wall is 0.1 ‰ less.
  ASSERT_TRUE(sliced.layers.size() == 82 || sliced.layers.size() == 83);
  EXPECT_TRUE(sliced.curved);
  const double n = static_cast<double>(sliced.layers.size());
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    const double phi = bend * static_cast<double>(l + 1) / n;
    ASSERT_EQ(sliced.layers[l].contours.size(), 1U);
    EXPECT_TRUE(sliced.layers[l].contours[0].closed);
    EXPECT_LT((sliced.layers[l].up - Vec3(-std::sin(phi), 0, std::cos(phi))).norm(), 3e-3);
    for (const ContourPoint& point : sliced.layers[l].contours[0].points) {
      const double rho = std::hypot(point.p.x() + R, point.p.z());
      EXPECT_NEAR(std::atan2(point.p.z(), point.p.x() + R), phi, 1e-5);
      EXPECT_NEAR(point.height, rho * bend / n, 5e-3);
    }
  }
  const auto [low, high] = heightRange(sliced);
  EXPECT_NEAR(low, (165.0 - 13.0) / n, 5e-3);
  EXPECT_NEAR(high, (165.0 + 13.0) / n, 5e-3);
  EXPECT_EQ(context.diagnostics().count("slicing.height_out_of_range"), 0U);
}

TEST(IsoValues, VerdictNamesPlaceExcessAndRemedy) {
  plugin::SliceInput input = inputOf(test::elbowMesh(19.0, 241.2, 13.0 / 19.0, 120, 160));
  const auto findings = [&](const BeadRange& bead) {
    input.bead = bead;
    const JobContext context;
    test::slice(kIso, input, R"({"step": 2.0})", context);
    std::vector<Diagnostic> found;
    for (const Diagnostic& d : context.diagnostics().items()) {
      if (d.code == "slicing.height_out_of_range") {
        found.push_back(d);
      }
    }
    return found;
  };
  // 1.83 to 2.17 mm in a range whose ratio is enough: another step does.
  const auto shifted = findings({2.0, 2.6, 8.0});
  ASSERT_EQ(shifted.size(), 1U);
  EXPECT_THAT(shifted[0].remedy, ::testing::HasSubstr("a step between 2.1"));
  EXPECT_GE(shifted[0].place.layer, 0);
  // The part needs a ratio of 178/152.
  const auto narrow = findings({1.95, 2.05, 8.0});
  ASSERT_EQ(narrow.size(), 1U);
  EXPECT_THAT(narrow[0].remedy, ::testing::HasSubstr("1.17 times the least"));
}

TEST(IsoValues, LastLayerIsTheSlantedBorder) {
  geometry::TriangleMesh mesh = test::tubeMesh(25.0, 100.0, 60, 50);
  for (Vec3& p : mesh.vertices) {
    p.z() *= 1.0 + 0.0025 * p.x();
  }
  const SlicedLayers sliced = test::slice(kIso, inputOf(mesh), R"({"step": 3.0})");
  EXPECT_EQ(sliced.layers.size(), 33U);
  ASSERT_EQ(sliced.layers.back().contours.size(), 1U);
  for (const ContourPoint& point : sliced.layers.back().contours[0].points) {
    EXPECT_NEAR(point.p.z(), 100.0 + 0.25 * point.p.x(), 1e-6);
  }
  for (const SlicedLayer& layer : sliced.layers) {
    ASSERT_EQ(layer.contours.size(), 1U);
    EXPECT_TRUE(layer.contours[0].closed);
  }
  // Harmonic: u = z/100 − 0.0625·cos·exp(−(100 − z)/25), so that the border bends the last layers:
  // |grad u| there is (1 ± 0.25)/100.
  const auto [low, high] = heightRange(sliced);
  EXPECT_NEAR(low, 100.0 / 33.0 / 1.25, 0.1);
  EXPECT_NEAR(high, 100.0 / 33.0 / 0.75, 0.1);
}

TEST(IsoValues, ShareOfDistancesKeepsTheBorders) {
  geometry::TriangleMesh mesh = test::tubeMesh(25.0, 100.0, 60, 50);
  for (Vec3& p : mesh.vertices) {
    p.z() *= 1.0 + 0.0025 * p.x();
  }
  for (const char* share : {"0.5", "1.0"}) {
    const SlicedLayers sliced = test::slice(
        kIso, inputOf(mesh), std::string(R"({"step": 3.0, "geodesic_share": )") + share + "}");
    EXPECT_EQ(sliced.layers.size(), 33U);
    for (const ContourPoint& point : sliced.layers.back().contours[0].points) {
      EXPECT_NEAR(point.p.z(), 100.0 + 0.25 * point.p.x(), 1e-6);
    }
    if (std::string(share) == "1.0") {
      // The slant spreads over the whole wall: 93.75 to 106.25 mm in 33 layers.
      const auto [low, high] = heightRange(sliced);
      EXPECT_NEAR(low, 93.75 / 33.0, 0.1);
      EXPECT_NEAR(high, 106.25 / 33.0, 0.1);
    }
  }
}

TEST(IsoValues, ConductionBendsTheLayers) {
  geometry::TriangleMesh mesh = test::tubeMesh(25.0, 100.0, 60, 50);
  for (Vec3& p : mesh.vertices) {
    p.z() *= 1.0 + 0.0025 * p.x();
  }
  // Spread of heights z within the layer at two thirds: conduction upwards makes the wall seem
  // shorter, so that the slant reaches farther down.
  const auto spread = [&](const char* up) {
    const SlicedLayers sliced = test::slice(
        kIso, inputOf(mesh), std::string(R"({"step": 3.0, "conductivity_up": )") + up + "}");
    double low = 1e9;
    double high = -1e9;
    for (const ContourPoint& point : sliced.layers[21].contours[0].points) {
      low = std::min(low, point.p.z());
      high = std::max(high, point.p.z());
    }
    return high - low;
  };
  EXPECT_GT(spread("16"), spread("1") + 1.0);
  EXPECT_LT(spread("0.1"), spread("1") - 0.5);
}

TEST(IsoValues, ExactPartKeepsItsSurface) {
  plugin::SliceInput input;
  input.parts = {test::importSample("elbow/elbow.step")};
  const geometry::Box box = input.parts[0]->mesh.bounds();
  input.substrate = test::plate(box.min.z());
  input.bead = {0.1, 50.0, 8.0};
  const SlicedLayers sliced = test::slice(kIso, input, R"({"step": 5.0})");
  EXPECT_GT(sliced.layers.size(), 5U);
  const geometry::AabbTree tree(input.parts[0]->mesh);
  for (const SlicedLayer& layer : sliced.layers) {
    for (const Contour& contour : layer.contours) {
      for (const ContourPoint& point : contour.points) {
        EXPECT_LT(tree.closestPoint(point.p)->distance, 0.3);  // of the tessellation
      }
    }
  }
}

TEST(IsoValues, DomeGrowsByDistance) {
  std::vector<geometry::Vec2> profile;
  for (int i = 0; i <= 40; ++i) {
    const double a = 0.5 * kPi * i / 40;
    profile.emplace_back(i == 40 ? 0.0 : 50.0 * std::cos(a), 50.0 * std::sin(a));
  }
  const SlicedLayers sliced =
      test::slice(kIso, inputOf(test::revolvedMesh(profile, 80)), R"({"step": 2.0})");
  EXPECT_NEAR(static_cast<double>(sliced.layers.size()), 0.5 * kPi * 50.0 / 2.0, 1.5);
  const auto [low, high] = heightRange(sliced);
  EXPECT_NEAR(low, 2.0, 0.06);
  EXPECT_NEAR(high, 2.0, 0.06);
}

TEST(IsoValues, BottomOfAClosedBodyIsNoWall) {
  // A closed cylinder with flat bottom and top: layers climb the wall and close the top.
  std::vector<geometry::Vec2> profile{{0.0, 0.0}};
  geometry::TriangleMesh mesh = test::tubeMesh(20.0, 40.0, 40, 20);
  const auto centre = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.emplace_back(0, 0, 0);
  mesh.vertices.emplace_back(0, 0, 40);
  for (std::uint32_t j = 0; j < 40; ++j) {
    mesh.triangles.push_back({centre, (j + 1) % 40, j});
    mesh.triangles.push_back({centre + 1, 800 + j, 800 + (j + 1) % 40});
  }
  const SlicedLayers sliced = test::slice(kIso, inputOf(mesh), R"({"step": 2.0})");
  // 40 mm of wall and 20 mm of top.
  EXPECT_NEAR(static_cast<double>(sliced.layers.size()), 30.0, 1.5);
  for (const ContourPoint& point : sliced.layers.front().contours[0].points) {
    EXPECT_NEAR(point.p.z(), 2.0, 0.1);
  }
}

TEST(IsoValues, EveryUpperBorderIsALayer) {
  // A fork whose one arm is cut shorter.
  geometry::TriangleMesh mesh = test::forkMesh(45);
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) {
      return mesh.vertices[v].x() > 0.0 && mesh.vertices[v].z() > 80.0;
    });
  });
  const geometry::HalfEdges halfEdges(mesh);
  ASSERT_EQ(halfEdges.borderLoops(mesh).size(), 3U);
  const SlicedLayers sliced = test::slice(kIso, inputOf(mesh), R"({"step": 3.0})");
  for (const auto& loop : halfEdges.borderLoops(mesh)) {
    if (mesh.vertices[loop.front()].z() < 1.0) {
      continue;
    }
    // Some layer runs along the border.
    double best = 1e9;
    for (const SlicedLayer& layer : sliced.layers) {
      for (const Contour& contour : layer.contours) {
        double worst = 0.0;
        for (const std::uint32_t v : loop) {
          double nearest = 1e9;
          for (const ContourPoint& point : contour.points) {
            nearest = std::min(nearest, (point.p - mesh.vertices[v]).norm());
          }
          worst = std::max(worst, nearest);
        }
        best = std::min(best, worst);
      }
    }
    EXPECT_LT(best, 3.0);  // between samples
  }
}

TEST(IsoValues, MovesAndScalesWithThePart) {
  geometry::TriangleMesh mesh = test::tubeMesh(25.0, 100.0, 40, 40);
  for (Vec3& p : mesh.vertices) {
    p.z() *= 1.0 + 0.0025 * p.x();
  }
  plugin::SliceInput input = inputOf(mesh);
  input.sampling = {0.01, 4.0};
  const SlicedLayers a = test::slice(kIso, input, R"({"step": 4.0})");
  for (Vec3& p : mesh.vertices) {
    p = 2.0 * Vec3(-p.y(), p.x(), p.z());
  }
  plugin::SliceInput twice = inputOf(mesh);
  twice.sampling = {0.02, 8.0};
  const SlicedLayers b = test::slice(kIso, twice, R"({"step": 8.0})");
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t l = 0; l < a.layers.size(); ++l) {
    const auto& p = a.layers[l].contours[0].points;
    const auto& q = b.layers[l].contours[0].points;
    ASSERT_EQ(p.size(), q.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      EXPECT_LT((2.0 * Vec3(-p[i].p.y(), p[i].p.x(), p[i].p.z()) - q[i].p).norm(), 1e-6);
      EXPECT_NEAR(2.0 * p[i].height, q[i].height, 1e-6);
    }
  }
}

TEST(IsoValues, WavyVaseOfRealData) {
  // Three lobes: the harmonic field crowds its layers below the border, distances do not.
  plugin::SliceInput input;
  input.parts = {
      io::importPart(std::string(WCAM_TEST_DATA) + "/compas_slicer/wavy_vase_open_low_res.stl",
                     io::ImportOptions{}, geometry::Pose::Identity(), JobContext())
          .surface};
  input.substrate = test::plate();
  input.bead = {1.5, 5.0, 8.0};
  const JobContext harmonic;
  const SlicedLayers crowded = test::slice(kIso, input, R"({"step": 4})", harmonic);
  EXPECT_EQ(harmonic.diagnostics().count("slicing.height_out_of_range"), 1U);
  const JobContext distances;
  const SlicedLayers even =
      test::slice(kIso, input, R"({"step": 3, "geodesic_share": 1})", distances);
  EXPECT_EQ(distances.diagnostics().count("slicing.height_out_of_range"), 0U);
  for (const SlicedLayers* sliced : {&crowded, &even}) {
    for (const SlicedLayer& layer : sliced->layers) {
      ASSERT_EQ(layer.contours.size(), 1U);
      EXPECT_TRUE(layer.contours[0].closed);
    }
  }
}

TEST(IsoValues, ReportsLayersThatGrowDown) {
  // A tube bent by 150°.
  plugin::SliceInput input = inputOf(test::elbowMesh(10.0, 60.0, 150.0 / 180.0 * kPi, 40, 80));
  const JobContext context;
  const SlicedLayers sliced = test::slice(kIso, input, R"({"step": 3})", context);
  ASSERT_EQ(context.diagnostics().count("slicing.grows_down"), 1U);
  // cos(phi) below −0.1 from 95.7° on.
  for (const Diagnostic& d : context.diagnostics().items()) {
    if (d.code == "slicing.grows_down") {
      EXPECT_NEAR(d.data.front().second,
                  static_cast<double>(sliced.layers.size()) * (150.0 - 95.74) / 150.0, 1.0);
    }
  }
}

TEST(IsoValues, RefusesWhatItCannotSlice) {
  EXPECT_THAT(
      errorOf(
          ErrorCode::JobFailed,
          [] { test::slice(kIso, inputOf(test::tubeMesh(25.0, 4.0, 40, 4)), R"({"step": 20})"); }),
      ::testing::HasSubstr("choose a smaller step"));
  plugin::SliceInput below = inputOf(test::tubeMesh(25.0, 4.0, 40, 4));
  below.substrate = test::plate(50.0);
  EXPECT_THAT(errorOf(ErrorCode::CheckFailed, [&] { test::slice(kIso, below, R"({"step": 2})"); }),
              ::testing::HasSubstr("below the substrate"));
}

}  // namespace
}  // namespace wcam::toolpath
