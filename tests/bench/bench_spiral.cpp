// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"
#include "wcam/geometry/geodesic.hpp"
#include "wcam/geometry/refine.hpp"
#include "wcam/io/import.hpp"
#include "wcam/toolpath/spiral.hpp"
#include "wcam/toolpath/wall.hpp"

#include "timing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

/// The continuous spiral of the trunk-like elbow of Diourté's Table 3.3 at 2 mm on one core: by
/// iso-values, by shortest paths, and as a level set. The anchor is what the thesis does for its
/// geodesic generatrices: exact shortest paths (Xin and Wang, by CGAL) from the upper border, one
/// per generatrix. Lengths must agree with the anchor and with the closed form.
namespace {

using namespace wcam;

constexpr double kStep = 2.0;
constexpr int kRuns = 3;
/// Of lengths: shortest paths on a triangulation with edges of 8 mm differ from those of the
/// surface.
constexpr double kAgreement = 0.2;

struct Range {
  double shortest = 1e300;
  double longest = 0.0;

  void add(double length) {
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
};

Range rangeOf(const toolpath::Generatrices& generatrices) {
  Range range;
  for (const toolpath::Generatrix& curve : generatrices.curves) {
    range.add(curve.length());
  }
  return range;
}

}  // namespace

int main() {
  const ThreadLimit oneCore(1);
  const JobContext context;
  const auto part = io::importPart(std::string(WCAM_TEST_DATA) + "/formula/trunk_surrogate.wsurf",
                                   io::ImportOptions{}, geometry::Pose::Identity(), context)
                        .surface;
  geometry::Pose pose = geometry::Pose::Identity();
  const toolpath::Substrate substrate(pose, geometry::Vec3(200, 200, 10));
  toolpath::SpiralWish wish;
  toolpath::GeneratrixOptions options;
  options.step = kStep;
  const double edge = geometry::fieldEdgeLength(*part, 4.0 * kStep);
  const auto whole = [&](toolpath::Decomposition method, Range& range) {
    const toolpath::WallPart wall = toolpath::prepareWall(*part, substrate, edge, context);
    options.method = method;
    const auto generatrices = toolpath::decomposeWall(wall.surface, wall.limits, options, context);
    range = rangeOf(generatrices);
    std::vector<double> lengths;
    for (const toolpath::Generatrix& curve : generatrices.curves) {
      lengths.push_back(curve.length());
    }
    const auto plan = toolpath::planSpiral(lengths, wish);
    return toolpath::spiralAlong(*part, generatrices, plan, wish, context)
        .layers.front()
        .contours.front()
        .points.size();
  };
  bench::Times isoValues;
  bench::Times geodesics;
  bench::Times levelSet;
  bench::Times exact;
  Range iso;
  Range geodesic;
  Range anchor;
  std::size_t points = 0;
  for (int run = 0; run < kRuns; ++run) {
    points = isoValues.measure([&] { return whole(toolpath::Decomposition::IsoValues, iso); });
    (void)geodesics.measure([&] { return whole(toolpath::Decomposition::Geodesic, geodesic); });
    (void)levelSet.measure([&] {
      const toolpath::WallPart wall = toolpath::prepareWall(*part, substrate, edge, context);
      return toolpath::spiralOnField(wall.surface, *part, wall.limits, wish, options.sampling,
                                     context)
          .layers.size();
    });
  }
  const toolpath::WallPart wall = toolpath::prepareWall(*part, substrate, edge, context);
  (void)exact.measure([&] {
    const geometry::ExactGeodesics solver(wall.surface.mesh, wall.limits.upper);
    std::size_t nodes = 0;
    for (const std::uint32_t v : wall.limits.lower) {
      anchor.add(solver.distance(v));
      nodes += solver.path(v).size();
    }
    return nodes;
  });
  std::printf("mesh of %zu triangles, spiral of %zu points\n", wall.surface.mesh.triangles.size(),
              points);
  std::printf("%-34s %8.3f s   %.2f ... %.2f mm\n", "spiral by iso-values", isoValues.min(),
              iso.shortest, iso.longest);
  std::printf("%-34s %8.3f s   %.2f ... %.2f mm\n", "spiral by shortest paths", geodesics.min(),
              geodesic.shortest, geodesic.longest);
  std::printf("%-34s %8.3f s\n", "spiral as a level set", levelSet.min());
  std::printf("%-34s %8.3f s   %.2f ... %.2f mm\n", "exact paths of the generatrices only",
              exact.min(), anchor.shortest, anchor.longest);
  std::printf("ratio of the anchor to the spiral by shortest paths: %.1f\n",
              exact.min() / geodesics.min());
  const bool agree = std::abs(iso.shortest - 152.0) < kAgreement &&
                     std::abs(iso.longest - 178.0) < kAgreement &&
                     std::abs(geodesic.shortest - anchor.shortest) < kAgreement;
  std::printf("%s\n", agree ? "results agree" : "RESULTS DIFFER");
  return agree ? 0 : 1;
}
