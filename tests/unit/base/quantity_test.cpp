// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"

#include "error_matchers.hpp"

#include <cmath>
#include <string>

namespace wcam {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using wcam::testing::errorOf;

constexpr QuantityKind kKinds[] = {
    QuantityKind::None,        QuantityKind::Length,  QuantityKind::Angle,
    QuantityKind::Time,        QuantityKind::Speed,   QuantityKind::AngularSpeed,
    QuantityKind::WireSpeed,   QuantityKind::Area,    QuantityKind::Volume,
    QuantityKind::Density,     QuantityKind::Current, QuantityKind::Voltage,
    QuantityKind::Temperature, QuantityKind::Ratio};

struct Case {
  const char* text;
  QuantityKind kind;
  double internal;
};

TEST(Quantity, ReadsEveryUnit) {
  const Case cases[] = {
      {"2.5mm", QuantityKind::Length, 2.5},
      {"2.5 cm", QuantityKind::Length, 25.0},
      {"0.25m", QuantityKind::Length, 250.0},
      {"40um", QuantityKind::Length, 0.04},
      {"0.1 in", QuantityKind::Length, 2.54},
      {"180deg", QuantityKind::Angle, kPi},
      {"90°", QuantityKind::Angle, kPi / 2},
      {"0.5rad", QuantityKind::Angle, 0.5},
      {"3s", QuantityKind::Time, 3.0},
      {"250 ms", QuantityKind::Time, 0.25},
      {"2min", QuantityKind::Time, 120.0},
      {"7mm/s", QuantityKind::Speed, 7.0},
      {"600 mm/min", QuantityKind::Speed, 10.0},
      {"36cm/min", QuantityKind::Speed, 6.0},
      {"0.6 m/min", QuantityKind::Speed, 10.0},
      {"0.02m/s", QuantityKind::Speed, 20.0},
      {"180deg/s", QuantityKind::AngularSpeed, kPi},
      {"2 rad/s", QuantityKind::AngularSpeed, 2.0},
      {"3 m/min", QuantityKind::WireSpeed, 50.0},
      {"50mm/s", QuantityKind::WireSpeed, 50.0},
      {"300cm/min", QuantityKind::WireSpeed, 50.0},
      {"4mm2", QuantityKind::Area, 4.0},
      {"5mm3", QuantityKind::Volume, 5.0},
      {"7.85 g/cm3", QuantityKind::Density, 7.85},
      {"7850kg/m3", QuantityKind::Density, 7.85},
      {"120A", QuantityKind::Current, 120.0},
      {"18.5V", QuantityKind::Voltage, 18.5},
      {"20degC", QuantityKind::Temperature, 20.0},
      {"20 °C", QuantityKind::Temperature, 20.0},
      {"5%", QuantityKind::Ratio, 0.05},
      {"0.05", QuantityKind::Ratio, 0.05},
      {"3", QuantityKind::None, 3.0},
  };
  for (const Case& c : cases) {
    EXPECT_NEAR(parseQuantity(c.text, c.kind), c.internal, 1e-15 * std::abs(c.internal)) << c.text;
  }
}

TEST(Quantity, BareNumberIsInTheFileUnit) {
  EXPECT_DOUBLE_EQ(parseQuantity("90", QuantityKind::Angle), kPi / 2);
  EXPECT_DOUBLE_EQ(parseQuantity("3", QuantityKind::WireSpeed), 50.0);
  EXPECT_DOUBLE_EQ(parseQuantity(" +1e-3 ", QuantityKind::Length), 1e-3);
  EXPECT_DOUBLE_EQ(parseQuantity("-.5", QuantityKind::Length), -0.5);
}

TEST(Quantity, RefusesWhatIsNoNumber) {
  for (const char* text : {"",      " ",        "mm",     "abc",   "+",     "-",   "+-5", "--5",
                           "1e400", "-1e400mm", "inf",    "nan",   "infmm", "1,5", "1 2", "0x10",
                           "5 m m", "5MM",      "5mm mm", "5mm/s", "5\xff", "5deg"}) {
    const std::string message = errorOf(ErrorCode::InvalidArgument,
                                        [&] { (void)parseQuantity(text, QuantityKind::Length); });
    EXPECT_THAT(message, HasSubstr("mm, cm, m, um, in")) << text;
  }
  EXPECT_THAT(
      errorOf(ErrorCode::InvalidArgument, [] { (void)parseQuantity("3mm", QuantityKind::None); }),
      AllOf(HasSubstr("'mm' is no unit of none"), HasSubstr("plain number")));
  // Finite as written, not finite in mm.
  errorOf(ErrorCode::InvalidArgument, [] { (void)parseQuantity("1e307m", QuantityKind::Length); });
}

TEST(Quantity, FileUnitsGoBothWays) {
  for (const QuantityKind kind : kKinds) {
    EXPECT_STRNE(toString(kind), "");
    EXPECT_DOUBLE_EQ(fromFileUnit(kind, toFileUnit(kind, 1.25)), 1.25);
    EXPECT_DOUBLE_EQ(parseQuantity(std::string("1.25") + fileUnit(kind), kind),
                     fromFileUnit(kind, 1.25));
  }
  EXPECT_STREQ(fileUnit(QuantityKind::Angle), "deg");
  EXPECT_STREQ(fileUnit(QuantityKind::WireSpeed), "m/min");
  EXPECT_STREQ(fileUnit(QuantityKind::None), "");
}

TEST(Quantity, FileNumbersAreTheOnesThatWereWritten) {
  for (const double degrees : {30.0, 0.1, 33.3, -170.0, 1e-6}) {
    EXPECT_EQ(toFileNumber(QuantityKind::Angle, degToRad(degrees)), degrees);
  }
  EXPECT_EQ(toFileNumber(QuantityKind::WireSpeed, (3.7_m_min).value()), 3.7);
  EXPECT_EQ(toFileNumber(QuantityKind::Length, 0.0), 0.0);
}

TEST(Quantity, Arithmetic) {
  constexpr Length a = 2.0_mm;
  static_assert((a + 1.0_mm).value() == 3.0);
  static_assert((a - 3.0_mm) == -(1.0_mm));
  static_assert((2.0 * a * 3.0 / 4.0).value() == 3.0);
  static_assert(a / 0.5_mm == 4.0);
  static_assert(a > 1.0_mm);
  static_assert(!std::is_convertible_v<double, Length> && !std::is_convertible_v<Length, double>);
  EXPECT_DOUBLE_EQ((180.0_deg).value(), kPi);
}

}  // namespace
}  // namespace wcam
