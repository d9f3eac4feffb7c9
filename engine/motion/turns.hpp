// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plan_detail.hpp"

namespace wcam::motion::detail {

/// Full turns of all periodic robot joints. Inside a run each value follows the one before; then
/// each run is moved by whole turns as one piece, so that all runs lie inside the limits (where
/// they can, else sharing the excess between both sides) and the sum of squared moves between runs
/// is least. With a cable limit the turns of an endless axis 6 keep the twist of each run nearest
/// to the cable's zero instead.
void chooseTurns(const Task& task, Motion& motion, const JobContext& context);

}  // namespace wcam::motion::detail
