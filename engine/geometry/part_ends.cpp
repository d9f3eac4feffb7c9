// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/part_ends.hpp"

#include "wcam/geometry/geodesic.hpp"
#include "wcam/geometry/harmonic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::geometry {

namespace {

/// Borders of legs that stand on one plate differ by less than this part of the part's height.
constexpr double kSameLevel = 0.02;
/// A border shorter than this part of the longest one is a hole, not an end.
constexpr double kHole = 0.1;
/// Rounding of heights, in parts of the part's height.
constexpr double kFlat = 1e-6;

struct Loop {
  double length = 0.0;
  double height = 0.0;  ///< mean over its length
};

Loop measure(const TriangleMesh& mesh, const std::vector<std::uint32_t>& vertices, const Vec3& up) {
  Loop loop;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3& a = mesh.vertices[vertices[i]];
    const Vec3& b = mesh.vertices[vertices[(i + 1) % vertices.size()]];
    loop.length += (b - a).norm();
    loop.height += (b - a).norm() * 0.5 * up.dot(a + b);
  }
  loop.height = loop.length > 0.0 ? loop.height / loop.length : up.dot(mesh.vertices[vertices[0]]);
  return loop;
}

/// Least and greatest height of the vertices that triangles use.
std::pair<double, double> heightRange(const TriangleMesh& mesh, const Vec3& up) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      low = std::min(low, up.dot(mesh.vertices[v]));
      high = std::max(high, up.dot(mesh.vertices[v]));
    }
  }
  return {low, high};
}

std::vector<double> distanceFrom(const TriangleMesh& mesh,
                                 const HalfEdges& halfEdges,
                                 const std::vector<std::uint32_t>& sources) {
  std::vector<double> field = HeatSolver(mesh, halfEdges).distance(sources);
  for (double& value : field) {
    value = std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
  }
  return field;
}

}  // namespace

PartEnds partEnds(const TriangleMesh& mesh, const HalfEdges& halfEdges, const Vec3& up) {
  PartEnds ends;
  const std::vector<std::vector<std::uint32_t>> loops = halfEdges.borderLoops(mesh);
  std::vector<Loop> measures;
  double longest = 0.0;
  for (const auto& loop : loops) {
    measures.push_back(measure(mesh, loop, up));
    longest = std::max(longest, measures.back().length);
  }
  double lowest = std::numeric_limits<double>::infinity();
  for (const Loop& loop : measures) {
    if (loop.length >= kHole * longest) {
      lowest = std::min(lowest, loop.height);
    }
  }
  const auto [low, high] = heightRange(mesh, up);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (measures[i].length < kHole * longest) {
      ends.holes.push_back(loops[i]);
    } else if (measures[i].height <= lowest + kSameLevel * (high - low)) {
      ends.lower.push_back(loops[i]);
    } else {
      ends.upper.push_back(loops[i]);
    }
  }
  return ends;
}

std::vector<double> endToEndField(const TriangleMesh& mesh,
                                  const HalfEdges& halfEdges,
                                  const PartEnds& ends,
                                  const Vec3& up) {
  std::vector<std::uint32_t> sources;
  for (const auto& loop : ends.lower) {
    sources.insert(sources.end(), loop.begin(), loop.end());
  }
  if (!ends.upper.empty()) {
    std::vector<FixedValues> fixed{{sources, 0.0}};
    for (const auto& loop : ends.upper) {
      fixed.push_back({loop, 1.0});
    }
    return harmonicField(mesh, halfEdges, fixed);
  }
  if (sources.empty()) {
    const auto [low, high] = heightRange(mesh, up);
    std::vector<bool> used(mesh.vertices.size(), false);
    for (const auto& t : mesh.triangles) {
      for (const std::uint32_t v : t) {
        used[v] = true;
      }
    }
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
      if (used[v] && up.dot(mesh.vertices[v]) <= low + kFlat * (high - low)) {
        sources.push_back(v);
      }
    }
  }
  return distanceFrom(mesh, halfEdges, sources);
}

}  // namespace wcam::geometry
