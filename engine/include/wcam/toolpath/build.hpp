// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/param.hpp"
#include "wcam/toolpath/slicing.hpp"
#include "wcam/toolpath/substrate.hpp"
#include "wcam/toolpath/toolpath.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace wcam::toolpath {

/// Where closed beads start. Starts lie on points of the contour (Chalvin A14, A15: the points of a
/// layer stay the same), or exactly at the wanted place between them (PathParams::seamExact).
enum class SeamMode {
  Nearest,      ///< start where the previous bead ended
  Aligned,      ///< starts lie in one direction from the contour's centre
  Shifted,      ///< each layer's start moves on by a length
  GoldenRatio,  ///< each layer's start moves on by 0.618 of the contour
  Random,       ///< anywhere, from a seed
  KeepAway,     ///< near the previous end, but a length away from the starts of the last layers
  Corner        ///< sharpest concave corner, else sharpest corner, else aligned
};

/// Which contour of a layer comes next, inside a group.
enum class OrderMode {
  Nearest,       ///< nearest to where the last bead ended
  AsGiven,       ///< as the strategy lists them
  LeastRecent,   ///< above the bead of the layers below that was deposited longest ago
  ThermalSpread  ///< where the beads deposited before have left the least heat
};

/// When "alternate" turns the direction of travel.
enum class AlternateBy { Layer, Bead };

/// Which side of the bead the contour is: thin-walled parts are modelled by one of their surfaces.
enum class BeadReference {
  Centre,   ///< the bead's middle runs on the contour
  Inside,   ///< the contour is the bead's inner side: it lies outside of it
  Outside,  ///< the contour is the bead's outer side
};

/// What is added where a bead starts and ends. Lengths in mm; 0: none.
struct ZoneParams {
  double leadIn = 0.0;        ///< straight run onto the start, along its tangent
  double leadOut = 0.0;       ///< straight run from the end on
  bool leadArc = false;       ///< the arc burns in both
  double rampIn = 0.0;        ///< length in which speed and wire feed grow to their values
  double rampOut = 0.0;       ///< length in which they leave them
  double rampInSpeed = 1.0;   ///< factor of the travel speed at the start
  double rampInWire = 1.0;    ///< factor of the wire feed speed at the start
  double rampOutSpeed = 1.0;  ///< … at the end
  double rampOutWire = 1.0;
  double overlap = 0.0;   ///< run of a closed bead past its seam
  double wipe = 0.0;      ///< run back over the bead with the arc off
  double wipeLift = 0.0;  ///< height that is gained in it
};

enum class AxisMode {
  Local,   ///< the build direction b of each point (tangent to the part's wall)
  Layer,   ///< the layer's build direction (plane normal)
  Global,  ///< the substrate's build direction everywhere
  Auto,    ///< the axis that came with the path, else Layer where layers are planes, else Local
  Mean     ///< the mean of b over the layer
};

/// How contours become beads. Sampling is used by the strategy, the rest afterwards: changing a
/// seam does not slice again.
struct PathParams {
  Length chordError = 0.0_mm;  ///< 0: from bead and mesh, see sampling()
  Length maxSpacing = 0.0_mm;  ///< 0: from the bead
  SeamMode seam = SeamMode::Nearest;
  Length seamShift = 10.0_mm;
  Angle seamDirection = 0.0_deg;
  int seed = 1;
  Length seamKeepAway = 20.0_mm;  ///< least distance to the starts of the last layers (KeepAway)
  int seamMemory = 3;             ///< number of these layers
  bool seamExact = false;         ///< starts between points: a point is put there

  OrderMode order = OrderMode::Nearest;
  Length heatReach = 40.0_mm;     ///< distance at which a bead's heat has fallen to 1/e
  Length coolLength = 1000.0_mm;  ///< deposited length after which it has fallen to 1/e
  bool reverseOpen = false;       ///< open beads start at the nearer end
  bool alternate = false;
  AlternateBy alternateBy = AlternateBy::Layer;

  BeadReference beadReference = BeadReference::Centre;

  Length leadIn = 0.0_mm;
  Length leadOut = 0.0_mm;
  bool leadArc = false;
  Length rampIn = 0.0_mm;
  double rampInSpeed = 1.0;
  double rampInWire = 1.0;
  Length rampOut = 0.0_mm;
  double rampOutSpeed = 1.0;
  double rampOutWire = 1.0;
  Length overlap = 0.0_mm;
  Length wipe = 0.0_mm;
  Length wipeLift = 2.0_mm;

  AxisMode axis = AxisMode::Auto;
  bool axisProject = false;  ///< axes are projected on a plane (Chalvin A16c)
  std::array<double, 3> axisPlaneNormal{1.0, 0.0, 0.0};  ///< of the plane, substrate frame
  Angle axisLimit = 180.0_deg;  ///< greatest lean from the build direction of the substrate
  double axisRate = 0.0;        ///< greatest turn of the axis along a bead, degrees per mm; 0: any
  Angle axisDeviation = 10.0_deg;  ///< smoothing that turns an axis by more is reported
  Angle lead = 0.0_deg;
  Angle lateralTilt = 0.0_deg;

  static const Schema<PathParams>& schema();

  [[nodiscard]] ZoneParams zones() const;

  /// Chord error and spacing. Where none is given a path follows an exact surface to 0.01 mm, and
  /// a mesh as closely as the mesh follows its shape (finer would only copy the facets), but never
  /// farther than a bead would show; its points lie no farther apart than a bead is wide, nor than
  /// the 4.9 mm that keep a robot on the line (Chalvin A26).
  /// @param width of the beads, mm
  /// @param meshDeviation of the parts (geometry::meshDeviation), mm; 0 for exact surfaces
  [[nodiscard]] Sampling sampling(double width, double meshDeviation) const;
};

/// Orders the contours of each layer, chooses seams and directions, and gives every point its frame
/// (t, n, b), its inter-layer distance and its tool axis. The distance is the one to the layers
/// below or to the substrate, whichever is nearer; in a bead of several revolutions that to its own
/// revolution before. A height or width that the strategy gave is kept; other heights are the
/// distance.
///
/// Contours of a lower group come first; a bead of several revolutions keeps its start and
/// direction.
///
/// @param range the width of the beads, for BeadReference
/// Findings: toolpath.unsupported (a bead in the air), toolpath.outside_plate,
/// toolpath.seam_too_close, toolpath.contour_vanished, toolpath.axis_smoothed,
/// toolpath.axis_not_projected.
Toolpath buildToolpath(const SlicedLayers& contours,
                       const Substrate& substrate,
                       const PathParams& params,
                       const JobContext& context,
                       const BeadRange& range = {});

}  // namespace wcam::toolpath
