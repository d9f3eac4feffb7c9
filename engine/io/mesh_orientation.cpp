// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"

#include "mesh_repair.hpp"

#include <array>
#include <cmath>
#include <numeric>

namespace wcam::io {

using geometry::Box;
using geometry::HalfEdges;
using geometry::TriangleMesh;
using geometry::Vec3;

namespace {

/// Work between two looks at the cancel request.
constexpr std::size_t kCheckInterval = 1 << 18;

/// Union-find whose members also know whether they point the other way than their root.
class ParityForest {
public:
  explicit ParityForest(std::size_t size) : parent_(size), odd_(size, 0) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  struct Found {
    std::uint32_t root;
    bool odd;
  };

  Found find(std::uint32_t v) {
    // Path halving with parity: each step shortens the way to the grandparent.
    bool odd = false;
    while (parent_[v] != v) {
      const std::uint32_t up = parent_[v];
      odd_[v] ^= parent_[up] == up ? 0 : odd_[up];
      parent_[v] = parent_[up];
      odd ^= odd_[v] != 0;
      v = parent_[v];
    }
    return {v, odd};
  }

  /// False when the two are known to be related the other way.
  bool relate(std::uint32_t a, std::uint32_t b, bool opposite) {
    const Found fa = find(a);
    const Found fb = find(b);
    if (fa.root == fb.root) {
      return (fa.odd != fb.odd) == opposite;
    }
    const auto [low, high] = std::minmax(fa.root, fb.root);
    parent_[high] = low;
    odd_[high] = static_cast<std::uint8_t>((fa.odd != fb.odd) != opposite);
    return true;
  }

private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> odd_;
};

/// A piece of the mesh that edges of two triangles join.
struct Piece {
  std::size_t triangles = 0;
  std::size_t oddTriangles = 0;
  bool open = false;
  std::uint32_t firstTriangle = HalfEdges::kNone;
  double volume6 = 0.0;  ///< six times the signed volume, as its root points
  Box box;
  bool turn = false;  ///< even members turn when true, odd ones when false
};

class Orienter {
public:
  Orienter(const TriangleMesh& mesh,
           const HalfEdges& halfEdges,
           const std::vector<std::int32_t>& nodeOf,
           std::size_t nodeCount,
           const std::string& file,
           const JobContext& context)
      : mesh_(mesh),
        halfEdges_(halfEdges),
        nodeOf_(nodeOf),
        file_(file),
        context_(context),
        forest_(nodeCount),
        nodeCount_(nodeCount) {}

  Orientation run() {
    relateTwins();
    relateEqualDirections();
    collectPieces();
    decideTurns();
    return result();
  }

private:
  [[nodiscard]] std::uint32_t nodeOf(std::size_t triangle) const {
    return nodeOf_.empty() ? static_cast<std::uint32_t>(triangle)
                           : static_cast<std::uint32_t>(nodeOf_[triangle]);
  }

  void relate(std::uint32_t h, std::uint32_t g, bool opposite) {
    if (!forest_.relate(nodeOf(h / 3), nodeOf(g / 3), opposite)) {
      const Vec3& p = mesh_.vertices[mesh_.triangles[h / 3][h % 3]];
      const Vec3& q = mesh_.vertices[mesh_.triangles[h / 3][(h + 1) % 3]];
      throw Error(
          ErrorCode::InputInvalid,
          text("the surface has only one side (like a Möbius strip); its normals disagree at %1 mm",
               {positionText(0.5 * (p + q))}),
          file_, "cut the surface there in the CAD system");
    }
  }

  void relateTwins() {
    const auto count = static_cast<std::uint32_t>(3 * mesh_.triangles.size());
    for (std::uint32_t h = 0; h < count; ++h) {
      if (h % kCheckInterval == 0) {
        context_.check();
      }
      const std::uint32_t twin = halfEdges_.twin(h);
      if (twin != HalfEdges::kNone && h < twin) {
        relate(h, twin, false);
      }
    }
  }

  /// Edges of exactly two triangles that run along them in the same direction.
  void relateEqualDirections() {
    paired_.assign(3 * mesh_.triangles.size(), false);
    if (halfEdges_.nonManifoldEdges().empty()) {
      return;
    }
    std::vector<std::array<std::uint32_t, 2>> users(halfEdges_.edgeCount(),
                                                    {HalfEdges::kNone, HalfEdges::kNone});
    std::vector<std::uint32_t> count(halfEdges_.edgeCount(), 0);
    for (std::uint32_t h = 0; h < paired_.size(); ++h) {
      const std::uint32_t edge = halfEdges_.edgeOf(h);
      if (count[edge] < 2) {
        users[edge][count[edge]] = h;
      }
      ++count[edge];
    }
    for (const std::uint32_t edge : halfEdges_.nonManifoldEdges()) {
      if (count[edge] == 2) {
        relate(users[edge][0], users[edge][1], true);
        paired_[users[edge][0]] = true;
        paired_[users[edge][1]] = true;
      }
    }
  }

  void collectPieces() {
    pieceOf_.assign(nodeCount_, HalfEdges::kNone);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto [root, odd] = forest_.find(nodeOf(t));
      std::uint32_t& index = pieceOf_[root];
      if (index == HalfEdges::kNone) {
        index = static_cast<std::uint32_t>(pieces_.size());
        pieces_.emplace_back();
        pieces_.back().firstTriangle = static_cast<std::uint32_t>(t);
      }
      addToPiece(pieces_[index], t, odd);
    }
  }

  void addToPiece(Piece& piece, std::size_t t, bool odd) {
    ++piece.triangles;
    piece.oddTriangles += odd ? 1 : 0;
    const auto& v = mesh_.triangles[t];
    for (std::size_t c = 0; c < 3; ++c) {
      const auto h = static_cast<std::uint32_t>(3 * t + c);
      piece.open = piece.open || (halfEdges_.twin(h) == HalfEdges::kNone && !paired_[h]);
      piece.box.add(mesh_.vertices[v[c]]);
    }
    // Relative to a point of the piece, against cancellation far from the origin.
    const Vec3& o = mesh_.vertices[mesh_.triangles[piece.firstTriangle][0]];
    const Vec3 a = mesh_.vertices[v[0]] - o;
    const Vec3 b = mesh_.vertices[v[1]] - o;
    const Vec3 c = mesh_.vertices[v[2]] - o;
    piece.volume6 += (odd ? -1.0 : 1.0) * a.dot(b.cross(c));
  }

  [[nodiscard]] std::uint32_t pieceOfTriangle(std::size_t t) {
    return pieceOf_[forest_.find(nodeOf(t)).root];
  }

  void decideTurns() {
    for (Piece& piece : pieces_) {
      const std::size_t even = piece.triangles - piece.oddTriangles;
      piece.turn = even < piece.oddTriangles;
    }
    // As they would be left, closed pieces with negative volume are inside out or cavities.
    std::vector<std::uint32_t> closed;
    bool anyNegative = false;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      if (!pieces_[i].open) {
        closed.push_back(i);
        anyNegative = anyNegative || volumeAsLeft(pieces_[i]) < 0.0;
      }
    }
    if (anyNegative) {
      turnOutwards(closed);
    }
  }

  static double volumeAsLeft(const Piece& piece) {
    return piece.turn ? -piece.volume6 : piece.volume6;
  }

  /// Turns outermost closed pieces with negative volume, and all pieces inside them.
  void turnOutwards(const std::vector<std::uint32_t>& closed) {
    std::vector<std::vector<std::uint32_t>> trianglesOf;
    std::vector<bool> outermost(pieces_.size(), true);
    std::vector<std::uint32_t> container(pieces_.size(), HalfEdges::kNone);
    for (const std::uint32_t inner : closed) {
      context_.check();
      for (const std::uint32_t outer : closed) {
        if (outer == inner || !contains(pieces_[outer].box, pieces_[inner].box)) {
          continue;
        }
        if (trianglesOf.empty()) {
          trianglesOf = listTriangles();
        }
        if (inside(trianglesOf[outer], pieces_[inner])) {
          outermost[inner] = false;
          const std::uint32_t known = container[inner];
          if (known == HalfEdges::kNone || contains(pieces_[outer].box, pieces_[known].box)) {
            container[inner] = outer;
          }
        }
      }
    }
    std::vector<bool> turn(pieces_.size(), false);
    for (const std::uint32_t i : closed) {
      turn[i] = outermost[i] && volumeAsLeft(pieces_[i]) < 0.0;
    }
    for (const std::uint32_t i : closed) {
      if (turn[i] || (!outermost[i] && turn[container[i]])) {
        pieces_[i].turn = !pieces_[i].turn;
      }
    }
  }

  static bool contains(const Box& outer, const Box& inner) {
    return (outer.min.array() <= inner.min.array()).all() &&
           (outer.max.array() >= inner.max.array()).all();
  }

  std::vector<std::vector<std::uint32_t>> listTriangles() {
    std::vector<std::vector<std::uint32_t>> lists(pieces_.size());
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      lists[pieceOfTriangle(t)].push_back(t);
    }
    return lists;
  }

  /// By the winding number (sum of solid angles), which no degenerate position upsets.
  [[nodiscard]] bool inside(const std::vector<std::uint32_t>& triangles, const Piece& piece) {
    const Vec3& p = mesh_.vertices[mesh_.triangles[piece.firstTriangle][0]];
    double angle = 0.0;
    std::size_t work = 0;
    for (const std::uint32_t t : triangles) {
      if (++work % kCheckInterval == 0) {
        context_.check();
      }
      const auto& v = mesh_.triangles[t];
      const Vec3 a = mesh_.vertices[v[0]] - p;
      const Vec3 b = mesh_.vertices[v[1]] - p;
      const Vec3 c = mesh_.vertices[v[2]] - p;
      const double la = a.norm();
      const double lb = b.norm();
      const double lc = c.norm();
      const double below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
      const double half = std::atan2(a.dot(b.cross(c)), below);
      angle += forest_.find(nodeOf(t)).odd ? -2.0 * half : 2.0 * half;
    }
    constexpr double kHalfTurn = 6.283185307179586;  // half of the full solid angle 4π
    return std::abs(angle) > kHalfTurn;
  }

  Orientation result() {
    Orientation orientation;
    orientation.components = pieces_.size();
    orientation.flipNode.assign(nodeCount_, false);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto [root, odd] = forest_.find(nodeOf(t));
      if (odd != pieces_[pieceOf_[root]].turn) {
        orientation.flipNode[nodeOf(t)] = true;
        if (orientation.flippedTriangles++ == 0) {
          orientation.first = mesh_.vertices[mesh_.triangles[t][0]];
        }
      }
    }
    return orientation;
  }

  const TriangleMesh& mesh_;
  const HalfEdges& halfEdges_;
  const std::vector<std::int32_t>& nodeOf_;
  const std::string& file_;
  const JobContext& context_;
  ParityForest forest_;
  std::size_t nodeCount_;
  std::vector<bool> paired_;            ///< half-edges of two-triangle edges without twin
  std::vector<std::uint32_t> pieceOf_;  ///< per root node
  std::vector<Piece> pieces_;
};

}  // namespace

Orientation findOrientation(const TriangleMesh& mesh,
                            const HalfEdges& halfEdges,
                            const std::vector<std::int32_t>& nodeOf,
                            std::size_t nodeCount,
                            const std::string& file,
                            const JobContext& context) {
  return Orienter(mesh, halfEdges, nodeOf, nodeCount, file, context).run();
}

}  // namespace wcam::io
