// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace wcam {
namespace {

using ::testing::ElementsAre;

TEST(Text, SplitTrimJoin) {
  EXPECT_THAT(splitText("a,,b", ','), ElementsAre("a", "", "b"));
  EXPECT_THAT(splitText("", ','), ElementsAre(""));
  EXPECT_EQ(trimText(" \t a b\r\n"), "a b");
  EXPECT_EQ(trimText(" \n"), "");
  EXPECT_EQ(joinText({"a", "b", "c"}, ", "), "a, b, c");
  EXPECT_EQ(joinText({}, ", "), "");
}

TEST(Text, ParseReal) {
  EXPECT_EQ(parseReal(" 2.5 "), 2.5);
  EXPECT_EQ(parseReal("+1e3"), 1000.0);
  EXPECT_EQ(parseReal("-0.5"), -0.5);
  for (const char* text : {"", "x", "1x", "1 2", "inf", "nan", "1e999", "+", "+-1", "--1", "1,5"}) {
    EXPECT_FALSE(parseReal(text)) << text;
  }
}

TEST(Text, FormatFixed) {
  EXPECT_EQ(formatFixed(1.23456, 3), "1.235");
  EXPECT_EQ(formatFixed(-0.0004, 3), "0.000");
  EXPECT_EQ(formatFixed(-0.0, 0), "0");
  EXPECT_EQ(formatFixed(-0.0006, 3), "-0.001");
  EXPECT_EQ(formatFixed(1e6, 2), "1000000.00");
  EXPECT_EQ(formatFixed(std::numeric_limits<double>::max(), 2).size(), 312U);
}

TEST(Text, NearestName) {
  const std::vector<std::string> names = {"step", "alternate", "seam"};
  EXPECT_EQ(nearestName("stp", names), "step");
  EXPECT_EQ(nearestName("alternating", names), "alternate");
  EXPECT_EQ(nearestName("seam", names), "seam");
  EXPECT_FALSE(nearestName("temperature", names));
  EXPECT_FALSE(nearestName("step", {}));
}

TEST(Text, ValidIds) {
  for (const char* id : {"a", "0", "wcam.post.fanuc", "op_1-b", "a..b"}) {
    EXPECT_TRUE(isValidId(id)) << id;
  }
  for (const char* id : {"", "A", "_a", ".a", "-a", "a b", "é", "a/b", "a\n"}) {
    EXPECT_FALSE(isValidId(id)) << id;
  }
  EXPECT_TRUE(isValidId(std::string(64, 'a')));
  EXPECT_FALSE(isValidId(std::string(65, 'a')));
}

}  // namespace
}  // namespace wcam
