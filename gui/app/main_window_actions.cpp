// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "main_window.hpp"
#include "widgets/command_palette.hpp"
#include "widgets/layer_slider.hpp"
#include "widgets/legend.hpp"
#include "widgets/program_view.hpp"
#include "widgets/text.hpp"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <QTabWidget>
#include <QToolBar>

#include <algorithm>
#include <array>

namespace wcam::gui {

QAction* MainWindow::addToggle(const QString& id,
                               const QString& menu,
                               const QString& text,
                               const QString& help,
                               const QString& keys,
                               const QString& icon,
                               bool on,
                               const std::function<void(bool)>& run) {
  QAction* action = actions_->add(id, menu, text, help, keys, icon, {});
  action->setCheckable(true);
  action->setChecked(on);
  connect(action, &QAction::toggled, this, run);
  return action;
}

void MainWindow::buildFileActions() {
  const QString menu = tr("&File");
  actions_->add("file.new", menu, tr("&New…"), tr("New project from a template"), "Ctrl+N", "new",
                [this] { newProject(); });
  actions_->add("file.open", menu, tr("&Open…"), tr("Open a project"), "Ctrl+O", "open",
                [this] { openDialog(); });
  QAction* recent = actions_->add("file.recent", menu, tr("Open &recent"),
                                  tr("Projects that were open lately"), {}, {}, {});
  recent_ = new QMenu(this);
  recent->setMenu(recent_);
  connect(recent_, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
  fillRecent();
  actions_->separate(menu);
  actions_->add("file.save", menu, tr("&Save"), tr("Save the project"), "Ctrl+S", "save",
                [this] { save(); });
  actions_->add("file.save_as", menu, tr("Save &as…"), tr("Save the project under another name"),
                "Ctrl+Shift+S", {}, [this] { saveAsDialog(); });
  actions_->separate(menu);
  actions_->add("file.import", menu, tr("&Import part…"), tr("Import a CAD or mesh file as a part"),
                "Ctrl+I", "import", [this] { importDialog(); });
  actions_->add("file.export", menu, tr("&Export programs…"),
                tr("Compute everything and write the robot programs"), "Ctrl+E", "export",
                [this] { showExport(); });
  actions_->add("file.report", menu, tr("Save repor&t…"),
                tr("Save figures, plots, findings and settings as one HTML page"), "Ctrl+R", {},
                [this] { saveReport(); });
  actions_->add("file.screenshot", menu, tr("Save &picture…"), tr("Save the 3D view as a PNG file"),
                "Ctrl+Shift+P", "camera", [this] { screenshot(); });
  actions_->separate(menu);
  actions_->add("file.quit", menu, tr("&Quit"), tr("Close the program"), "Ctrl+Q", {},
                [this] { close(); });
}

void MainWindow::buildEditActions() {
  const QString menu = tr("&Edit");
  actions_->add("edit.undo", menu, tr("&Undo"), tr("Take the last change back"), "Ctrl+Z", "undo",
                [this] { session_->undo(); });
  actions_->add("edit.redo", menu, tr("&Redo"), tr("Make the change again"), "Ctrl+Shift+Z", "redo",
                [this] { session_->redo(); });
  actions_->separate(menu);
  actions_->add("edit.copy", menu, tr("&Copy node"), tr("Copy the selected node as text"),
                "Ctrl+Shift+C", {}, [this] { copyNode(); });
  actions_->add("edit.paste", menu, tr("&Paste node"), tr("Add the copied node"), "Ctrl+Shift+V",
                {}, [this] { pasteNode(); });
  actions_->add("edit.duplicate", menu, tr("&Duplicate"), tr("Add a copy of the selected node"),
                "Ctrl+D", {}, [this] { duplicateNode(); });
  actions_->add("edit.rename", menu, tr("Re&name…"), tr("Give the selected node another id"), "F2",
                {}, [this] { renameNode(); });
  actions_->add("edit.remove", menu, tr("&Remove"), tr("Remove the selected node"), "Shift+Del",
                "remove", [this] { removeNode(); });
  actions_->add("edit.up", menu, tr("Move &up"), tr("Move the selected node up in its list"),
                "Ctrl+Up", {}, [this] { moveNode(-1); });
  actions_->add("edit.down", menu, tr("Move do&wn"), tr("Move the selected node down in its list"),
                "Ctrl+Down", {}, [this] { moveNode(1); });
  actions_->separate(menu);
  actions_->add("edit.search", menu, tr("&Find parameter"),
                tr("Search in the parameters of the selected node"), "Ctrl+F", {}, [this] {
                  formDock_->show();
                  form_->focusSearch();
                });
  actions_->add("edit.palette", menu, tr("Command p&alette…"), tr("Find a command by its name"),
                "Ctrl+K", {}, [this] { CommandPalette(*actions_, this).exec(); });
}

void MainWindow::buildProjectActions() {
  const QString menu = tr("&Project");
  actions_->add("project.add_operation", menu, tr("Add &operation…"),
                tr("Choose a strategy and add an operation"), "Ctrl+Shift+O", "add",
                [this] { addOperation(); });
  actions_->add("project.add_edit", menu, tr("Add &edit of the toolpath…"),
                tr("Change the generated toolpath: seams, layers, speed, pauses, torch angles"),
                "Ctrl+Shift+E", "edit", [this] { addEdit(); });
  actions_->add("project.add_substrate", menu, tr("Add &substrate"), tr("Add a plate to build on"),
                {}, "substrate", [this] { addNode("substrates"); });
  actions_->add("project.add_guide", menu, tr("Add &guide curve"),
                tr("Add a guide curve; picked edges become one as well"), {}, "guide",
                [this] { addNode("guides"); });
  actions_->add("project.add_process", menu, tr("Add &process"), tr("Add process parameters"), {},
                "process", [this] { addNode("processes"); });
  actions_->add("project.add_output", menu, tr("Add ou&tput"), tr("Add a robot program to write"),
                {}, "output", [this] { addNode("outputs"); });
  actions_->separate(menu);
  actions_->add("project.choose_cell", menu, tr("Choose &cell…"),
                tr("Choose the robot cell, one that comes with the program or a file"), {}, "cell",
                [this] { chooseCell(); });
  actions_->add("project.drop", menu, tr("&Drop part on plate"),
                tr("Move the selected part so that it stands in the middle of the plate"), "Ctrl+L",
                {}, [this] { dropPart(); });
  actions_->separate(menu);
  actions_->add("project.regenerate", menu, tr("&Regenerate"), tr("Compute what is out of date"),
                "F5", {}, [this] { session_->regenerate(); });
  actions_->add("project.cancel", menu, tr("C&ancel"),
                tr("Stop the computation; what is shown stays"), "Esc", "cancel", [this] {
                  if (measuring_) {
                    actions_->action("view.measure")->setChecked(false);
                  } else if (session_->generation().busy()) {
                    session_->cancel();
                  } else if (state_.selected()) {
                    state_.select(std::nullopt);
                  } else {
                    hideNotice();
                  }
                });
}

void MainWindow::buildViewActions() {
  const QString menu = tr("&View");
  const auto standard = [&](const QString& id, const QString& text, const QString& keys,
                            const QString& icon, viewport::StandardView view) {
    actions_->add(id, menu, text, tr("Look from a fixed direction"), keys, icon, [this, view] {
      if (view_ != nullptr) {
        view_->view().setStandardView(view);
        view_->redraw();
      }
    });
  };
  actions_->add("view.fit", menu, tr("&Fit"), tr("Show everything"), "F", "fit", [this] {
    if (view_ != nullptr) {
      view_->view().fit();
      view_->redraw();
    }
  });
  standard("view.iso", tr("&Isometric"), "0", "iso", viewport::StandardView::Isometric);
  standard("view.front", tr("F&ront"), "1", "front", viewport::StandardView::Front);
  standard("view.back", tr("&Back"), "2", {}, viewport::StandardView::Back);
  standard("view.right", tr("Ri&ght"), "3", "right", viewport::StandardView::Right);
  standard("view.left", tr("&Left"), "4", {}, viewport::StandardView::Left);
  standard("view.top", tr("&Top"), "7", "top", viewport::StandardView::Top);
  standard("view.bottom", tr("B&ottom"), "8", {}, viewport::StandardView::Bottom);
  addToggle("view.parallel", menu, tr("&Parallel projection"), tr("Without perspective"), "P", {},
            false, [this](bool on) {
              if (view_ != nullptr) {
                view_->view().setParallel(on);
                view_->redraw();
              }
            });
  actions_->separate(menu);
  auto* styles = new QActionGroup(this);
  const auto style = [&](const QString& id, const QString& text, const QString& keys,
                         viewport::PartStyle value) {
    QAction* action = addToggle(id, menu, text, tr("How the part is drawn"), keys, {},
                                value == viewport::PartStyle::Translucent, [this, value](bool on) {
                                  if (on) {
                                    setPartStyle(value);
                                  }
                                });
    styles->addAction(action);
  };
  style("view.part_solid", tr("Part s&olid"), "Shift+1", viewport::PartStyle::Solid);
  style("view.part_translucent", tr("Part tr&anslucent"), "Shift+2",
        viewport::PartStyle::Translucent);
  style("view.part_edges", tr("Part e&dges"), "Shift+3", viewport::PartStyle::Edges);
  style("view.part_hidden", tr("Part &hidden"), "Shift+4", viewport::PartStyle::Hidden);
  actions_->separate(menu);
  addToggle("view.cell", menu, tr("&Cell"),
            tr("Show robot and positioner, and move the part with them"), "C", "cell", false,
            [this](bool on) { scene_->setCellVisible(on); });
  addToggle("view.substrate", menu, tr("&Substrate"), tr("Show the substrate"), "B", "substrate",
            true, [this](bool on) { scene_->setSubstrateVisible(on); });
  addToggle("view.travel", menu, tr("Tra&vel moves"), tr("Show the moves between beads"), "T", {},
            false, [this](bool on) { scene_->setTravelVisible(on); });
  addToggle("view.torch", menu, tr("Torc&h"), tr("Show the torch during playback"), {}, {}, true,
            [this](bool on) { scene_->setTorchVisible(on); });
  addToggle("view.legend", menu, tr("Le&gend"), tr("Show what the colours mean"), "L", {}, true,
            [this](bool on) { legend_->setVisible(on && state_.path() != nullptr); });
  QAction* colour = actions_->add("view.colour", menu, tr("Colour b&y"),
                                  tr("What the colours of the beads show"), {}, {}, {});
  colours_ = new QMenu(this);
  colour->setMenu(colours_);
  auto* group = new QActionGroup(this);
  for (int i = 0; i < kQuantityCount; ++i) {
    const auto quantity = static_cast<Quantity>(i);
    QAction* action = colours_->addAction(nameOf(quantity), this,
                                          [this, quantity] { state_.setColour(quantity); });
    action->setObjectName(QString("colour.%1").arg(i));
    action->setCheckable(true);
    action->setChecked(quantity == state_.colour());
    group->addAction(action);
  }
  actions_->add("view.range", menu, tr("Colour li&mits…"), tr("Set the ends of the colour scale"),
                "Shift+L", {}, [this] { legend_->editRange(); });
  actions_->separate(menu);
  addToggle("view.section", menu, tr("Se&ction plane"), tr("Cut what is shown by a plane"), "S",
            "section", false, [this](bool on) {
              sectionBar_->setVisible(on);
              updateSection();
            });
  addToggle("view.measure", menu, tr("M&easure"), tr("Distance between two picked places"), "M",
            "measure", false, [this](bool on) {
              measuring_ = on;
              measureFrom_.reset();
              if (view_ != nullptr) {
                view_->setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
                if (!on) {
                  view_->scene().setMeasure(std::nullopt, {});
                  view_->redraw();
                }
              }
              status_->setText(on ? tr("Pick two places to measure") : QString());
            });
  actions_->separate(menu);
  const auto tab = [&](const QString& id, const QString& text, const QString& keys, int index) {
    actions_->add(id, menu, text, tr("Show this page of the results"), keys, {}, [this, index] {
      bottomDock_->show();
      tabs_->setCurrentIndex(index);
      tabs_->currentWidget()->setFocus();
    });
  };
  tab("view.findings", tr("Findings"), "Alt+1", 0);
  tab("view.joints", tr("Joints"), "Alt+2", 1);
  tab("view.process", tr("Process"), "Alt+3", 2);
  tab("view.program", tr("Program"), "Alt+4", 3);
  tab("view.history", tr("History"), "Alt+5", 4);
  tab("view.log", tr("Log"), "Alt+6", 5);
  actions_->separate(menu);
  const auto panel = [&](const QString& id, const QString& text, const QString& keys,
                         QDockWidget* dock) {
    QAction* action = addToggle(id, menu, text, tr("Show or hide this panel"), keys, {}, true,
                                [dock](bool on) { dock->setVisible(on); });
    connect(dock, &QDockWidget::visibilityChanged, action, [dock, action] {
      const QSignalBlocker block(action);
      action->setChecked(!dock->isHidden());
    });
  };
  panel("view.tree_panel", tr("Pro&ject panel"), "F9", treeDock_);
  panel("view.form_panel", tr("Parameter pa&nel"), "F10", formDock_);
  panel("view.bottom_panel", tr("Res&ults panel"), "F11", bottomDock_);
  addToggle("view.dark", menu, tr("Dar&k theme"), tr("Light letters on dark"), "Ctrl+Shift+D", {},
            false, [this](bool on) { applyTheme(on); });
}

void MainWindow::buildPlayActions() {
  const QString menu = tr("P&layback");
  actions_->add("play.toggle", menu, tr("&Play or pause"), tr("Play the moves"), "Space", "play",
                [this] { state_.setPlaying(!state_.playing()); });
  actions_->add("play.next", menu, tr("&Next move"), tr("One move forward"), ".", "forward",
                [this] { state_.setMove(state_.move() + 1); });
  actions_->add("play.previous", menu, tr("P&revious move"), tr("One move back"), ",", "back",
                [this] { state_.setMove(std::max(state_.move(), state_.begin() + 1) - 1); });
  actions_->add("play.first", menu, tr("To the &start"),
                tr("Before the first move of the layers shown"), "Shift+,", "first",
                [this] { state_.setMove(state_.begin()); });
  actions_->add("play.last", menu, tr("To the &end"), tr("After the last move of the layers shown"),
                "Shift+.", "last", [this] { state_.setMove(state_.end()); });
  actions_->add("play.faster", menu, tr("&Faster"), tr("Play faster"), "]", {}, [this] {
    static constexpr std::array<double, 7> kSpeeds = {1, 2, 5, 10, 20, 50, 100};
    const auto* next = std::upper_bound(kSpeeds.begin(), kSpeeds.end(), state_.speed());
    state_.setSpeed(next != kSpeeds.end() ? *next : kSpeeds.back());
  });
  actions_->add("play.slower", menu, tr("Slo&wer"), tr("Play slower"), "[", {}, [this] {
    static constexpr std::array<double, 7> kSpeeds = {1, 2, 5, 10, 20, 50, 100};
    const auto* next = std::lower_bound(kSpeeds.begin(), kSpeeds.end(), state_.speed());
    state_.setSpeed(next != kSpeeds.begin() ? *(next - 1) : kSpeeds.front());
  });
  actions_->separate(menu);
  actions_->add("play.layer_up", menu, tr("Layer &up"), tr("Show one layer more"), "W", {},
                [this] { state_.setLayers(state_.lower(), state_.upper() + 1); });
  actions_->add("play.layer_down", menu, tr("Layer &down"), tr("Show one layer less"), "Q", {},
                [this] {
                  const int upper = std::max(state_.upper() - 1, 0);
                  state_.setLayers(std::min(state_.lower(), upper), upper);
                });
  actions_->add("play.all_layers", menu, tr("&All layers"), tr("Show all layers"), "A", {}, [this] {
    actions_->action("play.single")->setChecked(false);
    state_.setLayers(0, state_.layerCount() - 1);
  });
  addToggle("play.single", menu, tr("Si&ngle layer"), tr("Show one layer alone"), "X", {}, false,
            [this](bool on) { state_.setSingle(on); });
}

void MainWindow::buildHelpActions() {
  const QString menu = tr("&Help");
  actions_->add(
      "help.keys", menu, tr("&Keyboard shortcuts"), tr("All shortcuts"), "F1", {}, [this] {
        QString text = "<table>";
        for (const ActionCatalog::Entry& entry : actions_->entries()) {
          if (!entry.id.isEmpty() && !entry.action->shortcut().isEmpty()) {
            text +=
                QString("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                    .arg(
                        entry.action->shortcut().toString(QKeySequence::NativeText).toHtmlEscaped(),
                        QString(entry.action->text()).remove('&').toHtmlEscaped());
          }
        }
        auto* box = new QMessageBox(this);
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->setWindowTitle(tr("Keyboard shortcuts"));
        box->setText(text + "</table>");
        box->open();
      });
  actions_->add("help.about", menu, tr("&About WCAM"), tr("Version and licence"), {}, {}, [this] {
    auto* box = new QMessageBox(this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(tr("About WCAM"));
    box->setIconPixmap(windowIcon().pixmap(64, 64));
    box->setText(tr("<h3>WCAM %1</h3><p>CAM for robotic wire-arc additive manufacturing.</p>"
                    "<p>Licence: GPL-3.0-or-later</p>")
                     .arg(QApplication::applicationVersion()));
    box->open();
  });
}

void MainWindow::buildToolBar() {
  auto* bar = addToolBar(tr("Tools"));
  bar->setObjectName("toolBar");
  bar->setMovable(false);
  bar->setIconSize({22, 22});
  for (const char* id : {"file.new",
                         "file.open",
                         "file.save",
                         "",
                         "edit.undo",
                         "edit.redo",
                         "",
                         "file.import",
                         "project.add_operation",
                         "file.export",
                         "",
                         "view.fit",
                         "view.iso",
                         "view.front",
                         "view.right",
                         "view.top",
                         "",
                         "view.cell",
                         "view.section",
                         "view.measure",
                         "file.screenshot"}) {
    if (*id == 0) {
      bar->addSeparator();
    } else {
      bar->addAction(actions_->action(id));
    }
  }
}

void MainWindow::fillRecent() {
  recent_->clear();
  const QStringList files = QSettings().value("recent").toStringList();
  for (const QString& file : files) {
    QAction* action =
        recent_->addAction(QFileInfo(file).fileName() + " — " + QFileInfo(file).path());
    action->setEnabled(QFileInfo::exists(file));
    connect(action, &QAction::triggered, this, [this, file] { openFile(utf8(file)); });
  }
  if (files.isEmpty()) {
    recent_->addAction(tr("none"))->setEnabled(false);
  }
}

void MainWindow::updateActions() {
  const project::History& history = session_->history();
  const auto set = [this](const char* id, bool enabled) {
    actions_->action(id)->setEnabled(enabled);
  };
  const bool editable = !session_->document().readOnly();
  QAction* undo = actions_->action("edit.undo");
  QAction* redo = actions_->action("edit.redo");
  undo->setEnabled(history.canUndo());
  redo->setEnabled(history.canRedo());
  undo->setText(history.canUndo() ? tr("&Undo: %1").arg(engineText(history.undoLabel()))
                                  : tr("&Undo"));
  redo->setText(history.canRedo() ? tr("&Redo: %1").arg(engineText(history.redoLabel()))
                                  : tr("&Redo"));
  const NodeRef node = tree_->selected();
  const bool isNode = !node.id.empty();
  for (const char* id : {"edit.duplicate", "edit.rename", "edit.remove", "edit.up", "edit.down"}) {
    set(id, isNode && editable);
  }
  set("edit.copy", isNode);
  set("project.add_edit", editable && !session_->document().project().operations.empty());
  set("project.drop", editable && !session_->document().project().parts.empty());
  for (const char* id :
       {"edit.paste", "file.import", "project.add_operation", "project.add_substrate",
        "project.add_guide", "project.add_process", "project.add_output", "project.choose_cell"}) {
    set(id, editable);
  }
  for (int i = 0; i < kQuantityCount; ++i) {
    if (auto* action = colours_->findChild<QAction*>(QString("colour.%1").arg(i))) {
      action->setChecked(static_cast<int>(state_.colour()) == i);
    }
  }
}

}  // namespace wcam::gui
