// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/constant_distance.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/guide_curve.hpp"
#include "wcam/toolpath/layer_distance.hpp"

#include "constant_fixture.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

/// Constant inter-layer distance on the test parts of Chalvin (AT-08 … AT-15).
namespace wcam::toolpath {
namespace {

using namespace constant_test;

TEST(ConstantDistance, TorusHasTheStepEverywhere) {
  // AT-09, on a torus of 150 degrees so that the last layers are whole.
  JobContext context;
  const SlicedLayers sliced =
      test::slice("wcam.slicing.constant", inputOf(formulaPart("p4_torus_150.wsurf"), {0.001, 4.9}),
                  R"({"step": 5.0, "first_layer": 0})", context);
  plot(sliced, "torus");
  for (const Diagnostic& d : context.diagnostics().items()) {
    ADD_FAILURE() << toLine(d);
  }
  ASSERT_GE(sliced.layers.size(), 18U);
  EXPECT_LE(worstDistance(sliced, 5.0), 0.01);
  for (std::size_t n = 0; n <= 17; ++n) {
    SCOPED_TRACE("layer " + std::to_string(n));
    const SlicedLayer& layer = sliced.layers[n];
    ASSERT_EQ(layer.contours.size(), 1U);
    EXPECT_TRUE(layer.contours[0].closed);
    EXPECT_NEAR(uAt(layer, kPi), static_cast<double>(n) * 2.0 * std::asin(5.0 / 70.0), 1e-4);
    double least = 10.0;
    for (const Vec3& p : pointsOf(layer)) {
      least = std::min(least, torusU(p));
      const Vec3 centre = kR * Vec3(p.x() + kR, 0, p.z()).normalized() - Vec3(kR, 0, 0);
      EXPECT_NEAR((p - centre).norm(), kr, 1e-6);
    }
    EXPECT_EQ(least >= kPi / 2.0, n >= 17);
  }
  EXPECT_NEAR(radToDeg(uAt(sliced.layers[10], 0.0)), 44.1, 0.3);
  EXPECT_NEAR(radToDeg(uAt(sliced.layers[17], 0.0)), 92.4, 0.3);
}

/// Greatest change of direction between neighbouring chords, rad.
double sharpestTurn(const SlicedLayer& layer) {
  double turn = 0.0;
  for (const Contour& contour : layer.contours) {
    const std::size_t n = contour.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 a = contour.points[(i + 1) % n].p - contour.points[i].p;
      const Vec3 b = contour.points[(i + 2) % n].p - contour.points[(i + 1) % n].p;
      turn = std::max(turn, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  }
  return turn;
}

TEST(ConstantDistance, TorusKinksWhereTheGeodesicsMeet) {
  // AT-10, about 120 points per layer: smooth up to s = 45 mm, an exact corner at the end.
  const SlicedLayers sliced =
      test::slice("wcam.slicing.constant", inputOf(formulaPart("p4_torus_150.wsurf"), {0.01, 0.8}),
                  R"({"step": 5.0, "first_layer": 0})");
  ASSERT_GE(sliced.layers.size(), 18U);
  for (std::size_t n = 1; n <= 9; ++n) {
    EXPECT_LE(radToDeg(sharpestTurn(sliced.layers[n])), 12.0) << "layer " << n;
  }
  EXPECT_NEAR(radToDeg(sharpestTurn(sliced.layers[17])), 112.7, 3.0);
  EXPECT_LE(worstDistance(sliced, 5.0), 0.01);
}

TEST(ConstantDistance, TorusConvergesToTheGeodesicDistance) {
  // AT-10, second half: layers of 0.5 mm count the geodesic distance from the base.
  const SlicedLayers sliced =
      test::slice("wcam.slicing.constant", inputOf(formulaPart("p4_quarter_torus.wsurf")),
                  R"({"step": 0.5, "first_layer": 0, "mesh_edge": 0.45})");
  const auto distanceTo = [&](double degrees) {
    for (std::size_t l = 1; l < sliced.layers.size(); ++l) {
      const double u0 = uAt(sliced.layers[l - 1], 0.0);
      const double u1 = uAt(sliced.layers[l], 0.0);
      if (u1 >= degToRad(degrees)) {
        return 0.5 * (static_cast<double>(l) - (u1 - degToRad(degrees)) / (u1 - u0));
      }
    }
    return 0.0;
  };
  EXPECT_NEAR(distanceTo(45.0), 50.962, 0.01 * 50.962);
  EXPECT_NEAR(distanceTo(60.0), 63.616, 0.01 * 63.616);
  EXPECT_NEAR(distanceTo(89.5), 83.546, 0.012 * 83.546);
  EXPECT_LE(worstDistance(sliced, 0.5), 0.01);
}

TEST(ConstantDistance, TorusOnACylinder) {
  // AT-08 and AT-11.
  plugin::SliceInput input = inputOf(formulaPart("p4_torus_150.wsurf"), {0.001, 4.9});
  input.substrate = cylinderSubstrate();
  const SlicedLayers sliced =
      test::slice("wcam.slicing.constant", input, R"({"step": 5.0, "first_layer": 0})");
  plot(sliced, "cylinder");
  ASSERT_GE(sliced.layers.size(), 13U);
  const SlicedLayer& base = sliced.layers[0];
  ASSERT_EQ(base.contours.size(), 1U);
  EXPECT_TRUE(base.contours[0].closed);
  for (const Vec3& p : pointsOf(base)) {
    EXPECT_NEAR(p.x() * p.x() + p.z() * p.z(), 1024.0, 1e-9);
  }
  EXPECT_NEAR(radToDeg(uAt(base, 0.0)), 28.71, 0.01);
  EXPECT_NEAR(radToDeg(uAt(base, kPi / 2.0)), 37.33, 0.01);
  EXPECT_NEAR(radToDeg(uAt(base, kPi)), 39.49, 0.01);
  EXPECT_LE(worstDistance(sliced, 5.0), 0.01);
  for (std::size_t n = 0; n <= 12; ++n) {
    double least = 10.0;
    for (const Vec3& p : pointsOf(sliced.layers[n])) {
      least = std::min(least, torusU(p));
    }
    EXPECT_EQ(least >= kPi / 2.0, n >= 12) << n;
  }
}

TEST(ConstantDistance, CornersAreRoundedWithinTheBound) {
  const auto part = formulaPart("p4_torus_150.wsurf");
  const SlicedLayers sharp =
      test::slice("wcam.slicing.constant", inputOf(part, {0.002, 0.8}), R"({"step": 5.0})");
  JobContext context;
  const SlicedLayers rounded = test::slice("wcam.slicing.constant", inputOf(part, {0.002, 0.8}),
                                           R"({"step": 5.0, "corner_bound": 0.4})", context);
  plot(rounded, "rounded");
  EXPECT_EQ(context.diagnostics().count("slicing.corners_rounded"), 1U);
  EXPECT_EQ(context.diagnostics().count(Severity::Warning), 0U);
  ASSERT_EQ(sharp.layers.size(), rounded.layers.size());
  EXPECT_LE(worstDistance(rounded, 5.0), 0.4 + 0.002);
  for (std::size_t n = 11; n < 17; ++n) {
    EXPECT_GT(radToDeg(sharpestTurn(sharp.layers[n])), 60.0);
    EXPECT_LT(radToDeg(sharpestTurn(rounded.layers[n])), 25.0);
    for (const Vec3& p : pointsOf(rounded.layers[n])) {
      const Vec3 centre = kR * Vec3(p.x() + kR, 0, p.z()).normalized() - Vec3(kR, 0, 0);
      EXPECT_NEAR((p - centre).norm(), kr, 1e-6);
    }
    for (const double d : layerDistance(pointsOf(rounded.layers[n]), sharp.layers[n].contours)) {
      EXPECT_LE(d, 0.2 + 0.002);
    }
  }
}

TEST(ConstantDistance, TheBaseStaysAsItIs) {
  const SlicedLayers sliced =
      test::slice("wcam.slicing.constant", inputOf(formulaPart("p4_quarter_torus.wsurf")),
                  R"({"step": 5.0, "first_layer": 0})");
  for (const Vec3& p : pointsOf(sliced.layers[0])) {
    EXPECT_NEAR(p.z(), 0.0, 1e-12);
    EXPECT_NEAR(std::hypot(p.x(), p.y()), kr, 1e-7);
  }
  EXPECT_NEAR((sliced.layers[0].up - Vec3::UnitZ()).norm(), 0.0, 1e-6);
  EXPECT_TRUE(sliced.curved);
}

/// Guide parameter of a point of the general tube.
double tubeParameter(const geometry::GuideCurve& guide, const Vec3& p) {
  double low = guide.begin();
  double high = guide.end();
  for (int i = 0; i < 50; ++i) {
    const double t = 0.5 * (low + high);
    const geometry::CurvePoint g = guide.evaluate(t);
    ((p - g.p).dot(g.d1) > 0.0 ? low : high) = t;
  }
  return low;
}

TEST(ConstantDistance, GeneralTube) {
  // AT-12, second half, and AT-14.
  JobContext context;
  const SlicedLayers sliced =
      test::slice("wcam.slicing.constant", inputOf(formulaPart("p6_tube_extended.wsurf")),
                  R"({"step": 1.0, "first_layer": 0})", context);
  plot(sliced, "tube");
  EXPECT_EQ(context.diagnostics().items().size(), 0U);
  EXPECT_LE(worstDistance(sliced, 1.0), 0.01);
  const auto guide =
      geometry::guideFromFormula({"(0.005*t^3-0.22*t^2)/6", "0.02*t^2", "t"}, 0.0, 46.0);
  std::vector<Vec3> below;
  std::vector<double> belowT;
  std::size_t layers = 0;
  for (std::size_t n = 0; n < sliced.layers.size() && layers == 0; ++n) {
    const std::vector<Vec3> points = pointsOf(sliced.layers[n]);
    std::vector<double> parameters;
    for (const Vec3& p : points) {
      parameters.push_back(tubeParameter(*guide, p));
      double nearest = 1e9;
      double nearestT = -1.0;
      for (std::size_t i = 0; i < below.size(); ++i) {
        if ((below[i] - p).squaredNorm() < nearest) {
          nearest = (below[i] - p).squaredNorm();
          nearestT = belowT[i];
        }
      }
      EXPECT_GT(parameters.back(), nearestT) << "layer " << n;
    }
    if (*std::min_element(parameters.begin(), parameters.end()) >= 40.0) {
      layers = n;
    }
    below = points;
    belowT = parameters;
  }
  EXPECT_NEAR(static_cast<double>(layers), 58.0, 1.0);
}

TEST(ConstantDistance, ATorusAsATubeGivesTheSameLayers) {
  // AT-13.
  const SlicedLayers a =
      test::slice("wcam.slicing.constant", inputOf(formulaPart("p4_torus_150.wsurf"), {0.001, 4.9}),
                  R"({"step": 5.0})");
  const SlicedLayers b =
      test::slice("wcam.slicing.constant",
                  inputOf(formulaPart("p4_torus_tube.wsurf"), {0.001, 4.9}), R"({"step": 5.0})");
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t n = 0; n < 17; ++n) {
    for (const double d : layerDistance(pointsOf(a.layers[n]), b.layers[n].contours)) {
      EXPECT_LE(d, 0.02) << "layer " << n;
    }
  }
}

TEST(ConstantDistance, CutByAPlane) {
  // AT-15: the end plane of the quarter torus.
  const SlicedLayers sliced = test::slice(
      "wcam.slicing.constant", inputOf(formulaPart("p4_torus_150.wsurf")),
      R"({"step": 5.0, "cut": true, "cut_point": [-50, 0, 0], "cut_normal": [-2, 0, 0]})");
  std::size_t open = 0;
  for (const SlicedLayer& layer : sliced.layers) {
    for (const Contour& contour : layer.contours) {
      for (const ContourPoint& point : contour.points) {
        EXPECT_LE(-50.0 - point.p.x(), 1e-9);
      }
      if (!contour.closed) {
        ++open;
        EXPECT_NEAR(contour.points.front().p.x(), -50.0, 1e-9);
        EXPECT_NEAR(contour.points.back().p.x(), -50.0, 1e-9);
      }
    }
  }
  EXPECT_GE(open, 4U);
  EXPECT_EQ(sliced.layers.size(), 16U);  // the 17th passes the plane everywhere
  EXPECT_LE(worstDistance(sliced, 5.0), 0.02);
}

TEST(ConstantDistance, StraightTubeHasPlaneLayersOnMeshAndOrderDoesNotMatter) {
  geometry::TriangleMesh mesh = test::tubeMesh(10.0, 20.0, 64, 9);
  const auto heights = [](const SlicedLayers& sliced) {
    for (std::size_t n = 0; n < sliced.layers.size(); ++n) {
      EXPECT_EQ(sliced.layers[n].contours.size(), 1U);
      for (const Vec3& p : pointsOf(sliced.layers[n])) {
        EXPECT_NEAR(p.z(), 1.5 * static_cast<double>(n + 1), 1e-6);
      }
    }
    return sliced.layers.size();
  };
  const char* params = R"({"step": 1.5})";
  EXPECT_EQ(heights(test::slice("wcam.slicing.constant", inputOf(test::meshSurface(mesh)), params)),
            13U);
  std::mt19937 random(7);
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
  for (auto& t : mesh.triangles) {
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random() % 3), t.end());
  }
  EXPECT_EQ(heights(test::slice("wcam.slicing.constant", inputOf(test::meshSurface(mesh)), params)),
            13U);
}

TEST(ConstantDistance, ClosedBoxIsCoveredOverItsTop) {
  const auto box = test::meshSurface(test::boxMesh({-10, -6, 0}, {10, 6, 8}));
  const SlicedLayers sliced =
      test::slice("wcam.slicing.constant", inputOf(box), R"({"step": 1.3})");
  plot(sliced, "box");
  EXPECT_LE(worstDistance(sliced, 1.3), 0.01);
  // Up the wall, then inwards on the top to its middle line.
  EXPECT_NEAR(static_cast<double>(sliced.layers.size()), (8.0 + 6.0) / 1.3, 2.0);
  for (const Contour& contour : sliced.layers.front().contours) {
    for (const ContourPoint& point : contour.points) {
      EXPECT_NEAR(point.p.z(), 1.3, 1e-9);
    }
  }
}

/// A profile (radius, height) turned about z.
geometry::TriangleMesh lathe(const std::vector<geometry::Vec2>& profile, int around) {
  geometry::TriangleMesh mesh;
  for (const geometry::Vec2& p : profile) {
    for (int j = 0; j < around; ++j) {
      const double v = 2.0 * kPi * j / around;
      mesh.vertices.emplace_back(p[0] * std::cos(v), p[0] * std::sin(v), p[1]);
    }
  }
  const auto index = [&](std::size_t i, int j) {
    return static_cast<std::uint32_t>(i * static_cast<std::size_t>(around) +
                                      static_cast<std::size_t>(j % around));
  };
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    for (int j = 0; j < around; ++j) {
      mesh.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
    }
  }
  return mesh;
}

TEST(ConstantDistance, TheOtherSideOfAThinDoubleWallIsFarAway) {
  const auto part = test::meshSurface(lathe({{10, 0}, {10, 12}, {9.5, 12}, {9.5, 0}}, 96));
  const SlicedLayers sliced =
      test::slice("wcam.slicing.constant", inputOf(part), R"({"step": 2.0})");
  ASSERT_GE(sliced.layers.size(), 5U);
  for (std::size_t n = 0; n < 5; ++n) {
    EXPECT_EQ(sliced.layers[n].contours.size(), 2U);
    for (const Vec3& p : pointsOf(sliced.layers[n])) {
      EXPECT_NEAR(p.z(), 2.0 * static_cast<double>(n + 1), 1e-6);
    }
  }
}

TEST(ConstantDistance, MovesAndScalesWithThePart) {
  geometry::TriangleMesh mesh = lathe({{10, 0}, {12, 6}, {9, 13}, {11, 20}}, 48);
  const SlicedLayers a =
      test::slice("wcam.slicing.constant", inputOf(test::meshSurface(mesh)), R"({"step": 1.5})");
  for (Vec3& v : mesh.vertices) {
    v = Vec3(-2.0 * v.y() + 30.0, 2.0 * v.x() - 7.0, 2.0 * v.z());
  }
  const SlicedLayers b = test::slice(
      "wcam.slicing.constant", inputOf(test::meshSurface(mesh), {0.02, 9.8}), R"({"step": 3.0})");
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t n = 0; n < a.layers.size(); ++n) {
    std::vector<Vec3> moved;
    for (const Vec3& p : pointsOf(a.layers[n])) {
      moved.emplace_back(-2.0 * p.y() + 30.0, 2.0 * p.x() - 7.0, 2.0 * p.z());
    }
    for (const double d : layerDistance(moved, b.layers[n].contours)) {
      EXPECT_LE(d, 0.05);
    }
  }
}

TEST(ConstantDistance, RefusesWithTheReason) {
  const auto refusal = [](const plugin::SliceInput& input, const char* params) {
    try {
      static_cast<void>(test::slice("wcam.slicing.constant", input, params));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const auto tube = test::meshSurface(test::tubeMesh(10.0, 20.0, 32, 4));
  plugin::SliceInput floating = inputOf(tube);
  floating.substrate = test::plate(-5.0);
  EXPECT_THAT(refusal(floating, R"({"step": 1})"), testing::HasSubstr("5.000 mm above it"));
  plugin::SliceInput buried = inputOf(tube);
  buried.substrate = test::plate(25.0);
  EXPECT_THAT(refusal(buried, R"({"step": 1})"), testing::HasSubstr("below the substrate"));
  EXPECT_THAT(refusal(inputOf(tube), R"({"step": 50})"), testing::HasSubstr("no layer fits"));
  EXPECT_THAT(refusal(inputOf(tube), R"({"step": 1, "cut": true, "cut_normal": [0, 0, 0]})"),
              testing::HasSubstr("no length"));
}

TEST(ConstantDistance, APieceWithoutBaseIsReported) {
  geometry::TriangleMesh mesh = test::tubeMesh(10.0, 20.0, 32, 4);
  const geometry::TriangleMesh ball = test::boxMesh({30, 0, 5}, {40, 10, 15});
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), ball.vertices.begin(), ball.vertices.end());
  for (auto t : ball.triangles) {
    mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  JobContext context;
  static_cast<void>(test::slice("wcam.slicing.constant", inputOf(test::meshSurface(mesh)),
                                R"({"step": 2})", context));
  EXPECT_EQ(context.diagnostics().count("slicing.not_reached"), 1U);
}

}  // namespace
}  // namespace wcam::toolpath
