// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/types.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace wcam::geometry {

/// Indexed triangles, counter-clockwise seen from outside (the material's outward side, or the side
/// that an open shell's normal points to). Lengths in mm.
struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  [[nodiscard]] Box bounds() const;
  /// Unit normal of a triangle; zero for a degenerate one.
  [[nodiscard]] Vec3 normal(std::size_t triangle) const;
};

/// Half-edge structure of a mesh. Half-edge 3·t+c runs from corner c to corner (c+1)%3 of triangle
/// t.
///
/// An edge with more than two triangles, or with two triangles of equal direction, is non-manifold:
/// its half-edges have no twin, so that every traversal treats it as a border.
class HalfEdges {
public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  HalfEdges() = default;
  /// O(n): edges by counting sort on their lower vertex, no hashing.
  explicit HalfEdges(const TriangleMesh& mesh);

  [[nodiscard]] std::size_t edgeCount() const noexcept { return edgeVertices_.size(); }

  /// Vertices of an edge, lower index first.
  [[nodiscard]] const std::array<std::uint32_t, 2>& edgeVertices(std::uint32_t edge) const {
    return edgeVertices_[edge];
  }

  [[nodiscard]] std::uint32_t edgeOf(std::uint32_t halfEdge) const { return edgeOf_[halfEdge]; }

  /// The opposite half-edge, or kNone on a border.
  [[nodiscard]] std::uint32_t twin(std::uint32_t halfEdge) const { return twin_[halfEdge]; }

  /// One half-edge of the edge.
  [[nodiscard]] std::uint32_t halfEdgeOf(std::uint32_t edge) const { return firstHalfEdge_[edge]; }

  [[nodiscard]] const std::vector<std::uint32_t>& nonManifoldEdges() const noexcept {
    return nonManifoldEdges_;
  }

  [[nodiscard]] bool closed() const noexcept { return borderEdgeCount_ == 0; }

  [[nodiscard]] std::size_t borderEdgeCount() const noexcept { return borderEdgeCount_; }

  /// Border loops as vertex indices, each in the direction of its half-edges. Ordered by lowest
  /// half-edge.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> borderLoops(const TriangleMesh& mesh) const;

private:
  std::vector<std::array<std::uint32_t, 2>> edgeVertices_;
  std::vector<std::uint32_t> edgeOf_;
  std::vector<std::uint32_t> twin_;
  std::vector<std::uint32_t> firstHalfEdge_;
  std::vector<std::uint32_t> nonManifoldEdges_;
  std::size_t borderEdgeCount_ = 0;
};

}  // namespace wcam::geometry
