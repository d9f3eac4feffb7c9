// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/types.hpp"
#include "wcam/toolpath/slicing.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace wcam::toolpath {

/// Which part of a bead a move belongs to.
enum class BeadZone { Body, LeadIn, Overlap, LeadOut, Wipe };

/// What holds the section of a bead where an edit changes travel speed or wire feed: the process's
/// plan (nothing changed), or what follows the change.
enum class SectionRule { Plan, Width, Wire, Speed };

/// What edits want of the move that ends at a point: a factor of what the process plans, or a value
/// in mm/s.
struct ProcessChange {
  double speed = 1.0;
  double wire = 1.0;
  bool speedIsValue = false;
  bool wireIsValue = false;
  SectionRule section = SectionRule::Plan;
};

/// A point of a bead, in the part frame. (t, n, b) is right-handed: t along travel, n the outward
/// surface normal made perpendicular to t (the inward one on a bead that runs back), b = t × n the
/// build direction.
struct PathPoint {
  Vec3 p = Vec3::Zero();  ///< mm
  Vec3 t = Vec3::UnitX();
  Vec3 n = Vec3::UnitY();
  Vec3 b = Vec3::UnitZ();
  Vec3 axis =
      Vec3::UnitZ();  ///< tool axis, from the part towards the torch, with lead and lateral tilt
  Vec3 up =
      Vec3::UnitZ();      ///< axis before lead and tilt: what the positioner turns to the vertical
  double distance = 0.0;  ///< inter-layer distance δ to the layer below, mm (Chalvin A4)
  double height = 0.0;    ///< local layer height: the strategy's, else the distance, mm
  double width = 0.0;     ///< bead width, mm; 0 before the process is applied: the process's
  /// Mean width that the bead fills up to its height beside its neighbours, mm: its section is
  /// fillWidth·height. 0: a bead that stands alone, whose section follows from width and height.
  double fillWidth = 0.0;
  double speed = 0.0;      ///< travel speed of the move that ends here, mm/s
  double wireSpeed = 0.0;  ///< wire feed speed of the move that ends here, mm/s
  /// The arc burns during the move that ends here; without meaning at the first point.
  bool arc = true;
  BeadZone zone = BeadZone::Body;  ///< of the move that ends here (of the first point: that begins)
  double speedFactor = 1.0;        ///< of the travel speed, in ramps
  double wireFactor = 1.0;         ///< of the wire feed speed, in ramps
  ProcessChange change = {};       ///< by edits, of the move that ends here
};

/// One run of the torch with the arc on, perhaps with moves before and after it whose arc is off. A
/// closed bead repeats the first point of its body as the body's last one.
struct Bead {
  std::vector<PathPoint> points;
  bool closed = false;
  /// Runs against the direction in which n is outward: the outward normal is then −n.
  bool back = false;
  int part = 0;  ///< index of the part in the operation
  BeadFeature feature = BeadFeature::Wall;
  int revolutions = 0;       ///< of a bead that climbs (Contour::turns); 0 for a bead of one layer
  double pauseBefore = 0.0;  ///< s that the torch waits above the start, arc off, before the bead
  double pauseAfter = 0.0;   ///< s that it waits above the end afterwards
  [[nodiscard]] double length() const;

  /// The outward surface normal at a point of the bead.
  [[nodiscard]] Vec3 outward(const PathPoint& point) const {
    return back ? Vec3(-point.n) : point.n;
  }
};

struct Layer {
  double level = 0.0;       ///< value of the field: mm along the build direction or along the guide
  Vec3 up = Vec3::UnitZ();  ///< mean build direction of the layer
  std::vector<Bead> beads;
};

/// What an operation deposits, in order.
struct Toolpath {
  std::vector<Layer> layers;
  [[nodiscard]] std::size_t beadCount() const;
  [[nodiscard]] std::size_t pointCount() const;
};

}  // namespace wcam::toolpath
