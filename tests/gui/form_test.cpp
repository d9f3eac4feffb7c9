// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/io/import.hpp"
#include "wcam/process/process.hpp"
#include "wcam/project/project_file.hpp"

#include "app/node_form.hpp"
#include "app/placing.hpp"
#include "gui_fixture.hpp"
#include "widgets/diagnostics_table.hpp"
#include "widgets/text.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollArea>
#include <QToolButton>

namespace wcam::gui {
namespace {

struct Edit {
  std::string section;
  std::string key;
  Value value;
};

/// A form of the process parameters that records its edits.
class Form : public ::testing::Test {
protected:
  void SetUp() override {
    QObject::connect(
        &form, &ParamForm::edited, &form,
        [this](const std::string& section, const std::string& key, const Value& value) {
          edits.push_back({section, key, value});
        });
    form.resize(360, 500);
    form.show();
    set(Value::object());
  }

  void set(const Value& values) {
    form.setSections("process/steel", "steel",
                     {{"params", "Parameters", process::ProcessParams::schema().params(), values}});
  }

  QLineEdit& line(const char* key) { return *qobject_cast<QLineEdit*>(form.field("params", key)); }

  void type(const char* key, const QString& text) {
    line(key).setFocus();
    line(key).selectAll();
    QTest::keyClicks(&line(key), text);
    QTest::keyClick(&line(key), Qt::Key_Return);
  }

  ParamForm form;
  std::vector<Edit> edits;
};

TEST_F(Form, ShowsDefaultsAndValuesInFileUnits) {
  EXPECT_EQ(line("wire_diameter").text(), "1.2");
  set(Value::object({{"wire_diameter", 1.0}}));
  EXPECT_EQ(line("wire_diameter").text(), "1");
}

TEST_F(Form, TakesUnitsAndTellsWhatWasEdited) {
  type("bead_width", "0.5 cm");
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(edits[0].section, "params");
  EXPECT_EQ(edits[0].key, "bead_width");
  EXPECT_DOUBLE_EQ(edits[0].value.asReal(), 5.0);
  EXPECT_TRUE(form.errorAt("params", "bead_width").isEmpty());
}

TEST_F(Form, AWrongValueStaysWithItsErrorAndChangesNothing) {
  type("bead_width", "-4");
  EXPECT_TRUE(edits.empty());
  EXPECT_FALSE(form.errorAt("params", "bead_width").isEmpty());
  type("bead_width", "wide");
  EXPECT_TRUE(edits.empty());
  EXPECT_TRUE(form.errorAt("params", "bead_width").contains("wide"))
      << utf8(form.errorAt("params", "bead_width"));
  type("bead_width", "7");
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_TRUE(form.errorAt("params", "bead_width").isEmpty());
}

TEST_F(Form, AValueOfTheFileThatIsWrongHasItsErrorAtTheField) {
  set(Value::object({{"wire_speed", -1.0}}));
  EXPECT_FALSE(form.errorAt("params", "wire_speed").isEmpty());
  EXPECT_TRUE(form.errorAt("params", "bead_width").isEmpty());
}

TEST_F(Form, WhatIsSetCanBeReset) {
  set(Value::object({{"bead_width", 7.0}}));
  ASSERT_NE(form.field("params", "bead_width"), nullptr);
  const auto buttons = form.findChildren<QToolButton*>();
  QToolButton* reset = nullptr;
  for (QToolButton* button : buttons) {
    if (button->isVisible() && button->accessibleName().startsWith("Reset")) {
      EXPECT_EQ(reset, nullptr) << "only one parameter is set";
      reset = button;
    }
  }
  ASSERT_NE(reset, nullptr);
  QTest::mouseClick(reset, Qt::LeftButton);
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(edits[0].key, "bead_width");
  EXPECT_TRUE(edits[0].value.isNull());
}

TEST_F(Form, SearchShowsParametersOfEveryLevel) {
  auto* search = form.findChild<QLineEdit*>("formSearch");
  search->setText("density");
  EXPECT_TRUE(line("density").isVisible());
  EXPECT_FALSE(line("bead_width").isVisible());
  search->setText("nothing of the kind");
  EXPECT_FALSE(line("density").isVisible());
  search->clear();
  EXPECT_TRUE(line("bead_width").isVisible());
}

TEST_F(Form, LevelsHideWhatIsNotSet) {
  std::vector<ParamDef> defs;
  for (const auto& [key, level] :
       {std::pair("plain", ParamLevel::Basic), std::pair("more", ParamLevel::Advanced),
        std::pair("odd", ParamLevel::Expert), std::pair("chosen", ParamLevel::Expert)}) {
    ParamDef def;
    def.info.key = def.info.label = key;
    def.info.level = level;
    def.defaultValue = Value(1.0);
    defs.push_back(def);
  }
  form.setSections("levels", "levels",
                   {{"params", "Parameters", ParamSchema(defs), Value::object({{"chosen", 2.0}})}});
  const auto shown = [&](const char* key) { return form.field("params", key)->isVisible(); };
  auto* level = form.findChild<QComboBox*>("formLevel");
  level->setCurrentIndex(0);
  EXPECT_TRUE(shown("plain"));
  EXPECT_FALSE(shown("more"));
  EXPECT_FALSE(shown("odd"));
  EXPECT_TRUE(shown("chosen")) << "what is set is always shown";
  level->setCurrentIndex(1);
  EXPECT_TRUE(shown("more"));
  EXPECT_FALSE(shown("odd"));
  level->setCurrentIndex(2);
  EXPECT_TRUE(shown("odd"));
}

TEST_F(Form, ANewValueOfTheSameNodeKeepsTheFields) {
  QWidget* before = form.field("params", "bead_width");
  set(Value::object({{"bead_width", 9.0}}));
  EXPECT_EQ(form.field("params", "bead_width"), before);
  EXPECT_EQ(line("bead_width").text(), "9");
}

TEST_F(Form, MakesWidgetsOnceAndOnlyForWhatIsShown) {
  auto* level = form.findChild<QComboBox*>("formLevel");
  level->setCurrentIndex(0);
  std::vector<ParamDef> defs;
  for (int i = 0; i < 60; ++i) {
    ParamDef def;
    def.info.key = def.info.label = "p" + std::to_string(i);
    def.info.level = i % 3 == 0 ? ParamLevel::Basic : ParamLevel::Expert;
    def.defaultValue = Value(1.0);
    defs.push_back(def);
  }
  const auto show = [&](const Value& values) {
    form.setSections("many", "many", {{"params", "Parameters", ParamSchema(defs), values}});
  };
  const int before = form.builds();
  show(Value::object());
  EXPECT_EQ(form.filledRows(), 0U) << "widgets come in later turns of the event loop";
  // The last turn lays them out and shows them.
  ASSERT_TRUE(test::waitFor([&] { return form.findChild<QScrollArea*>()->widget() != nullptr; }));
  EXPECT_EQ(form.filledRows(), 20U);
  show(Value::object({{"p0", 9.0}}));
  show(Value::object({{"p3", 7.0}}));
  EXPECT_EQ(form.builds(), before + 1) << "other values of the same parameters";
  show(Value::object({{"p1", 2.0}}));
  EXPECT_EQ(form.filledRows(), 21U) << "what is set is shown";
  level->setCurrentIndex(2);
  EXPECT_EQ(form.filledRows(), 60U);
  level->setCurrentIndex(0);
  EXPECT_EQ(form.builds(), before + 1);
}

TEST_F(Form, AListOfObjectsIsChosenWithTheKeyboardAndTheMouse) {
  ParamDef def;
  def.info.key = def.info.label = "parts";
  def.type = ParamType::Text;
  def.defaultValue = Value("");
  const auto show = [&](const char* ids) {
    form.setSections("list", "list",
                     {{"node",
                       "Settings",
                       ParamSchema({def}),
                       Value::object({{"parts", ids}}),
                       false,
                       {{"parts", {{"a", "a – a.step"}, {"b", ""}, {"c", ""}}}},
                       {}}});
  };
  show("c, gone");
  auto* list = qobject_cast<QListWidget*>(form.field("node", "parts"));
  ASSERT_NE(list, nullptr);
  ASSERT_EQ(list->count(), 4);
  EXPECT_EQ(list->item(0)->text(), "a – a.step");
  EXPECT_EQ(list->item(2)->checkState(), Qt::Checked);
  EXPECT_TRUE(list->item(3)->text().contains("gone")) << "it can be unchecked";
  list->setFocus();
  list->setCurrentRow(0);
  QTest::keyClick(list, Qt::Key_Space);
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(edits[0].value, Value("c, gone, a")) << "the order of the file stays";
  show("c, gone, a");
  EXPECT_EQ(form.field("node", "parts"), list);
  const QRect last = list->visualItemRect(list->item(3));
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, last.center());
  QTest::keyClick(list, Qt::Key_Space);
  ASSERT_EQ(edits.size(), 2U);
  EXPECT_EQ(edits[1].value, Value("c, a"));
}

TEST_F(Form, AnIndexCountsFromOne) {
  ParamDef def;
  def.info.key = def.info.label = "first_layer";
  def.info.min = -100;
  def.info.max = 100;
  def.type = ParamType::Integer;
  def.defaultValue = Value(0);
  const auto show = [&](const Value& values) {
    form.setSections(
        "index", "index",
        {{"params", "Parameters", ParamSchema({def}), values, false, {}, {"first_layer"}}});
  };
  show(Value::object());
  EXPECT_EQ(line("first_layer").text(), "1");
  type("first_layer", "4");
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(edits[0].value, Value(3));
  show(Value::object({{"first_layer", 3}}));
  EXPECT_EQ(line("first_layer").text(), "4");
  type("first_layer", "-1");
  ASSERT_EQ(edits.size(), 2U);
  EXPECT_EQ(edits[1].value, Value(-1)) << "the top layer";
  show(Value::object({{"first_layer", -1}}));
  EXPECT_EQ(line("first_layer").text(), "-1");
  type("first_layer", "0");
  EXPECT_EQ(edits.size(), 2U);
  EXPECT_FALSE(form.errorAt("params", "first_layer").isEmpty());
}

TEST(NodeForm, PartsAndOperationsAreChosenAndLayersOfEditsCountFromOne) {
  project::Document document = project::loadProject(test::example("elbow")).document;
  const NodeForm operation = formOf(document, {"operations", "planar"}, *test::plugins());
  ASSERT_EQ(operation.sections[0].lists.count("parts"), 1U);
  EXPECT_EQ(operation.sections[0].lists.at("parts").size(), document.project().parts.size());
  const project::Command command = commandOf(document, {"operations", "planar"}, "node", "parts",
                                             Value("x, " + document.project().parts[0].id));
  EXPECT_EQ(command.args.at("parts").size(), 2U);
  document = project::apply(
      document,
      {"edit.add", Value::object({{"operation", "planar"}, {"id", "p"}, {"type", "pause"}})});
  const NodeForm edit = formOf(document, editRef("planar", "p"), *test::plugins());
  EXPECT_EQ(edit.sections[1].indices, (std::set<std::string>{"first_layer", "last_layer", "bead"}));
}

TEST(NodeForm, EveryNodeOfEveryExampleHasAFormWhoseFieldsMakeValidCommands) {
  for (const char* name : {"elbow", "hemisphere", "branches", "supportless"}) {
    const project::Document document = project::loadProject(test::example(name)).document;
    for (const char* list :
         {"parts", "substrates", "guides", "processes", "operations", "outputs"}) {
      const Value* nodes = document.tree().find(list);
      for (std::size_t i = 0; nodes != nullptr && i < nodes->size(); ++i) {
        const NodeRef node{list, nodes->asArray()[i].at("id").asString()};
        const NodeForm form = formOf(document, node, *test::plugins());
        ASSERT_FALSE(form.sections.empty()) << list;
        for (const FormSection& section : form.sections) {
          EXPECT_TRUE(plugin::schemaProblems(section.schema).empty())
              << list << "." << section.id << ": "
              << plugin::schemaProblems(section.schema).front();
          for (const ParamDef& def : section.schema.defs()) {
            // Writing a value again that the file holds changes nothing.
            if (const Value* value = section.values.find(def.info.key)) {
              const project::Document after = project::apply(
                  document, commandOf(document, node, section.id, def.info.key, *value));
              if (def.info.key != "file") {  // choosing a file again drops its pinned hash
                EXPECT_EQ(after, document) << list << "." << node.id << "." << def.info.key;
              }
            }
          }
        }
      }
    }
  }
}

TEST(NodeForm, TheCellIsChosenFromTheShippedOnes) {
  const project::Document document = project::loadProject(test::example("elbow")).document;
  const NodeForm form = formOf(document, {"cell", {}}, *test::plugins());
  const ParamDef& def = form.sections.front().schema.defs().front();
  EXPECT_GE(def.info.choices.size(), 4U);
  const project::Document other =
      project::apply(document, commandOf(document, {"cell", {}}, "node", "file",
                                         Value("wcam:cells/yaskawa_ma1440_mt250.json")));
  EXPECT_EQ(other.project().cell.path, "wcam:cells/yaskawa_ma1440_mt250.json");
  const project::Document none =
      project::apply(document, commandOf(document, {"cell", {}}, "node", "file", Value("-")));
  EXPECT_TRUE(none.project().cell.empty());
}

TEST(Placing, StandsAPartOnThePlateAndOnAFace) {
  // A wedge of two faces: 0 below, 1 looks along +x.
  geometry::PartSurface part;
  part.mesh.vertices = {{10, 10, 5}, {30, 10, 5}, {30, 40, 5}, {30, 10, 25}, {30, 40, 25}};
  part.mesh.triangles = {{0, 2, 1}, {1, 2, 4}, {1, 4, 3}};
  part.binding.face = {0, 1, 1};
  const geometry::Pose none = geometry::Pose::Identity();
  const project::Placement flat = placedOn(part, none, none, -1);
  EXPECT_EQ(flat.positionMm, (std::array<double, 3>{-20, -25, -5}));
  EXPECT_EQ(flat.rotationDeg, (std::array<double, 3>{}));
  const project::Placement turned = placedOn(part, none, none, 1);
  const geometry::Pose T = project::toPose(turned);
  for (const int v : {1, 2, 3, 4}) {
    EXPECT_NEAR((T * part.mesh.vertices[static_cast<std::size_t>(v)]).z(), 0.0, 1e-5);
  }
  EXPECT_GT((T * part.mesh.vertices[0]).z(), 1.0);
  // On a plate that stands elsewhere.
  geometry::Pose plate = none;
  plate.translation() = geometry::Vec3(100, 0, 40);
  EXPECT_EQ(placedOn(part, none, plate, -1).positionMm, (std::array<double, 3>{80, -25, 35}));
}

TEST(Findings, RowsCountFromOneAndCanBeFiltered) {
  Diagnostic d{Severity::Violation, "motion.joint_limit", "J5 goes too far",
               "turn the part",     {"elbow", 2, 0, 11},  {}};
  const FindingRow row = rowOf(d);
  EXPECT_EQ(row.status, Status::Error);
  EXPECT_TRUE(row.place.contains("3")) << utf8(row.place);
  EXPECT_TRUE(row.place.contains("12")) << utf8(row.place);
  d.severity = Severity::Information;
  d.message = "something else";
  DiagnosticsTable table;
  table.setRows({row, rowOf(d)});
  EXPECT_EQ(table.count(Status::Error), 1);
  EXPECT_EQ(table.shownRows(), 2);
  auto* filter = table.findChild<QLineEdit*>("diagnosticsFilter");
  filter->setText("too far");
  EXPECT_EQ(table.shownRows(), 1);
  filter->clear();
  EXPECT_EQ(table.shownRows(), 2);
}

}  // namespace
}  // namespace wcam::gui
