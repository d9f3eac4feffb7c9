// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/part_surface.hpp"
#include "wcam/geometry/segment_tree.hpp"
#include "wcam/toolpath/fill_room.hpp"

#include "cladding_beads.hpp"

#include <functional>
#include <vector>

namespace wcam::cladding {

/// Lengths in mm.
struct RoomOptions {
  double width = 8.0;    ///< of a bead
  double spacing = 5.3;  ///< of neighbouring beads
  double stock = 0.0;    ///< width that a bead on the border fills beyond it
  double reach = 8.0;    ///< what lies farther from every bead is not covered
};

/// What each bead has to fill for the layers to become full and level: the surface that is nearer
/// to it than to any other bead, and for higher layers that surface moved along its normals.
class SurfaceRoom {
public:
  /// @param counts whether a triangle is to be covered
  /// @param border of the surface
  /// Cost: some ten nearest-segment queries per millimetre of bead.
  SurfaceRoom(const geometry::PartSurface& part,
              const std::vector<SurfaceCurve>& curves,
              const std::function<bool(std::uint32_t)>& counts,
              const geometry::SegmentTree& border,
              const RoomOptions& options);

  /// Area per length of a curve for a layer whose middle lies at this height above the surface.
  [[nodiscard]] toolpath::FillRoom at(std::size_t curve, double height) const;

  /// What no bead reaches, mm².
  [[nodiscard]] double uncoveredArea() const { return uncovered_; }

private:
  /// Area a + b·h + c·h² at the height h.
  struct Piece {
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
  };

  struct Room {
    std::vector<Piece> pieces;  ///< equal lengths of the curve
    double length = 0.0;
    bool closed = false;
  };

  class Sharer;

  RoomOptions options_;
  std::vector<Room> rooms_;
  double uncovered_ = 0.0;
};

}  // namespace wcam::cladding
