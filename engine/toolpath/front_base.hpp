// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/toolpath/substrate.hpp"

#include "sampled_curve.hpp"
#include "surface_patch.hpp"

#include <memory>
#include <vector>

namespace wcam::toolpath {

/// A curve on the part with the triangle of each piece.
struct TracedCurve {
  std::unique_ptr<SampledCurve> curve;
  std::vector<std::uint32_t> triangles;
};

/// Where a part stands on its substrate.
struct FrontBase {
  std::vector<TracedCurve> curves;
  std::vector<bool> covered;  ///< per vertex: below the substrate, or inside a flat bottom
  std::shared_ptr<const void> keepAlive;  ///< what the curves refer to
};

/// Border loops on the substrate, rims of a flat bottom on it, or the curve in which the part
/// leaves the substrate. @throws Error(JobFailed) when there is none of these
FrontBase findFrontBase(const SurfacePatch& patch,
                        const Substrate& substrate,
                        const JobContext& context);

}  // namespace wcam::toolpath
