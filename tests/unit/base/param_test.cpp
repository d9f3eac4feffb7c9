// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/param.hpp"

#include "wcam/base/json.hpp"

#include "error_matchers.hpp"

namespace wcam {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using wcam::testing::errorOf;

enum class Seam { Aligned, Nearest, Random };

struct Params {
  Length step = 2.0_mm;
  Angle tilt = 30.0_deg;
  bool alternate = true;
  int count = 3;
  double factor = 0.5;
  std::string title = "none";
  Seam seam = Seam::Nearest;
  std::array<double, 3> direction{0.0, 0.0, 1.0};
};

const Schema<Params>& schema() {
  static const Schema<Params> kSchema =
      Schema<Params>{}
          .add(&Params::step, {.key = "step",
                               .label = "Step",
                               .help = "Layer height",
                               .min = 0.1,
                               .max = 20,
                               .aliases = {"layer_step", "layer_height"}})
          .add(&Params::tilt,
               {.key = "tilt", .label = "Tilt", .min = -45, .max = 45, .enabledIf = "seam!=random"})
          .add(&Params::alternate, {.key = "alternate", .label = "Alternate"})
          .add(&Params::count, {.key = "count",
                                .label = "Count",
                                .group = "Extra",
                                .level = ParamLevel::Expert,
                                .min = 1})
          .add(&Params::factor, {.key = "factor", .label = "Factor"})
          .add(&Params::title, {.key = "title", .label = "Title"})
          .add(&Params::seam,
               {.key = "seam",
                .label = "Seam",
                .enabledIf = "alternate=true and count=3",
                .choices = {{"aligned", "Aligned"}, {"nearest", "Nearest"}, {"random", "Random"}}})
          .add(&Params::direction, {.key = "direction", .label = "Direction"});
  return kSchema;
}

Value params(const char* json) {
  return parseJson(json);
}

std::vector<std::string> problemsOf(const char* json) {
  std::vector<std::string> lines;
  for (const ParamProblem& problem : schema().params().validate(params(json), "op")) {
    lines.push_back(problem.path + ": " + problem.message.str() +
                    (problem.unknown ? " (unknown)" : ""));
  }
  return lines;
}

TEST(Schema, DefaultsAreTheFieldsOwn) {
  const Value completed = schema().params().complete(Value());
  EXPECT_EQ(
      toCompactJson(completed),
      R"({"step": 2.0, "tilt": 30.0, "alternate": true, "count": 3, "factor": 0.5, "title": "none", "seam": "nearest", "direction": [0.0, 0.0, 1.0]})");
  const Params defaults = schema().read(Value::object());
  EXPECT_EQ(defaults.step, 2.0_mm);
  EXPECT_EQ(defaults.seam, Seam::Nearest);
}

TEST(Schema, ReadsIntoTheStruct) {
  const Params p = schema().read(
      params(
          R"({"direction": [1, "20", 3], "seam": "random", "tilt": "0.5rad", "step": "0.1in", "count": 7, "alternate": false})"),
      "op");
  EXPECT_DOUBLE_EQ(p.step.value(), 2.54);
  EXPECT_NEAR(p.tilt.value(), 0.5, 1e-12);
  EXPECT_EQ(p.seam, Seam::Random);
  EXPECT_EQ(p.count, 7);
  EXPECT_FALSE(p.alternate);
}

TEST(Schema, NamesAllProblemsAtOnce) {
  EXPECT_THAT(
      problemsOf(
          R"({"step": 300, "tilt": "x", "count": 2.5, "stp": 1, "seam": "none", "direction": [1, 2],
                             "alternate": 1, "title": 3})"),
      ElementsAre("op.step: 300 mm is above the maximum of 20 mm", "op.tilt: 'x' is not a number",
                  "op.count: expected an integer, got a number",
                  "op.stp: is not a parameter here; did you mean 'step'? (unknown)",
                  "op.seam: 'none' is not one of: aligned, nearest, random",
                  "op.direction: expected a list of 3 numbers",
                  "op.alternate: expected a boolean, got an integer",
                  "op.title: expected a text, got an integer"));
  const std::string message = errorOf(ErrorCode::InvalidArgument, [] {
    (void)schema().read(params(R"({"step": 0, "count": 0, "unknown": 1})"), "operation elbow");
  });
  EXPECT_THAT(message, AllOf(HasSubstr("2 problems"),
                             HasSubstr("operation elbow.step: 0 mm is below the minimum of 0.1 mm"),
                             HasSubstr("operation elbow.count: 0 is below the minimum of 1"),
                             Not(HasSubstr("unknown"))));
  EXPECT_THAT(problemsOf("[]"), ElementsAre("op: expected an object, got a list"));
  EXPECT_THAT(problemsOf("null"), IsEmpty());
}

TEST(Schema, IntegersThatTheFieldCannotHoldAreRefused) {
  EXPECT_THAT(problemsOf(R"({"count": 5000000000})"),
              ElementsAre("op.count: 5000000000 is above the maximum of 2147483647"));
}

TEST(Schema, AliasesAreReadAndRenamed) {
  const Value completed = schema().params().complete(params(R"({"layer_height": 4})"));
  EXPECT_EQ(completed.at("step").asReal(), 4.0);
  EXPECT_FALSE(completed.contains("layer_height"));
  EXPECT_EQ(
      schema().params().complete(params(R"({"layer_height": 4, "step": 5})")).at("step").asReal(),
      5.0);
  EXPECT_EQ(schema().params().find("layer_step")->info.key, "step");
  EXPECT_EQ(schema().params().find("nothing"), nullptr);
}

TEST(Schema, ParsesTheTextOfASetting) {
  const ParamSchema s = schema().params();
  EXPECT_EQ(s.parse("step", "2.5mm"), Value(2.5));
  EXPECT_EQ(s.parse("layer_step", "1cm"), Value(10.0));
  EXPECT_EQ(s.parse("tilt", "0.5235987755982988rad"), Value(30.0));
  EXPECT_EQ(s.parse("alternate", "false"), Value(false));
  EXPECT_EQ(s.parse("count", "5"), Value(5));
  EXPECT_EQ(s.parse("seam", "aligned"), Value("aligned"));
  EXPECT_EQ(s.parse("title", "a=b"), Value("a=b"));
  EXPECT_EQ(s.parse("direction", "0, 1, 0").size(), 3U);
  const auto refused = [&](const char* key, const char* text) {
    return errorOf(ErrorCode::InvalidArgument, [&] { (void)s.parse(key, text); });
  };
  EXPECT_THAT(refused("stp", "1"), AllOf(HasSubstr("'stp'"), HasSubstr("did you mean 'step'?")));
  EXPECT_THAT(refused("temperature", "1"), HasSubstr("parameters: step, tilt"));
  EXPECT_THAT(refused("step", "2.5s"), AllOf(HasSubstr("step: "), HasSubstr("mm, cm, m, um, in")));
  EXPECT_THAT(refused("step", "30"), HasSubstr("above the maximum of 20 mm"));
  EXPECT_THAT(refused("count", "2.5"), HasSubstr("not an integer"));
  EXPECT_THAT(refused("count", "0"), HasSubstr("below the minimum"));
  EXPECT_THAT(refused("alternate", "yes"), HasSubstr("neither true nor false"));
  EXPECT_THAT(refused("direction", "1,2"), HasSubstr("3 numbers"));
  EXPECT_THAT(refused("seam", "Aligned"), HasSubstr("not one of"));
}

TEST(Schema, Conditions) {
  const ParamSchema s = schema().params();
  const auto enabled = [&](const char* key, const char* json) {
    return ParamSchema::enabled(*s.find(key), s.complete(params(json)));
  };
  EXPECT_TRUE(enabled("step", "{}"));
  EXPECT_TRUE(enabled("tilt", "{}"));
  EXPECT_FALSE(enabled("tilt", R"({"seam": "random"})"));
  EXPECT_TRUE(enabled("seam", "{}"));
  EXPECT_FALSE(enabled("seam", R"({"count": 4})"));
  EXPECT_FALSE(enabled("seam", R"({"alternate": false})"));
  ParamDef broken;
  broken.info.key = "x";
  for (const char* condition : {"nothing=1", "step"}) {
    broken.info.enabledIf = condition;
    EXPECT_THAT(errorOf(ErrorCode::Internal,
                        [&] { (void)ParamSchema::enabled(broken, s.complete(Value())); }),
                HasSubstr(condition));
  }
}

TEST(Schema, JsonSchema) {
  const Value json = schema().params().jsonSchema("Test");
  EXPECT_EQ(json.at("title").asString(), "Test");
  const Value& step = json.at("properties").at("step");
  EXPECT_EQ(
      toCompactJson(step),
      R"({"title": "Step", "description": "Layer height", "type": "number", "minimum": 0.1, "maximum": 20.0, "default": 2.0, "x-quantity": "length", "x-unit": "mm", "x-group": "General", "x-level": "basic"})");
  EXPECT_EQ(json.at("properties").at("seam").at("enum").size(), 3U);
  EXPECT_EQ(json.at("properties").at("direction").at("minItems").asInteger(), 3);
  EXPECT_EQ(json.at("properties").at("count").at("type").asString(), "integer");
  EXPECT_EQ(json.at("properties").at("tilt").at("x-enabled-if").asString(), "seam!=random");
  EXPECT_EQ(json.at("properties").size(), schema().params().defs().size());
}

TEST(Schema, ReferencePageHasEveryParameter) {
  const ParamSchema declared = schema().params();
  const std::string page = declared.markdown();
  for (const ParamDef& def : declared.defs()) {
    EXPECT_THAT(page, HasSubstr("| `" + def.info.key + "` |"));
  }
  EXPECT_THAT(page, HasSubstr("≥ 0.1 mm, ≤ 20 mm"));
}

}  // namespace
}  // namespace wcam
