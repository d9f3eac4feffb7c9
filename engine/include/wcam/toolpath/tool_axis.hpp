// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/quantity.hpp"
#include "wcam/geometry/types.hpp"

namespace wcam::toolpath {

using geometry::Vec3;

/// Tool axis with lead angle θn (in the travel plane, positive leans forward along t) and lateral
/// tilt θt (towards n): T = (tan θn·t + tan θt·n + b) / √(1 + tan²θn + tan²θt). (t, n, b)
/// orthonormal. Chalvin A16 (closed form).
Vec3 tiltedAxis(const Vec3& t, const Vec3& n, const Vec3& b, Angle lead, Angle lateral);

}  // namespace wcam::toolpath
