// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/motion/plan.hpp"

namespace wcam::motion::detail {

/// How far a build direction may lean from the vertical when the positioner's best is `leastError`:
/// the tolerance where the positioner can hold it, else that much above its best, rad.
inline double allowedVerticalError(const MotionParams& params, double leastError) {
  const double tolerance = params.verticalTolerance.value();
  return leastError <= tolerance ? tolerance : leastError + tolerance;
}

}  // namespace wcam::motion::detail
