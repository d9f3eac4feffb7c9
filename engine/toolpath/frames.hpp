// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/toolpath/toolpath.hpp"

namespace wcam::toolpath {

/// Below this a sum or product of unit vectors has no direction that rounding leaves alone.
inline constexpr double kNoDirection = 1e-9;

/// Unit tangent at the middle of three points: exact on circles (each chord weighted by the other's
/// length). Where the path turns back on itself: the direction that leaves.
Vec3 tangentAt(const Vec3& before, const Vec3& p, const Vec3& after);

/// What lead and lateral tilt lean the torch to; both perpendicular to `up` and to each other.
struct TiltFrame {
  Vec3 along;     ///< the travel
  Vec3 outwards;  ///< across it, on the side of the outward normal
};

TiltFrame tiltFrame(const Vec3& travel, const Vec3& outward, const Vec3& up);

/// Right-handed (t, n, b) with t kept and n as near to the surface normal as it can be.
void setFrame(PathPoint& point, const Vec3& t, const Vec3& surfaceNormal, const Vec3& fallbackUp);

}  // namespace wcam::toolpath
