// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
// What the window does with findings, failures and choices; without a display.

#include "wcam/base/file_io.hpp"

#include "app/cell_dialog.hpp"
#include "gui_fixture.hpp"
#include "widgets/legend.hpp"
#include "widgets/text.hpp"
#include "widgets/theme.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>

#include <algorithm>

namespace wcam::gui {
namespace {

using test::waitFor;
using test::waitSettled;

class RemedyWindow : public ::testing::Test {
protected:
  void SetUp() override {
    window.show();
    ASSERT_TRUE(window.openFile(test::copyOf("elbow", folder.path()))) << utf8(window.noticeText());
    apply("operation.set", {{"id", "guide"}, {"enabled", false}});
    ASSERT_TRUE(waitSettled(window));
    window.tree().select({"operations", "planar"});
  }

  void apply(const std::string& id, Value::Object args) {
    Value value = Value::object();
    for (auto& [key, item] : args) {
      value.set(key, item);
    }
    const auto error = window.session().apply({id, value});
    ASSERT_FALSE(error) << error->what();
  }

  void setParam(const char* key, const Value& value, const char* section = "params") {
    apply("operation.set_param",
          {{"id", "planar"}, {"section", section}, {"key", key}, {"value", value}});
  }

  /// Index of the first row in the table that a remedy can be applied to, or −1.
  int applicableRow(const QString& code = {}) {
    const auto& rows = window.diagnostics().rows();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!rows[i].apply.empty() && (code.isEmpty() || rows[i].code == code)) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

  /// Clicks the button of the first row in the table that has one.
  void clickApply() {
    auto* table = window.findChild<QTableView*>("diagnosticsTable");
    for (int row = 0; row < table->model()->rowCount(); ++row) {
      for (int column = 0; column < table->model()->columnCount(); ++column) {
        const QModelIndex index = table->model()->index(row, column);
        if (index.data().toString() == "Apply") {
          table->scrollTo(index);
          QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                            table->visualRect(index).center());
          return;
        }
      }
    }
    FAIL() << "no row has a button";
  }

  testing::TestFolder folder;
  MainWindow window{test::plugins(), false};
};

TEST_F(RemedyWindow, TheRangeOfASpiralIsAppliedWithOneClickAndDoes) {
  apply("operation.set", {{"id", "planar"}, {"strategy", "wcam.slicing.spiral"}});
  ASSERT_TRUE(waitSettled(window));
  const GeneratedOperation* refused = window.session().generated().operation("planar");
  ASSERT_TRUE(refused->error) << "the lengths of an elbow differ too much for the default range";
  ASSERT_GE(applicableRow(), 0) << refused->error->what();
  const std::string hint = refused->error->hint();
  clickApply();
  ASSERT_TRUE(waitFor([&] { return !window.session().stale(); }));
  const GeneratedOperation* applied = window.session().generated().operation("planar");
  ASSERT_TRUE(applied->path);
  EXPECT_FALSE(applied->error) << applied->error->what();
  for (const Diagnostic& finding : applied->path->result().findings) {
    EXPECT_NE(finding.code, "slicing.spiral_height") << finding.message;
    EXPECT_NE(finding.code, "slicing.spiral_infeasible") << finding.message;
  }
  // What the remedy said is what stands in the project now, with two decimals.
  const Value& params = window.session().document().project().operation("planar")->params;
  const QString low = QString::number(params.at("height_min").asReal(), 'f', 2);
  const QString high = QString::number(params.at("height_max").asReal(), 'f', 2);
  EXPECT_TRUE(qt(hint).contains(low + " to " + high))
      << hint << " but " << utf8(low) << " to " << utf8(high);
  // One step.
  window.actions().action("edit.undo")->trigger();
  EXPECT_FALSE(
      window.session().document().project().operation("planar")->params.contains("height_min"));
}

TEST_F(RemedyWindow, AHintHasNoButton) {
  FindingRow hint;
  hint.code = "a.hint";
  hint.remedy = "a hint";
  FindingRow proven = hint;
  proven.code = "a.remedy";
  proven.apply = {
      {"operation.set_param",
       Value::object({{"id", "planar"}, {"section", "params"}, {"key", "step"}, {"value", 4.0}})}};
  window.diagnostics().setRows({hint, proven});
  auto* table = window.findChild<QTableView*>("diagnosticsTable");
  auto* button = window.findChild<QToolButton*>("applyRemedy");
  for (int row = 0; row < 2; ++row) {
    table->setCurrentIndex(table->model()->index(row, 2));
    const bool isHint = table->model()->index(row, 5).data().toString() == "a.hint";
    EXPECT_EQ(button->isEnabled(), !isHint);
    if (!isHint) {
      QTest::mouseClick(button, Qt::LeftButton);
      break;
    }
  }
  EXPECT_DOUBLE_EQ(
      window.session().document().project().operation("planar")->params.at("step").asReal(), 4.0);
}

TEST_F(RemedyWindow, AnErrorKeepsTheLastPathWithoutItsFindings) {
  const auto before = window.viewState().path();
  ASSERT_NE(before, nullptr);
  ASSERT_GT(window.diagnostics().rows().size(), 0U);
  setParam("step", Value(-3.0));
  ASSERT_TRUE(waitSettled(window));
  EXPECT_EQ(window.viewState().path(), before) << "the last path that there was stays";
  const GeneratedOperation* shown = window.session().generated().operation("planar");
  EXPECT_TRUE(shown->error);
  EXPECT_TRUE(shown->outdated);
  EXPECT_NE(shown->substrate, nullptr);
  auto* note = window.findChild<QLabel*>("staleNote");
  EXPECT_FALSE(note->isHidden());
  for (const FindingRow& row : window.diagnostics().rows()) {
    EXPECT_EQ(row.jump.layer, -1) << "a finding of the old path: " << utf8(row.message);
  }
  EXPECT_EQ(window.tree().badge({"operations", "planar"}).status, Status::Error);
  // And goes when there is a path again.
  setParam("step", Value(6.0));
  ASSERT_TRUE(waitSettled(window));
  EXPECT_NE(window.viewState().path(), before);
  EXPECT_TRUE(note->isHidden());
}

TEST_F(RemedyWindow, FindingsOfDeletedLayersAreGone) {
  const int layers = window.viewState().layerCount();
  int above = 0;
  for (const FindingRow& row : window.diagnostics().rows()) {
    above += row.jump.layer >= 4 ? 1 : 0;
  }
  ASSERT_GT(above, 0) << "the upper layers have findings";
  apply("edit.add", {{"operation", "planar"},
                     {"id", "cut"},
                     {"type", "delete_layers"},
                     {"params", Value::object({{"first_layer", 4}})}});
  ASSERT_TRUE(waitSettled(window));
  ASSERT_EQ(window.viewState().layerCount(), 4);
  ASSERT_GT(layers, 4);
  for (const FindingRow& row : window.diagnostics().rows()) {
    EXPECT_LT(row.jump.layer, 4) << utf8(row.place + ": " + row.message);
  }
}

TEST_F(RemedyWindow, PlateAndCellAreThereBeforeAnyPath) {
  apply("operation.remove", {{"id", "planar"}});
  apply("operation.remove", {{"id", "guide"}});
  ASSERT_TRUE(waitSettled(window));
  const Generated& generated = window.session().generated();
  EXPECT_TRUE(generated.operations.empty());
  EXPECT_NE(generated.cell, nullptr);
  ASSERT_EQ(generated.plates.size(), 1U);
  EXPECT_NE(generated.plates[0].mesh, nullptr);
  EXPECT_EQ(window.tree().badge({"cell", {}}).status, Status::Ok);
  // A cell that cannot be read is told once, at its node.
  apply("cell.set", {{"file", Value::object({{"path", "none.json"}, {"sha256", ""}})}});
  ASSERT_TRUE(waitSettled(window));
  EXPECT_EQ(window.tree().badge({"cell", {}}).status, Status::Error);
}

TEST_F(RemedyWindow, ACellIsChosenByItsName) {
  const std::filesystem::path other = folder / "own_cell.json";
  test::whenDialog([](QDialog& dialog) {
    ASSERT_EQ(dialog.objectName(), "cellDialog");
    auto* cells = dialog.findChild<QListWidget*>("cells");
    ASSERT_GE(cells->count(), 10);
    // The project's own is chosen.
    ASSERT_NE(cells->currentItem(), nullptr);
    EXPECT_TRUE(cells->currentItem()->text().startsWith("FANUC ARC Mate 120iC"))
        << utf8(cells->currentItem()->text());
    bool found = false;
    for (int i = 0; i < cells->count(); ++i) {
      if (cells->item(i)->text().startsWith("KUKA KR16 with tilting turntable")) {
        cells->setCurrentRow(i);
        found = true;
      }
    }
    EXPECT_TRUE(found);
    EXPECT_NE(dialog.findChild<QPushButton*>("otherCell"), nullptr);
    QTest::mouseClick(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok),
                      Qt::LeftButton);
  });
  window.actions().action("project.choose_cell")->trigger();
  ASSERT_TRUE(test::dialogsDone());
  EXPECT_EQ(window.session().document().project().cell.path,
            "wcam:cells/kuka_kr16_positioner.json");
}

TEST_F(RemedyWindow, WhatIsTypedIsSavedWithTheKeys) {
  auto* line = qobject_cast<QLineEdit*>(window.form().field("params", "step"));
  ASSERT_NE(line, nullptr);
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, "7.5");
  // Neither Enter nor another field: the menu means what is being typed.
  window.actions().action("file.save")->trigger();
  EXPECT_NE(readFile(window.session().file()).find("\"step\": 7.5"), std::string::npos);
}

TEST_F(RemedyWindow, LayersInTheLimitsOfTheColoursAreCountedFromOne) {
  window.viewState().setColour(Quantity::Layer);
  const int layers = window.viewState().layerCount();
  test::whenDialog([layers](QDialog& dialog) {
    EXPECT_EQ(dialog.findChild<QLineEdit*>("rangeLow")->placeholderText(), "1");
    EXPECT_EQ(dialog.findChild<QLineEdit*>("rangeHigh")->placeholderText(),
              QString::number(layers));
    dialog.findChild<QLineEdit*>("rangeLow")->setText("3");
    dialog.accept();
  });
  window.findChild<Legend*>("legend")->editRange();
  ASSERT_TRUE(window.viewState().range());
  EXPECT_FLOAT_EQ(window.viewState().range()->first, 2.0F) << "the third layer";
}

TEST(DropDowns, TheCurrentEntryIsReadable) {
  for (const bool dark : {false, true}) {
    applyTheme(dark);
    QComboBox box;
    box.addItems({"Planar slicing", "Continuous spiral", "Iso-values"});
    box.setCurrentIndex(1);
    box.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&box));
    box.showPopup();
    ASSERT_TRUE(waitFor([&] { return box.view()->isVisible(); }));
    QTest::qWait(50);
    const QImage list = box.view()->viewport()->grab().toImage();
    for (int row = 0; row < box.count(); ++row) {
      const QRect rect = box.view()->visualRect(box.model()->index(row, 0)).adjusted(2, 2, -2, -2);
      // Letters stand out from what is behind them.
      int low = 255;
      int high = 0;
      for (int y = rect.top(); y <= rect.bottom(); ++y) {
        for (int x = rect.left(); x <= rect.right(); ++x) {
          low = std::min(low, qGray(list.pixel(x, y)));
          high = std::max(high, qGray(list.pixel(x, y)));
        }
      }
      EXPECT_GT(high - low, 90) << "entry " << row + 1 << (dark ? ", dark" : ", light");
    }
    box.hidePopup();
  }
  applyTheme(false);
}

}  // namespace
}  // namespace wcam::gui
