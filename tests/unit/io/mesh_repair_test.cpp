// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_repair.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"

#include "io_files.hpp"
#include "polygon.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace wcam::io {
namespace {

using geometry::HalfEdges;
using geometry::TriangleMesh;
using geometry::Vec3;

Orientation orientationOf(const TriangleMesh& mesh) {
  return findOrientation(mesh, HalfEdges(mesh), {}, mesh.triangles.size(), "part.stl",
                         JobContext());
}

void apply(TriangleMesh& mesh, const Orientation& orientation) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (orientation.flipNode[t]) {
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
  }
}

void turnAll(TriangleMesh& mesh) {
  for (auto& t : mesh.triangles) {
    std::swap(t[1], t[2]);
  }
}

TEST(MeshRepair, DegenerateAndDuplicateTrianglesGo) {
  TriangleMesh mesh = test::boxMesh(Vec3(0, 0, 0), Vec3(1, 2, 3));
  const auto clean = mesh.triangles;
  mesh.triangles.insert(mesh.triangles.begin() + 3, {5, 5, 1});
  mesh.triangles.push_back({mesh.triangles[0][1], mesh.triangles[0][2], mesh.triangles[0][0]});
  mesh.triangles.push_back({mesh.triangles[1][0], mesh.triangles[1][2], mesh.triangles[1][1]});
  const Dropped degenerate = dropDegenerate(mesh);
  EXPECT_EQ(degenerate.count, 1U);
  EXPECT_EQ(degenerate.first, mesh.vertices[5]);
  EXPECT_EQ(dropDuplicates(mesh).count, 2U);
  EXPECT_EQ(mesh.triangles, clean);
}

TEST(MeshRepair, WallsBetweenTouchingBodiesAreDropped) {
  // Two cubes of two triangles a side that share the corners of one side.
  TriangleMesh two = test::boxMesh({0, 0, 0}, {10, 10, 10});
  const TriangleMesh other = test::boxMesh({10, 0, 0}, {20, 10, 10});
  for (const auto& t : other.triangles) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = other.vertices[t[k]];
      const auto same = std::find_if(two.vertices.begin(), two.vertices.end(),
                                     [&p](const Vec3& q) { return (p - q).norm() < 1e-9; });
      corners[k] = static_cast<std::uint32_t>(same - two.vertices.begin());
      if (same == two.vertices.end()) {
        two.vertices.push_back(p);
      }
    }
    two.triangles.push_back(corners);
  }
  const std::size_t all = two.triangles.size();
  const Dropped dropped = dropInnerWalls(two);
  EXPECT_EQ(dropped.count, 4U);
  EXPECT_EQ(two.triangles.size(), all - 4);
  EXPECT_TRUE(HalfEdges(two).closed());
  EXPECT_TRUE(HalfEdges(two).nonManifoldEdges().empty());
}

TEST(MeshRepair, SheetsWithTwoSidesAreKept) {
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}};
  EXPECT_EQ(dropInnerWalls(sheet).count, 0U);
  // As a fin on a box: three of its sides are free.
  TriangleMesh fin = test::boxMesh({0, 0, 0}, {10, 10, 10});
  const auto find = [&fin](const Vec3& p) {
    for (std::uint32_t v = 0; v < fin.vertices.size(); ++v) {
      if ((fin.vertices[v] - p).norm() < 1e-9) {
        return v;
      }
    }
    fin.vertices.push_back(p);
    return static_cast<std::uint32_t>(fin.vertices.size() - 1);
  };
  const std::uint32_t a = find({0, 0, 10});
  const std::uint32_t b = find({10, 0, 10});
  const std::uint32_t c = find({10, -5, 15});
  const std::uint32_t d = find({0, -5, 15});
  for (const auto& t :
       std::vector<std::array<std::uint32_t, 3>>{{a, b, c}, {a, c, d}, {c, b, a}, {d, c, a}}) {
    fin.triangles.push_back(t);
  }
  EXPECT_EQ(dropInnerWalls(fin).count, 0U);
}

TEST(MeshRepair, RandomlyTurnedTrianglesAreTurnedBack) {
  const unsigned seed = 11;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const TriangleMesh torus = test::torusMesh(40, 30, 50, 15);
  for (int run = 0; run < 20; ++run) {
    TriangleMesh mesh = torus;
    std::size_t turned = 0;
    for (auto& t : mesh.triangles) {
      if (random() % 20 < static_cast<unsigned>(run)) {
        std::swap(t[1], t[2]);
        ++turned;
      }
    }
    const Orientation orientation = orientationOf(mesh);
    EXPECT_EQ(orientation.flippedTriangles, turned);
    EXPECT_EQ(orientation.components, 1U);
    apply(mesh, orientation);
    EXPECT_EQ(mesh.triangles, torus.triangles);
  }
}

TEST(MeshRepair, OpenPieceKeepsItsMajority) {
  TriangleMesh mesh = test::torusMesh(40, 30, 50, 15);
  mesh.triangles.resize(1200);
  const auto before = mesh.triangles;
  std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
  const Orientation orientation = orientationOf(mesh);
  EXPECT_EQ(orientation.flippedTriangles, 1U);
  EXPECT_TRUE(orientation.flipNode[7]);
}

TEST(MeshRepair, CavityStaysACavity) {
  TriangleMesh outer = test::boxMesh(Vec3(0, 0, 0), Vec3(10, 10, 10));
  TriangleMesh hole = test::boxMesh(Vec3(3, 3, 3), Vec3(6, 6, 6));
  turnAll(hole);
  TriangleMesh mesh = outer;
  test::append(mesh, hole);
  EXPECT_EQ(orientationOf(mesh).flippedTriangles, 0U);

  turnAll(mesh);  // the whole file inside out
  apply(mesh, orientationOf(mesh));
  EXPECT_NEAR(test::signedVolume(mesh), 1000.0 - 27.0, 1e-9);
}

TEST(MeshRepair, SeparateBodiesPointOutwards) {
  TriangleMesh mesh = test::boxMesh(Vec3(0, 0, 0), Vec3(1, 1, 1));
  TriangleMesh other = test::boxMesh(Vec3(5, 0, 0), Vec3(7, 2, 2));
  turnAll(other);
  test::append(mesh, other);
  apply(mesh, orientationOf(mesh));
  EXPECT_NEAR(test::signedVolume(mesh), 9.0, 1e-9);
}

TEST(MeshRepair, MoebiusStripIsRefusedWithItsPlace) {
  TriangleMesh strip;
  const int n = 30;
  for (int i = 0; i < n; ++i) {
    const double u = 2 * kPi * i / n;
    for (const double w : {-1.0, 1.0}) {
      const double r = 10 + w * std::cos(u / 2);
      strip.vertices.emplace_back(r * std::cos(u), r * std::sin(u), w * std::sin(u / 2));
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = 2 * i + 1;
    const std::uint32_t c = i + 1 < n ? 2 * i + 2 : 1;
    const std::uint32_t d = i + 1 < n ? 2 * i + 3 : 0;
    strip.triangles.push_back({a, c, b});
    strip.triangles.push_back({b, c, d});
  }
  try {
    orientationOf(strip);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InputInvalid);
    EXPECT_THAT(error.what(), testing::HasSubstr("only one side"));
    EXPECT_THAT(error.what(), testing::HasSubstr("mm"));
  }
}

TEST(MeshRepair, NonManifoldEdgeIsKeptAndNotOriented) {
  TriangleMesh mesh = test::boxMesh(Vec3(0, 0, 0), Vec3(1, 1, 1));
  mesh.vertices.push_back(Vec3(2, 2, 0.5));
  mesh.triangles.push_back({3, 7, 8});  // a fin on a vertical edge
  const HalfEdges halfEdges(mesh);
  EXPECT_EQ(halfEdges.nonManifoldEdges().size(), 1U);
  EXPECT_EQ(orientationOf(mesh).flippedTriangles, 0U);
}

TEST(MeshRepair, BordersWithinToleranceAreJoined) {
  TriangleMesh mesh = test::torusMesh(20, 10, 50, 15);
  TriangleMesh soup;
  const unsigned seed = 3;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-1e-4, 1e-4);
  for (const auto& t : mesh.triangles) {
    const auto base = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t v : t) {
      soup.vertices.push_back(mesh.vertices[v] + Vec3(noise(random), noise(random), noise(random)));
    }
    soup.triangles.push_back({base, base + 1, base + 2});
  }
  EXPECT_EQ(stitchBorders(soup, HalfEdges(soup), 1e-3), soup.vertices.size() - 200);
  dropUnusedVertices(soup);
  EXPECT_EQ(soup.vertices.size(), 200U);
  EXPECT_TRUE(HalfEdges(soup).closed());
}

TEST(MeshRepair, FlatTrianglesAreCounted) {
  TriangleMesh mesh;
  mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 1e-9, 0), Vec3(0, 1, 0)};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
  EXPECT_EQ(countFlat(mesh).count, 1U);
}

TEST(Polygon, ConcavePolygonKeepsItsArea) {
  // An L in the plane y = 3, and the same turned over.
  std::vector<Vec3> p = {Vec3(0, 3, 0), Vec3(0, 3, 4), Vec3(1, 3, 4),
                         Vec3(1, 3, 1), Vec3(3, 3, 1), Vec3(3, 3, 0)};
  std::vector<std::uint32_t> corners = {0, 1, 2, 3, 4, 5};
  for (int turn = 0; turn < 2; ++turn) {
    for (int shift = 0; shift < 6; ++shift) {
      std::vector<std::array<std::uint32_t, 3>> triangles;
      dividePolygon(p, corners, triangles);
      ASSERT_EQ(triangles.size(), 4U);
      double area = 0.0;
      Vec3 sum = Vec3::Zero();
      for (const auto& t : triangles) {
        const Vec3 n = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]) / 2;
        area += n.norm();
        sum += n;
      }
      EXPECT_NEAR(area, 6.0, 1e-12);
      EXPECT_NEAR(sum.norm(), 6.0, 1e-12);
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    }
    std::reverse(corners.begin(), corners.end());
  }
}

TEST(Polygon, CrossedPolygonEnds) {
  const std::vector<Vec3> p = {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  std::vector<std::array<std::uint32_t, 3>> triangles;
  dividePolygon(p, {0, 1, 2, 3}, triangles);
  EXPECT_EQ(triangles.size(), 2U);
}

}  // namespace
}  // namespace wcam::io
