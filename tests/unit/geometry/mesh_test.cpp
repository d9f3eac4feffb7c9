// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/mesh.hpp"

#include "io_files.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace wcam::geometry {
namespace {

using Edge = std::array<std::uint32_t, 2>;

std::uint32_t startOf(const TriangleMesh& mesh, std::uint32_t h) {
  return mesh.triangles[h / 3][h % 3];
}

std::uint32_t endOf(const TriangleMesh& mesh, std::uint32_t h) {
  return mesh.triangles[h / 3][(h + 1) % 3];
}

Edge sorted(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

/// Compares with edges found by a map, and walks the border loops.
void expectConsistent(const TriangleMesh& mesh) {
  const HalfEdges halfEdges(mesh);
  std::map<Edge, std::vector<std::uint32_t>> users;
  const auto count = static_cast<std::uint32_t>(3 * mesh.triangles.size());
  for (std::uint32_t h = 0; h < count; ++h) {
    users[sorted(startOf(mesh, h), endOf(mesh, h))].push_back(h);
  }
  ASSERT_EQ(halfEdges.edgeCount(), users.size());
  std::uint32_t edge = 0;
  std::size_t borders = 0;
  std::vector<std::uint32_t> nonManifold;
  std::size_t withoutTwin = 0;
  for (const auto& [vertices, list] : users) {  // ordered as the edges are numbered
    EXPECT_EQ(halfEdges.edgeVertices(edge), vertices);
    EXPECT_EQ(halfEdges.halfEdgeOf(edge), list.front());
    const bool paired = list.size() == 2 && startOf(mesh, list[0]) != startOf(mesh, list[1]);
    for (const std::uint32_t h : list) {
      EXPECT_EQ(halfEdges.edgeOf(h), edge);
      EXPECT_EQ(halfEdges.twin(h), paired ? list[0] + list[1] - h : HalfEdges::kNone);
    }
    borders += paired ? 0 : 1;
    withoutTwin += paired ? 0 : list.size();
    if (!paired && list.size() > 1) {
      nonManifold.push_back(edge);
    }
    ++edge;
  }
  EXPECT_EQ(halfEdges.borderEdgeCount(), borders);
  EXPECT_EQ(halfEdges.nonManifoldEdges(), nonManifold);
  std::size_t onLoops = 0;
  for (const auto& loop : halfEdges.borderLoops(mesh)) {
    onLoops += loop.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      EXPECT_EQ(users.count(sorted(loop[i], loop[(i + 1) % loop.size()])), 1U);
    }
  }
  EXPECT_EQ(onLoops, withoutTwin);
}

TEST(HalfEdges, ClosedTorus) {
  const TriangleMesh torus = test::torusMesh(30, 20, 50, 15);
  const HalfEdges halfEdges(torus);
  EXPECT_TRUE(halfEdges.closed());
  EXPECT_EQ(halfEdges.edgeCount(), 1800U);
  EXPECT_TRUE(halfEdges.borderLoops(torus).empty());
  expectConsistent(torus);
}

TEST(HalfEdges, CutTorusHasTwoLoopsInTheDirectionOfTheirTriangles) {
  TriangleMesh torus = test::torusMesh(30, 20, 50, 15);
  torus.triangles.resize(600);  // fifteen rings of 40
  const HalfEdges halfEdges(torus);
  const auto loops = halfEdges.borderLoops(torus);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].size(), 20U);
  EXPECT_EQ(loops[1].size(), 20U);
  expectConsistent(torus);
}

TEST(HalfEdges, TwoHolesThatTouchAtAVertexAreTwoLoops) {
  // A fan of six triangles about vertex 0 without the first and the fourth.
  TriangleMesh mesh;
  mesh.vertices.emplace_back(0, 0, 0);
  for (int i = 0; i < 6; ++i) {
    mesh.vertices.emplace_back(std::cos(i), std::sin(i), 0);
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 4}, {0, 5, 6}, {0, 6, 1}};
  EXPECT_EQ(HalfEdges(mesh).borderLoops(mesh).size(), 2U);
  expectConsistent(mesh);
}

TEST(HalfEdges, EqualDirectionIsNonManifold) {
  TriangleMesh mesh;
  mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
  const HalfEdges halfEdges(mesh);
  EXPECT_EQ(halfEdges.nonManifoldEdges().size(), 1U);
  EXPECT_EQ(halfEdges.twin(0), HalfEdges::kNone);
  expectConsistent(mesh);
}

TEST(HalfEdges, RandomSoups) {
  const unsigned seed = 4711;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int run = 0; run < 300; ++run) {
    TriangleMesh mesh;
    mesh.vertices.resize(4 + random() % 12, Vec3::Zero());
    const std::size_t triangles = random() % 40;
    while (mesh.triangles.size() < triangles) {
      const auto pick = [&] { return static_cast<std::uint32_t>(random() % mesh.vertices.size()); };
      const std::array<std::uint32_t, 3> t{pick(), pick(), pick()};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) {
        mesh.triangles.push_back(t);
      }
    }
    expectConsistent(mesh);
  }
}

TEST(TriangleMesh, BoundsAndNormals) {
  const TriangleMesh box = test::boxMesh(Vec3(-1, 0, 2), Vec3(3, 5, 7));
  EXPECT_EQ(box.bounds().min, Vec3(-1, 0, 2));
  EXPECT_EQ(box.bounds().max, Vec3(3, 5, 7));
  EXPECT_EQ(box.normal(0), -Vec3::UnitZ());
  TriangleMesh flat = box;
  flat.triangles.push_back({1, 1, 2});
  EXPECT_EQ(flat.normal(12), Vec3::Zero());
  EXPECT_TRUE(TriangleMesh().bounds().empty());
}

}  // namespace
}  // namespace wcam::geometry
