// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/plausible.hpp"

#include "wcam/base/json.hpp"
#include "wcam/base/text.hpp"

#include <cmath>
#include <limits>

namespace wcam {

namespace {

std::string plainNumber(double value) {
  constexpr double kWhole = 1e15;
  return std::abs(value) < kWhole && value == std::floor(value) ? formatFixed(value, 0)
                                                                : formatReal(value);
}

}  // namespace

PlausibleRange plausibleRange(QuantityKind kind) noexcept {
  constexpr double kEndless = std::numeric_limits<double>::max();
  switch (kind) {
    case QuantityKind::None:
      return {-kEndless, kEndless};
    case QuantityKind::Length:
      return {-1e6, 1e6};  // 1 km: no cell is as large
    case QuantityKind::Angle:
      return {-1e5, 1e5};  // 278 turns: more than any axis with a cable
    case QuantityKind::Time:
      return {-1e7, 1e7};  // four months
    case QuantityKind::Speed:
      return {-1e5, 1e5};  // 100 m/s
    case QuantityKind::AngularSpeed:
      return {-1e6, 1e6};  // 170 000 revolutions per minute
    case QuantityKind::WireSpeed:
      return {-1e3, 1e3};
    case QuantityKind::Area:
      return {-1e12, 1e12};
    case QuantityKind::Volume:
      return {-1e18, 1e18};
    case QuantityKind::Density:
      return {0.0, 100.0};  // osmium has 22.6
    case QuantityKind::Current:
    case QuantityKind::Voltage:
      return {-1e5, 1e5};
    case QuantityKind::Temperature:
      return {-273.15, 1e4};
    case QuantityKind::Ratio:
      return {-1e6, 1e6};
  }
  return {-kEndless, kEndless};
}

Text implausible(double value, QuantityKind kind) {
  return outOfRange(value, plausibleRange(kind), fileUnit(kind));
}

Text outOfRange(double value, const PlausibleRange& range, const std::string& unit) {
  if (!std::isfinite(value)) {
    return "is not a finite number";
  }
  if (value >= range.min && value <= range.max) {
    return {};
  }
  const std::vector<Text> words = {plainNumber(value), plainNumber(range.min),
                                   plainNumber(range.max), unit};
  return unit.empty() ? text("%1 is not within %2 and %3", words)
                      : text("%1 %4 is not within %2 and %3 %4", words);
}

}  // namespace wcam
