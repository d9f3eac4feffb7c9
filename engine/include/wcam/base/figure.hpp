// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace wcam {

/// A number of any size as people read it: four significant digits, without zeros at the end, with
/// an exponent only where it would be very long. Findings use it where the size is not known
/// beforehand, formatFixed where it is, and never a double as files have it.
std::string formatFigure(double value);

}  // namespace wcam
