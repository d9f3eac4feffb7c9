// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "frames.hpp"

namespace wcam::toolpath {

Vec3 tangentAt(const Vec3& before, const Vec3& p, const Vec3& after) {
  const Vec3 d1 = p - before;
  const Vec3 d2 = after - p;
  const double l1 = d1.norm();
  const double l2 = d2.norm();
  Vec3 t = Vec3::Zero();
  if (l1 > 0.0) {
    t += d1 / l1 * l2;
  }
  if (l2 > 0.0) {
    t += d2 / l2 * l1;
  }
  // A point where the path turns back on itself has no mean direction: keep the one that leaves.
  return t.norm() > kNoDirection * (l1 + l2) ? Vec3(t.normalized())
                                             : Vec3((l2 > 0.0 ? d2 : d1).normalized());
}

TiltFrame tiltFrame(const Vec3& travel, const Vec3& outward, const Vec3& up) {
  Vec3 along = travel - travel.dot(up) * up;
  along = along.norm() > kNoDirection ? Vec3(along.normalized()) : up.unitOrthogonal();
  const Vec3 left = up.cross(along);
  return {along, left.dot(outward) < 0.0 ? Vec3(-left) : left};
}

void setFrame(PathPoint& point, const Vec3& t, const Vec3& surfaceNormal, const Vec3& fallbackUp) {
  Vec3 b = t.cross(surfaceNormal);
  if (b.norm() < kNoDirection) {
    b = fallbackUp - fallbackUp.dot(t) * t;
  }
  point.t = t;
  point.b = b.norm() > 0.0 ? Vec3(b.normalized()) : t.unitOrthogonal();
  point.n = point.b.cross(point.t);
}

}  // namespace wcam::toolpath
