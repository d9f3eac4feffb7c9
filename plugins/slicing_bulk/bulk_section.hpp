// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/polygon2d.hpp"
#include "wcam/toolpath/fill_room.hpp"
#include "wcam/toolpath/slicing.hpp"
#include "wcam/toolpath/substrate.hpp"

#include <vector>

namespace wcam::bulk {

using geometry::Vec2;
using geometry::Vec3;

/// The plane of a layer with x along the substrate's x axis, z = up.
class LayerPlane {
public:
  /// @param height up·p of the plane's points, mm
  LayerPlane(const Vec3& up, double height, const toolpath::Substrate& substrate);

  [[nodiscard]] Vec2 toPlane(const Vec3& p) const { return {x_.dot(p), y_.dot(p)}; }

  [[nodiscard]] Vec3 toSpace(const Vec2& q) const {
    return q.x() * x_ + q.y() * y_ + height_ * up_;
  }

  [[nodiscard]] Vec3 direction(const Vec2& d) const { return d.x() * x_ + d.y() * y_; }

  [[nodiscard]] const Vec3& up() const { return up_; }

private:
  Vec3 up_, x_, y_;
  double height_;
};

/// The region of the closed contours of one part in a layer. Contours of an outward surface run
/// clockwise; where the surface is turned inside out, what an odd number of contours surrounds is
/// inside.
geometry::Region2 sectionRegion(const toolpath::SlicedLayer& layer,
                                int part,
                                const LayerPlane& plane,
                                double tolerance);

/// The part of a region above a plate that cuts the layer's plane.
geometry::Region2 abovePlate(const geometry::Region2& region,
                             const LayerPlane& plane,
                             const toolpath::Substrate& substrate);

/// A bead of the fill as a contour: points no farther apart than the spacing, each with the width
/// that it has to fill, n across the travel with t × n = up, so that closed beads run clockwise as
/// walls do.
toolpath::Contour toContour(const toolpath::FillBead& bead,
                            const toolpath::FillRoom& room,
                            int part,
                            const LayerPlane& plane,
                            const toolpath::Sampling& sampling);

}  // namespace wcam::bulk
