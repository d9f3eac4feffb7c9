// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/numeric_frames.hpp"

#include "wcam/base/parallel.hpp"
#include "wcam/geometry/segment_tree.hpp"

#include "frames.hpp"

#include <algorithm>

namespace wcam::toolpath {

namespace {

geometry::SegmentTree treeOf(const SlicedLayer& layer) {
  geometry::SegmentTree tree;
  for (const Contour& contour : layer.contours) {
    std::vector<Vec3> polyline;
    for (const ContourPoint& point : contour.points) {
      polyline.push_back(point.p);
    }
    tree.add(polyline, contour.closed);
  }
  tree.build();
  return tree;
}

/// Unit normal of the facet over a chord in the upward direction u; zero without a direction.
Vec3 facetNormal(const Vec3& u, const Vec3& chord) {
  const Vec3 n = u.cross(chord);
  const double size = u.norm() * chord.norm();
  return n.norm() > kNoDirection * size ? Vec3(n.normalized()) : Vec3::Zero();
}

void setNormals(Contour& contour,
                const Vec3& up,
                const geometry::SegmentTree* below,
                const geometry::SegmentTree* above) {
  const std::size_t n = contour.points.size();
  std::vector<Vec3> normals(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool first = !contour.closed && i == 0;
    const bool last = !contour.closed && i + 1 == n;
    const Vec3& p = contour.points[i].p;
    const Vec3& before = first ? p : contour.points[(i + n - 1) % n].p;
    const Vec3& after = last ? p : contour.points[(i + 1) % n].p;
    const Vec3 chord = after - before;
    Vec3 sum = Vec3::Zero();
    if (below != nullptr && !below->empty()) {
      sum += facetNormal(before - below->nearest(p), chord);
    }
    if (above != nullptr && !above->empty()) {
      sum += facetNormal(above->nearest(p) - before, chord);
    }
    if (!(sum.norm() > kNoDirection)) {
      sum = facetNormal(up, chord);
    }
    normals[i] = sum.norm() > 0.0 ? Vec3(sum.normalized()) : up.unitOrthogonal();
  }
  for (std::size_t i = 0; i < n; ++i) {
    contour.points[i].n = normals[i];
  }
}

}  // namespace

void setNumericNormals(SlicedLayers& layers, const JobContext& context) {
  std::vector<geometry::SegmentTree> trees(layers.layers.size());
  parallelFor(
      trees.size(), 1, [&](std::size_t l) { trees[l] = treeOf(layers.layers[l]); }, context);
  parallelFor(
      trees.size(), 1,
      [&](std::size_t l) {
        for (Contour& contour : layers.layers[l].contours) {
          setNormals(contour, layers.layers[l].up, l > 0 ? &trees[l - 1] : nullptr,
                     l + 1 < trees.size() ? &trees[l + 1] : nullptr);
        }
      },
      context);
}

}  // namespace wcam::toolpath
