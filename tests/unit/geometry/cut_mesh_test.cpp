// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/cut_mesh.hpp"

#include "wcam/geometry/part_ends.hpp"
#include "wcam/geometry/skeleton.hpp"
#include "wcam/io/import.hpp"

#include "../../support/error_matchers.hpp"
#include "../../support/field_meshes.hpp"
#include "../../support/implicit_mesh.hpp"
#include "../../support/random_source.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace wcam;
using namespace wcam::geometry;
using wcam::testing::errorOf;

PartSurface surfaceOf(TriangleMesh mesh) {
  PartSurface surface;
  surface.mesh = std::move(mesh);
  surface.halfEdges = HalfEdges(surface.mesh);
  surface.hash = "test";
  return surface;
}

std::vector<double> heights(const TriangleMesh& mesh) {
  std::vector<double> field;
  for (const Vec3& p : mesh.vertices) {
    field.push_back(p.z());
  }
  return field;
}

double areaOf(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    area += 0.5 *
            (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  }
  return area;
}

void expectNoTriangleAcross(const CutSurface& cut, double level) {
  for (const auto& t : cut.surface.mesh.triangles) {
    bool below = false;
    bool above = false;
    for (const std::uint32_t v : t) {
      below = below || cut.field[v] < level;
      above = above || cut.field[v] > level;
    }
    EXPECT_FALSE(below && above) << level;
  }
}

TEST(CutMesh, SplitsTrianglesAtLevels) {
  for (const std::uint64_t seed : wcam::testing::testSeeds(5)) {
    wcam::testing::RandomSource random(seed);
    TriangleMesh mesh = test::torusMesh(30.0, 10.0, 16, 32);
    std::vector<double> field;
    for (const Vec3& p : mesh.vertices) {
      field.push_back(p.x() + random.real(-3.0, 3.0));
    }
    const PartSurface part = surfaceOf(mesh);
    // A level through a vertex, and two close ones.
    const std::vector<double> levels{-20.0, field[100] < 5.0 ? 5.0 : field[100], 30.0, 30.1};
    const CutSurface cut = cutAtLevels(part, field, levels);
    EXPECT_TRUE(cut.surface.halfEdges.closed()) << seed;
    EXPECT_TRUE(cut.surface.halfEdges.nonManifoldEdges().empty()) << seed;
    EXPECT_NEAR(areaOf(cut.surface.mesh), areaOf(mesh), 1e-9 * areaOf(mesh));
    EXPECT_EQ(cut.field.size(), cut.surface.mesh.vertices.size());
    for (const double level : levels) {
      expectNoTriangleAcross(cut, level);
    }
  }
}

TEST(CutMesh, LevelsThroughVerticesCutNothing) {
  const PartSurface part = surfaceOf(test::tubeMesh(10.0, 40.0, 16, 20));
  const CutSurface cut = cutAtLevels(part, heights(part.mesh), {0.0, 10.0, 20.0, 40.0, 100.0});
  EXPECT_EQ(cut.surface.mesh.triangles, part.mesh.triangles);
}

TEST(CutMesh, NewVerticesLieOnTheExactSurface) {
  const auto part = io::importPart(std::string(WCAM_RESOURCES) + "/projects/elbow/elbow.step",
                                   io::ImportOptions{}, Pose::Identity(), JobContext())
                        .surface;
  std::vector<double> field;
  for (const Vec3& p : part->mesh.vertices) {
    field.push_back(p.dot(Vec3(0.3, 0.2, 1.0)));
  }
  const auto [low, high] = std::minmax_element(field.begin(), field.end());
  std::vector<double> levels;
  for (int i = 1; i < 8; ++i) {
    levels.push_back(*low + (*high - *low) * i / 8.3);
  }
  const CutSurface cut = cutAtLevels(*part, field, levels);
  const PartSurface& s = cut.surface;
  ASSERT_TRUE(s.exact());
  EXPECT_GT(s.mesh.triangles.size(), part->mesh.triangles.size());
  EXPECT_EQ(s.halfEdges.borderEdgeCount() > 0, part->halfEdges.borderEdgeCount() > 0);
  EXPECT_TRUE(s.halfEdges.nonManifoldEdges().empty());
  BrepEvaluator evaluator(*s.brep);
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3& p = s.mesh.vertices[s.mesh.triangles[t][c]];
      EXPECT_LT((evaluator.surface(s.binding.face[t], s.binding.uv[t][c]).p - p).norm(), 1e-6);
      const std::int32_t edge = s.binding.edge[3 * t + c];
      if (edge >= 0) {
        EXPECT_LT((evaluator.curve(edge, s.binding.edgeParam[3 * t + c][0]).p - p).norm(), 1e-6);
        const Vec3& q = s.mesh.vertices[s.mesh.triangles[t][(c + 1) % 3]];
        EXPECT_LT((evaluator.curve(edge, s.binding.edgeParam[3 * t + c][1]).p - q).norm(), 1e-6);
      }
    }
  }
}

TEST(FieldPieces, ForkGivesThreeSingleBranches) {  // Diourté A41
  for (const bool down : {false, true}) {
    const PartSurface part = surfaceOf(test::forkMesh(36, down));
    const std::vector<FieldPiece> pieces = splitAtSaddles(part, heights(part.mesh), 1.0);
    ASSERT_EQ(pieces.size(), 3U);
    double area = 0.0;
    for (const FieldPiece& piece : pieces) {
      area += areaOf(piece.surface.mesh);
      EXPECT_TRUE(
          skeletonOf(piece.surface.mesh, piece.surface.halfEdges, Vec3::UnitZ()).singleBranch());
    }
    EXPECT_NEAR(area, areaOf(part.mesh), 1e-6 * area);
    if (down) {
      EXPECT_EQ(pieces[2].below, (std::vector<std::size_t>{0, 1}));
      EXPECT_EQ(pieces[0].above, (std::vector<std::size_t>{2}));
      EXPECT_NEAR(pieces[0].to, pieces[2].from, 1e-9);
    } else {
      EXPECT_EQ(pieces[0].above, (std::vector<std::size_t>{1, 2}));
      EXPECT_EQ(pieces[1].below, (std::vector<std::size_t>{0}));
    }
  }
}

TEST(FieldPieces, TubeStaysWhole) {
  const PartSurface part = surfaceOf(test::tubeMesh(10.0, 40.0, 16, 20));
  const std::vector<FieldPiece> pieces = splitAtSaddles(part, heights(part.mesh), 0.0);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].surface.mesh.triangles.size(), part.mesh.triangles.size());
}

TEST(FieldPieces, UprightTorusHasFourPieces) {
  TriangleMesh mesh = test::torusMesh(30.0, 10.0, 24, 64);
  for (Vec3& p : mesh.vertices) {
    p = Vec3(p.x(), p.z(), p.y());
  }
  const PartSurface part = surfaceOf(mesh);
  const std::vector<FieldPiece> pieces = splitAtSaddles(part, heights(mesh), 1.0);
  ASSERT_EQ(pieces.size(), 4U);
  EXPECT_EQ(pieces[3].below, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(pieces[0].above, (std::vector<std::size_t>{1, 2}));
  double area = 0.0;
  for (const FieldPiece& piece : pieces) {
    area += areaOf(piece.surface.mesh);
  }
  EXPECT_NEAR(area, areaOf(mesh), 1e-6 * area);
}

TEST(FieldPieces, NoiseMakesNoPieces) {
  for (const std::uint64_t seed : wcam::testing::testSeeds(5)) {
    wcam::testing::RandomSource random(seed);
    const PartSurface part = surfaceOf(test::forkMesh(36));
    std::vector<double> field = heights(part.mesh);
    for (double& value : field) {
      value += random.real(-1.0, 1.0);
    }
    EXPECT_EQ(splitAtSaddles(part, field, 4.0).size(), 3U) << seed;
  }
}

TEST(FieldPieces, RefusesFieldsThatDoNotFit) {
  const PartSurface part = surfaceOf(test::tubeMesh(10.0, 40.0, 16, 20));
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { cutAtLevels(part, {1.0}, {0.0}); }),
              ::testing::HasSubstr("one value per vertex"));
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { splitAtSaddles(part, {1.0}, 0.0); }),
              ::testing::HasSubstr("one value per vertex"));
}

}  // namespace
