// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generatrix_coverage.hpp"

#include "wcam/geometry/aabb_tree.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {

std::vector<StripGap> stripGaps(const geometry::TriangleMesh& mesh,
                                const std::vector<Generatrix>& curves,
                                double spacing) {
  double longest = 0.0;
  for (const Generatrix& curve : curves) {
    longest = std::max(longest, curve.length());
  }
  const auto rows = static_cast<std::size_t>(std::max(2.0, std::ceil(longest / spacing)));
  geometry::TriangleMesh strips;
  for (const Generatrix& curve : curves) {
    for (std::size_t r = 0; r <= rows; ++r) {
      strips.vertices.push_back(
          curve.at(curve.length() * static_cast<double>(r) / static_cast<double>(rows)));
    }
  }
  const auto vertex = [&](std::size_t curve, std::size_t row) {
    return static_cast<std::uint32_t>((curve % curves.size()) * (rows + 1) + row);
  };
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (std::size_t r = 0; r < rows; ++r) {
      strips.triangles.push_back({vertex(i, r), vertex(i + 1, r), vertex(i, r + 1)});
      strips.triangles.push_back({vertex(i + 1, r), vertex(i + 1, r + 1), vertex(i, r + 1)});
    }
  }
  const geometry::AabbTree tree(strips);
  std::vector<StripGap> gaps(curves.size());
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    const auto hit = tree.closestPoint(mesh.vertices[v]);
    if (!hit) {
      continue;
    }
    StripGap& gap = gaps[hit->triangle / (2 * rows)];
    if (hit->distance > gap.distance) {
      gap = {hit->distance, v};
    }
  }
  return gaps;
}

}  // namespace wcam::toolpath
