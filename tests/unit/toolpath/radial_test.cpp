// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <cmath>

namespace wcam::toolpath {
namespace {

using geometry::Vec3;

plugin::SliceInput inputOf(const std::shared_ptr<const geometry::PartSurface>& part) {
  return {{part}, test::plate(), nullptr, {0.01, 3.0}};
}

/// Flat flange between two radii in the plane z = 7, normal up.
geometry::TriangleMesh flange(double inner, double outer) {
  geometry::TriangleMesh mesh = test::tubeMesh(1.0, 1.0, 180, 20);
  for (Vec3& p : mesh.vertices) {
    const double angle = std::atan2(p.y(), p.x());
    const double radius = inner + p.z() * (outer - inner);
    p = Vec3(radius * std::cos(angle), radius * std::sin(angle), 7.0);
  }
  return mesh;
}

TEST(RadialSlicing, FlangeGrowsFromTheShaftInCircles) {
  const SlicedLayers sliced =
      test::slice("wcam.slicing.radial", inputOf(test::meshSurface(flange(20.0, 50.5))),
                  R"({"step": 2.0, "start": 20.0, "last_layer": "leave"})");
  ASSERT_EQ(sliced.layers.size(), 15U);
  EXPECT_TRUE(sliced.curved);
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    ASSERT_EQ(sliced.layers[l].contours.size(), 1U);
    const Contour& contour = sliced.layers[l].contours[0];
    EXPECT_TRUE(contour.closed);
    for (std::size_t i = 0; i < contour.points.size(); ++i) {
      const ContourPoint& point = contour.points[i];
      // Chords of the mesh's 180 columns cut the circle by r(1 − cos 1°).
      EXPECT_NEAR(std::hypot(point.p.x(), point.p.y()), 20.0 + 2.0 * static_cast<double>(l + 1),
                  0.01);
      EXPECT_NEAR(point.p.z(), 7.0, 1e-9);
      // Build direction away from the axis.
      const Vec3 t = contour.points[(i + 1) % contour.points.size()].p - point.p;
      EXPECT_GT(t.cross(point.n).dot(Vec3(point.p.x(), point.p.y(), 0.0)), 0.0);
    }
  }
  const Toolpath path =
      buildToolpath(sliced, *inputOf(test::meshSurface(flange(20.0, 50.5))).substrate, PathParams{},
                    JobContext());
  for (const Bead& bead : path.layers.back().beads) {
    for (const PathPoint& point : bead.points) {
      EXPECT_NEAR(point.height, 2.0, 0.02);
      EXPECT_NEAR(point.up.dot(Vec3(point.p.x(), point.p.y(), 0.0).normalized()), 1.0, 1e-3);
    }
  }
}

TEST(RadialSlicing, SpheresAndConesAreMetExactly) {
  // On a tube of radius 30 a sphere of radius s cuts z = √(s² − 900), a cone 2·h − √3·30.
  const auto part = test::meshSurface(test::tubeMesh(30.0, 80.0, 360, 80));
  const auto expectCircles = [](const SlicedLayers& sliced, const std::vector<double>& heights) {
    ASSERT_EQ(sliced.layers.size(), heights.size());
    for (std::size_t l = 0; l < heights.size(); ++l) {
      ASSERT_EQ(sliced.layers[l].contours.size(), 1U);
      EXPECT_TRUE(sliced.layers[l].contours[0].closed);
      for (const ContourPoint& point : sliced.layers[l].contours[0].points) {
        // Facets of one degree lie inside the circle by 0.0012 mm.
        EXPECT_NEAR(point.p.z(), heights[l], 2e-3) << l;
        EXPECT_NEAR(std::hypot(point.p.x(), point.p.y()), 30.0, 2e-3);
      }
    }
  };
  std::vector<double> heights;
  for (double s = 34.0; s * s < 900.0 + 6400.0; s += 4.0) {
    heights.push_back(std::sqrt(s * s - 900.0));
  }
  expectCircles(test::slice("wcam.slicing.radial", inputOf(part),
                            R"({"shape": "sphere", "step": 4.0, "start": 30.0,
                                "last_layer": "leave"})"),
                heights);
  // The cone's own start is the tube's lower border, at √3/2·30 from the cone through the origin.
  heights.clear();
  for (double h = 2.0; h <= 40.0; h += 2.0) {
    heights.push_back(2.0 * h);
  }
  expectCircles(test::slice("wcam.slicing.radial", inputOf(part),
                            R"({"shape": "cone", "cone_angle": 60.0, "step": 2.0,
                                "last_layer": "leave"})"),
                heights);
}

TEST(RadialSlicing, HalfPlanesCutARingIntoCircles) {
  // A torus of R = 50, r = 15 about z: every half-plane meets it in one circle, neighbours are one
  // step apart on the guide circle.
  geometry::TriangleMesh ring = test::torusMesh(50.0, 15.0, 90, 180);
  for (Vec3& p : ring.vertices) {
    p.z() += 20.0;
  }
  const SlicedLayers sliced =
      test::slice("wcam.slicing.radial", inputOf(test::meshSurface(ring)),
                  R"({"shape": "angle", "step": 5.0, "step_radius": 50.0, "sweep": 350.0})");
  const double step = 2.0 * std::asin(0.05);
  ASSERT_EQ(sliced.layers.size(), static_cast<std::size_t>(degToRad(350.0) / step));
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    const double angle = step * static_cast<double>(l + 1);
    ASSERT_EQ(sliced.layers[l].contours.size(), 1U) << l;
    EXPECT_TRUE(sliced.layers[l].contours[0].closed);
    for (const ContourPoint& point : sliced.layers[l].contours[0].points) {
      const double along = point.p.x() * std::cos(angle) + point.p.y() * std::sin(angle);
      EXPECT_NEAR(point.p.y() * std::cos(angle) - point.p.x() * std::sin(angle), 0.0, 1e-6);
      EXPECT_NEAR(std::hypot(along - 50.0, point.p.z() - 20.0), 15.0, 0.05);
    }
    // Layers grow about +z.
    EXPECT_NEAR(sliced.layers[l].up.dot(Vec3(-std::sin(angle), std::cos(angle), 0.0)), 1.0, 1e-3);
  }
}

TEST(RadialSlicing, BadParametersAreRefused) {
  const auto part = test::meshSurface(flange(20.0, 50.5));
  EXPECT_THROW((void)test::slice("wcam.slicing.radial", inputOf(part), R"({"step": 100.0})"),
               Error);
  EXPECT_THROW((void)test::slice("wcam.slicing.radial", inputOf(part),
                                 R"({"custom_axis": true, "axis_direction": [0, 0, 0]})"),
               Error);
}

}  // namespace
}  // namespace wcam::toolpath
