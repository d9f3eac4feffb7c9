// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/geometry/surface_projector.hpp"
#include "wcam/toolpath/generatrices.hpp"

#include "polyline.hpp"

#include <optional>
#include <string>
#include <vector>

namespace wcam::toolpath {

/// What the decompositions share.
struct Wall {
  const geometry::PartSurface* part = nullptr;
  const geometry::SurfaceProjector* projector = nullptr;
  WallLimits limits;
  Loop lower;                 ///< in the direction of travel
  std::optional<Loop> upper;  ///< nothing for a part that closes
};

/// A loop of mesh vertices as points.
std::vector<Vec3> loopPoints(const geometry::TriangleMesh& mesh,
                             const std::vector<std::uint32_t>& vertices);

/// The loop or its reverse, whichever runs like the reference.
Loop orientedLike(Loop loop, const Loop& reference);

/// Number of curves around a wall with these loops: neither the chord error nor the spacing is
/// passed.
std::size_t curveCount(const std::vector<Loop>& loops, const Sampling& sampling);

/// Level curves of a field that follows both limits, all in the direction of travel: the lower
/// limit, the levels, the upper limit of an open wall.
struct WallLoops {
  std::vector<Loop> loops;
  std::optional<Vec3> closure;  ///< of a part that closes
};

/// @param spacing mean distance of neighbouring loops, mm
/// @throws Error(JobFailed) when a level is not one closed curve
WallLoops loopsOf(const Wall& wall, double spacing, const JobContext& context);

Generatrices decomposeByIsoValues(const Wall& wall,
                                  const GeneratrixOptions& options,
                                  const JobContext& context);
Generatrices decomposeByGeodesics(const Wall& wall,
                                  const GeneratrixOptions& options,
                                  const JobContext& context);
Generatrices decomposeByEnvelope(const Wall& wall,
                                 const GeneratrixOptions& options,
                                 const JobContext& context);

}  // namespace wcam::toolpath
