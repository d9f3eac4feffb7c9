// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace wcam::motion::detail {

/// What a value may be at a time.
struct Gate {
  double time = 0.0;  ///< ascending from gate to gate
  double low = 0.0;
  double high = 0.0;
};

/// Values at the gates of the string that is pulled taut through them with both ends free. Of all
/// functions of time through the gates it has the least integral of every convex function of the
/// rate, so also the smallest greatest rate. (Between gates it is straight.) Linear time: a funnel
/// of the shortest paths to both ends of the gate that came last (Lee and Preparata 1984).
std::vector<double> tautString(const std::vector<Gate>& gates);

}  // namespace wcam::motion::detail
