// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/shapes.hpp"

#include <vector>

/// Convex solids and their covers by spheres. Private to this module.
namespace wcam::collision::detail {

using cell::Shape;
using cell::ShapeKind;
using geometry::Pose;
using geometry::Vec3;

/// Everything but a mesh, in its own frame, centred (see cell::Shape).
struct Primitive {
  ShapeKind kind = ShapeKind::Sphere;
  double radius = 0.0;
  double half = 0.0;           ///< half length along z
  Vec3 halves = Vec3::Zero();  ///< of a box
};

Primitive primitiveOf(const Shape& shape);

/// Distance of a point from the solid, negative inside, mm. Convex and 1-Lipschitz.
double signedDistance(const Primitive& solid, const Vec3& p);

/// Radius about the centre that holds the solid.
double outerRadius(const Primitive& solid);

/// A segment with a radius.
struct Rod {
  Vec3 a = Vec3::Zero();
  Vec3 b = Vec3::Zero();
  double radius = 0.0;
};

/// Distance of a rod from a solid; where they overlap, minus the depth to which the rod's axis and
/// radius reach into the solid. The signed distance of a convex solid is convex along the rod's
/// axis, so a section search finds its minimum: exact to kSectionTolerance, robust in every
/// position, and a tenth of the time of a general GJK.
struct RodDistance {
  double value = 0.0;
  Vec3 point = Vec3::Zero();  ///< the axis point of the rod that is nearest, frame of the solid
};

inline constexpr double kSectionTolerance = 1e-7;  // mm, a hundredth of what machines resolve
RodDistance rodDistance(const Primitive& solid, const Rod& rod);

/// A sphere of a cover, frame of the shape.
struct CoverSphere {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
};

/// Spheres whose union holds the shape (the surface of a mesh). Round shapes grow by at most about
/// a tenth of their radius, flat ends by 0.41 of it; boxes and meshes take at most kMaxCover.
inline constexpr int kMaxCover = 96;
std::vector<CoverSphere> coverOf(const Shape& shape);

}  // namespace wcam::collision::detail
