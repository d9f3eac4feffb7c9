// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Edits of toolpaths: from the menu, from the layers that are shown and from a picked point.
#include "wcam/toolpath/edits.hpp"

#include "edit_dialog.hpp"
#include "edit_pictures.hpp"
#include "main_window.hpp"
#include "widgets/layer_slider.hpp"
#include "widgets/text.hpp"

#include <QDockWidget>
#include <QMenu>

#include <cmath>

namespace wcam::gui {

namespace {

/// The layers that are shown, as an edit says them: nothing for all.
Value shownLayers(const ViewState& state) {
  Value params = Value::object();
  if (state.lower() > 0) {
    params.set("first_layer", state.lower());
  }
  if (state.upper() + 1 < state.layerCount()) {
    params.set("last_layer", state.upper());
  }
  return params;
}

Value rounded(const geometry::Vec3& p) {
  Value::Array numbers;
  for (int i = 0; i < 3; ++i) {
    numbers.emplace_back(std::round(p(i) * 1000.0) / 1000.0);
  }
  return Value(numbers);
}

}  // namespace

bool MainWindow::makeEdit(const std::string& operation,
                          const std::string& id,
                          const std::string& type,
                          const Value& params) {
  if (operation.empty() ||
      !run({"edit.add",
            Value::object(
                {{"operation", operation}, {"id", id}, {"type", type}, {"params", params}})})) {
    return false;
  }
  tree_->select(editRef(operation, id));
  formDock_->show();
  return true;
}

void MainWindow::addEdit() {
  const NodeRef node = tree_->selected();
  const std::string operation = node.list == "edits"                            ? operationOf(node)
                                : node.list == "operations" && !node.id.empty() ? node.id
                                                                                : shownOperation();
  EditDialog dialog(session_->document(), operation, this);
  if (dialog.exec() == QDialog::Accepted) {
    makeEdit(dialog.operation(), dialog.id(), dialog.type(), Value::object());
  }
}

void MainWindow::addEditTypes(QMenu& menu, const Value& params) {
  for (const toolpath::EditTypeInfo& info : toolpath::editTypes()) {
    QAction* action = menu.addAction(
        editPicture(info.type), engineText(info.name), this, [this, type = info.key, params] {
          const std::string operation = shownOperation();
          makeEdit(operation, freeEditId(session_->document(), operation, type), type, params);
        });
    action->setToolTip(engineText(info.summary));
  }
  menu.setToolTipsVisible(true);
}

void MainWindow::layerMenu(const QPoint& global) {
  if (state_.layerCount() == 0) {
    return;
  }
  QMenu menu(this);
  menu.setObjectName("layerMenu");
  menu.addSection(state_.lower() == state_.upper()
                      ? tr("Edit layer %1").arg(state_.lower() + 1)
                      : tr("Edit layers %1 to %2").arg(state_.lower() + 1).arg(state_.upper() + 1));
  addEditTypes(menu, shownLayers(state_));
  menu.setEnabled(!session_->document().readOnly());
  menu.exec(global);
}

void MainWindow::addPointEdits(QMenu& menu, std::size_t move) {
  const toolpath::PathPoint* point = state_.path()->pathPoint(move);
  if (point == nullptr || session_->document().readOnly()) {
    return;
  }
  QMenu* edits = menu.addMenu(tr("Edit the toolpath here"));
  const int layer = state_.path()->layer(move);
  const int bead = state_.path()->bead(move);
  const Value own = Value::object({{"first_layer", layer}, {"last_layer", layer}});
  const auto add = [&](const QString& text, const std::string& type, const Value& params) {
    edits->addAction(editPicture(*toolpath::editTypeOf(type)), text, this, [this, type, params] {
      const std::string operation = shownOperation();
      makeEdit(operation, freeEditId(session_->document(), operation, type), type, params);
    });
  };
  Value seam = shownLayers(state_);
  seam.set("seam", "point").set("point", rounded(point->p));
  add(tr("Move the seams of the shown layers here"), "move_seam", seam);
  Value one = own;
  one.set("bead", bead);
  add(tr("Pause before this bead"), "pause", one);
  add(tr("Reverse this bead"), "reverse", one);
  Value around = Value::object({{"region", "sphere"}, {"centre", rounded(point->p)}});
  add(tr("Change the travel speed around this point"), "set_speed", around);
  add(tr("Change the wire feed around this point"), "set_wire", around);
  add(tr("Change the lead angle around this point"), "set_lead", around);
  add(tr("Delete layer %1").arg(layer + 1), "delete_layers", own);
  add(tr("Repeat layer %1").arg(layer + 1), "repeat_layers", own);
}

}  // namespace wcam::gui
