// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"

#include "random_source.hpp"
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace wcam {
namespace {

using wcam::testing::RandomSource;

class BaseLaws : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(BaseLaws, EveryFiniteDoubleSurvivesItsText) {
  RandomSource random(GetParam());
  SCOPED_TRACE("WCAM_TEST_SEED=" + std::to_string(random.seed()));
  for (int i = 0; i < 20000; ++i) {
    const double number = std::bit_cast<double>(random.bits());
    if (!std::isfinite(number)) {
      continue;
    }
    const Value back = parseJson(formatReal(number));
    ASSERT_EQ(back.type(), Value::Type::Real) << formatReal(number);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(back.asReal()), std::bit_cast<std::uint64_t>(number))
        << formatReal(number);
  }
}

TEST_P(BaseLaws, EveryIntegerSurvivesItsText) {
  RandomSource random(GetParam());
  SCOPED_TRACE("WCAM_TEST_SEED=" + std::to_string(random.seed()));
  for (int i = 0; i < 5000; ++i) {
    const auto number = static_cast<std::int64_t>(random.bits() >> random.below(64));
    ASSERT_EQ(parseJson(toCompactJson(Value(number))), Value(number));
  }
}

TEST_P(BaseLaws, DamagedJsonIsRefusedOrReadNeverWorse) {
  RandomSource random(GetParam());
  SCOPED_TRACE("WCAM_TEST_SEED=" + std::to_string(random.seed()));
  const std::string good =
      R"({"a": [1, -2.5e3, "x\u00e9\n", true, null, {"b": {}}], "ä": "€", "c": 1e-7})";
  for (int i = 0; i < 3000; ++i) {
    std::string text = good;
    for (std::size_t k = 1 + random.below(3); k > 0; --k) {
      const std::size_t place = random.below(text.size());
      switch (random.below(3)) {
        case 0:
          text[place] = static_cast<char>(random.bits());
          break;
        case 1:
          text.erase(place, 1 + random.below(4));
          break;
        default:
          text.insert(place, 1, "{}[],:\"\\0e-. \x80"[random.below(15)]);
      }
      if (text.empty()) {
        text = "0";
      }
    }
    try {
      const Value value = parseJson(text);
      // What is read has one canonical text.
      ASSERT_EQ(toCanonicalJson(parseJson(toCanonicalJson(value))), toCanonicalJson(value)) << text;
      ASSERT_EQ(parseJson(toCompactJson(value)), value) << text;
    } catch (const Error& error) {
      ASSERT_EQ(error.code(), ErrorCode::InputInvalid);
    }
  }
}

TEST_P(BaseLaws, QuantitiesInFileUnitsSurvive) {
  RandomSource random(GetParam());
  SCOPED_TRACE("WCAM_TEST_SEED=" + std::to_string(random.seed()));
  for (int i = 0; i < 2000; ++i) {
    // What people write: at most 9 digits.
    const double number = static_cast<double>(random.below(1000000000)) /
                          std::pow(10.0, static_cast<double>(random.below(9)));
    for (const QuantityKind kind :
         {QuantityKind::Length, QuantityKind::Angle, QuantityKind::AngularSpeed,
          QuantityKind::WireSpeed, QuantityKind::Speed, QuantityKind::Time}) {
      const double internal = parseQuantity(formatReal(number) + " " + fileUnit(kind), kind);
      ASSERT_EQ(toFileNumber(kind, internal), number) << toString(kind);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, BaseLaws, ::testing::ValuesIn(wcam::testing::testSeeds(4)));

}  // namespace
}  // namespace wcam
