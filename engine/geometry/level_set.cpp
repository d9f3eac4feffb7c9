// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/level_set.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::geometry {

namespace {

constexpr std::uint32_t kNone = HalfEdges::kNone;
/// Levels traced together: their nodes stay in the second-level cache for meshes of a million
/// triangles.
constexpr std::size_t kSlab = 16;
constexpr std::size_t kVertexGrain = 16384;

class Tracer {
public:
  Tracer(const TriangleMesh& mesh,
         const HalfEdges& halfEdges,
         std::span<const double> scalar,
         std::span<const double> levels,
         double snap)
      : mesh_(mesh), halfEdges_(halfEdges), scalar_(scalar), levels_(levels), snap_(snap) {
    countLevels(snap);
    splitNonManifold();
  }

  std::vector<std::vector<LevelContour>> run(const JobContext& context) {
    std::vector<std::vector<LevelContour>> result(levels_.size());
    sortEdgesIntoSlabs();
    const std::size_t slabs = slabStart_.size() - 1;
    const std::size_t perTask = std::max<std::size_t>(1, (slabs + 7) / 8);
    parallelForChunks(
        slabs, perTask,
        [&](std::size_t begin, std::size_t end) {
          Workspace workspace;
          workspace.offset.resize(edgeVertexCount());
          for (std::size_t slab = begin; slab < end; ++slab) {
            context.check();
            traceSlab(slab, workspace, result);
          }
        },
        context);
    return result;
  }

private:
  /// Per task, reused between slabs.
  struct Workspace {
    std::vector<std::uint32_t> offset;  ///< per mesh edge: first node minus its first level
    std::vector<std::uint32_t> next, entry;
    std::vector<std::uint8_t> state;
  };

  static constexpr std::uint8_t kHasPrevious = 1;
  static constexpr std::uint8_t kVisited = 2;

  [[nodiscard]] std::size_t edgeVertexCount() const {
    return halfEdges_.edgeCount() + extraEdges_.size();
  }

  [[nodiscard]] std::uint32_t startOf(std::uint32_t h) const {
    return mesh_.triangles[h / 3][h % 3];
  }

  [[nodiscard]] std::uint32_t endOf(std::uint32_t h) const {
    return mesh_.triangles[h / 3][(h % 3 + 1) % 3];
  }

  [[nodiscard]] static std::uint32_t nextInTriangle(std::uint32_t h) {
    return h % 3 == 2 ? h - 2 : h + 1;
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
    bool uniform = true;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      uniform =
          uniform && std::abs(levels_[i] - (first + step * static_cast<double>(i))) < 1e-6 * step;
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
          k = static_cast<std::size_t>(std::max(0.0, std::floor(guess) + 1.0));
          k = std::min(k, levels_.size());
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

  /// Half-edge of trace edge e along which the field rises, or kNone; and any half-edge of it.
  [[nodiscard]] std::uint32_t risingHalfEdge(std::uint32_t e, std::uint32_t& some) const {
    const bool extra = e >= halfEdges_.edgeCount();
    some = extra ? extraEdges_[e - halfEdges_.edgeCount()] : halfEdges_.halfEdgeOf(e);
    if (count_[startOf(some)] < count_[endOf(some)]) {
      return some;
    }
    return extra ? kNone : halfEdges_.twin(some);
  }

  bool levelRange(std::uint32_t e, std::uint32_t& low, std::uint32_t& high) const {
    const bool extra = e >= halfEdges_.edgeCount();
    if (!extra && !nonManifold_.empty() && nonManifold_[e] != 0) {
      return false;
    }
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    if (extra) {
      a = startOf(extraEdges_[e - halfEdges_.edgeCount()]);
      b = endOf(extraEdges_[e - halfEdges_.edgeCount()]);
    } else {
      a = halfEdges_.edgeVertices(e)[0];
      b = halfEdges_.edgeVertices(e)[1];
    }
    low = std::min(count_[a], count_[b]);
    high = std::max(count_[a], count_[b]);
    return high != kNone && low < high;
  }

  void sortEdgesIntoSlabs() {
    const std::size_t slabs = (levels_.size() + kSlab - 1) / kSlab;
    slabStart_.assign(slabs + 1, 0);
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    const auto edges = static_cast<std::uint32_t>(edgeVertexCount());
    for (std::uint32_t e = 0; e < edges; ++e) {
      if (levelRange(e, low, high)) {
        for (std::size_t s = low / kSlab; s <= (high - 1) / kSlab; ++s) {
          ++slabStart_[s + 1];
        }
      }
    }
    for (std::size_t s = 0; s < slabs; ++s) {
      slabStart_[s + 1] += slabStart_[s];
    }
    slabEdges_.resize(slabStart_.back());
    std::vector<std::size_t> fill(slabStart_.begin(), slabStart_.end() - 1);
    for (std::uint32_t e = 0; e < edges; ++e) {
      if (levelRange(e, low, high)) {
        for (std::size_t s = low / kSlab; s <= (high - 1) / kSlab; ++s) {
          slabEdges_[fill[s]++] = e;
        }
      }
    }
  }

  void traceSlab(std::size_t slab,
                 Workspace& w,
                 std::vector<std::vector<LevelContour>>& result) const {
    const auto slabLow = static_cast<std::uint32_t>(slab * kSlab);
    const auto slabHigh = static_cast<std::uint32_t>(std::min(levels_.size(), (slab + 1) * kSlab));
    std::uint32_t nodes = 0;
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    for (std::size_t i = slabStart_[slab]; i < slabStart_[slab + 1]; ++i) {
      const std::uint32_t e = slabEdges_[i];
      levelRange(e, low, high);
      low = std::max(low, slabLow);
      w.offset[e] = nodes - low;  // unsigned wrap-around cancels when a level is added
      nodes += std::min(high, slabHigh) - low;
    }
    w.next.assign(nodes, kNone);
    w.entry.resize(nodes);
    w.state.assign(nodes, 0);
    for (std::size_t i = slabStart_[slab]; i < slabStart_[slab + 1]; ++i) {
      linkEdge(slabEdges_[i], slabLow, slabHigh, w);
    }
    joinAtNonManifold(slab, slabLow, slabHigh, w);
    follow(slab, slabLow, slabHigh, w, result);
  }

  /// Links every node of an edge to the node through which the curve leaves the entered triangle.
  void linkEdge(std::uint32_t e,
                std::uint32_t slabLow,
                std::uint32_t slabHigh,
                Workspace& w) const {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    levelRange(e, low, high);
    std::uint32_t some = kNone;
    const std::uint32_t h = risingHalfEdge(e, some);
    low = std::max(low, slabLow);
    high = std::min(high, slabHigh);
    if (h == kNone) {
      for (std::uint32_t l = low; l < high; ++l) {
        w.entry[w.offset[e] + l] = some;
      }
      return;
    }
    const std::uint32_t h1 = nextInTriangle(h);
    const std::uint32_t h2 = nextInTriangle(h1);
    const std::uint32_t apex = count_[startOf(h2)];
    for (std::uint32_t l = low; l < high; ++l) {
      const std::uint32_t node = w.offset[e] + l;
      w.entry[node] = h;
      if (apex == kNone) {
        continue;  // the triangle reaches out of the field
      }
      // Falls from the end of h to the apex when the apex is below the level, else from the apex to
      // the start.
      const std::uint32_t exit = apex <= l ? h1 : h2;
      const std::uint32_t successor = w.offset[edgeOf(exit)] + l;
      w.next[node] = successor;
      w.state[successor] = kHasPrevious;
    }
  }

  /// Joins the ends and the starts of curves that meet on one non-manifold mesh edge at one level.
  void joinAtNonManifold(std::size_t slab,
                         std::uint32_t slabLow,
                         std::uint32_t slabHigh,
                         Workspace& w) const {
    if (extraEdges_.empty()) {
      return;
    }

    struct Loose {
      std::uint32_t edge, level, node;
      bool start;
    };

    std::vector<Loose> loose;
    for (std::size_t i = slabStart_[slab]; i < slabStart_[slab + 1]; ++i) {
      const std::uint32_t e = slabEdges_[i];
      if (e < halfEdges_.edgeCount()) {
        continue;
      }
      std::uint32_t low = 0;
      std::uint32_t high = 0;
      levelRange(e, low, high);
      for (std::uint32_t l = std::max(low, slabLow); l < std::min(high, slabHigh); ++l) {
        const std::uint32_t node = w.offset[e] + l;
        const bool start = (w.state[node] & kHasPrevious) == 0 && w.next[node] != kNone;
        loose.push_back(
            {halfEdges_.edgeOf(extraEdges_[e - halfEdges_.edgeCount()]), l, node, start});
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
        w.next[loose[i + k].node] = loose[i + ends + k].node;
        w.state[loose[i + ends + k].node] |= kHasPrevious;
      }
      i = end;
    }
  }

  void follow(std::size_t slab,
              std::uint32_t slabLow,
              std::uint32_t slabHigh,
              Workspace& w,
              std::vector<std::vector<LevelContour>>& result) const {
    // Open curves from their starts first, then the loops.
    for (const bool open : {true, false}) {
      for (std::size_t i = slabStart_[slab]; i < slabStart_[slab + 1]; ++i) {
        const std::uint32_t e = slabEdges_[i];
        std::uint32_t low = 0;
        std::uint32_t high = 0;
        levelRange(e, low, high);
        for (std::uint32_t l = std::max(low, slabLow); l < std::min(high, slabHigh); ++l) {
          const std::uint32_t node = w.offset[e] + l;
          const bool isStart = (w.state[node] & kHasPrevious) == 0;
          if ((w.state[node] & kVisited) != 0 || isStart != open ||
              (open && w.next[node] == kNone)) {
            continue;
          }
          LevelContour contour = followFrom(node, l, w);
          contour.closed = !open;
          finish(contour);
          result[l].push_back(std::move(contour));
        }
      }
    }
  }

  LevelContour followFrom(std::uint32_t first, std::uint32_t level, Workspace& w) const {
    LevelContour contour;
    for (std::uint32_t node = first; node != kNone && (w.state[node] & kVisited) == 0;
         node = w.next[node]) {
      w.state[node] |= kVisited;
      const std::uint32_t h = w.entry[node];
      const double a = scalar_[startOf(h)];
      const double b = scalar_[endOf(h)];
      const Vec3& p = mesh_.vertices[startOf(h)];
      const Vec3& q = mesh_.vertices[endOf(h)];
      contour.halfEdges.push_back(h);
      // A snapped vertex is the node itself, so that curves through a vertex have equal nodes.
      if (std::abs(levels_[level] - a) <= snap_) {
        contour.fractions.push_back(0.0);
        contour.points.push_back(p);
      } else if (std::abs(levels_[level] - b) <= snap_) {
        contour.fractions.push_back(1.0);
        contour.points.push_back(q);
      } else {
        const double fraction = std::clamp((levels_[level] - a) / (b - a), 0.0, 1.0);
        contour.fractions.push_back(fraction);
        contour.points.push_back(p + fraction * (q - p));
      }
    }
    return contour;
  }

  /// Removes nodes that coincide with their successor (curve through a vertex); keeps the last of a
  /// run, whose triangle holds the segment that follows.
  static void finish(LevelContour& contour) {
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
  std::vector<std::uint32_t> count_;  ///< levels at or below each vertex; kNone outside the field
  std::vector<std::uint32_t> extraEdges_, extraEdgeOf_;
  std::vector<std::uint8_t> nonManifold_;
  std::vector<std::size_t> slabStart_;
  std::vector<std::uint32_t> slabEdges_;
};

}  // namespace

std::vector<std::vector<LevelContour>> traceLevels(const TriangleMesh& mesh,
                                                   const HalfEdges& halfEdges,
                                                   std::span<const double> scalar,
                                                   std::span<const double> levels,
                                                   double snap,
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
  return traceLevels(mesh, halfEdges, height, levels, kRelativeSnap * mesh.bounds().diagonal(),
                     context);
}

}  // namespace wcam::geometry
