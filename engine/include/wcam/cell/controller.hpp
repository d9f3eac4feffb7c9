// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/value.hpp"

#include <string>

namespace wcam::cell {

/// Make of the controller that a cell file names ("FANUC", "KUKA"; robot.controller); empty: not
/// known.
/// @param file content of the file (Cell::source)
std::string controllerOf(const Value& file);

}  // namespace wcam::cell
