// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Edits of toolpaths in the window: tree, form, menus, undo.
#include "wcam/base/json.hpp"

#include "app/edit_dialog.hpp"
#include "app/edit_pictures.hpp"
#include "app/node_form.hpp"
#include "gui_fixture.hpp"
#include "widgets/layer_slider.hpp"
#include "widgets/text.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QInputDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>

namespace wcam::gui {
namespace {

using test::waitSettled;

class EditsInTheWindow : public ::testing::Test {
protected:
  void SetUp() override {
    window.show();
    ASSERT_TRUE(window.openFile(test::copyOf("elbow", folder.path()))) << utf8(window.noticeText());
    ASSERT_TRUE(waitSettled(window));
    window.tree().select({"operations", "planar"});
  }

  /// Adds an edit with the dialog. @return its node
  NodeRef add(const char* type) {
    test::whenDialog([type](QDialog& dialog) {
      auto* types = dialog.findChild<QListWidget*>("editTypes");
      for (int i = 0; i < types->count(); ++i) {
        if (types->item(i)->data(Qt::UserRole).toString() == type) {
          types->setCurrentRow(i);
        }
      }
      dialog.accept();
    });
    window.actions().action("project.add_edit")->trigger();
    return window.tree().selected();
  }

  const std::vector<project::OperationEdit>& edits() {
    return window.session().document().project().operation("planar")->edits;
  }

  void set(const char* section, const char* key, const Value& value) {
    emit window.form().edited(section, key, value);
  }

  testing::TestFolder folder;
  MainWindow window{test::plugins(), false};
};

TEST_F(EditsInTheWindow, AreAddedFromTheListAndShapedInTheForm) {
  EXPECT_EQ(add("pause"), editRef("planar", "pause"));
  ASSERT_EQ(edits().size(), 1U);
  // Every parameter of the type has a field.
  const ParamSchema schema = toolpath::editSchema(toolpath::EditType::Pause).params();
  for (const ParamDef& def : schema.defs()) {
    EXPECT_NE(window.form().field("params", def.info.key), nullptr) << def.info.key;
  }
  set("params", "time", Value(12.5));
  set("params", "first_layer", Value(4));
  set("params", "last_layer", Value(4));
  ASSERT_TRUE(waitSettled(window));
  EXPECT_EQ(toCompactJson(edits()[0].params),
            R"({"time": 12.5, "first_layer": 4, "last_layer": 4})");
  double pauses = 0.0;
  for (const motion::Waypoint& point :
       window.viewState().path()->result().motion->motion.waypoints) {
    pauses += point.pause;
  }
  EXPECT_EQ(pauses, 12.5);
  set("params", "last_layer", Value());
  EXPECT_FALSE(edits()[0].params.contains("last_layer"));
}

TEST_F(EditsInTheWindow, ChangeTheLayersAndAreTakenBack) {
  const int layers = window.viewState().layerCount();
  add("repeat_layers");
  set("params", "first_layer", Value(2));
  set("params", "last_layer", Value(3));
  ASSERT_TRUE(waitSettled(window));
  EXPECT_EQ(window.viewState().layerCount(), layers + 2);
  window.tree().select(editRef("planar", "repeat_layers"));
  window.actions().action("edit.undo")->trigger();
  window.actions().action("edit.undo")->trigger();
  window.actions().action("edit.undo")->trigger();
  ASSERT_TRUE(waitSettled(window));
  EXPECT_TRUE(edits().empty());
  EXPECT_EQ(window.viewState().layerCount(), layers);
  window.actions().action("edit.redo")->trigger();
  EXPECT_EQ(edits().size(), 1U);
}

TEST_F(EditsInTheWindow, AreSwitchedOrderedCopiedRenamedAndRemoved) {
  add("reverse");
  add("pause");
  EXPECT_EQ(edits()[1].id, "pause");
  window.actions().action("edit.up")->trigger();
  EXPECT_EQ(edits()[0].id, "pause");
  EXPECT_EQ(window.tree().selected(), editRef("planar", "pause"));
  window.actions().action("edit.down")->trigger();
  EXPECT_EQ(edits()[1].id, "pause");
  emit window.tree().enabledChanged(editRef("planar", "pause"), false);
  EXPECT_FALSE(edits()[1].enabled);
  set("node", "enabled", Value());
  EXPECT_TRUE(edits()[1].enabled);
  window.actions().action("edit.duplicate")->trigger();
  EXPECT_EQ(window.tree().selected(), editRef("planar", "pause-2"));
  window.actions().action("edit.copy")->trigger();
  window.tree().select({"operations", "guide"});
  window.actions().action("edit.paste")->trigger();
  EXPECT_EQ(window.session().document().project().operation("guide")->edits[0].id, "pause-2");
  EXPECT_EQ(window.tree().selected(), editRef("guide", "pause-2"));
  window.tree().select(editRef("planar", "pause"));
  test::whenDialog([](QDialog& dialog) {
    dialog.findChild<QLineEdit*>()->setText("cool");
    dialog.accept();
  });
  window.actions().action("edit.rename")->trigger();
  EXPECT_EQ(edits()[1].id, "cool");
  EXPECT_EQ(window.tree().selected(), editRef("planar", "cool"));
  window.actions().action("edit.remove")->trigger();
  ASSERT_EQ(edits().size(), 2U);
  EXPECT_EQ(edits()[1].id, "pause-2");
}

TEST_F(EditsInTheWindow, WhatFindsNothingHasABadge) {
  add("set_speed");
  set("params", "factor", Value(0.5));
  ASSERT_TRUE(waitSettled(window));
  EXPECT_EQ(window.tree().badge(editRef("planar", "set_speed")).status, Status::None);
  set("params", "first_layer", Value(900));
  set("params", "last_layer", Value(901));
  ASSERT_TRUE(waitSettled(window));
  EXPECT_EQ(window.tree().badge(editRef("planar", "set_speed")).status, Status::Warning);
  // One that contradicts itself stops the operation, and the place is marked.
  set("params", "last_layer", Value(3));
  ASSERT_TRUE(waitSettled(window));
  EXPECT_EQ(window.tree().badge(editRef("planar", "set_speed")).status, Status::Error);
  EXPECT_GT(window.diagnostics().count(Status::Error), 0);
}

TEST_F(EditsInTheWindow, TheLayersThatAreShownAreEdited) {
  window.viewState().setLayers(3, 5);
  auto* slider = window.findChild<LayerSlider*>();
  ASSERT_NE(slider, nullptr);
  bool met = false;
  QTimer::singleShot(50, [&met] {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    ASSERT_NE(menu, nullptr);
    for (QAction* action : menu->actions()) {
      if (action->text() == engineText("Delete layers")) {
        met = true;
        action->trigger();
      }
    }
    menu->close();
  });
  emit slider->customContextMenuRequested({5, 5});
  EXPECT_TRUE(met);
  ASSERT_EQ(edits().size(), 1U);
  EXPECT_EQ(toCompactJson(edits()[0].params), R"({"first_layer": 3, "last_layer": 5})");
  EXPECT_EQ(window.viewState().lower(), 3);
  // The right button opens the menu and leaves the layers alone.
  QTest::mousePress(slider, Qt::RightButton, {}, QPoint(10, slider->height() - 4));
  EXPECT_EQ(window.viewState().lower(), 3);
  EXPECT_EQ(window.viewState().upper(), 5);
}

TEST(EditForm, EveryTypeHasAPictureASentenceAndAForm) {
  project::Document document = project::loadProject(test::example("elbow")).document;
  for (const toolpath::EditTypeInfo& info : toolpath::editTypes()) {
    EXPECT_FALSE(editPicture(info.type).isNull());
    document = project::apply(
        document, {"edit.add",
                   Value::object({{"operation", "planar"}, {"id", info.key}, {"type", info.key}})});
    const NodeForm form = formOf(document, editRef("planar", info.key), *test::plugins());
    ASSERT_EQ(form.sections.size(), 2U) << info.key;
    const project::Command command =
        commandOf(document, editRef("planar", info.key), "params", "first_layer", Value(1));
    EXPECT_EQ(command.id, "edit.set_param");
    document = project::apply(document, command);
  }
  EXPECT_TRUE(formOf(document, editRef("planar", "none"), *test::plugins()).sections.empty());
  EXPECT_TRUE(formOf(document, editRef("none", "pause"), *test::plugins()).sections.empty());
  EXPECT_EQ(freeEditId(document, "planar", "pause"), "pause-2");
  EditDialog dialog(document, "guide");
  EXPECT_EQ(dialog.operation(), "guide");
  EXPECT_EQ(dialog.id(), "move_seam");
}

}  // namespace
}  // namespace wcam::gui
