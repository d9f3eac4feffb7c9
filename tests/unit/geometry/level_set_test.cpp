// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/level_set.hpp"

#include "wcam/base/parallel.hpp"

#include "sample_meshes.hpp"
#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace wcam::geometry {
namespace {

using test::boxMesh;
using test::torusMesh;
using test::tubeMesh;

double lengthOf(const LevelContour& contour) {
  double length = 0.0;
  for (std::size_t i = 1; i < contour.points.size(); ++i) {
    length += (contour.points[i] - contour.points[i - 1]).norm();
  }
  return contour.closed ? length + (contour.points.front() - contour.points.back()).norm() : length;
}

/// Signed area seen from the end of `up`, for closed contours in a plane.
double areaOf(const LevelContour& contour, const Vec3& up) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    sum += contour.points[i].cross(contour.points[(i + 1) % contour.points.size()]);
  }
  return 0.5 * sum.dot(up);
}

TEST(LevelSet, TubeGivesOneClosedContourPerLevelClockwiseSeenFromAbove) {
  const TriangleMesh mesh = tubeMesh(10.0, 20.0, 48, 13);
  const HalfEdges halfEdges(mesh);
  const std::vector<double> levels{0.0, 5.0, 20.0 * 7 / 13, 19.0};
  const auto sections = planeSections(mesh, halfEdges, Vec3::UnitZ(), levels);
  const double polygon = 0.5 * 48 * 100.0 * std::sin(2.0 * kPi / 48);
  for (std::size_t l = 0; l < levels.size(); ++l) {
    ASSERT_EQ(sections[l].size(), 1U) << "level " << l;
    EXPECT_TRUE(sections[l][0].closed);
    // t × n = up makes outer contours run clockwise seen from above.
    EXPECT_NEAR(areaOf(sections[l][0], Vec3::UnitZ()), -polygon, 1e-9) << "level " << l;
    for (const Vec3& p : sections[l][0].points) {
      EXPECT_NEAR(p.z(), levels[l], 1e-12);
    }
  }
}

TEST(LevelSet, BorderAtTheMinimumIsAContourAndTheOneAtTheTopToo) {
  const TriangleMesh mesh = tubeMesh(10.0, 20.0, 32, 4);
  const auto sections =
      planeSections(mesh, HalfEdges(mesh), Vec3::UnitZ(), std::vector<double>{0.0, 20.0});
  for (const auto& section : sections) {
    ASSERT_EQ(section.size(), 1U);
    EXPECT_TRUE(section[0].closed);
    EXPECT_EQ(section[0].points.size(), 32U);  // no node twice
  }
}

TEST(LevelSet, BoxSectionsAtItsFlatFacesAreTheOutline) {
  const TriangleMesh mesh = boxMesh({0, 0, 0}, {4, 3, 2});
  const auto sections =
      planeSections(mesh, HalfEdges(mesh), Vec3::UnitZ(), std::vector<double>{0.0, 1.0, 2.0});
  for (const auto& section : sections) {
    ASSERT_EQ(section.size(), 1U);
    EXPECT_TRUE(section[0].closed);
    EXPECT_NEAR(lengthOf(section[0]), 14.0, 1e-12);
  }
}

TEST(LevelSet, OpenSurfaceGivesOpenContoursFromBorderToBorder) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 0, 3}, {0, 0, 3}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto sections =
      planeSections(mesh, HalfEdges(mesh), Vec3::UnitZ(), std::vector<double>{1.0});
  ASSERT_EQ(sections[0].size(), 1U);
  EXPECT_FALSE(sections[0][0].closed);
  EXPECT_EQ(sections[0][0].points.size(), 3U);
  EXPECT_NEAR(lengthOf(sections[0][0]), 4.0, 1e-12);
}

/// Sum over all triangles of the length cut by the plane: the oracle, planes × triangles.
double bruteForceLength(const TriangleMesh& mesh, const Vec3& up, double level) {
  double total = 0.0;
  for (const auto& triangle : mesh.triangles) {
    std::vector<Vec3> cuts;
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3& a = mesh.vertices[triangle[c]];
      const Vec3& b = mesh.vertices[triangle[(c + 1) % 3]];
      const double fa = up.dot(a) - level;
      const double fb = up.dot(b) - level;
      if ((fa < 0.0) != (fb < 0.0)) {
        cuts.push_back(a + fa / (fa - fb) * (b - a));
      }
    }
    if (cuts.size() == 2) {
      total += (cuts[1] - cuts[0]).norm();
    }
  }
  return total;
}

TEST(LevelSet, AgreesWithEveryTriangleCutByEveryPlane) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    TriangleMesh mesh = torusMesh(20.0, 7.0, 24, 40);
    for (Vec3& v : mesh.vertices) {
      v += 0.8 * Vec3(uniform(random), uniform(random), uniform(random));
    }
    const HalfEdges halfEdges(mesh);
    ASSERT_TRUE(halfEdges.closed());
    const Vec3 up = Vec3(uniform(random), uniform(random), uniform(random)).normalized();
    std::vector<double> levels;
    for (double level = -30.0; level < 30.0; level += 0.1 + std::abs(uniform(random))) {
      levels.push_back(level);
    }
    const auto sections = planeSections(mesh, halfEdges, up, levels);
    for (std::size_t l = 0; l < levels.size(); ++l) {
      double length = 0.0;
      for (const LevelContour& contour : sections[l]) {
        EXPECT_TRUE(contour.closed);
        length += lengthOf(contour);
      }
      EXPECT_NEAR(length, bruteForceLength(mesh, up, levels[l]), 1e-9);
    }
  }
}

TEST(LevelSet, LevelsThroughVerticesLoseAndRepeatNothing) {
  // A grid of integer heights: every level passes through vertices and along edges.
  std::mt19937 random(7);
  std::uniform_int_distribution<int> height(0, 4);
  for (int run = 0; run < 50; ++run) {
    SCOPED_TRACE("run " + std::to_string(run));
    constexpr int kSize = 8;
    TriangleMesh mesh;
    for (int i = 0; i < kSize; ++i) {
      for (int j = 0; j < kSize; ++j) {
        const bool rim = i == 0 || j == 0 || i == kSize - 1 || j == kSize - 1;
        mesh.vertices.emplace_back(i, j, rim ? 0 : height(random));
      }
    }
    const auto index = [](int i, int j) { return static_cast<std::uint32_t>(i * kSize + j); };
    for (int i = 0; i + 1 < kSize; ++i) {
      for (int j = 0; j + 1 < kSize; ++j) {
        mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
        mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
      }
    }
    const HalfEdges halfEdges(mesh);
    const auto sections =
        planeSections(mesh, halfEdges, Vec3::UnitZ(), std::vector<double>{1.0, 2.0, 3.0, 4.0});
    for (std::size_t l = 0; l < 4; ++l) {
      // "On a level counts as above" is the limit of the level from below.
      const auto limit = planeSections(mesh, halfEdges, Vec3::UnitZ(),
                                       std::vector<double>{static_cast<double>(l) + 1.0 - 1e-7});
      EXPECT_EQ(sections[l].size(), limit[0].size());
      double length = 0.0;
      double limitLength = 0.0;
      for (const LevelContour& contour : sections[l]) {
        EXPECT_TRUE(contour.closed);
        length += lengthOf(contour);
        for (std::size_t i = 0; i + 1 < contour.points.size(); ++i) {
          EXPECT_NE(contour.points[i], contour.points[i + 1]);
        }
      }
      for (const LevelContour& contour : limit[0]) {
        limitLength += lengthOf(contour);
      }
      EXPECT_NEAR(length, limitLength, 1e-4);
    }
  }
}

TEST(LevelSet, ApexAtALevelIsASinglePoint) {
  TriangleMesh mesh;
  mesh.vertices = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const auto sections =
      planeSections(mesh, HalfEdges(mesh), Vec3::UnitZ(), std::vector<double>{1.0});
  ASSERT_EQ(sections[0].size(), 1U);
  EXPECT_EQ(sections[0][0].points.size(), 1U);
  EXPECT_EQ(sections[0][0].points[0], Vec3(0, 0, 1));
}

TEST(LevelSet, CurvesAreJoinedAcrossANonManifoldEdge) {
  // Two boxes that share one vertical edge.
  TriangleMesh mesh = boxMesh({0, 0, 0}, {1, 1, 1});
  const TriangleMesh other = boxMesh({1, 1, 0}, {2, 2, 1});
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vec3& v : other.vertices) {
    mesh.vertices.push_back(v);
  }
  for (auto triangle : other.triangles) {
    for (std::uint32_t& v : triangle) {
      v += offset;
      // (1,1,0) and (1,1,1) are corners 3 and 7 of the first box.
      v = v == offset + 0 ? 3 : (v == offset + 4 ? 7 : v);
    }
    mesh.triangles.push_back(triangle);
  }
  const HalfEdges halfEdges(mesh);
  ASSERT_EQ(halfEdges.nonManifoldEdges().size(), 1U);
  const auto sections = planeSections(mesh, halfEdges, Vec3::UnitZ(), std::vector<double>{0.5});
  double length = 0.0;
  for (const LevelContour& contour : sections[0]) {
    EXPECT_TRUE(contour.closed);
    length += lengthOf(contour);
  }
  EXPECT_NEAR(length, 8.0, 1e-12);
}

TEST(LevelSet, VerticesOutsideTheFieldCutTheCurve) {
  const TriangleMesh mesh = tubeMesh(10.0, 10.0, 36, 4);
  std::vector<double> scalar;
  for (const Vec3& v : mesh.vertices) {
    scalar.push_back(v.x() > 5.0 ? std::numeric_limits<double>::quiet_NaN() : v.z());
  }
  const auto curves = traceLevels(mesh, HalfEdges(mesh), scalar, std::vector<double>{3.0}, 1e-12);
  ASSERT_EQ(curves[0].size(), 1U);
  EXPECT_FALSE(curves[0][0].closed);
  for (const Vec3& p : curves[0][0].points) {
    EXPECT_LE(p.x(), 5.0);
  }
}

TEST(LevelSet, DoesNotDependOnTheNumberOfThreads) {
  const TriangleMesh mesh = torusMesh(50.0, 15.0, 90, 200);
  const HalfEdges halfEdges(mesh);
  std::vector<double> levels(301);
  std::iota(levels.begin(), levels.end(), 0.0);
  for (double& level : levels) {
    level = -15.0 + 0.1 * level;
  }
  std::vector<std::vector<std::vector<LevelContour>>> results;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    results.push_back(planeSections(mesh, halfEdges, Vec3::UnitZ(), levels));
  }
  for (std::size_t r = 1; r < results.size(); ++r) {
    for (std::size_t l = 0; l < levels.size(); ++l) {
      ASSERT_EQ(results[0][l].size(), results[r][l].size());
      for (std::size_t c = 0; c < results[0][l].size(); ++c) {
        EXPECT_EQ(results[0][l][c].points, results[r][l][c].points);
      }
    }
  }
}

}  // namespace
}  // namespace wcam::geometry
