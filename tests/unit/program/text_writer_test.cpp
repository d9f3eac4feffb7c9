// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/text_writer.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <clocale>
#include <limits>
#include <random>

using namespace wcam::program;

namespace {

/// std::to_chars, without the sign of a zero.
std::string reference(double value, int decimals) {
  char buffer[400];
  const auto [end, error] =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals);
  std::string text(buffer, end);
  if (text.find_first_not_of("-0.") == std::string::npos && text.front() == '-') {
    text.erase(0, 1);
  }
  return error == std::errc{} ? text : "error";
}

std::string printed(double value, int decimals) {
  TextWriter writer(0);
  writer.fixed(value, decimals);
  return writer.take();
}

template <int Decimals>
std::string printedStatically(double value) {
  TextWriter writer;
  writer.fixed<Decimals>(value);
  return writer.take();
}

/// The text with the point taken out, as an integer.
std::int64_t digitsOf(std::string text) {
  std::erase(text, '.');
  return std::stoll(text);
}

}  // namespace

TEST(TextWriter, EqualsToCharsForRandomNumbers) {
  constexpr unsigned kSeed = 20260101;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> exponent(-12.0, 9.0);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  for (int i = 0; i < 200000; ++i) {
    const double value = mantissa(random) * std::pow(10.0, exponent(random));
    const int decimals = i % (kMaxDecimals + 1);
    ASSERT_EQ(printed(value, decimals), reference(value, decimals)) << i;
  }
}

TEST(TextWriter, EqualsToCharsNextToTies) {
  constexpr unsigned kSeed = 7;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937_64 random(kSeed);
  std::uniform_int_distribution<int> whole(-3000000, 3000000);
  const double infinity = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 100000; ++i) {
    // Half a unit of the third decimal, and its neighbours.
    const double tie = (whole(random) + 0.5) / 1000.0;
    for (const double value :
         {tie, std::nextafter(tie, infinity), std::nextafter(tie, -infinity)}) {
      ASSERT_EQ(printedStatically<3>(value), reference(value, 3)) << tie;
      ASSERT_EQ(fixedDigits(value, 3), digitsOf(reference(value, 3))) << tie;
    }
  }
}

TEST(TextWriter, EqualsToCharsAtTheEnds) {
  for (const double value :
       {0.0, 5e-324, 0x1p-1000, 0.5, 0.05, 0.0005, 0.9995, 0.99949999, 999.9995, 0x1p49, 0x1p50,
        0x1p50 + 0.25, 0x1p53, 1e15, 1e17, 1e22, 1e100, std::numeric_limits<double>::max()}) {
    for (int decimals = 0; decimals <= kMaxDecimals; ++decimals) {
      EXPECT_EQ(printed(value, decimals), reference(value, decimals)) << value;
      EXPECT_EQ(printed(-value, decimals), reference(-value, decimals)) << value;
    }
  }
}

TEST(TextWriter, NeverPrintsNegativeZero) {
  EXPECT_EQ(printedStatically<3>(-0.0), "0.000");
  EXPECT_EQ(printedStatically<3>(-0.0004), "0.000");
  EXPECT_EQ(printedStatically<3>(-0.0005), reference(-0.0005, 3));
  EXPECT_EQ(printed(-1e-300, 0), "0");
  EXPECT_EQ(fixedDigits(-0.0004, 3), 0);
}

TEST(TextWriter, RefusesNumbersThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {nan, infinity, -infinity}) {
    EXPECT_THROW(printed(value, 3), wcam::Error);
    EXPECT_THROW((void)fixedDigits(value, 3), wcam::Error);
  }
  EXPECT_THROW((void)fixedDigits(1e18, 3), wcam::Error);
}

TEST(TextWriter, AlignsToTheRight) {
  TextWriter writer(1);
  writer.integer(7, 4)
      .text(":")
      .fixed(-1.5, 2, 8)
      .text("|")
      .digits(-1234567, 3, 4)
      .text("|")
      .integer(12345, 4);
  EXPECT_EQ(writer.view(), "   7:   -1.50|-1234.567|12345");
  EXPECT_EQ(writer.size(), writer.view().size());
  EXPECT_EQ(writer.take().size(), 29U);
  EXPECT_EQ(writer.take(), "");
}

TEST(TextWriter, PrintsAllIntegers) {
  TextWriter writer;
  writer.integer(std::numeric_limits<std::int64_t>::min()).text(" ");
  writer.integer(std::numeric_limits<std::int64_t>::max()).text(" ").integer(0);
  EXPECT_EQ(writer.view(), "-9223372036854775808 9223372036854775807 0");
}

TEST(TextWriter, GrowsFromNothing) {
  TextWriter writer(0);
  std::string expected;
  for (int i = 0; i < 5000; ++i) {
    writer.text("LIN {X ").fixed<3>(i * 0.25).text("}\n");
    expected += "LIN {X " + reference(i * 0.25, 3) + "}\n";
  }
  EXPECT_EQ(writer.take(), expected);
}

TEST(TextWriter, ModalNumberComparesWhatIsPrinted) {
  ModalNumber modal;
  EXPECT_TRUE(modal.changes(fixedDigits(1.00049, 3)));
  EXPECT_FALSE(modal.changes(fixedDigits(0.9999, 3)));
  EXPECT_TRUE(modal.changes(fixedDigits(1.0006, 3)));
  modal.forget();
  EXPECT_TRUE(modal.changes(fixedDigits(1.0006, 3)));
}
