// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/value.hpp"

#include "error_matchers.hpp"

namespace wcam {
namespace {

using ::testing::HasSubstr;
using wcam::testing::errorOf;

TEST(Value, AccessorsNameTheTypes) {
  const Value text("x");
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { (void)text.asReal(); }),
              HasSubstr("expected a number, got a text"));
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { (void)text.at("a"); }),
              HasSubstr("expected an object"));
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { (void)Value::object().at("a"); }),
              HasSubstr("'a'"));
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { (void)Value(1.0).asInteger(); }),
              HasSubstr("integer"));
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { (void)Value(1).asBool(); }),
              HasSubstr("boolean"));
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { (void)Value(1).asArray(); }),
              HasSubstr("list"));
  EXPECT_EQ(Value(3).asReal(), 3.0);
  EXPECT_EQ(text.find("a"), nullptr);
  EXPECT_EQ(text.size(), 0U);
}

TEST(Value, CopiesShareUntilOneIsChanged) {
  Value original = Value::object({{"list", Value(Value::Array{Value(1)})}});
  Value copy = original;
  EXPECT_EQ(&copy.asObject(), &original.asObject());
  copy.findMutable("list")->push(2);
  EXPECT_EQ(original.at("list").size(), 1U);
  EXPECT_EQ(copy.at("list").size(), 2U);
  Value third = copy;
  third.set("new", "x");
  EXPECT_EQ(&third.at("list").asArray(), &copy.at("list").asArray())
      << "untouched members stay shared";
  EXPECT_FALSE(copy.contains("new"));
}

TEST(Value, ObjectsKeepTheirOrder) {
  Value object;
  object.set("z", 1).set("a", 2).set("z", 3);
  EXPECT_EQ(object.asObject()[0].first, "z");
  EXPECT_EQ(object.at("z").asInteger(), 3);
  EXPECT_TRUE(object.remove("z"));
  EXPECT_FALSE(object.remove("z"));
  EXPECT_EQ(object.size(), 1U);
  Value list;
  list.push(1).push(2);
  EXPECT_EQ(list.size(), 2U);
}

TEST(Value, ComparisonIsDeepAndStrict) {
  EXPECT_NE(Value(1), Value(1.0));
  EXPECT_NE(Value(false), Value(0));
  EXPECT_EQ(Value(Value::Array{Value("a")}), Value(Value::Array{Value("a")}));
  EXPECT_NE(Value::object({{"a", 1}, {"b", 2}}), Value::object({{"b", 2}, {"a", 1}}));
  EXPECT_EQ(Value(), Value(nullptr));
}

TEST(Value, AddingItselfDoesNotLoop) {
  Value value = Value::object({{"a", 1}});
  value.set("self", value);
  EXPECT_EQ(value.at("self"), Value::object({{"a", 1}}));
}

}  // namespace
}  // namespace wcam
