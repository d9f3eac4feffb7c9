// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/aabb_tree.hpp"
#include "wcam/geometry/segment_tree.hpp"

#include "sample_meshes.hpp"
#include <gtest/gtest.h>

#include <random>

namespace wcam::geometry {
namespace {

TEST(AabbTree, ClosestPointOnABox) {
  const AabbTree tree(test::boxMesh({0, 0, 0}, {4, 3, 2}));
  const auto hit = tree.closestPoint({5, 1, 1});
  ASSERT_TRUE(hit);
  EXPECT_NEAR((hit->p - Vec3(4, 1, 1)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(hit->distance, 1.0, 1e-12);
  EXPECT_NEAR(tree.closestPoint({5, 4, 3})->distance, std::sqrt(3.0), 1e-12);
}

TEST(AabbTree, FirstHitOfARay) {
  const AabbTree tree(test::boxMesh({0, 0, 0}, {4, 3, 2}));
  const auto hit = tree.firstHit({1, 1, 10}, {0, 0, -2});
  ASSERT_TRUE(hit);
  EXPECT_NEAR((hit->p - Vec3(1, 1, 2)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(hit->distance, 8.0, 1e-12);
  EXPECT_FALSE(tree.firstHit({1, 1, 10}, {0, 0, 1}));
}

TEST(AabbTree, EmptyAndDegenerateMeshesHaveNoHits) {
  TriangleMesh mesh;
  EXPECT_FALSE(AabbTree(mesh).closestPoint({0, 0, 0}));
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}};
  mesh.triangles = {{0, 1, 1}};
  EXPECT_FALSE(AabbTree(mesh).closestPoint({0, 0, 0}));
}

TEST(SegmentTree, AgreesWithAllSegments) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-10.0, 10.0);
    std::vector<Vec3> line;
    for (int i = 0; i < 157; ++i) {
      line.emplace_back(uniform(random), uniform(random), uniform(random));
    }
    SegmentTree tree;
    tree.add(line, true);
    tree.add({Vec3(50, 50, 50)}, false);
    tree.build();
    for (int q = 0; q < 200; ++q) {
      const Vec3 p = 2.0 * Vec3(uniform(random), uniform(random), uniform(random));
      double expected = (p - Vec3(50, 50, 50)).norm();
      for (std::size_t i = 0; i < line.size(); ++i) {
        expected = std::min(expected, distanceToSegment(p, line[i], line[(i + 1) % line.size()]));
      }
      EXPECT_DOUBLE_EQ(tree.distance(p), expected);
    }
  }
  SegmentTree none;
  none.build();
  EXPECT_TRUE(std::isinf(none.distance(Vec3::Zero())));
}

}  // namespace
}  // namespace wcam::geometry
