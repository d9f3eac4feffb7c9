// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/skeleton.hpp"

#include "wcam/geometry/part_ends.hpp"

#include "../../support/error_matchers.hpp"
#include "../../support/field_meshes.hpp"
#include "../../support/implicit_mesh.hpp"
#include "../../support/random_source.hpp"

#include <cmath>

namespace {

using namespace wcam;
using namespace wcam::geometry;
using wcam::testing::errorOf;

TriangleMesh dome(double R, int around, int rows) {
  std::vector<Vec2> profile;
  for (int i = 0; i <= rows; ++i) {
    const double a = 0.5 * kPi * i / rows;
    profile.emplace_back(i == rows ? 0.0 : R * std::cos(a), R * std::sin(a));
  }
  return test::revolvedMesh(profile, around);
}

Skeleton skeleton(const TriangleMesh& mesh) {
  return skeletonOf(mesh, HalfEdges(mesh), Vec3::UnitZ());
}

PartSurface surfaceOf(TriangleMesh mesh) {
  PartSurface surface;
  surface.mesh = std::move(mesh);
  surface.halfEdges = HalfEdges(surface.mesh);
  return surface;
}

TEST(PartEnds, SortsBorders) {
  const TriangleMesh fork = test::forkMesh(30, true);
  const PartEnds legs = partEnds(fork, HalfEdges(fork), Vec3::UnitZ());
  EXPECT_EQ(legs.lower.size(), 2U);
  EXPECT_EQ(legs.upper.size(), 1U);
  TriangleMesh tube = test::tubeMesh(20.0, 60.0, 48, 60);
  tube.triangles.erase(tube.triangles.begin() + 2800);
  const PartEnds ends = partEnds(tube, HalfEdges(tube), Vec3::UnitZ());
  EXPECT_EQ(ends.lower.size(), 1U);
  EXPECT_EQ(ends.upper.size(), 1U);
  EXPECT_EQ(ends.holes.size(), 1U);
  const PartEnds turned = partEnds(tube, HalfEdges(tube), -Vec3::UnitZ());
  EXPECT_EQ(turned.lower, ends.upper);
}

TEST(Skeleton, SingleBranchTest) {  // Diourté A2
  EXPECT_TRUE(skeleton(test::tubeMesh(20.0, 60.0, 24, 30)).singleBranch());
  EXPECT_TRUE(skeleton(dome(50.0, 30, 10)).singleBranch());
  EXPECT_TRUE(skeleton(test::elbowMesh(10.0, 60.0, 0.5 * kPi, 24, 40)).singleBranch());
  EXPECT_TRUE(skeleton(test::boxMesh({0, 0, 0}, {10, 10, 40})).singleBranch());
  for (const bool down : {false, true}) {
    const Skeleton fork = skeleton(test::forkMesh(30, down));
    EXPECT_FALSE(fork.singleBranch());
    EXPECT_EQ(std::count(fork.degree.begin(), fork.degree.end(), 1U), 3);
    EXPECT_EQ(std::count(fork.degree.begin(), fork.degree.end(), 3U), 1);
  }
}

TEST(Skeleton, LinesRunInsideTheFork) {
  // Arms lean by atan(30/60) from (0,0,40) and part at about z = 66; below, the line runs between
  // them.
  const Skeleton fork = skeleton(test::forkMesh(60));
  for (const Vec3& p : fork.nodes) {
    const double toArm = std::min(test::segmentDistance(p, {0, 0, 40}, {30, 0, 100}),
                                  test::segmentDistance(p, {0, 0, 40}, {-30, 0, 100}));
    EXPECT_LT(std::min(toArm, test::segmentDistance(p, {0, 0, -10}, {0, 0, 66})), 1.5)
        << p.transpose();
  }
}

TEST(Skeleton, TorusHasACycle) {
  TriangleMesh mesh = test::torusMesh(30.0, 10.0, 24, 64);
  for (Vec3& p : mesh.vertices) {
    p = Vec3(p.x(), p.z(), p.y());
  }
  const Skeleton torus = skeleton(mesh);
  EXPECT_FALSE(torus.singleBranch());
  EXPECT_EQ(torus.edges.size(), torus.nodes.size());  // a tree has one edge less than nodes
}

TEST(Skeleton, NoiseMakesNoFork) {
  for (const std::uint64_t seed : wcam::testing::testSeeds(5)) {
    wcam::testing::RandomSource random(seed);
    TriangleMesh mesh = dome(50.0, 60, 30);
    for (Vec3& p : mesh.vertices) {
      p += Vec3(random.real(-0.5, 0.5), random.real(-0.5, 0.5), random.real(-0.5, 0.5));
    }
    EXPECT_TRUE(skeleton(mesh).singleBranch()) << seed;
  }
}

TEST(AutomaticGuide, QuarterTorus) {
  const double R = 60.0;
  const TriangleMesh mesh = test::elbowMesh(10.0, R, 0.5 * kPi, 36, 60);
  const auto guide = automaticGuide(surfaceOf(mesh), Vec3::UnitZ());
  // The elbow starts at the origin and turns about (−R, 0, 0).
  const double length = arcLength(*guide, guide->begin(), guide->end());
  // Between the rings of the mesh centres lie on chords, up to 1.57²/(8·60) mm inside the circle.
  const double sagitta = 0.006;
  EXPECT_NEAR(length, 0.5 * kPi * R, 0.01);
  for (int i = 0; i <= 200; ++i) {
    const double t = guide->begin() + (guide->end() - guide->begin()) * i / 200;
    const Vec3 p = guide->evaluate(t).p;
    EXPECT_NEAR(std::hypot(p.x() + R, p.z()), R, sagitta);
    EXPECT_NEAR(p.y(), 0.0, 1e-9);
  }
  EXPECT_NEAR(guide->evaluate(guide->begin()).p.z(), 0.0, 1e-12);
  EXPECT_NEAR(guide->evaluate(guide->end()).p.x(), -R, 1e-9);
}

TEST(AutomaticGuide, DomeEndsAtItsTop) {
  const auto guide = automaticGuide(surfaceOf(dome(50.0, 40, 20)), Vec3::UnitZ());
  EXPECT_LT(guide->evaluate(guide->begin()).p.norm(), 1e-9);
  EXPECT_LT((guide->evaluate(guide->end()).p - Vec3(0, 0, 50)).norm(), 1e-9);
  EXPECT_NEAR(arcLength(*guide, guide->begin(), guide->end()), 50.0, 0.5);
}

TEST(AutomaticGuide, RefusesWhatHasNoAxis) {
  EXPECT_THAT(errorOf(ErrorCode::JobFailed,
                      [] { automaticGuide(surfaceOf(test::forkMesh(30)), Vec3::UnitZ()); }),
              ::testing::HasSubstr("branches"));
  EXPECT_THAT(
      errorOf(ErrorCode::JobFailed,
              [] {
                automaticGuide(surfaceOf(test::boxMesh({0, 0, 0}, {10, 10, 40})), Vec3::UnitZ());
              }),
      ::testing::HasSubstr("no lower border"));
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument,
                      [] { automaticGuide(surfaceOf(TriangleMesh{}), Vec3::UnitZ()); }),
              ::testing::HasSubstr("no triangles"));
}

}  // namespace
