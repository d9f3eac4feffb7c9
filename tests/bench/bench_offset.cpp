// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nested insets of 100 slices of a large mesh against plain Clipper on the raw slices, at equal
// tolerance. Each side starts from the same loops in every repetition. Both are compared with a
// reference, Clipper's round offset of the raw loops directly by each whole distance: area, and
// Hausdorff distance of the borders. A run in which the own insets leave it by more than the
// tolerance, or more than plain Clipper does, fails.

#include "wcam/base/quantity.hpp"
#include "wcam/geometry/level_set.hpp"
#include "wcam/geometry/polygon2d.hpp"

#include "timing.hpp"
#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace {

using wcam::bench::Times;
using wcam::geometry::CornerJoin;
using wcam::geometry::Polyline2;
using wcam::geometry::Region2;
using wcam::geometry::TriangleMesh;
using wcam::geometry::Vec2;
using wcam::geometry::Vec3;

constexpr double kTolerance = 0.05;  // mm
constexpr double kStep = 3.0;        // mm
constexpr int kInsets = 8;
constexpr std::size_t kLayers = 100;
/// Units of Clipper's grid per mm.
constexpr double kUnits = 1000.0;
/// Hausdorff distances are measured on some layers only: they cost more than the offsets.
constexpr std::size_t kMeasuredLayers = 5;

/// A torus with waves on it, tilted; nearly isotropic triangles.
TriangleMesh bumpyTorus(std::uint32_t along, std::uint32_t around) {
  constexpr double kBig = 120.0;
  constexpr double kSmall = 48.0;
  const Eigen::Matrix3d tilt =
      (Eigen::AngleAxisd(0.3, Vec3::UnitX()) * Eigen::AngleAxisd(0.2, Vec3::UnitY()))
          .toRotationMatrix();
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < along; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const double u = 2.0 * wcam::kPi * i / along;
      const double v = 2.0 * wcam::kPi * j / around;
      const double r = kSmall + 3.0 * std::sin(9.0 * u) * std::cos(5.0 * v);
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

/// Raw slices: loops of all crossed edges, material on the left.
std::vector<Region2> rawSlices() {
  const TriangleMesh mesh = bumpyTorus(1118, 447);
  const wcam::geometry::HalfEdges halfEdges(mesh);
  const auto bounds = mesh.bounds();
  std::vector<double> levels;
  for (std::size_t k = 0; k < kLayers; ++k) {
    levels.push_back(bounds.min.z() +
                     (static_cast<double>(k) + 0.5) / kLayers * (bounds.max.z() - bounds.min.z()));
  }
  std::vector<Region2> slices;
  for (const auto& contours : planeSections(mesh, halfEdges, Vec3::UnitZ(), levels)) {
    Region2 slice;
    for (const auto& contour : contours) {
      Polyline2 loop;
      for (auto p = contour.points.rbegin(); p != contour.points.rend(); ++p) {
        loop.emplace_back(p->x(), p->y());
      }
      slice.loops.push_back(std::move(loop));
    }
    slices.push_back(std::move(slice));
  }
  return slices;
}

using Nested = std::vector<Region2>;  ///< the insets of one slice

std::vector<Nested> own(const std::vector<Region2>& slices, CornerJoin join) {
  std::vector<Nested> result;
  result.reserve(slices.size());
  for (const Region2& slice : slices) {
    result.push_back(
        wcam::geometry::nestedInsets(slice, kStep, kStep, kInsets, {join, 2.0, kTolerance}));
  }
  return result;
}

ClipperLib::Paths toPaths(const Region2& region) {
  ClipperLib::Paths paths;
  for (const Polyline2& loop : region.loops) {
    ClipperLib::Path path;
    path.reserve(loop.size());
    for (const Vec2& p : loop) {
      path.push_back({std::llround(p.x() * kUnits), std::llround(p.y() * kUnits)});
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

Region2 toRegion(const ClipperLib::Paths& paths) {
  Region2 region;
  for (const ClipperLib::Path& path : paths) {
    Polyline2 loop;
    loop.reserve(path.size());
    for (const auto& p : path) {
      loop.emplace_back(static_cast<double>(p.X) / kUnits, static_cast<double>(p.Y) / kUnits);
    }
    region.loops.push_back(std::move(loop));
  }
  return region;
}

ClipperLib::Paths clipperOffset(const ClipperLib::Paths& paths,
                                double distance,
                                ClipperLib::JoinType join,
                                double tolerance) {
  ClipperLib::ClipperOffset offset(2.0, tolerance * kUnits);
  offset.AddPaths(paths, join, ClipperLib::etClosedPolygon);
  ClipperLib::Paths result;
  offset.Execute(result, distance * kUnits);
  return result;
}

/// Plain Clipper: each inset from the one before.
std::vector<Nested> plain(const std::vector<Region2>& slices, ClipperLib::JoinType join) {
  std::vector<Nested> result;
  result.reserve(slices.size());
  for (const Region2& slice : slices) {
    Nested nested;
    ClipperLib::Paths paths = toPaths(slice);
    for (int k = 0; k < kInsets; ++k) {
      paths = clipperOffset(paths, -kStep, join, kTolerance);
      if (paths.empty()) {
        break;
      }
      nested.push_back(toRegion(paths));
    }
    result.push_back(std::move(nested));
  }
  return result;
}

/// Each inset directly from the raw loops, with fine arcs.
Nested reference(const Region2& slice) {
  Nested nested;
  const ClipperLib::Paths paths = toPaths(slice);
  for (int k = 0; k < kInsets; ++k) {
    const ClipperLib::Paths inset =
        clipperOffset(paths, -kStep * (k + 1), ClipperLib::jtRound, 0.02 * kTolerance);
    if (inset.empty()) {
      break;
    }
    nested.push_back(toRegion(inset));
  }
  return nested;
}

double distanceTo(const Region2& border, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Polyline2& loop : border.loops) {
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
      const Vec2 d = loop[i] - loop[j];
      const double length2 = d.squaredNorm();
      const double s = length2 > 0.0 ? std::clamp((p - loop[j]).dot(d) / length2, 0.0, 1.0) : 0.0;
      least = std::min(least, (p - loop[j] - s * d).squaredNorm());
    }
  }
  return std::sqrt(least);
}

double oneSided(const Region2& a, const Region2& b) {
  double worst = 0.0;
  for (const Polyline2& loop : a.loops) {
    for (const Vec2& p : loop) {
      worst = std::max(worst, distanceTo(b, p));
    }
  }
  return worst;
}

double areaOf(const std::vector<Nested>& all) {
  double sum = 0.0;
  for (const Nested& nested : all) {
    for (const Region2& region : nested) {
      sum += region.area();
    }
  }
  return sum;
}

double hausdorff(const std::vector<Nested>& all, const std::vector<Region2>& slices) {
  double worst = 0.0;
  for (std::size_t k = 0; k < kMeasuredLayers; ++k) {
    const std::size_t layer = (2 * k + 1) * slices.size() / (2 * kMeasuredLayers);
    const Nested exact = reference(slices[layer]);
    if (exact.size() != all[layer].size()) {
      return std::numeric_limits<double>::infinity();
    }
    for (std::size_t i = 0; i < exact.size(); ++i) {
      worst =
          std::max({worst, oneSided(all[layer][i], exact[i]), oneSided(exact[i], all[layer][i])});
    }
  }
  return worst;
}

/// @param repetitions few for round joins: plain Clipper doubles the points of arcs with each inset
/// @return whether the own insets are as good as they claim
bool runCase(const char* name,
             const std::vector<Region2>& slices,
             CornerJoin join,
             ClipperLib::JoinType clipperJoin,
             int repetitions) {
  std::size_t vertices = 0;
  for (const Region2& slice : slices) {
    vertices += slice.pointCount();
  }
  Times ownTimes, clipperTimes;
  std::vector<Nested> mine, theirs;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    mine = ownTimes.measure([&] { return own(slices, join); });
    theirs = clipperTimes.measure([&] { return plain(slices, clipperJoin); });
  }
  const double ownError = hausdorff(mine, slices);
  const double clipperError = hausdorff(theirs, slices);
  const auto perVertex = [&](const Times& times) {
    return times.min() * 1e9 / static_cast<double>(vertices);
  };
  std::printf("%s: %zu slices, %zu vertices, %d insets of %.0f mm\n", name, slices.size(), vertices,
              kInsets, kStep);
  std::printf("  own            min %8.4f s, first %8.4f s, %7.1f ns/vertex\n", ownTimes.min(),
              ownTimes.first(), perVertex(ownTimes));
  std::printf("  plain Clipper  min %8.4f s, first %8.4f s, %7.1f ns/vertex\n", clipperTimes.min(),
              clipperTimes.first(), perVertex(clipperTimes));
  std::printf("  ratio %.1f (medians %.1f), goal 5; %s\n", clipperTimes.min() / ownTimes.min(),
              clipperTimes.median() / ownTimes.median(), name);
  std::printf(
      "  area %.1f, plain Clipper %.1f mm²; Hausdorff distance to the exact insets %.4f, "
      "plain Clipper %.4f mm\n",
      areaOf(mine), areaOf(theirs), ownError, clipperError);
  const bool good = ownError <= std::max(kTolerance, clipperError);
  if (!good) {
    std::printf("  the results do not agree: the run is invalid\n");
  }
  return good;
}

}  // namespace

int main() {
  const std::vector<Region2> slices = rawSlices();
  bool good = runCase("mitred joins", slices, CornerJoin::Miter, ClipperLib::jtMiter, 3);
  good = runCase("round joins", slices, CornerJoin::Round, ClipperLib::jtRound, 1) && good;
  return good ? 0 : 1;
}
