// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/types.hpp"

#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>

#include <array>
#include <functional>
#include <string>

namespace wcam::io {

using SurfaceFunction = std::function<geometry::Vec3(double u, double v)>;
using CurveFunction = std::function<geometry::Vec3(double s)>;

/// A spline and its largest measured distance from the function that it stands for, mm.
template <class Spline>
struct Fitted {
  Handle(Spline) spline;
  double deviation = 0.0;
};

/// Quintic spline through a grid of points of the function, refined in each direction until the
/// points between agree to 1e-9 of the size of the surface. A closed direction is closed exactly.
/// @param place the place in the file, for messages
/// @throws Error(InputInvalid) when the function is not finite, does not close, or is not smooth
///   enough to be met within 1e-7 of its size
Fitted<Geom_BSplineSurface> fitSurface(const SurfaceFunction& function,
                                       const std::array<double, 2>& u,
                                       const std::array<double, 2>& v,
                                       bool closedU,
                                       bool closedV,
                                       const std::string& place,
                                       const JobContext& context);

/// The same for a curve over [0, 1]; its ends are met exactly.
/// @param size of the part that the accuracy counts from, mm
Fitted<Geom_BSplineCurve> fitCurve(const CurveFunction& function,
                                   double size,
                                   const std::string& place,
                                   const JobContext& context);

}  // namespace wcam::io
