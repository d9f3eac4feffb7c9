// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Level sets of a geodesic distance on a mesh of a million triangles, as chained polylines:
// traceLevels against vtkContourFilter with vtkStripper. The total length of the curves is
// compared; a run that does not agree fails.

#include "wcam/base/parallel.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/geometry/geodesic.hpp"
#include "wcam/geometry/level_set.hpp"

#include "timing.hpp"
#include "vtk_contour.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

using wcam::bench::Times;
using wcam::bench::VtkContourer;
using wcam::bench::VtkContours;
using wcam::geometry::HalfEdges;
using wcam::geometry::LevelContour;
using wcam::geometry::TriangleMesh;
using wcam::geometry::Vec3;

constexpr std::size_t kLevels = 500;
constexpr int kOwnRepetitions = 5;
constexpr double kLengthAgreement = 1e-6;  // relative

TriangleMesh torus(std::uint32_t rows, std::uint32_t around) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const double u = 2.0 * wcam::kPi * i / rows;
      const double v = 2.0 * wcam::kPi * j / around;
      const double rho = 60.0 + 24.0 * std::cos(v);
      mesh.vertices.emplace_back(rho * std::cos(u), rho * std::sin(u), 24.0 * std::sin(v));
    }
  }
  const auto id = [&](std::uint32_t i, std::uint32_t j) {
    return (i % rows) * around + j % around;
  };
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return mesh;
}

VtkContours measure(const std::vector<std::vector<LevelContour>>& layers) {
  VtkContours result;
  for (const auto& contours : layers) {
    for (const LevelContour& contour : contours) {
      ++result.polylines;
      result.points += contour.points.size();
      for (std::size_t i = 1; i < contour.points.size(); ++i) {
        result.length += (contour.points[i] - contour.points[i - 1]).norm();
      }
      if (contour.closed) {
        result.length += (contour.points.front() - contour.points.back()).norm();
      }
    }
  }
  return result;
}

VtkContourer makeVtk(const TriangleMesh& mesh, const std::vector<double>& scalar) {
  std::vector<double> positions;
  std::vector<unsigned> triangles;
  for (const Vec3& p : mesh.vertices) {
    positions.insert(positions.end(), p.data(), p.data() + 3);
  }
  for (const auto& t : mesh.triangles) {
    triangles.insert(triangles.end(), t.begin(), t.end());
  }
  return {positions, triangles, scalar};
}

}  // namespace

int main() {
  const TriangleMesh mesh = torus(1118, 447);
  const HalfEdges halfEdges(mesh);
  wcam::geometry::GeodesicSource source;
  source.vertices = {0};
  const std::vector<double> field =
      wcam::geometry::GeodesicSolver(mesh, halfEdges).distance(source);
  const double farthest = *std::max_element(field.begin(), field.end());
  std::vector<double> levels;
  for (std::size_t k = 0; k < kLevels; ++k) {
    levels.push_back(farthest * (static_cast<double>(k) + 0.5) / kLevels);
  }
  VtkContourer vtk = makeVtk(mesh, field);
  const wcam::ThreadLimit limit(1);
  Times own, anchor;
  VtkContours mine;
  for (int repetition = 0; repetition < kOwnRepetitions; ++repetition) {
    const auto layers = own.measure(
        [&] { return wcam::geometry::traceLevels(mesh, halfEdges, field, levels, 0.0); });
    mine = measure(layers);
  }
  anchor.measure([&] {
    vtk.run(levels);
    return 0;
  });
  const VtkContours other = vtk.measure();
  const double apart = std::abs(mine.length - other.length) / other.length;
  std::printf("%zu triangles x %zu levels of the distance from a vertex\n", mesh.triangles.size(),
              kLevels);
  std::printf("  own, 1 thread   min %8.4f s, first %8.4f s, %zu curves, %zu points\n", own.min(),
              own.first(), mine.polylines, mine.points);
  std::printf("  VTK             %8.4f s, %zu polylines, %zu points\n", anchor.min(),
              other.polylines, other.points);
  std::printf("  ratio %.0f, goal 50; lengths differ by %.1e\n", anchor.min() / own.min(), apart);
  if (!(apart <= kLengthAgreement)) {
    std::printf("  the results do not agree: the run is invalid\n");
    return 1;
  }
  return 0;
}
