// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/layer_distance.hpp"

#include "wcam/base/parallel.hpp"
#include "wcam/geometry/segment_tree.hpp"

namespace wcam::toolpath {

std::vector<double> layerDistance(const std::vector<Vec3>& points,
                                  const std::vector<Contour>& below) {
  geometry::SegmentTree tree;
  for (const Contour& contour : below) {
    std::vector<Vec3> polyline;
    polyline.reserve(contour.points.size());
    for (const ContourPoint& point : contour.points) {
      polyline.push_back(point.p);
    }
    tree.add(polyline, contour.closed);
  }
  tree.build();
  std::vector<double> distance(points.size());
  parallelFor(points.size(), 1024, [&](std::size_t i) { distance[i] = tree.distance(points[i]); });
  return distance;
}

}  // namespace wcam::toolpath
