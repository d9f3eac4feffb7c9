// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cladding_lines.hpp"

#include "wcam/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wcam::cladding {

namespace {

/// Traces nearer than this part of the spacing count as dense.
constexpr double kDense = 0.75;
constexpr double kMostLines = 1e5;
/// Steps of the integral of the slope, for each spacing of plane distance.
constexpr double kStepsPerLine = 64.0;

struct Strip {
  double low = 0.0;
  double high = 0.0;
  double slope = 0.0;  ///< length of the direction's part in the surface, per mm
  double area = 0.0;
};

std::vector<Strip> stripsOf(const geometry::TriangleMesh& mesh, const Vec3& across) {
  std::vector<Strip> strips;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& triangle = mesh.triangles[t];
    const Vec3& a = mesh.vertices[triangle[0]];
    const Vec3& b = mesh.vertices[triangle[1]];
    const Vec3& c = mesh.vertices[triangle[2]];
    const double area = 0.5 * (b - a).cross(c - a).norm();
    if (!(area > 0.0)) {
      continue;
    }
    const double cosine = mesh.normal(t).dot(across);
    const double fa = across.dot(a);
    const double fb = across.dot(b);
    const double fc = across.dot(c);
    strips.push_back({std::min({fa, fb, fc}), std::max({fa, fb, fc}),
                      std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), area});
  }
  return strips;
}

/// Least slope in each of equal steps over the extent: strips in ascending order of slope fill the
/// steps that are still free.
std::vector<double> leastSlopes(std::vector<Strip> strips, double low, double step, std::size_t n) {
  std::stable_sort(strips.begin(), strips.end(),
                   [](const Strip& a, const Strip& b) { return a.slope < b.slope; });
  std::vector<double> slopes(n, 1.0);
  std::vector<std::size_t> nextFree(n + 1);
  std::iota(nextFree.begin(), nextFree.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (nextFree[i] != i) {
      nextFree[i] = nextFree[nextFree[i]];
      i = nextFree[i];
    }
    return i;
  };
  for (const Strip& strip : strips) {
    const auto at = [&](double f) {
      return static_cast<std::size_t>(
          std::clamp(std::floor((f - low) / step), 0.0, static_cast<double>(n - 1)));
    };
    const std::size_t last = at(strip.high);
    for (std::size_t i = find(at(strip.low)); i <= last; i = find(i)) {
      slopes[i] = strip.slope;
      nextFree[i] = i + 1;
    }
  }
  return slopes;
}

}  // namespace

int gapsOf(double length, double spacing) {
  // A tenth of a spacing more or less is level all the same, and saves a bead.
  constexpr double kWider = 0.1;
  return static_cast<int>(std::max(0.0, std::ceil(length / spacing - kWider)));
}

void requireFewLines(double count) {
  if (!(count <= kMostLines)) {
    throw Error(ErrorCode::JobFailed, "more than 100 000 lines would be needed",
                "cladding, bead spacing", "choose wider beads");
  }
}

LinePlanes linePlanes(const geometry::PartSurface& surface,
                      const Vec3& across,
                      double spacing,
                      const std::array<double, 2>& margins) {
  if (!(across.norm() > 0.0) || !across.allFinite()) {
    throw Error(ErrorCode::InvalidArgument, "the direction across the beads has no length",
                "direction", "give a vector such as [1, 0, 0]");
  }
  LinePlanes planes;
  planes.stack.up = across.normalized();
  std::vector<Strip> strips = stripsOf(surface.mesh, planes.stack.up);
  for (const Strip& strip : strips) {
    planes.area += strip.area;
    planes.uncoveredArea += strip.slope < kLeastSlope ? strip.area : 0.0;
  }
  std::erase_if(strips, [](const Strip& strip) { return strip.slope < kLeastSlope; });
  if (strips.empty()) {
    throw Error(ErrorCode::JobFailed, "the surface runs along the planes of the beads",
                "cladding, direction", "choose a direction that lies in the surface");
  }
  double low = strips[0].low;
  double high = strips[0].high;
  for (const Strip& strip : strips) {
    low = std::min(low, strip.low);
    high = std::max(high, strip.high);
  }
  requireFewLines((high - low) / spacing);
  const auto n =
      static_cast<std::size_t>(std::ceil(kStepsPerLine * std::max(1.0, (high - low) / spacing)));
  const double step = (high - low) / static_cast<double>(n);
  const std::vector<double> slopes = leastSlopes(strips, low, step, n);
  // Surface distance from the low end.
  std::vector<double> distance(n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    distance[i + 1] = distance[i] + step / slopes[i];
  }
  const double width = distance[n];
  const double room = width - margins[0] - margins[1];
  requireFewLines(room / spacing);
  const int gaps = room > 0.0 ? gapsOf(room, spacing) : 0;
  const double first = room > 0.0 && gaps > 0
                           ? margins[0]
                           : std::clamp(0.5 * (width + margins[0] - margins[1]), 0.0, width);
  planes.width = width;
  planes.spacing = gaps > 0 ? room / gaps : spacing;
  std::size_t i = 0;
  for (int k = 0; k <= gaps; ++k) {
    const double wanted = first + k * planes.spacing;
    while (i + 1 < n && distance[i + 1] < wanted) {
      ++i;
    }
    const double f = low + step * (static_cast<double>(i) +
                                   std::clamp((wanted - distance[i]) * slopes[i] / step, 0.0, 1.0));
    planes.stack.levels.push_back({std::clamp(f, low, high), planes.stack.up, planes.spacing});
  }
  for (const Strip& strip : strips) {
    const auto middle = static_cast<std::size_t>(
        std::clamp((0.5 * (strip.low + strip.high) - low) / step, 0.0, static_cast<double>(n - 1)));
    planes.denseArea += slopes[middle] < kDense * strip.slope ? strip.area : 0.0;
  }
  return planes;
}

}  // namespace wcam::cladding
