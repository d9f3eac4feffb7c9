// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/io/import.hpp"

#include "io_files.hpp"
#include "mesh_boolean.hpp"
#include "random_source.hpp"
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gmock/gmock.h>
#include <gp_Pnt.hxx>
#include <gtest/gtest.h>

#include <cmath>

namespace wcam::io {
namespace {

using geometry::findOverlaps;
using geometry::HalfEdges;
using geometry::Overlaps;
using geometry::Pose;
using geometry::TriangleMesh;
using geometry::Vec3;
using test::boxMesh;
using test::TemporaryFolder;
using wcam::testing::RandomSource;
using wcam::testing::testSeeds;

TriangleMesh together(const std::vector<TriangleMesh>& meshes) {
  TriangleMesh all;
  for (const TriangleMesh& mesh : meshes) {
    test::append(all, mesh);
  }
  return all;
}

TriangleMesh turned(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) {
    std::swap(t[1], t[2]);
  }
  return mesh;
}

Overlaps overlapsOf(const TriangleMesh& mesh) {
  return findOverlaps(mesh, HalfEdges(mesh), 1e-6, JobContext());
}

TEST(Overlap, ApartTouchingAndOpenPiecesAreLeftAlone) {
  const TriangleMesh a = boxMesh(Vec3(0, 0, 0), Vec3(10, 10, 10));
  TriangleMesh open = boxMesh(Vec3(5, 5, 5), Vec3(30, 30, 30));
  open.triangles.pop_back();
  for (const TriangleMesh& other : {boxMesh(Vec3(11, 0, 0), Vec3(20, 10, 10)),  // apart
                                    boxMesh(Vec3(10, 0, 0), Vec3(20, 10, 10)),  // a face
                                    boxMesh(Vec3(10, 2, 3), Vec3(20, 30, 7)),   // a piece of a face
                                    boxMesh(Vec3(10, 10, 0), Vec3(20, 20, 10)),     // an edge
                                    boxMesh(Vec3(10, 10, 10), Vec3(20, 20, 20)),    // a corner
                                    turned(boxMesh(Vec3(2, 2, 2), Vec3(8, 8, 8))),  // a cavity
                                    open}) {
    const Overlaps overlaps = overlapsOf(together({a, other}));
    EXPECT_FALSE(overlaps.any());
    EXPECT_EQ(overlaps.volume, 0.0);
  }
}

TEST(Overlap, ABodyInACavityIsNoOverlap) {
  const Overlaps overlaps = overlapsOf(together({boxMesh(Vec3(0, 0, 0), Vec3(30, 30, 30)),
                                                 turned(boxMesh(Vec3(5, 5, 5), Vec3(25, 25, 25))),
                                                 boxMesh(Vec3(10, 10, 10), Vec3(20, 20, 20))}));
  EXPECT_FALSE(overlaps.any());
}

TEST(Overlap, CavitiesStayWhenBodiesAreUnited) {
  const TriangleMesh mesh = together({boxMesh(Vec3(0, 0, 0), Vec3(30, 30, 30)),
                                      turned(boxMesh(Vec3(5, 5, 5), Vec3(15, 15, 15))),
                                      boxMesh(Vec3(20, 10, 10), Vec3(40, 20, 20))});
  const Overlaps overlaps = overlapsOf(mesh);
  EXPECT_EQ(overlaps.crossing, 2U);
  EXPECT_NEAR(overlaps.volume, 1000.0, 1e-9);
  ASSERT_TRUE(overlaps.united);
  EXPECT_NEAR(test::signedVolume(*overlaps.united), 27000.0 - 1000.0 + 2000.0 - 1000.0, 1e-6);
}

/// Boxes with whole corners: the union is counted in unit cubes.
TEST(Overlap, UnionOfRandomBoxesIsThatOfTheirCubes) {
  for (const std::uint64_t seed : testSeeds(40)) {
    SCOPED_TRACE(seed);
    RandomSource random(seed);
    constexpr int kSide = 8;
    std::vector<std::array<int, 6>> boxes;
    std::vector<TriangleMesh> meshes;
    for (std::size_t n = 2 + random.below(5); n-- > 0;) {
      std::array<int, 6> box{};
      for (std::size_t k = 0; k < 3; ++k) {
        box[k] = static_cast<int>(random.below(kSide - 1));
        box[k + 3] = box[k] + 1 +
                     static_cast<int>(random.below(static_cast<std::size_t>(kSide - box[k] - 1)));
      }
      // Equal boxes share points only after welding; here they are apart.
      if (std::find(boxes.begin(), boxes.end(), box) != boxes.end()) {
        continue;
      }
      boxes.push_back(box);
      meshes.push_back(boxMesh(Vec3(box[0], box[1], box[2]), Vec3(box[3], box[4], box[5])));
    }
    double united = 0.0;
    double sum = 0.0;
    for (int cell = 0; cell < kSide * kSide * kSide; ++cell) {
      const std::array<int, 3> at{cell % kSide, cell / kSide % kSide, cell / kSide / kSide};
      int covers = 0;
      for (const auto& box : boxes) {
        bool in = true;
        for (std::size_t k = 0; k < 3; ++k) {
          in = in && at[k] >= box[k] && at[k] < box[k + 3];
        }
        covers += in ? 1 : 0;
      }
      united += covers > 0 ? 1.0 : 0.0;
      sum += covers;
    }
    const TriangleMesh mesh = together(meshes);
    const Overlaps overlaps = overlapsOf(mesh);
    // A body may be moved by the tolerance where the union would touch itself.
    const double allowed = 1e-4;
    EXPECT_NEAR(overlaps.volume, sum - united, allowed);
    EXPECT_EQ(overlaps.any(), sum > united);
    if (overlaps.united) {
      EXPECT_NEAR(test::signedVolume(*overlaps.united), united, allowed);
    } else {
      EXPECT_EQ(sum, united);
    }
  }
}

TEST(Overlap, CurvedBodies) {
  // Two tori through each other like links of a chain share nothing; moved, they do.
  TriangleMesh link = test::torusMesh(60, 30, 50, 10);
  TriangleMesh other = link;
  for (Vec3& p : other.vertices) {
    p = Vec3(p.x() + 50, p.z(), p.y());
  }
  other = turned(other);
  EXPECT_FALSE(overlapsOf(together({link, other})).any());
  for (Vec3& p : other.vertices) {
    p.x() -= 35.0;
  }
  const Overlaps overlaps = overlapsOf(together({link, other}));
  EXPECT_EQ(overlaps.crossing, 2U);
  ASSERT_TRUE(overlaps.united);
  EXPECT_GT(overlaps.volume, 100.0);
  EXPECT_NEAR(test::signedVolume(*overlaps.united),
              2.0 * test::signedVolume(link) - overlaps.volume, 1e-3);
}

TEST(Overlap, SubtractGivesTheRest) {
  const TriangleMesh a = boxMesh(Vec3(0, 0, 0), Vec3(10, 10, 10));
  const auto rest = geometry::subtract(a, boxMesh(Vec3(5, -1, -1), Vec3(20, 20, 20)));
  ASSERT_TRUE(rest);
  EXPECT_NEAR(test::signedVolume(*rest), 500.0, 1e-9);
  // Both may be turned inwards.
  const auto cavity = geometry::subtract(turned(a), turned(boxMesh(Vec3(2, 2, 2), Vec3(4, 4, 4))));
  ASSERT_TRUE(cavity);
  EXPECT_NEAR(test::signedVolume(*cavity), 992.0, 1e-9);
  TriangleMesh open = a;
  open.triangles.pop_back();
  EXPECT_FALSE(geometry::subtract(open, a));
  EXPECT_FALSE(geometry::subtract(a, open));
}

TEST(Overlap, WithoutRepairItIsOnlyTold) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "a.stl",
                   test::binaryStl(together({boxMesh(Vec3(0, 0, 0), Vec3(10, 10, 10)),
                                             boxMesh(Vec3(5, 5, 5), Vec3(20, 20, 20))})));
  ImportOptions options;
  options.repair = false;
  const JobContext context;
  const ImportedPart part = importPart(folder / "a.stl", options, Pose::Identity(), context);
  EXPECT_EQ(part.report.triangles, 24U);
  EXPECT_NEAR(part.report.volume.value_or(0.0), 1000.0 + 3375.0 - 125.0, 1e-6);
  EXPECT_EQ(context.diagnostics().count("import.overlapping_bodies"), 1U);
}

TEST(Overlap, ExactBodiesAreToldAndCountedOnce) {
  const TemporaryFolder folder;
  TopoDS_Compound both;
  const BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(40, 40, 20)).Shape());
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(20, 20, 0), gp_Pnt(60, 60, 20)).Shape());
  BRepTools::Write(both, (folder / "a.brep").c_str());
  const JobContext context;
  const ImportedPart part = importPart(folder / "a.brep", {}, Pose::Identity(), context);
  EXPECT_NEAR(part.report.volume.value_or(0.0), 56000.0, 1e-6);
  EXPECT_NEAR(part.report.overlap, 8000.0, 1e-6);
  EXPECT_TRUE(part.surface->exact());
  EXPECT_EQ(context.diagnostics().count("import.overlapping_bodies"), 1U);
}

}  // namespace
}  // namespace wcam::io
