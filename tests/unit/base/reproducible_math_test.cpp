// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "random_source.hpp"
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

/// The mathematical functions that take the place of the C library's (reproducible_math.cpp).
namespace wcam {
namespace {

struct Function {
  const char* name;
  double (*value)(double);
  long double (*reference)(long double);
  double low;
  double high;
};

void PrintTo(const Function& function, std::ostream* out) {
  *out << function.name;
}

class ReproducibleMath : public ::testing::TestWithParam<Function> {};

/// In the units of the last place of the true value.
double errorOf(double value, long double truth) {
  const double near = std::abs(static_cast<double>(truth));
  const double unit = std::nextafter(near, std::numeric_limits<double>::infinity()) - near;
  return static_cast<double>(std::abs(static_cast<long double>(value) - truth)) / unit;
}

TEST_P(ReproducibleMath, IsWithinOneUnitInTheLastPlace) {
  const Function& function = GetParam();
  testing::RandomSource random(1);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.real(function.low, function.high);
    ASSERT_LE(errorOf(function.value(x), function.reference(x)), 1.0) << x;
  }
}

/// For all libraries of the process, not for the engine's calls alone.
TEST_P(ReproducibleMath, StandsBeforeTheCLibrary) {
  void* const symbol = ::dlsym(RTLD_DEFAULT, GetParam().name);
  ASSERT_NE(symbol, nullptr);
  Dl_info info;
  ASSERT_NE(::dladdr(symbol, &info), 0);
  EXPECT_NE(std::string(info.dli_fname).find("wcam-engine"), std::string::npos) << info.dli_fname;
}

#define WCAM_FUNCTION(name, low, high)                                                             \
  Function {                                                                                       \
#name, [](double x) { return std::name(x); }, [](long double x) { return std::name(x); }, low, \
                                                                                           high    \
  }

INSTANTIATE_TEST_SUITE_P(Functions,
                         ReproducibleMath,
                         ::testing::Values(WCAM_FUNCTION(sin, -1e3, 1e3),
                                           WCAM_FUNCTION(cos, -1e3, 1e3),
                                           WCAM_FUNCTION(tan, -10, 10),
                                           WCAM_FUNCTION(asin, -1, 1),
                                           WCAM_FUNCTION(acos, -1, 1),
                                           WCAM_FUNCTION(atan, -100, 100),
                                           WCAM_FUNCTION(sinh, -10, 10),
                                           WCAM_FUNCTION(cosh, -10, 10),
                                           WCAM_FUNCTION(tanh, -10, 10),
                                           WCAM_FUNCTION(asinh, -10, 10),
                                           WCAM_FUNCTION(acosh, 1, 10),
                                           WCAM_FUNCTION(atanh, -1, 1),
                                           WCAM_FUNCTION(exp, -300, 300),
                                           WCAM_FUNCTION(expm1, -10, 10),
                                           WCAM_FUNCTION(log, 0, 1e3),
                                           WCAM_FUNCTION(log2, 0, 1e3),
                                           WCAM_FUNCTION(log10, 0, 1e3),
                                           WCAM_FUNCTION(log1p, -1, 10)));

TEST(ReproducibleMath, ArcTangentOfTwo) {
  testing::RandomSource random(1);
  for (int i = 0; i < 20000; ++i) {
    const double y = random.real(-10.0, 10.0);
    const double x = random.real(-10.0, 10.0);
    ASSERT_LE(errorOf(std::atan2(y, x), std::atan2(static_cast<long double>(y), x)), 1.0)
        << y << " " << x;
  }
  EXPECT_EQ(std::atan2(0.0, -1.0), std::acos(-1.0));
  EXPECT_EQ(std::atan2(-0.0, -1.0), -std::acos(-1.0));
  EXPECT_TRUE(std::signbit(std::atan2(-0.0, 1.0)));
}

TEST(ReproducibleMath, Powers) {
  double exact = 1.0;
  for (int n = 0; n <= 22; ++n, exact *= 10.0) {
    EXPECT_EQ(std::pow(10.0, n), exact);
    EXPECT_EQ(std::pow(10.0, -n), 1.0 / exact);
    EXPECT_EQ(std::pow(-2.0, n), (n % 2 == 0 ? 1.0 : -1.0) * std::ldexp(1.0, n));
  }
  testing::RandomSource random(1);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.real(0.0, 10.0);
    const double y = random.real(-10.0, 10.0);
    ASSERT_LE(errorOf(std::pow(x, y), std::pow(static_cast<long double>(x), y)), 1.0)
        << x << " " << y;
    ASSERT_EQ(std::pow(x, 2.0), x * x);
  }
  EXPECT_TRUE(std::isnan(std::pow(-8.0, 1.0 / 3.0)));
  EXPECT_EQ(std::pow(0.0, 0.0), 1.0);
}

}  // namespace
}  // namespace wcam
