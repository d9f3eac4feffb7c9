// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "beads.hpp"
#include "prepared.hpp"

#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStaticCellLocator.h>

#include <vector>

namespace wcam::viewport {

class PreparedMesh {
public:
  MeshData mesh;
  vtkSmartPointer<vtkPolyData> surface;
  std::vector<vtkSmartPointer<vtkPolyData>> pieces;  ///< of the surface, each drawn quickly
  vtkSmartPointer<vtkPolyData> coarse;  ///< fewer triangles; null when there are few anyway
  vtkSmartPointer<vtkPolyData> edges;   ///< null when the mesh has none
  vtkSmartPointer<vtkStaticCellLocator> locator;
};

/// A part of a path that is drawn as one object.
struct PreparedChunk {
  ChunkRange range;
  vtkSmartPointer<vtkPolyData> data;
  vtkSmartPointer<vtkCellArray> all;  ///< the cells of all its moves
  std::vector<std::uint32_t> moveOfVertex;
  std::vector<std::uint32_t> cellsUpTo;  ///< per move: cells of it and those before
  bool isLines = false;
};

enum class ChunkKind { Solid, Lines, FewLines, Travel };
std::vector<PreparedChunk> prepareChunks(const PathData& path, ChunkKind kind);

class PreparedPath {
public:
  std::shared_ptr<const PathData> data;
  std::vector<PreparedChunk> fine;    ///< solids, or lines when there are only lines
  std::vector<PreparedChunk> coarse;  ///< lines, of fewer points when there are only lines
  std::vector<PreparedChunk> travel;  ///< made when they are needed first

  [[nodiscard]] bool onlyLines() const;
};

}  // namespace wcam::viewport
