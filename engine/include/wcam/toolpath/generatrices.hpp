// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/slicing.hpp"

#include <cstdint>
#include <vector>

namespace wcam::toolpath {

/// How a wall is decomposed into curves from its lower to its upper limit (Diourté 3.3).
enum class Decomposition {
  IsoValues,  ///< level curves of a field that follows both limits, linked from one to the next
              ///< (M17–M19)
  Geodesic,   ///< shortest paths, filled up where they leave gaps (M13–M16)
  Envelope  ///< straight lines of a cylinder projected towards the part's axis (M12): no overhangs
};

/// A curve from the lower to the upper limit of a wall.
class Generatrix {
public:
  /// @param points at least two, the first on the lower limit
  explicit Generatrix(std::vector<Vec3> points);

  [[nodiscard]] double length() const noexcept { return arc_.back(); }

  [[nodiscard]] const std::vector<Vec3>& points() const noexcept { return points_; }

  /// Point at an arc length, linear between the points; clamped to the ends.
  [[nodiscard]] Vec3 at(double arc) const;

private:
  std::vector<Vec3> points_;
  std::vector<double> arc_;
};

struct GeneratrixOptions {
  Decomposition method = Decomposition::IsoValues;
  Vec3 up = Vec3::UnitZ();  ///< build direction: tells below from above for the envelope
  double step = 2.0;        ///< layer height; the curves are resolved to a part of it, mm
  Sampling sampling;        ///< bounds the distance of neighbouring curves
  std::size_t count = 0;    ///< number of curves; 0: from the sampling
  double coverage = 0.0;  ///< geodesic: greatest gap of the surface to the curves, mm; 0: the step
};

/// The limits of a wall with one bead of thickness: one loop below, at most one above.
struct WallLimits {
  std::vector<std::uint32_t> lower;  ///< vertices of the lower loop
  std::vector<std::uint32_t> upper;  ///< of the upper one; empty for a part that closes in a point
};

struct Generatrices {
  std::vector<Generatrix> curves;  ///< in the order of travel (t × n = up); the first at the seam
  bool closes = false;             ///< the part closes in a point
  Vec3 closure = Vec3::Zero();     ///< that point
  std::size_t filled = 0;          ///< curves added to cover the surface
};

/// Decomposes a wall. The mesh must be fine enough for the step (refineSurface).
///
/// @throws Error(JobFailed) when the surface branches (names the level and the place), when the
/// envelope meets an overhang (names the height), when the surface has no way from one limit to the
/// other
/// Cost: one field solution and O(n) tracing; the geodesic method adds the triangles crossed.
Generatrices decomposeWall(const geometry::PartSurface& part,
                           const WallLimits& limits,
                           const GeneratrixOptions& options,
                           const JobContext& context);

}  // namespace wcam::toolpath
