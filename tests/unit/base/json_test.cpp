// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/json.hpp"

#include "error_matchers.hpp"

#include <clocale>
#include <cmath>
#include <limits>

namespace wcam {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using wcam::testing::errorOf;

std::string refusal(const std::string& text) {
  return errorOf(ErrorCode::InputInvalid, [&] { (void)parseJson(text, "file.json"); });
}

TEST(Json, CanonicalText) {
  const Value value = Value::object(
      {{"z", Value(1)},
       {"a",
        Value::object(
            {{"list", Value(Value::Array{Value(1), Value(2.5), Value("x"), Value(), Value(true)})},
             {"nested", Value(Value::Array{Value::array(), Value::object({{"k", Value(-0.0)}})})},
             {"empty", Value::object()}})}});
  const std::string text =
      "{\n  \"z\": 1,\n  \"a\": {\n    \"list\": [1, 2.5, \"x\", null, true],\n    \"nested\": [\n "
      "     [],\n      {\n"
      "        \"k\": -0.0\n      }\n    ],\n    \"empty\": {}\n  }\n}\n";
  EXPECT_EQ(toCanonicalJson(value), text);
  EXPECT_EQ(parseJson(text), value);
  EXPECT_EQ(toCanonicalJson(parseJson(text)), text);
  EXPECT_EQ(
      toCompactJson(value),
      R"({"z": 1, "a": {"list": [1, 2.5, "x", null, true], "nested": [[], {"k": -0.0}], "empty": {}}})");
}

TEST(Json, KeepsIntegersAndRealsApart) {
  EXPECT_EQ(toCompactJson(parseJson("[1, 1.0, 1e5, 100000.0, -7, 9007199254740993]")),
            "[1, 1.0, 1e+05, 1e+05, -7, 9007199254740993]");
  EXPECT_EQ(parseJson("9223372036854775807").asInteger(), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(parseJson("-9223372036854775808").asInteger(),
            std::numeric_limits<std::int64_t>::min());
  // Beyond 64 bits a number becomes a real.
  EXPECT_EQ(parseJson("9223372036854775808").asReal(), 9223372036854775808.0);
  EXPECT_EQ(parseJson("1" + std::string(300, '0')).asReal(), 1e300);
}

TEST(Json, Unicode) {
  const Value value =
      parseJson(R"(["\u00e9", "é", "\ud83d\ude00", "\u0000", "\n\t\"\\\/", "\u007f"])");
  EXPECT_EQ(value.asArray()[0], value.asArray()[1]);
  EXPECT_EQ(value.asArray()[2].asString(), "😀");
  EXPECT_EQ(value.asArray()[3].asString(), std::string(1, '\0'));
  EXPECT_EQ(parseJson(toCanonicalJson(value)), value);
  EXPECT_EQ(toCompactJson(Value("é😀")), "\"é😀\"");
  EXPECT_EQ(parseJson("\xef\xbb\xbf{}"), Value::object()) << "a byte order mark is no content";
}

TEST(Json, RefusesBadText) {
  for (const char* text : {"{",       "[1,]",        "{\"a\":}", "{a: 1}",     "'a'",
                           "[1 2]",   "{} {}",       "nul",      "NaN",        "Infinity",
                           "-",       "01",          "1.",       ".5",         "+1",
                           R"("\x")", R"("\ud800")", "\"a\nb\"", "[\"\xff\"]", "[\"\xc0\xaf\"]",
                           "// c\n1", "]",           "\"open"}) {
    EXPECT_THAT(refusal(text), AllOf(HasSubstr("file.json"), HasSubstr("line"))) << text;
  }
  EXPECT_THAT(refusal(""), HasSubstr("empty"));
  EXPECT_THAT(refusal(" \r\n\t"), HasSubstr("empty"));
}

TEST(Json, ZeroByteDoesNotHideWhatFollows) {
  EXPECT_THAT(refusal(std::string("{}\n\0garbage", 11)), HasSubstr("line 2: a zero byte"));
  EXPECT_THAT(refusal(std::string("[1]\0", 4)), HasSubstr("line 1: a zero byte"));
}

TEST(Json, NamesTheLineOfADuplicateKey) {
  EXPECT_THAT(refusal("{\n  \"a\": 1,\n  \"b\": {\"a\": 2},\n  \"a\": 3\n}"),
              HasSubstr("line 4: the key 'a' stands twice"));
  EXPECT_THAT(refusal(R"({"\u0061": 1, "a": 2})"), HasSubstr("line 1"));
}

TEST(Json, NamesTheLineOfAHugeNumber) {
  EXPECT_THAT(refusal("[1,\n1e400\n]"), HasSubstr("line 2: "));
  EXPECT_THAT(refusal("[1,\n\n-1e999]"), HasSubstr("line 3: "));
  EXPECT_EQ(parseJson("1e-999").asReal(), 0.0);
}

TEST(Json, DeepNestingIsRefusedWithoutExhaustingTheStack) {
  EXPECT_NO_THROW((void)parseJson(std::string(200, '[') + std::string(200, ']')));
  EXPECT_THAT(refusal(std::string(201, '[') + std::string(201, ']')),
              HasSubstr("nested deeper than 200"));
  EXPECT_THAT(refusal(std::string(1000000, '[')), HasSubstr("nested deeper than 200"));
  std::string objects;
  for (int i = 0; i < 100000; ++i) {
    objects += "{\"a\":";
  }
  EXPECT_THAT(refusal(objects), HasSubstr("nested deeper than 200"));
}

TEST(Json, RealsAreShortestAndLocaleFree) {
  EXPECT_EQ(formatReal(0.1), "0.1");
  EXPECT_EQ(formatReal(1.0), "1.0");
  EXPECT_EQ(formatReal(-0.0), "-0.0");
  EXPECT_EQ(formatReal(1e22), "1e+22");
  EXPECT_EQ(formatReal(5e-324), "5e-324");
  EXPECT_EQ(formatReal(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(formatReal(123456789.0), "123456789.0");
  const std::string before = std::setlocale(LC_ALL, nullptr);
  // Where the locale is installed, its decimal comma must not reach a file.
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  EXPECT_EQ(formatReal(2.5), "2.5");
  EXPECT_EQ(parseJson("2.5").asReal(), 2.5);
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Json, NumbersThatAreNotFiniteAreNotWritten) {
  for (const double number : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    errorOf(ErrorCode::Internal,
            [&] { (void)toCanonicalJson(Value(Value::Array{Value(number)})); });
  }
}

}  // namespace
}  // namespace wcam
