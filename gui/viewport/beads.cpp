// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "beads.hpp"

#include <algorithm>

namespace wcam::viewport {

namespace {

struct Corner {
  float side;
  float up;
  float sideNormal;
  float upNormal;
};

// A bead is nearly flat above and below and round at its sides.
constexpr std::array<Corner, kSectionCorners> kSection = {{{1.0F, -0.38F, 0.94F, -0.34F},
                                                           {1.0F, 0.38F, 0.94F, 0.34F},
                                                           {0.72F, 1.0F, 0.42F, 0.91F},
                                                           {-0.72F, 1.0F, -0.42F, 0.91F},
                                                           {-1.0F, 0.38F, -0.94F, 0.34F},
                                                           {-1.0F, -0.38F, -0.94F, -0.34F},
                                                           {-0.72F, -1.0F, -0.42F, -0.91F},
                                                           {0.72F, -1.0F, 0.42F, -0.91F}}};

void addSection(const PathData& path, std::size_t place, std::size_t like, BeadSolid& solid) {
  // The section has the size of the move that is drawn, at the place where that move begins or
  // ends.
  const float* p = &path.positions[3 * place];
  const float* b = &path.build[3 * place];
  const float* s = &path.side[3 * place];
  const float half = 0.5F * path.heights[like];
  const float wide = 0.5F * path.widths[like];
  for (const Corner& corner : kSection) {
    for (int axis = 0; axis < 3; ++axis) {
      solid.positions.push_back(p[axis] + b[axis] * half * (corner.up - 1.0F) +
                                s[axis] * wide * corner.side);
    }
    for (int axis = 0; axis < 3; ++axis) {
      solid.normals.push_back(b[axis] * corner.upNormal + s[axis] * corner.sideNormal);
    }
    solid.moveOfVertex.push_back(static_cast<std::uint32_t>(like));
  }
}

void addPolygon(BeadSolid& solid, std::initializer_list<long long> corners) {
  solid.corners.insert(solid.corners.end(), corners);
  solid.offsets.push_back(static_cast<long long>(solid.corners.size()));
}

void addCap(BeadSolid& solid, long long first, bool reversed) {
  for (int k = 0; k < kSectionCorners; ++k) {
    solid.corners.push_back(first + (reversed ? kSectionCorners - 1 - k : k));
  }
  solid.offsets.push_back(static_cast<long long>(solid.corners.size()));
}

}  // namespace

std::vector<ChunkRange> chunksOf(const PathData& path, std::size_t most, bool across) {
  std::vector<ChunkRange> chunks;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (chunks.empty() || (!across && chunks.back().layer != path.layers[i]) ||
        chunks.back().end - chunks.back().begin >= most) {
      chunks.push_back({i, i, path.layers[i]});
    }
    chunks.back().end = i + 1;
  }
  return chunks;
}

BeadSolid beadSolid(const PathData& path, const ChunkRange& chunk) {
  BeadSolid solid;
  solid.offsets.push_back(0);
  long long last = -1;          // first vertex of the section at the end of the move before
  std::size_t lastSection = 0;  // its move
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    if (path.deposits[i] != 0 && i > 0) {
      const bool begins = last < 0 || lastSection + 1 != i;
      if (begins) {
        last = static_cast<long long>(solid.moveOfVertex.size());
        addSection(path, i - 1, i, solid);
        // Inside a bead that goes on from the chunk before there is no end to close.
        if (path.deposits[i - 1] == 0 || i - 1 == 0) {
          addCap(solid, last, true);
        }
      }
      const auto next = static_cast<long long>(solid.moveOfVertex.size());
      addSection(path, i, i, solid);
      for (int k = 0; k < kSectionCorners; ++k) {
        const int other = (k + 1) % kSectionCorners;
        addPolygon(solid, {last + k, last + other, next + other, next + k});
      }
      if (i + 1 >= path.size() || path.deposits[i + 1] == 0) {
        addCap(solid, next, false);
      }
      last = next;
      lastSection = i;
    }
    solid.polygonsUpTo.push_back(static_cast<std::uint32_t>(solid.offsets.size() - 1));
  }
  return solid;
}

BeadLines beadLines(const PathData& path,
                    const ChunkRange& chunk,
                    bool travel,
                    std::size_t stride) {
  BeadLines lines;
  lines.offsets.push_back(0);
  const auto add = [&](std::size_t place, std::size_t like) {
    lines.positions.insert(lines.positions.end(), &path.positions[3 * place],
                           &path.positions[3 * place] + 3);
    lines.moveOfVertex.push_back(static_cast<std::uint32_t>(like));
    return static_cast<long long>(lines.moveOfVertex.size() - 1);
  };
  long long last = -1;
  std::size_t lastMove = 0;
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    if ((path.deposits[i] != 0) != travel && i > 0) {
      if (last < 0 || lastMove + 1 != i) {
        last = add(i - 1, i);
      }
      lastMove = i;
      const bool goesOn = i + 1 < chunk.end && (path.deposits[i + 1] != 0) != travel;
      if (goesOn && (i + 1 - chunk.begin) % stride != 0) {
        lines.linesUpTo.push_back(static_cast<std::uint32_t>(lines.offsets.size() - 1));
        continue;
      }
      const long long next = add(i, i);
      lines.corners.insert(lines.corners.end(), {last, next});
      lines.offsets.push_back(static_cast<long long>(lines.corners.size()));
      last = next;
    }
    lines.linesUpTo.push_back(static_cast<std::uint32_t>(lines.offsets.size() - 1));
  }
  return lines;
}

}  // namespace wcam::viewport
