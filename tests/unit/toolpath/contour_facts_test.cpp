// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/build.hpp"
#include "wcam/toolpath/layer_distance.hpp"

#include "hand_made_layers.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

namespace wcam::toolpath {
namespace {

using test::circle;
using test::helix;
using test::layerOf;

Toolpath build(const SlicedLayers& sliced, const std::string& params = "{}") {
  return buildToolpath(sliced, *test::plate(), PathParams::schema().read(parseJson(params)),
                       JobContext());
}

TEST(ContourFacts, AGivenHeightIsKeptBesideTheMeasuredDistance) {
  SlicedLayers sliced{{layerOf(2.0, {circle(20, 2.0)}), layerOf(4.0, {circle(20, 4.0)})}};
  for (ContourPoint& point : sliced.layers[1].contours[0].points) {
    point.height = 1.7;
    point.width = 6.5;
  }
  const Toolpath path = build(sliced);
  for (const PathPoint& point : path.layers[1].beads[0].points) {
    EXPECT_NEAR(point.distance, 2.0, 1e-12);
    EXPECT_EQ(point.height, 1.7);
    EXPECT_EQ(point.width, 6.5);
  }
  for (const PathPoint& point : path.layers[0].beads[0].points) {
    EXPECT_EQ(point.height, point.distance);
    EXPECT_EQ(point.width, 0.0);
  }
}

TEST(ContourFacts, GroupsAreDepositedInTheirOrderAndFeaturesAreKept) {
  SlicedLayer layer = layerOf(2.0, {});
  for (int i = 0; i < 6; ++i) {
    Contour contour = circle(5.0, 2.0, Vec3(20.0 * i, 0, 0));
    contour.group = (i * 5) % 3;
    contour.feature = contour.group == 0 ? BeadFeature::Wall : BeadFeature::Fill;
    layer.contours.push_back(contour);
  }
  const Toolpath path = build({{layer}});
  ASSERT_EQ(path.layers[0].beads.size(), 6U);
  for (std::size_t b = 0; b < 6; ++b) {
    EXPECT_EQ(path.layers[0].beads[b].feature, b < 2 ? BeadFeature::Wall : BeadFeature::Fill);
  }
}

TEST(ContourFacts, ASpiralMeasuresItsOwnRevolutionBefore) {
  const SlicedLayers sliced{{layerOf(0.0, {helix(20.0, 2.0, 6.4, 90)})}};
  const Toolpath path = build(sliced, R"({"alternate": true, "seam": "golden"})");
  const Bead& bead = path.layers[0].beads[0];
  ASSERT_EQ(bead.points.size(), sliced.layers[0].contours[0].points.size());
  EXPECT_FALSE(bead.closed);
  // The helix of pitch 2 on radius 20: neighbouring turns are 2·cos(slope) apart.
  const double apart = 2.0 * std::cos(std::atan(2.0 / (2.0 * kPi * 20.0)));
  for (std::size_t i = 0; i < bead.points.size(); ++i) {
    EXPECT_EQ(bead.points[i].p, sliced.layers[0].contours[0].points[i].p);
    if (i >= 90) {
      // Chords of 4° stand 0.012 mm inside the circle.
      EXPECT_NEAR(bead.points[i].distance, apart, 1e-3) << i;
    } else if (i > 0) {
      EXPECT_NEAR(bead.points[i].distance, bead.points[i].p.z(), 1e-12) << i;
    }
  }
}

TEST(ContourFacts, TheFirstRevolutionMeasuresTheLayersBelow) {
  Contour spiral = helix(20.0, 2.0, 3.0, 90);
  for (ContourPoint& point : spiral.points) {
    point.p.z() += 10.0;
  }
  const SlicedLayers sliced{
      {layerOf(9.0, {circle(20, 9.0, Vec3::Zero(), 90)}), layerOf(10.0, {spiral})}};
  const Bead bead = build(sliced).layers[1].beads[0];
  for (std::size_t i = 0; i < 90; ++i) {
    EXPECT_NEAR(bead.points[i].distance, bead.points[i].p.z() - 9.0, 1e-9);
  }
}

TEST(ContourFacts, DistancesGoToTheLayersThatTheStrategyNames) {
  SlicedLayers sliced{{layerOf(2.0, {circle(20, 2.0)}), layerOf(3.0, {circle(8, 3.0)}),
                       layerOf(5.0, {circle(20, 5.0)}), layerOf(50.0, {circle(8, 50.0)})}};
  sliced.layers[2].below = {{0}};
  sliced.layers[3].below = std::vector<std::size_t>{};
  const Toolpath path = build(sliced);
  EXPECT_NEAR(path.layers[2].beads[0].points[7].distance, 3.0, 1e-12);
  EXPECT_NEAR(path.layers[3].beads[0].points[7].distance, 50.0, 1e-12);
  sliced.layers[2].below = {{9}};
  EXPECT_THROW(build(sliced), Error);
}

TEST(ContourFacts, CurvedLayersTakeTheLocalAxisByThemselves) {
  Contour cone = circle(20, 2.0);
  for (ContourPoint& point : cone.points) {
    point.n = (point.n + Vec3(0, 0, -0.5)).normalized();
  }
  SlicedLayers sliced{{layerOf(2.0, {cone})}};
  EXPECT_EQ(build(sliced).layers[0].beads[0].points[3].axis, Vec3::UnitZ());
  sliced.curved = true;
  const Toolpath path = build(sliced);
  const PathPoint& point = path.layers[0].beads[0].points[3];
  EXPECT_EQ(point.axis, point.b);
  EXPECT_NEAR(point.b.z(), std::cos(std::atan(0.5)), 1e-9);
}

TEST(RevolutionDistance, IsInfiniteWithoutARevolutionBefore) {
  EXPECT_TRUE(revolutionDistance({}, {0}).empty());
  const std::vector<double> none = revolutionDistance({Vec3::Zero(), Vec3::UnitX()}, {});
  EXPECT_TRUE(std::isinf(none[0]) && std::isinf(none[1]));
  const std::vector<double> first = revolutionDistance({Vec3::Zero(), Vec3::UnitX()}, {0, 1});
  EXPECT_TRUE(std::isinf(first[0]));
}

}  // namespace
}  // namespace wcam::toolpath
