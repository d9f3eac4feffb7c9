// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "main_window.hpp"
#include "node_form.hpp"
#include "widgets/program_view.hpp"
#include "widgets/text.hpp"

#include <QDir>
#include <QFileDialog>
#include <QListWidget>
#include <QMenu>
#include <QSlider>

namespace wcam::gui {

void MainWindow::showDocument() {
  const project::Document& document = session_->document();
  tree_->setDocument(document);
  showNode(tree_->selected());
  QStringList outputs;
  for (const project::Output& output : document.project().outputs) {
    outputs.append(qt(output.id));
  }
  program_->setOutputs(outputs);
  showTitle();
  showHistory();
  updateActions();
}

void MainWindow::showTitle() {
  const QString name =
      session_->file().empty() ? tr("untitled") : qt(session_->file().filename().string());
  setWindowTitle(QString("%1[*] — WCAM").arg(name));
  setWindowModified(session_->modified());
  if (session_->document().readOnly()) {
    setWindowTitle(windowTitle() + " " + tr("(read only)"));
  }
}

void MainWindow::showHistory() {
  const QSignalBlocker block(history_);
  history_->clear();
  const std::vector<Text> labels = session_->history().labels();
  // The first entry is the state before all steps.
  history_->addItem(tr("Start"));
  for (const Text& label : labels) {
    history_->addItem(engineText(label));
  }
  const auto position = static_cast<int>(session_->history().position());
  for (int i = 0; i < history_->count(); ++i) {
    if (i > position) {
      history_->item(i)->setForeground(palette().color(QPalette::PlaceholderText));
    }
  }
  history_->setCurrentRow(position);
}

std::string MainWindow::shownOperation() const {
  const project::Project& project = session_->document().project();
  if (project.operation(chosenOperation_) != nullptr) {
    return chosenOperation_;
  }
  for (const project::Operation& operation : project.operations) {
    if (operation.enabled) {
      return operation.id;
    }
  }
  return {};
}

void MainWindow::showNode(const NodeRef& node) {
  const std::string operation = node.list == "edits"        ? operationOf(node)
                                : node.list == "operations" ? node.id
                                                            : std::string();
  if (!operation.empty() && operation != chosenOperation_) {
    chosenOperation_ = operation;
    session_->setFirst(operation);
    scene_->setResults(session_->generated(), shownOperation());
    programDelay_.start();
  }
  NodeForm form = formOf(session_->document(), node, session_->plugins());
  if (form.sections.empty()) {
    form_->clear();
  } else {
    form_->setSections(node.list + "/" + node.id, form.title, std::move(form.sections));
  }
  shownNode_ = node;
  updateActions();
}

void MainWindow::editNode(const std::string& section, const std::string& key, const Value& value) {
  const NodeRef node = shownNode_;
  try {
    const project::Command command = commandOf(session_->document(), node, section, key, value);
    if (const auto error = session_->apply(command)) {
      form_->showError(section, key, errorText(*error));
    }
  } catch (const Error& error) {
    form_->showError(section, key, errorText(error));
  }
}

void MainWindow::nodeMenu(const NodeRef& node, const QPoint& global) {
  QMenu menu(this);
  const auto add = [&](const char* id) { menu.addAction(actions_->action(id)); };
  if (node.list == "operations" || node.list == "edits") {
    add("project.add_operation");
    add("project.add_edit");
  } else if (node.list == "parts") {
    add("file.import");
    add("project.drop");
    if (!node.id.empty()) {
      menu.addAction(tr("Locate file…"), this, [this, node] { locateFile("parts", node.id); });
    }
  } else if (node.list == "substrates") {
    add("project.add_substrate");
  } else if (node.list == "guides") {
    add("project.add_guide");
  } else if (node.list == "processes") {
    add("project.add_process");
  } else if (node.list == "outputs") {
    add("project.add_output");
    add("file.export");
  } else if (node.list == "cell") {
    add("project.choose_cell");
  }
  if (!node.id.empty()) {
    menu.addSeparator();
    for (const char* id : {"edit.rename", "edit.duplicate", "edit.copy", "edit.paste", "edit.up",
                           "edit.down", "edit.remove"}) {
      add(id);
    }
  } else {
    menu.addSeparator();
    add("edit.paste");
  }
  menu.exec(global);
}

void MainWindow::screenshot() {
  if (view_ == nullptr) {
    return;
  }
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save picture"), QDir::homePath() + "/wcam.png", tr("Pictures (*.png)"));
  if (!file.isEmpty() && !view_->picture().save(file, "PNG")) {
    notify(Status::Error, tr("The picture cannot be written to %1").arg(file));
  }
}

void MainWindow::setPartStyle(viewport::PartStyle style) {
  scene_->setPartStyle(style);
}

void MainWindow::updateSection() {
  scene_->setSection(actions_->action("view.section")->isChecked(), sectionAxisIndex_,
                     sectionSlider_->value() / 1000.0);
}

}  // namespace wcam::gui
