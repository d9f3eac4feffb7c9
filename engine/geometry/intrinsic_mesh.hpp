// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace wcam::geometry {

/// A triangle by its intrinsic measures: edge c runs from corner c to corner (c+1)%3.
struct FlatTriangle {
  std::array<std::uint32_t, 3> corner{};
  std::array<double, 3> square{};  ///< of the edges' lengths, mm²
  double twiceArea = 0.0;          ///< mm²

  /// Product of the two edges that leave a corner.
  [[nodiscard]] double dotAt(std::uint32_t c) const {
    return 0.5 * (square[c] + square[(c + 2) % 3] - square[(c + 1) % 3]);
  }
};

/// What geodesics need of a surface: its vertices and flat triangles, Delaunay by intrinsic flips
/// where the mesh has slivers (the surface stays the same, its edges become geodesics), the
/// triangles around each vertex, and the curvature at it.
class IntrinsicMesh {
public:
  IntrinsicMesh(const TriangleMesh& mesh, const HalfEdges& halfEdges);

  [[nodiscard]] std::size_t vertexCount() const noexcept { return firstCorner_.size() - 1; }

  [[nodiscard]] const FlatTriangle& triangle(std::uint32_t t) const { return triangles_[t]; }

  /// Corners 3·t+c at a vertex.
  [[nodiscard]] const std::uint32_t* cornersBegin(std::uint32_t v) const {
    return corners_.data() + firstCorner_[v];
  }

  [[nodiscard]] const std::uint32_t* cornersEnd(std::uint32_t v) const {
    return corners_.data() + firstCorner_[v + 1];
  }

  /// Tells the processor that the list of corners at a vertex is wanted soon.
  void prefetchCorners(std::uint32_t v) const { __builtin_prefetch(cornersBegin(v)); }

  /// The same for the triangles around it.
  void prefetchTriangles(std::uint32_t v) const {
    for (const std::uint32_t* it = cornersBegin(v); it != cornersEnd(v); ++it) {
      __builtin_prefetch(&triangles_[*it / 3]);
    }
  }

  /// Gaussian curvature at a vertex of a smooth surface, 1/mm²; 0 on borders and at corners.
  [[nodiscard]] double curvature(std::uint32_t v) const { return curvature_[v]; }

  /// Whether shortest paths may bend at a vertex: borders and saddle corners.
  [[nodiscard]] bool bends(std::uint32_t v) const { return bends_[v] != 0; }

  /// Root mean square of the edges' lengths, mm.
  [[nodiscard]] double typicalEdge() const noexcept { return typicalEdge_; }

  [[nodiscard]] double longestEdge() const noexcept { return longestEdge_; }

  [[nodiscard]] std::size_t flips() const noexcept { return flips_; }

private:
  /// What surrounds a vertex: the sum of its corners' angles and a third of its triangles' area.
  struct Cell {
    double angle = 0.0;
    double area = 0.0;
  };

  std::vector<Cell> layFlat(const TriangleMesh& mesh);
  void flipSlivers(const HalfEdges& halfEdges);
  void collectCorners(std::size_t vertices);
  void findCurvature(const std::vector<Cell>& cells,
                     const HalfEdges& halfEdges,
                     const TriangleMesh& mesh);

  std::vector<FlatTriangle> triangles_;
  std::vector<std::uint32_t> firstCorner_;
  std::vector<std::uint32_t> corners_;
  std::vector<float> curvature_;
  std::vector<std::uint8_t> bends_;
  double typicalEdge_ = 0.0;
  double longestEdge_ = 0.0;
  std::size_t flips_ = 0;
};

}  // namespace wcam::geometry
