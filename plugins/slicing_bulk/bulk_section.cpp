// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bulk_section.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::bulk {

using geometry::LoopRule;
using geometry::Polyline2;
using geometry::Region2;

LayerPlane::LayerPlane(const Vec3& up, double height, const toolpath::Substrate& substrate)
    : up_(up), height_(height) {
  // Where the build direction runs along the substrate's x axis, its y axis takes that place.
  constexpr double kParallel = 1e-6;
  const geometry::Pose& pose = substrate.pose();
  x_ = pose.linear().col(0) - up.dot(pose.linear().col(0)) * up;
  if (x_.norm() < kParallel) {
    x_ = pose.linear().col(1) - up.dot(pose.linear().col(1)) * up;
  }
  x_.normalize();
  y_ = up_.cross(x_);
}

Region2 sectionRegion(const toolpath::SlicedLayer& layer,
                      int part,
                      const LayerPlane& plane,
                      double tolerance) {
  std::vector<Polyline2> loops;
  for (const toolpath::Contour& contour : layer.contours) {
    if (!contour.closed || contour.part != part) {
      continue;
    }
    Polyline2 loop;
    loop.reserve(contour.points.size());
    for (auto point = contour.points.rbegin(); point != contour.points.rend(); ++point) {
      loop.push_back(plane.toPlane(point->p));
    }
    loops.push_back(std::move(loop));
  }
  double area = 0.0;
  for (const Polyline2& loop : loops) {
    area += geometry::signedArea(loop);
  }
  return geometry::makeRegion(loops, area > 0.0 ? LoopRule::Orientation : LoopRule::Nesting,
                              tolerance);
}

Region2 abovePlate(const Region2& region,
                   const LayerPlane& plane,
                   const toolpath::Substrate& substrate) {
  const geometry::Pose& pose = substrate.pose();
  const Vec3 z = pose.linear().col(2);
  const Vec2 slope(z.dot(plane.direction(Vec2::UnitX())), z.dot(plane.direction(Vec2::UnitY())));
  // Parallel planes lie above or below as a whole; the stack of planes begins above.
  constexpr double kParallel = 1e-9;
  if (region.empty() || slope.norm() < kParallel) {
    return region;
  }
  const double base = z.dot(plane.toSpace(Vec2::Zero()) - pose.translation());
  const Vec2 along = slope.normalized();
  const Vec2 across(-along.y(), along.x());
  const geometry::Box2 box = region.bounds();
  const Vec2 centre = 0.5 * (box.min + box.max);
  const double size = box.diagonal();
  // Height above the plate grows along `along`; it is zero at this place of the centre's line.
  const double cut = -(base + slope.dot(centre)) / slope.norm();
  if (cut <= -size) {
    return region;
  }
  if (cut >= size) {
    return {};
  }
  const Vec2 origin = centre + cut * along;
  const double far = 2.0 * size;
  const Region2 half{{{origin - far * across, origin - far * across + far * along,
                       origin + far * across + far * along, origin + far * across}}};
  const Region2 ccw = geometry::signedArea(half.loops[0]) > 0.0
                          ? half
                          : Region2{{Polyline2(half.loops[0].rbegin(), half.loops[0].rend())}};
  return geometry::intersect(region, ccw);
}

toolpath::Contour toContour(const toolpath::FillBead& bead,
                            const toolpath::FillRoom& room,
                            int part,
                            const LayerPlane& plane,
                            const toolpath::Sampling& sampling) {
  Polyline2 points = bead.points;
  std::vector<double> widths = bead.widths;
  if (bead.closed) {
    std::reverse(points.begin(), points.end());
    std::reverse(widths.begin(), widths.end());
  }
  toolpath::Contour contour;
  contour.closed = bead.closed;
  contour.part = part;
  contour.feature = bead.feature;
  contour.group = bead.group;
  const std::size_t n = points.size();
  const std::size_t edges = bead.closed ? n : n - 1;
  // A closed bead runs from the last of the bead's own points back to it.
  const double whole = geometry::polylineLength(points, bead.closed);
  const double last = bead.closed ? (points.front() - points.back()).norm() : 0.0;
  double before = 0.0;
  const auto direction = [&](std::size_t edge) {
    const Vec2 d = points[(edge + 1) % n] - points[edge];
    return d.norm() > 0.0 ? Vec2(d.normalized()) : Vec2(Vec2::Zero());
  };
  const auto add = [&](const Vec2& p, const Vec2& in, const Vec2& out, double width, double s) {
    Vec2 t = in + out;
    constexpr double kTurnsBack = 1e-6;
    if (t.norm() < kTurnsBack) {
      t = out;
    }
    t.normalize();
    contour.points.push_back({plane.toSpace(p), plane.direction(Vec2(-t.y(), t.x())), 0.0, width});
    contour.points.back().fillWidth = room.at(bead.closed ? whole - last - s : s);
  };
  for (std::size_t i = 0; i < edges; ++i) {
    const Vec2 u = direction(i);
    const Vec2 in = i > 0 || bead.closed ? direction((i + edges - 1) % edges) : u;
    const std::size_t j = (i + 1) % n;
    const double length = (points[j] - points[i]).norm();
    const auto pieces =
        static_cast<std::size_t>(std::max(1.0, std::ceil(length / sampling.maxSpacing - 1e-9)));
    for (std::size_t k = 0; k < pieces; ++k) {
      const double along = static_cast<double>(k) / static_cast<double>(pieces);
      const double width = widths.empty() ? 0.0 : widths[i] + along * (widths[j] - widths[i]);
      add(points[i] + along * (points[j] - points[i]), k == 0 ? in : u, u, width,
          before + along * length);
    }
    before += length;
  }
  if (!bead.closed) {
    const Vec2 u = direction(n - 2);
    add(points[n - 1], u, u, widths.empty() ? 0.0 : widths[n - 1], whole);
  }
  return contour;
}

}  // namespace wcam::bulk
