// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "colours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::gui {

namespace {

// Dark blue over green to yellow and red: light enough on dark, dark enough on light.
constexpr std::array<viewport::Colour, 6> kScale = {
    {{46, 78, 158}, {41, 137, 178}, {63, 176, 120}, {180, 200, 60}, {240, 160, 44}, {210, 62, 52}}};

constexpr std::array<viewport::Colour, 8> kKinds = {{{74, 144, 200},
                                                     {236, 152, 60},
                                                     {100, 176, 92},
                                                     {206, 78, 84},
                                                     {150, 116, 190},
                                                     {150, 110, 90},
                                                     {226, 128, 190},
                                                     {120, 126, 134}}};

// Nothing, information, warning, violation.
constexpr std::array<viewport::Colour, 4> kFindings = {
    {{120, 170, 140}, {80, 140, 210}, {240, 170, 40}, {215, 50, 50}}};

constexpr viewport::Colour kNoValue = {140, 140, 146};

}  // namespace

viewport::Colour scaleColour(double fraction) {
  const double at = std::clamp(fraction, 0.0, 1.0) * (kScale.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kScale.size() - 2);
  const double t = at - static_cast<double>(low);
  viewport::Colour colour{};
  for (std::size_t i = 0; i < 3; ++i) {
    colour[i] =
        static_cast<std::uint8_t>(std::lround((1.0 - t) * kScale[low][i] + t * kScale[low + 1][i]));
  }
  return colour;
}

viewport::Colour kindColour(int kind) {
  return kKinds[static_cast<std::size_t>(kind) % kKinds.size()];
}

bool isKind(Quantity quantity) {
  return quantity == Quantity::Feature || quantity == Quantity::Finding;
}

Coloured colourPath(const PathModel& path,
                    Quantity quantity,
                    const std::optional<std::pair<float, float>>& range) {
  Coloured result;
  const std::vector<float> values = path.values(quantity);
  result.rgb.resize(3 * values.size());
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i]) && path.point(i) >= 0) {
      low = std::min(low, values[i]);
      high = std::max(high, values[i]);
    }
  }
  result.empty = !(low <= high);
  if (result.empty) {
    low = high = 0.0F;
  }
  if (range) {
    std::tie(low, high) = *range;
  }
  result.low = low;
  result.high = high;
  // Values that are the same up to rounding have one colour.
  const float span =
      high - low > 1e-5F * std::max(std::abs(low), std::abs(high)) ? high - low : 0.0F;
  std::array<bool, 32> seen{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    viewport::Colour colour = kNoValue;
    if (std::isfinite(values[i])) {
      if (isKind(quantity)) {
        const int kind = std::clamp(static_cast<int>(values[i]), 0, 31);
        seen[static_cast<std::size_t>(kind)] =
            seen[static_cast<std::size_t>(kind)] || path.point(i) >= 0;
        colour = quantity == Quantity::Finding
                     ? kFindings[static_cast<std::size_t>(std::min(kind, 3))]
                     : kindColour(kind);
      } else if (quantity == Quantity::Layer && !range) {
        // Neighbouring layers are told apart: the scale with a light and a dark turn.
        colour = scaleColour(span > 0.0F ? (values[i] - low) / span : 0.35);
        if (static_cast<int>(values[i]) % 2 != 0) {
          for (std::uint8_t& c : colour) {
            c = static_cast<std::uint8_t>(c * 4 / 5);
          }
        }
      } else {
        colour = scaleColour(span > 0.0F ? (values[i] - low) / span : 0.35);
      }
    }
    std::copy(colour.begin(), colour.end(),
              result.rgb.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
  for (int kind = 0; kind < 32; ++kind) {
    if (isKind(quantity) && seen[static_cast<std::size_t>(kind)]) {
      result.kinds.push_back(kind);
    }
  }
  return result;
}

}  // namespace wcam::gui
