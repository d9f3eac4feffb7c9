// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
// The whole window with a placeholder for the 3D view.

#include "wcam/base/file_io.hpp"

#include "app/application.hpp"
#include "app/dialogs.hpp"
#include "gui_fixture.hpp"
#include "widgets/program_view.hpp"
#include "widgets/text.hpp"

#include <QAbstractButton>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QMenuBar>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QTabWidget>
#include <QTextBlock>
#include <QTranslator>

#include <set>

namespace wcam::gui {
namespace {

using test::waitFor;
using test::waitSettled;

class Offscreen : public ::testing::Test {
protected:
  void SetUp() override { window.show(); }

  void open(const char* name = "elbow") {
    ASSERT_TRUE(window.openFile(test::copyOf(name, folder.path()))) << utf8(window.noticeText());
    ASSERT_TRUE(waitSettled(window));
  }

  void set(const char* section, const char* key, const Value& value) {
    emit window.form().edited(section, key, value);
  }

  testing::TestFolder folder;
  MainWindow window{test::plugins(), false};
};

TEST_F(Offscreen, OpensTheExampleAndShowsItsLayersAndStatus) {
  open();
  EXPECT_GT(window.viewState().layerCount(), 10);
  EXPECT_EQ(window.tree().badge({"operations", "planar"}).status == Status::Ok ||
                window.tree().badge({"operations", "planar"}).status == Status::Warning,
            true);
  EXPECT_EQ(window.tree().badge({"parts", "elbow"}).status, Status::Ok);
  EXPECT_FALSE(window.isWindowModified());
}

TEST_F(Offscreen, EditsAreStepsThatCanBeTakenBackAndSaved) {
  open();
  const int layers = window.viewState().layerCount();
  window.tree().select({"operations", "planar"});
  set("params", "step", Value(10.0));
  EXPECT_TRUE(window.isWindowModified());
  ASSERT_TRUE(waitSettled(window));
  EXPECT_LT(window.viewState().layerCount(), layers);
  window.actions().action("edit.undo")->trigger();
  ASSERT_TRUE(waitSettled(window));
  EXPECT_EQ(window.viewState().layerCount(), layers);
  EXPECT_FALSE(window.isWindowModified());
  window.actions().action("edit.redo")->trigger();
  EXPECT_TRUE(window.saveTo(window.session().file()));
  EXPECT_FALSE(window.isWindowModified());
  EXPECT_NE(readFile(window.session().file()).find("\"step\": 10.0"), std::string::npos);
}

TEST_F(Offscreen, AWrongParameterIsToldAtItsFieldAndAtItsNode) {
  open();
  window.tree().select({"operations", "planar"});
  set("params", "step", Value(-3.0));
  ASSERT_TRUE(waitSettled(window));
  EXPECT_EQ(window.tree().badge({"operations", "planar"}).status, Status::Error);
  EXPECT_FALSE(window.form().errorAt("params", "step").isEmpty());
  EXPECT_GT(window.diagnostics().count(Status::Error), 0);
  EXPECT_EQ(window.tree().badge({"operations", "guide"}).status != Status::Error, true)
      << "the other operation goes on";
}

TEST_F(Offscreen, NodesAreCopiedRenamedMovedAndRemoved) {
  open();
  window.tree().select({"operations", "planar"});
  window.actions().action("edit.copy")->trigger();
  window.actions().action("edit.paste")->trigger();
  EXPECT_NE(window.session().document().project().operation("planar-2"), nullptr);
  EXPECT_EQ(window.tree().selected(), (NodeRef{"operations", "planar-2"}));
  window.actions().action("edit.up")->trigger();
  EXPECT_EQ(window.session().document().project().operations[1].id, "planar-2");
  window.actions().action("edit.remove")->trigger();
  EXPECT_EQ(window.session().document().project().operation("planar-2"), nullptr);
  // What is in use stays, and the reason is shown.
  window.tree().select({"substrates", "plate"});
  window.actions().action("edit.remove")->trigger();
  EXPECT_NE(window.session().document().project().substrate("plate"), nullptr);
  EXPECT_TRUE(window.noticeText().contains("plate")) << utf8(window.noticeText());
}

TEST_F(Offscreen, EveryActionIsReachedByTheKeyboardAndNoKeysAreTakenTwice) {
  std::set<QString> keys;
  for (const ActionCatalog::Entry& entry : window.actions().entries()) {
    if (entry.id.isEmpty()) {
      continue;
    }
    EXPECT_FALSE(entry.action->text().isEmpty()) << utf8(entry.id);
    EXPECT_FALSE(entry.action->statusTip().isEmpty()) << utf8(entry.id);
    EXPECT_TRUE(entry.menu.contains('&')) << "the menu of " << utf8(entry.id) << " has no key";
    for (const QKeySequence& sequence : entry.action->shortcuts()) {
      EXPECT_TRUE(keys.insert(sequence.toString()).second)
          << utf8(sequence.toString()) << " is taken twice, by " << utf8(entry.id);
    }
  }
  // Every action is in a menu of the bar, so the arrow keys come to it.
  std::set<QAction*> inMenus;
  for (QAction* menu : window.menuBar()->actions()) {
    for (QAction* action : menu->menu()->actions()) {
      inMenus.insert(action);
    }
  }
  for (const ActionCatalog::Entry& entry : window.actions().entries()) {
    EXPECT_EQ(inMenus.count(entry.action), 1U) << utf8(entry.id);
  }
}

TEST_F(Offscreen, TheProgramTextFollowsTheMoveAndBack) {
  open();
  window.tree().select({"operations", "planar"});
  window.actions().action("view.program")->trigger();
  ASSERT_TRUE(waitFor([&] { return window.program().editor().toPlainText().contains("P["); }));
  const std::size_t first = window.viewState().path()->layerBegin(1) + 10;
  window.viewState().setMove(first);
  ASSERT_TRUE(waitFor([&] { return window.program().markedLine() > 0; }));
  const int line = window.program().markedLine();
  window.viewState().setMove(first + 5);
  EXPECT_EQ(window.program().markedLine(), line + 5);
  // A click on the first line goes back to its move.
  window.program().editor().setTextCursor(
      QTextCursor(window.program().editor().document()->findBlockByNumber(line)));
  EXPECT_EQ(window.viewState().move(), first);
}

TEST_F(Offscreen, AJobThatRunsIsCancelledAndTheOldResultStaysMarkedAsStale) {
  open();
  window.tree().select({"operations", "planar"});
  const auto before = window.viewState().path();
  set("params", "step", Value(0.8));
  window.session().regenerate();
  window.session().cancel();
  ASSERT_TRUE(waitFor([&] { return !window.session().generation().busy(); }));
  EXPECT_TRUE(window.session().stale());
  EXPECT_EQ(window.viewState().path(), before);
  EXPECT_EQ(window.tree().badge({"operations", "planar"}).status, Status::Stale);
  window.actions().action("edit.undo")->trigger();
  ASSERT_TRUE(waitSettled(window));
}

TEST_F(Offscreen, ClosingWhileAJobRunsEnds) {
  open();
  window.tree().select({"operations", "planar"});
  set("params", "step", Value(0.5));
  window.session().regenerate();
  test::whenDialog([](QDialog& box) {
    auto* message = qobject_cast<QMessageBox*>(&box);
    ASSERT_NE(message, nullptr);
    QTest::mouseClick(message->button(QMessageBox::Discard), Qt::LeftButton);
  });
  EXPECT_TRUE(window.close());
}

TEST_F(Offscreen, TheReportIsAPageOfTheProject) {
  open();
  window.writeReport(folder / "report.html");
  ASSERT_TRUE(waitFor([&] { return !window.noticeText().isEmpty(); }));
  const std::string html = readFile(folder / "report.html");
  for (const char* wanted : {"planar", "guide", "<svg", "J6", "step"}) {
    EXPECT_NE(html.find(wanted), std::string::npos) << wanted;
  }
}

TEST_F(Offscreen, TheReportIsAPdfToo) {
  open();
  window.writeReport(folder / "report.pdf");
  ASSERT_TRUE(waitFor([&] { return !window.noticeText().isEmpty(); }));
  const std::string pdf = readFile(folder / "report.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF-1")) << pdf.substr(0, 20);
  EXPECT_NE(pdf.rfind("%%EOF"), std::string::npos);
  // Every operation has a picture of its path, height, speed and joints.
  std::size_t pictures = 0;
  for (std::size_t at = pdf.find("/Subtype /Image"); at != std::string::npos;
       at = pdf.find("/Subtype /Image", at + 1)) {
    ++pictures;
  }
  EXPECT_GE(pictures, 8U);
}

TEST_F(Offscreen, TemplatesBecomeProjectsWhoseFilesAreCopiedOnSaving) {
  NewDialog dialog;
  auto* list = dialog.findChild<QListWidget*>("templates");
  ASSERT_GE(list->count(), 5);
  for (int i = 0; i < list->count(); ++i) {
    list->setCurrentRow(i);
    window.session().create(dialog.document(window.session().plugins()));
    const std::filesystem::path file = folder / ("template" + std::to_string(i)) / "mine.wcam";
    std::filesystem::create_directories(file.parent_path());
    ASSERT_TRUE(window.saveTo(file)) << utf8(window.noticeText());
    const project::LoadedProject loaded = project::loadProject(file);
    EXPECT_TRUE(project::checkFiles(loaded.document, file).empty());
    std::size_t own = 0;
    for (const project::UsedFile& used : project::usedFiles(loaded.document)) {
      const std::string& path = used.ref.path;
      EXPECT_FALSE(std::filesystem::path(path).is_absolute()) << path;
      if (path.rfind(project::kShippedPrefix, 0) == 0) {
        continue;
      }
      // The copy beside the project is the file of the example, byte by byte.
      ++own;
      const std::filesystem::path copy = file.parent_path() / path;
      ASSERT_TRUE(std::filesystem::exists(copy)) << path;
      const std::string example = utf8(list->item(i)->data(Qt::UserRole).toString());
      ASSERT_FALSE(example.empty()) << "the empty project names no file of its own";
      EXPECT_EQ(readFile(copy), readFile(std::filesystem::path(example).parent_path() /
                                         std::filesystem::path(path).filename()));
    }
    EXPECT_EQ(own > 0, i > 0) << "every example has a part, the empty project none";
    // The check is one: it finds a file that is gone.
    for (const project::UsedFile& used : project::usedFiles(loaded.document)) {
      if (used.ref.path.rfind(project::kShippedPrefix, 0) != 0) {
        std::filesystem::remove(file.parent_path() / used.ref.path);
      }
    }
    if (own > 0) {
      EXPECT_THROW(project::checkFiles(loaded.document, file), Error);
    }
  }
}

TEST_F(Offscreen, FrenchTextsAreShown) {
  ASSERT_TRUE(loadTranslations(*qApp, "fr"));
  MainWindow french(test::plugins(), false);
  EXPECT_EQ(french.actions().action("file.new")->text(), QString::fromUtf8("&Nouveau…"));
  for (QTranslator* translator : qApp->findChildren<QTranslator*>()) {
    QCoreApplication::removeTranslator(translator);
  }
  QLocale::setDefault(QLocale::c());
}

}  // namespace
}  // namespace wcam::gui
