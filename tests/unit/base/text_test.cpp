// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>
#include <vector>

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

std::string inFrench(const Text& text) {
  return render(text, [](const std::string& pattern) -> std::string {
    static const std::map<std::string, std::string> kFrench = {
        {"joint %1 is %2 beyond its limit", "de %2, l'axe %1 dépasse sa butée"},
        {"%1 points", "%1 points de passage"},
        {"%1 at %2", "en %2 : %1"},
        {"torch", "torche"},
        {"a, b", "un, deux"},
        {"50 %1", "cinquante %1"}};
    const auto found = kFrench.find(pattern);
    return found != kFrench.end() ? found->second : pattern;
  });
}

TEST(Text, PlacesAreFilledAndTranslatedInTheOrderOfTheLanguage) {
  const Text limit = text("joint %1 is %2 beyond its limit", {"J4", "2.500 deg"});
  EXPECT_EQ(limit.str(), "joint J4 is 2.500 deg beyond its limit");
  EXPECT_EQ(inFrench(limit), "de 2.500 deg, l'axe J4 dépasse sa butée");
  const Text nested = text("%1 at %2", {limit, text("%1 points", {std::to_string(3)})});
  EXPECT_EQ(nested.str(), "joint J4 is 2.500 deg beyond its limit at 3 points");
  EXPECT_EQ(inFrench(nested), "en 3 points de passage : de 2.500 deg, l'axe J4 dépasse sa butée");
  EXPECT_EQ(inFrench(text("no translation of %1", {"torch"})), "no translation of torche");
}

TEST(Text, APercentSignInAnArgumentIsNoPlace) {
  EXPECT_EQ(text("%1 and %2", {"%2", "%1"}).str(), "%2 and %1");
  EXPECT_EQ(text("%1", {std::string("100 %1 %% %")}).str(), "100 %1 %% %");
  EXPECT_EQ(text("%1 % of %2 %", {"5", "20"}).str(), "5 % of 20 %");
}

TEST(Text, WithoutArgumentsEverythingIsLiteral) {
  EXPECT_EQ(Text("use %1 or 50 %").str(), "use %1 or 50 %");
  EXPECT_EQ(text("$OUT[%1]").str(), "$OUT[%1]");
  EXPECT_EQ(inFrench(Text("50 %1")), "cinquante %1");
  EXPECT_EQ(Text().str(), "");
  EXPECT_TRUE(Text().empty());
  EXPECT_FALSE(Text("a").empty());
}

TEST(Text, PlacesWithoutAnArgumentStay) {
  EXPECT_EQ(text("%1 %2 %3", {"a"}).str(), "a %2 %3");
  EXPECT_EQ(text("%10 %0 %x %", {"a"}).str(), "a0 %0 %x %") << "a place has one digit";
  EXPECT_EQ(text("%1 %1", {"a", "b"}).str(), "a a");
}

TEST(Text, WordsFromElsewhereAreTranslatedOnTheirOwnOnly) {
  const std::string name = "torch";  // of a part that the user calls so
  EXPECT_EQ(inFrench(text("%1 at %2", {name, "torch"})), "en torche : torch");
  EXPECT_EQ(inFrench(Text(name)), "torche") << "the message of a plugin";
  EXPECT_TRUE(Text(name).foreign());
  EXPECT_FALSE(Text("torch").foreign());
}

TEST(Text, ListsAreNestedAndShallow) {
  EXPECT_EQ(joinTexts({}, ", ").str(), "");
  EXPECT_EQ(joinTexts({"a"}, ", ").str(), "a");
  EXPECT_EQ(joinTexts({"a", "torch", "c"}, ", ").str(), "a, torch, c");
  EXPECT_EQ(inFrench(joinTexts({"a", "torch", "c"}, ", ")), "a, torche, c");
  const std::vector<Text> many(100000, "x");
  EXPECT_EQ(joinTexts(many, "").str(), std::string(100000, 'x'));
}

TEST(Text, EqualTextsReadAlike) {
  EXPECT_EQ(text("%1 points", {"3"}), "3 points");
  EXPECT_EQ(text("%1 points", {"3"}), std::string("3 points"));
  EXPECT_NE(text("%1 points", {"3"}), text("%1 points", {"4"}));
  EXPECT_EQ(std::string(text("%1 points", {"3"})), "3 points");
}

}  // namespace
}  // namespace wcam
