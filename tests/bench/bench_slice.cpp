// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plane sections of large meshes: the edge topology and planeSections against CGAL's
// Polygon_mesh_slicer with its Surface_mesh and its tree. Both sides start from the same arrays of
// vertices and triangles in every repetition. Loops and areas of each layer are compared; a run
// that does not agree fails.

#include "wcam/base/parallel.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/geometry/level_set.hpp"

#include "timing.hpp"
#include <CGAL/AABB_halfedge_graph_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using wcam::bench::Times;
using wcam::geometry::HalfEdges;
using wcam::geometry::LevelContour;
using wcam::geometry::TriangleMesh;
using wcam::geometry::Vec3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Primitive = CGAL::AABB_halfedge_graph_segment_primitive<CgalMesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using Polylines = std::vector<std::vector<Kernel::Point_3>>;

constexpr const char* kGoal = "goal 10";
constexpr const char* kNoGoal = "for information";
constexpr double kAreaAgreement = 1e-5;  // relative
constexpr std::size_t kPlanes = 500;
constexpr int kRepetitions = 5;

/// A torus with waves on it, tilted so that no edge lies in a plane; nearly isotropic triangles.
TriangleMesh bumpyTorus(std::size_t triangles) {
  constexpr double kBig = 60.0;
  constexpr double kSmall = 24.0;
  const double rows = std::sqrt(0.5 * static_cast<double>(triangles) * kSmall / kBig);
  const auto around = static_cast<std::uint32_t>(std::lround(rows));
  const auto along = static_cast<std::uint32_t>(
      std::lround(0.5 * static_cast<double>(triangles) / static_cast<double>(around)));
  const Eigen::Matrix3d tilt =
      (Eigen::AngleAxisd(0.7, Vec3::UnitX()) * Eigen::AngleAxisd(0.4, Vec3::UnitY()))
          .toRotationMatrix();
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < along; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const double u = 2.0 * wcam::kPi * i / along;
      const double v = 2.0 * wcam::kPi * j / around;
      const double r = kSmall + 1.5 * std::sin(9.0 * u) * std::cos(5.0 * v);
      const double rho = kBig + r * std::cos(v);
      mesh.vertices.push_back(tilt * Vec3(rho * std::cos(u), rho * std::sin(u), r * std::sin(v)));
    }
  }
  const auto index = [&](std::uint32_t i, std::uint32_t j) {
    return (i % along) * around + j % around;
  };
  for (std::uint32_t i = 0; i < along; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return mesh;
}

/// Fisher–Yates by hand: std::shuffle differs between libraries.
template <class T>
void shuffle(std::vector<T>& items, std::mt19937_64& random) {
  for (std::size_t i = items.size(); i > 1; --i) {
    std::swap(items[i - 1], items[random() % i]);
  }
}

/// The same surface with vertices and triangles in random order.
TriangleMesh shuffled(const TriangleMesh& mesh) {
  std::mt19937_64 random(20261122);
  std::vector<std::uint32_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  shuffle(order, random);
  TriangleMesh result;
  result.vertices.resize(mesh.vertices.size());
  for (std::size_t v = 0; v < order.size(); ++v) {
    result.vertices[order[v]] = mesh.vertices[v];
  }
  result.triangles = mesh.triangles;
  for (auto& triangle : result.triangles) {
    for (std::uint32_t& v : triangle) {
      v = order[v];
    }
  }
  shuffle(result.triangles, random);
  return result;
}

/// Heights of planes in the middle of equal slabs.
std::vector<double> middleLevels(const TriangleMesh& mesh, std::size_t count) {
  const auto bounds = mesh.bounds();
  const double low = bounds.min.z();
  const double step = (bounds.max.z() - low) / static_cast<double>(count);
  std::vector<double> levels;
  for (std::size_t k = 0; k < count; ++k) {
    levels.push_back(low + (static_cast<double>(k) + 0.5) * step);
  }
  return levels;
}

std::vector<std::vector<LevelContour>> sliceOwn(const TriangleMesh& mesh,
                                                const std::vector<double>& levels) {
  const HalfEdges halfEdges(mesh);
  return planeSections(mesh, halfEdges, Vec3::UnitZ(), levels);
}

std::vector<Polylines> sliceCgal(const TriangleMesh& mesh, const std::vector<double>& levels) {
  CgalMesh surface;
  const auto vertices = static_cast<CgalMesh::size_type>(mesh.vertices.size());
  const auto faces = static_cast<CgalMesh::size_type>(mesh.triangles.size());
  surface.reserve(vertices, 3 * faces / 2, faces);
  for (const Vec3& p : mesh.vertices) {
    surface.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  }
  for (const auto& t : mesh.triangles) {
    surface.add_face(CgalMesh::Vertex_index(t[0]), CgalMesh::Vertex_index(t[1]),
                     CgalMesh::Vertex_index(t[2]));
  }
  Tree tree(edges(surface).first, edges(surface).second, surface);
  const CGAL::Polygon_mesh_slicer<CgalMesh, Kernel> slicer(surface, tree);
  std::vector<Polylines> layers(levels.size());
  for (std::size_t k = 0; k < levels.size(); ++k) {
    slicer(Kernel::Plane_3(0, 0, 1, -levels[k]), std::back_inserter(layers[k]));
  }
  return layers;
}

struct Layer {
  std::size_t closed = 0;
  std::size_t open = 0;
  std::size_t nodes = 0;
  double area = 0.0;  ///< sum of the loops' areas without sign, since CGAL's have no direction
};

/// @param pointAt k -> {x, y}
template <class PointAt>
double shoelaceArea(std::size_t count, const PointAt& pointAt) {
  double twice = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto [x0, y0] = pointAt(k);
    const auto [x1, y1] = pointAt(k + 1 < count ? k + 1 : 0);
    twice += x0 * y1 - x1 * y0;
  }
  return std::abs(0.5 * twice);
}

std::vector<Layer> summary(const std::vector<std::vector<LevelContour>>& layers) {
  std::vector<Layer> result;
  for (const auto& contours : layers) {
    Layer layer;
    for (const LevelContour& contour : contours) {
      ++(contour.closed ? layer.closed : layer.open);
      layer.nodes += contour.points.size();
      layer.area += shoelaceArea(contour.points.size(), [&](std::size_t k) {
        return std::pair(contour.points[k].x(), contour.points[k].y());
      });
    }
    result.push_back(layer);
  }
  return result;
}

std::vector<Layer> summary(const std::vector<Polylines>& layers) {
  std::vector<Layer> result;
  for (const Polylines& polylines : layers) {
    Layer layer;
    for (const auto& polyline : polylines) {
      const bool closed = polyline.front() == polyline.back();
      ++(closed ? layer.closed : layer.open);
      const std::size_t nodes = polyline.size() - (closed ? 1U : 0U);
      layer.nodes += nodes;
      layer.area += shoelaceArea(
          nodes, [&](std::size_t k) { return std::pair(polyline[k].x(), polyline[k].y()); });
    }
    result.push_back(layer);
  }
  return result;
}

struct Agreement {
  std::size_t layersApart = 0;  ///< with another number of loops
  double worstArea = 0.0;       ///< relative
  std::size_t loops = 0;
  std::size_t nodes = 0;

  [[nodiscard]] bool holds() const { return layersApart == 0 && worstArea <= kAreaAgreement; }
};

Agreement compare(const std::vector<Layer>& own, const std::vector<Layer>& anchor) {
  Agreement result;
  for (std::size_t k = 0; k < own.size(); ++k) {
    result.layersApart +=
        own[k].closed != anchor[k].closed || own[k].open != anchor[k].open ? 1U : 0U;
    const double scale = std::max(own[k].area, anchor[k].area);
    if (scale > 0.0) {
      result.worstArea = std::max(result.worstArea, std::abs(own[k].area - anchor[k].area) / scale);
    }
    result.loops += own[k].closed + own[k].open;
    result.nodes += own[k].nodes;
  }
  return result;
}

void print(const char* side, const Times& times, std::size_t nodes) {
  std::printf("  %-24s min %8.4f s, median %8.4f s, first %8.4f s, %7.1f ns/node\n", side,
              times.min(), times.median(), times.first(),
              times.min() * 1e9 / static_cast<double>(nodes));
}

/// @return whether both sides agree
bool runCase(const std::string& name, const std::string& goal, const TriangleMesh& mesh) {
  const std::vector<double> levels = middleLevels(mesh, kPlanes);
  Times one, all, topology, cgal;
  Agreement agreement;
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    std::vector<Layer> own, ownAll;
    {
      const wcam::ThreadLimit limit(1);
      own = summary(one.measure([&] { return sliceOwn(mesh, levels); }));
      topology.measure([&] { return HalfEdges(mesh); });
    }
    ownAll = summary(all.measure([&] { return sliceOwn(mesh, levels); }));
    const std::vector<Layer> anchor =
        summary(cgal.measure([&] { return sliceCgal(mesh, levels); }));
    const Agreement now = compare(own, anchor);
    if (repetition == 0 || !now.holds()) {
      agreement = now;
    }
    if (const Agreement threads = compare(ownAll, anchor); !threads.holds()) {
      agreement = threads;
    }
  }
  std::printf("%s: %zu triangles x %zu planes, %zu loops, %zu nodes\n", name.c_str(),
              mesh.triangles.size(), levels.size(), agreement.loops, agreement.nodes);
  print("own, 1 thread", one, agreement.nodes);
  print("  of which topology", topology, agreement.nodes);
  print("own, all threads", all, agreement.nodes);
  print("CGAL (has no threads)", cgal, agreement.nodes);
  std::printf("  ratio %.1f (medians %.1f), all threads %.1f (medians %.1f), %s; %s\n",
              cgal.min() / one.min(), cgal.median() / one.median(), cgal.min() / all.min(),
              cgal.median() / all.median(), goal.c_str(), name.c_str());
  std::printf("  layers with other loops %zu, worst area difference %.1e\n", agreement.layersApart,
              agreement.worstArea);
  if (!agreement.holds()) {
    std::printf("  the results do not agree: the run is invalid\n");
  }
  return agreement.holds();
}

}  // namespace

int main() {
  const TriangleMesh million = bumpyTorus(1'000'000);
  bool agree = runCase("torus 1M", kGoal, million);
  agree = runCase("torus 1M, shuffled", kNoGoal, shuffled(million)) && agree;
  agree = runCase("torus 100k", kNoGoal, bumpyTorus(100'000)) && agree;
  return agree ? 0 : 1;
}
