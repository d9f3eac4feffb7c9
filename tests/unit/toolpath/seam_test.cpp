// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/build.hpp"

#include "hand_made_layers.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace wcam::toolpath {
namespace {

using geometry::Vec2;
using test::circle;
using test::layerOf;
using test::polygon;

Toolpath build(const SlicedLayers& sliced,
               const std::string& params,
               const JobContext& context = JobContext()) {
  return buildToolpath(sliced, *test::plate(), PathParams::schema().read(parseJson(params)),
                       context);
}

SlicedLayers tower(int layers, double radius = 20.0, int points = 72) {
  SlicedLayers sliced;
  for (int l = 0; l < layers; ++l) {
    sliced.layers.push_back(
        layerOf(2.0 * (l + 1), {circle(radius, 2.0 * (l + 1), Vec3::Zero(), points)}));
  }
  return sliced;
}

Vec3 start(const Toolpath& path, std::size_t layer, std::size_t bead = 0) {
  return path.layers[layer].beads[bead].points.front().p;
}

std::vector<std::array<double, 3>> sortedPoints(const std::vector<Vec3>& points) {
  std::vector<std::array<double, 3>> sorted;
  for (const Vec3& p : points) {
    sorted.push_back({p.x(), p.y(), p.z()});
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

TEST(SeamModes, EveryModeKeepsThePointsOfALayer) {
  // Chalvin AT-16, AT-17.
  const SlicedLayers sliced = tower(7);
  for (const std::string mode :
       {"nearest", "aligned", "shifted", "golden", "random", "keep_away", "corner"}) {
    const Toolpath path = build(sliced, R"({"alternate": true, "seam": ")" + mode + "\"}");
    for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
      std::vector<Vec3> before;
      std::vector<Vec3> after;
      for (const ContourPoint& point : sliced.layers[l].contours[0].points) {
        before.push_back(point.p);
      }
      const auto& points = path.layers[l].beads[0].points;
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        after.push_back(points[i].p);
      }
      EXPECT_EQ(sortedPoints(before), sortedPoints(after)) << mode << " layer " << l;
    }
  }
}

TEST(SeamModes, NearestIsMinimalOverAllCyclicShiftsOfRandomContours) {
  // Chalvin AT-16.
  constexpr unsigned kSeed = 2024;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> place(-50.0, 50.0);
  for (int run = 0; run < 50; ++run) {
    SlicedLayers sliced;
    for (int l = 0; l < 5; ++l) {
      std::vector<Vec2> corners;
      for (int i = 0; i < 30; ++i) {
        corners.emplace_back(place(random), place(random));
      }
      sliced.layers.push_back(layerOf(2.0 * l, {polygon(corners, 2.0 * l)}));
    }
    const Toolpath path = build(sliced, R"({"seam": "nearest"})");
    for (std::size_t l = 1; l < 5; ++l) {
      const Vec3 end = path.layers[l - 1].beads[0].points.back().p;
      for (const ContourPoint& point : sliced.layers[l].contours[0].points) {
        ASSERT_LE((start(path, l) - end).norm(), (point.p - end).norm()) << "seed " << kSeed;
      }
    }
  }
}

TEST(SeamModes, ExactShiftMovesByTheExactArcLength) {
  const SlicedLayers sliced = tower(6, 20.0, 72);
  const Toolpath path =
      build(sliced, R"({"seam": "shifted", "seam_shift": 7.3, "seam_exact": true})");
  const double whole = 72 * 2 * 20.0 * std::sin(kPi / 72);
  for (std::size_t l = 1; l < 6; ++l) {
    // Arc length along the polygon from the start of the first layer.
    const Vec3 at(start(path, l).x(), start(path, l).y(), 0);
    const double azimuth = -std::atan2(at.y(), at.x());
    const double full = std::floor((azimuth < 0 ? azimuth + 2 * kPi : azimuth) / (2 * kPi) * 72);
    const Vec3 corner =
        20.0 * Vec3(std::cos(-2 * kPi * full / 72), std::sin(-2 * kPi * full / 72), 0);
    const double length = full * whole / 72 + (at - corner).norm();
    EXPECT_NEAR(length, std::fmod(7.3 * static_cast<double>(l), whole), 1e-9) << "layer " << l;
    EXPECT_LE(path.layers[l].beads[0].points.size(), 74U);
    EXPECT_NEAR(path.layers[l].beads[0].length(), whole, 1e-9);
  }
}

TEST(SeamModes, ExactAlignedLiesInTheDirection) {
  const SlicedLayers sliced = tower(2, 20.0, 31);
  for (const double direction : {0.0, 17.0, 93.7, -140.0}) {
    const Toolpath path = build(sliced, R"({"seam": "aligned", "seam_exact": true,
                                            "seam_direction": )" +
                                            std::to_string(direction) + "}");
    const Vec3 p = start(path, 1);
    EXPECT_NEAR(std::remainder(std::atan2(p.y(), p.x()) - degToRad(direction), 2 * kPi), 0.0, 1e-6);
  }
}

TEST(SeamModes, ExactNearestLiesOnTheSegment) {
  const SlicedLayers sliced{{layerOf(2, {polygon({{-10, -10}, {-10, 10}, {10, 10}, {10, -10}}, 2)}),
                             layerOf(4, {polygon({{-7, -40}, {-7, 40}, {12, 40}, {12, -40}}, 4)})}};
  const Toolpath path = build(sliced, R"({"seam": "nearest", "seam_exact": true})");
  const Vec3 end = path.layers[0].beads[0].points.back().p;
  EXPECT_NEAR(start(path, 1).y(), end.y(), 1e-12);
  EXPECT_EQ(path.layers[1].beads[0].points.size(), 6U);
}

TEST(SeamModes, KeepAwayHoldsItsDistanceToTheLastLayers) {
  // Chalvin AT-17: no two consecutive starts within a length.
  const SlicedLayers sliced = tower(20);
  JobContext context;
  const Toolpath path =
      build(sliced, R"({"seam": "keep_away", "seam_keep_away": 18.0, "seam_memory": 3})", context);
  EXPECT_EQ(context.diagnostics().count("toolpath.seam_too_close"), 0U);
  for (std::size_t l = 1; l < 20; ++l) {
    for (std::size_t k = l >= 3 ? l - 3 : 0; k < l; ++k) {
      EXPECT_GE((start(path, l) - start(path, k)).norm(), 18.0) << l << " " << k;
    }
  }
  (void)build(sliced, R"({"seam": "keep_away", "seam_keep_away": 60.0})", context);
  EXPECT_GT(context.diagnostics().count("toolpath.seam_too_close"), 0U);
}

/// A square with a notch, clockwise from above, with points every 5 mm.
Contour notched(double z) {
  const std::vector<Vec2> corners = {{-30, -30}, {-30, 30}, {-5, 30}, {0, 10},
                                     {5, 30},    {30, 30},  {30, -30}};
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 to = corners[(i + 1) % corners.size()];
    const int pieces = static_cast<int>(std::ceil((to - corners[i]).norm() / 5.0));
    for (int k = 0; k < pieces; ++k) {
      points.push_back(corners[i] + (to - corners[i]) * k / pieces);
    }
  }
  return polygon(points, z);
}

TEST(SeamModes, CornerHidesTheStartInTheConcaveCorner) {
  const Toolpath path = build({{layerOf(2, {notched(2)})}}, R"({"seam": "corner"})");
  EXPECT_NEAR((start(path, 0) - Vec3(0, 10, 2)).norm(), 0.0, 1e-12);
  // Without a concave one the sharpest; of equals the one in the seam direction.
  const SlicedLayers square{{layerOf(2, {polygon({{-9, -9}, {-9, 9}, {9, 9}, {9, -9}}, 2)})}};
  for (const double direction : {40.0, 130.0, -50.0}) {
    const Vec3 p = start(
        build(square, R"({"seam": "corner", "seam_direction": )" + std::to_string(direction) + "}"),
        0);
    EXPECT_NEAR(std::atan2(p.y(), p.x()), degToRad(direction + 5.0), 1e-9);
  }
  const Vec3 round = start(build(tower(1), R"({"seam": "corner", "seam_direction": 90})"), 0);
  EXPECT_NEAR(round.y(), 20.0, 1e-9);
}

Contour line(const Vec3& from, const Vec3& to, int group = 0) {
  Contour contour;
  contour.group = group;
  for (int i = 0; i <= 10; ++i) {
    contour.points.push_back({from + (to - from) * i / 10.0, Vec3::UnitY()});
  }
  return contour;
}

TEST(BeadOrder, OpenBeadsRunEitherWayWhenTheyMay) {
  SlicedLayer layer = layerOf(2, {});
  for (int i = 0; i < 8; ++i) {
    layer.contours.push_back(line(Vec3(0, 6.0 * i, 2), Vec3(50, 6.0 * i, 2)));
  }
  const auto travel = [](const Toolpath& path) {
    double way = 0.0;
    for (std::size_t b = 1; b < path.layers[0].beads.size(); ++b) {
      way +=
          (path.layers[0].beads[b].points.front().p - path.layers[0].beads[b - 1].points.back().p)
              .norm();
    }
    return way;
  };
  const Toolpath oneWay = build({{layer}}, "{}");
  const Toolpath eitherWay = build({{layer}}, R"({"reverse_open": true})");
  EXPECT_GT(travel(oneWay), 7 * 50.0);
  EXPECT_NEAR(travel(eitherWay), 7 * 6.0, 1e-9);
  const Toolpath alternate =
      build({{layer}}, R"({"alternate": true, "alternate_by": "bead", "order": "given"})");
  EXPECT_NEAR(travel(alternate), 7 * 6.0, 1e-9);
  for (const Toolpath* path : {&oneWay, &eitherWay, &alternate}) {
    for (const Bead& bead : path->layers[0].beads) {
      EXPECT_NEAR((bead.points[4].b - Vec3::UnitZ()).norm(), 0.0, 1e-12);
    }
  }
}

/// Islands in a row, 30 mm apart; each layer lists them in the same order.
SlicedLayers islands(int layers, int count) {
  SlicedLayers sliced;
  for (int l = 0; l < layers; ++l) {
    SlicedLayer layer = layerOf(2.0 * (l + 1), {});
    for (int i = 0; i < count; ++i) {
      layer.contours.push_back(circle(6.0, 2.0 * (l + 1), Vec3(30.0 * i, 0, 0)));
    }
    sliced.layers.push_back(layer);
  }
  return sliced;
}

int islandOf(const Bead& bead) {
  return static_cast<int>(std::lround(bead.points.front().p.x() / 30.0));
}

std::vector<int> orderOf(const Toolpath& path, std::size_t layer) {
  std::vector<int> order;
  for (const Bead& bead : path.layers[layer].beads) {
    order.push_back(islandOf(bead));
  }
  return order;
}

TEST(BeadOrder, LeastRecentRepeatsTheOrderOfTheLayerBelow) {
  const SlicedLayers sliced = islands(4, 5);
  const Toolpath nearest = build(sliced, "{}");
  EXPECT_EQ(orderOf(nearest, 0), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(orderOf(nearest, 1), (std::vector<int>{4, 3, 2, 1, 0}));
  const Toolpath recent = build(sliced, R"({"order": "least_recent"})");
  for (std::size_t l = 1; l < 4; ++l) {
    EXPECT_EQ(orderOf(recent, l), orderOf(recent, 0));
  }
}

TEST(BeadOrder, ThermalSpreadJumpsAwayFromTheHeat) {
  const Toolpath path = build(islands(3, 6), R"({"order": "thermal"})");
  double sum = 0.0;
  for (std::size_t l = 0; l < 3; ++l) {
    const std::vector<int> order = orderOf(path, l);
    for (std::size_t b = 1; b < order.size(); ++b) {
      sum += 30.0 * std::abs(order[b] - order[b - 1]) / 15.0;
    }
  }
  // In the order of the row the mean jump is 30 mm, drawn at random 70 mm.
  EXPECT_GE(sum, 70.0);
  EXPECT_EQ(orderOf(build(islands(1, 6), R"({"order": "given"})"), 0),
            (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

TEST(BeadOrder, APathThatIsGivenStaysAsItIs) {
  SlicedLayers sliced = islands(3, 4);
  std::reverse(sliced.layers[1].contours.begin(), sliced.layers[1].contours.end());
  sliced.asGiven = true;
  const Toolpath path =
      build(sliced, R"({"alternate": true, "order": "thermal", "seam": "golden"})");
  for (std::size_t l = 0; l < 3; ++l) {
    for (std::size_t b = 0; b < 4; ++b) {
      for (std::size_t i = 0; i < sliced.layers[l].contours[b].points.size(); ++i) {
        ASSERT_EQ(path.layers[l].beads[b].points[i].p, sliced.layers[l].contours[b].points[i].p);
      }
    }
  }
}

TEST(BeadOrder, EmptyContoursAndLayersAreNoTrouble) {
  const SlicedLayers sliced{{layerOf(2, {}), layerOf(4, {Contour{}, circle(5, 4)})}};
  const Toolpath path = build(sliced, R"({"order": "least_recent"})");
  EXPECT_TRUE(path.layers[0].beads.empty());
  EXPECT_EQ(path.layers[1].beads.size(), 1U);
}

}  // namespace
}  // namespace wcam::toolpath
