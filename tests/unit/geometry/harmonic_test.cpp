// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/harmonic.hpp"

#include "../../support/error_matchers.hpp"
#include "../../support/field_meshes.hpp"
#include "../../support/random_source.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace {

using namespace wcam;
using namespace wcam::geometry;
using wcam::testing::errorOf;

std::vector<double> between(const TriangleMesh& mesh,
                            const std::vector<Conductivity>& conductivity = {}) {
  return harmonicField(mesh, HalfEdges(mesh),
                       {{test::borderAt(mesh, true), 0.0}, {test::borderAt(mesh, false), 1.0}},
                       conductivity);
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

TEST(Harmonic, ElbowFollowsTheBend) {  // Diourté A8
  const int around = 36;
  const int rows = 40;
  const TriangleMesh mesh = test::elbowMesh(19.0, 241.2, 13.0 / 19.0, around, rows);
  const std::vector<double> u = between(mesh);
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j < around; ++j) {
      EXPECT_NEAR(u[static_cast<std::size_t>(i * around + j)], static_cast<double>(i) / rows,
                  1e-10);
    }
  }
}

TEST(Harmonic, CylinderIsLinearInHeight) {  // Diourté A16
  wcam::testing::RandomSource random(7);
  TriangleMesh mesh = test::tubeMesh(20.0, 60.0, 24, 30);
  // Vertices moved up and down along their generatrix: any triangulation holds a linear field.
  for (Vec3& p : mesh.vertices) {
    if (p.z() > 0.0 && p.z() < 60.0) {
      p.z() += random.real(-0.8, 0.8);
    }
  }
  const std::vector<double> u = between(mesh);
  for (std::size_t v = 0; v < u.size(); ++v) {
    EXPECT_NEAR(u[v], mesh.vertices[v].z() / 60.0, 1e-10) << "seed " << random.seed();
  }
}

TriangleMesh bumpyVase(std::uint64_t seed) {
  wcam::testing::RandomSource random(seed);
  std::vector<Vec2> profile;
  for (int i = 0; i <= 24; ++i) {
    profile.emplace_back(15.0 + 6.0 * std::sin(0.35 * i) + random.real(0.0, 1.0), 2.5 * i);
  }
  return test::revolvedMesh(profile, 30);
}

TEST(Harmonic, StaysBetweenTheFixedValues) {  // Diourté A16
  for (const std::uint64_t seed : wcam::testing::testSeeds(5)) {
    const TriangleMesh mesh = bumpyVase(seed);
    const std::vector<double> u = between(mesh);
    for (std::size_t v = 0; v < u.size(); ++v) {
      EXPECT_GE(u[v], 0.0) << "seed " << seed;
      EXPECT_LE(u[v], 1.0) << "seed " << seed;
    }
  }
}

TEST(Harmonic, MovesAndScalesWithThePart) {
  const TriangleMesh mesh = bumpyVase(3);
  const std::vector<FixedValues> fixed{{test::borderAt(mesh, true), 0.0},
                                       {test::borderAt(mesh, false), 1.0}};
  const std::vector<double> u = harmonicField(mesh, HalfEdges(mesh), fixed);
  Pose pose = Pose::Identity();
  pose.rotate(Eigen::AngleAxisd(1.1, Vec3(1.0, 2.0, -0.5).normalized()));
  pose.pretranslate(Vec3(100.0, -40.0, 7.0));
  for (const double scale : {1e-3, 1.0, 1e3}) {
    TriangleMesh moved = mesh;
    for (Vec3& p : moved.vertices) {
      p = pose * (scale * p);
    }
    EXPECT_LT(largestDifference(u, harmonicField(moved, HalfEdges(moved), fixed)), 1e-10) << scale;
  }
}

TEST(Harmonic, DoesNotDependOnTheOrderOfTriangles) {
  const TriangleMesh mesh = bumpyVase(4);
  const std::vector<FixedValues> fixed{{test::borderAt(mesh, true), 0.0},
                                       {test::borderAt(mesh, false), 1.0}};
  TriangleMesh other = mesh;
  std::reverse(other.triangles.begin(), other.triangles.end());
  for (auto& t : other.triangles) {
    std::rotate(t.begin(), t.begin() + 1, t.end());
  }
  EXPECT_LT(largestDifference(harmonicField(mesh, HalfEdges(mesh), fixed),
                              harmonicField(other, HalfEdges(other), fixed)),
            1e-12);
  EXPECT_EQ(harmonicField(mesh, HalfEdges(mesh), fixed),
            harmonicField(mesh, HalfEdges(mesh), fixed));
}

TEST(Harmonic, WeightsDivideTheDrop) {
  const TriangleMesh mesh = test::tubeMesh(10.0, 40.0, 16, 20);
  std::vector<Conductivity> conductivity(mesh.triangles.size());
  for (std::size_t t = mesh.triangles.size() / 2; t < mesh.triangles.size(); ++t) {
    conductivity[t].weight = 3.0;  // the upper half conducts three times as well
  }
  const std::vector<double> u = between(mesh, conductivity);
  for (std::size_t v = 0; v < u.size(); ++v) {
    const double z = mesh.vertices[v].z();
    EXPECT_NEAR(u[v], z <= 20.0 ? 0.75 * z / 20.0 : 0.75 + 0.25 * (z - 20.0) / 20.0, 1e-10);
  }
}

TEST(Harmonic, AnisotropyStretchesThePart) {
  // Conduction 4 along y equals an isotropic plate of half the depth.
  const TriangleMesh mesh = test::gridMesh(30.0, 50.0, 24, 32);
  TriangleMesh squeezed = mesh;
  for (Vec3& p : squeezed.vertices) {
    p.y() *= 0.5;
  }
  std::vector<FixedValues> fixed(3);
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vec3& p = mesh.vertices[v];
    if (p.y() == 0.0) {
      fixed.push_back({{v}, std::sin(kPi * p.x() / 30.0)});
    } else if (p.x() == 0.0 || p.x() == 30.0) {
      fixed[0].vertices.push_back(v);
    }
  }
  Conductivity along;
  along.direction = Vec3(0.0, 2.0, 0.0);
  along.along = 4.0;
  const std::vector<double> u = harmonicField(
      mesh, HalfEdges(mesh), fixed, std::vector<Conductivity>(mesh.triangles.size(), along));
  EXPECT_LT(largestDifference(u, harmonicField(squeezed, HalfEdges(squeezed), fixed)), 1e-10);
  // Separation of variables: u falls as cosh(c·(50 − y))/cosh(50·c) with c = π/30/√4.
  const double c = kPi / 60.0;
  for (std::size_t v = 0; v < u.size(); ++v) {
    const Vec3& p = mesh.vertices[v];
    const double exact =
        std::sin(kPi * p.x() / 30.0) * std::cosh(c * (50.0 - p.y())) / std::cosh(50.0 * c);
    EXPECT_NEAR(u[v], exact, 2e-3);
  }
}

TEST(Harmonic, IslandsWithoutBorderValuesHaveNoValue) {
  TriangleMesh mesh = test::tubeMesh(10.0, 20.0, 12, 6);
  const std::size_t first = mesh.vertices.size();
  const std::vector<FixedValues> fixed{{test::borderAt(mesh, true), 2.0},
                                       {test::borderAt(mesh, false), 5.0}};
  TriangleMesh island = test::boxMesh({50, 0, 0}, {60, 10, 10});
  for (auto t : island.triangles) {
    for (std::uint32_t& v : t) {
      v += static_cast<std::uint32_t>(first);
    }
    mesh.triangles.push_back(t);
  }
  mesh.vertices.insert(mesh.vertices.end(), island.vertices.begin(), island.vertices.end());
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);  // belongs to no triangle
  const std::vector<double> u = harmonicField(mesh, HalfEdges(mesh), fixed);
  for (std::size_t v = 0; v < u.size(); ++v) {
    if (v < first) {
      EXPECT_NEAR(u[v], 2.0 + 3.0 * mesh.vertices[v].z() / 20.0, 1e-10);
    } else {
      EXPECT_TRUE(std::isnan(u[v]));
    }
  }
}

TEST(Harmonic, OneBorderAloneGivesItsValueEverywhere) {
  const TriangleMesh mesh = test::tubeMesh(10.0, 20.0, 12, 6);
  for (const double u : harmonicField(mesh, HalfEdges(mesh), {{test::borderAt(mesh, true), 2.0}})) {
    EXPECT_NEAR(u, 2.0, 1e-12);
  }
}

TEST(Harmonic, DegenerateTrianglesDoNoHarm) {
  // Slivers down to nothing: rows of triangles squeezed towards a plane, corners that coincide.
  for (const double gap : {1e-3, 1e-6, 1e-9, 0.0}) {
    TriangleMesh mesh = test::tubeMesh(20.0, 60.0, 24, 30);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      const std::size_t row = v / 24;
      if (row == 11) {
        mesh.vertices[v].z() = 20.0 + gap;
      }
    }
    mesh.triangles.push_back({24, 24, 25});
    mesh.triangles.push_back({30, 30, 30});
    const std::vector<double> u =
        harmonicField(mesh, HalfEdges(mesh),
                      {{test::borderAt(test::tubeMesh(20.0, 60.0, 24, 30), true), 0.0},
                       {test::borderAt(test::tubeMesh(20.0, 60.0, 24, 30), false), 1.0}});
    for (std::size_t v = 0; v < u.size(); ++v) {
      // A flat triangle counts as 1e-7 of its length high.
      EXPECT_NEAR(u[v], mesh.vertices[v].z() / 60.0, 1e-7) << "gap " << gap;
    }
  }
}

TEST(Harmonic, RefusesWhatHasNoMeaning) {
  const TriangleMesh mesh = test::tubeMesh(10.0, 20.0, 12, 6);
  const HalfEdges halfEdges(mesh);
  const auto message = [&](const std::vector<FixedValues>& fixed,
                           const std::vector<Conductivity>& conductivity = {}) {
    return errorOf(ErrorCode::InvalidArgument,
                   [&] { harmonicField(mesh, halfEdges, fixed, conductivity); });
  };
  EXPECT_THAT(message({}), ::testing::HasSubstr("no vertex has a fixed value"));
  EXPECT_THAT(message({{{}, 1.0}}), ::testing::HasSubstr("choose at least one border"));
  EXPECT_THAT(message({{{5000}, 1.0}}), ::testing::HasSubstr("no vertex 5000"));
  EXPECT_THAT(message({{{1}, 0.0}, {{1}, 1.0}}), ::testing::HasSubstr("share the point"));
  EXPECT_THAT(message({{{1}, std::nan("")}}), ::testing::HasSubstr("not a number"));
  EXPECT_THAT(message({{{1}, 1.0}}, std::vector<Conductivity>(3)),
              ::testing::HasSubstr("3 of 144 triangles"));
  std::vector<Conductivity> zero(mesh.triangles.size());
  zero[7].weight = 0.0;
  EXPECT_THAT(message({{{1}, 1.0}}, zero), ::testing::HasSubstr("triangle 7"));
  EXPECT_NO_THROW(harmonicField(mesh, halfEdges, {{{1}, 1.0}, {{1, 2}, 1.0}}));
}

TEST(Harmonic, CancelIsHeard) {
  const TriangleMesh mesh = test::tubeMesh(10.0, 20.0, 12, 6);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(harmonicField(mesh, HalfEdges(mesh), {{{1}, 1.0}}, {}, JobContext(stop.get_token())),
               CancelledError);
}

}  // namespace
