// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/harmonic.hpp"
#include "wcam/geometry/level_set.hpp"
#include "wcam/geometry/topology_events.hpp"

#include "../../support/error_matchers.hpp"
#include "../../support/field_meshes.hpp"
#include "../../support/implicit_mesh.hpp"
#include "../../support/random_source.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace {

using namespace wcam;
using namespace wcam::geometry;
using wcam::testing::errorOf;
using Kind = TopologyEvent::Kind;

std::vector<double> heights(const TriangleMesh& mesh) {
  std::vector<double> field;
  for (const Vec3& p : mesh.vertices) {
    field.push_back(p.z());
  }
  return field;
}

std::vector<Kind> kinds(const FieldTopology& topology) {
  std::vector<Kind> result;
  for (const TopologyEvent& event : topology.events) {
    result.push_back(event.kind);
  }
  return result;
}

double areaOf(const TriangleMesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return 0.5 *
         (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
}

/// The number of curves at a level must be the number of branches that cross it.
void expectCountsFit(const TriangleMesh& mesh,
                     const std::vector<double>& field,
                     const FieldTopology& topology,
                     double clear) {
  const auto [low, high] = std::minmax_element(field.begin(), field.end());
  for (int i = 1; i < 60; ++i) {
    const double level = *low + (*high - *low) * (i + 0.137) / 60.0;
    const bool near = std::any_of(
        topology.events.begin(), topology.events.end(),
        [&](const TopologyEvent& event) { return std::abs(event.level - level) < clear; });
    if (near) {
      continue;
    }
    const std::size_t curves =
        traceLevels(mesh, HalfEdges(mesh), field, std::vector<double>{level}, 0.0)[0].size();
    const auto crossing = static_cast<std::size_t>(
        std::count_if(topology.branches.begin(), topology.branches.end(),
                      [&](const FieldBranch& b) { return b.from < level && level < b.to; }));
    EXPECT_EQ(curves, crossing) << "level " << level;
  }
}

TEST(Topology, TubeIsOneBranch) {
  const TriangleMesh mesh = test::tubeMesh(10.0, 40.0, 17, 9);
  const FieldTopology t = fieldTopology(mesh, HalfEdges(mesh), heights(mesh), 0.0);
  EXPECT_EQ(kinds(t), (std::vector{Kind::Begin, Kind::End}));
  ASSERT_EQ(t.branches.size(), 1U);
  EXPECT_EQ(t.branches[0].from, 0.0);
  EXPECT_EQ(t.branches[0].to, 40.0);
  EXPECT_TRUE(t.branches[0].below.empty());
  EXPECT_TRUE(t.branches[0].above.empty());
  EXPECT_TRUE(std::all_of(t.branchOf.begin(), t.branchOf.end(), [](auto b) { return b == 0; }));
}

TEST(Topology, SlantedBordersStayOneBranch) {
  // Curves that open and close at a border remain one curve.
  TriangleMesh mesh = test::tubeMesh(10.0, 40.0, 40, 40);
  for (Vec3& p : mesh.vertices) {
    p.z() += 0.4 * p.x() * p.z() / 40.0;
  }
  const FieldTopology t = fieldTopology(mesh, HalfEdges(mesh), heights(mesh), 0.0);
  EXPECT_EQ(t.branches.size(), 1U);
  expectCountsFit(mesh, heights(mesh), t, 1e-6);
}

TEST(Topology, ForkHasThreeBranches) {  // Diourté A41
  for (const bool down : {false, true}) {
    const TriangleMesh mesh = test::forkMesh(30, down);
    const FieldTopology t = fieldTopology(mesh, HalfEdges(mesh), heights(mesh), 1.0);
    EXPECT_EQ(t.branches.size(), 3U);
    expectCountsFit(mesh, heights(mesh), t, 1e-6);
    if (down) {
      EXPECT_EQ(kinds(t), (std::vector{Kind::Begin, Kind::Begin, Kind::Merge, Kind::End}));
      EXPECT_EQ(t.branches[2].below, (std::vector<std::size_t>{0, 1}));
      EXPECT_EQ(t.branches[0].above, (std::vector<std::size_t>{2}));
    } else {
      EXPECT_EQ(kinds(t), (std::vector{Kind::Begin, Kind::Split, Kind::End, Kind::End}));
      EXPECT_EQ(t.branches[0].above, (std::vector<std::size_t>{1, 2}));
      EXPECT_EQ(t.branches[1].below, (std::vector<std::size_t>{0}));
    }
    const double saddle = t.events[down ? 2 : 1].level;
    const auto loops = [&](double level) {
      return traceLevels(mesh, HalfEdges(mesh), heights(mesh), std::vector<double>{level}, 0.0)[0]
          .size();
    };
    EXPECT_EQ(loops(saddle - 0.3), down ? 2U : 1U);
    EXPECT_EQ(loops(saddle + 0.3), down ? 1U : 2U);
    double sum = 0.0;
    std::vector<double> area(3, 0.0);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      area[t.branchOf[i]] += areaOf(mesh, i);
      sum += areaOf(mesh, i);
    }
    EXPECT_NEAR(area[0] + area[1] + area[2], sum, 1e-6 * sum);
    for (const double a : area) {
      EXPECT_GT(a, 0.1 * sum);
    }
  }
}

TEST(Topology, UprightTorusHasAHandle) {
  TriangleMesh mesh = test::torusMesh(30.0, 10.0, 24, 64);
  for (Vec3& p : mesh.vertices) {
    p = Vec3(p.x(), p.z(), p.y());  // the axis lies along y: turned over, normals do not matter
  }
  const FieldTopology t = fieldTopology(mesh, HalfEdges(mesh), heights(mesh), 1.0);
  EXPECT_EQ(kinds(t), (std::vector{Kind::Begin, Kind::Split, Kind::Handle, Kind::End}));
  ASSERT_EQ(t.branches.size(), 4U);
  EXPECT_EQ(t.branches[0].above, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(t.branches[3].below, (std::vector<std::size_t>{1, 2}));
  EXPECT_NEAR(t.events[1].level, -20.0, 0.2);
  EXPECT_NEAR(t.events[2].level, 20.0, 0.2);
  expectCountsFit(mesh, heights(mesh), t, 1e-6);
}

TEST(Topology, LyingTorusWithTies) {
  // Two whole circles of extrema and ties in every row.
  const TriangleMesh mesh = test::torusMesh(30.0, 10.0, 24, 64);
  const FieldTopology t = fieldTopology(mesh, HalfEdges(mesh), heights(mesh), 0.0);
  expectCountsFit(mesh, heights(mesh), t, 1e-6);
  EXPECT_EQ(t.branches.size(), 2U);  // the outer and the inner wall
  EXPECT_EQ(kinds(t), (std::vector{Kind::Begin, Kind::Begin, Kind::End, Kind::End}));
}

TEST(Topology, NoiseMakesNoBranch) {
  for (const std::uint64_t seed : wcam::testing::testSeeds(10)) {
    wcam::testing::RandomSource random(seed);
    const TriangleMesh mesh = test::tubeMesh(10.0, 40.0, 40, 40);
    std::vector<double> field = heights(mesh);
    for (double& value : field) {
      value += random.real(-1.5, 1.5);  // more than a row's height
    }
    const FieldTopology raw = fieldTopology(mesh, HalfEdges(mesh), field, 0.0);
    EXPECT_GT(raw.branches.size(), 50U) << seed;
    expectCountsFit(mesh, field, raw, 0.0);
    const FieldTopology t = fieldTopology(mesh, HalfEdges(mesh), field, 3.0);
    EXPECT_EQ(t.branches.size(), 1U) << seed;
    EXPECT_EQ(kinds(t), (std::vector{Kind::Begin, Kind::End})) << seed;
  }
}

TEST(Topology, NoiseOnAForkLeavesThreeBranches) {
  for (const std::uint64_t seed : wcam::testing::testSeeds(5)) {
    wcam::testing::RandomSource random(seed);
    const TriangleMesh mesh = test::forkMesh(40);
    std::vector<double> field = heights(mesh);
    for (double& value : field) {
      value += random.real(-1.5, 1.5);
    }
    const FieldTopology t = fieldTopology(mesh, HalfEdges(mesh), field, 4.0);
    EXPECT_EQ(t.branches.size(), 3U) << seed;
  }
}

TEST(Topology, ThreeLegsMeetAtOnce) {
  // Saddles at nearly one level are one place.
  const auto f = [](const Vec3& p) {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
      const double a = 2.0 * kPi * i / 3.0 + 0.1;
      sum += std::exp(
          -(test::segmentDistance(p, {0, 0, 60}, {60 * std::cos(a), 60 * std::sin(a), -20}) - 9.0) /
          2.0);
    }
    sum += std::exp(-(test::segmentDistance(p, {0, 0, 60}, {0, 0, 120}) - 9.0) / 2.0);
    return -2.0 * std::log(sum);
  };
  Box box;
  box.add(Vec3(-60, -60, 0));
  box.add(Vec3(60, 60, 90));
  const TriangleMesh mesh = test::implicitMesh(f, box, {40, 40, 30});
  const FieldTopology t = fieldTopology(mesh, HalfEdges(mesh), heights(mesh), 4.0);
  ASSERT_EQ(t.branches.size(), 4U);
  EXPECT_EQ(t.branches[3].below, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(Topology, DoesNotDependOnTheOrderOfTriangles) {
  const TriangleMesh mesh = test::forkMesh(30);
  TriangleMesh other = mesh;
  std::reverse(other.triangles.begin(), other.triangles.end());
  const FieldTopology a = fieldTopology(mesh, HalfEdges(mesh), heights(mesh), 1.0);
  FieldTopology b = fieldTopology(other, HalfEdges(other), heights(mesh), 1.0);
  std::reverse(b.branchOf.begin(), b.branchOf.end());
  EXPECT_EQ(a.branchOf, b.branchOf);
  EXPECT_EQ(kinds(a), kinds(b));
}

TEST(Topology, IslandsHolesAndBadTriangles) {
  TriangleMesh mesh = test::tubeMesh(10.0, 40.0, 16, 20);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const TriangleMesh box = test::boxMesh({50, 0, 10}, {60, 10, 20});
  mesh.vertices.insert(mesh.vertices.end(), box.vertices.begin(), box.vertices.end());
  for (const auto& t : box.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  mesh.triangles.push_back(mesh.triangles[3]);  // twice: non-manifold edges
  mesh.triangles.push_back({5, 5, 6});
  std::vector<double> field = heights(mesh);
  field[100] = std::numeric_limits<double>::quiet_NaN();
  const FieldTopology t = fieldTopology(mesh, HalfEdges(mesh), field, 0.5);
  EXPECT_EQ(t.branchOf.back(), HalfEdges::kNone);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& c = mesh.triangles[i];
    const bool outside =
        std::find(c.begin(), c.end(), 100U) != c.end() || i + 1 == mesh.triangles.size();
    EXPECT_EQ(t.branchOf[i] == HalfEdges::kNone, outside);
  }
  for (const FieldBranch& branch : t.branches) {
    EXPECT_LE(branch.from, branch.to);
  }
}

TEST(Topology, RefusesFieldsThatDoNotFit) {
  const TriangleMesh mesh = test::tubeMesh(10.0, 40.0, 16, 20);
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument,
                      [&] {
                        fieldTopology(mesh, HalfEdges(mesh), {1.0, 2.0}, 0.0);
                      }),
              ::testing::HasSubstr("one value per vertex"));
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument,
                      [&] { fieldTopology(mesh, HalfEdges(mesh), heights(mesh), -1.0); }),
              ::testing::HasSubstr("negative"));
}

}  // namespace
