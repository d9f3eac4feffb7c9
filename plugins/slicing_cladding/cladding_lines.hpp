// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/plane_field.hpp"

#include <array>
#include <memory>
#include <vector>

namespace wcam::cladding {

using geometry::Vec3;

/// Planes across a surface whose traces lie one spacing apart on it.
struct LinePlanes {
  toolpath::PlaneStack stack;  ///< up is the direction across the beads; levels from the origin
  double area = 0.0;           ///< of the surface, mm²
  double uncoveredArea = 0.0;  ///< of faces that run along the planes, mm²
  double denseArea = 0.0;      ///< where the traces lie clearly nearer than the spacing, mm²
  double width = 0.0;          ///< of the surface across the lines, mm
  double spacing = 0.0;        ///< of the lines, fitted to the width, mm
};

/// Surface that is nearer than this to the planes' own direction (sine of about 6 degrees) cannot
/// be covered by them: one bead would stand for ten spacings of plane distance.
inline constexpr double kLeastSlope = 0.1;

/// Distances that fill a length, none more than a little wider than the spacing.
int gapsOf(double length, double spacing);

/// @throws Error(JobFailed) for more than 100 000 lines
void requireFewLines(double count);

/// Positions of the planes: the distance from one to the next is the spacing times the least slope
/// that the surface between them has against the planes, so that traces are nowhere farther apart
/// than the spacing, and exactly one spacing on planes, cylinders and spheres. The first and the
/// last trace lie on their margins from the ends, and the spacing is fitted to what is between
/// them; a surface that is too narrow for both margins has one line in its middle.
/// @throws Error(InvalidArgument) for a direction without length, Error(JobFailed) when the whole
/// surface runs along the planes or more than 100 000 lines would be needed
/// Cost: O(triangles·log + lines).
LinePlanes linePlanes(const geometry::PartSurface& surface,
                      const Vec3& across,
                      double spacing,
                      const std::array<double, 2>& margins);

}  // namespace wcam::cladding
