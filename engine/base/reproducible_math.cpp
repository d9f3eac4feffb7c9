// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The C library chooses its sin, cos, exp, ... by the processor: with and without FMA their last
// bits differ, and with them every table and sometimes the choice between two equal motions. These
// definitions take their place in every program that links the engine, for the engine, its
// libraries and its plugins alike (the dynamic linker binds a name to the first library that has
// it, and the engine stands before the C library). SLEEF's pure C functions give the same bits on
// every processor; they are within 1 unit in the last place. Measured on one machine: sine, cosine,
// tangent, arc cosine and arc tangent cost 1.4 to 3 times as much as the C library's, exponential
// and logarithms 2 to 6 times, acosh 9 times, asin less.
//
// Not here: functions whose C versions are the same on every processor (sqrt, hypot, cbrt, fmod,
// floor, ...; those of float, which compute in double and round).

#include <sleef.h>

// Declared by <cmath> as the C library does.
#include <cmath>

namespace {

/// The largest power of ten that a double holds exactly is 10^22.
constexpr double kLargestProduct = 22.0;

/// x^n by products: exact where the result and its factors are numbers of a double (10^22).
double powerByProducts(double x, int n) {
  double result = 1.0;
  for (double factor = x; n > 0; n /= 2, factor *= factor) {
    if (n % 2 == 1) {
      result *= factor;
    }
  }
  return result;
}

}  // namespace

// NOLINTBEGIN(readability-identifier-naming, bugprone-easily-swappable-parameters)
extern "C" {

// Sine and cosine are the two halves of one function: whether the compiler joins the two calls must
// not matter, and joined they cost little more than one.

double sin(double x) noexcept {
  return Sleef_cinz_sincosd1_u10purec(x).x;
}

double cos(double x) noexcept {
  return Sleef_cinz_sincosd1_u10purec(x).y;
}

void sincos(double x, double* sine, double* cosine) noexcept {
  const Sleef_double_2 both = Sleef_cinz_sincosd1_u10purec(x);
  *sine = both.x;
  *cosine = both.y;
}

double tan(double x) noexcept {
  return Sleef_cinz_tand1_u10purec(x);
}

double asin(double x) noexcept {
  return Sleef_cinz_asind1_u10purec(x);
}

double acos(double x) noexcept {
  return Sleef_cinz_acosd1_u10purec(x);
}

double atan(double x) noexcept {
  return Sleef_cinz_atand1_u10purec(x);
}

double atan2(double y, double x) noexcept {
  return Sleef_cinz_atan2d1_u10purec(y, x);
}

double sinh(double x) noexcept {
  return Sleef_cinz_sinhd1_u10purec(x);
}

double cosh(double x) noexcept {
  return Sleef_cinz_coshd1_u10purec(x);
}

double tanh(double x) noexcept {
  return Sleef_cinz_tanhd1_u10purec(x);
}

double asinh(double x) noexcept {
  return Sleef_cinz_asinhd1_u10purec(x);
}

double acosh(double x) noexcept {
  return Sleef_cinz_acoshd1_u10purec(x);
}

double atanh(double x) noexcept {
  return Sleef_cinz_atanhd1_u10purec(x);
}

double exp(double x) noexcept {
  return Sleef_cinz_expd1_u10purec(x);
}

double exp10(double x) noexcept {
  return Sleef_cinz_exp10d1_u10purec(x);
}

double expm1(double x) noexcept {
  return Sleef_cinz_expm1d1_u10purec(x);
}

double log(double x) noexcept {
  return Sleef_cinz_logd1_u10purec(x);
}

double log2(double x) noexcept {
  return Sleef_cinz_log2d1_u10purec(x);
}

double log10(double x) noexcept {
  return Sleef_cinz_log10d1_u10purec(x);
}

double log1p(double x) noexcept {
  return Sleef_cinz_log1pd1_u10purec(x);
}

double pow(double x, double y) noexcept {
  if (y == std::floor(y) && std::abs(y) <= kLargestProduct) {
    const double power = powerByProducts(x, static_cast<int>(std::abs(y)));
    return y < 0.0 ? 1.0 / power : power;
  }
  return Sleef_cinz_powd1_u10purec(x, y);
}

}  // extern "C"
// NOLINTEND(readability-identifier-naming, bugprone-easily-swappable-parameters)
