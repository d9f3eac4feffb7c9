// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/toolpath/plane_field.hpp"
#include "wcam/toolpath/slicing.hpp"

namespace wcam::toolpath {

/// Planes at such heights that the greatest distance of a layer's points to the layer below is the
/// step (Chalvin A6; on a body of revolution these are the parallels of A7). The height between two
/// planes stays inside the process's range: where the least height still gives a greater distance
/// (a flat overhang, a new island) it is taken, and told.
///
/// Findings: slicing.step_not_kept per layer whose distance is greater than the step, with the
/// distance.
/// @param options the step is the wanted distance
/// @throws Error as planeStack; Error(InvalidArgument) when the range ascends not or the step lies
/// outside it
/// Cost: some ten sections per layer.
PlaneStack adaptivePlanes(const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                          const Substrate& substrate,
                          const PlaneStackOptions& options,
                          const BeadRange& range,
                          const Sampling& sampling,
                          const JobContext& context);

}  // namespace wcam::toolpath
