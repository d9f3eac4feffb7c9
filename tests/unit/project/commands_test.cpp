// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/commands.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/sha256.hpp"

#include "sample_project.hpp"

namespace wcam::project {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Command make(const char* id, const char* args) {
  return {id, parseJson(args)};
}

Document applied(const char* id, const char* args) {
  return apply(sampleDocument(), make(id, args));
}

/// Message of a refusal; the document must be untouched.
std::string refusal(const char* id, const char* args) {
  const Document document = sampleDocument();
  const std::string before = document.text();
  const std::string message =
      errorOf(ErrorCode::InvalidArgument, [&] { (void)apply(document, make(id, args)); });
  EXPECT_EQ(document.text(), before);
  return message;
}

std::vector<std::string> keysOf(const Value& object) {
  std::vector<std::string> keys;
  for (const auto& member : object.asObject()) {
    keys.push_back(member.first);
  }
  return keys;
}

TEST(Commands, BuildAProjectFromNothing) {
  Document document;
  const std::vector<std::pair<const char*, const char*>> steps = {
      {"operation.add", nullptr},
      {"project.rename", R"({"name": "elbow"})"},
      {"process.add", R"({"id": "steel"})"},
      {"substrate.add", R"({"size_mm": [300, 300, 20], "type": "plate", "id": "plate"})"},
      {"part.add", R"({"file": {"path": "elbow.step"}, "id": "elbow"})"},
      {"cell.set", R"({"file": {"path": "cell.json", "sha256": ""}})"},
      {"operation.add",
       R"({"id": "op", "process": "steel", "substrate": "plate", "parts": ["elbow"], "strategy": "s"})"},
      {"output.add", R"({"id": "out", "post": "p"})"},
  };
  for (const auto& [id, args] : steps) {
    if (args != nullptr) {
      document = apply(document, make(id, args));
    }
  }
  EXPECT_THAT(keysOf(document.tree()),
              ElementsAre("format", "format_version", "name", "cell", "parts", "substrates",
                          "processes", "operations", "outputs"));
  EXPECT_THAT(keysOf(document.tree().at("operations").asArray()[0]),
              ElementsAre("id", "strategy", "parts", "substrate", "process"));
  EXPECT_EQ(document.project().operations.size(), 1U);
}

TEST(Commands, NeverTouchTheOldDocument) {
  const Document before = sampleDocument();
  const std::string text = before.text();
  const Document after = apply(before, make("part.set", R"({"id": "elbow", "faces": [7]})"));
  EXPECT_EQ(before.text(), text);
  EXPECT_NE(after.text(), text);
}

TEST(Commands, AddAtAnIndex) {
  const Document document =
      applied("part.add", R"({"id": "n", "file": {"path": "n.stl"}, "index": 1})");
  EXPECT_EQ(document.project().parts[1].id, "n");
  EXPECT_FALSE(document.tree().at("parts").asArray()[1].contains("index"));
  EXPECT_THAT(refusal("part.add", R"({"id": "n", "file": {"path": "n.stl"}, "index": 3})"),
              HasSubstr("only 2 entries"));
  EXPECT_THAT(refusal("part.add", R"({"id": "elbow", "file": {"path": "n.stl"}})"),
              HasSubstr("there is a part 'elbow' already"));
}

TEST(Commands, SetKeepsOtherKeysAndOrder) {
  const Document document =
      applied("operation.set",
              R"({"id": "planar", "enabled": false, "guide": "axis", "params": {"step": 2.0}})");
  EXPECT_THAT(
      keysOf(document.tree().at("operations").asArray()[0]),
      ElementsAre("id", "strategy", "parts", "substrate", "guide", "process", "params", "enabled"));
  const Document cleared =
      apply(document, make("operation.set", R"({"id": "planar", "guide": null})"));
  EXPECT_EQ(cleared.project().operation("planar")->guide, "");
  const Document part = applied("part.set", R"({"id": "elbow", "file": {"path": "other.step"}})");
  EXPECT_EQ(part.tree().at("parts").asArray()[0].at("x_tag").asString(), "k");
}

TEST(Commands, SetThatBreaksTheDocumentIsRefused) {
  EXPECT_THAT(refusal("operation.set", R"({"id": "planar", "substrate": "plat"})"),
              AllOf(HasSubstr("operation.set"), HasSubstr("did you mean 'plate'?")));
  EXPECT_THAT(refusal("operation.set", R"({"id": "planar", "strategy": null})"),
              HasSubstr("'strategy' is missing"));
  EXPECT_THAT(refusal("substrate.set", R"({"id": "plate", "type": "part"})"),
              HasSubstr("needs it"));
  EXPECT_THAT(refusal("operation.set", R"({"id": "planr", "enabled": true})"),
              HasSubstr("there is no operation 'planr'; did you mean 'planar'?"));
}

TEST(Commands, AllWrongArgumentsAtOnce) {
  const std::string message = refusal(
      "operation.add",
      R"({"id": "A B", "strateg": "x", "parts": "elbow", "substrate": "plate", "enabled": 1})");
  EXPECT_THAT(message, HasSubstr("id: 'A B' is no id"));
  EXPECT_THAT(message, HasSubstr("strategy: is missing"));
  EXPECT_THAT(message,
              HasSubstr("strateg: is no argument of this command; did you mean 'strategy'?"));
  EXPECT_THAT(message, HasSubstr("parts: expected a list"));
  EXPECT_THAT(message, HasSubstr("process: is missing"));
  EXPECT_THAT(message, HasSubstr("enabled: expected true or false"));
  EXPECT_THAT(refusal("operation.add", "[]"), HasSubstr("must be an object"));
  EXPECT_THAT(refusal("project.rename", R"({"name": 3})"), HasSubstr("name: expected a text"));
}

TEST(Commands, RemoveRefusesWhatIsUsed) {
  EXPECT_THAT(
      refusal("part.remove", R"({"id": "elbow"})"),
      HasSubstr("is used by guide 'rim', guide 'named', operation 'planar', operation 'guided'"));
  EXPECT_THAT(refusal("operation.remove", R"({"id": "planar"})"), HasSubstr("output 'fanuc'"));
  EXPECT_EQ(applied("operation.remove", R"({"id": "guided"})").project().operations.size(), 1U);
}

TEST(Commands, RenameFollowsReferences) {
  const Document document = applied("part.rename", R"({"id": "elbow", "to": "tube"})");
  EXPECT_NE(document.project().part("tube"), nullptr);
  EXPECT_EQ(document.project().guide("rim")->part, "tube");
  EXPECT_THAT(document.project().operation("guided")->parts, ElementsAre("tube", "base.part"));
  EXPECT_EQ(apply(document, make("part.rename", R"({"id": "tube", "to": "elbow"})")),
            sampleDocument());
  EXPECT_THAT(refusal("part.rename", R"({"id": "elbow", "to": "base.part"})"),
              HasSubstr("already"));
  EXPECT_EQ(applied("part.rename", R"({"id": "elbow", "to": "elbow"})"), sampleDocument());
}

TEST(Commands, MoveChangesTheOrderOnly) {
  const Document document = applied("guide.move", R"({"id": "axis", "index": 2})");
  EXPECT_EQ(document.project().guides[2].id, "axis");
  EXPECT_EQ(document.project().guides[0].id, "rim");
  EXPECT_EQ(apply(document, make("guide.move", R"({"id": "axis", "index": 0})")), sampleDocument());
  EXPECT_THAT(refusal("guide.move", R"({"id": "axis", "index": 4})"), HasSubstr("only 4 entries"));
}

TEST(Commands, SetParam) {
  const Document document =
      applied("operation.set_param",
              R"({"id": "planar", "section": "motion", "key": "rotation", "value": 12.5})");
  EXPECT_EQ(document.project().operation("planar")->motion.at("rotation").asReal(), 12.5);
  const Document removed =
      applied("operation.set_param", R"({"id": "planar", "key": "step", "value": null})");
  EXPECT_EQ(removed.project().operation("planar")->params.size(), 0U);
  EXPECT_EQ(applied("part.set_param", R"({"id": "elbow", "key": "angle", "value": [1, 2]})")
                .project()
                .part("elbow")
                ->import.at("angle")
                .size(),
            2U);
  EXPECT_THAT(refusal("operation.set_param",
                      R"({"id": "planar", "section": "motio", "key": "a", "value": 1})"),
              HasSubstr("not one of: params, path, motion"));
  EXPECT_THAT(refusal("operation.set_param", R"({"id": "planar", "key": "", "value": 1})"),
              HasSubstr("key"));
  EXPECT_THAT(refusal("operation.set_param", R"({"id": "planar", "key": "a"})"),
              HasSubstr("value: is missing"));
}

TEST(Commands, CellAndName) {
  EXPECT_TRUE(applied("cell.remove", "{}").project().cell.empty());
  EXPECT_EQ(applied("cell.set", R"({"file": {"path": "b.json"}})").project().cell.path, "b.json");
  EXPECT_EQ(applied("project.rename", R"({"name": "n"})").project().name, "n");
}

TEST(Commands, PinStoresHashes) {
  const TestFolder folder;
  for (const char* name :
       {"cells/arcmate.json", "elbow.step", "base.stl", "guide.csv", "processes/shop.json"}) {
    createFolder((folder / name).parent_path());
    writeFileAtomically(folder / name, name);
  }
  const Command pin = pinCommand(sampleDocument(), folder / "x.wcam");
  const Document document = apply(sampleDocument(), pin);
  EXPECT_EQ(document.project().cell.sha256, sha256Hex("cells/arcmate.json"));
  EXPECT_EQ(document.project().part("elbow")->file.sha256, sha256Hex("elbow.step"));
  EXPECT_EQ(document.project().process("shop")->file.sha256, sha256Hex("processes/shop.json"));
  EXPECT_EQ(apply(document, pin), document);
  EXPECT_EQ(document.tree().at("parts").asArray()[0].at("file").at("x_size").asInteger(), 12);
  EXPECT_THAT(refusal("file.pin", R"({"files": {"elbw.step": ""}})"),
              HasSubstr("did you mean 'elbow.step'?"));
  EXPECT_THAT(refusal("file.pin", R"({"files": {"elbow.step": "xyz"}})"),
              HasSubstr("64 lower-case"));
}

TEST(Commands, UnknownCommandIsNamedWithTheNearest) {
  try {
    (void)apply(Document(), make("part.ad", "{}"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InvalidArgument);
    EXPECT_THAT(error.hint(), HasSubstr("part.add"));
  }
}

TEST(Commands, ReadOnlyDocumentIsNotChanged) {
  const Document document = Document::parse(sampleTree().set("format_version", 2));
  errorOf(ErrorCode::ProjectReadOnly,
          [&] { (void)apply(document, make("project.rename", R"({"name": "n"})")); });
}

TEST(Commands, WhatCannotBeWrittenIsRefused) {
  const Document document = sampleDocument();
  for (const Value& value : {Value("\xff"), Value(std::numeric_limits<double>::infinity())}) {
    const Command command{"operation.set_param",
                          Value::object({{"id", "planar"}, {"key", "a"}, {"value", value}})};
    errorOf(ErrorCode::InvalidArgument, [&] { (void)apply(document, command); });
  }
}

TEST(Commands, Labels) {
  EXPECT_EQ(labelOf(make("operation.set_param", R"({"id": "elbow", "key": "step", "value": 1})")),
            "Set step of elbow");
  EXPECT_EQ(labelOf(make("part.add", R"({"id": "elbow"})")), "Add part elbow");
  EXPECT_EQ(labelOf(make("part.set", R"({"id": "elbow", "faces": [], "placement": {}})")),
            "Set faces, placement of part elbow");
  EXPECT_EQ(labelOf(make("part.rename", R"({"id": "a", "to": "b"})")), "Rename part a to b");
  EXPECT_EQ(labelOf(make("file.pin", "{}")), "Pin files");
  EXPECT_EQ(labelOf({"unknown", Value()}), "unknown");
}

TEST(Commands, CatalogueDescribesEveryCommand) {
  std::string last;
  for (const CommandInfo& info : commandCatalog()) {
    EXPECT_LT(last, info.id);
    last = info.id;
    EXPECT_TRUE(info.summary.ends_with(".")) << info.id;
    const Value schema = info.jsonSchema();
    EXPECT_EQ(schema.at("title").asString(), info.id);
    EXPECT_EQ(schema.at("properties").size(), info.args.size());
    for (const ArgInfo& arg : info.args) {
      EXPECT_FALSE(arg.help.empty()) << info.id << " " << arg.key;
    }
  }
}

TEST(Commands, AsData) {
  const Command command = make("part.remove", R"({"id": "elbow"})");
  EXPECT_EQ(toCompactJson(toValue(command)),
            R"({"command": "part.remove", "args": {"id": "elbow"}})");
  EXPECT_EQ(commandFromValue(toValue(command)), command);
  EXPECT_TRUE(commandFromValue(parseJson(R"({"command": "cell.remove"})")).args.isObject());
  for (const char* text : {"1", "{}", R"({"command": 3})"}) {
    errorOf(ErrorCode::InvalidArgument, [&] { (void)commandFromValue(parseJson(text)); });
  }
}

}  // namespace
}  // namespace wcam::project
