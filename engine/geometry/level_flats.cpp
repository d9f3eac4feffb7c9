// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "level_flats.hpp"

#include "wcam/base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

namespace wcam::geometry {

namespace {

constexpr std::uint32_t kNone = HalfEdges::kNone;
constexpr std::size_t kGrain = 16384;
/// Vertices of a flat lie within so many tolerances of the level: a face that comes within one
/// tolerance and is scattered by one tolerance reaches over three.
constexpr double kReach = 4.0;
/// A set that reaches from below the level by so many tolerances to as much above it is a slope.
constexpr double kSlope = 3.0;
/// Levels are at least so many tolerances apart: no vertex is near two of them.
constexpr double kApart = 20.0;
/// Noise of a face, mm, and in parts of the mesh's size.
constexpr double kNoise = 1e-3;
constexpr double kNoiseRelative = 5e-5;
/// Roundings of a number in single precision that add up in a placed vertex.
constexpr double kSingleRoundings = 4.0;

/// Least distance of neighbouring levels.
double leastSpacing(std::span<const double> levels) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t l = 1; l < levels.size(); ++l) {
    least = std::min(least, levels[l] - levels[l - 1]);
  }
  return least;
}

class Flats {
public:
  Flats(const TriangleMesh& mesh,
        const HalfEdges& halfEdges,
        std::span<const double> scalar,
        std::span<const double> levels,
        double tolerance,
        bool bordersOnly)
      : mesh_(mesh),
        halfEdges_(halfEdges),
        scalar_(scalar),
        levels_(levels),
        tolerance_(std::min(tolerance, leastSpacing(levels) / kApart)),
        mmPerUnit_(tolerance > 0.0 ? flatTolerance(mesh) / tolerance : 1.0),
        bordersOnly_(bordersOnly) {}

  void settle(std::vector<std::uint32_t>& count, std::vector<std::uint32_t>& settled) {
    if (!(tolerance_ > 0.0) || !findNear(count)) {
      return;
    }
    join();
    if (sets_.empty()) {
      return;
    }
    measure();
    settled.resize(near_.size(), kNone);
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < count.size(); ++v) {
      lowest = count[v] == kNone ? lowest : std::min(lowest, scalar_[v]);
    }
    const double size = mesh_.bounds().diagonal();
    for (std::size_t v = 0; v < near_.size(); ++v) {
      if (parent_[v] == kNone) {
        continue;
      }
      const Set& set = sets_[setOf_[root(static_cast<std::uint32_t>(v))]];
      const double level = levels_[near_[v]];
      if (!isFlat(set, level, size)) {
        continue;
      }
      const bool bottom = lowest >= level - kReach * tolerance_;
      if (bottom ? set.low <= level + tolerance_ : set.high >= level - tolerance_) {
        count[v] = near_[v] + (bottom ? 0 : 1);
        settled[v] = near_[v];
      }
    }
  }

private:
  struct Set {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    double area = 0.0;
    double perimeter = 0.0;
  };

  /// Per vertex the level that is near it. False when there is none.
  bool findNear(const std::vector<std::uint32_t>& count) {
    near_.assign(count.size(), kNone);
    std::atomic<bool> any{false};
    const double reach = kReach * tolerance_;
    parallelForChunks(count.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      bool found = false;
      for (std::size_t v = begin; v < end; ++v) {
        const std::uint32_t k = count[v];
        if (k == kNone) {
          continue;
        }
        if (k > 0 && scalar_[v] - levels_[k - 1] <= reach) {
          near_[v] = k - 1;
        } else if (k < levels_.size() && levels_[k] - scalar_[v] <= reach) {
          near_[v] = k;
        }
        found = found || near_[v] != kNone;
      }
      if (found) {
        any = true;
      }
    });
    return any;
  }

  /// The level on which a flat triangle lies.
  [[nodiscard]] std::uint32_t levelOf(std::uint32_t triangle) const {
    if (bordersOnly_) {
      return kNone;
    }
    const auto& t = mesh_.triangles[triangle];
    const std::uint32_t level = near_[t[0]];
    return level == near_[t[1]] && level == near_[t[2]] ? level : kNone;
  }

  std::uint32_t root(std::uint32_t v) {
    while (parent_[v] != v) {
      parent_[v] = parent_[parent_[v]];
      v = parent_[v];
    }
    return v;
  }

  void unite(std::uint32_t a, std::uint32_t b) {
    if (parent_.empty()) {
      parent_.assign(near_.size(), kNone);
    }
    parent_[a] = parent_[a] == kNone ? a : parent_[a];
    parent_[b] = parent_[b] == kNone ? b : parent_[b];
    const std::uint32_t ra = root(a);
    const std::uint32_t rb = root(b);
    parent_[std::max(ra, rb)] = std::min(ra, rb);
  }

  /// Joins the vertices of flat triangles and of border edges on one level.
  void join() {
    const bool open = !halfEdges_.closed();
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& c = mesh_.triangles[t];
      if (near_[c[0]] == kNone && near_[c[1]] == kNone) {
        continue;
      }
      if (levelOf(t) != kNone) {
        unite(c[0], c[1]);
        unite(c[1], c[2]);
      } else if (open) {
        for (std::uint32_t k = 0; k < 3; ++k) {
          const std::uint32_t a = c[k];
          const std::uint32_t b = c[(k + 1) % 3];
          if (near_[a] != kNone && near_[a] == near_[b] && halfEdges_.twin(3 * t + k) == kNone) {
            unite(a, b);
          }
        }
      }
    }
    if (parent_.empty()) {
      return;
    }
    setOf_.assign(near_.size(), kNone);
    for (std::uint32_t v = 0; v < parent_.size(); ++v) {
      if (parent_[v] == v) {
        setOf_[v] = static_cast<std::uint32_t>(sets_.size());
        sets_.emplace_back();
      }
    }
  }

  void measure() {
    for (std::uint32_t v = 0; v < parent_.size(); ++v) {
      if (parent_[v] != kNone) {
        Set& set = sets_[setOf_[root(v)]];
        set.low = std::min(set.low, scalar_[v]);
        set.high = std::max(set.high, scalar_[v]);
      }
    }
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (levelOf(t) == kNone) {
        continue;
      }
      const auto& c = mesh_.triangles[t];
      Set& set = sets_[setOf_[root(c[0])]];
      const Vec3& a = mesh_.vertices[c[0]];
      set.area += 0.5 * (mesh_.vertices[c[1]] - a).cross(Vec3(mesh_.vertices[c[2]] - a)).norm();
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t twin = halfEdges_.twin(3 * t + k);
        if (twin == kNone || levelOf(twin / 3) == kNone) {
          set.perimeter += (mesh_.vertices[c[(k + 1) % 3]] - mesh_.vertices[c[k]]).norm();
        }
      }
    }
  }

  [[nodiscard]] bool isFlat(const Set& set, double level, double size) const {
    if (set.low < level - kSlope * tolerance_ && set.high > level + kSlope * tolerance_) {
      return false;
    }
    // A sphere of radius r has a cap of height h within √(2·r·h), and no radius of a part is
    // greater than half its size: what is narrower may be a pole.
    return !(set.area > 0.0) ||
           2.0 * set.area >= set.perimeter * std::sqrt(mmPerUnit_ * (set.high - set.low) * size);
  }

  const TriangleMesh& mesh_;
  const HalfEdges& halfEdges_;
  std::span<const double> scalar_;
  std::span<const double> levels_;
  double tolerance_;
  double mmPerUnit_;  ///< of the scalar
  bool bordersOnly_;
  std::vector<std::uint32_t> near_;    ///< per vertex
  std::vector<std::uint32_t> parent_;  ///< per vertex of a set, kNone for the others
  std::vector<std::uint32_t> setOf_;   ///< per root
  std::vector<Set> sets_;
};

}  // namespace

double flatTolerance(const TriangleMesh& mesh) {
  const Box box = mesh.bounds();
  if (box.empty()) {
    return 0.0;
  }
  const double farthest = box.max.cwiseAbs().cwiseMax(box.min.cwiseAbs()).maxCoeff();
  constexpr double kSingle = 0.5 * std::numeric_limits<float>::epsilon();
  return std::max(std::min(kNoise, kNoiseRelative * box.diagonal()),
                  kSingleRoundings * kSingle * farthest);
}

std::vector<std::uint32_t> settleFlats(const TriangleMesh& mesh,
                                       const HalfEdges& halfEdges,
                                       std::span<const double> scalar,
                                       std::span<const double> levels,
                                       const LevelSnap& snap,
                                       std::vector<std::uint32_t>& count) {
  std::vector<std::uint32_t> settled;
  if (snap.flat > 0.0) {
    Flats(mesh, halfEdges, scalar, levels, snap.flat, false).settle(count, settled);
  }
  if (snap.border > snap.flat && !halfEdges.closed()) {
    Flats(mesh, halfEdges, scalar, levels, snap.border, true).settle(count, settled);
  }
  return settled;
}

}  // namespace wcam::geometry
