// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/collision/cell_collision.hpp"

#include "scene.hpp"

namespace wcam::collision::detail {

/// See CellCollision::standingContacts.
std::vector<StandingContact> standingContacts(const Scene& scene,
                                              const toolpath::Toolpath& path,
                                              std::span<const CellState> states,
                                              const JobContext& context);

}  // namespace wcam::collision::detail
