// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/level_set.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"

#include "level_flats.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace wcam::geometry {

namespace {

constexpr std::uint32_t kNone = HalfEdges::kNone;
constexpr std::size_t kVertexGrain = 16384;
constexpr std::size_t kTriangleGrain = 32768;
constexpr std::size_t kLevelGrain = 8;
/// Mesh edges are numbered in at most so many chunks, each with its own count per level.
constexpr std::size_t kEdgeChunks = 16;
constexpr std::size_t kLeastEdgeGrain = 32768;
/// Nodes that are traced at a time (one level may have more): bounds the working memory to some
/// 200 MB.
constexpr std::size_t kBlockNodes = std::size_t{1} << 24;

/// Traces in four sweeps, each a stream over one array: the vertices count the levels at or below
/// them; the edges number their nodes level by level; the triangles link the nodes; the levels
/// follow the links. Only the last one jumps, within the nodes of one level.
class Tracer {
public:
  Tracer(const TriangleMesh& mesh,
         const HalfEdges& halfEdges,
         std::span<const double> scalar,
         std::span<const double> levels,
         const LevelSnap& snap)
      : mesh_(mesh), halfEdges_(halfEdges), scalar_(scalar), levels_(levels), snap_(snap.rounding) {
    countLevels(snap_);
    settled_ = settleFlats(mesh, halfEdges, scalar, levels, snap, count_);
    splitNonManifold();
  }

  std::vector<std::vector<LevelContour>> run(const JobContext& context) {
    std::vector<std::vector<LevelContour>> result(levels_.size());
    countNodes(context);
    base_.resize(traceEdgeCount());
    for (std::uint32_t low = 0; low < levels_.size();) {
      const std::uint32_t high = blockEnd(low);
      traceBlock(low, high, result, context);
      low = high;
    }
    return result;
  }

private:
  static constexpr std::uint8_t kHasPrevious = 1;
  static constexpr std::uint8_t kVisited = 2;

  /// A range of levels that is traced at once.
  struct Block {
    std::uint32_t low, high;
  };

  /// Mesh edges; each half-edge at a non-manifold edge is a trace edge of its own.
  [[nodiscard]] std::size_t traceEdgeCount() const {
    return halfEdges_.edgeCount() + extraEdges_.size();
  }

  [[nodiscard]] std::uint32_t startOf(std::uint32_t h) const {
    return mesh_.triangles[h / 3][h % 3];
  }

  [[nodiscard]] std::uint32_t endOf(std::uint32_t h) const {
    return mesh_.triangles[h / 3][(h % 3 + 1) % 3];
  }

  [[nodiscard]] std::uint32_t edgeOf(std::uint32_t h) const {
    return extraEdgeOf_.empty() || extraEdgeOf_[h] == kNone ? halfEdges_.edgeOf(h)
                                                            : extraEdgeOf_[h];
  }

  void countLevels(double snap) {
    const std::size_t n = mesh_.vertices.size();
    count_.resize(n);
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < n; ++v) {
      lowest = std::isnan(scalar_[v]) ? lowest : std::min(lowest, scalar_[v]);
    }
    const double first = levels_.front();
    const double step = levels_.size() > 1
                            ? (levels_.back() - first) / static_cast<double>(levels_.size() - 1)
                            : 1.0;
    // Off by less, the guessed index is off by one at most.
    constexpr double kUniform = 1e-6;
    bool uniform = true;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      uniform = uniform &&
                std::abs(levels_[i] - (first + step * static_cast<double>(i))) < kUniform * step;
    }
    parallelForChunks(n, kVertexGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        const double value = scalar_[v] + snap;
        std::size_t k = 0;
        if (std::isnan(value)) {
          count_[v] = kNone;
          continue;
        }
        if (uniform) {
          // A guess by arithmetic, made exact by comparing with its neighbours.
          const double guess =
              std::clamp((value - first) / step, -1.0, static_cast<double>(levels_.size()));
          k = std::min(static_cast<std::size_t>(guess + 1.0), levels_.size());
          while (k > 0 && levels_[k - 1] > value) {
            --k;
          }
          while (k < levels_.size() && levels_[k] <= value) {
            ++k;
          }
        } else {
          k = static_cast<std::size_t>(std::upper_bound(levels_.begin(), levels_.end(), value) -
                                       levels_.begin());
        }
        count_[v] = static_cast<std::uint32_t>(k);
      }
    });
    for (std::size_t l = 0; l < levels_.size(); ++l) {
      if (std::abs(levels_[l] - lowest) <= snap) {
        // The level is the minimum: its vertices count as below.
        for (std::size_t v = 0; v < n; ++v) {
          if (count_[v] == l + 1 && scalar_[v] <= levels_[l] + snap) {
            count_[v] = static_cast<std::uint32_t>(l);
          }
        }
      }
    }
  }

  void splitNonManifold() {
    if (halfEdges_.nonManifoldEdges().empty()) {
      return;
    }
    std::vector<std::uint8_t> bad(halfEdges_.edgeCount(), 0);
    for (const std::uint32_t edge : halfEdges_.nonManifoldEdges()) {
      bad[edge] = 1;
    }
    extraEdgeOf_.assign(mesh_.triangles.size() * 3, kNone);
    for (std::uint32_t h = 0; h < extraEdgeOf_.size(); ++h) {
      if (bad[halfEdges_.edgeOf(h)] != 0) {
        extraEdgeOf_[h] = static_cast<std::uint32_t>(halfEdges_.edgeCount() + extraEdges_.size());
        extraEdges_.push_back(h);
      }
    }
    nonManifold_ = std::move(bad);
  }

  /// Levels that cross a trace edge within a block.
  [[nodiscard]] Block crossings(std::uint32_t e, const Block& block) const {
    std::array<std::uint32_t, 2> ends{};
    if (e >= halfEdges_.edgeCount()) {
      const std::uint32_t h = extraEdges_[e - halfEdges_.edgeCount()];
      ends = {startOf(h), endOf(h)};
    } else if (!nonManifold_.empty() && nonManifold_[e] != 0) {
      return {0, 0};
    } else {
      ends = halfEdges_.edgeVertices(e);
    }
    const std::uint32_t a = count_[ends[0]];
    const std::uint32_t b = count_[ends[1]];
    const std::uint32_t low = std::max(std::min(a, b), block.low);
    const std::uint32_t high = std::min(std::max(a, b), block.high);
    if (a == kNone || b == kNone || low >= high) {
      return {0, 0};
    }
    return {low, high};
  }

  /// Calls body(chunk, crossed edge, crossings) for the edges of each chunk in their order.
  template <class Body>
  void forCrossedEdges(const Block& block, const Body& body, const JobContext& context) const {
    parallelForChunks(
        traceEdgeCount(), edgeGrain_,
        [&](std::size_t begin, std::size_t end) {
          const std::size_t chunk = begin / edgeGrain_;
          for (std::size_t e = begin; e < end; ++e) {
            const Block levels = crossings(static_cast<std::uint32_t>(e), block);
            if (levels.low < levels.high) {
              body(chunk, e, levels);
            }
          }
        },
        context);
  }

  /// Counts the nodes of every edge chunk and level.
  void countNodes(const JobContext& context) {
    edgeGrain_ = std::max(kLeastEdgeGrain, traceEdgeCount() / kEdgeChunks + 1);
    const std::size_t chunks = (traceEdgeCount() + edgeGrain_ - 1) / edgeGrain_;
    const std::size_t width = levels_.size() + 1;
    // First differences from level to level; unsigned wrap-around cancels in the sums.
    chunkNodes_.assign(chunks, std::vector<std::uint32_t>(width, 0));
    forCrossedEdges(
        {0, static_cast<std::uint32_t>(levels_.size())},
        [&](std::size_t chunk, std::size_t, const Block& levels) {
          ++chunkNodes_[chunk][levels.low];
          --chunkNodes_[chunk][levels.high];
        },
        context);
    levelNodes_.assign(width, 0);
    for (std::vector<std::uint32_t>& nodes : chunkNodes_) {
      for (std::size_t l = 0; l < width; ++l) {
        nodes[l] += l > 0 ? nodes[l - 1] : 0;
        levelNodes_[l] += nodes[l];
      }
    }
  }

  [[nodiscard]] std::uint32_t blockEnd(std::uint32_t low) const {
    std::size_t nodes = levelNodes_[low];
    std::uint32_t high = low + 1;
    while (high < levels_.size() && nodes + levelNodes_[high] <= kBlockNodes) {
      nodes += levelNodes_[high];
      ++high;
    }
    return high;
  }

  void traceBlock(std::uint32_t low,
                  std::uint32_t high,
                  std::vector<std::vector<LevelContour>>& result,
                  const JobContext& context) {
    const Block block{low, high};
    numberNodes(block, context);
    next_.assign(nodeOf_.size(), kNone);
    entry_.resize(nodeOf_.size());
    state_.assign(nodeOf_.size(), 0);
    parallelFor(
        mesh_.triangles.size(), kTriangleGrain,
        [&](std::size_t t) { linkTriangle(static_cast<std::uint32_t>(t), block); }, context);
    joinAtNonManifold(block);
    parallelForChunks(
        high - low, kLevelGrain,
        [&](std::size_t begin, std::size_t end) {
          std::vector<std::uint32_t> chain;
          for (std::size_t l = low + begin; l < low + end; ++l) {
            followLevel(static_cast<std::uint32_t>(l), levelStart_[l - low],
                        levelStart_[l - low + 1], chain, result[l]);
          }
        },
        context);
  }

  /// Numbers the nodes of a block by level, then by edge.
  void numberNodes(const Block& block, const JobContext& context) {
    const std::size_t chunks = chunkNodes_.size();
    const std::size_t width = block.high - block.low;
    levelStart_.assign(width + 1, 0);
    std::vector<std::vector<std::uint32_t>> fill(chunks, std::vector<std::uint32_t>(width));
    std::vector<std::uint32_t> chunkStart(chunks, 0);
    std::uint32_t nodes = 0;
    for (std::size_t l = 0; l < width; ++l) {
      levelStart_[l] = nodes;
      for (std::size_t c = 0; c < chunks; ++c) {
        fill[c][l] = nodes;
        nodes += chunkNodes_[c][block.low + l];
      }
    }
    levelStart_[width] = nodes;
    for (std::size_t c = 0, sum = 0; c < chunks; ++c) {
      chunkStart[c] = static_cast<std::uint32_t>(sum);
      const auto begin = chunkNodes_[c].begin() + block.low;
      sum = std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(width), sum);
    }
    nodeOf_.resize(nodes);
    forCrossedEdges(
        block,
        [&](std::size_t chunk, std::size_t e, const Block& levels) {
          std::uint32_t& place = chunkStart[chunk];
          base_[e] = place - levels.low;  // unsigned wrap-around cancels when a level is added
          for (std::uint32_t l = levels.low; l < levels.high; ++l) {
            nodeOf_[place++] = fill[chunk][l - block.low]++;
          }
        },
        context);
  }

  [[nodiscard]] std::uint32_t node(std::uint32_t edge, std::uint32_t level) const {
    return nodeOf_[base_[edge] + level];
  }

  /// Links the nodes through which curves enter a triangle (field rising along its half-edge) to
  /// those through which they leave it. Every node is written by one triangle.
  void linkTriangle(std::uint32_t t, const Block& block) {
    const auto& corners = mesh_.triangles[t];
    const std::array<std::uint32_t, 3> count{count_[corners[0]], count_[corners[1]],
                                             count_[corners[2]]};
    if (count[0] == count[1] && count[1] == count[2]) {
      return;
    }
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t c1 = c == 2 ? 0 : c + 1;
      const std::uint32_t c2 = c == 0 ? 2 : c - 1;
      const std::uint32_t h = 3 * t + c;
      if (count[c] == kNone || count[c1] == kNone) {
        continue;
      }
      const std::uint32_t low = std::max(std::min(count[c], count[c1]), block.low);
      const std::uint32_t high = std::min(std::max(count[c], count[c1]), block.high);
      if (low >= high) {
        continue;
      }
      if (count[c] < count[c1]) {
        linkHalfEdge(h, {3 * t + c1, 3 * t + c2}, count[c2], {low, high});
      } else if (!halfEdges_.closed() && halfEdges_.twin(h) == kNone) {
        for (std::uint32_t l = low; l < high; ++l) {
          entry_[node(edgeOf(h), l)] = h;  // the curve leaves the mesh
        }
      }
    }
  }

  /// @param exits the half-edges after h
  /// @param apex levels at or below the corner opposite to h
  void linkHalfEdge(std::uint32_t h,
                    const std::array<std::uint32_t, 2>& exits,
                    std::uint32_t apex,
                    const Block& levels) {
    const std::uint32_t edge = edgeOf(h);
    for (std::uint32_t l = levels.low; l < levels.high; ++l) {
      const std::uint32_t from = node(edge, l);
      entry_[from] = h;
      if (apex == kNone) {
        continue;  // the triangle reaches out of the field
      }
      // Falls from the end of h to the apex when the apex is below the level, else from the apex to
      // the start.
      const std::uint32_t to = node(edgeOf(apex <= l ? exits[0] : exits[1]), l);
      next_[from] = to;
      state_[to] = kHasPrevious;
    }
  }

  /// Joins the ends and the starts of curves that meet on one non-manifold mesh edge at one level.
  void joinAtNonManifold(const Block& block) {
    struct Loose {
      std::uint32_t edge, level, node;
      bool start;
    };

    std::vector<Loose> loose;
    for (std::size_t i = 0; i < extraEdges_.size(); ++i) {
      const auto e = static_cast<std::uint32_t>(halfEdges_.edgeCount() + i);
      const Block levels = crossings(e, block);
      for (std::uint32_t l = levels.low; l < levels.high; ++l) {
        const std::uint32_t n = node(e, l);
        const bool start = (state_[n] & kHasPrevious) == 0 && next_[n] != kNone;
        loose.push_back({halfEdges_.edgeOf(extraEdges_[i]), l, n, start});
      }
    }
    std::sort(loose.begin(), loose.end(), [](const Loose& a, const Loose& b) {
      return std::tie(a.edge, a.level, a.start, a.node) <
             std::tie(b.edge, b.level, b.start, b.node);
    });
    for (std::size_t i = 0; i < loose.size();) {
      std::size_t end = i;
      std::size_t starts = 0;
      while (end < loose.size() && loose[end].edge == loose[i].edge &&
             loose[end].level == loose[i].level) {
        starts += loose[end].start ? 1U : 0U;
        ++end;
      }
      const std::size_t ends = end - i - starts;
      for (std::size_t k = 0; k < std::min(starts, ends); ++k) {
        next_[loose[i + k].node] = loose[i + ends + k].node;
        state_[loose[i + ends + k].node] |= kHasPrevious;
      }
      i = end;
    }
  }

  /// Makes the contours of the nodes [begin, end) of a level. `chain` is working memory.
  void followLevel(std::uint32_t level,
                   std::uint32_t begin,
                   std::uint32_t end,
                   std::vector<std::uint32_t>& chain,
                   std::vector<LevelContour>& contours) {
    // Open curves from their starts first, then the loops.
    for (const bool open : {true, false}) {
      for (std::uint32_t first = begin; first < end; ++first) {
        const bool isStart = (state_[first] & kHasPrevious) == 0;
        if ((state_[first] & kVisited) != 0 || isStart != open || (open && next_[first] == kNone)) {
          continue;
        }
        chain.clear();
        for (std::uint32_t n = first; n != kNone && (state_[n] & kVisited) == 0; n = next_[n]) {
          state_[n] |= kVisited;
          chain.push_back(entry_[n]);
        }
        contours.push_back(makeContour(level, !open, chain));
      }
    }
  }

  /// @param entries per node the half-edge
  [[nodiscard]] LevelContour makeContour(std::uint32_t level,
                                         bool closed,
                                         const std::vector<std::uint32_t>& entries) const {
    LevelContour contour;
    contour.closed = closed;
    contour.halfEdges = entries;
    contour.points.resize(entries.size());
    contour.fractions.resize(entries.size());
    bool repeats = false;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      placeNode(entries[i], level, contour.points[i], contour.fractions[i]);
      repeats = repeats || (i > 0 && contour.points[i] == contour.points[i - 1]);
    }
    if (repeats || contour.points.front() == contour.points.back()) {
      removeRepeats(contour);
    }
    return contour;
  }

  [[nodiscard]] bool isSettled(std::uint32_t vertex, std::uint32_t level) const {
    return !settled_.empty() && settled_[vertex] == level;
  }

  void placeNode(std::uint32_t h, std::uint32_t index, Vec3& point, double& fraction) const {
    const std::uint32_t start = startOf(h);
    const std::uint32_t end = endOf(h);
    const double level = levels_[index];
    const double a = scalar_[start];
    const double b = scalar_[end];
    const Vec3& p = mesh_.vertices[start];
    const Vec3& q = mesh_.vertices[end];
    // A snapped vertex is the node itself, so that curves through a vertex have equal nodes.
    if (std::abs(level - a) <= snap_ || isSettled(start, index)) {
      fraction = 0.0;
      point = p;
    } else if (std::abs(level - b) <= snap_ || isSettled(end, index)) {
      fraction = 1.0;
      point = q;
    } else {
      fraction = std::clamp((level - a) / (b - a), 0.0, 1.0);
      point = p + fraction * (q - p);
    }
  }

  /// Removes nodes that coincide with their successor (curve through a vertex); keeps the last of a
  /// run, whose triangle holds the segment that follows.
  static void removeRepeats(LevelContour& contour) {
    const std::size_t n = contour.points.size();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t successor = i + 1 < n ? i + 1 : 0;
      const bool last = i + 1 == n;
      const bool same = contour.points[i] == contour.points[successor];
      if (same && successor != i && !(last && (!contour.closed || kept == 0))) {
        continue;
      }
      contour.points[kept] = contour.points[i];
      contour.halfEdges[kept] = contour.halfEdges[i];
      contour.fractions[kept] = contour.fractions[i];
      ++kept;
    }
    contour.points.resize(kept);
    contour.halfEdges.resize(kept);
    contour.fractions.resize(kept);
  }

  const TriangleMesh& mesh_;
  const HalfEdges& halfEdges_;
  std::span<const double> scalar_;
  std::span<const double> levels_;
  double snap_;
  std::vector<std::uint32_t> count_;    ///< levels at or below each vertex; kNone outside the field
  std::vector<std::uint32_t> settled_;  ///< per vertex the level of its flat; empty without flats
  std::vector<std::uint32_t> extraEdges_, extraEdgeOf_;
  std::vector<std::uint8_t> nonManifold_;
  std::size_t edgeGrain_ = 1;
  std::vector<std::vector<std::uint32_t>> chunkNodes_;  ///< per edge chunk and level
  std::vector<std::size_t> levelNodes_;                 ///< per level
  // Of the present block:
  std::vector<std::uint32_t> levelStart_;  ///< first node of each level
  std::vector<std::uint32_t> base_;        ///< per trace edge: place in nodeOf_ of level 0
  std::vector<std::uint32_t> nodeOf_;      ///< nodes in the order of edge, then level
  std::vector<std::uint32_t> next_, entry_;
  std::vector<std::uint8_t> state_;
};

}  // namespace

std::vector<std::vector<LevelContour>> traceLevels(const TriangleMesh& mesh,
                                                   const HalfEdges& halfEdges,
                                                   std::span<const double> scalar,
                                                   std::span<const double> levels,
                                                   const LevelSnap& snap,
                                                   const JobContext& context) {
  WCAM_ASSERT(scalar.size() == mesh.vertices.size());
  WCAM_ASSERT(std::adjacent_find(levels.begin(), levels.end(), std::greater_equal<>()) ==
              levels.end());
  if (levels.empty() || mesh.triangles.empty()) {
    return std::vector<std::vector<LevelContour>>(levels.size());
  }
  return Tracer(mesh, halfEdges, scalar, levels, snap).run(context);
}

std::vector<std::vector<LevelContour>> planeSections(const TriangleMesh& mesh,
                                                     const HalfEdges& halfEdges,
                                                     const Vec3& direction,
                                                     std::span<const double> levels,
                                                     const JobContext& context) {
  std::vector<double> height(mesh.vertices.size());
  parallelFor(height.size(), kVertexGrain,
              [&](std::size_t v) { height[v] = direction.dot(mesh.vertices[v]); });
  // Rounding of a height is a few units in the last place of the coordinates.
  constexpr double kRelativeSnap = 1e-12;
  return traceLevels(mesh, halfEdges, height, levels,
                     {kRelativeSnap * mesh.bounds().diagonal(), flatTolerance(mesh)}, context);
}

}  // namespace wcam::geometry
