// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cell_model.hpp"
#include "plan_detail.hpp"

namespace wcam::motion::detail {

/// The scalars that smooth optimisation moves at a target.
enum class FreeScalar { Torch, Table, Lead, Lateral };
inline constexpr int kFreeScalars = 4;

/// Change of the robot's joints per change of each free scalar (per rad), the tool staying on the
/// target: dq/dξ = J⁻¹·∂x/∂ξ, analytic. The table is the positioner's last axis. Columns of scalars
/// that the cell does not have are zero. Bounded near singularities.
using FreeGradient = Eigen::Matrix<double, 6, kFreeScalars>;

FreeGradient freeGradient(const CellModel& model,
                          const Target& target,
                          const FreeChoice& choice,
                          const Pose& T_part_tcp,
                          const ArmState& state,
                          bool withTilt);

}  // namespace wcam::motion::detail
