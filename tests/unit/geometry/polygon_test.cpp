// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"
#include "wcam/geometry/polygon2d.hpp"

#include "error_matchers.hpp"
#include "random_source.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::geometry {
namespace {

using testing::RandomSource;

Polyline2 circle(double x, double y, double r, int n) {
  Polyline2 loop;
  for (int i = 0; i < n; ++i) {
    loop.emplace_back(x + r * std::cos(2.0 * kPi * i / n), y + r * std::sin(2.0 * kPi * i / n));
  }
  return loop;
}

Polyline2 rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Region2 region(std::vector<Polyline2> loops, double tolerance = 1e-6) {
  return makeRegion(loops, LoopRule::Nesting, tolerance);
}

double distanceToBorder(const Region2& area, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Polyline2& loop : area.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i];
      const Vec2 d = loop[(i + 1) % loop.size()] - a;
      const double s = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (p - a - s * d).norm());
    }
  }
  return least;
}

/// A star with waves, sometimes with a hole; never self-crossing.
Region2 randomRegion(RandomSource& random) {
  const int n = 3 + static_cast<int>(random.below(200));
  const double wave = random.real(0.0, 0.6);
  const auto lobes = static_cast<double>(1 + random.below(9));
  Polyline2 loop;
  for (int i = 0; i < n; ++i) {
    const double a = 2.0 * kPi * i / n;
    const double r = 50.0 * (1.0 + wave * std::sin(lobes * a)) * random.real(0.9, 1.0);
    loop.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  std::vector<Polyline2> loops{loop};
  if (random.chance(0.4)) {
    loops.push_back(circle(3.0, 0.0, 8.0, 20));
  }
  return region(loops);
}

TEST(Region, OrientationAndNestingOfLoops) {
  const std::vector<Polyline2> loops{rectangle(4, 4, 6, 6), rectangle(0, 0, 10, 10)};
  const Region2 ring = makeRegion(loops, LoopRule::Nesting, 1e-6);
  EXPECT_NEAR(ring.area(), 96.0, 1e-9);
  ASSERT_EQ(ring.loops.size(), 2U);
  EXPECT_GT(signedArea(ring.loops[0]), 0.0);
  EXPECT_LT(signedArea(ring.loops[1]), 0.0);
  // Both counter-clockwise: by orientation the inner one adds nothing.
  EXPECT_NEAR(makeRegion(loops, LoopRule::Orientation, 1e-6).area(), 100.0, 1e-9);
  EXPECT_TRUE(ring.contains(Vec2(1, 1)));
  EXPECT_FALSE(ring.contains(Vec2(5, 5)));
  const auto islands = islandsOf(ring);
  ASSERT_EQ(islands.size(), 1U);
  EXPECT_EQ(islands[0].loops.size(), 2U);
}

TEST(Region, SelfCrossingTouchingRepeatedAndEmptyInput) {
  // A bow tie by nesting: two triangles.
  EXPECT_NEAR(region({{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}).area(), 50.0, 1e-6);
  // Squares that touch along an edge are one, at a corner two islands or one with a pinch.
  const std::vector<Polyline2> edge{rectangle(0, 0, 10, 10), rectangle(10, 0, 20, 10)};
  const Region2 joined = makeRegion(edge, LoopRule::Orientation, 1e-6);
  EXPECT_EQ(joined.loops.size(), 1U);
  EXPECT_NEAR(joined.area(), 200.0, 1e-6);
  const std::vector<Polyline2> corner{rectangle(0, 0, 10, 10), rectangle(10, 10, 20, 20)};
  EXPECT_NEAR(makeRegion(corner, LoopRule::Orientation, 1e-6).area(), 200.0, 1e-6);
  // Repeated points, spikes, single points, nothing.
  EXPECT_NEAR(region({{{0, 0}, {0, 0}, {10, 0}, {15, 0}, {10, 0}, {10, 10}, {0, 10}}}).area(),
              100.0, 1e-6);
  EXPECT_TRUE(region({}).empty());
  EXPECT_TRUE(region({{{1, 1}}}).empty());
  EXPECT_TRUE(region({{{1, 1}, {2, 2}}}).empty());
  EXPECT_TRUE(region({{{0, 0}, {5, 5}, {10, 10}}}).empty());
  EXPECT_TRUE(offsetRegion({}, 1.0, {}).empty());
  EXPECT_TRUE(medialAxis({}, {}).empty());
  EXPECT_TRUE(hatchRegion({}, 0.0, 1.0).empty());
  EXPECT_TRUE(nestedInsets({}, 1.0, 1.0, 5, {}).empty());
}

TEST(Region, CoordinatesThatAreNoNumbersAreNamed) {
  const std::vector<Polyline2> loops{
      rectangle(0, 0, 1, 1), {{0, 0}, {1, 0}, {std::numeric_limits<double>::quiet_NaN(), 1}}};
  const std::string text = testing::errorOf(ErrorCode::InvalidArgument, [&] {
    static_cast<void>(makeRegion(loops, LoopRule::Nesting, 0.01));
  });
  EXPECT_NE(text.find("loop 1, point 2"), std::string::npos) << text;
  const Region2 square = region({rectangle(0, 0, 1, 1)});
  testing::errorOf(ErrorCode::InvalidArgument,
                   [&] { static_cast<void>(offsetRegion(square, NAN, {})); });
  testing::errorOf(ErrorCode::InvalidArgument, [&] {
    static_cast<void>(offsetRegion(square, 1.0, {CornerJoin::Miter, 2.0, 0.0}));
  });
  testing::errorOf(ErrorCode::InvalidArgument,
                   [&] { static_cast<void>(hatchRegion(square, 0.0, 0.0)); });
  testing::errorOf(ErrorCode::InvalidArgument,
                   [&] { static_cast<void>(hatchRegion(square, 0.0, 1e-9)); });
  testing::errorOf(ErrorCode::InvalidArgument, [&] {
    static_cast<void>(medialAxis(square, {0.0, 0.0}));
  });
}

TEST(Region, FarFromTheOriginAndTiny) {
  const double far = 1e7;
  const Region2 moved = offsetRegion(region({rectangle(far, far, far + 40, far + 30)}), -3.0,
                                     {CornerJoin::Miter, 2.0, 0.01});
  EXPECT_NEAR(moved.area(), 34.0 * 24.0, 1e-3);
  const Region2 tiny = offsetRegion(region({rectangle(0, 0, 4e-4, 3e-4)}, 1e-9), -5e-5,
                                    {CornerJoin::Miter, 2.0, 1e-6});
  EXPECT_NEAR(tiny.area(), 3e-4 * 2e-4, 1e-10);
  EXPECT_TRUE(offsetRegion(tiny, -1.0, {}).empty());
}

TEST(Offset, ClosedForms) {
  const Region2 square = region({rectangle(0, 0, 40, 40)});
  const OffsetOptions sharp{CornerJoin::Miter, 2.0, 0.01};
  const OffsetOptions round{CornerJoin::Round, 2.0, 0.001};
  EXPECT_NEAR(offsetRegion(square, -3.0, sharp).area(), 34.0 * 34.0, 1e-9);
  EXPECT_NEAR(offsetRegion(square, 3.0, sharp).area(), 46.0 * 46.0, 1e-9);
  // Grown: area + perimeter·d + π·d².
  EXPECT_NEAR(offsetRegion(square, 3.0, round).area(), 1600.0 + 480.0 + 9.0 * kPi, 0.02);
  EXPECT_TRUE(offsetRegion(square, -20.0 - 1e-6, sharp).empty());
  EXPECT_NEAR(offsetRegion(square, 0.0, sharp).area(), 1600.0, 1e-9);
  const Region2 disc = region({circle(0, 0, 20, 2000)});
  EXPECT_NEAR(offsetRegion(disc, -5.0, round).area(), kPi * 225.0, 0.1);
  EXPECT_NEAR(offsetRegion(disc, 5.0, round).area(), kPi * 625.0, 0.2);
  // A ring closes when its holes grow; they pass each other without crossing at a large distance.
  const Region2 ring = region({circle(0, 0, 20, 200), circle(0.5, 0, 12, 150)});
  EXPECT_NEAR(offsetRegion(ring, -2.0, round).area(), kPi * (18.0 * 18.0 - 14.0 * 14.0), 0.5);
  EXPECT_TRUE(offsetRegion(ring, -8.0, round).empty());
}

TEST(Offset, NestedInsetsEndBeforeTheFirstEmptyOneAndDoNotDrift) {
  const Region2 square = region({rectangle(0, 0, 40, 40)});
  const auto insets = nestedInsets(square, 3.0, 4.0, 100, {CornerJoin::Miter, 2.0, 0.01});
  ASSERT_EQ(insets.size(), 5U);
  for (std::size_t k = 0; k < insets.size(); ++k) {
    const double side = 40.0 - 2.0 * (3.0 + 4.0 * static_cast<double>(k));
    EXPECT_NEAR(insets[k].area(), side * side, 1e-6) << k;
  }
  const Region2 wavy = [] {
    RandomSource random(7);
    return randomRegion(random);
  }();
  const OffsetOptions options{CornerJoin::Round, 2.0, 0.01};
  const auto nested = nestedInsets(wavy, 0.5, 0.5, 1000, options);
  ASSERT_GT(nested.size(), 10U);
  for (std::size_t k = 0; k < nested.size(); ++k) {
    const double distance = 0.5 * static_cast<double>(k + 1);
    for (const Polyline2& loop : nested[k].loops) {
      for (const Vec2& p : loop) {
        EXPECT_NEAR(distanceToBorder(wavy, p), distance, 0.02) << k;
      }
    }
  }
}

TEST(Offset, EveryPointOfRandomOffsetsHasItsDistance) {
  for (const std::uint64_t seed : testing::testSeeds(60)) {
    RandomSource random(seed);
    const Region2 area = randomRegion(random);
    for (const double d : {-0.5, -3.0, -9.0, 2.0, 11.0}) {
      const OffsetOptions options{CornerJoin::Round, 2.0, 0.02};
      const Region2 moved = offsetRegion(area, d, options);
      ASSERT_FALSE(findCrossing(moved.loops, true, 0.0).has_value()) << "seed " << seed;
      for (const Polyline2& loop : moved.loops) {
        for (const Vec2& p : loop) {
          ASSERT_NEAR(distanceToBorder(area, p), std::abs(d), options.tolerance)
              << "seed " << seed << ", offset " << d;
          ASSERT_EQ(area.contains(p), d < 0.0) << "seed " << seed;
        }
      }
      // Nothing is missing: points farther inside than the offset lie in the result.
      for (int k = 0; k < 50; ++k) {
        const Vec2 p(random.real(-90, 90), random.real(-90, 90));
        const double signedDistance = (area.contains(p) ? -1.0 : 1.0) * distanceToBorder(area, p);
        if (std::abs(signedDistance - d) > options.tolerance) {
          ASSERT_EQ(moved.contains(p), signedDistance < d) << "seed " << seed << ", offset " << d;
        }
      }
    }
  }
}

TEST(Offset, MicrometreEdgesLoseNoArea) {
  // A slice with edges of 0.1 µm: its nested insets keep the area of the smooth outline.
  Polyline2 noisy;
  RandomSource random(3);
  for (int i = 0; i < 4000; ++i) {
    const double a = 2.0 * kPi * i / 4000;
    const Vec2 p(30.0 * std::cos(a), 30.0 * std::sin(a));
    noisy.push_back(p);
    noisy.push_back(p + Vec2(random.real(-1e-4, 1e-4), random.real(-1e-4, 1e-4)));
  }
  const auto insets =
      nestedInsets(region({noisy}, 1e-3), 3.0, 3.0, 8, {CornerJoin::Round, 2.0, 0.05});
  ASSERT_EQ(insets.size(), 8U);
  for (std::size_t k = 0; k < insets.size(); ++k) {
    const double r = 30.0 - 3.0 * static_cast<double>(k + 1);
    EXPECT_NEAR(insets[k].area(), kPi * r * r, 2.0 * kPi * r * 0.05) << k;
  }
}

TEST(Simplify, KeepsEveryPointWithinTheToleranceFromAnyStart) {
  Polyline2 loop = circle(0, 0, 20, 1000);
  const Polyline2 simple = simplified(loop, true, 0.05);
  EXPECT_LT(simple.size(), 70U);
  for (const Vec2& p : loop) {
    EXPECT_LE(distanceToBorder({{simple}}, p), 0.05);
  }
  std::rotate(loop.begin(), loop.begin() + 321, loop.end());
  EXPECT_EQ(simplified(loop, true, 0.05), simple);
  const Polyline2 line = simplified({{0, 0}, {1, 0.01}, {2, 0}, {3, 5}}, false, 0.05);
  EXPECT_EQ(line, (Polyline2{{0, 0}, {2, 0}, {3, 5}}));
}

TEST(Hatch, LinesLieAtTheirSpacingAndStayInside) {
  const Region2 area = region({rectangle(0, 0, 60, 40), circle(20, 20, 10, 60)});
  const double angle = 0.4;
  const Vec2 across(-std::sin(angle), std::cos(angle));
  const auto segments = hatchRegion(area, angle, 2.0, 0.3);
  double length = 0.0;
  for (const HatchSegment& s : segments) {
    EXPECT_NEAR(s.a.dot(across), 0.3 + 2.0 * static_cast<double>(s.line), 1e-12);
    EXPECT_NEAR(s.b.dot(across), 0.3 + 2.0 * static_cast<double>(s.line), 1e-12);
    EXPECT_NEAR(distanceToBorder(area, s.a), 0.0, 1e-9);
    EXPECT_NEAR(distanceToBorder(area, s.b), 0.0, 1e-9);
    EXPECT_TRUE(area.contains(0.5 * (s.a + s.b)));
    length += (s.b - s.a).norm();
  }
  EXPECT_NEAR(2.0 * length, area.area(), 0.02 * area.area());
  // Lines exactly through vertices and edges.
  EXPECT_EQ(hatchRegion(region({rectangle(0, 0, 10, 10)}), 0.0, 5.0).size(), 2U);
  EXPECT_EQ(hatchRegion(region({{{0, 0}, {10, 5}, {0, 10}, {-10, 5}}}), 0.0, 5.0).size(), 1U);
}

TEST(Medial, RectangleHasItsRoof) {
  const Region2 area = region({rectangle(0, 0, 40, 10)});
  const auto full = medialAxis(area, {0.01, 0.0});
  EXPECT_EQ(full.size(), 5U);
  const auto pruned = medialAxis(area, {0.01, 2.0});
  ASSERT_EQ(pruned.size(), 1U);
  EXPECT_NEAR(polylineLength({pruned[0].points.front().p, pruned[0].points.back().p}, false), 30.0,
              1e-4);
  for (const AxisPoint& p : pruned[0].points) {
    EXPECT_NEAR(p.p.y(), 5.0, 1e-5);
    EXPECT_NEAR(p.radius, 5.0, 1e-5);
  }
}

TEST(Medial, DiscIsItsCentreAndRingACircle) {
  const auto disc = medialAxis(region({circle(1, 2, 20, 100)}), {0.01, 0.7});
  ASSERT_EQ(disc.size(), 1U);
  for (const AxisPoint& p : disc[0].points) {
    EXPECT_NEAR((p.p - Vec2(1, 2)).norm(), 0.0, 0.05);
    EXPECT_NEAR(p.radius, 20.0, 0.05);
  }
  const auto ring = medialAxis(region({circle(0, 0, 20, 200), circle(0, 0, 12, 160)}), {0.02, 0.7});
  ASSERT_EQ(ring.size(), 1U);
  EXPECT_TRUE(ring[0].closed);
  for (const AxisPoint& p : ring[0].points) {
    EXPECT_NEAR(p.p.norm(), 16.0, 0.03);
    EXPECT_NEAR(p.radius, 4.0, 0.03);
  }
}

TEST(Medial, RadiusIsTheDistanceToTheBorderOfRandomRegions) {
  for (const std::uint64_t seed : testing::testSeeds(20)) {
    RandomSource random(seed);
    const Region2 area = randomRegion(random);
    const auto branches = medialAxis(area, {0.05, 0.7});
    ASSERT_FALSE(branches.empty()) << "seed " << seed;
    for (const AxisBranch& branch : branches) {
      for (const AxisPoint& p : branch.points) {
        ASSERT_TRUE(p.radius < 0.1 || area.contains(p.p)) << "seed " << seed;
        ASSERT_NEAR(distanceToBorder(area, p.p), p.radius, 0.06) << "seed " << seed;
      }
    }
  }
}

TEST(Stroke, CoversARectangleWithRoundEnds) {
  const Stroke2 line{{{0, 0}, {20, 0}}, {6.0}, false};
  EXPECT_NEAR(strokeArea(std::span(&line, 1), 0.001).area(), 120.0 + 9.0 * kPi, 0.05);
  const Stroke2 wedge{{{0, 0}, {20, 0}}, {2.0, 6.0}, false};
  const double area = strokeArea(std::span(&wedge, 1), 0.001).area();
  // Between the trapezoid with half circles and the one of the larger width.
  EXPECT_GT(area, 80.0 + 0.5 * kPi + 4.5 * kPi - 1.0);
  EXPECT_LT(area, 120.0 + 9.0 * kPi);
}

TEST(Clip, KeepsOrderAndDirectionOfTheLine) {
  const Region2 area = region({rectangle(0, 0, 10, 10), rectangle(4, 4, 6, 6)});
  const auto pieces = clipPolyline({{-5, 5}, {15, 5}, {15, 8}, {-5, 8}}, area);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_NEAR(pieces[0].front().x(), 0.0, 1e-6);
  EXPECT_NEAR(pieces[0].back().x(), 4.0, 1e-6);
  EXPECT_NEAR(pieces[2].front().x(), 10.0, 1e-6);
}

TEST(Crossing, IsFoundWhereItIs) {
  const Polyline2 eight{{0, 0}, {10, 10}, {10, 0}, {0, 10}};
  const auto crossing = findCrossing(std::span(&eight, 1), true, 0.0);
  ASSERT_TRUE(crossing.has_value());
  EXPECT_NEAR((crossing->p - Vec2(5, 5)).norm(), 0.0, 1e-12);
  const Polyline2 square = rectangle(0, 0, 10, 10);
  EXPECT_FALSE(findCrossing(std::span(&square, 1), true, 0.0).has_value());
}

}  // namespace
}  // namespace wcam::geometry
