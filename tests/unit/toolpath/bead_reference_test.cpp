// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/segment_tree.hpp"
#include "wcam/toolpath/build.hpp"

#include "hand_made_layers.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <random>

namespace wcam::toolpath {
namespace {

using geometry::Vec2;
using test::circle;
using test::layerOf;
using test::polygon;

Toolpath build(const SlicedLayers& sliced,
               const std::string& reference,
               double width,
               const JobContext& context = JobContext()) {
  BeadRange range;
  range.width = width;
  return buildToolpath(
      sliced, *test::plate(),
      PathParams::schema().read(parseJson(R"({"bead_reference": ")" + reference + "\"}")), context,
      range);
}

double area(const Bead& bead) {
  double sum = 0.0;
  for (std::size_t i = 1; i < bead.points.size(); ++i) {
    const Vec3& a = bead.points[i - 1].p;
    const Vec3& b = bead.points[i].p;
    sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return std::abs(sum);
}

bool cross(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto side = [](const Vec3& p, const Vec3& q, const Vec3& r) {
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  };
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

int selfCrossings(const Bead& bead) {
  int count = 0;
  for (std::size_t i = 1; i < bead.points.size(); ++i) {
    for (std::size_t k = i + 2; k < bead.points.size(); ++k) {
      count += cross(bead.points[i - 1].p, bead.points[i].p, bead.points[k - 1].p, bead.points[k].p)
                   ? 1
                   : 0;
    }
  }
  return count;
}

/// Least and greatest distance of a bead's points to a contour.
std::pair<double, double> distances(const Bead& bead, const Contour& contour) {
  geometry::SegmentTree tree;
  std::vector<Vec3> points;
  for (const ContourPoint& point : contour.points) {
    points.push_back(point.p);
  }
  tree.add(points, contour.closed);
  tree.build();
  double low = 1e9;
  double high = 0.0;
  for (const PathPoint& point : bead.points) {
    const double d = tree.distance(point.p);
    low = std::min(low, d);
    high = std::max(high, d);
  }
  return {low, high};
}

TEST(BeadReference, CirclesGetTheirNewRadiusAndKeepTheirHeight) {
  const SlicedLayers sliced{{layerOf(2.0, {circle(20, 2.0)}), layerOf(4.0, {circle(20, 4.0)})}};
  for (const auto& [reference, radius] :
       {std::pair<std::string, double>{"centre", 20.0}, {"inside", 23.0}, {"outside", 17.0}}) {
    const Toolpath path = build(sliced, reference, 6.0);
    ASSERT_EQ(path.layers[1].beads.size(), 1U);
    const Bead& bead = path.layers[1].beads[0];
    EXPECT_TRUE(bead.closed);
    EXPECT_EQ(bead.points.size(), 73U);
    for (const PathPoint& point : bead.points) {
      EXPECT_NEAR(std::hypot(point.p.x(), point.p.y()), radius, 1e-9);
      EXPECT_EQ(point.p.z(), 4.0);
      EXPECT_NEAR(point.distance, 2.0, 1e-9);
    }
  }
}

TEST(BeadReference, SquaresGetSharpInnerAndRoundOuterCorners) {
  const Contour square = polygon({{-20, -20}, {-20, 20}, {20, 20}, {20, -20}}, 2.0);
  const SlicedLayers sliced{{layerOf(2.0, {square})}};
  const Toolpath inner = build(sliced, "outside", 8.0);
  ASSERT_EQ(inner.layers[0].beads.size(), 1U);
  EXPECT_NEAR(area(inner.layers[0].beads[0]), 32.0 * 32.0, 1e-6);
  EXPECT_EQ(inner.layers[0].beads[0].points.size(), 5U);
  const Toolpath outer = build(sliced, "inside", 8.0);
  // Minkowski sum with a disc: chords inside the arcs by the chord error.
  const double exact = 1600.0 + 160.0 * 4.0 + kPi * 16.0;
  EXPECT_NEAR(area(outer.layers[0].beads[0]), exact, 4.0 * kPi * 2 * 0.01);
  EXPECT_LE(area(outer.layers[0].beads[0]), exact);
}

TEST(BeadReference, PinchedContoursFallApart) {
  // Two squares of 30 joined by a neck of 4: a bead of 8 does not pass.
  const Contour dumbbell = polygon({{-40, -15},
                                    {-40, 15},
                                    {-10, 15},
                                    {-10, 2},
                                    {10, 2},
                                    {10, 15},
                                    {40, 15},
                                    {40, -15},
                                    {10, -15},
                                    {10, -2},
                                    {-10, -2},
                                    {-10, -15}},
                                   2.0);
  const Toolpath path = build({{layerOf(2.0, {dumbbell})}}, "outside", 8.0);
  ASSERT_EQ(path.layers[0].beads.size(), 2U);
  for (const Bead& bead : path.layers[0].beads) {
    EXPECT_TRUE(bead.closed);
    EXPECT_EQ(selfCrossings(bead), 0);
    // The square of 22 and what bulges into the neck: discs of radius 4 around its two corners.
    EXPECT_GE(area(bead), 22.0 * 22.0 - 1e-6);
    EXPECT_LT(area(bead), 22.0 * 22.0 + 4.0 * 4.0);
    EXPECT_GE(distances(bead, dumbbell).first, 4.0 - 0.08);
  }
}

TEST(BeadReference, WhatIsTooNarrowVanishesWithAFinding) {
  JobContext context;
  const SlicedLayers sliced{{layerOf(2.0, {circle(3, 2.0), circle(30, 2.0)})}};
  const Toolpath path = build(sliced, "outside", 8.0, context);
  EXPECT_EQ(path.layers[0].beads.size(), 1U);
  EXPECT_EQ(context.diagnostics().count("toolpath.contour_vanished"), 1U);
  EXPECT_EQ(build(sliced, "inside", 8.0, context).layers[0].beads.size(), 2U);
}

TEST(BeadReference, RandomStarsHaveNoLoops) {
  constexpr unsigned kSeed = 7;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> radius(12.0, 45.0);
  for (int run = 0; run < 60; ++run) {
    std::vector<Vec2> corners;
    constexpr int kCorners = 14;
    for (int i = 0; i < kCorners; ++i) {
      const double a = -2 * kPi * i / kCorners;
      const double r = radius(random);
      corners.emplace_back(r * std::cos(a), r * std::sin(a));
    }
    const Contour star = polygon(corners, 2.0);
    for (const std::string reference : {"inside", "outside"}) {
      const Toolpath path = build({{layerOf(2.0, {star})}}, reference, 6.0);
      for (const Bead& bead : path.layers[0].beads) {
        EXPECT_TRUE(bead.closed);
        EXPECT_EQ(selfCrossings(bead), 0) << "seed " << kSeed << " run " << run << reference;
        EXPECT_GE(distances(bead, star).first, 3.0 - 0.06) << "seed " << kSeed << " run " << run;
        EXPECT_LE(distances(bead, star).second, 3.0 + 0.3) << "seed " << kSeed << " run " << run;
      }
    }
  }
}

TEST(BeadReference, CurvedLayersFollowTheSurfaceNormal) {
  // A latitude circle of a sphere: the bead moves along the radius of the sphere.
  Contour latitude;
  latitude.closed = true;
  const double beta = degToRad(30.0);
  for (int i = 0; i < 90; ++i) {
    const double a = -2 * kPi * i / 90;
    const Vec3 n(std::cos(beta) * std::cos(a), std::cos(beta) * std::sin(a), std::sin(beta));
    latitude.points.push_back({40.0 * n, n});
  }
  SlicedLayers sliced{{layerOf(20.0, {latitude})}, true};
  for (const auto& [reference, radius] :
       {std::pair<std::string, double>{"inside", 44.0}, {"outside", 36.0}}) {
    const Toolpath path = build(sliced, reference, 8.0);
    ASSERT_EQ(path.layers[0].beads.size(), 1U);
    for (const PathPoint& point : path.layers[0].beads[0].points) {
      EXPECT_NEAR(point.p.norm(), radius, 1e-9);
      EXPECT_NEAR(point.p.normalized().z(), 0.5, 1e-9);
    }
  }
}

TEST(BeadReference, OpenContoursStayOpenAndSpiralsKeepTheirRevolutions) {
  Contour angle;
  for (const Vec2& p : {Vec2(0, 40), Vec2(0, 0), Vec2(40, 0)}) {
    angle.points.push_back({Vec3(p.x(), p.y(), 2), Vec3(-1, -1, 0).normalized()});
  }
  angle.points[0].n = -Vec3::UnitX();
  angle.points[2].n = -Vec3::UnitY();
  std::reverse(angle.points.begin(), angle.points.end());
  const Toolpath inner = build({{layerOf(2.0, {angle})}}, "outside", 8.0);
  ASSERT_EQ(inner.layers[0].beads.size(), 1U);
  EXPECT_FALSE(inner.layers[0].beads[0].closed);
  EXPECT_NEAR(inner.layers[0].beads[0].length(), 72.0, 1e-6);
  const Toolpath outer = build({{layerOf(2.0, {angle})}}, "inside", 8.0);
  EXPECT_NEAR(outer.layers[0].beads[0].length(), 80.0 + 2.0 * kPi, 0.02);

  const Contour spiral = test::helix(20.0, 2.0, 5.5, 60);
  const Toolpath climbing = build({{layerOf(0.0, {spiral})}}, "inside", 8.0);
  ASSERT_EQ(climbing.layers[0].beads.size(), 1U);
  const Bead& bead = climbing.layers[0].beads[0];
  EXPECT_EQ(bead.revolutions, 6);
  ASSERT_EQ(bead.points.size(), spiral.points.size());
  EXPECT_NEAR(std::hypot(bead.points[99].p.x(), bead.points[99].p.y()), 24.0, 1e-9);
  EXPECT_NEAR(bead.points[99].distance, 2.0, 0.01);
}

}  // namespace
}  // namespace wcam::toolpath
