// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/names.hpp"

#include "wcam/base/error.hpp"
#include "wcam/program/ascii.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

using namespace wcam::program;

TEST(ControllerName, KeepsWhatAControllerAccepts) {
  EXPECT_EQ(controllerName("elbow", 8), "ELBOW");
  EXPECT_EQ(controllerName("elbow-upper.2", 36), "ELBOW_UPPER_2");
  EXPECT_EQ(controllerName("3rd part", 36), "P3RD_PART");
  EXPECT_EQ(controllerName("__ok__", 36), "OK");
  EXPECT_EQ(controllerName("Größe", 36), "GROSSE");
  EXPECT_EQ(controllerName("Œuvre d'été", 36), "OEUVRE_D_ETE");
  EXPECT_EQ(controllerName("Änneau", 36), "ANNEAU");
  EXPECT_EQ(controllerName("e\xCC\x81l\xC3\xA9ment", 36), "ELEMENT");  // e and a mark, then é
  EXPECT_EQ(controllerName("Łódź", 36), "LODZ");
  EXPECT_EQ(controllerName("Σ ring", 36), "RING");
  EXPECT_EQ(controllerName("", 36), "PROGRAM");
  EXPECT_EQ(controllerName("---", 36, "MAIN"), "MAIN");
  EXPECT_EQ(controllerName("日本", 8), "PROGRAM");
}

TEST(ControllerName, StaysDifferentWhenCut) {
  std::set<std::string> names;
  for (int i = 0; i < 100; ++i) {
    const std::string name = controllerName("the_same_long_beginning_" + std::to_string(i), 8);
    EXPECT_EQ(name.size(), 8U);
    EXPECT_TRUE(name.starts_with("THE__") || name.starts_with("THE_")) << name;
    names.insert(name);
  }
  EXPECT_EQ(names.size(), 100U);
}

TEST(PartNames, AreDifferentAndShortEnough) {
  for (const char* text :
       {"elbow", "ABCDEF_1", "ABCD_1", "A_1", "a_very_long_operation_name", "1"}) {
    for (const std::size_t parts : {1U, 9U, 10U, 99U}) {
      for (const std::size_t length : {9U, 24U, 36U}) {
        const auto names = partNames(text, parts, {length});
        EXPECT_EQ(names.size(), parts + 1);
        EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size()) << text;
        for (const std::string& name : names) {
          EXPECT_LE(name.size(), length) << name;
        }
      }
    }
  }
  EXPECT_EQ(partNames("elbow", 2, {36}), (std::vector<std::string>{"ELBOW", "ELBOW_1", "ELBOW_2"}));
  EXPECT_EQ(partNames("elbow", 10, {36}).at(1), "ELBOW_01");
  EXPECT_EQ(partNames("elbow", 0, {36}), (std::vector<std::string>{"ELBOW"}));
  EXPECT_THROW((void)partNames("elbow", 100, {8}), wcam::Error);
}

TEST(PartNames, AvoidWordsOfTheLanguageAndDevices) {
  constexpr std::array<std::string_view, 2> kWords = {"END", "WAIT"};
  const NameRules rules{8, kWords};
  EXPECT_EQ(partNames("end", 0, rules), (std::vector<std::string>{"P_END"}));
  EXPECT_EQ(partNames("Wait", 2, rules),
            (std::vector<std::string>{"P_WAIT", "P_WAIT_1", "P_WAIT_2"}));
  EXPECT_EQ(partNames("ending", 0, rules).front(), "ENDING");
  for (const char* device : {"con", "PRN", "aux", "nul", "com1", "LPT9"}) {
    EXPECT_TRUE(partNames(device, 0, rules).front().starts_with("P_")) << device;
  }
  EXPECT_EQ(partNames("console", 0, rules).front(), "CONSOLE");
  EXPECT_EQ(partNames("come", 0, rules).front(), "COME");
}

TEST(Ascii, EveryLatinLetterHasASpellingThatIsOne) {
  // Letters of Unicode's Latin blocks in capitals and small ones stay what they are.
  for (const auto& [given, ascii] :
       std::vector<std::pair<std::string, std::string>>{{"ÀÁÂÃÄÅ", "AAAAAA"},
                                                        {"àáâãäå", "aaaaaa"},
                                                        {"ÇÈÉÊËÌÍÎÏÑ", "CEEEEIIIIN"},
                                                        {"ŠšŽžÝÿ", "SsZzYy"},
                                                        {"ÆæØøÅåÞþÐð", "AEaeOoAaTHthDd"},
                                                        {"ąęłńśźżő", "aelnszzo"},
                                                        {"ệ Ữ ẞ", "e U SS"},
                                                        {"Русский", "???????"},
                                                        {"a\xFF"
                                                         "b",
                                                         "a?b"},
                                                        {"\xE2\x82", "?"},
                                                        {"\xC0\x8A", "?"},
                                                        {"\xE0\x80\x8A", "?"}}) {
    EXPECT_EQ(toAscii(given, '?'), ascii) << given;
  }
}

TEST(ControllerName, KeepsWhatIsExpectedWithoutAWord) {
  for (const auto& [wanted, keeps] :
       std::vector<std::pair<std::string, bool>>{{"ring", true},
                                                 {"upper ring-2.b", true},
                                                 {"été", false},
                                                 {"1ring", false},
                                                 {"P[1]", false},
                                                 {"Σ", false},
                                                 {"a_name_that_is_too_long_for_it", false}}) {
    EXPECT_EQ(keepsName(wanted, controllerName(wanted, 24)), keeps) << wanted;
  }
}

TEST(WrapComment, CutsAtBlanksWherePossible) {
  EXPECT_EQ(wrapComment("one two three", 8), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(wrapComment("abcdefghij", 4), (std::vector<std::string>{"abcd", "efgh", "ij"}));
  EXPECT_EQ(wrapComment("", 4), (std::vector<std::string>{""}));
  EXPECT_EQ(wrapComment("été\tx\n", 32), (std::vector<std::string>{"ete x"}));
  EXPECT_EQ(asciiComment("Straße – 5 °, 日本 µ"), "Strasse - 5 deg, ?? u");
  for (const std::string& piece :
       wrapComment("the quick brown fox jumps over the lazy dog again and again", 32)) {
    EXPECT_LE(piece.size(), 32U);
  }
}
