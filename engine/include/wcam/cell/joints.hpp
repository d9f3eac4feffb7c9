// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace wcam::cell {

/// Joint values in the cell's order (robot, then positioner), rad or mm. Up to 12 joints, no heap.
using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 12, 1>;

}  // namespace wcam::cell
