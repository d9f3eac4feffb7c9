// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/document.hpp"

#include "wcam/base/quantity.hpp"

#include "sample_project.hpp"

#include <cmath>

namespace wcam::project {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string problemsOf(Value tree) {
  return errorOf(ErrorCode::ProjectInvalid,
                 [&] { (void)Document::parse(std::move(tree), "x.wcam"); });
}

/// The sample with one key of one node replaced (null removes it).
Value changed(const char* list, std::size_t index, const char* key, Value value) {
  Value tree = sampleTree();
  Value& node = tree.findMutable(list)->mutableArray()[index];
  if (value.isNull()) {
    node.remove(key);
  } else {
    node.set(key, std::move(value));
  }
  return tree;
}

TEST(Document, ReadsEveryKindOfNode) {
  const Document document = sampleDocument();
  const Project& p = document.project();
  EXPECT_EQ(p.formatVersion, 1);
  EXPECT_EQ(p.name, "élbow");
  EXPECT_EQ(p.cell.path, "cells/arcmate.json");
  ASSERT_EQ(p.parts.size(), 2U);
  EXPECT_EQ(p.parts[0].file.path, "elbow.step");
  EXPECT_EQ(p.parts[0].placement.positionMm[2], 12.5);
  EXPECT_EQ(p.parts[0].placement.rotationDeg[0], 90.0);
  EXPECT_THAT(p.parts[0].faces, ElementsAre(1, 2));
  EXPECT_EQ(p.parts[0].import.at("chord_mm").asReal(), 0.01);
  EXPECT_TRUE(p.parts[1].import.isObject());
  EXPECT_EQ(p.substrate("plate")->type, Substrate::Type::Plate);
  EXPECT_EQ(p.substrate("plate")->sizeMm[2], 20.0);
  EXPECT_EQ(p.substrate("on_part")->type, Substrate::Type::Part);
  EXPECT_EQ(p.substrate("on_part")->part, "base.part");
  EXPECT_EQ(p.guide("axis")->formulas[0], "50*cos(t)-50");
  EXPECT_EQ(p.guide("axis")->end, 1.5);
  EXPECT_EQ(p.guide("rim")->edge, 3);
  EXPECT_TRUE(p.guide("rim")->reversed);
  EXPECT_EQ(p.guide("named")->edge, -1);
  EXPECT_EQ(p.guide("named")->edgeName, "E12");
  EXPECT_EQ(p.guide("line")->file.path, "guide.csv");
  EXPECT_EQ(p.process("steel")->params.at("wire_speed").asReal(), 3.5);
  EXPECT_EQ(p.process("shop")->file.path, "processes/shop.json");
  EXPECT_TRUE(p.operation("planar")->enabled);
  EXPECT_FALSE(p.operation("guided")->enabled);
  EXPECT_EQ(p.operation("guided")->guide, "axis");
  EXPECT_THAT(p.operation("guided")->parts, ElementsAre("elbow", "base.part"));
  EXPECT_EQ(p.operation("guided")->path.at("seam").asString(), "nearest");
  EXPECT_EQ(p.output("fanuc")->folder, "ls");
  EXPECT_THAT(p.output("all")->operations, IsEmpty());
  ASSERT_EQ(p.plugins.size(), 1U);
  EXPECT_EQ(p.plugins[0].version, "0.1.0");
  EXPECT_EQ(p.operation("nothing"), nullptr);
  EXPECT_THAT(document.findings(), IsEmpty());
}

TEST(Document, KeepsUnknownKeysAndTheirOrder) {
  EXPECT_EQ(sampleDocument().tree(), sampleTree());
  EXPECT_EQ(sampleDocument().text(), toCanonicalJson(sampleTree()));
}

TEST(Document, EmptyProjectIsValid) {
  EXPECT_EQ(Document().text(),
            "{\n  \"format\": \"wcam-project\",\n  \"format_version\": 1,\n  \"name\": \"\"\n}\n");
  EXPECT_EQ(Document::empty("a").project().name, "a");
}

TEST(Document, NamesAllProblemsWithTheirPaths) {
  Value tree = sampleTree();
  tree.findMutable("parts")->mutableArray()[0].set("id", "Not An Id");
  tree.findMutable("parts")->mutableArray()[1].remove("file");
  tree.findMutable("operations")->mutableArray()[0].set("substrate", "plat");
  tree.findMutable("operations")->mutableArray()[1].set("enabled", "yes");
  tree.findMutable("outputs")->mutableArray()[1].set("id", "fanuc");
  const std::string message = problemsOf(tree);
  EXPECT_THAT(message, HasSubstr("x.wcam"));
  EXPECT_THAT(message, HasSubstr("parts[0].id: 'Not An Id' is no id"));
  EXPECT_THAT(message, HasSubstr("parts[1]: the key 'file' is missing"));
  EXPECT_THAT(message, HasSubstr("operations[0].substrate: operation 'planar' names an unknown "
                                 "substrate 'plat'; did you mean 'plate'?"));
  EXPECT_THAT(message, HasSubstr("operations[1].enabled: expected true or false, got a text"));
  EXPECT_THAT(message, HasSubstr("outputs[1].id: another output has the id 'fanuc' already"));
}

struct BadNode {
  const char* list;
  std::size_t index;
  const char* key;
  Value value;
  const char* message;
};

TEST(Document, RefusesBadNodes) {
  const Value::Array two = {Value(1), Value(2)};
  const std::vector<BadNode> cases = {
      {"parts", 0, "file", "elbow.step", "parts[0].file: expected an object, got a text"},
      {"parts", 0, "file", Value::object(), "parts[0].file: the key 'path' is missing"},
      {"parts", 0, "file", Value::object({{"path", ""}}), "must not be empty"},
      {"parts", 0, "file", Value::object({{"path", "a"}, {"sha256", "12"}}), "64 lower-case"},
      {"parts", 0, "faces", Value(Value::Array{Value(-1)}),
       "parts[0].faces[0]: expected an integer"},
      {"parts", 0, "faces", Value(Value::Array{Value(1), Value(1)}), "stands twice"},
      {"parts", 0, "placement", Value::object({{"position_mm", two}}),
       "parts[0].placement.position_mm: expected a list of 3 numbers"},
      {"substrates", 0, "type", "disc", "'disc' is not one of: part, plate"},
      {"substrates", 0, "size_mm", Value(), "the type plate needs it"},
      {"substrates", 0, "size_mm", Value(Value::Array{Value(1), Value(0), Value(1)}),
       "greater than 0"},
      {"substrates", 1, "part", "elbw", "unknown part 'elbw'; did you mean 'elbow'?"},
      {"guides", 0, "end", 0.0, "must be greater than begin"},
      {"guides", 0, "z", Value(), "the type formula needs it"},
      {"guides", 1, "edge", -3, "expected the index of an edge from 0, or its name"},
      {"guides", 1, "edge", "", "expected the index of an edge from 0, or its name"},
      {"guides", 3, "file", Value(), "the type polyline needs it"},
      {"processes", 0, "params", Value::array(), "processes[0].params: expected an object"},
      {"operations", 0, "strategy", Value(), "the key 'strategy' is missing"},
      {"operations", 0, "strategy", 7, "operations[0].strategy: expected a text, got an integer"},
      {"operations", 0, "parts", Value::array(), "needs at least one part"},
      {"operations", 0, "parts", Value(Value::Array{Value("x")}),
       "operations[0].parts[0]: operation"},
      {"operations", 1, "guide", "axes", "unknown guide 'axes'; did you mean 'axis'?"},
      {"operations", 1, "process", "zzzzzz", "unknown process 'zzzzzz'; there are: steel, shop"},
      {"outputs", 0, "operations", Value(Value::Array{Value("plan")}), "unknown operation 'plan'"},
      {"outputs", 0, "post", "Fanuc LS", "is no id"},
      {"plugins", 0, "version", 2, "plugins[0].version: expected a text"},
  };
  for (const BadNode& bad : cases) {
    EXPECT_THAT(problemsOf(changed(bad.list, bad.index, bad.key, bad.value)),
                HasSubstr(bad.message));
  }
}

TEST(Document, RefusesWhatIsNoProject) {
  EXPECT_THAT(problemsOf(Value::array()), HasSubstr("no WCAM project"));
  EXPECT_THAT(problemsOf(Value::object()),
              AllOf(HasSubstr("format: "), HasSubstr("format_version")));
  EXPECT_THAT(problemsOf(sampleTree().set("format", "other")), HasSubstr("format: must be"));
  for (const Value& version : {Value(1.0), Value("1"), Value(-1), Value(std::int64_t{1} << 40)}) {
    EXPECT_THAT(problemsOf(sampleTree().set("format_version", version)),
                HasSubstr("format_version: must be an integer"));
  }
  EXPECT_THAT(problemsOf(sampleTree().set("format_version", 0)),
              HasSubstr("version 0 is not known"));
  EXPECT_THAT(problemsOf(sampleTree().set("parts", Value::object())),
              HasSubstr("parts: expected a list"));
  EXPECT_THAT(problemsOf(sampleTree().set("parts", Value(Value::Array{Value(1)}))),
              HasSubstr("parts[0]: expected an object"));
  EXPECT_THAT(problemsOf(sampleTree().set("name", 3)), HasSubstr("name: expected a text"));
  EXPECT_THAT(problemsOf(sampleTree().set("cell", "c.json")),
              HasSubstr("cell: expected an object"));
}

TEST(Document, RefusesWhatCannotBeWritten) {
  EXPECT_THAT(problemsOf(sampleTree().set("x", std::nan(""))),
              HasSubstr("x: is not a finite number"));
  EXPECT_THAT(problemsOf(sampleTree().set("x", "\xff")), HasSubstr("x: is not UTF-8"));
  EXPECT_THAT(problemsOf(sampleTree().set("x", "\xed\xa0\x80")), HasSubstr("x: is not UTF-8"));
  EXPECT_THAT(problemsOf(sampleTree().set("x", "\xc0\xaf")), HasSubstr("x: is not UTF-8"));
  EXPECT_THAT(problemsOf(sampleTree().set("\xff", 1)), HasSubstr("key is not UTF-8"));
  Value twice(Value::Object{{"a", Value(1)}, {"a", Value(2)}});
  EXPECT_THAT(problemsOf(sampleTree().set("x", twice)), HasSubstr("x.a: stands twice"));
  Value deep = Value::array();
  for (int i = 0; i < 250; ++i) {
    deep = Value(Value::Array{deep});
  }
  EXPECT_THAT(problemsOf(sampleTree().set("x", deep)), HasSubstr("nested deeper than 200 levels"));
}

TEST(Document, DeepestTreeCanBeReadBack) {
  Value deep = Value(Value::Array{Value("end")});
  for (int i = 0; i < 198; ++i) {
    deep = Value(Value::Array{deep});
  }
  const Document document = Document::parse(sampleTree().set("x", deep));
  EXPECT_EQ(Document::parse(parseJson(document.text())), document);
}

TEST(Document, NewerVersionIsReadOnlyAndKeepsWhatIsUnderstood) {
  Value tree = changed("operations", 0, "parts", Value("elbow")).set("format_version", 7);
  const Document document = Document::parse(tree);
  EXPECT_TRUE(document.readOnly());
  EXPECT_EQ(document.tree(), tree);
  EXPECT_EQ(document.project().operations.size(), 1U);
  ASSERT_EQ(document.findings().size(), 2U);
  EXPECT_EQ(document.findings()[0].code, "project.newer_version");
  EXPECT_EQ(document.findings()[0].severity, Severity::Warning);
  EXPECT_THAT(document.findings()[0].message, HasSubstr("format 7"));
  EXPECT_EQ(document.findings()[1].code, "project.not_understood");
}

TEST(Document, TellsOfKeysThatMeanNothing) {
  Value tree = sampleTree();
  Value& plate = tree.findMutable("substrates")->mutableArray().front();
  plate.set("placement", Value::object()).set("sise_mm", Value(Value::Array{1.0, 2.0, 3.0}));
  tree.set("operation", Value(Value::Array{}));
  const Document document = Document::parse(tree);
  std::vector<std::string> lines;
  for (const Diagnostic& finding : document.findings()) {
    lines.push_back(toLine(finding));
  }
  ASSERT_THAT(lines, ::testing::SizeIs(3));
  EXPECT_THAT(lines[0], AllOf(HasSubstr("project.unknown_key: operation: is no key here"),
                              HasSubstr("did you mean 'operations'?")));
  EXPECT_THAT(lines[1], AllOf(HasSubstr("substrates[0].placement: is no key here"),
                              HasSubstr("position_mm")));
  EXPECT_THAT(lines[2], HasSubstr("did you mean 'size_mm'?"));
}

TEST(Document, WarnsOfPathsThatDoNotTravel) {
  const auto codesFor = [](const char* path) {
    const Document document =
        Document::parse(changed("parts", 0, "file", Value::object({{"path", path}})));
    std::vector<std::string> codes;
    for (const Diagnostic& finding : document.findings()) {
      EXPECT_THAT(finding.message, HasSubstr("part 'elbow'"));
      codes.push_back(finding.code);
    }
    return codes;
  };
  EXPECT_THAT(codesFor("/home/me/elbow.step"), ElementsAre("project.path_absolute"));
  EXPECT_THAT(codesFor("../elbow.step"), ElementsAre("project.path_outside"));
  EXPECT_THAT(codesFor("a/../../elbow.step"), ElementsAre("project.path_outside"));
  EXPECT_THAT(codesFor("a\\elbow.step"), ElementsAre("project.path_separator"));
  EXPECT_THAT(codesFor("a/../elbow.step"), IsEmpty());
  EXPECT_THAT(codesFor("..elbow/é.step"), IsEmpty());
  const Document folder = Document::parse(changed("outputs", 0, "folder", "../../out"));
  ASSERT_EQ(folder.findings().size(), 1U);
  EXPECT_THAT(folder.findings()[0].message, HasSubstr("output 'fanuc'"));
}

TEST(Placement, IsBryantAboutMovingAxes) {
  // R = Rx(90°): z of the part points to −y of its surroundings.
  const geometry::Pose x90 = toPose({{1, 2, 3}, {90, 0, 0}});
  EXPECT_EQ(x90.linear() * geometry::Vec3::UnitZ(), geometry::Vec3(0, -1, 0));
  EXPECT_EQ(x90.translation(), geometry::Vec3(1, 2, 3));
  // Rx(90°)·Ry(90°)·Rz(90°) = [0 0 1; 0 -1 0; 1 0 0], computed by hand.
  Eigen::Matrix3d expected;
  expected << 0, 0, 1, 0, -1, 0, 1, 0, 0;
  EXPECT_EQ(toPose({{}, {90, 90, 90}}).linear(), expected);
}

TEST(Placement, QuarterTurnsAreExact) {
  for (const double angle :
       {-450.0, -270.0, -180.0, -90.0, 0.0, 90.0, 180.0, 270.0, 360.0, 720090.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      Placement placement;
      placement.rotationDeg[static_cast<std::size_t>(axis)] = angle;
      const Eigen::Matrix3d r = toPose(placement).linear();
      const Eigen::Matrix3d rounded = r.unaryExpr([](double v) { return std::round(v); });
      EXPECT_EQ(r, rounded) << angle;
      const Eigen::Matrix3d usual =
          Eigen::AngleAxisd(degToRad(angle), Eigen::Vector3d::Unit(axis)).toRotationMatrix();
      EXPECT_LT((r - usual).norm(), 1e-9) << angle;
    }
  }
}

TEST(Placement, PoseAndBackIsTheSamePose) {
  for (const double x : {-170.0, -90.0, 0.0, 33.0, 180.0}) {
    for (const double y : {-90.0, -40.0, 0.0, 89.999, 90.0}) {
      for (const double z : {-120.0, 0.0, 15.5}) {
        const geometry::Pose pose = toPose({{1.5, -2, 0}, {x, y, z}});
        const geometry::Pose back = toPose(toPlacement(pose));
        EXPECT_LT((pose.matrix() - back.matrix()).norm(), 1e-12) << x << " " << y << " " << z;
      }
    }
  }
}

TEST(ChangeSet, NamesWhatDiffers) {
  const Document before = sampleDocument();
  EXPECT_TRUE(diff(before, before).empty());
  Value tree = sampleTree();
  auto& outputs = tree.findMutable("outputs")->mutableArray();
  std::swap(outputs[0], outputs[1]);
  tree.findMutable("guides")->mutableArray().erase(
      tree.findMutable("guides")->mutableArray().begin() + 1);
  tree.findMutable("parts")->mutableArray()[1].set("faces", Value::array());
  tree.findMutable("parts")->push(
      Value::object({{"id", "new"}, {"file", Value::object({{"path", "n.stl"}})}}));
  tree.set("name", "other");
  tree.remove("x_note");
  const ChangeSet changes = diff(before, Document::parse(tree));
  ASSERT_EQ(changes.lists.size(), 3U);
  EXPECT_EQ(changes.lists[0].list, "parts");
  EXPECT_THAT(changes.lists[0].added, ElementsAre("new"));
  EXPECT_THAT(changes.lists[0].changed, ElementsAre("base.part"));
  EXPECT_FALSE(changes.lists[0].reordered);
  EXPECT_EQ(changes.lists[1].list, "guides");
  EXPECT_THAT(changes.lists[1].removed, ElementsAre("rim"));
  EXPECT_EQ(changes.lists[2].list, "outputs");
  EXPECT_TRUE(changes.lists[2].reordered);
  EXPECT_THAT(changes.keys, ElementsAre("name", "x_note"));
}

}  // namespace
}  // namespace wcam::project
