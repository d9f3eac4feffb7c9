// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace wcam::geometry {

/// A level curve on a mesh, one node per crossed mesh edge, in the direction t with t × n = ∇φ made
/// tangent (n the outward normal): material and field keep their sides all along.
struct LevelContour {
  bool closed = false;
  std::vector<Vec3> points;  ///< a closed contour does not repeat its first node
  std::vector<std::uint32_t>
      halfEdges;  ///< per node: the half-edge through which it is entered (field rising), whose
                  ///< triangle holds the segment to the next node; at the end of an open contour
                  ///< the half-edge through which it leaves (field falling)
  std::vector<double> fractions;  ///< per node: place on the half-edge, 0 at its start
};

/// How near to a level counts as on it, in the scalar's unit.
struct LevelSnap {
  LevelSnap(double roundingOfValues,  // NOLINT: a number is a rounding
            double ofFlats = 0.0,
            double ofBorders = 0.0)
      : rounding(roundingOfValues), flat(ofFlats), border(ofBorders) {}

  double rounding;  ///< of a single vertex
  double flat;      ///< of a whole face or border; 0: only the rounding counts
  double border;    ///< of a whole border, where that is more
};

/// How far the vertices of a flat face lie off its plane at most, mm: the noise that programs leave
/// (a micrometre, less on small parts), or the rounding of a file in single precision where
/// coordinates are large.
double flatTolerance(const TriangleMesh& mesh);

/// Traces the level curves of a scalar given per vertex: one kernel for planes, guide planes,
/// parameters and distances. `levels` must ascend strictly.
///
/// Every vertex counts the levels at or below its value; an edge then carries one node per level
/// between its ends, and each node knows its successor from the one triangle that it enters: no
/// hash, no sort, no lock. A vertex within `snap` of a level counts as on it, hence above; only a
/// level that is the minimum of the field counts its vertices as below, so that a border or a flat
/// base is itself a contour. Faces and borders that lie on a level within `snap.flat` are decided
/// as a whole, and their vertices become the nodes. At non-manifold edges curves end and are joined
/// pairwise in the order of the half-edges.
///
/// @param scalar one value per vertex; NaN marks a vertex outside the field: its triangles carry no
/// curve
/// @return per level the contours, ordered by the lowest half-edge that they enter; nodes that
/// coincide
///   (a curve through a vertex) appear once. A contour that is a single point keeps one node.
/// Cost: O(vertices·log(levels) + nodes), parallel over slabs of levels; the result does not depend
/// on threads.
std::vector<std::vector<LevelContour>> traceLevels(const TriangleMesh& mesh,
                                                   const HalfEdges& halfEdges,
                                                   std::span<const double> scalar,
                                                   std::span<const double> levels,
                                                   const LevelSnap& snap,
                                                   const JobContext& context = JobContext());

/// Sections by the parallel planes {direction·p = level}: traceLevels of the heights, snapped at
/// 1e-12 of the mesh's size, flats by their tolerance.
std::vector<std::vector<LevelContour>> planeSections(const TriangleMesh& mesh,
                                                     const HalfEdges& halfEdges,
                                                     const Vec3& direction,
                                                     std::span<const double> levels,
                                                     const JobContext& context = JobContext());

}  // namespace wcam::geometry
