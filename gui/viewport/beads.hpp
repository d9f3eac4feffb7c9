// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene_data.hpp"

#include <cstddef>
#include <vector>

namespace wcam::viewport {

/// Corners of the section of a drawn bead.
inline constexpr int kSectionCorners = 8;

/// Moves of one layer that are drawn as one object: few enough that a changed range costs nothing,
/// enough that a million moves make few objects.
inline constexpr std::size_t kChunkMoves = 4096;

/// A range of moves [begin, end), and the layer in which it begins.
struct ChunkRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::uint32_t layer = 0;
};

/// Cuts a path into chunks: a new one after `most` moves and, unless `across` layers, with every
/// layer.
std::vector<ChunkRange> chunksOf(const PathData& path,
                                 std::size_t most = kChunkMoves,
                                 bool across = false);

/// The solid beads of a chunk. The first section stands at the end of the move before the chunk, so
/// that chunks join. Polygons come in the order of the moves.
struct BeadSolid {
  std::vector<float> positions;  ///< kSectionCorners vertices per section
  std::vector<float> normals;
  std::vector<std::uint32_t> moveOfVertex;  ///< move whose colour a vertex takes
  std::vector<long long> offsets;           ///< of the polygons, and the end
  std::vector<long long> corners;
  std::vector<std::uint32_t>
      polygonsUpTo;  ///< per move of the chunk: polygons of it and those before
};

BeadSolid beadSolid(const PathData& path, const ChunkRange& chunk);

/// The same as lines: one per depositing move (or, with `travel`, one per other move). Of `stride`
/// points of a bead one is kept, and its ends.
struct BeadLines {
  std::vector<float> positions;
  std::vector<std::uint32_t> moveOfVertex;
  std::vector<long long> offsets;
  std::vector<long long> corners;
  std::vector<std::uint32_t> linesUpTo;
};

BeadLines beadLines(const PathData& path,
                    const ChunkRange& chunk,
                    bool travel,
                    std::size_t stride = 1);

}  // namespace wcam::viewport
