// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/tool_axis.hpp"

#include <cmath>

namespace wcam::toolpath {

Vec3 tiltedAxis(const Vec3& t, const Vec3& n, const Vec3& b, Angle lead, Angle lateral) {
  const double tn = std::tan(lead.value());
  const double tt = std::tan(lateral.value());
  return (tn * t + tt * n + b) / std::sqrt(1.0 + tn * tn + tt * tt);
}

}  // namespace wcam::toolpath
