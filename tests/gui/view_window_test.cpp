// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
// What the mouse picks and where the camera is, in the real window.

#include "wcam/base/file_io.hpp"
#include "wcam/cell/kinematics.hpp"

#include "gui_fixture.hpp"
#include "widgets/text.hpp"

#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::gui {
namespace {

using test::waitFor;
using test::waitSettled;

double distance(const viewport::Point& a, const viewport::Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

class ViewWindow : public ::testing::Test {
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

  viewport::View& view() { return window.view()->view(); }

  viewport::Pick pickAt(const viewport::Point& p) {
    const auto pixel = view().project(p);
    return view().pick(pixel[0], pixel[1], {});
  }

  viewport::Point position(std::size_t move) { return window.viewState().path()->position(move); }

  /// Moves of a layer that lay a bead.
  std::vector<std::size_t> beadMoves(int layer) {
    std::vector<std::size_t> moves;
    const auto path = window.viewState().path();
    for (std::size_t i = path->layerBegin(layer); i < path->layerBegin(layer + 1); ++i) {
      if (path->pathPoint(i) != nullptr) {
        moves.push_back(i);
      }
    }
    return moves;
  }

  testing::TestFolder folder;
  MainWindow window{test::plugins()};
};

TEST_F(ViewWindow, WhatIsHiddenIsNotPicked) {
  // Of a layer in the middle the far side lies behind the solid part.
  window.actions().action("view.part_solid")->trigger();
  window.actions().action("view.front")->trigger();
  window.view()->picture();
  const std::vector<std::size_t> moves = beadMoves(4);
  const auto depth = [&](std::size_t move) { return distance(view().eye(), position(move)); };
  const auto [near, far] =
      std::minmax_element(moves.begin(), moves.end(),
                          [&](std::size_t a, std::size_t b) { return depth(a) < depth(b); });
  ASSERT_GT(depth(*far) - depth(*near), 20.0);
  // What is seen is picked.
  const viewport::Pick seen = pickAt(position(*near));
  ASSERT_EQ(seen.kind, viewport::Pick::Kind::Move);
  EXPECT_LT(distance(seen.position, position(*near)), 12.0);
  for (const std::size_t move : moves) {
    if (depth(move) < depth(*far) - 5.0) {
      continue;
    }
    const viewport::Pick pick = pickAt(position(move));
    EXPECT_NE(pick.index, static_cast<int>(move)) << "a point behind the part";
    EXPECT_LT(distance(view().eye(), pick.position), depth(move) - 10.0);
  }
  // From below the plate hides everything.
  window.actions().action("view.bottom")->trigger();
  window.view()->picture();
  for (const std::size_t move : moves) {
    EXPECT_EQ(pickAt(position(move)).kind, viewport::Pick::Kind::None) << move;
  }
  window.actions().action("view.substrate")->trigger();
  EXPECT_NE(pickAt(position(moves.front())).kind, viewport::Pick::Kind::None);
}

TEST_F(ViewWindow, WhatASectionTakesAwayIsNotPicked) {
  window.actions().action("view.part_hidden")->trigger();
  window.actions().action("view.section")->trigger();
  window.actions().action("view.front")->trigger();
  window.view()->picture();
  // The section keeps what is behind the middle in y.
  const std::array<double, 6> box = window.view()->scene().bounds();
  const double middle = 0.5 * (box[2] + box[3]);
  int cut = 0;
  for (const std::size_t move : beadMoves(4)) {
    if (position(move)[1] < middle - 2.0) {
      ++cut;
      const viewport::Pick pick = pickAt(position(move));
      EXPECT_NE(pick.index, static_cast<int>(move));
      EXPECT_TRUE(pick.kind == viewport::Pick::Kind::None || pick.position[1] > middle - 1e-6);
    }
  }
  EXPECT_GT(cut, 5);
}

TEST_F(ViewWindow, AFindingIsLookedAtWhereItIsDrawnAndFromOutsideOfTheRobot) {
  window.actions().action("view.cell")->trigger();
  window.view()->picture();
  const auto path = window.viewState().path();
  const std::size_t move = path->layerBegin(path->layerCount() / 2) + 10;
  FindingRow row;
  row.jump = {"planar", path->layer(move), path->bead(move), path->point(move)};
  row.node = {"operations", "planar"};
  // From near: as near as the robot's arm.
  for (int i = 0; i < 12; ++i) {
    view().zoom(1.25, 300.0, 300.0);
  }
  emit window.diagnostics().activated(row);
  const auto cell = window.session().generated().cell;
  const motion::Waypoint* waypoint = path->waypoint(window.viewState().move());
  ASSERT_NE(waypoint, nullptr);
  const geometry::Pose T_world_part =
      cell->T_world_base * cell::T_base_part(*cell, waypoint->joints);
  const viewport::Point p = position(window.viewState().move());
  const geometry::Vec3 drawn = T_world_part * geometry::Vec3(p[0], p[1], p[2]);
  const viewport::Point wanted = {drawn.x(), drawn.y(), drawn.z()};
  ASSERT_GT(distance(wanted, p), 100.0) << "the table stands away from the world's origin";
  EXPECT_LT(distance(view().focus(), wanted), 1e-3);
  for (const std::array<double, 6>& box : window.view()->scene().obstacles(wanted)) {
    const viewport::Point eye = view().eye();
    const bool inside = eye[0] > box[0] && eye[0] < box[1] && eye[1] > box[2] && eye[1] < box[3] &&
                        eye[2] > box[4] && eye[2] < box[5];
    EXPECT_FALSE(inside) << "the camera is inside a body of the cell";
  }
}

TEST_F(ViewWindow, WhatMovesOutOfTheViewIsFollowed) {
  ASSERT_TRUE(view().sees(window.view()->scene().bounds()));
  for (const char* id : {"elbow"}) {
    ASSERT_FALSE(window.session().apply(
        {"part.set",
         Value::object(
             {{"id", id},
              {"placement", Value::object({{"position_mm", Value::Array{900.0, 700.0, 0.0}}})}})}));
  }
  ASSERT_TRUE(waitSettled(window));
  const std::array<double, 6> box = window.view()->scene().bounds();
  EXPECT_TRUE(view().sees(box)) << "the camera looks at nothing";
  // Not when the user came near on purpose.
  const viewport::Point focus = view().focus();
  ASSERT_FALSE(window.session().apply(
      {"operation.set_param", Value::object({{"id", "planar"}, {"key", "step"}, {"value", 7.0}})}));
  ASSERT_TRUE(waitSettled(window));
  EXPECT_LT(distance(view().focus(), focus), 1e-9);
}

TEST_F(ViewWindow, ARobotThatIsReadWhileTheCellIsShownStandsInThePicture) {
  window.actions().action("view.cell")->trigger();
  ASSERT_FALSE(window.session().apply(
      {"cell.set", Value::object({{"file", Value::object({{"path", "wcam:cells/kuka_kr16.json"},
                                                          {"sha256", ""}})}})}));
  ASSERT_TRUE(waitSettled(window));
  const viewport::Point eye = view().eye();
  const auto boxes = window.view()->scene().obstacles({1e9, 1e9, 1e9});
  ASSERT_GT(boxes.size(), 5U);
  for (const std::array<double, 6>& box : boxes) {
    EXPECT_FALSE(eye[0] > box[0] && eye[0] < box[1] && eye[1] > box[2] && eye[1] < box[3] &&
                 eye[2] > box[4] && eye[2] < box[5])
        << "the camera is inside a body of the cell";
    EXPECT_TRUE(view().sees(box));
  }
}

TEST_F(ViewWindow, PlateAndCellAreDrawnBeforeAnyPath) {
  const QImage full = window.view()->picture();
  for (const char* id : {"planar", "guide"}) {
    ASSERT_FALSE(window.session().apply({"operation.remove", Value::object({{"id", id}})}));
  }
  ASSERT_FALSE(
      window.session().apply({"part.remove", Value::object({{"id", "elbow"}})}).has_value() &&
      false);
  ASSERT_TRUE(waitSettled(window));
  EXPECT_EQ(window.viewState().path(), nullptr);
  window.actions().action("view.cell")->trigger();
  EXPECT_GT(window.view()->scene().obstacles({1e9, 1e9, 1e9}).size(), 5U);
  const std::array<double, 6> box = window.view()->scene().bounds();
  EXPECT_LT(box[0], box[1]);
  EXPECT_TRUE(view().sees(box));
}

TEST_F(ViewWindow, TheMenusKeysWorkInFieldsAndMeanWhatIsTyped) {
  auto* line = qobject_cast<QLineEdit*>(window.form().field("params", "step"));
  ASSERT_NE(line, nullptr);
  QTest::mouseClick(line, Qt::LeftButton);
  QTest::keyClick(line, Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(line->selectedText(), line->text()) << "what every field can do stays its own";
  QTest::keyClicks(line, "8.5");
  bool opened = false;
  test::whenDialog([&opened](QDialog& dialog) {
    opened = true;
    EXPECT_NE(dialog.findChild<QPushButton*>("exportRun"), nullptr);
    dialog.reject();
  });
  // Ctrl+E is "to the end of the line" for a field of X11.
  QTest::keyClick(line, Qt::Key_E, Qt::ControlModifier);
  EXPECT_TRUE(opened);
  EXPECT_DOUBLE_EQ(
      window.session().document().project().operation("planar")->params.at("step").asReal(), 8.5);
  // Ctrl+Z in a field is the field's own.
  QTest::mouseClick(line, Qt::LeftButton);
  QTest::keyClick(line, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(line, "9");
  QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(window.session().history().canUndo());
  EXPECT_DOUBLE_EQ(
      window.session().document().project().operation("planar")->params.at("step").asReal(), 8.5);
}

TEST_F(ViewWindow, APartThatIsImportedAfterTheFirstSaveComesAlong) {
  testing::TestFolder elsewhere;
  std::filesystem::copy(test::example("elbow").parent_path() / "elbow.step",
                        elsewhere / "second.step");
  ASSERT_FALSE(window.session().apply(
      {"part.add",
       Value::object({{"id", "second"},
                      {"file", Value::object({{"path", pathText(elsewhere / "second.step")},
                                              {"sha256", ""}})}})}));
  ASSERT_TRUE(window.session().modified());
  window.session().save();
  EXPECT_FALSE(window.session().modified());
  const project::LoadedProject loaded = project::loadProject(window.session().file());
  EXPECT_EQ(loaded.document.project().part("second")->file.path, "second.step");
  EXPECT_EQ(readFile(folder / "second.step"), readFile(elsewhere / "second.step"));
  // What the file named already stays as its owner wrote it.
  EXPECT_EQ(loaded.document.project().part("elbow")->file.path, "elbow.step");
}

}  // namespace
}  // namespace wcam::gui
