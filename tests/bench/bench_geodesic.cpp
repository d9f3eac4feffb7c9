// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesic distance from one vertex of large meshes: GeodesicSolver (tables and propagation, one
// thread) against CGAL's Heat_method_3 (factorisation and solution). Errors are against the exact
// solver at 100 000 triangles and against closed forms at a million; a run in which the own result
// is off fails.

#include "wcam/base/parallel.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/geometry/geodesic.hpp"

#include "timing.hpp"
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace {

using wcam::bench::Times;
using wcam::geometry::ExactGeodesics;
using wcam::geometry::GeodesicSolver;
using wcam::geometry::GeodesicSource;
using wcam::geometry::HalfEdges;
using wcam::geometry::TriangleMesh;
using wcam::geometry::Vec3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr int kRepetitions = 5;
constexpr double kMeanAllowed = 2e-3;   // PERFORMANCE: mean error at most 0.2 %
constexpr double kWorstAllowed = 2e-2;  // and worst at most 2 %

/// Rows and columns of a surface that is closed in the second direction, and in the first if asked.
TriangleMesh ring(std::uint32_t rows,
                  std::uint32_t around,
                  bool closed,
                  const std::function<Vec3(double, double)>& at) {
  TriangleMesh mesh;
  const std::uint32_t last = closed ? rows : rows + 1;
  for (std::uint32_t i = 0; i < last; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      mesh.vertices.push_back(at(static_cast<double>(i) / rows, static_cast<double>(j) / around));
    }
  }
  const auto id = [&](std::uint32_t i, std::uint32_t j) {
    return (closed ? i % rows : i) * around + j % around;
  };
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return mesh;
}

TriangleMesh torus(std::uint32_t rows, std::uint32_t around) {
  return ring(rows, around, true, [](double s, double t) {
    const double u = 2.0 * wcam::kPi * s;
    const double v = 2.0 * wcam::kPi * t;
    const double rho = 60.0 + 24.0 * std::cos(v);
    return Vec3(rho * std::cos(u), rho * std::sin(u), 24.0 * std::sin(v));
  });
}

constexpr double kTubeRadius = 40.0;
constexpr double kTubeHeight = 250.0;

TriangleMesh tube(std::uint32_t rows, std::uint32_t around) {
  return ring(rows, around, false, [](double s, double t) {
    const double v = 2.0 * wcam::kPi * t;
    return Vec3(kTubeRadius * std::cos(v), kTubeRadius * std::sin(v), kTubeHeight * s);
  });
}

std::vector<double> ownDistance(const TriangleMesh& mesh,
                                const HalfEdges& halfEdges,
                                std::uint32_t from) {
  const GeodesicSolver solver(mesh, halfEdges);
  GeodesicSource source;
  source.vertices = {from};
  return solver.distance(source);
}

CgalMesh toCgal(const TriangleMesh& mesh) {
  CgalMesh surface;
  for (const Vec3& p : mesh.vertices) {
    surface.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  }
  for (const auto& t : mesh.triangles) {
    surface.add_face(CgalMesh::Vertex_index(t[0]), CgalMesh::Vertex_index(t[1]),
                     CgalMesh::Vertex_index(t[2]));
  }
  return surface;
}

std::vector<double> cgalHeat(CgalMesh& surface, std::uint32_t from) {
  auto map = surface.add_property_map<CgalMesh::Vertex_index, double>("v:distance", 0.0).first;
  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<CgalMesh, CGAL::Heat_method_3::Direct>
      heat(surface);
  heat.add_source(CgalMesh::Vertex_index(from));
  heat.estimate_geodesic_distances(map);
  std::vector<double> distance;
  for (const auto v : surface.vertices()) {
    distance.push_back(map[v]);
  }
  return distance;
}

struct Error {
  double mean = 0.0;
  double worst = 0.0;
};

Error errorOf(const std::vector<double>& distance, const std::vector<double>& truth) {
  Error error;
  std::size_t count = 0;
  for (std::size_t v = 0; v < distance.size(); ++v) {
    if (truth[v] > 0.0) {
      const double e = std::abs(distance[v] / truth[v] - 1.0);
      error.mean += e;
      error.worst = std::max(error.worst, e);
      ++count;
    }
  }
  error.mean /= static_cast<double>(count);
  return error;
}

void print(const char* side, const Times& times, const Error& error) {
  std::printf("  %-22s min %9.4f s, first %9.4f s, error mean %.4f %%, worst %.3f %%\n", side,
              times.min(), times.first(), 100.0 * error.mean, 100.0 * error.worst);
}

/// @return whether the own result is right
bool runCase(const std::string& name,
             const std::string& goal,
             const TriangleMesh& mesh,
             std::uint32_t from,
             const std::vector<double>& truth) {
  const wcam::ThreadLimit limit(1);
  const HalfEdges halfEdges(mesh);
  Times own, heat;
  std::vector<double> distance;
  CgalMesh surface = toCgal(mesh);
  std::vector<double> other;
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    distance = own.measure([&] { return ownDistance(mesh, halfEdges, from); });
    if (repetition == 0) {
      other = heat.measure([&] { return cgalHeat(surface, from); });
    }
  }
  const Error mine = errorOf(distance, truth);
  std::printf("%s: %zu triangles\n", name.c_str(), mesh.triangles.size());
  print("own, tables and all", own, mine);
  print("CGAL heat, first query", heat, errorOf(other, truth));
  std::printf("  ratio %.0f, %.0f ns per vertex, %s\n", heat.min() / own.min(),
              own.min() * 1e9 / static_cast<double>(mesh.vertices.size()), goal.c_str());
  const bool right = mine.mean <= kMeanAllowed && mine.worst <= kWorstAllowed;
  if (!right) {
    std::printf("  the result is wrong: the run is invalid\n");
  }
  return right;
}

std::vector<double> exactDistances(const TriangleMesh& mesh, std::uint32_t from) {
  const ExactGeodesics exact(mesh, {from});
  std::vector<double> truth;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    truth.push_back(exact.distance(v));
  }
  return truth;
}

/// Distances on the unrolled tube.
std::vector<double> tubeDistances(const TriangleMesh& mesh, std::uint32_t from) {
  const Vec3& a = mesh.vertices[from];
  std::vector<double> truth;
  for (const Vec3& p : mesh.vertices) {
    const double turn = std::atan2(a.x() * p.y() - a.y() * p.x(), a.x() * p.x() + a.y() * p.y());
    truth.push_back(std::hypot(kTubeRadius * turn, p.z() - a.z()));
  }
  return truth;
}

}  // namespace

int main() {
  const TriangleMesh small = torus(353, 141);
  bool right = runCase("torus 100k, against the exact solver", "for information", small, 0,
                       exactDistances(small, 0));
  const TriangleMesh million = tube(706, 708);
  const std::uint32_t middle = 353 * 708 + 17;
  right = runCase("tube 1M, against the unrolled tube", "goal 50, at most 0.2 s", million, middle,
                  tubeDistances(million, middle)) &&
          right;
  return right ? 0 : 1;
}
