// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/polygon2d.hpp"

#include <polyclipping/clipper.hpp>

#include <span>
#include <vector>

namespace wcam::geometry::detail {

/// Integer coordinates for Clipper and Boost.Polygon: centred on the geometry, with a power of two
/// as scale chosen from the size, so that every coordinate keeps within `bits` bits.
class IntegerFrame {
public:
  IntegerFrame(const Box2& box, int bits);

  [[nodiscard]] Vec2 scaled(const Vec2& p) const { return (p - origin_) * scale_; }

  [[nodiscard]] Vec2 point(double x, double y) const { return Vec2(x, y) / scale_ + origin_; }

  [[nodiscard]] ClipperLib::IntPoint toInteger(const Vec2& p) const;
  [[nodiscard]] ClipperLib::Path toPath(const Polyline2& points) const;
  [[nodiscard]] Polyline2 toPolyline(const ClipperLib::Path& path) const;

  /// Length of one integer unit, mm.
  [[nodiscard]] double unit() const { return 1.0 / scale_; }

private:
  Vec2 origin_ = Vec2::Zero();
  double scale_ = 1.0;
};

/// Below this Clipper needs no products of 128 bits.
inline constexpr int kClipperBits = 29;

/// @param place pattern of the place of a point: %1 the loop, %2 its point
/// @throws Error(InvalidArgument) naming the first coordinate that is no number
void checkFinite(std::span<const Polyline2> loops, const char* place);

Box2 boundsOf(std::span<const Polyline2> loops);

/// Loops begin at their lowest point and are ordered by it; repeated points go.
void canonicalise(Region2& region);

/// What the loops wind around at least once (positive) or an odd number of times, without
/// crossings.
Region2 cleaned(std::span<const Polyline2> loops, ClipperLib::PolyFillType fill);

}  // namespace wcam::geometry::detail
