// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
// What the engine says, in French: findings, errors, helps, steps.

#include "wcam/toolpath/edits.hpp"

#include "app/application.hpp"
#include "gui_fixture.hpp"
#include "widgets/text.hpp"

#include <QLineEdit>
#include <QLocale>
#include <QTranslator>

#include <algorithm>

namespace wcam::gui {
namespace {

using test::waitFor;
using test::waitSettled;

class French : public ::testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(loadTranslations(*qApp, "fr"));
    window = std::make_unique<MainWindow>(test::plugins(), false);
    window->show();
  }

  void TearDown() override {
    window.reset();
    for (QTranslator* translator : qApp->findChildren<QTranslator*>()) {
      QCoreApplication::removeTranslator(translator);
    }
    QLocale::setDefault(QLocale::c());
  }

  void open(const std::filesystem::path& file) {
    ASSERT_TRUE(window->openFile(file)) << utf8(window->noticeText());
    ASSERT_TRUE(waitSettled(*window));
  }

  /// The first row of the table of findings with this code.
  [[nodiscard]] FindingRow rowOf(const QString& code) const {
    const std::vector<FindingRow>& rows = window->diagnostics().rows();
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const FindingRow& r) { return r.code == code; });
    EXPECT_NE(found, rows.end()) << utf8(code);
    return found != rows.end() ? *found : FindingRow();
  }

  testing::TestFolder folder;
  std::unique_ptr<MainWindow> window;
};

TEST_F(French, FindingsOfAPathOutOfReach) {
  const std::filesystem::path file = test::copyOf("elbow", folder.path());
  open(file);
  ASSERT_FALSE(window->session().apply(
      {"part.set",
       Value::object(
           {{"id", "elbow"},
            {"placement", Value::object({{"position_mm", Value::Array{5000.0, 0.0, 0.0}}})}})}));
  ASSERT_TRUE(waitSettled(*window));
  const FindingRow row = rowOf("motion.unreachable");
  EXPECT_TRUE(row.message.contains("hors de portée du robot ; il manque au poignet jusqu’à"))
      << utf8(row.message);
  EXPECT_TRUE(row.remedy.startsWith("rien de cela seul n’y remédie")) << utf8(row.remedy);
  // Nothing of what the engine found stays English.
  std::size_t findings = 0;
  for (const GeneratedOperation& operation : window->session().generated().operations) {
    for (const Diagnostic& finding : operation.path->result().findings) {
      ++findings;
      EXPECT_NE(engineText(finding.message), qt(finding.message.str()));
      EXPECT_TRUE(finding.remedy.empty() || engineText(finding.remedy) != qt(finding.remedy.str()))
          << finding.remedy;
    }
  }
  EXPECT_GT(findings, 0U);
  EXPECT_EQ(utf8(engineText(window->session().history().undoLabel())),
            "Régler placement de pièce elbow");
}

TEST_F(French, AMissingFileOfAPart) {
  const std::filesystem::path file = test::copyOf("elbow", folder.path());
  std::filesystem::remove(folder / "elbow.step");
  open(file);
  const FindingRow row = rowOf("input-not-found");
  EXPECT_TRUE(row.message.contains("n’existe pas")) << utf8(row.message);
  EXPECT_TRUE(row.message.contains("elbow.step")) << utf8(row.message);
  EXPECT_FALSE(row.remedy.isEmpty());
  EXPECT_TRUE(row.remedy.contains("chemin")) << utf8(row.remedy);
  EXPECT_FALSE(window->openFile(folder / "none.wcam"));
  EXPECT_TRUE(window->noticeText().contains("le fichier n’existe pas"))
      << utf8(window->noticeText());
}

TEST_F(French, AWrongParameterIsToldAtItsPlace) {
  const std::filesystem::path file = test::copyOf("elbow", folder.path());
  open(file);
  ASSERT_FALSE(window->session().apply(
      {"operation.set_param",
       Value::object(
           {{"id", "planar"}, {"section", "params"}, {"key", "step"}, {"value", "wide"}})}));
  ASSERT_TRUE(waitSettled(*window));
  const Badge badge = window->tree().badge({"operations", "planar"});
  EXPECT_EQ(badge.status, Status::Error);
  EXPECT_TRUE(badge.tip.contains("operations[0].params.step : « wide » n’est pas un nombre"))
      << utf8(badge.tip);
}

TEST_F(French, ErrorsWithHints) {
  const Error error(ErrorCode::InvalidArgument, text("the project has no operation '%1'", {"a"}),
                    text("part '%1'", {std::string("part")}), text("did you mean '%1'?", {"b"}));
  EXPECT_EQ(
      utf8(errorText(error)),
      "pièce « part » : le projet n’a pas d’opération « a »\nConseil : vouliez-vous dire « b » ?");
  // What a plugin of others says stays as it is.
  EXPECT_EQ(engineText(Text(std::string("some words of a plugin, 50 %1"))),
            "some words of a plugin, 50 %1");
}

TEST_F(French, HelpsOfParameters) {
  for (const toolpath::EditTypeInfo& info : toolpath::editTypes()) {
    for (const ParamDef& def : toolpath::editSchema(info.type).params().defs()) {
      EXPECT_TRUE(def.info.help.empty() || engineText(def.info.help) != qt(def.info.help))
          << def.info.help;
    }
  }
  const auto& planar = test::plugins()->findSlicing("wcam.slicing.planar")->info;
  for (const ParamDef& def : planar.params.defs()) {
    EXPECT_TRUE(def.info.help.empty() || engineText(def.info.help) != qt(def.info.help))
        << def.info.help;
  }
}

TEST_F(French, ADecimalCommaIsTaken) {
  open(test::copyOf("elbow", folder.path()));
  window->tree().select({"operations", "planar"});
  const auto type = [this](const char* section, const char* key, const QString& text) {
    auto* line = qobject_cast<QLineEdit*>(window->form().field(section, key));
    ASSERT_NE(line, nullptr) << key;
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_EQ(utf8(window->form().errorAt(section, key)), "") << key;
  };
  const auto shown = [this](const char* section, const char* key) {
    window->form().setFocus();
    auto* line = qobject_cast<QLineEdit*>(window->form().field(section, key));
    return line != nullptr ? utf8(line->text()) : std::string();
  };
  type("params", "step", "7,25 mm");
  EXPECT_EQ(shown("params", "step"), "7,25");
  const project::Operation* operation = window->session().document().project().operation("planar");
  EXPECT_DOUBLE_EQ(operation->params.at("step").asReal(), 7.25);
  type("params", "step", "6.5");
  operation = window->session().document().project().operation("planar");
  EXPECT_DOUBLE_EQ(operation->params.at("step").asReal(), 6.5) << "files write points";
  // Vectors: with ';' between the numbers, or with commas and blanks.
  window->tree().select({"parts", "elbow"});
  for (const char* text : {"1,5; -2; 3,25", "1,5, -2, 3,25"}) {
    ASSERT_FALSE(window->session().apply(
        {"part.set", Value::object({{"id", "elbow"}, {"placement", Value()}})}));
    type("node", "placement_position_mm", text);
    const project::Part* part = window->session().document().project().part("elbow");
    EXPECT_EQ(part->placement.positionMm, (std::array<double, 3>{1.5, -2.0, 3.25})) << text;
    EXPECT_EQ(shown("node", "placement_position_mm"), "1,5; -2; 3,25");
  }
}

TEST_F(French, FiguresAndShapesOfFindings) {
  EXPECT_EQ(
      utf8(engineText(text("the gap is %1 and %2", {std::string("6.02 mm"), std::string("-0.5")}))),
      "the gap is 6,02 mm and -0,5");
  // Names and versions are no figures.
  EXPECT_EQ(utf8(engineText(text("%1 of %2", {std::string("part 2.stl"), std::string("1.2.3")}))),
            "part 2.stl of 1.2.3");
  EXPECT_EQ(utf8(figureText(1234.5, 2)), "1234,50");
  EXPECT_EQ(utf8(engineText(text("robot %1", {text("forearm")}))).find("forearm"),
            std::string::npos);
}

TEST_F(French, NamesOfStrategies) {
  std::size_t strategies = 0;
  for (const plugin::ComponentEntry& entry : test::plugins()->components()) {
    if (entry.kind == plugin::ComponentKind::Slicing) {
      ++strategies;
      EXPECT_NE(engineText(entry.name), qt(entry.name));
    }
  }
  EXPECT_GT(strategies, 10U);
}

}  // namespace
}  // namespace wcam::gui
