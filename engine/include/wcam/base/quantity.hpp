// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace wcam {

/// What a number measures. Internal units: mm, rad, s and the ones named below.
enum class QuantityKind {
  None,
  Length,        ///< mm
  Angle,         ///< rad inside, degrees in files
  Time,          ///< s
  Speed,         ///< mm/s
  AngularSpeed,  ///< rad/s inside, deg/s in files
  WireSpeed,     ///< mm/s inside, m/min in files
  Area,          ///< mm²
  Volume,        ///< mm³
  Density,       ///< g/cm³
  Current,       ///< A
  Voltage,       ///< V
  Temperature,   ///< °C
  Ratio          ///< dimensionless
};

/// Stable name in schemas, for example "length".
const char* toString(QuantityKind kind) noexcept;
/// Unit of the kind in files and in the interface: "mm", "deg", "s", "mm/s", "m/min", ... ("" for
/// None).
const char* fileUnit(QuantityKind kind) noexcept;
double fromFileUnit(QuantityKind kind, double value) noexcept;
double toFileUnit(QuantityKind kind, double value) noexcept;
/// toFileUnit rounded to 12 significant digits, so that 30 degrees are written as 30.
double toFileNumber(QuantityKind kind, double value) noexcept;

/// Reads "2.5mm", "0.1 in", "30°", "0.5rad", "36cm/min", "2.3 m/min", or a bare number in the file
/// unit.
/// @return the value in the internal unit
/// @throws Error(InvalidArgument) naming the text and the units that would be accepted
double parseQuantity(std::string_view text, QuantityKind kind);

/// A number that cannot be mixed up with another quantity. value() is in the internal unit.
template <QuantityKind K>
class Quantity {
public:
  static constexpr QuantityKind kKind = K;
  constexpr Quantity() = default;

  constexpr explicit Quantity(double internal) : value_(internal) {}

  [[nodiscard]] constexpr double value() const noexcept { return value_; }

  friend constexpr auto operator<=>(const Quantity&, const Quantity&) = default;

  friend constexpr Quantity operator+(Quantity a, Quantity b) {
    return Quantity(a.value_ + b.value_);
  }

  friend constexpr Quantity operator-(Quantity a, Quantity b) {
    return Quantity(a.value_ - b.value_);
  }

  friend constexpr Quantity operator*(double s, Quantity a) { return Quantity(s * a.value_); }

  friend constexpr Quantity operator*(Quantity a, double s) { return Quantity(s * a.value_); }

  friend constexpr Quantity operator/(Quantity a, double s) { return Quantity(a.value_ / s); }

  friend constexpr double operator/(Quantity a, Quantity b) { return a.value_ / b.value_; }

  constexpr Quantity operator-() const { return Quantity(-value_); }

private:
  double value_ = 0.0;
};

using Length = Quantity<QuantityKind::Length>;
using Angle = Quantity<QuantityKind::Angle>;
using Duration = Quantity<QuantityKind::Time>;
using Speed = Quantity<QuantityKind::Speed>;
using AngularSpeed = Quantity<QuantityKind::AngularSpeed>;
using WireSpeed = Quantity<QuantityKind::WireSpeed>;

inline constexpr double kPi = 3.14159265358979323846;

constexpr double degToRad(double deg) noexcept {
  return deg * (kPi / 180.0);
}

constexpr double radToDeg(double rad) noexcept {
  return rad * (180.0 / kPi);
}

inline namespace literals {
constexpr Length operator""_mm(long double v) {
  return Length(static_cast<double>(v));
}

constexpr Angle operator""_deg(long double v) {
  return Angle(degToRad(static_cast<double>(v)));
}

constexpr Angle operator""_rad(long double v) {
  return Angle(static_cast<double>(v));
}

constexpr Duration operator""_s(long double v) {
  return Duration(static_cast<double>(v));
}

constexpr Speed operator""_mm_s(long double v) {
  return Speed(static_cast<double>(v));
}

constexpr WireSpeed operator""_m_min(long double v) {
  return WireSpeed(static_cast<double>(v) * 1000.0 / 60.0);
}
}  // namespace literals

}  // namespace wcam
