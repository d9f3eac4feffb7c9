// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plan_detail.hpp"

namespace wcam::motion::detail {

/// What the free scalars are measured from: splines describe the smooth rest.
struct RefineFrame {
  std::vector<double> gauge;  ///< torch rotation of every target
  std::size_t family = 0;     ///< gravity-aligned reference of the table
  bool moveTable = false;     ///< the table's offset from the reference is free
};

/// Smooth optimisation of the free scalars from a start: cubic B-splines over the length of each
/// bead (torch rotation and table as offsets from the frame, lead and lateral tilt where the
/// tolerance allows), Gauss–Newton with analytic gradients (gradient.hpp) on banded normal
/// equations. All objectives of the parameters but Jerk are residuals; constraints are squared
/// hinges inside tightened bounds whose weight grows until they hold. Branches stay. The result is
/// the start itself where nothing better (Evaluation::betterThan) is found. About 5 µs per point
/// and iteration.
Candidate refine(const Task& task,
                 const RefineFrame& frame,
                 const Candidate& start,
                 const JobContext& context,
                 const collision::Clearance* clearance);

}  // namespace wcam::motion::detail
