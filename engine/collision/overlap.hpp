// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "primitive.hpp"

/// How deep convex solids overlap. Private to this module.
namespace wcam::collision::detail {

/// The least translation that parts two solids that overlap.
struct Overlap {
  double depth = 0.0;         ///< mm; not positive where they do not overlap
  Vec3 way = Vec3::Zero();    ///< unit vector: the first solid leaves along it
  Vec3 point = Vec3::Zero();  ///< in the middle of the overlap
};

/// Of two convex solids, both in one frame. The widths of the overlap are compared in the
/// directions of axes, edges and centres and over the sphere, and the best direction is refined:
/// for boxes exact, else to about a thousandth. Never less than the least translation; a result
/// that is not positive proves that the solids are apart. About 0.3 ms.
/// @param enough a depth that is not of interest: nothing more is looked for below it
Overlap leastTranslation(
    const Primitive& a, const Pose& T_a, const Primitive& b, const Pose& T_b, double enough = 0.0);

/// The rod as a solid in the frame of poseOf(rod).
Primitive primitiveOf(const Rod& rod);

}  // namespace wcam::collision::detail
