// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/mesh.hpp"
#include "wcam/geometry/surface_point.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace wcam::geometry {

/// Where distances start: vertices, points inside triangles and polylines on the surface, each with
/// an offset (the distance that it has itself). Segments of a polyline must lie in one triangle
/// each, as level curves and border loops do.
struct GeodesicSource {
  std::vector<std::uint32_t> vertices;
  std::vector<MeshPoint> points;
  std::vector<std::vector<MeshPoint>> curves;  ///< consecutive points share a triangle
  std::vector<std::uint32_t> borderEdges;      ///< half-edges that are wholly source
};

/// Geodesic distance by propagation with virtual sources (Trettner, Bommes, Kobbelt 2021): every
/// vertex keeps the unfolded place of its source, so that distances behind a point source are
/// straight lines, not planar fronts; boundaries and saddles start new sources. Slivers and obtuse
/// corners are handled by intrinsic unfolding.
///
/// A solver holds the one-ring tables of one mesh; distance() is const and thread-safe.
class GeodesicSolver {
public:
  GeodesicSolver(const TriangleMesh& mesh, const HalfEdges& halfEdges);
  ~GeodesicSolver();
  GeodesicSolver(GeodesicSolver&&) noexcept;
  GeodesicSolver& operator=(GeodesicSolver&&) noexcept;

  /// Distance of every vertex, mm; infinity where no path leads (another component) or beyond
  /// `limit`. Cost: about 0.2 µs per vertex.
  /// @throws Error(InvalidArgument) when the source is empty or does not lie on the mesh
  [[nodiscard]] std::vector<double> distance(const GeodesicSource& source,
                                             double limit = std::numeric_limits<double>::infinity(),
                                             const JobContext& context = JobContext()) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Smooth distance by the heat method (Crane 2013; Diourté M16, Annex A): factorised once, many
/// sources. Time step t = m·h², h the mean edge length; more on parts so long that the heat would
/// fall below the least number. At borders without a source the mean of the Neumann and the
/// Dirichlet solution is taken. distance() is const and thread-safe.
class HeatSolver {
public:
  /// @throws Error(InvalidArgument) for a time factor that is not positive, Error(JobFailed) when
  /// the mesh is too degenerate. Cost: two sparse factorisations.
  HeatSolver(const TriangleMesh& mesh, const HalfEdges& halfEdges, double timeFactor = 1.0);
  ~HeatSolver();
  HeatSolver(HeatSolver&&) noexcept;
  HeatSolver& operator=(HeatSolver&&) noexcept;
  /// Distance of every vertex, mm, with mean zero over the sources of each component; infinity in
  /// components without a source. @throws Error(InvalidArgument) when there is no source
  [[nodiscard]] std::vector<double> distance(
      const std::vector<std::uint32_t>& sourceVertices) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Exact distances and paths on a polyhedron (Xin and Wang, by CGAL): the oracle of tests, and for
/// single paths. For one thread at a time. Cost: seconds at 100 000 triangles.
class ExactGeodesics {
public:
  /// @throws Error(InvalidArgument) when there is no source, or for meshes with triangles without
  /// area, non-manifold edges or vertices
  ExactGeodesics(const TriangleMesh& mesh, const std::vector<std::uint32_t>& sourceVertices);
  ~ExactGeodesics();
  ExactGeodesics(ExactGeodesics&&) noexcept;
  ExactGeodesics& operator=(ExactGeodesics&&) noexcept;
  /// mm; infinity where no path leads.
  [[nodiscard]] double distance(std::uint32_t vertex) const;
  /// Points from the vertex to the nearest source; empty where no path leads.
  [[nodiscard]] std::vector<Vec3> path(std::uint32_t vertex) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The shortest path from a point back to the source of a distance field: steepest descent through
/// the triangles, along edges where the field has a valley. Begins at `from`, ends where the field
/// has its minimum. Consecutive points share a triangle. Cost: O(triangles crossed).
std::vector<MeshPoint> descend(const TriangleMesh& mesh,
                               const HalfEdges& halfEdges,
                               const std::vector<double>& field,
                               const MeshPoint& from);

}  // namespace wcam::geometry
