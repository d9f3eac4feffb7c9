// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/toolpath/fill_room.hpp"

#include "error_matchers.hpp"
#include "random_source.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <string>

namespace wcam::toolpath {
namespace {

using geometry::LoopRule;
using geometry::Polyline2;
using geometry::Region2;

Polyline2 circle(double x, double y, double r, int n) {
  Polyline2 loop;
  for (int i = 0; i < n; ++i) {
    loop.emplace_back(x + r * std::cos(2.0 * kPi * i / n), y + r * std::sin(2.0 * kPi * i / n));
  }
  return loop;
}

Region2 region(const std::vector<Polyline2>& loops) {
  return geometry::makeRegion(loops, LoopRule::Nesting, 1e-4);
}

/// Loops of a polygon file: lines "- [x, y, z]" under "polygon:", metres.
std::vector<Polyline2> loopsOf(const std::string& relative) {
  const std::string text = readFile(std::string(WCAM_TEST_DATA) + "/" + relative);
  std::vector<Polyline2> loops;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    if (line.find("polygon") != std::string::npos) {
      loops.emplace_back();
    } else if (const std::size_t open = line.find('['); open != std::string::npos) {
      char* rest = nullptr;
      const double x = std::strtod(line.c_str() + open + 1, &rest);
      const double y = std::strtod(rest + 1, nullptr);
      loops.back().emplace_back(1000.0 * x, 1000.0 * y);
    }
    at = end + 1;
  }
  return loops;
}

struct Shape {
  std::string name;
  Region2 area;
  double leastCoverage;
};

std::vector<Shape> shapes() {
  return {
      {"rectangle", region({{{0, 0}, {40, 0}, {40, 40}, {0, 40}}}), 0.99},
      {"disc", region({circle(0, 0, 25, 200)}), 0.995},
      {"ring", region({circle(0, 0, 30, 200), circle(2, 0, 12, 120)}), 0.99},
      {"L", region({{{0, 0}, {60, 0}, {60, 22}, {25, 22}, {25, 60}, {0, 60}}}), 0.99},
      {"holes",
       region(
           {{{0, 0}, {80, 0}, {80, 50}, {0, 50}}, circle(20, 25, 8, 60), circle(55, 30, 10, 60)}),
       0.99},
      {"dumbbell",
       region({{{0, 0},
                {30, 0},
                {30, 13},
                {50, 13},
                {50, 0},
                {80, 0},
                {80, 30},
                {50, 30},
                {50, 17.5},
                {30, 17.5},
                {30, 30},
                {0, 30}}}),
       0.98},
      {"comb",
       region({{{0, 0},
                {80, 0},
                {80, 40},
                {74, 40},
                {74, 12},
                {60, 12},
                {60, 40},
                {52, 40},
                {52, 12},
                {38, 12},
                {38, 40},
                {28, 40},
                {28, 12},
                {14, 12},
                {14, 40},
                {0, 40}}}),
       0.98},
      {"touching",
       region({{{0, 0}, {30, 0}, {30, 30}, {0, 30}}, {{30, 30}, {60, 30}, {60, 60}, {30, 60}}}),
       0.98},
      {"polygon with hole", region(loopsOf("ram/polygon_with_hole.yaml")), 0.97},
      {"two walls", region(loopsOf("ram/two_thin_walls.yaml")), 0.98},
  };
}

const std::vector<std::pair<FillPattern, std::string>> kPatterns{
    {FillPattern::Raster, "raster"},   {FillPattern::Zigzag, "zigzag"},
    {FillPattern::Contour, "contour"}, {FillPattern::Spiral, "spiral"},
    {FillPattern::Hybrid, "hybrid"},   {FillPattern::Continuous, "continuous"},
    {FillPattern::Medial, "medial"}};

/// The 6 mm bead of Diourté M05.
FillOptions beadOf6(FillPattern pattern) {
  FillOptions options;
  options.pattern = pattern;
  options.width = 6.0;
  options.minWidth = 3.0;
  options.maxWidth = 9.0;
  options.minLength = 4.0;
  return options;
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

class EveryPattern : public ::testing::TestWithParam<std::size_t> {
protected:
  FillPattern pattern() const { return kPatterns[GetParam()].first; }
};

TEST_P(EveryPattern, CoversEveryShapeInsideItsBorder) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    const FillOptions options = beadOf6(pattern());
    const FillResult fill = fillRegion(shape.area, options);
    const FillCoverage coverage = fillCoverage(shape.area, fill.beads, options);
    EXPECT_NEAR(coverage.area, shape.area.area(), 1e-9);
    EXPECT_GE(coverage.coveredPart(), shape.leastCoverage);
    EXPECT_LE(coverage.coveredPart(), 1.0);
    for (const FillBead& bead : fill.beads) {
      ASSERT_GE(bead.points.size(), 2U);
      ASSERT_FALSE(geometry::findCrossing(std::span(&bead.points, 1), bead.closed, 0.0));
      for (std::size_t i = 0; i < bead.points.size(); ++i) {
        const Vec2& p = bead.points[i];
        ASSERT_TRUE(shape.area.contains(p)) << p.transpose();
        // The bead stays inside: half its width from the border.
        const double width = bead.widths.empty() ? options.width : bead.widths[i];
        ASSERT_GE(distanceToBorder(shape.area, p), 0.5 * width - 3.0 * options.tolerance)
            << p.transpose();
        if (!bead.widths.empty()) {
          ASSERT_GE(width, options.minWidth);
          ASSERT_LE(width, options.maxWidth);
        }
      }
      if (bead.closed) {
        EXPECT_TRUE(bead.widths.empty() ? bead.feature != BeadFeature::Fill : true);
      } else {
        EXPECT_GE(geometry::polylineLength(bead.points, false), options.minLength);
      }
    }
  }
}

TEST_P(EveryPattern, RoomsOfTheBeadsAreTheSection) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    const FillOptions options = beadOf6(pattern());
    const FillResult fill = fillRegion(shape.area, options);
    const std::vector<FillRoom> rooms = shareRoom(shape.area, fill.beads, options, 2.0);
    ASSERT_EQ(rooms.size(), fill.beads.size());
    EXPECT_NEAR(fillRatio(shape.area, rooms), 1.0, 0.03);
    for (std::size_t b = 0; b < rooms.size(); ++b) {
      const double length = geometry::polylineLength(fill.beads[b].points, fill.beads[b].closed);
      for (int k = 0; k <= 20; ++k) {
        const double width = rooms[b].at(0.05 * k * length);
        ASSERT_GE(width, options.overlap * options.minWidth - 1e-12);
        // Within a bead width of an open bead's ends, what lies around them is laid.
        const double toEnd = std::min(0.05 * k, 1.0 - 0.05 * k) * length;
        const bool end = !fill.beads[b].closed && toEnd <= 1.5 * options.width;
        ASSERT_LE(width, (end ? 3.0 : 1.0) * options.maxWidth + 1e-12);
      }
    }
  }
}

TEST_P(EveryPattern, TurnsAndScalesWithTheRegion) {
  const Shape shape = shapes()[4];
  FillOptions options = beadOf6(pattern());
  const FillCoverage before =
      fillCoverage(shape.area, fillRegion(shape.area, options).beads, options);
  // Turned with the line angle, and twice as large with all lengths doubled.
  const double angle = 0.7;
  std::vector<Polyline2> loops = shape.area.loops;
  for (Polyline2& loop : loops) {
    for (Vec2& p : loop) {
      p = 2.0 * (Eigen::Rotation2Dd(angle) * p);
    }
  }
  options.angle = angle;
  for (double* length : {&options.width, &options.minWidth, &options.maxWidth, &options.minLength,
                         &options.tolerance}) {
    *length *= 2.0;
  }
  const Region2 moved = region(loops);
  const FillCoverage after = fillCoverage(moved, fillRegion(moved, options).beads, options);
  EXPECT_NEAR(after.coveredPart(), before.coveredPart(), 2e-3);
}

TEST_P(EveryPattern, DoesNotDependOnStartOrOrderOfTheLoops) {
  const Shape shape = shapes()[4];
  std::vector<Polyline2> loops = shape.area.loops;
  std::reverse(loops.begin(), loops.end());
  for (Polyline2& loop : loops) {
    std::rotate(loop.begin(), loop.begin() + 3, loop.end());
  }
  const FillOptions options = beadOf6(pattern());
  const FillResult a = fillRegion(shape.area, options);
  const FillResult b = fillRegion(region(loops), options);
  ASSERT_EQ(a.beads.size(), b.beads.size());
  for (std::size_t i = 0; i < a.beads.size(); ++i) {
    EXPECT_EQ(a.beads[i].points, b.beads[i].points) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Fill,
                         EveryPattern,
                         ::testing::Range<std::size_t>(0, kPatterns.size()),
                         [](const auto& test) { return kPatterns[test.param].second; });

TEST(Fill, LinesLieExactlyAtTheOverlapDistance) {
  const Region2 square = shapes()[0].area;
  for (const FillPattern pattern : {FillPattern::Raster, FillPattern::Zigzag}) {
    FillOptions options = beadOf6(pattern);
    options.walls = 0;
    const double spacing = 0.667 * 6.0;
    std::set<long> heights;
    for (const FillBead& bead : fillRegion(square, options).beads) {
      for (std::size_t i = 1; i < bead.points.size(); ++i) {
        if (bead.points[i].y() == bead.points[i - 1].y()) {
          heights.insert(std::lround(bead.points[i].y() * 1e9));
        }
      }
    }
    // 34 mm between the first and the last possible line: nine lines.
    ASSERT_EQ(heights.size(), 9U);
    for (auto it = std::next(heights.begin()); it != heights.end(); ++it) {
      EXPECT_NEAR(static_cast<double>(*it - *std::prev(it)) * 1e-9, spacing, 2e-9);
    }
  }
}

TEST(Fill, WallsOfASquareFollowTheOverlapModel) {
  // Diourté M05, M06: first half a bead width inside, then 0.667 bead widths each.
  FillOptions options = beadOf6(FillPattern::None);
  options.walls = 3;
  const FillResult fill = fillRegion(shapes()[0].area, options);
  ASSERT_EQ(fill.beads.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = 40.0 - 2.0 * (3.0 + 4.002 * static_cast<double>(k));
    EXPECT_NEAR(geometry::signedArea(fill.beads[k].points), side * side, 1e-6);
    EXPECT_EQ(fill.beads[k].group, static_cast<int>(k));
    EXPECT_EQ(fill.beads[k].feature, BeadFeature::Inset);
  }
  options.order = InsetOrder::InsideFirst;
  EXPECT_NEAR(geometry::signedArea(fillRegion(shapes()[0].area, options).beads[2].points),
              34.0 * 34.0, 1e-6);
  options.order = InsetOrder::Automatic;
  options.reference = BeadReference::Centre;
  EXPECT_NEAR(geometry::signedArea(fillRegion(shapes()[0].area, options).beads[0].points), 1600.0,
              1e-6);
  options.reference = BeadReference::Outside;
  EXPECT_NEAR(geometry::signedArea(fillRegion(shapes()[0].area, options).beads[0].points),
              46.0 * 46.0, 1e-6);
}

TEST(Fill, SpiralOfASimpleShapeHasOneArcStart) {
  FillOptions options = beadOf6(FillPattern::Spiral);
  options.walls = 0;
  for (const std::size_t k : {0U, 1U}) {
    const FillResult fill = fillRegion(shapes()[k].area, options);
    EXPECT_EQ(fill.beads.size(), 1U) << shapes()[k].name;
  }
  // Two borders: a spiral from each.
  EXPECT_EQ(fillRegion(shapes()[2].area, options).beads.size(), 2U);
}

TEST(Fill, ContinuousNeedsFewArcStarts) {
  const auto starts = [](std::size_t shape, FillPattern pattern) {
    return fillRegion(shapes()[shape].area, beadOf6(pattern)).beads.size();
  };
  EXPECT_EQ(starts(0, FillPattern::Continuous), 1U);
  EXPECT_EQ(starts(1, FillPattern::Continuous), 1U);
  EXPECT_LE(starts(2, FillPattern::Continuous), 3U);
  for (std::size_t shape = 0; shape < shapes().size(); ++shape) {
    EXPECT_LE(starts(shape, FillPattern::Continuous), starts(shape, FillPattern::Zigzag)) << shape;
    EXPECT_LE(starts(shape, FillPattern::Zigzag), starts(shape, FillPattern::Raster)) << shape;
  }
}

TEST(Fill, NeckNarrowerThanABeadTakesOneOfItsWidth) {
  const Region2 dumbbell = shapes()[5].area;
  FillOptions options = beadOf6(FillPattern::Zigzag);
  const FillResult fill = fillRegion(dumbbell, options);
  ASSERT_EQ(fill.narrow.size(), 1U);
  EXPECT_NEAR(fill.narrow[0].thickness, 4.5, 0.1);
  EXPECT_TRUE(fill.narrow[0].filled);
  bool found = false;
  for (const FillBead& bead : fill.beads) {
    for (std::size_t i = 0; i < bead.widths.size(); ++i) {
      if (std::abs(bead.points[i].x() - 40.0) < 11.0) {
        found = true;
        EXPECT_NEAR(bead.points[i].y(), 15.25, 0.1);
        EXPECT_NEAR(bead.widths[i], 4.5, 0.1);
      }
    }
  }
  EXPECT_TRUE(found);
  options.minWidth = 5.0;
  const FillResult none = fillRegion(dumbbell, options);
  ASSERT_EQ(none.narrow.size(), 1U);
  EXPECT_FALSE(none.narrow[0].filled);
  EXPECT_LT(fillCoverage(dumbbell, none.beads, options).coveredPart(), 0.96);
}

TEST(Fill, MedialBeadsRunFromInsideToOutsideWithinTheirRange) {
  // A wall of 8 mm takes one bead of 8 mm.
  const Region2 wall = region({{{0, 0}, {100, 0}, {100, 8}, {0, 8}}});
  const FillResult one = fillRegion(wall, beadOf6(FillPattern::Medial));
  ASSERT_EQ(one.beads.size(), 1U);
  for (const double width : one.beads[0].widths) {
    EXPECT_NEAR(width, 8.0, 0.05);
  }
  const FillResult fill = fillRegion(shapes()[0].area, beadOf6(FillPattern::Medial));
  ASSERT_GT(fill.beads.size(), 3U);
  EXPECT_EQ(fill.beads.back().feature, BeadFeature::Inset);
  double before = 0.0;
  for (const FillBead& bead : fill.beads) {
    if (bead.closed) {
      EXPECT_GT(geometry::signedArea(bead.points), before);
      before = geometry::signedArea(bead.points);
    }
  }
}

TEST(FillRoom, IsTheCentreDistanceInsideAndReachesTheBorder) {
  // Lines 4.002 mm apart between walls; the wall lies 3 mm inside the border.
  const FillOptions options = beadOf6(FillPattern::Raster);
  const Region2 square = shapes()[0].area;
  const FillResult fill = fillRegion(square, options);
  const std::vector<FillRoom> rooms = shareRoom(square, fill.beads, options, 2.0);
  std::size_t lines = 0;
  for (std::size_t b = 0; b < rooms.size(); ++b) {
    const FillBead& bead = fill.beads[b];
    const double length = geometry::polylineLength(bead.points, bead.closed);
    if (bead.closed) {
      // Half a width to the border, and half the way to the first line: 26 mm between the last
      // places for lines hold six gaps, and what is left lies on both sides.
      const double left = 0.5 * (40.0 - 2.0 * (3.0 + 4.002) - 6.0 * 4.002);
      const double expected = 3.0 + 0.5 * (4.002 + left);
      EXPECT_NEAR(rooms[b].at(0.125 * length), expected, 0.03);
    } else if (std::abs(bead.points[0].y() - 20.0) < 8.0) {
      ++lines;
      EXPECT_NEAR(rooms[b].at(0.5 * length), 4.002, 2e-3);
    }
  }
  EXPECT_GE(lines, 3U);
}

TEST(FillRoom, OfALoneBeadIsItsPlace) {
  // A wall of 7 mm with one bead along its middle: 7 mm² per mm, whatever its width.
  const Region2 wall = region({{{0, 0}, {200, 0}, {200, 7}, {0, 7}}});
  FillBead bead;
  bead.points = {{3.5, 3.5}, {196.5, 3.5}};
  bead.widths = {7.0, 7.0};
  const FillOptions options = beadOf6(FillPattern::Medial);
  const std::vector<FillRoom> rooms = shareRoom(wall, {bead}, options, 2.0);
  EXPECT_NEAR(rooms[0].at(100.0), 7.0, 1e-3);
  EXPECT_NEAR(rooms[0].area(), 200.0 * 7.0, 0.02 * 1400.0);
}

TEST(FillRoom, PilesAreMeasuredByVolume) {
  // Both sides of a wall of 7 mm: each bead has 3.5 mm. No bead is narrower than 5.5 mm, which
  // holds 0.667 times that.
  const Region2 wall = region({{{0, 0}, {200, 0}, {200, 7}, {0, 7}}});
  FillOptions options = beadOf6(FillPattern::Zigzag);
  EXPECT_NEAR(fillRatio(wall, shareRoom(wall, fillRegion(wall, options).beads, options, 2.0)), 1.0,
              0.01);
  options.minWidth = 5.5;
  options.fillNarrow = false;
  EXPECT_NEAR(fillRatio(wall, shareRoom(wall, fillRegion(wall, options).beads, options, 2.0)),
              0.667 * 5.5 / 3.5, 0.02);
}

TEST(Fill, RandomRegionsGiveBeadsThatDoNotCrossThemselves) {
  for (const std::uint64_t seed : testing::testSeeds(25)) {
    testing::RandomSource random(seed);
    const int n = 3 + static_cast<int>(random.below(80));
    const double wave = random.real(0.0, 0.8);
    const auto lobes = static_cast<double>(1 + random.below(9));
    Polyline2 loop;
    for (int i = 0; i < n; ++i) {
      const double a = 2.0 * kPi * i / n;
      const double r = 50.0 * (1.0 + wave * std::sin(lobes * a));
      loop.emplace_back(r * std::cos(a), r * std::sin(a) * random.real(0.8, 1.0));
    }
    const Region2 area = region({loop});
    for (const auto& [pattern, name] : kPatterns) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      FillOptions options = beadOf6(pattern);
      options.walls = static_cast<int>(random.below(3));
      options.angle = random.real(0.0, kPi);
      const FillResult fill = fillRegion(area, options);
      const FillCoverage coverage = fillCoverage(area, fill.beads, options);
      EXPECT_LE(coverage.coveredPart(), 1.0);
      const double ratio = fillRatio(area, shareRoom(area, fill.beads, options, 2.0));
      EXPECT_LE(ratio, 1.03);
      EXPECT_GE(ratio, 0.97 * coverage.coveredPart());
      for (const FillBead& bead : fill.beads) {
        ASSERT_TRUE(bead.widths.empty() || bead.widths.size() == bead.points.size());
        ASSERT_FALSE(geometry::findCrossing(std::span(&bead.points, 1), bead.closed, 0.0));
        for (const Vec2& p : bead.points) {
          ASSERT_TRUE(p.allFinite());
          ASSERT_TRUE(area.contains(p));
        }
      }
    }
  }
}

TEST(Fill, RefusesOptionsOutOfRange) {
  const Region2 square = shapes()[0].area;
  const auto refused = [&](auto change) {
    FillOptions options = beadOf6(FillPattern::Zigzag);
    change(options);
    testing::errorOf(ErrorCode::InvalidArgument,
                     [&] { static_cast<void>(fillRegion(square, options)); });
  };
  refused([](FillOptions& o) { o.width = 0.0; });
  refused([](FillOptions& o) { o.width = NAN; });
  refused([](FillOptions& o) { o.overlap = 0.0; });
  refused([](FillOptions& o) { o.overlap = 1.5; });
  refused([](FillOptions& o) { o.minWidth = 20.0; });
  refused([](FillOptions& o) { o.walls = -1; });
  refused([](FillOptions& o) { o.tolerance = 0.0; });
  EXPECT_TRUE(fillRegion({}, beadOf6(FillPattern::Medial)).beads.empty());
  // A region smaller than a bead.
  const Region2 dot = region({circle(0, 0, 1.0, 40)});
  for (const auto& [pattern, name] : kPatterns) {
    EXPECT_TRUE(fillRegion(dot, beadOf6(pattern)).beads.empty()) << name;
  }
}

}  // namespace
}  // namespace wcam::toolpath
