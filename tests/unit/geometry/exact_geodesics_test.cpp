// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/geodesic.hpp"

#include "../../support/error_matchers.hpp"
#include "../../support/field_meshes.hpp"

#include <cmath>

namespace {

using namespace wcam;
using namespace wcam::geometry;
using wcam::testing::errorOf;

double lengthOf(const std::vector<Vec3>& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    length += (path[i] - path[i - 1]).norm();
  }
  return length;
}

TEST(ExactGeodesics, PlaneIsEuclidean) {
  const TriangleMesh mesh = test::gridMesh(30.0, 20.0, 15, 11);
  const std::uint32_t source = 5 * 16 + 3;
  const ExactGeodesics exact(mesh, {source});
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    EXPECT_NEAR(exact.distance(v), (mesh.vertices[v] - mesh.vertices[source]).norm(), 1e-9);
    const std::vector<Vec3> path = exact.path(v);
    ASSERT_FALSE(path.empty());
    EXPECT_NEAR(lengthOf(path), exact.distance(v), 1e-9);
    EXPECT_LT((path.front() - mesh.vertices[v]).norm(), 1e-9);
    EXPECT_LT((path.back() - mesh.vertices[source]).norm(), 1e-9);
  }
}

TEST(ExactGeodesics, TubeUnrolls) {
  // A prism of 24 facets unrolls to a strip; the shorter way around counts.
  const int around = 24;
  const TriangleMesh mesh = test::tubeMesh(10.0, 30.0, around, 12);
  const double facet = 2.0 * 10.0 * std::sin(kPi / around);
  const ExactGeodesics exact(mesh, {0});
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const int j = static_cast<int>(v) % around;
    const double way = facet * std::min(j, around - j);
    EXPECT_NEAR(exact.distance(v), std::hypot(way, mesh.vertices[v].z()), 1e-9);
  }
}

TEST(ExactGeodesics, OppositeCornerOfABox) {
  // Over two faces of a 2 × 3 × 4 box: √((2 + 3)² + 4²).
  const ExactGeodesics exact(test::boxMesh({0, 0, 0}, {2, 3, 4}), {0});
  EXPECT_NEAR(exact.distance(7), std::sqrt(41.0), 1e-9);
  EXPECT_NEAR(lengthOf(exact.path(7)), std::sqrt(41.0), 1e-9);
  EXPECT_EQ(exact.distance(0), 0.0);
}

TEST(ExactGeodesics, SeveralSourcesAndIslands) {
  TriangleMesh mesh = test::tubeMesh(10.0, 30.0, 24, 12);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::vector<std::uint32_t> ring = test::borderAt(mesh, true);
  mesh.vertices.emplace_back(100, 0, 0);
  mesh.vertices.emplace_back(101, 0, 0);
  mesh.vertices.emplace_back(100, 1, 0);
  mesh.vertices.emplace_back(100, 1, 50);
  mesh.triangles.push_back({first, first + 1, first + 2});
  const ExactGeodesics exact(mesh, ring);
  for (std::uint32_t v = 0; v < first; ++v) {
    EXPECT_NEAR(exact.distance(v), mesh.vertices[v].z(), 1e-9);
  }
  for (std::uint32_t v = first; v < first + 4; ++v) {
    EXPECT_TRUE(std::isinf(exact.distance(v)));
    EXPECT_TRUE(exact.path(v).empty());
  }
}

TEST(ExactGeodesics, RefusesBrokenMeshes) {
  TriangleMesh mesh = test::tubeMesh(10.0, 30.0, 24, 12);
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { ExactGeodesics(mesh, {}); }),
              ::testing::HasSubstr("no vertex is a source"));
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { ExactGeodesics(mesh, {100000}); }),
              ::testing::HasSubstr("no vertex 100000"));
  TriangleMesh twice = mesh;
  twice.triangles.push_back(twice.triangles[10]);
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { ExactGeodesics(twice, {0}); }),
              ::testing::HasSubstr("non-manifold"));
  TriangleMesh flat = mesh;
  flat.triangles.push_back({0, 1, 1});
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { ExactGeodesics(flat, {0}); }),
              ::testing::HasSubstr("without area"));
}

}  // namespace
