// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/toolpath/slicing.hpp"

namespace wcam::toolpath {

/// Point at a part of the way from a to b on their chord: normal, height, widths and axis go along,
/// as far as both have them.
inline ContourPoint between(const ContourPoint& a, const ContourPoint& b, double fraction) {
  const auto mix = [fraction](double x, double y) {
    return x > 0.0 && y > 0.0 ? (1.0 - fraction) * x + fraction * y : 0.0;
  };
  const auto direction = [fraction](const Vec3& x, const Vec3& y) {
    const Vec3 sum = (1.0 - fraction) * x + fraction * y;
    return Vec3(sum.norm() > 0.0 ? sum.normalized() : (fraction < 0.5 ? x : y));
  };
  ContourPoint point;
  point.p = (1.0 - fraction) * a.p + fraction * b.p;
  point.n = direction(a.n, b.n);
  point.height = mix(a.height, b.height);
  point.width = mix(a.width, b.width);
  point.fillWidth = mix(a.fillWidth, b.fillWidth);
  if (a.axis.norm() > 0.0 && b.axis.norm() > 0.0) {
    point.axis = direction(a.axis, b.axis);
  }
  return point;
}

}  // namespace wcam::toolpath
