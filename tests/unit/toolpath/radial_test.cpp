// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"

#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

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

/// A ring of flat facets between two radii: a sheet at z = 4, or a solid from there on.
geometry::TriangleMesh facetRing(double inner, double outer, std::uint32_t facets, double thick) {
  geometry::TriangleMesh mesh;
  const std::vector<std::array<double, 2>> profile =
      thick > 0.0 ? std::vector<std::array<double, 2>>{{inner, 4.0},
                                                       {outer, 4.0},
                                                       {outer, 4.0 + thick},
                                                       {inner, 4.0 + thick}}
                  : std::vector<std::array<double, 2>>{{outer, 4.0}, {inner, 4.0}};
  const auto rows = static_cast<std::uint32_t>(profile.size());
  for (std::uint32_t i = 0; i < facets; ++i) {
    const double a = 0.3 + 2.0 * kPi * i / facets;
    for (const auto& [radius, z] : profile) {
      mesh.vertices.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
    }
  }
  for (std::uint32_t i = 0; i < facets; ++i) {
    const std::uint32_t next = (i + 1) % facets;
    for (std::uint32_t r = 0; r + (thick > 0.0 ? 0 : 1) < rows; ++r) {
      const std::uint32_t up = (r + 1) % rows;
      mesh.triangles.push_back({i * rows + r, next * rows + r, next * rows + up});
      mesh.triangles.push_back({i * rows + r, next * rows + up, i * rows + up});
    }
  }
  return mesh;
}

TEST(RadialSlicing, LastLayerLiesOnTheOuterSurfaceOfFacets) {
  for (const double thick : {0.0, 3.0}) {
    for (const std::uint32_t facets : {24U, 31U, 48U, 90U}) {
      for (const char* step : {"2.9", "2.75"}) {
        SCOPED_TRACE(std::to_string(facets) + " facets, thick " + std::to_string(thick));
        JobContext context;
        // 13.75 mm are five layers of 2.75 mm; the start is the inner border.
        const SlicedLayers sliced =
            test::slice("wcam.slicing.radial",
                        inputOf(test::meshSurface(facetRing(17.0, 30.75, facets, thick))),
                        std::string(R"({"last_layer": "fit", "step": )") + step + "}", context);
        ASSERT_EQ(sliced.layers.size(), 5U);
        for (std::size_t l = 0; l < 5; ++l) {
          const double radius = 17.0 + 2.75 * static_cast<double>(l + 1);
          EXPECT_NEAR(sliced.layers[l].level, radius, 1e-6);
          ASSERT_EQ(sliced.layers[l].contours.size(), thick > 0.0 ? 2U : 1U);
          for (const Contour& contour : sliced.layers[l].contours) {
            EXPECT_TRUE(contour.closed);
            for (const ContourPoint& point : contour.points) {
              const double r = std::hypot(point.p.x(), point.p.y());
              EXPECT_LE(r, radius + 0.02);
              EXPECT_GE(r, radius * std::cos(kPi / facets) - 0.02);
            }
          }
        }
        EXPECT_EQ(context.diagnostics().count("slicing.degenerate_contour"), 0U);
        EXPECT_EQ(context.diagnostics().count("slicing.rest"), 0U);
        EXPECT_EQ(context.diagnostics().count("slicing.step_fitted"), step[2] == '9' ? 1U : 0U);
      }
    }
  }
}

TEST(RadialSlicing, RestAtAPrismIsAFinding) {
  // An octagon of 30 mm: its sides are 2.28 mm nearer than its corners, which is no chord error.
  JobContext context;
  const SlicedLayers sliced =
      test::slice("wcam.slicing.radial", inputOf(test::meshSurface(facetRing(20.0, 30.0, 8, 0.0))),
                  R"({"step": 2.8, "start": 20.0, "last_layer": "fit"})", context);
  EXPECT_NEAR(sliced.layers.back().level, 28.4, 1e-9);
  const auto found = context.diagnostics().items();
  const auto rest = std::find_if(found.begin(), found.end(),
                                 [](const Diagnostic& d) { return d.code == "slicing.rest"; });
  ASSERT_NE(rest, found.end());
  EXPECT_NE(rest->message.str().find("1.600 mm at its corners"), std::string::npos)
      << rest->message.str();
}

TEST(RadialSlicing, PointsOfALayerAreOneFinding) {
  // At the corners of the octagon the layer at 30 mm has eight points.
  JobContext context;
  (void)test::slice("wcam.slicing.radial",
                    inputOf(test::meshSurface(facetRing(20.0, 30.0, 8, 0.0))),
                    R"({"step": 2.5, "start": 20.0})", context);
  EXPECT_LE(context.diagnostics().count("slicing.degenerate_contour"), 1U);
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
