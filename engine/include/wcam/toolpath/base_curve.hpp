// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/geodesic.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/substrate.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wcam::toolpath {

/// A border of the part or a stretch of one, or a curve in which it meets the substrate.
struct BaseLoop {
  bool closed = true;
  /// In the direction of the border's half-edges (material on the left seen from outside);
  /// consecutive points share a triangle. A closed loop repeats its first point at the end.
  std::vector<geometry::MeshPoint> points;
  std::vector<std::uint32_t> vertices;   ///< of a border, in order; empty for an intersection
  std::vector<std::uint32_t> halfEdges;  ///< of a border, in order; empty for an intersection
  double length = 0.0;                   ///< mm
  double lowest = 0.0;                   ///< least height above the substrate, mm
  double highest = 0.0;                  ///< greatest height above the substrate, mm
  double mean = 0.0;                     ///< by length, mm
  std::size_t component = 0;             ///< connected piece of the surface
};

/// How a connected piece of the part begins.
enum class BaseKind {
  Border,        ///< on a border of the surface
  Intersection,  ///< where the surface passes through the substrate
  Contact,       ///< on the flat bottom, edge or point on which a closed body stands
  None           ///< below the substrate, or closed and above it: it is not built
};

/// Where the layers of a part begin and where they end.
struct PartBase {
  geometry::GeodesicSource source;     ///< all of the base: distance 0
  std::vector<BaseLoop> lower;         ///< borders and intersections that are base
  std::vector<BaseLoop> upper;         ///< the other borders above the substrate
  std::vector<BaseKind> kind;          ///< per component
  std::vector<std::size_t> component;  ///< per vertex: its component
  /// Per vertex: −1 below the substrate, 1 above or on it.
  std::vector<std::int8_t> side;
};

/// A point that is nearer to the substrate than this counts as on it, mm: small against a bead,
/// greater than the chord error of a tessellated substrate.
inline constexpr double kSubstrateContact = 0.05;

/// Finds the base of each connected piece of a part: the curve in which it passes through the
/// substrate, else the borders or, of open sheets, the stretches of borders that lie on it, else
/// the lowest border, else (closed bodies) the contact with the substrate. The upper border of an
/// open sheet is the stretch of its border between its sides.
///
/// Findings: slicing.base_off_substrate (the lowest border does not lie on the substrate: how far,
/// where), slicing.several_lower_borders (layers grow from several borders of one piece and will
/// meet), slicing.piece_below_substrate, slicing.piece_without_base (a closed piece above it).
/// @throws Error(JobFailed) when no piece has a base: closed and above the substrate, or below it:
/// with the place and the distance Cost: one height per vertex, O(n).
PartBase findBase(const geometry::PartSurface& surface,
                  const Substrate& substrate,
                  const JobContext& context = JobContext());

/// Geodesic distance of every vertex from the base, mm; negative below the substrate, NaN on pieces
/// that have no base.
std::vector<double> distanceFromBase(const geometry::PartSurface& surface,
                                     const PartBase& base,
                                     const JobContext& context = JobContext());

}  // namespace wcam::toolpath
