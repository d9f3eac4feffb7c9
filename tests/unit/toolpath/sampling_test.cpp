// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"
#include "wcam/toolpath/slice_field.hpp"

#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

namespace wcam::toolpath {
namespace {

TEST(ChordSampling, CountsOfTheThesisCircle) {
  // Chalvin AT-01: circle of diameter 600.
  EXPECT_EQ(chordCount(300.0, 0.5), 55);
  EXPECT_EQ(chordCount(300.0, 0.1), 122);
  EXPECT_EQ(chordCount(300.0, 0.01), 385);
  EXPECT_EQ(chordCount(300.0, 0.5, true), 54);
  EXPECT_EQ(chordCount(300.0, 0.1, true), 122);
  EXPECT_EQ(chordCount(300.0, 0.01, true), 385);
  const auto spacing = [](int n) { return 600.0 * std::sin(kPi / n); };
  EXPECT_NEAR(spacing(chordCount(300.0, 0.5, true)), 34.887, 0.001);
  EXPECT_NEAR(spacing(chordCount(300.0, 0.1, true)), 15.449, 0.001);
  EXPECT_NEAR(spacing(chordCount(300.0, 0.01, true)), 4.896, 0.001);
  for (const double e : {0.5, 0.1, 0.01}) {
    EXPECT_LE(300.0 * (1.0 - std::cos(kPi / chordCount(300.0, e))), e);
  }
  EXPECT_THROW((void)chordCount(0.0, 0.1), Error);
}

std::vector<Vec3> pointsOf(const Contour& contour) {
  std::vector<Vec3> points;
  for (const ContourPoint& point : contour.points) {
    points.push_back(point.p);
  }
  return points;
}

double largestSpacing(const Contour& contour) {
  double largest = 0.0;
  const std::vector<Vec3> p = pointsOf(contour);
  for (std::size_t i = 0; i + (contour.closed ? 0 : 1) < p.size(); ++i) {
    largest = std::max(largest, (p[(i + 1) % p.size()] - p[i]).norm());
  }
  return largest;
}

/// The equator section of the exact hemisphere: a true circle of radius √(45² − z²).
Contour circleAt(double z, const Sampling& sampling) {
  plugin::SliceInput input{
      {test::importSample("hemisphere/hemisphere.step")}, test::plate(), nullptr, sampling};
  const auto sliced = test::slice(
      "wcam.slicing.planar", input,
      "{\"step\": " + std::to_string(z) + ", \"end_height\": " + std::to_string(1.5 * z) + "}");
  return sliced.layers.at(0).contours.at(0);
}

TEST(ChordSampling, AnExactCircleGetsTheCountOfTheFormula) {
  const double radius = std::sqrt(45.0 * 45.0 - 100.0);
  for (const double e : {0.5, 0.1, 0.01, 0.001}) {
    const Contour circle = circleAt(10.0, {e, 1000.0});
    EXPECT_EQ(static_cast<int>(circle.points.size()), chordCount(radius, e)) << "chord error " << e;
    for (std::size_t i = 0; i < circle.points.size(); ++i) {
      const Vec3 middle =
          0.5 * (circle.points[i].p + circle.points[(i + 1) % circle.points.size()].p);
      EXPECT_LE(radius - std::hypot(middle.x(), middle.y()), e * (1.0 + 1e-6));
    }
  }
}

TEST(ChordSampling, SpacingBoundsFlatCurves) {
  const Contour circle = circleAt(10.0, {0.5, 2.0});
  EXPECT_LE(largestSpacing(circle), 2.0 * (1.0 + 1e-9));
  EXPECT_GT(largestSpacing(circle), 1.95);
  plugin::SliceInput box{{test::meshSurface(test::boxMesh({0, 0, 0}, {50, 30, 10}))},
                         test::plate(),
                         nullptr,
                         {0.01, 4.9}};
  const auto sliced = test::slice("wcam.slicing.planar", box, R"({"step": 4.0})");
  ASSERT_EQ(sliced.layers.size(), 2U);
  const Contour& outline = sliced.layers[0].contours.at(0);
  EXPECT_LE(largestSpacing(outline), 4.9 * (1.0 + 1e-9));
  // 50/4.9 and 30/4.9 rounded up, twice each; the corners are points.
  EXPECT_EQ(outline.points.size(), 2U * (11U + 7U));
  for (const Vec3& corner : {Vec3(0, 0, 4), Vec3(50, 0, 4), Vec3(50, 30, 4), Vec3(0, 30, 4)}) {
    const auto points = pointsOf(outline);
    EXPECT_TRUE(std::any_of(points.begin(), points.end(),
                            [&](const Vec3& p) { return (p - corner).norm() < 1e-12; }));
  }
}

TEST(ChordSampling, CornersOfExactPartsStayPoints) {
  const auto part = test::importSample("supportless/supportless_sample.stp");
  plugin::SliceInput input{{part}, test::plate(), nullptr, {0.01, 1000.0}};
  const auto sliced =
      test::slice("wcam.slicing.planar", input, R"({"step": 10.0, "last_layer": "leave"})");
  // A plane crosses the sharp edges of the part in the corners of the section.
  std::size_t corners = 0;
  for (const SlicedLayer& layer : sliced.layers) {
    for (std::uint32_t h = 0; h < 3 * part->mesh.triangles.size(); ++h) {
      const auto& t = part->mesh.triangles[h / 3];
      const geometry::Vec3& a = part->mesh.vertices[t[h % 3]];
      const geometry::Vec3& b = part->mesh.vertices[t[(h % 3 + 1) % 3]];
      constexpr double kClear = 0.01;
      constexpr double kSharp = 0.9;  // cosine of the angle between the normals of both sides
      const std::uint32_t twin = part->halfEdges.twin(h);
      if (part->binding.edge[h] < 0 || twin == geometry::HalfEdges::kNone ||
          part->mesh.normal(h / 3).dot(part->mesh.normal(twin / 3)) > kSharp ||
          std::min(a.z(), b.z()) > layer.level - kClear ||
          std::max(a.z(), b.z()) < layer.level + kClear) {
        continue;
      }
      const geometry::Vec3 corner = a + (layer.level - a.z()) / (b.z() - a.z()) * (b - a);
      double nearest = 1e9;
      for (const Contour& contour : layer.contours) {
        for (const ContourPoint& point : contour.points) {
          nearest = std::min(nearest, (point.p - corner).norm());
        }
      }
      // Edges are curved; their chords lie off them by the tolerance of the tessellation.
      EXPECT_LT(nearest, 0.05) << corner.transpose();
      ++corners;
    }
  }
  EXPECT_GT(corners, 20U);
}

}  // namespace
}  // namespace wcam::toolpath
