// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/host.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace wcam;
using namespace wcam::plugin;
using ::testing::HasSubstr;

namespace {

ParamDef length(const char* key) {
  ParamDef def;
  def.info = {.key = key, .label = "Length", .min = 0.0, .max = 10.0};
  def.quantity = QuantityKind::Length;
  def.defaultValue = 1.0;
  return def;
}

std::string problems(std::vector<ParamDef> defs) {
  std::string all;
  for (const std::string& problem : schemaProblems(ParamSchema(std::move(defs)))) {
    all += problem + "\n";
  }
  return all;
}

}  // namespace

TEST(SchemaProblems, AcceptsSoundSchemas) {
  EXPECT_EQ(problems({}), "");
  ParamDef second = length("second");
  second.info.enabledIf = "first=1 and third!=2";
  EXPECT_EQ(problems({length("first"), second, length("third")}), "");
}

TEST(SchemaProblems, FindsEachMistake) {
  EXPECT_THAT(problems({length("a"), length("a")}), HasSubstr("'a' is declared twice"));
  ParamDef def = length("b");
  def.info.aliases = {"a"};
  EXPECT_THAT(problems({length("a"), def}), HasSubstr("'a' is declared twice"));
  EXPECT_THAT(problems({length("Big Key")}), HasSubstr("is not a snake_case key"));
  def = length("a");
  def.info.label = " ";
  EXPECT_THAT(problems({def}), HasSubstr("a: has no label"));
  def = length("a");
  def.info.min = 20.0;
  EXPECT_THAT(problems({def}), HasSubstr("the minimum is above the maximum"));
  def = length("a");
  def.defaultValue = 11.0;
  EXPECT_THAT(problems({def}), HasSubstr("its default 11.0 11 mm is above the maximum"));
  def.defaultValue = "x";
  EXPECT_THAT(problems({def}), HasSubstr("its default"));
  def = length("a");
  def.info.enabledIf = "nowhere=1";
  EXPECT_THAT(problems({def}), HasSubstr("condition 'nowhere=1'"));
  def.info.enabledIf = "a";
  EXPECT_THAT(problems({def}), HasSubstr("condition 'a'"));
  def = length("a");
  def.type = ParamType::Choice;
  EXPECT_THAT(problems({def}), HasSubstr("a choice without choices"));
  def.info.choices = {{"x", "X"}, {"x", "Y"}};
  def.defaultValue = "x";
  EXPECT_THAT(problems({def}), HasSubstr("choice 'x' is empty or repeated"));
}
