// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/motion/plan.hpp"

namespace wcam::motion::detail {

/// The parameters of the collision checks.
void addCollision(Schema<MotionParams>& schema);

}  // namespace wcam::motion::detail
