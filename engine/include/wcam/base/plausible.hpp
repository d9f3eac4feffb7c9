// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"

#include <string>

namespace wcam {

/// What a quantity of a file can be at all, in file units.
struct PlausibleRange {
  double min;
  double max;
};

/// The widest range that any machine, part or process has, by far: what lies beyond it is damage or
/// another unit. Every number that comes from a file keeps it, whatever tighter limits its
/// parameter declares. QuantityKind::None is any finite number.
PlausibleRange plausibleRange(QuantityKind kind) noexcept;

/// Empty when a number (in file units) lies within the range of its kind; otherwise what is wrong,
/// with the figure and the range: "1e300 mm is not within -1000000 and 1000000 mm".
Text implausible(double value, QuantityKind kind);

/// The same for a range and a unit of one's own.
Text outOfRange(double value, const PlausibleRange& range, const std::string& unit);

}  // namespace wcam
