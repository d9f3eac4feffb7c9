// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/toolpath/fill.hpp"

#include <vector>

namespace wcam::toolpath {

/// Width of the room that a bead has to fill, along its length: the area of the layer that is
/// nearer to this bead than to any other, per length of the bead. Times the layer height it is the
/// section that the bead must have for the layer to become full and level. Between two neighbours
/// it is their centre distance (Ding 2015); at the border it reaches from the surface to half the
/// distance of the next bead.
class FillRoom {
public:
  FillRoom() = default;

  /// @param widths of equal pieces of the bead, mm
  FillRoom(std::vector<double> widths, double length, bool closed);

  /// Width at an arc length from the bead's first point, linear between the middles of pieces, mm.
  [[nodiscard]] double at(double s) const;
  /// Area of the room, mm².
  [[nodiscard]] double area() const;

private:
  std::vector<double> widths_;
  double length_ = 0.0;
  bool closed_ = false;
};

/// Area that falls to a place of a bead.
struct RoomShare {
  double s = 0.0;     ///< arc length from the bead's first point, mm
  double area = 0.0;  ///< mm²
};

/// How shares are averaged along a bead. Lengths in mm.
struct RoomAverage {
  double length = 0.0;      ///< that the shares know
  double fullLength = 0.0;  ///< of the bead itself
  double piece = 0.0;       ///< longest piece with one width
  double reach = 0.0;       ///< the weights are a triangle that reaches so far to both sides
  bool closed = false;
};

/// Bounds of the widths, mm.
struct RoomBounds {
  double least = 0.0;
  double most = 0.0;
  double mostAtEnds = 0.0;  ///< within the reach of the average from an open bead's ends
};

/// The shares averaged, since no torch follows faster changes. The whole area is kept: what would
/// go beyond an end comes back from it.
FillRoom averagedRoom(const std::vector<RoomShare>& shares,
                      const RoomAverage& average,
                      const RoomBounds& bounds);

/// Shares a layer among the beads that fill it. The rooms are exact along the beads (rays across
/// them, to the bisector of the next bead or to the border) and averaged over one bead width, since
/// no torch follows faster changes. Each width is at least that of the narrowest bead,
/// overlap·minWidth, and at most maxWidth; the ends of open beads also take what lies around
/// them.
/// @param region what the layer has to fill, mm²: the part's section, perhaps that of its middle
/// @param height of the layer, mm: where the border slopes, the outermost beads reach at most half
/// of it farther than their own width
/// @return one room per bead
/// Cost: some µs per millimetre of bead.
std::vector<FillRoom> shareRoom(const geometry::Region2& region,
                                const std::vector<FillBead>& beads,
                                const FillOptions& options,
                                double height);

/// Material of the beads in parts of the region's room, by area: more than 1 piles up, less leaves
/// voids.
double fillRatio(const geometry::Region2& region, const std::vector<FillRoom>& rooms);

}  // namespace wcam::toolpath
