// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/iso_parametric.hpp"

#include "wcam/base/error.hpp"
#include "wcam/toolpath/layer_distance.hpp"

#include "constant_fixture.hpp"
#include "test_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

/// Iso-parametric layers on the test parts of Chalvin (AT-02, AT-03, AT-07, AT-18, AT-19).
namespace wcam::toolpath {
namespace {

using namespace constant_test;

SlicedLayers isoparam(const plugin::SliceInput& input, const std::string& params) {
  return test::slice("wcam.slicing.isoparam", input, params);
}

double radiusOf(const SlicedLayer& layer) {
  const Vec3& p = layer.contours.at(0).points.at(0).p;
  return std::hypot(p.x(), p.y());
}

double heightOf(const SlicedLayer& layer) {
  return layer.contours.at(0).points.at(0).p.z();
}

/// Chord between neighbouring circles on one meridian.
double chordOf(const SlicedLayer& a, const SlicedLayer& b) {
  return std::hypot(radiusOf(b) - radiusOf(a), heightOf(b) - heightOf(a));
}

TEST(IsoRevolution, SphereFollowsTheRecursion) {
  // AT-02.
  for (const auto& [step, count] : {std::pair{5.0, 15U}, std::pair{1.0, 71U}}) {
    const SlicedLayers sliced = isoparam(
        inputOf(formulaPart("p1_hemisphere.wsurf")),
        R"({"first_layer": 0, "mode": "revolution", "step": )" + std::to_string(step) + "}");
    EXPECT_EQ(sliced.layers.size(), count);
    double z = 0.0;
    for (std::size_t n = 0; n < sliced.layers.size(); ++n) {
      const SlicedLayer& layer = sliced.layers[n];
      ASSERT_EQ(layer.contours.size(), 1U);
      const double u = static_cast<double>(n) * 2.0 * std::asin(step / 90.0);
      EXPECT_NEAR(heightOf(layer), 45.0 * std::sin(u), 1e-6);
      EXPECT_NEAR(z, 45.0 * std::sin(u), 1e-10);  // Eq. 2.6 is the same
      if (n > 0) {
        EXPECT_NEAR(chordOf(sliced.layers[n - 1], layer), step, 1e-9);
      }
      for (const ContourPoint& point : layer.contours[0].points) {
        EXPECT_NEAR(point.p.norm(), 45.0, 1e-6);
        EXPECT_NEAR((point.n - point.p / 45.0).norm(), 0.0, 1e-5);
      }
      const double q = step * step / (45.0 * 45.0);
      z = z * (1.0 - q / 2.0) +
          step * std::sqrt((1.0 - q / 4.0) * std::max(0.0, 1.0 - z * z / (45.0 * 45.0)));
    }
  }
}

TEST(IsoRevolution, ArcLengthDeviatesAsItShould) {
  // AT-03.
  for (const auto& [step, deviation] : {std::pair{5.0, 5.14e-4}, std::pair{1.0, 2.06e-5}}) {
    const SlicedLayers sliced =
        isoparam(inputOf(formulaPart("p1_hemisphere.wsurf")),
                 R"({"first_layer": 0, "measure": "arc", "step": )" + std::to_string(step) + "}");
    for (std::size_t n = 1; n < sliced.layers.size(); ++n) {
      EXPECT_NEAR(1.0 - chordOf(sliced.layers[n - 1], sliced.layers[n]) / step, deviation,
                  0.02 * deviation);
    }
  }
}

TEST(IsoRevolution, HalfCatenoidHasItsContours) {
  // AT-19.
  const SlicedLayers sliced = isoparam(inputOf(formulaPart("p2_half_catenoid.wsurf")),
                                       R"({"first_layer": 0, "step": 1.0})");
  EXPECT_EQ(sliced.layers.size(), 71U);
  EXPECT_LE(worstDistance(sliced, 1.0), 0.01);
  plot(sliced, "catenoid");
}

TEST(IsoRevolution, NozzleBridgesItsThroat) {
  // AT-18.
  for (const double step : {5.0, 1.0}) {
    const SlicedLayers sliced =
        isoparam(inputOf(formulaPart("p3_nozzle.wsurf")),
                 R"({"first_layer": 0, "step": )" + std::to_string(step) + "}");
    plot(sliced, "nozzle");
    // One layer more than whole steps of the profile; chords cut the bend at the throat a little.
    EXPECT_NEAR(static_cast<double>(sliced.layers.size()), std::floor(136.757 / step) + 1.0, 1.0);
    for (std::size_t n = 1; n < sliced.layers.size(); ++n) {
      EXPECT_NEAR(chordOf(sliced.layers[n - 1], sliced.layers[n]), step, 1e-9);
      EXPECT_GT(heightOf(sliced.layers[n]), heightOf(sliced.layers[n - 1]));
    }
  }
}

TEST(IsoRevolution, LayersGrowUpwardsWithTheWallOutside) {
  const SlicedLayers sliced =
      isoparam(inputOf(formulaPart("p1_hemisphere.wsurf")), R"({"step": 5.0})");
  for (const SlicedLayer& layer : sliced.layers) {
    const auto& points = layer.contours[0].points;
    const Vec3 t = (points[1].p - points[0].p).normalized();
    EXPECT_GT(t.cross(points[0].n).z(), 0.0);
  }
  EXPECT_NEAR(heightOf(sliced.layers[0]), 45.0 * std::sin(2.0 * std::asin(5.0 / 90.0)), 1e-6);
}

TEST(IsoRevolution, MeshesAndTiltedAxesWork) {
  geometry::Pose pose = geometry::Pose::Identity();
  pose.translate(Vec3(5, 6, 0));
  const auto part = formulaPart("p3_nozzle.wsurf", pose);
  auto mesh = std::make_shared<geometry::PartSurface>();
  mesh->mesh = part->mesh;
  mesh->halfEdges = geometry::HalfEdges(mesh->mesh);
  const SlicedLayers a = isoparam(inputOf(part), R"({"step": 4.0})");
  const SlicedLayers b = isoparam(inputOf(mesh), R"({"step": 4.0})");
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t n = 0; n < a.layers.size(); ++n) {
    EXPECT_NEAR(heightOf(a.layers[n]), heightOf(b.layers[n]), 0.2);
  }
}

TEST(IsoRevolution, LeastRadiusEndsAtThePole) {
  const SlicedLayers sliced = isoparam(inputOf(formulaPart("p1_hemisphere.wsurf")),
                                       R"({"step": 1.0, "least_radius": 4.0})");
  EXPECT_GE(radiusOf(sliced.layers.back()), 4.0);
  EXPECT_LE(radiusOf(sliced.layers.back()), 5.0);
}

TEST(IsoRevolution, RefusesWhatIsNoRevolution) {
  const auto refusal = [](const plugin::SliceInput& input, const std::string& params) {
    try {
      static_cast<void>(isoparam(input, params));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const auto box = test::meshSurface(test::boxMesh({-10, -6, 0}, {10, 6, 8}));
  EXPECT_THAT(refusal(inputOf(box), R"({"mode": "revolution"})"),
              ::testing::HasSubstr("no body of revolution"));
  EXPECT_THAT(refusal(inputOf(box), "{}"), ::testing::HasSubstr("is a mesh"));
  EXPECT_THAT(refusal(inputOf(formulaPart("p4_quarter_torus.wsurf")),
                      R"({"mode": "revolution", "custom_axis": true})"),
              ::testing::HasSubstr("off the profile"));
}

double lengthOf(const SlicedLayers& sliced) {
  double length = 0.0;
  for (const SlicedLayer& layer : sliced.layers) {
    for (const Contour& contour : layer.contours) {
      const std::size_t n = contour.points.size();
      for (std::size_t i = 0; i + (contour.closed ? 0 : 1) < n; ++i) {
        length += (contour.points[(i + 1) % n].p - contour.points[i].p).norm();
      }
    }
  }
  return length;
}

std::shared_ptr<const geometry::PartSurface> partFrom(const std::string& surface) {
  const wcam::testing::TestFolder folder;
  std::ofstream(folder / "part.wsurf") << R"({"format_version": 1, "surface": )" << surface << "}";
  return io::importPart(folder / "part.wsurf", {}, geometry::Pose::Identity(), JobContext())
      .surface;
}

std::shared_ptr<const geometry::PartSurface> asMesh(
    const std::shared_ptr<const geometry::PartSurface>& part) {
  auto mesh = std::make_shared<geometry::PartSurface>();
  mesh->mesh = part->mesh;
  mesh->halfEdges = geometry::HalfEdges(mesh->mesh);
  return mesh;
}

TEST(IsoRevolution, ParallelsEndAtTheSidesOfASector) {
  // A cone of ±60 degrees, from radius 40 to 10 over 40 mm: slant 50 mm, 25 steps.
  const auto part = partFrom(
      R"json({"type": "parametric", "x": "(40-0.75*v)*cos(u)", "y": "(40-0.75*v)*sin(u)", "z": "v",
          "u": ["-pi/3", "pi/3"], "v": [0, 40]})json");
  for (const bool mesh : {false, true}) {
    const SlicedLayers sliced =
        isoparam(inputOf(mesh ? asMesh(part) : part), R"({"step": 2.0, "mode": "revolution"})");
    ASSERT_EQ(sliced.layers.size(), 25U);
    double expected = 0.0;
    for (std::size_t n = 0; n < sliced.layers.size(); ++n) {
      ASSERT_EQ(sliced.layers[n].contours.size(), 1U);
      const Contour& contour = sliced.layers[n].contours[0];
      EXPECT_FALSE(contour.closed);
      const double radius = 40.0 - 1.2 * static_cast<double>(n + 1);
      expected += 2.0 * kPi / 3.0 * radius;
      for (const ContourPoint* end : {&contour.points.front(), &contour.points.back()}) {
        EXPECT_NEAR(std::abs(std::atan2(end->p.y(), end->p.x())), kPi / 3.0, mesh ? 2e-3 : 1e-6);
      }
      const Vec3 t = contour.points[1].p - contour.points[0].p;
      EXPECT_GT(t.cross(contour.points[0].n).z(), 0.0);
    }
    EXPECT_NEAR(lengthOf(sliced), expected, mesh ? 2.0 : 0.5);
  }
}

TEST(IsoRevolution, ParallelsOfAQuarterTorusStayOnIt) {
  const auto part = formulaPart("p4_quarter_torus.wsurf");
  const SlicedLayers sliced = isoparam(inputOf(part), R"({"step": 2.0})");
  // A quarter turn at each step of the tube's circle: π/2·Σr, about π/2·50·47.
  EXPECT_NEAR(lengthOf(sliced), 3650.0, 60.0);
  for (const SlicedLayer& layer : sliced.layers) {
    for (const Contour& contour : layer.contours) {
      for (const ContourPoint& point : contour.points) {
        EXPECT_GE(point.p.z(), -1e-3);
      }
    }
  }
}

TEST(IsoRevolution, HolesPartTheParallels) {
  // A tube with a window of 60 by 10 degrees: faces that the parallels cross twice.
  geometry::TriangleMesh tube = test::tubeMesh(30.0, 40.0, 120, 20);
  tube.triangles.erase(
      std::remove_if(
          tube.triangles.begin(), tube.triangles.end(),
          [&](const std::array<std::uint32_t, 3>& t) {
            const Vec3 c = (tube.vertices[t[0]] + tube.vertices[t[1]] + tube.vertices[t[2]]) / 3.0;
            return std::abs(std::atan2(c.y(), c.x())) < kPi / 6.0 && c.z() > 10.0 && c.z() < 30.0;
          }),
      tube.triangles.end());
  const SlicedLayers sliced =
      isoparam(inputOf(test::meshSurface(std::move(tube))), R"({"step": 4.0})");
  ASSERT_EQ(sliced.layers.size(), 10U);
  for (const SlicedLayer& layer : sliced.layers) {
    const bool open = layer.level > 11.0 && layer.level < 29.0;
    ASSERT_EQ(layer.contours.size(), 1U);
    EXPECT_EQ(layer.contours[0].closed, !open) << layer.level;
  }
}

TEST(IsoFaces, CurvesThatMeetEachOtherAreRefusedEarly) {
  // A bow from plate to plate: fronts from both feet run over each other.
  const auto bow = partFrom(
      R"json({"type": "parametric", "x": "(50+12*cos(v))*cos(u)", "y": "12*sin(v)",
          "z": "(50+12*cos(v))*sin(u)", "u": [0, "pi"], "v": [0, "2*pi"], "closed_v": true})json");
  // A whole torus that stands in the plate: they would go on for ever.
  const auto torus = partFrom(
      R"json({"type": "parametric", "x": "(50+12*cos(v))*cos(u)", "y": "12*sin(v)",
              "z": "(50+12*cos(v))*sin(u)", "u": [0, "2*pi"], "v": [0, "2*pi"],
              "closed_u": true, "closed_v": true})json");
  for (const auto& part : {bow, torus}) {
    try {
      static_cast<void>(isoparam(inputOf(part), R"({"step": 2.0, "mode": "faces"})"));
      FAIL() << "accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::JobFailed);
      EXPECT_THAT(std::string(error.what()), ::testing::HasSubstr("more than once"));
    }
  }
}

TEST(IsoFaces, TorusDipsAsTheTheorySays) {
  // AT-07.
  const SlicedLayers sliced = isoparam(inputOf(formulaPart("p4_torus_179.wsurf"), {0.01, 0.8}),
                                       R"({"step": 5.0, "first_layer": 0, "mode": "faces"})");
  plot(sliced, "isov");
  ASSERT_GE(sliced.layers.size(), 22U);
  double least = 10.0;
  for (std::size_t n = 1; n <= 21; ++n) {
    ASSERT_EQ(sliced.layers[n].contours.size(), 1U);
    const auto& above = sliced.layers[n].contours[0].points;
    const auto& below = sliced.layers[n - 1].contours[0].points;
    ASSERT_EQ(above.size(), below.size());
    const std::vector<double> distances =
        layerDistance(pointsOf(sliced.layers[n]), sliced.layers[n - 1].contours);
    double lowest = 10.0;
    for (std::size_t i = 0; i < above.size(); ++i) {
      EXPECT_NEAR((above[i].p - below[i].p).norm(), 5.0, 1e-9);
      EXPECT_NEAR(std::remainder(torusV(above[i].p) - torusV(below[i].p), 2.0 * kPi), 0.0, 1e-6);
      EXPECT_LE(distances[i], 5.0 + 1e-9);
      if (torusU(above[i].p) <= kPi / 2.0) {
        least = std::min(least, distances[i]);
      }
      lowest = std::min(lowest, torusU(above[i].p));
    }
    EXPECT_EQ(lowest >= kPi / 2.0, n >= 21) << n;
  }
  EXPECT_NEAR(least, 2.71, 0.05);
}

TEST(IsoFaces, SmallStepsMatchTheClosedForm) {
  // AT-07 at 1 mm: δ = Δ / √(1 + (u sin v)²).
  const SlicedLayers sliced = isoparam(inputOf(formulaPart("p4_quarter_torus.wsurf"), {0.01, 0.8}),
                                       R"({"step": 1.0, "first_layer": 0, "mode": "faces"})");
  for (std::size_t n = 1; n < 40; ++n) {
    const std::vector<Vec3> points = pointsOf(sliced.layers[n]);
    const std::vector<double> distances = layerDistance(points, sliced.layers[n - 1].contours);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double dip = torusU(points[i]) * std::sin(torusV(points[i]));
      EXPECT_NEAR(distances[i] * std::sqrt(1.0 + dip * dip), 1.0, 0.05) << n;
    }
  }
}

TEST(IsoFaces, TorusOnACylinderHasFourteenLayers) {
  plugin::SliceInput input = inputOf(formulaPart("p4_torus_179.wsurf"), {0.01, 0.8});
  input.substrate = cylinderSubstrate();
  const SlicedLayers sliced =
      isoparam(input, R"({"step": 5.0, "first_layer": 0, "mode": "faces"})");
  std::size_t layers = 0;
  for (std::size_t n = 0; n < sliced.layers.size() && layers == 0; ++n) {
    double least = 10.0;
    for (const Vec3& p : pointsOf(sliced.layers[n])) {
      least = std::min(least, torusU(p));
    }
    layers = least >= kPi / 2.0 ? n : 0;
  }
  EXPECT_EQ(layers, 14U);
}

TEST(IsoFaces, CurvesGoOnOverTheEdgesOfFaces) {
  // Two faces that continue each other at z = 15, between the layers: one wall of 40 mm.
  const auto wall = partFrom(
      R"json({"type": "revolution", "radius": [{"z": [0, 15], "radius": "30"},
                                           {"z": [15, 40], "radius": "30"}]})json");
  ASSERT_EQ(wall->brep->faceCount(), 2);
  const SlicedLayers sliced = isoparam(inputOf(wall), R"({"step": 2.0, "mode": "faces"})");
  ASSERT_EQ(sliced.layers.size(), 20U);
  for (std::size_t n = 0; n < sliced.layers.size(); ++n) {
    ASSERT_EQ(sliced.layers[n].contours.size(), 1U);
    EXPECT_TRUE(sliced.layers[n].contours[0].closed);
    for (const ContourPoint& point : sliced.layers[n].contours[0].points) {
      EXPECT_NEAR(point.p.z(), 2.0 * static_cast<double>(n + 1), 1e-6);
      EXPECT_NEAR(std::hypot(point.p.x(), point.p.y()), 30.0, 1e-6);
    }
  }
  // A cone of 45 degrees does not continue a cylinder: its face stays without layers.
  const auto kink = partFrom(
      R"json({"type": "revolution", "radius": [{"z": [0, 16], "radius": "30"},
                                           {"z": [16, 26], "radius": "46-z"}]})json");
  EXPECT_EQ(isoparam(inputOf(kink), R"({"step": 2.0, "mode": "faces"})").layers.size(), 8U);
}

TEST(IsoFaces, RefusesParametersThatRunAlongTheBase) {
  try {
    static_cast<void>(isoparam(inputOf(formulaPart("p4_quarter_torus.wsurf")),
                               R"({"mode": "faces", "direction": "v"})"));
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("face 0"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("90 degrees"));
  }
}

}  // namespace
}  // namespace wcam::toolpath
