// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/iso_parametric.hpp"

#include "wcam/base/error.hpp"
#include "wcam/toolpath/layer_distance.hpp"

#include "constant_fixture.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

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
              testing::HasSubstr("no body of revolution"));
  EXPECT_THAT(refusal(inputOf(box), "{}"), testing::HasSubstr("is a mesh"));
  EXPECT_THAT(refusal(inputOf(formulaPart("p4_quarter_torus.wsurf")),
                      R"({"mode": "revolution", "custom_axis": true})"),
              testing::HasSubstr("off the profile"));
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
  // The nozzle's three faces: cone-like, ring, cone-like; the ring breaks the curves.
  const SlicedLayers sliced = isoparam(inputOf(test::importSample("elbow/elbow.step")),
                                       R"({"step": 2.0, "mode": "faces"})");
  EXPECT_GT(sliced.layers.size(), 20U);
}

TEST(IsoFaces, RefusesParametersThatRunAlongTheBase) {
  try {
    static_cast<void>(isoparam(inputOf(formulaPart("p4_quarter_torus.wsurf")),
                               R"({"mode": "faces", "direction": "v"})"));
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("face 0"));
    EXPECT_THAT(error.what(), testing::HasSubstr("90 degrees"));
  }
}

}  // namespace
}  // namespace wcam::toolpath
