// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are broken, missing, locked, newer, dropped; programs that ended badly.

#include "wcam/base/file_io.hpp"

#include "app/dialogs.hpp"
#include "gui_fixture.hpp"
#include "widgets/text.hpp"
#include <sys/stat.h>

#include <QDialogButtonBox>
#include <QDragEnterEvent>
#include <QLockFile>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTextBrowser>
#include <QUrl>

namespace wcam::gui {
namespace {

using test::waitFor;
using test::waitSettled;

class WindowFiles : public ::testing::Test {
protected:
  void SetUp() override {
    window.show();
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  }

  void drop(const std::filesystem::path& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(qt(pathText(file)))});
    // Qt knows the target of a drop from the enter before it.
    QDragEnterEvent enter(QPoint(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent event(QPointF(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window, &event);
    EXPECT_FALSE(test::dialogsDone()) << "the program that is dropped from must not wait";
    // The dialog closes before the function that opened it goes on.
    ASSERT_TRUE(waitFor(test::dialogsDone)) << "the drop opened no dialog";
    QTest::qWait(50);
  }

  testing::TestFolder folder;
  MainWindow window{test::plugins()};
};

TEST_F(WindowFiles, ADroppedPartIsPreviewedImportedAndShown) {
  std::filesystem::copy(test::example("elbow").parent_path() / "elbow.step",
                        folder / "Elbow Part.step");
  test::whenDialog([](QDialog& dialog) {
    auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    ASSERT_TRUE(waitFor([&] { return ok->isEnabled(); }));
    dialog.grab().save(QString(WCAM_GUI_PICTURES) + "/import-window.png");
    EXPECT_TRUE(dialog.findChild<QTextBrowser*>("importReport")->toPlainText().contains("STEP"));
    QTest::mouseClick(ok, Qt::LeftButton);
  });
  drop(folder / "Elbow Part.step");
  ASSERT_EQ(window.session().document().project().parts.size(), 1U);
  EXPECT_EQ(window.session().document().project().parts[0].id, "elbow-part");
  ASSERT_TRUE(waitSettled(window));
  EXPECT_EQ(window.tree().badge({"parts", "elbow-part"}).status, Status::Ok);
  // An operation on it makes layers.
  test::whenDialog([](QDialog& dialog) {
    dialog.grab().save(QString(WCAM_GUI_PICTURES) + "/operation-window.png");
    QTest::mouseClick(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok),
                      Qt::LeftButton);
  });
  window.actions().action("project.add_operation")->trigger();
  ASSERT_EQ(window.session().document().project().operations.size(), 1U)
      << utf8(window.noticeText());
  ASSERT_TRUE(waitSettled(window));
  // Without a cell there is no motion: the user is told so.
  EXPECT_EQ(window.tree().badge({"operations", "planar"}).status, Status::Error);
  ASSERT_FALSE(window.session().apply(
      {"cell.set",
       Value::object({{"file", Value::object({{"path", "wcam:cells/fanuc_arcmate120ic.json"},
                                              {"sha256", ""}})}})}));
  ASSERT_TRUE(waitSettled(window));
  EXPECT_GT(window.viewState().layerCount(), 5);
}

TEST_F(WindowFiles, ABrokenPartIsRefusedWithTheReasonAndTheWindowGoesOn) {
  writeFileAtomically(folder / "broken.step", "ISO-10303-21; this is no STEP file");
  test::whenDialog([](QDialog& dialog) {
    auto* report = dialog.findChild<QTextBrowser*>("importReport");
    ASSERT_TRUE(waitFor([&] { return !report->toPlainText().isEmpty(); }));
    EXPECT_TRUE(report->toPlainText().contains("broken.step")) << utf8(report->toPlainText());
    EXPECT_FALSE(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
    QTest::mouseClick(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel),
                      Qt::LeftButton);
  });
  drop(folder / "broken.step");
  EXPECT_TRUE(window.session().document().project().parts.empty());
  EXPECT_TRUE(window.openFile(test::copyOf("elbow", folder.path())));
}

TEST_F(WindowFiles, AFileThatIsNoProjectIsRefusedAndTheOldOneStays) {
  ASSERT_TRUE(window.openFile(test::copyOf("elbow", folder.path())));
  writeFileAtomically(folder / "bad.wcam", "{\"format\": \"wcam-project\", ");
  EXPECT_FALSE(window.openFile(folder / "bad.wcam"));
  EXPECT_TRUE(window.noticeText().contains("bad.wcam")) << utf8(window.noticeText());
  EXPECT_FALSE(window.openFile(folder / "none.wcam"));
  EXPECT_EQ(window.session().document().project().name, "elbow");
  ASSERT_TRUE(waitSettled(window));
}

TEST_F(WindowFiles, AMissingPartIsToldWithItsNode) {
  const std::filesystem::path file = test::copyOf("elbow", folder.path());
  std::filesystem::remove(folder / "elbow.step");
  ASSERT_TRUE(window.openFile(file));
  ASSERT_TRUE(waitSettled(window));
  EXPECT_EQ(window.tree().badge({"parts", "elbow"}).status, Status::Error);
  EXPECT_GT(window.diagnostics().count(Status::Error), 0);
  // It comes back, and so do the layers.
  std::filesystem::copy(test::example("elbow").parent_path() / "elbow.step", folder / "elbow.step");
  window.session().regenerate();
  ASSERT_TRUE(
      waitFor([&] { return test::settled(window) && window.viewState().layerCount() > 0; }));
}

TEST_F(WindowFiles, AMissingPluginIsNamed) {
  const std::filesystem::path file = test::copyOf("elbow", folder.path());
  std::string text = readFile(file);
  text.replace(text.find("wcam.slicing.planar"), 19, "acme.slicing.magic");
  writeFileAtomically(file, text);
  ASSERT_TRUE(window.openFile(file));
  ASSERT_TRUE(waitSettled(window));
  bool named = false;
  for (const FindingRow& row : window.diagnostics().rows()) {
    named = named || row.message.contains("acme.slicing.magic");
  }
  EXPECT_TRUE(named);
  EXPECT_GT(window.session().generated().operation("guide")->path->layerCount(), 0);
}

TEST_F(WindowFiles, AProjectWithoutANameTakesThatOfItsFirstFile) {
  ASSERT_EQ(window.session().document().project().name, Session::kUntitled);
  std::filesystem::create_directories(folder / "a");
  std::filesystem::create_directories(folder / "b");
  std::filesystem::copy(test::example("elbow").parent_path() / "elbow.step",
                        folder / "a" / "elbow.step");
  ASSERT_FALSE(window.session().apply(
      {"part.add",
       Value::object({{"id", "elbow"},
                      {"file", Value::object({{"path", pathText(folder / "a" / "elbow.step")},
                                              {"sha256", ""}})}})}));
  ASSERT_TRUE(waitSettled(window));
  // The first save brings the part along: nothing is wrong with its path.
  for (const FindingRow& row : window.diagnostics().rows()) {
    EXPECT_NE(row.code, "project.path_absolute");
  }
  ASSERT_TRUE(window.saveTo(folder / "b" / "bracket 2.wcam")) << utf8(window.noticeText());
  EXPECT_EQ(window.session().document().project().name, "bracket 2");
  // Later files change nothing.
  ASSERT_TRUE(window.saveTo(folder / "b" / "other.wcam"));
  EXPECT_EQ(window.session().document().project().name, "bracket 2");
}

TEST_F(WindowFiles, ASecondWindowOnTheSameFileIsWarnedAndDoesNotOverwrite) {
  const std::filesystem::path file = test::copyOf("elbow", folder.path());
  ASSERT_TRUE(window.openFile(file));
  MainWindow second(test::plugins(), false);
  ASSERT_TRUE(second.openFile(file));
  EXPECT_FALSE(second.session().lockedBy().isEmpty());
  EXPECT_FALSE(second.noticeText().isEmpty());
  EXPECT_THROW(second.session().save(), Error);
  EXPECT_TRUE(second.saveTo(folder / "other.wcam")) << utf8(second.noticeText());
  EXPECT_TRUE(second.session().lockedBy().isEmpty());
}

TEST_F(WindowFiles, AChangeByAnotherProgramIsReadOrKeptOut) {
  const std::filesystem::path file = test::copyOf("elbow", folder.path());
  ASSERT_TRUE(window.openFile(file));
  const auto changeOutside = [&](const std::string& name) {
    project::Document changed = project::loadProject(file).document;
    changed = project::apply(changed, {"project.rename", Value::object({{"name", name}})});
    writeFileAtomically(file, changed.text());
  };
  const auto answer = [&](const QString& button) {
    QMessageBox* box = nullptr;
    ASSERT_TRUE(waitFor([&] {
      box = window.findChild<QMessageBox*>("reloadBox");
      return box != nullptr && box->isVisible();
    })) << "nothing was asked";
    box->grab().save(QString(WCAM_GUI_PICTURES) + "/reload-window.png");
    for (QAbstractButton* each : box->buttons()) {
      if (each->text() == button) {
        QTest::mouseClick(each, Qt::LeftButton);
        break;
      }
    }
    ASSERT_TRUE(waitFor([&] { return window.findChild<QMessageBox*>("reloadBox") == nullptr; }));
  };
  changeOutside("outside");
  // Before anything is decided nobody's work is replaced.
  EXPECT_THROW(window.session().save(), Error);
  answer("Read again");
  EXPECT_EQ(window.session().document().project().name, "outside");
  EXPECT_FALSE(window.session().modified());
  ASSERT_FALSE(
      window.session().apply({"project.rename", Value::object({{"name", "mine"}})}).has_value());
  changeOutside("outside again");
  answer("Keep what is open");
  EXPECT_EQ(window.session().document().project().name, "mine");
  window.session().save();
  EXPECT_EQ(project::loadProject(file).document.project().name, "mine");
  // Its own saving is no change by another program.
  QTest::qWait(200);
  EXPECT_EQ(window.findChild<QMessageBox*>("reloadBox"), nullptr);
}

TEST_F(WindowFiles, UnsavedWorkIsRecoveredAfterACrash) {
  const std::filesystem::path file = test::copyOf("elbow", folder.path());
  {
    MainWindow crashed(test::plugins(), false);
    ASSERT_TRUE(crashed.openFile(file));
    ASSERT_FALSE(crashed.session().apply({"project.rename", Value::object({{"name", "rescued"}})}));
    crashed.session().autosaveNow();
    // Destroyed without being closed: nothing is asked, nothing is tidied.
  }
  ASSERT_TRUE(std::filesystem::exists(project::autosavePath(file)));
  test::whenDialog([](QDialog& box) {
    auto* message = qobject_cast<QMessageBox*>(&box);
    ASSERT_NE(message, nullptr);
    QTest::mouseClick(message->buttons().front(), Qt::LeftButton);
  });
  ASSERT_TRUE(window.openFile(file));
  EXPECT_EQ(window.session().document().project().name, "rescued");
  EXPECT_TRUE(window.session().modified());
  EXPECT_TRUE(window.saveTo(file));
  EXPECT_FALSE(std::filesystem::exists(project::autosavePath(file)));
}

TEST_F(WindowFiles, AFolderThatCannotBeWrittenToKeepsTheWork) {
  ASSERT_TRUE(window.openFile(test::copyOf("elbow", folder.path())));
  ASSERT_FALSE(window.session().apply({"project.rename", Value::object({{"name", "kept"}})}));
  // A file stands where the folder should be: no user may write there, not even root.
  writeFileAtomically(folder / "wall", "");
  EXPECT_FALSE(window.saveTo(folder / "wall" / "a.wcam"));
  EXPECT_FALSE(window.noticeText().isEmpty());
  EXPECT_TRUE(window.session().modified());
  EXPECT_EQ(window.session().document().project().name, "kept");
}

TEST_F(WindowFiles, AProjectOfANewerVersionIsShownAndNotChanged) {
  const std::filesystem::path file = test::copyOf("elbow", folder.path());
  std::string text = readFile(file);
  text.replace(text.find("\"format_version\": 1"), 19, "\"format_version\": 9");
  writeFileAtomically(file, text);
  ASSERT_TRUE(window.openFile(file));
  EXPECT_TRUE(window.session().document().readOnly());
  EXPECT_FALSE(window.actions().action("project.add_operation")->isEnabled());
  EXPECT_TRUE(window.session().apply({"project.rename", Value::object({{"name", "x"}})}));
  ASSERT_TRUE(waitSettled(window));
}

TEST_F(WindowFiles, ClosingAsksAboutUnsavedWork) {
  ASSERT_TRUE(window.openFile(test::copyOf("elbow", folder.path())));
  ASSERT_FALSE(window.session().apply({"project.rename", Value::object({{"name", "new"}})}));
  const auto answer = [](QMessageBox::StandardButton button) {
    test::whenDialog([button](QDialog& box) {
      QTest::mouseClick(qobject_cast<QMessageBox*>(&box)->button(button), Qt::LeftButton);
    });
  };
  answer(QMessageBox::Cancel);
  EXPECT_FALSE(window.close());
  EXPECT_TRUE(window.isVisible());
  answer(QMessageBox::Save);
  EXPECT_TRUE(window.close());
  EXPECT_NE(readFile(folder / "elbow.wcam").find("\"name\": \"new\""), std::string::npos);
}

}  // namespace
}  // namespace wcam::gui
