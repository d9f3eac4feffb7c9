// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "viewport/beads.hpp"

#include "sample_path.hpp"
#include "viewport/frame_budget.hpp"
#include "viewport/scene.hpp"
#include <gtest/gtest.h>

#include <algorithm>

namespace wcam::viewport {
namespace {

using gui::test::samplePath;

TEST(Beads, ChunksCoverAllMovesAndEndWithEachLayer) {
  const auto path = samplePath(3, 5000);
  const auto chunks = chunksOf(*path->data());
  ASSERT_EQ(chunks.size(), 6U);
  std::size_t next = 0;
  for (const ChunkRange& chunk : chunks) {
    EXPECT_EQ(chunk.begin, next);
    EXPECT_LE(chunk.end - chunk.begin, kChunkMoves);
    EXPECT_EQ(path->data()->layers[chunk.begin], path->data()->layers[chunk.end - 1]);
    next = chunk.end;
  }
  EXPECT_EQ(next, path->size());
  EXPECT_TRUE(chunksOf(PathData()).empty());
}

TEST(Beads, ASolidHasTheHeightAndWidthOfTheBeadAndHangsBelowThePath) {
  const auto path = samplePath(1, 4);  // y across, z up; 1 mm high, 6 mm wide, at z = 0
  const BeadSolid solid = beadSolid(*path->data(), chunksOf(*path->data()).front());
  float lowZ = 1e9F;
  float highZ = -1e9F;
  float lowY = 1e9F;
  float highY = -1e9F;
  for (std::size_t i = 0; i < solid.positions.size(); i += 3) {
    lowY = std::min(lowY, solid.positions[i + 1]);
    highY = std::max(highY, solid.positions[i + 1]);
    lowZ = std::min(lowZ, solid.positions[i + 2]);
    highZ = std::max(highZ, solid.positions[i + 2]);
  }
  EXPECT_FLOAT_EQ(highZ, 0.0F);
  EXPECT_FLOAT_EQ(lowZ, -1.0F);
  EXPECT_FLOAT_EQ(highY, 3.0F);
  EXPECT_FLOAT_EQ(lowY, -3.0F);
  // Three moves of eight sides and two ends.
  EXPECT_EQ(solid.offsets.size(), 3U * kSectionCorners + 2U + 1U);
  EXPECT_EQ(solid.polygonsUpTo.front(), 0U);
  EXPECT_EQ(solid.polygonsUpTo.back(), 3U * kSectionCorners + 2U);
}

TEST(Beads, SolidsOfChunksJoinAndTheirPolygonsNameExistingVertices) {
  const auto path = samplePath(1, 9000);
  std::size_t polygons = 0;
  for (const ChunkRange& chunk : chunksOf(*path->data())) {
    const BeadSolid solid = beadSolid(*path->data(), chunk);
    for (const long long corner : solid.corners) {
      ASSERT_LT(corner, static_cast<long long>(solid.moveOfVertex.size()));
    }
    polygons += solid.offsets.size() - 1;
  }
  EXPECT_EQ(polygons, 8999U * kSectionCorners + 2U);
}

TEST(Beads, LinesAreTheDepositingMovesAndTravelTheOthers) {
  const auto path = samplePath(2, 6);
  std::size_t beads = 0;
  std::size_t travel = 0;
  for (const ChunkRange& chunk : chunksOf(*path->data())) {
    beads += beadLines(*path->data(), chunk, false).offsets.size() - 1;
    travel += beadLines(*path->data(), chunk, true).offsets.size() - 1;
  }
  EXPECT_EQ(beads, 10U);
  EXPECT_EQ(travel, 1U);
}

TEST(Scene, ATickOfTheRangeTouchesOnlyTheChunksThatChange) {
  Scene scene;
  const auto path = samplePath(50, 200);
  scene.setPath(path->prepared());
  scene.setPathColours(std::vector<std::uint8_t>(3 * path->size(), 90));
  const std::size_t before = scene.uploads();
  for (std::size_t i = 0; i < 150; ++i) {
    scene.setRange(0, 20 * 200 + i + 1);
  }
  EXPECT_LE(scene.uploads() - before, 151U);
  EXPECT_FALSE(scene.drawsLines());
}

TEST(Scene, ManyMovesAreDrawnAsLines) {
  Scene scene;
  const auto path = samplePath(60, 4000);
  scene.setPath(path->prepared());
  EXPECT_TRUE(scene.drawsLines());
  // While it is scrubbed a part of the points stands for all, ends of beads among them.
  EXPECT_LT(scene.triangles(Scene::Detail::Coarse), 0.3 * scene.triangles(Scene::Detail::Fine));
  const PathData& data = *path->data();
  const ChunkRange chunk = chunksOf(data).front();
  const BeadLines few = beadLines(data, chunk, false, 4);
  ASSERT_EQ(few.linesUpTo.size(), chunk.end - chunk.begin);
  EXPECT_EQ(few.linesUpTo.back() + 1, few.offsets.size());
  EXPECT_EQ(few.moveOfVertex.front(), 1U);
  EXPECT_EQ(few.moveOfVertex.back(), chunk.end - 1);
}

TEST(Scene, NoPortionOfAPictureHasMoreThanAFrameHolds) {
  Scene scene;
  const auto path = samplePath(40, 800);
  scene.setPath(path->prepared());
  MeshData mesh;  // a sheet of 80 000 triangles
  constexpr std::uint32_t kSide = 200;
  for (std::uint32_t i = 0; i <= kSide; ++i) {
    for (std::uint32_t k = 0; k <= kSide; ++k) {
      mesh.positions.insert(mesh.positions.end(),
                            {static_cast<float>(i), static_cast<float>(k), 0.0F});
      if (i < kSide && k < kSide) {
        const std::uint32_t at = i * (kSide + 1) + k;
        mesh.triangles.insert(mesh.triangles.end(),
                              {at, at + 1, at + kSide + 2, at, at + kSide + 2, at + kSide + 1});
      }
    }
  }
  scene.setParts({prepare(mesh)});
  constexpr double kCapacity = 20000.0;
  for (const PartStyle style : {PartStyle::Solid, PartStyle::Translucent}) {
    scene.setPartStyle(style);
    scene.chooseAll(Scene::Detail::Fine);  // everything was drawn once
    const double all = scene.triangles(Scene::Detail::Fine);
    EXPECT_NEAR(all, 80000 + 16 * 40 * 799, 1000);
    EXPECT_LT(scene.triangles(Scene::Detail::Coarse), 0.1 * all);
    scene.beginPortions(kCapacity);
    double sum = 0.0;
    int portions = 0;
    while (!scene.portionsComplete()) {
      const double triangles = scene.choosePortion(kCapacity);
      EXPECT_LE(triangles, kCapacity);
      sum += triangles;
      ASSERT_LT(++portions, 100);
    }
    EXPECT_GT(portions, 20);
    if (style == PartStyle::Solid) {
      EXPECT_DOUBLE_EQ(sum, all) << "all of it is drawn, and nothing twice";
    } else {
      EXPECT_LT(sum, all - 60000) << "a translucent part is mixed in one go, so it is coarse";
    }
  }
}

TEST(Scene, WhatIsDrawnFirstCountsMore) {
  Scene scene;
  scene.setPath(samplePath(2, 50)->prepared());
  const double before = scene.triangles(Scene::Detail::Fine);
  EXPECT_GT(before, scene.chooseAll(Scene::Detail::Fine) * 0.99);
  EXPECT_LT(scene.triangles(Scene::Detail::Fine), before);
}

TEST(FrameBudget, LearnsWhatAFrameHolds) {
  FrameBudget budget;
  EXPECT_EQ(budget.capacity(), FrameBudget::kFirst);
  for (int i = 0; i < 30; ++i) {
    budget.drawn(budget.capacity(), 0.001);
  }
  EXPECT_GT(budget.capacity(), 1e6) << "a graphics card gets all at once";
  // 200 000 triangles a second
  for (int i = 0; i < 30; ++i) {
    budget.drawn(budget.capacity(), budget.capacity() / 200000.0);
  }
  EXPECT_LE(budget.capacity(), std::max(FrameBudget::kLeast, 200000.0 * FrameBudget::kFrame));
  for (int i = 0; i < 30; ++i) {
    budget.drawn(1e4, 10.0);
  }
  EXPECT_EQ(budget.capacity(), FrameBudget::kLeast);
  budget.drawn(10.0, 0.0001);
  EXPECT_EQ(budget.capacity(), FrameBudget::kLeast) << "a few triangles say nothing about many";
}

TEST(Scene, PicksTheMoveUnderTheMouse) {
  Scene scene;
  const auto path = samplePath(1, 11);  // x from 0 to 20
  scene.setPath(path->prepared());
  // Looking down: x and y of ±32 mm fill a square of 640 pixels.
  Scene::Ray ray;
  ray.worldToClip = {1.0 / 32, 0, 0, 0, 0, 1.0 / 32, 0, 0, 0, 0, -1.0 / 100, 0, 0, 0, 0, 1};
  ray.width = ray.height = 640;
  ray.x = 320 + 10.0 * 12.3;
  ray.y = 320 + 4.0;
  const Pick pick = scene.pickMove(ray);
  ASSERT_EQ(pick.kind, Pick::Kind::Move);
  EXPECT_EQ(pick.index, 6);
  EXPECT_DOUBLE_EQ(pick.position[0], 12.0);
  ray.y = 500;
  EXPECT_EQ(scene.pickMove(ray).kind, Pick::Kind::None);
  scene.setRange(0, 3);
  ray.y = 320;
  EXPECT_EQ(scene.pickMove(ray).kind, Pick::Kind::None) << "what is hidden cannot be picked";
}

TEST(Scene, PicksFacesAndEdgesOfAPart) {
  Scene scene;
  MeshData mesh;
  mesh.positions = {0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0};
  mesh.triangles = {0, 1, 2, 0, 2, 3};
  mesh.faces = {7, 7};
  mesh.edgePositions = {0, 0, 0, 10, 0, 0};
  mesh.edgeBegin = {0, 2};
  mesh.edgeIds = {3};
  scene.setParts({prepare(mesh)});
  scene.setPartStyle(PartStyle::Solid);
  Scene::Ray ray;
  ray.worldToClip = {1.0 / 32, 0, 0, 0, 0, 1.0 / 32, 0, 0, 0, 0, -1.0 / 100, 0, 0, 0, 0, 1};
  ray.width = ray.height = 640;
  ray.x = 320 + 50;
  ray.y = 320 + 52;
  ray.eye = {5.0, 5.2, 100};
  ray.direction = {0, 0, -1};
  EXPECT_EQ(scene.pickEdge(ray).kind, Pick::Kind::None);
  const Pick face = scene.pickFace(ray);
  ASSERT_EQ(face.kind, Pick::Kind::Face);
  EXPECT_EQ(face.index, 7);
  EXPECT_NEAR(face.position[1], 5.2, 1e-6);
  ray.y = 321;
  const Pick edge = scene.pickEdge(ray);
  ASSERT_EQ(edge.kind, Pick::Kind::Edge);
  EXPECT_EQ(edge.index, 3);
  scene.setPartStyle(PartStyle::Hidden);
  EXPECT_EQ(scene.pickFace(ray).kind, Pick::Kind::None);
  EXPECT_EQ(scene.pickEdge(ray).kind, Pick::Kind::None);
}

}  // namespace
}  // namespace wcam::viewport
