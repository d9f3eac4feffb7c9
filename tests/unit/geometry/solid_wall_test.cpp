// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/solid_wall.hpp"

#include "wcam/base/error.hpp"
#include "wcam/io/import.hpp"

#include "field_meshes.hpp"
#include "random_source.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wcam::geometry {
namespace {

using test::revolvedMesh;

PartSurface partOf(TriangleMesh mesh) {
  PartSurface part;
  part.mesh = std::move(mesh);
  part.halfEdges = HalfEdges(part.mesh);
  part.hash = "mesh";
  return part;
}

/// A closed body of revolution from a closed profile (outer side upwards), the last point joined to
/// the first one.
TriangleMesh ringBody(std::vector<Vec2> profile, int around) {
  const auto rings = static_cast<std::uint32_t>(profile.size());
  profile.push_back(profile.front());
  TriangleMesh mesh = revolvedMesh(profile, around);
  const std::uint32_t first = rings * static_cast<std::uint32_t>(around);
  for (auto& t : mesh.triangles) {
    for (std::uint32_t& v : t) {
      v = v >= first ? v - first : v;
    }
  }
  mesh.vertices.resize(first);
  return mesh;
}

/// Points on the profile's straight line from a to b, without b.
void addLine(std::vector<Vec2>& profile, const Vec2& a, const Vec2& b, int count) {
  for (int i = 0; i < count; ++i) {
    profile.push_back(a + (b - a) * (static_cast<double>(i) / count));
  }
}

TriangleMesh tubeBody(double outer, double inner, double height, int rows, int around) {
  std::vector<Vec2> profile;
  addLine(profile, {outer, 0.0}, {outer, height}, rows);
  addLine(profile, {outer, height}, {inner, height}, 2);
  addLine(profile, {inner, height}, {inner, 0.0}, rows);
  addLine(profile, {inner, 0.0}, {outer, 0.0}, 2);
  return ringBody(profile, around);
}

TriangleMesh cupBody(int around) {
  std::vector<Vec2> profile;
  addLine(profile, {30.0, 0.0}, {30.0, 60.0}, 12);
  addLine(profile, {30.0, 60.0}, {25.0, 60.0}, 1);
  addLine(profile, {25.0, 60.0}, {25.0, 5.0}, 12);
  addLine(profile, {25.0, 5.0}, {0.0, 5.0}, 5);
  profile.emplace_back(0.0, 5.0);
  TriangleMesh mesh = revolvedMesh(profile, around);
  // The bottom from below: rings of its own, joined at the outer edge.
  const auto centre = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);
  const auto ring = centre + 1;
  for (int j = 0; j < around; ++j) {
    mesh.vertices.push_back(mesh.vertices[static_cast<std::size_t>(j)] * (24.0 / 30.0));
  }
  for (int j = 0; j < around; ++j) {
    const auto a = static_cast<std::uint32_t>(j);
    const auto b = static_cast<std::uint32_t>((j + 1) % around);
    mesh.triangles.push_back({ring + a, centre, ring + b});
    mesh.triangles.push_back({b, a, ring + a});
    mesh.triangles.push_back({b, ring + a, ring + b});
  }
  return mesh;
}

double radius(const Vec3& p) {
  return std::hypot(p.x(), p.y());
}

std::string reasonOf(const PartSurface& part) {
  try {
    (void)solidWall(part, WallSide::Middle);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::JobFailed);
    EXPECT_FALSE(error.hint().empty());
    return error.message();
  }
  return "no error";
}

TEST(SolidWall, SidesOfATubeAndTheSurfaceBetween) {
  constexpr int kAround = 180;
  const PartSurface part = partOf(tubeBody(20.0, 16.0, 50.0, 10, kAround));
  const SolidWall outer = solidWall(part, WallSide::Outer);
  const SolidWall inner = solidWall(part, WallSide::Inner);
  const SolidWall middle = solidWall(part, WallSide::Middle);
  for (const Vec3& p : outer.surface.mesh.vertices) {
    EXPECT_NEAR(radius(p), 20.0, 1e-12);
  }
  for (const Vec3& p : inner.surface.mesh.vertices) {
    EXPECT_NEAR(radius(p), 16.0, 1e-12);
  }
  // The feet of refined vertices lie on facets: their sagitta is what is left.
  const double sagitta = 20.0 * (1.0 - std::cos(kPi / kAround));
  for (const Vec3& p : middle.surface.mesh.vertices) {
    EXPECT_NEAR(radius(p), 18.0, 2.0 * sagitta);
  }
  for (const SolidWall* wall : {&outer, &inner, &middle}) {
    EXPECT_NEAR(wall->thickness.min, 4.0, 2.0 * sagitta);
    EXPECT_NEAR(wall->thickness.mean, 4.0, 2.0 * sagitta);
    EXPECT_NEAR(wall->thickness.max, 4.0, 2.0 * sagitta);
    ASSERT_EQ(wall->thickness.atVertex.size(), wall->surface.mesh.vertices.size());
    EXPECT_EQ(wall->surface.halfEdges.borderLoops(wall->surface.mesh).size(), 2U);
    EXPECT_NEAR(wall->surface.mesh.bounds().min.z(), 0.0, 1e-12);
    EXPECT_NEAR(wall->surface.mesh.bounds().max.z(), 50.0, 1e-12);
  }
  EXPECT_GT(middle.surface.mesh.normal(0).dot(
                middle.surface.mesh.vertices[middle.surface.mesh.triangles[0][0]]),
            0.0)
      << "the middle surface looks outwards";
  EXPECT_NE(outer.surface.hash, middle.surface.hash);
}

TEST(SolidWall, ThicknessOfATaperedTubeIsMeasured) {
  // 6 mm thick below, 2 mm above, measured across the slope of the inner side.
  std::vector<Vec2> profile;
  addLine(profile, {30.0, 0.0}, {30.0, 80.0}, 40);
  addLine(profile, {30.0, 80.0}, {28.0, 80.0}, 1);
  addLine(profile, {28.0, 80.0}, {24.0, 0.0}, 40);
  addLine(profile, {24.0, 0.0}, {30.0, 0.0}, 1);
  const SolidWall wall = solidWall(partOf(ringBody(profile, 256)), WallSide::Outer);
  const double slope = std::cos(std::atan2(4.0, 80.0));
  EXPECT_NEAR(wall.thickness.max, 6.0 * slope, 0.01);
  EXPECT_NEAR(wall.thickness.min, 2.0, 0.01);
  EXPECT_NEAR(wall.thickness.mean, 4.0 * slope, 0.02);
  EXPECT_NEAR(wall.thickness.thickest.z(), 0.0, 4.0);
  EXPECT_NEAR(wall.thickness.thinnest.z(), 80.0, 1e-9);
}

TEST(SolidWall, ACupKeepsItsBottom) {
  const PartSurface part = partOf(cupBody(96));
  const SolidWall outer = solidWall(part, WallSide::Outer);
  const SolidWall inner = solidWall(part, WallSide::Inner);
  const SolidWall middle = solidWall(part, WallSide::Middle);
  for (const SolidWall* wall : {&outer, &inner, &middle}) {
    EXPECT_EQ(wall->surface.halfEdges.borderLoops(wall->surface.mesh).size(), 1U) << "only the rim";
  }
  EXPECT_NEAR(outer.surface.mesh.bounds().min.z(), 0.0, 1e-12);
  EXPECT_NEAR(inner.surface.mesh.bounds().min.z(), 5.0, 1e-12);
  EXPECT_NEAR(middle.surface.mesh.bounds().min.z(), 2.5, 1e-9);
  EXPECT_NEAR(middle.thickness.min, 5.0, 0.05);
}

TEST(SolidWall, AStandingPlateTakesTheSideFartherAlongX) {
  TriangleMesh mesh = test::boxMesh({0.0, 0.0, 0.0}, {3.0, 60.0, 40.0});
  const SolidWall outer = solidWall(partOf(mesh), WallSide::Outer);
  EXPECT_NEAR(outer.surface.mesh.bounds().min.x(), 3.0, 1e-12);
  const SolidWall middle = solidWall(partOf(mesh), WallSide::Middle);
  for (const Vec3& p : middle.surface.mesh.vertices) {
    EXPECT_NEAR(p.x(), 1.5, 1e-12);
  }
  EXPECT_NEAR(middle.thickness.min, 3.0, 1e-12);
  EXPECT_NEAR(middle.thickness.max, 3.0, 1e-12);
}

TEST(SolidWall, CadPartsStayExact) {
  const auto part = io::importPart(std::string(WCAM_TEST_DATA) + "/step/cup.step", {},
                                   Pose::Identity(), JobContext())
                        .surface;
  const SolidWall outer = solidWall(*part, WallSide::Outer);
  EXPECT_TRUE(outer.surface.exact());
  const SolidWall middle = solidWall(*part, WallSide::Middle);
  EXPECT_FALSE(middle.surface.exact());
  // Of the cone: halfway along the normal of the outer side, up to the bottom's edge.
  const double slope = std::atan2(10.0, 80.0);
  const double across = 6.0 * std::cos(slope);
  std::size_t onCone = 0;
  for (std::size_t v = 0; v < middle.surface.mesh.vertices.size(); ++v) {
    const Vec3& p = middle.surface.mesh.vertices[v];
    if (p.z() > 12.0 && p.z() < 75.0) {
      ++onCone;
      const double wanted = 30.0 + p.z() / 8.0 - 0.5 * across / std::cos(slope);
      EXPECT_NEAR(radius(p), wanted, 1e-9);
      EXPECT_NEAR(middle.thickness.atVertex[v], across, 1e-9);
    }
  }
  EXPECT_GT(onCone, 100U);
  EXPECT_EQ(middle.surface.halfEdges.borderLoops(middle.surface.mesh).size(), 1U);
}

TEST(SolidWall, MovesAndScalesWithThePartInAnyOrderOfTriangles) {
  const TriangleMesh mesh = tubeBody(20.0, 16.0, 50.0, 10, 64);
  for (const std::uint64_t seed : testing::testSeeds(3)) {
    SCOPED_TRACE("WCAM_TEST_SEED=" + std::to_string(seed));
    testing::RandomSource random(seed);
    const SolidWall before = solidWall(partOf(mesh), WallSide::Middle);
    const double scale = random.real(0.1, 10.0);
    const Eigen::Quaterniond turn = Eigen::Quaterniond(random.real(-1, 1), random.real(-1, 1),
                                                       random.real(-1, 1), random.real(-1, 1))
                                        .normalized();
    const Vec3 shift(random.real(-100, 100), random.real(-100, 100), random.real(-100, 100));
    TriangleMesh moved = mesh;
    for (Vec3& p : moved.vertices) {
      p = scale * (turn * p) + shift;
    }
    std::reverse(moved.triangles.begin(), moved.triangles.end());
    const SolidWall after = solidWall(partOf(moved), WallSide::Middle);
    EXPECT_NEAR(after.thickness.mean, scale * before.thickness.mean, 1e-3 * scale);
    ASSERT_FALSE(after.surface.mesh.vertices.empty());
    for (const Vec3& p : after.surface.mesh.vertices) {
      EXPECT_NEAR(radius(turn.inverse() * (p - shift) / scale), 18.0, 0.06);
    }
  }
}

TEST(SolidWall, RefusesWhatIsNoWallWithTheReason) {
  EXPECT_THAT(reasonOf(partOf(test::tubeMesh(20.0, 50.0, 64, 10))),
              ::testing::HasSubstr("an open surface"));
  EXPECT_THAT(reasonOf(partOf(test::boxMesh({0, 0, 0}, {40, 40, 40}))),
              ::testing::HasSubstr("no solid wall"));
  EXPECT_THAT(reasonOf(partOf(test::torusMesh(50.0, 15.0, 48, 96))),
              ::testing::HasSubstr("no solid wall"));
  EXPECT_THAT(reasonOf(partOf(test::gridMesh(40.0, 40.0, 4, 4))),
              ::testing::HasSubstr("nowhere do two sides"));
  EXPECT_THAT(reasonOf(partOf({})), ::testing::HasSubstr("no triangles"));
}

}  // namespace
}  // namespace wcam::geometry
