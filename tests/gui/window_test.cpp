// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
// The real window, driven with mouse and keyboard as its user does.

#include "wcam/base/file_io.hpp"

#include "gui_fixture.hpp"
#include "widgets/layer_slider.hpp"
#include "widgets/legend.hpp"
#include "widgets/text.hpp"
#include <unistd.h>

#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScreen>
#include <QSlider>
#include <QTextBrowser>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

namespace wcam::gui {
namespace {

using test::waitFor;
using test::waitSettled;

class Window : public ::testing::Test {
protected:
  void SetUp() override {
    window.resize(1240, 960);
    window.show();
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    ASSERT_TRUE(window.openFile(test::copyOf("elbow", folder.path()))) << utf8(window.noticeText());
    ASSERT_TRUE(waitSettled(window));
    window.tree().select({"operations", "planar"});
    QTest::qWait(50);
  }

  /// The 3D view as it is drawn now.
  QImage picture() {
    QCoreApplication::processEvents();
    return window.view()->picture().convertToFormat(QImage::Format_RGB888);
  }

  /// Keeps a picture for people to look at, and gives it back.
  QImage kept(const char* name) {
    const QImage image = picture();
    QDir().mkpath(WCAM_GUI_PICTURES);
    image.save(QString(WCAM_GUI_PICTURES) + "/" + name + ".png");
    window.grab().save(QString(WCAM_GUI_PICTURES) + "/" + name + "-window.png");
    return image;
  }

  QLineEdit* stepField() { return qobject_cast<QLineEdit*>(window.form().field("params", "step")); }

  /// Where a move is drawn, in the view's coordinates.
  QPoint pixelOf(std::size_t move) {
    const auto at = window.view()->view().project(window.viewState().path()->position(move));
    return {static_cast<int>(std::lround(at[0])), static_cast<int>(std::lround(at[1]))};
  }

  testing::TestFolder folder;
  MainWindow window{test::plugins()};
};

/// Share of pixels that differ by more than a step of the colours.
double difference(const QImage& a, const QImage& b) {
  if (a.size() != b.size() || a.isNull()) {
    return 1.0;
  }
  std::size_t other = 0;
  for (int y = 0; y < a.height(); ++y) {
    const uchar* p = a.constScanLine(y);
    const uchar* q = b.constScanLine(y);
    for (int x = 0; x < a.width(); ++x) {
      int most = 0;
      for (int c = 0; c < 3; ++c) {
        most = std::max(most, std::abs(p[3 * x + c] - q[3 * x + c]));
      }
      other += most > 12 ? 1 : 0;
    }
  }
  return static_cast<double>(other) / (a.width() * a.height());
}

/// Share of pixels whose colour is far from grey.
double colourful(const QImage& image) {
  std::size_t count = 0;
  for (int y = 0; y < image.height(); ++y) {
    const uchar* p = image.constScanLine(y);
    for (int x = 0; x < image.width(); ++x) {
      const auto [low, high] = std::minmax({p[3 * x], p[3 * x + 1], p[3 * x + 2]});
      count += high - low > 60 ? 1 : 0;
    }
  }
  return static_cast<double>(count) / (image.width() * image.height());
}

/// Compares a picture, made small, with the stored one in tests/data/gui. WCAM_UPDATE_PICTURES=1
/// stores it anew; look at it before it is committed.
void expectStored(const QImage& picture, const std::string& name) {
  constexpr int kWidth = 320;
  // What another version of the rasteriser does at edges; a bead or a colour that is missing is
  // more.
  constexpr double kSamePicture = 0.04;
  const QImage small = picture.scaledToWidth(kWidth, Qt::SmoothTransformation)
                           .convertToFormat(QImage::Format_RGB888);
  const QString file = QString(WCAM_TEST_DATA) + "/gui/" + QString::fromStdString(name) + ".png";
  if (qEnvironmentVariableIsSet("WCAM_UPDATE_PICTURES")) {
    QDir().mkpath(QFileInfo(file).path());
    ASSERT_TRUE(small.save(file));
  }
  const QImage stored = QImage(file).convertToFormat(QImage::Format_RGB888);
  ASSERT_FALSE(stored.isNull()) << file.toStdString() << " is missing";
  EXPECT_LT(difference(small, stored), kSamePicture)
      << name << " does not look as it did; see " << WCAM_GUI_PICTURES << "/" << name << ".png";
}

TEST_F(Window, TheWorkOfAUserFromOpeningToExport) {
  const int layers = window.viewState().layerCount();
  ASSERT_GT(layers, 10);
  const QImage first = kept("opened");
  EXPECT_GT(colourful(first), 0.03) << "beads are drawn";

  // Another step makes other layers, seen in the view.
  ASSERT_NE(stepField(), nullptr);
  QTest::mouseClick(stepField(), Qt::LeftButton);
  QTest::keyClick(stepField(), Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(stepField(), "10 mm");
  QTest::keyClick(stepField(), Qt::Key_Return);
  ASSERT_TRUE(waitFor([&] { return window.session().stale(); }, 1000));
  ASSERT_TRUE(waitSettled(window));
  EXPECT_LT(window.viewState().layerCount(), layers);
  EXPECT_GT(difference(first, picture()), 0.01);

  // Scrub with the move slider.
  auto* slider = window.findChild<QSlider*>("moveSlider");
  const std::size_t last = window.viewState().move();
  QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() / 4, slider->height() / 2));
  EXPECT_NEAR(static_cast<double>(window.viewState().move()), last / 4.0, last / 50.0);
  EXPECT_LT(colourful(kept("scrubbed")), colourful(first));
  const std::size_t scrubbed = window.viewState().move();
  QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_EQ(window.viewState().move(), scrubbed + 1);

  // Drag the upper thumb of the layers down.
  auto* thumbs = window.findChild<LayerSlider*>("layerSlider");
  const QPoint from = thumbs->thumb(true);
  QTest::mousePress(thumbs, Qt::LeftButton, {}, from);
  QTest::mouseMove(thumbs, QPoint(from.x(), thumbs->height() / 2));
  QTest::mouseRelease(thumbs, Qt::LeftButton, {}, QPoint(from.x(), thumbs->height() / 2));
  EXPECT_LT(window.viewState().upper(), window.viewState().layerCount() - 1);
  EXPECT_GT(window.viewState().upper(), 0);
  QTest::keyClick(thumbs, Qt::Key_Down);
  QTest::keyClick(thumbs, Qt::Key_X);
  EXPECT_TRUE(window.viewState().single());
  QTest::keyClick(thumbs, Qt::Key_A);
  EXPECT_FALSE(window.viewState().single());
  EXPECT_EQ(window.viewState().upper(), window.viewState().layerCount() - 1);

  // Pick a point of the top layer.
  QTest::keyClick(window.view(), Qt::Key_7);
  picture();
  const std::size_t wanted =
      window.viewState().path()->layerBegin(window.viewState().layerCount() - 1) + 12;
  QTest::mouseClick(window.view(), Qt::LeftButton, {}, pixelOf(wanted));
  ASSERT_TRUE(window.viewState().selected());
  const viewport::Point a = window.viewState().path()->position(*window.viewState().selected());
  const viewport::Point b = window.viewState().path()->position(wanted);
  EXPECT_LT(std::hypot(a[0] - b[0], a[1] - b[1]), 6.0);
  kept("picked");

  // Undo with the keys.
  QTest::keyClick(window.view(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitSettled(window));
  EXPECT_EQ(window.viewState().layerCount(), layers);

  // Export what is stored.
  const QString out = qt(pathText(folder / "out"));
  test::whenDialog([&](QDialog& dialog) {
    dialog.findChild<QLineEdit*>("exportFolder")->setText(out);
    auto* run = dialog.findChild<QPushButton*>("exportRun");
    QTest::mouseClick(run, Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return run->isEnabled(); }));
    dialog.grab().save(QString(WCAM_GUI_PICTURES) + "/export-window.png");
    const QString report = dialog.findChild<QTextBrowser*>("exportReport")->toPlainText();
    EXPECT_TRUE(report.contains("planar")) << utf8(report);
    QTest::mouseClick(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Close),
                      Qt::LeftButton);
  });
  QTest::keyClick(window.view(), Qt::Key_E, Qt::ControlModifier);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/report.json"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/fanuc"));

  // Nothing is unsaved, so closing asks nothing.
  EXPECT_TRUE(window.close());
}

TEST_F(Window, PlaybackLetsTheBeadsGrow) {
  window.viewState().setMove(0);
  const double before = colourful(picture());
  window.viewState().setSpeed(100.0);
  QTest::keyClick(window.view(), Qt::Key_Space);
  EXPECT_TRUE(window.viewState().playing());
  ASSERT_TRUE(waitFor([&] { return window.viewState().move() > 200; }));
  QTest::keyClick(window.view(), Qt::Key_Space);
  EXPECT_FALSE(window.viewState().playing());
  EXPECT_GT(colourful(kept("playback")), before);
  QTest::keyClick(window.view(), Qt::Key_C);
  kept("cell");
}

TEST_F(Window, ScenesShowWhatIsChosen) {
  // A size that no font changes.
  window.view()->setFixedSize(560, 420);
  QTest::qWait(50);
  window.actions().action("view.iso")->trigger();
  window.actions().action("view.fit")->trigger();
  const QImage all = kept("layers");
  EXPECT_EQ(difference(all, picture()), 0.0) << "the same scene gives the same picture";
  // Colours by another quantity.
  window.viewState().setColour(Quantity::TravelSpeed);
  const QImage speeds = kept("speeds");
  expectStored(all, "layers");
  expectStored(speeds, "speeds");
  EXPECT_GT(difference(all, speeds), 0.01);
  window.viewState().setColour(Quantity::Layer);
  EXPECT_LT(difference(all, picture()), 0.001);
  // Standard views, the plate, the section, dark and light.
  window.actions().action("view.front")->trigger();
  const QImage front = kept("front");
  expectStored(front, "front");
  EXPECT_GT(difference(all, front), 0.02);
  window.actions().action("view.substrate")->trigger();
  EXPECT_GT(difference(front, picture()), 0.005);
  window.actions().action("view.substrate")->trigger();
  window.actions().action("view.section")->trigger();
  window.actions().action("view.iso")->trigger();
  EXPECT_GT(difference(all, kept("section")), 0.01);
  window.actions().action("view.section")->trigger();
  window.actions().action("view.dark")->trigger();
  const QImage dark = kept("dark");
  expectStored(dark, "dark");
  // Icons take the colours of the theme.
  const QImage icon = window.actions().action("file.save")->icon().pixmap(24).toImage();
  int lightest = 0;
  for (int y = 0; y < icon.height(); ++y) {
    for (int x = 0; x < icon.width(); ++x) {
      lightest = std::max(lightest, qAlpha(icon.pixel(x, y)) > 200 ? qGray(icon.pixel(x, y)) : 0);
    }
  }
  EXPECT_GT(lightest, 180);
  EXPECT_LT(qGray(dark.pixel(5, 5)), 90);
  window.actions().action("view.dark")->trigger();
  EXPECT_GT(qGray(picture().pixel(5, 5)), 200);
}

TEST_F(Window, ADragTurnsTheViewAndTheWheelComesNearer) {
  QTest::keyClick(window.view(), Qt::Key_0);
  const QImage before = picture();
  const QPoint middle(window.view()->width() / 2, window.view()->height() / 2);
  QTest::mousePress(window.view(), Qt::LeftButton, {}, middle);
  QTest::mouseMove(window.view(), middle + QPoint(60, 10));
  QTest::mouseMove(window.view(), middle + QPoint(120, 20));
  QTest::mouseRelease(window.view(), Qt::LeftButton, {}, middle + QPoint(120, 20));
  const QImage turned = picture();
  EXPECT_GT(difference(before, turned), 0.01);
  EXPECT_FALSE(window.viewState().selected()) << "a drag picks nothing";
  QTest::keyClick(window.view(), Qt::Key_Plus);
  EXPECT_GT(difference(turned, picture()), 0.01);
  QTest::keyClick(window.view(), Qt::Key_F);
  QTest::keyClick(window.view(), Qt::Key_0);
  EXPECT_LT(difference(before, picture()), 0.02);
}

TEST_F(Window, MeasuresBetweenTwoPickedPoints) {
  QTest::keyClick(window.view(), Qt::Key_7);
  picture();
  QTest::keyClick(window.view(), Qt::Key_M);
  const auto path = window.viewState().path();
  const std::size_t top = path->layerBegin(window.viewState().layerCount() - 1);
  QTest::mouseClick(window.view(), Qt::LeftButton, {}, pixelOf(top + 4));
  QTest::mouseClick(window.view(), Qt::LeftButton, {}, pixelOf(top + 14));
  auto* status = window.findChild<QLabel*>("statusText");
  EXPECT_TRUE(status->text().contains("mm")) << utf8(status->text());
  EXPECT_FALSE(window.viewState().selected());
  kept("measure");
  QTest::keyClick(window.view(), Qt::Key_Escape);
  EXPECT_FALSE(window.actions().action("view.measure")->isChecked());
}

TEST_F(Window, APickedPointIsEdited) {
  const auto path = window.viewState().path();
  const std::size_t move = path->layerBegin(3) + 12;
  ASSERT_NE(path->pathPoint(move), nullptr);
  const geometry::Vec3 p = path->pathPoint(move)->p;
  viewport::Pick pick;
  pick.kind = viewport::Pick::Kind::Move;
  pick.index = static_cast<int>(move);
  bool met = false;
  QTimer::singleShot(100, [&met] {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    ASSERT_NE(menu, nullptr);
    for (QAction* action : menu->actions()) {
      if (action->menu() != nullptr && !met) {
        met = true;
        EXPECT_EQ(action->menu()->actions().size(), 8);
        action->menu()->actions().front()->trigger();
      }
    }
    menu->close();
  });
  emit window.view()->contextMenuAt(pick, window.view()->mapToGlobal(QPoint(40, 40)));
  EXPECT_TRUE(met);
  ASSERT_TRUE(waitSettled(window));
  // The seams of all layers come as near to the point as they can.
  const toolpath::Toolpath& seamed = *window.viewState().path()->result().path;
  EXPECT_NEAR((seamed.layers[3].beads[0].points.front().p - p).norm(), 0.0, 1e-3);
  EXPECT_EQ(window.tree().selected(), editRef("planar", "move_seam"));
  kept("edit-seam");
}

TEST_F(Window, ThePagesOfTheResultsAreDrawn) {
  for (const char* page :
       {"view.joints", "view.process", "view.program", "view.history", "view.findings"}) {
    window.actions().action(page)->trigger();
    QTest::qWait(300);
    kept(page + 5);
  }
  EXPECT_TRUE(window.noticeText().isEmpty()) << utf8(window.noticeText());
}

TEST_F(Window, NoLibraryOfQt5IsInTheProcess) {
  std::ifstream maps("/proc/self/maps");
  std::set<std::string> qt;
  for (std::string line; std::getline(maps, line);) {
    const auto at = line.find("libQt");
    if (at != std::string::npos) {
      qt.insert(line.substr(at, 6));
    }
    EXPECT_EQ(line.find("libQt5"), std::string::npos) << line;
  }
  EXPECT_EQ(qt, std::set<std::string>{"libQt6"});
}

long residentKb() {
  std::ifstream file("/proc/self/statm");
  long pages = 0;
  long resident = 0;
  file >> pages >> resident;
  return resident * (::sysconf(_SC_PAGESIZE) / 1024);
}

TEST_F(Window, TwoHundredRegenerationsKeepTheMemory) {
  const auto regenerate = [&](int i) {
    const auto error = window.session().apply(
        {"operation.set_param",
         Value::object({{"id", "planar"}, {"key", "step"}, {"value", i % 2 == 0 ? 20.0 : 25.0}})},
        "test");
    ASSERT_FALSE(error);
    window.session().regenerate();
    ASSERT_TRUE(waitSettled(window));
  };
  // The other operation is heavier and always the same.
  ASSERT_FALSE(window.session().apply(
      {"operation.set", Value::object({{"id", "guide"}, {"enabled", false}})}));
  for (int i = 0; i < 40; ++i) {
    regenerate(i);
  }
  picture();
  const long before = residentKb();
  for (int i = 0; i < 200; ++i) {
    regenerate(i);
  }
  picture();
  const long after = residentKb();
  // A scene, a path or a document that is kept each time would be many times this.
  constexpr long kAllowedKb = 12 * 1024;
  EXPECT_LT(after - before, kAllowedKb) << before << " kB became " << after << " kB";
}

}  // namespace
}  // namespace wcam::gui
