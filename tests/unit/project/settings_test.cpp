// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/commands.hpp"

#include "sample_project.hpp"

namespace wcam::project {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

ParamDef def(const char* key, ParamType type, QuantityKind kind = QuantityKind::None) {
  ParamDef result;
  result.info.key = key;
  result.type = type;
  result.quantity = kind;
  return result;
}

std::optional<ParamSchema> schemas(const ParamSection& section) {
  ParamDef step = def("step", ParamType::Real, QuantityKind::Length);
  step.info.min = 0.1;
  step.info.max = 20.0;
  step.info.aliases = {"layer_step"};
  if (section.component.starts_with("wcam.slicing.")) {
    return ParamSchema({step, def("alternate", ParamType::Bool)});
  }
  if (section.component == "wcam.post.fanuc") {
    return ParamSchema({def("mode", ParamType::Text), def("decimals", ParamType::Integer)});
  }
  if (section.section == "path") {
    return ParamSchema(
        {def("seam", ParamType::Text), def("tilt", ParamType::Real, QuantityKind::Angle)});
  }
  if (section.section == "motion") {
    return ParamSchema({def("tilt", ParamType::Real, QuantityKind::Angle)});
  }
  if (section.list == "processes") {
    return ParamSchema({def("wire_speed", ParamType::Real, QuantityKind::WireSpeed)});
  }
  if (section.section == "import") {
    return ParamSchema({def("chord_mm", ParamType::Real, QuantityKind::Length)});
  }
  return std::nullopt;
}

std::vector<std::string> linesOf(const Document& document, const char* setting) {
  std::vector<std::string> lines;
  for (const Command& command : commandsOfSetting(document, setting, schemas)) {
    lines.push_back(command.id + " " + toCompactJson(command.args));
  }
  return lines;
}

std::vector<std::string> linesOf(const char* setting) {
  return linesOf(sampleDocument(), setting);
}

std::string refusal(const char* setting, ErrorCode code = ErrorCode::InvalidArgument) {
  try {
    (void)commandsOfSetting(sampleDocument(), setting, schemas);
  } catch (const Error& error) {
    EXPECT_STREQ(toString(error.code()), toString(code)) << setting;
    return std::string(error.what()) + " | " + error.hint();
  }
  ADD_FAILURE() << "no error for " << setting;
  return {};
}

TEST(Settings, BareKeyMeansAllOperationsThatKnowIt) {
  EXPECT_THAT(
      linesOf("step=2.5mm"),
      ElementsAre(
          R"(operation.set_param {"id": "planar", "section": "params", "key": "step", "value": 2.5})",
          R"(operation.set_param {"id": "guided", "section": "params", "key": "step", "value": 2.5})"));
}

TEST(Settings, BareKeyOfOutputsProcessesAndParts) {
  EXPECT_THAT(
      linesOf("mode=cartesian"),
      ElementsAre(
          R"(output.set_param {"id": "fanuc", "section": "params", "key": "mode", "value": "cartesian"})"));
  EXPECT_EQ(linesOf("wire_speed=50mm/s").size(), 2U);
  EXPECT_EQ(linesOf("chord_mm=10um").size(), 2U);
}

TEST(Settings, AddressedKey) {
  const auto expected = ElementsAre(
      R"(operation.set_param {"id": "planar", "section": "params", "key": "step", "value": 12.7})");
  EXPECT_THAT(linesOf("planar.step=0.5in"), expected);
  EXPECT_THAT(linesOf(" planar.params.step = 0.5 in "), expected);
  EXPECT_THAT(linesOf("operations.planar.params.step=12.7"), expected);
  EXPECT_THAT(
      linesOf("guided.motion.tilt=10"),
      ElementsAre(
          R"(operation.set_param {"id": "guided", "section": "motion", "key": "tilt", "value": 10.0})"));
  EXPECT_THAT(
      linesOf("base.part.chord_mm=1mm"),
      ElementsAre(
          R"(part.set_param {"id": "base.part", "section": "import", "key": "chord_mm", "value": 1.0})"));
}

TEST(Settings, PlainFields) {
  EXPECT_THAT(linesOf("planar.enabled=false"),
              ElementsAre(R"(operation.set {"id": "planar", "enabled": false})"));
  EXPECT_THAT(linesOf("plate.position_mm=1, 2cm, 0"),
              ElementsAre(R"(substrate.set {"id": "plate", "position_mm": [1.0, 20.0, 0.0]})"));
  EXPECT_THAT(
      linesOf("elbow.placement.rotation_deg=0,0,45"),
      ElementsAre(
          R"(part.set {"id": "elbow", "placement": {"position_mm": [0, 0, 12.5], "rotation_deg": [0.0, 0.0, 45.0]}})"));
  EXPECT_THAT(
      linesOf("base.part.placement.position_mm=0,0,4"),
      ElementsAre(
          R"(part.set {"id": "base.part", "placement": {"position_mm": [0.0, 0.0, 4.0]}})"));
  EXPECT_THAT(linesOf("planar.parts=elbow, base.part"),
              ElementsAre(R"(operation.set {"id": "planar", "parts": ["elbow", "base.part"]})"));
  EXPECT_THAT(linesOf("fanuc.folder="), ElementsAre(R"(output.set {"id": "fanuc", "folder": ""})"));
}

TEST(Settings, FormerNameIsReplaced) {
  const Document old =
      apply(sampleDocument(),
            {"operation.set", parseJson(R"({"id": "planar", "params": {"layer_step": 4.0}})")});
  Document document = old;
  for (const Command& command : commandsOfSetting(old, "planar.layer_step=3", schemas)) {
    document = apply(document, command);
  }
  EXPECT_EQ(toCompactJson(document.project().operation("planar")->params), R"({"step": 3.0})");
}

TEST(Settings, WrongKeysAreNamedWithTheNearest) {
  EXPECT_THAT(refusal("stp=3"), AllOf(HasSubstr("'stp' is no parameter"), HasSubstr("'step'")));
  EXPECT_THAT(refusal("planar.stp=3"), HasSubstr("did you mean 'planar.step'?"));
  EXPECT_THAT(refusal("nothing.like.this=3"), HasSubstr("is no parameter"));
  EXPECT_THAT(refusal("step"), HasSubstr("KEY=VALUE"));
  EXPECT_THAT(refusal("=3"), HasSubstr("KEY=VALUE"));
  EXPECT_THAT(refusal(""), HasSubstr("KEY=VALUE"));
}

TEST(Settings, AmbiguousKeysAreRefused) {
  EXPECT_THAT(refusal("tilt=3deg"), AllOf(HasSubstr("operations.planar.path.tilt"),
                                          HasSubstr("operations.planar.motion.tilt")));
  EXPECT_THAT(refusal("planar.tilt=3deg"), HasSubstr("more than one meaning"));
}

TEST(Settings, WrongValuesAreRefusedWithTheFullKey) {
  EXPECT_THAT(refusal("planar.step=300"), AllOf(HasSubstr("operations.planar.params.step"),
                                                HasSubstr("above the maximum of 20 mm")));
  EXPECT_THAT(refusal("planar.step=3s"), HasSubstr("'s' is no unit of length"));
  EXPECT_THAT(refusal("planar.step="), HasSubstr("is not a number"));
  EXPECT_THAT(refusal("planar.alternate=1"), HasSubstr("neither true nor false"));
  EXPECT_THAT(refusal("plate.position_mm=1,2"), HasSubstr("list of 3 numbers"));
  EXPECT_THAT(refusal("decimals=2.5"), HasSubstr("not an integer"));
}

TEST(Settings, MissingPluginIsNamed) {
  EXPECT_THAT(refusal("all.mode=x", ErrorCode::PluginMissing), HasSubstr("wcam.post.kuka"));
  EXPECT_THAT(refusal("nothing=x"), HasSubstr("no plugin provides wcam.post.kuka"));
}

}  // namespace
}  // namespace wcam::project
