// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/collision/exit_angle.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::collision {

double exitAngleThroughEnd(double y, double z, double standOff) {
  const double r = std::hypot(y, z);
  if (!(r > 0.0)) {
    return 0.0;  // the TCP itself lies in the end of a nozzle without stand-off
  }
  return std::max(std::acos(std::clamp(standOff / r, -1.0, 1.0)) - std::atan2(std::abs(y), z), 0.0);
}

double exitAngle(double x, double y, double z, double radius, double standOff) {
  const double half2 = radius * radius - x * x;
  if (!(half2 >= 0.0)) {
    return 0.0;
  }
  const double half = std::sqrt(half2);  // of the nozzle's section in the plane of the rotation
  if (std::abs(y) > half || z < standOff) {
    return 0.0;
  }
  const double r = std::hypot(y, z);
  const double end = exitAngleThroughEnd(y, z, standOff);
  if (r < half) {
    return end;
  }
  const double side = std::asin(std::min(half / r, 1.0)) - std::atan2(std::abs(y), z);
  return std::max(std::min(end, side), 0.0);
}

}  // namespace wcam::collision
