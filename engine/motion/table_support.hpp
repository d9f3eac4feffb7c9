// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/toolpath/substrate.hpp"

namespace wcam::motion::detail {

/// Finding motion.beside_table (violation) where no part of the substrate lies above the table that
/// should carry it: nothing could hold it there. Looked at where the cell knows the shapes of its
/// table (frame "table").
void checkTable(const cell::Cell& cell,
                const toolpath::Substrate& substrate,
                const JobContext& context);

}  // namespace wcam::motion::detail
