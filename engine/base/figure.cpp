// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/figure.hpp"

#include <charconv>
#include <cmath>

namespace wcam {

std::string formatFigure(double value) {
  if (!std::isfinite(value)) {
    return "not a number";
  }
  constexpr int kDigits = 4;
  constexpr double kWhole = 1e4;
  constexpr double kLongest = 1e9;
  char buffer[64];
  const double size = std::abs(value);
  if (size >= kWhole && size < kLongest) {
    const auto whole = std::to_chars(buffer, buffer + sizeof buffer, std::round(value),
                                     std::chars_format::fixed, 0);
    return {buffer, whole.ptr};
  }
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value == 0.0 ? 0.0 : value,
                                 std::chars_format::general, kDigits);
  return {buffer, end.ptr};
}

}  // namespace wcam
