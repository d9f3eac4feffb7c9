// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "prepared_vtk.hpp"
#include "simplify.hpp"
#include "vtk_arrays.hpp"

#include <vtkFloatArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <utility>

namespace wcam::viewport {

namespace {

// Above this many moves beads are lines: solids would need gigabytes and seconds (PERFORMANCE i).
constexpr std::size_t kMaxSolidMoves = 200000;
/// Triangles of a part that are drawn: more than a view has room for, and few enough for a frame of
/// software rendering.
constexpr std::size_t kMostTriangles = 100000;
/// Triangles of a part while things move, where drawing is slow.
constexpr std::size_t kCoarseTriangles = 10000;
/// Triangles that are drawn as one object: a frame of a software renderer holds several.
constexpr std::size_t kPieceTriangles = 8000;
/// Moves that are drawn as one object of solids: the same, with 16 triangles each.
constexpr std::size_t kSolidMoves = 512;
/// The same of lines, which cost little: an object itself costs more. A range of layers is a range
/// of moves, so these may go across layers.
constexpr std::size_t kLineMoves = 16384;
/// Of so many points of a long path one is drawn while things move.
constexpr std::size_t kFewStride = 4;

PreparedChunk chunkOf(const ChunkRange& range, BeadSolid built) {
  PreparedChunk chunk;
  chunk.range = range;
  chunk.data = vtkSmartPointer<vtkPolyData>::New();
  chunk.data->SetPoints(pointsOf(built.positions));
  chunk.data->GetPointData()->SetNormals(vectorsOf(built.normals));
  chunk.all = cellsOf(built.offsets, built.corners);
  chunk.data->SetPolys(chunk.all);
  chunk.cellsUpTo = std::move(built.polygonsUpTo);
  chunk.moveOfVertex = std::move(built.moveOfVertex);
  return chunk;
}

PreparedChunk chunkOf(const ChunkRange& range, BeadLines built) {
  PreparedChunk chunk;
  chunk.range = range;
  chunk.isLines = true;
  chunk.data = vtkSmartPointer<vtkPolyData>::New();
  chunk.data->SetPoints(pointsOf(built.positions));
  chunk.all = cellsOf(built.offsets, built.corners);
  chunk.data->SetLines(chunk.all);
  chunk.cellsUpTo = std::move(built.linesUpTo);
  chunk.moveOfVertex = std::move(built.moveOfVertex);
  return chunk;
}

}  // namespace

std::vector<PreparedChunk> prepareChunks(const PathData& path, ChunkKind kind) {
  std::vector<PreparedChunk> chunks;
  const bool solid = kind == ChunkKind::Solid;
  for (const ChunkRange& range : chunksOf(path, solid ? kSolidMoves : kLineMoves, !solid)) {
    chunks.push_back(kind == ChunkKind::Solid
                         ? chunkOf(range, beadSolid(path, range))
                         : chunkOf(range, beadLines(path, range, kind == ChunkKind::Travel,
                                                    kind == ChunkKind::FewLines ? kFewStride : 1)));
  }
  return chunks;
}

bool PreparedPath::onlyLines() const {
  return data->size() > kMaxSolidMoves;
}

std::shared_ptr<const PreparedMesh> prepare(MeshData mesh) {
  auto prepared = std::make_shared<PreparedMesh>();
  mesh = simplified(std::move(mesh), kMostTriangles);
  prepared->surface = surfaceOf(mesh);
  const std::size_t count = mesh.triangles.size() / 3;
  if (count > kCoarseTriangles) {
    MeshData coarse = mesh;
    coarse.edgeBegin.clear();
    prepared->coarse = surfaceOf(simplified(std::move(coarse), kCoarseTriangles));
  }
  for (std::size_t first = 0; first < count || first == 0; first += kPieceTriangles) {
    vtkNew<vtkPolyData> piece;
    piece->ShallowCopy(prepared->surface);
    piece->SetPolys(
        cellRange(prepared->surface->GetPolys(), first, std::min(first + kPieceTriangles, count)));
    prepared->pieces.emplace_back(piece);
  }
  if (mesh.edgeBegin.size() > 1) {
    prepared->edges = edgesOf(mesh);
  }
  prepared->locator = vtkSmartPointer<vtkStaticCellLocator>::New();
  prepared->locator->SetDataSet(prepared->surface);
  prepared->locator->BuildLocator();
  prepared->mesh = std::move(mesh);
  return prepared;
}

std::shared_ptr<PreparedPath> prepare(std::shared_ptr<const PathData> path) {
  auto prepared = std::make_shared<PreparedPath>();
  prepared->data = std::move(path);
  const bool onlyLines = prepared->onlyLines();
  prepared->fine = prepareChunks(*prepared->data, onlyLines ? ChunkKind::Lines : ChunkKind::Solid);
  prepared->coarse =
      prepareChunks(*prepared->data, onlyLines ? ChunkKind::FewLines : ChunkKind::Lines);
  return prepared;
}

}  // namespace wcam::viewport
