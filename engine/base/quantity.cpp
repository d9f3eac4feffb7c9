// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace wcam {

namespace {

struct Unit {
  QuantityKind kind;
  const char* name;
  double factor;  ///< internal = factor · value (+ 0)
};

constexpr double kDegree = kPi / 180.0;

/// The first unit of each kind is the file unit.
constexpr std::array kUnits = {
    Unit{QuantityKind::Length, "mm", 1.0},
    Unit{QuantityKind::Length, "cm", 10.0},
    Unit{QuantityKind::Length, "m", 1000.0},
    Unit{QuantityKind::Length, "um", 0.001},
    Unit{QuantityKind::Length, "in", 25.4},
    Unit{QuantityKind::Angle, "deg", kDegree},
    Unit{QuantityKind::Angle, "\xc2\xb0", kDegree},
    Unit{QuantityKind::Angle, "rad", 1.0},
    Unit{QuantityKind::Time, "s", 1.0},
    Unit{QuantityKind::Time, "ms", 0.001},
    Unit{QuantityKind::Time, "min", 60.0},
    Unit{QuantityKind::Speed, "mm/s", 1.0},
    Unit{QuantityKind::Speed, "mm/min", 1.0 / 60.0},
    Unit{QuantityKind::Speed, "cm/min", 10.0 / 60.0},
    Unit{QuantityKind::Speed, "m/min", 1000.0 / 60.0},
    Unit{QuantityKind::Speed, "m/s", 1000.0},
    Unit{QuantityKind::AngularSpeed, "deg/s", kDegree},
    Unit{QuantityKind::AngularSpeed, "rad/s", 1.0},
    Unit{QuantityKind::WireSpeed, "m/min", 1000.0 / 60.0},
    Unit{QuantityKind::WireSpeed, "mm/s", 1.0},
    Unit{QuantityKind::WireSpeed, "cm/min", 10.0 / 60.0},
    Unit{QuantityKind::Area, "mm2", 1.0},
    Unit{QuantityKind::Volume, "mm3", 1.0},
    Unit{QuantityKind::Density, "g/cm3", 1.0},
    Unit{QuantityKind::Density, "kg/m3", 0.001},
    Unit{QuantityKind::Current, "A", 1.0},
    Unit{QuantityKind::Voltage, "V", 1.0},
    Unit{QuantityKind::Temperature, "degC", 1.0},
    Unit{QuantityKind::Temperature,
         "\xc2\xb0"
         "C",
         1.0},
    Unit{QuantityKind::Ratio, "%", 0.01},
};

const Unit* fileUnitOf(QuantityKind kind) noexcept {
  if (kind == QuantityKind::Ratio) {
    return nullptr;  // a ratio is written as a plain number
  }
  for (const Unit& unit : kUnits) {
    if (unit.kind == kind) {
      return &unit;
    }
  }
  return nullptr;
}

}  // namespace

const char* toString(QuantityKind kind) noexcept {
  switch (kind) {
    case QuantityKind::None:
      return "none";
    case QuantityKind::Length:
      return "length";
    case QuantityKind::Angle:
      return "angle";
    case QuantityKind::Time:
      return "time";
    case QuantityKind::Speed:
      return "speed";
    case QuantityKind::AngularSpeed:
      return "angular_speed";
    case QuantityKind::WireSpeed:
      return "wire_speed";
    case QuantityKind::Area:
      return "area";
    case QuantityKind::Volume:
      return "volume";
    case QuantityKind::Density:
      return "density";
    case QuantityKind::Current:
      return "current";
    case QuantityKind::Voltage:
      return "voltage";
    case QuantityKind::Temperature:
      return "temperature";
    case QuantityKind::Ratio:
      return "ratio";
  }
  return "none";
}

const char* fileUnit(QuantityKind kind) noexcept {
  const Unit* unit = fileUnitOf(kind);
  return unit != nullptr ? unit->name : "";
}

double fromFileUnit(QuantityKind kind, double value) noexcept {
  const Unit* unit = fileUnitOf(kind);
  return unit != nullptr ? value * unit->factor : value;
}

double toFileUnit(QuantityKind kind, double value) noexcept {
  const Unit* unit = fileUnitOf(kind);
  return unit != nullptr ? value / unit->factor : value;
}

double toFileNumber(QuantityKind kind, double value) noexcept {
  const double number = toFileUnit(kind, value);
  char buffer[40];
  const auto [end, error] =
      std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::general, 12);
  double rounded = number;
  if (error == std::errc{}) {
    std::from_chars(buffer, end, rounded);
  }
  return rounded;
}

double parseQuantity(std::string_view text, QuantityKind kind) {
  const std::string_view trimmed = trimText(text);
  std::string_view digits = trimmed;
  if (digits.starts_with('+') && !digits.starts_with("+-")) {
    digits.remove_prefix(1);
  }
  double number = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  std::string accepted;
  for (const Unit& unit : kUnits) {
    if (unit.kind == kind) {
      accepted += (accepted.empty() ? "" : ", ") + std::string(unit.name);
    }
  }
  const Text hint = accepted.empty() ? wcam::text("write a plain number")
                                     : wcam::text("write a number with one of: %1", {accepted});
  if (digits.empty() || error != std::errc{} || !std::isfinite(number)) {
    throw Error(ErrorCode::InvalidArgument, wcam::text("'%1' is not a number", {std::string(text)}),
                {}, hint);
  }
  const std::string_view unitText = trimText(
      std::string_view(end, static_cast<std::size_t>(digits.data() + digits.size() - end)));
  if (unitText.empty()) {
    return fromFileUnit(kind, number);
  }
  for (const Unit& unit : kUnits) {
    if (unit.kind == kind && unitText == unit.name) {
      const double value = number * unit.factor;
      if (!std::isfinite(value)) {
        break;
      }
      return value;
    }
  }
  throw Error(ErrorCode::InvalidArgument,
              wcam::text("'%1' is no unit of %2", {std::string(unitText), toString(kind)}), {},
              hint);
}

}  // namespace wcam
