// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/geodesic.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <iterator>
#include <limits>

namespace wcam::geometry {

namespace {

constexpr const char* kPlace = "exact distance";

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using ShortestPath =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;
using Vertex = boost::graph_traits<Mesh>::vertex_descriptor;

/// Vertex i of the result is vertex i of the mesh. @throws Error(InvalidArgument)
Mesh toCgal(const TriangleMesh& mesh) {
  Mesh result;
  for (const Vec3& p : mesh.vertices) {
    result.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const bool flat =
        CGAL::collinear(result.point(Vertex(a)), result.point(Vertex(b)), result.point(Vertex(c)));
    if (flat || result.add_face(Vertex(a), Vertex(b), Vertex(c)) == Mesh::null_face()) {
      const Vec3& p = mesh.vertices[a];
      throw Error(ErrorCode::InvalidArgument,
                  text(flat ? "a triangle without area at %1, %2, %3"
                            : "a non-manifold edge or vertex at %1, %2, %3",
                       {formatFixed(p.x(), 3), formatFixed(p.y(), 3), formatFixed(p.z(), 3)}),
                  kPlace, "repair the mesh, or use the propagated distance");
    }
  }
  return result;
}

}  // namespace

struct ExactGeodesics::Impl {
  Mesh mesh;
  ShortestPath search;

  explicit Impl(const TriangleMesh& triangles) : mesh(toCgal(triangles)), search(mesh) {}

  [[nodiscard]] Vertex vertex(std::uint32_t v) const {
    if (v >= mesh.number_of_vertices()) {
      throw Error(ErrorCode::InvalidArgument, text("there is no vertex %1", {std::to_string(v)}),
                  kPlace);
    }
    return Vertex(v);
  }
};

ExactGeodesics::ExactGeodesics(const TriangleMesh& mesh,
                               const std::vector<std::uint32_t>& sourceVertices)
    : impl_(std::make_unique<Impl>(mesh)) {
  if (sourceVertices.empty()) {
    throw Error(ErrorCode::InvalidArgument, "no vertex is a source", kPlace,
                "choose a border or points of the part");
  }
  for (const std::uint32_t v : sourceVertices) {
    const Vertex vertex = impl_->vertex(v);
    if (!impl_->mesh.is_isolated(vertex)) {
      impl_->search.add_source_point(vertex);
    }
  }
  if (impl_->search.number_of_source_points() > 0) {
    impl_->search.build_sequence_tree();
  }
}

ExactGeodesics::~ExactGeodesics() = default;
ExactGeodesics::ExactGeodesics(ExactGeodesics&&) noexcept = default;
ExactGeodesics& ExactGeodesics::operator=(ExactGeodesics&&) noexcept = default;

double ExactGeodesics::distance(std::uint32_t vertex) const {
  const Vertex v = impl_->vertex(vertex);
  if (impl_->mesh.is_isolated(v) || impl_->search.number_of_source_points() == 0) {
    return std::numeric_limits<double>::infinity();
  }
  const double distance = impl_->search.shortest_distance_to_source_points(v).first;
  return distance < 0.0 ? std::numeric_limits<double>::infinity() : distance;
}

std::vector<Vec3> ExactGeodesics::path(std::uint32_t vertex) const {
  std::vector<Vec3> result;
  if (distance(vertex) == std::numeric_limits<double>::infinity()) {
    return result;
  }
  std::vector<Kernel::Point_3> points;
  impl_->search.shortest_path_points_to_source_points(Vertex(vertex), std::back_inserter(points));
  for (const Kernel::Point_3& p : points) {
    const Vec3 q(p.x(), p.y(), p.z());
    if (result.empty() || (q - result.back()).norm() > 0.0) {
      result.push_back(q);
    }
  }
  return result;
}

}  // namespace wcam::geometry
