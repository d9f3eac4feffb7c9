// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"

#include "main_window.hpp"
#include "model/program_text.hpp"
#include "node_form.hpp"
#include "widgets/legend.hpp"
#include "widgets/program_view.hpp"
#include "widgets/text.hpp"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QProgressBar>
#include <QRegularExpression>
#include <QSlider>
#include <QTabWidget>
#include <QToolButton>
#include <QToolTip>

#include <algorithm>
#include <cmath>

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

const GeneratedPart* MainWindow::pickedPart(const viewport::Pick& pick) const {
  // The view counts the parts that could be read.
  int index = 0;
  for (const GeneratedPart& part : session_->generated().parts) {
    if (part.mesh && index++ == pick.part) {
      return &part;
    }
  }
  return nullptr;
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

std::map<NodeRef, Badge> MainWindow::badges() const {
  std::map<NodeRef, Badge> badges;
  const Generated& results = session_->generated();
  const project::Project& project = session_->document().project();
  const bool stale = session_->stale();
  const bool running = session_->generation().busy();
  const Badge waiting = running ? Badge{Status::Running, tr("being computed")}
                                : Badge{Status::Stale, tr("out of date: F5 computes it")};
  for (const project::Part& part : project.parts) {
    const GeneratedPart* shown = results.part(part.id);
    Badge& badge = badges[{"parts", part.id}];
    if (shown == nullptr) {
      badge = waiting;
    } else if (shown->error) {
      badge = {Status::Error, errorText(*shown->error)};
    } else {
      badge = {Status::Ok, tr("%1, %L2 triangles")
                               .arg(qt(shown->part->report.format))
                               .arg(shown->part->report.triangles)};
    }
  }
  for (const project::Operation& operation : project.operations) {
    const GeneratedOperation* shown = results.operation(operation.id);
    Badge& badge = badges[{"operations", operation.id}];
    if (!operation.enabled) {
      badge = {};
    } else if (stale || shown == nullptr) {
      badge = waiting;
    } else if (shown->error) {
      badge = {Status::Error, errorText(*shown->error)};
    } else {
      std::size_t counts[3] = {0, 0, 0};
      for (const Diagnostic& d : shown->path->result().findings) {
        ++counts[static_cast<int>(d.severity)];
      }
      badge.status = counts[2] > 0 ? Status::Error : counts[1] > 0 ? Status::Warning : Status::Ok;
      badge.tip = tr("%n layer(s)", nullptr, shown->path->layerCount()) + "\n" +
                  tr("%1 violations, %2 warnings").arg(counts[2]).arg(counts[1]);
    }
  }
  // Edits that find nothing, or only a part, say so; those with no finding need no badge.
  for (const GeneratedOperation& operation : results.operations) {
    if (stale || !operation.path) {
      continue;
    }
    for (const Diagnostic& finding : operation.path->result().findings) {
      const QString quoted = qt(finding.message.str()).section('\'', 1, 1);
      if (finding.code.starts_with("edit.") && !quoted.isEmpty()) {
        Badge& badge = badges[editRef(operation.id, utf8(quoted))];
        const Status status =
            finding.severity == Severity::Information ? Status::Information : Status::Warning;
        badge.status = badge.status == Status::Warning ? Status::Warning : status;
        badge.tip += (badge.tip.isEmpty() ? "" : "\n") + engineText(finding.message);
      }
    }
  }
  if (!project.cell.empty()) {
    badges[{"cell", {}}] =
        results.cell ? Badge{Status::Ok, qt(results.cell->description)} : Badge{};
  }
  // Problems of the project name the place: "operations[0].params.step: ...".
  if (results.error) {
    static const QRegularExpression kPlace("(\\w+)\\[(\\d+)\\]([^:]*): (.*)");
    // The places are read from the English lines; the shown ones have the same order.
    const QStringList lines = qt(results.error->message()).split('\n');
    const QStringList shown = engineText(results.error->messageText()).split('\n');
    for (qsizetype i = 0; i < lines.size(); ++i) {
      const QString tip = (shown.size() == lines.size() ? shown : lines)[i].trimmed();
      const QRegularExpressionMatch match = kPlace.match(lines[i]);
      const Value* list =
          match.hasMatch() ? session_->document().tree().find(utf8(match.captured(1))) : nullptr;
      const auto index = static_cast<std::size_t>(match.captured(2).toInt());
      if (list != nullptr && list->isArray() && index < list->size()) {
        const std::string id = list->asArray()[index].at("id").asString();
        badges[{utf8(match.captured(1)), id}] = {Status::Error, tip};
        static const QRegularExpression kEdit("^\\.edits\\[(\\d+)\\]");
        const QRegularExpressionMatch edit = kEdit.match(match.captured(3));
        const project::Operation* operation = project.operation(id);
        const auto at = static_cast<std::size_t>(edit.captured(1).toInt());
        if (edit.hasMatch() && operation != nullptr && at < operation->edits.size()) {
          badges[editRef(id, operation->edits[at].id)] = {Status::Error, tip};
        }
      }
    }
  }
  return badges;
}

std::vector<FindingRow> MainWindow::findingRows() const {
  std::vector<FindingRow> rows;
  const Generated& results = session_->generated();
  const auto addError = [&rows](const Error& error, const NodeRef& node, const QString& place) {
    FindingRow row;
    row.status = Status::Error;
    row.code = qt(toString(error.code()));
    row.message = engineText(error.whatText());
    row.remedy = engineText(error.hintText());
    row.node = node;
    row.place = place;
    // The same cause of several operations is told once.
    for (const FindingRow& other : rows) {
      if (other.message == row.message) {
        return;
      }
    }
    rows.push_back(std::move(row));
  };
  if (results.error) {
    addError(*results.error, {}, tr("project"));
  }
  for (const GeneratedPart& part : results.parts) {
    if (part.error) {
      addError(*part.error, {"parts", part.id}, qt(part.id));
    }
  }
  for (const GeneratedOperation& operation : results.operations) {
    if (operation.error) {
      addError(*operation.error, {"operations", operation.id}, qt(operation.id));
    }
  }
  for (const Diagnostic& finding : results.findings) {
    rows.push_back(rowOf(finding));
  }
  for (const GeneratedOperation& operation : results.operations) {
    if (operation.path) {
      for (const Diagnostic& finding : operation.path->result().findings) {
        rows.push_back(rowOf(finding));
      }
    }
  }
  return rows;
}

void MainWindow::showResults() {
  scene_->setResults(session_->generated(), shownOperation());
  diagnostics_->setRows(findingRows());
  const int errors = diagnostics_->count(Status::Error);
  const int all = static_cast<int>(diagnostics_->rows().size());
  tabs_->setTabText(0, all > 0 ? tr("Findings (%1)").arg(all) : tr("Findings"));
  tabs_->setTabIcon(0, errors > 0 ? statusIcon(Status::Error) : QIcon());
  showState();
  programDelay_.start();
}

void MainWindow::showState() {
  const bool running = session_->generation().busy();
  const bool stale = session_->stale();
  progress_->setVisible(running);
  cancel_->setVisible(running);
  if (!running) {
    progress_->setValue(0);
  }
  if (!stale) {
    scene_->setStale(false);
  } else if (!staleDelay_.isActive()) {
    staleDelay_.start();
  }
  staleNote_->setText(tr("Out of date — F5 computes it"));
  staleNote_->setVisible(stale && !running && state_.path() != nullptr);
  placeOverlay();
  tree_->setBadges(badges());
  const auto path = state_.path();
  if (measuring_) {
    return;
  }
  if (running) {
    status_->setText(tr("Computing …"));
  } else if (path && path->size() > 0) {
    status_->setText(tr("%1: %2 layers, %L3 points, %4")
                         .arg(qt(path->result().id))
                         .arg(path->layerCount())
                         .arg(path->result().path->pointCount())
                         .arg(QString("%1 min").arg(path->totalTime() / 60.0, 0, 'f', 1)));
  } else {
    status_->setText(session_->document().project().parts.empty()
                         ? tr("Drop a CAD file here, or choose File › Import part")
                         : QString());
  }
}

void MainWindow::showProgram() {
  if (!program_->isVisible()) {
    return;
  }
  const auto path = state_.path();
  const project::Output* output = session_->document().project().output(utf8(program_->output()));
  if (!path || output == nullptr || path->result().program == nullptr) {
    program_->setMessage(output == nullptr ? tr("The project has no output.")
                                           : tr("There is no program yet."));
    return;
  }
  auto text = std::make_shared<ProgramText>();
  session_->tasks().start(
      {utf8(tr("Program text")),
       [text, path, out = *output, pipeline = session_->pipeline()](const JobContext& context) {
         *text = linkProgram(pipeline.post(out, path->result(), context), *path);
       },
       [this, text](const std::optional<Error>& error) {
         if (!error) {
           program_->setProgram(text);
         } else if (error->code() != ErrorCode::Cancelled) {
           program_->setMessage(errorText(*error));
         }
       }});
}

void MainWindow::showPick(const viewport::Pick& pick) {
  if (measuring_) {
    measure(pick);
    return;
  }
  if (view_ == nullptr) {
    return;
  }
  viewport::Scene& scene = view_->scene();
  scene.setMarkedFaces({});
  scene.setMarkedEdges({});
  if (pick.kind == viewport::Pick::Kind::Move) {
    state_.jumpTo(static_cast<std::size_t>(pick.index));
  } else {
    state_.select(std::nullopt);
    if (pick.kind == viewport::Pick::Kind::Face && pick.index >= 0) {
      scene.setMarkedFaces({{pick.part, pick.index}});
    } else if (pick.kind == viewport::Pick::Kind::Edge) {
      scene.setMarkedEdges({{pick.part, pick.index}});
    }
  }
  view_->redraw();
}

void MainWindow::measure(const viewport::Pick& pick) {
  if (pick.kind == viewport::Pick::Kind::None || view_ == nullptr) {
    return;
  }
  if (!measureFrom_) {
    measureFrom_ = pick.position;
    view_->scene().setMeasure(std::nullopt, {});
    status_->setText(tr("Pick the second place"));
  } else {
    const viewport::Point a = *measureFrom_;
    const viewport::Point b = pick.position;
    const double d = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    const QString text = QString("%1 mm").arg(d, 0, 'f', 3);
    view_->scene().setMeasure(std::pair(a, b), utf8(text));
    status_->setText(tr("Distance %1 (Δx %2, Δy %3, Δz %4)")
                         .arg(text)
                         .arg(b[0] - a[0], 0, 'f', 3)
                         .arg(b[1] - a[1], 0, 'f', 3)
                         .arg(b[2] - a[2], 0, 'f', 3));
    measureFrom_.reset();
  }
  view_->redraw();
}

namespace {

QString moveTip(const PathModel& path, std::size_t move) {
  QString tip = MainWindow::tr("<b>Layer %1, bead %2, point %3</b>")
                    .arg(path.layer(move) + 1)
                    .arg(path.bead(move) + 1)
                    .arg(path.point(move) + 1);
  const auto row = [&tip](const QString& name, const QString& value) {
    tip += QString("<tr><td>%1&nbsp;</td><td align='right'>%2</td></tr>").arg(name, value);
  };
  tip += "<table>";
  const toolpath::PathPoint* point = path.pathPoint(move);
  if (point != nullptr) {
    row(MainWindow::tr("Position"), QString("%1, %2, %3 mm")
                                        .arg(point->p.x(), 0, 'f', 2)
                                        .arg(point->p.y(), 0, 'f', 2)
                                        .arg(point->p.z(), 0, 'f', 2));
    row(nameOf(Quantity::Height), QString("%1 mm").arg(point->height, 0, 'f', 3));
    row(nameOf(Quantity::Distance), QString("%1 mm").arg(point->distance, 0, 'f', 3));
    row(nameOf(Quantity::Width), QString("%1 mm").arg(point->width, 0, 'f', 2));
    row(nameOf(Quantity::TravelSpeed), QString("%1 mm/s").arg(point->speed, 0, 'f', 2));
    row(nameOf(Quantity::WireSpeed),
        QString("%1 m/min").arg(toFileUnit(QuantityKind::WireSpeed, point->wireSpeed), 0, 'f', 2));
  }
  if (const motion::Waypoint* waypoint = path.waypoint(move)) {
    row(nameOf(Quantity::TcpSpeed), QString("%1 mm/s").arg(waypoint->tcpSpeed, 0, 'f', 2));
    row(nameOf(Quantity::Time), QString("%1 s").arg(waypoint->time, 0, 'f', 1));
    const cell::Cell* cell = path.result().cell.get();
    QStringList joints;
    for (int j = 0; cell != nullptr && j < waypoint->joints.size(); ++j) {
      const bool slides = cell->joint(j).prismatic();
      joints.append(
          QString("%1 %2%3")
              .arg(qt(cell->joint(j).name))
              .arg(slides ? waypoint->joints[j] : radToDeg(waypoint->joints[j]), 0, 'f', 1)
              .arg(slides ? " mm" : "°"));
    }
    row(MainWindow::tr("Joints"), joints.join(" "));
  }
  return tip + "</table>";
}

}  // namespace

void MainWindow::showTip(const viewport::Pick& pick, const QPoint& global) {
  QString tip;
  if (pick.kind == viewport::Pick::Kind::Move && state_.path()) {
    tip = moveTip(*state_.path(), static_cast<std::size_t>(pick.index));
  } else if (const GeneratedPart* part = pickedPart(pick)) {
    const auto& brep = part->part->surface->brep;
    if (pick.kind == viewport::Pick::Kind::Face && brep && pick.index >= 0) {
      tip = tr("<b>Face %1</b><br/>%2").arg(pick.index).arg(qt(brep->face(pick.index).surfaceType));
    } else if (pick.kind == viewport::Pick::Kind::Edge && brep && pick.index >= 0) {
      const geometry::BrepEdgeInfo& edge = brep->edge(pick.index);
      tip = tr("<b>Edge %1</b> %2<br/>length %3 mm")
                .arg(pick.index)
                .arg(qt(edge.name))
                .arg(edge.length, 0, 'f', 2);
    }
  }
  if (tip.isEmpty()) {
    QToolTip::hideText();
  } else {
    QToolTip::showText(global + QPoint(12, 8), tip, view_);
  }
}

void MainWindow::jump(const FindingRow& row) {
  if (!row.node.empty()) {
    tree_->select(row.node);
  }
  if (row.jump.layer >= 0 && state_.path()) {
    if (const auto move = state_.path()->find(row.jump.layer, row.jump.bead, row.jump.point)) {
      state_.jumpTo(*move);
      if (view_ != nullptr) {
        view_->view().lookAt(state_.path()->position(*move));
        view_->redraw();
      }
    }
  }
  // A file that is missing can be found again.
  if (row.code == "input-not-found" && row.node.list == "parts") {
    locateFile("parts", row.node.id);
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

void MainWindow::pickMenu(const viewport::Pick& pick, const QPoint& global) {
  QMenu menu(this);
  const project::Project& project = session_->document().project();
  const GeneratedPart* picked = pickedPart(pick);
  const bool ofPart = picked != nullptr;
  const std::string part = ofPart ? picked->id : std::string();
  const std::string operation = shownOperation();
  if (ofPart && pick.kind == viewport::Pick::Kind::Edge && pick.index >= 0) {
    menu.addAction(
        tr("Use edge %1 as guide curve").arg(pick.index), this,
        [this, part, edge = pick.index, operation] {
          std::string id = "edge-" + std::to_string(edge);
          std::vector<project::Command> commands;
          if (session_->document().project().guide(id) == nullptr) {
            commands.push_back(
                {"guide.add",
                 Value::object({{"id", id}, {"type", "edge"}, {"part", part}, {"edge", edge}})});
          }
          if (!operation.empty()) {
            commands.push_back(
                {"operation.set", Value::object({{"id", operation}, {"guide", id}})});
          }
          runAll(tr("Guide curve from edge %1").arg(edge), commands);
        });
  }
  if (ofPart && pick.kind == viewport::Pick::Kind::Face && pick.index >= 0) {
    const auto faces =
        project.part(part) != nullptr ? project.part(part)->faces : std::vector<int>();
    const bool has = std::find(faces.begin(), faces.end(), pick.index) != faces.end();
    menu.addAction(
        has ? tr("Take face %1 from the working surface").arg(pick.index)
            : tr("Add face %1 to the working surface").arg(pick.index),
        this, [this, part, faces, has, face = pick.index] {
          Value list = Value::array();
          for (const int f : faces) {
            if (f != face) {
              list.push(f);
            }
          }
          if (!has) {
            list.push(face);
          }
          run({"part.set",
               Value::object({{"id", part}, {"faces", list.size() > 0 ? list : Value()}})});
        });
    menu.addAction(tr("Set part on face %1").arg(pick.index), this, [this, pick, part] {
      tree_->select({"parts", part});
      chosenFace_ = pick.index;
      dropPart();
    });
  }
  if (pick.kind == viewport::Pick::Kind::Move && state_.path()) {
    const auto move = static_cast<std::size_t>(pick.index);
    menu.addAction(tr("Show layer %1 alone").arg(state_.path()->layer(move) + 1), this,
                   [this, move] {
                     actions_->action("play.single")->setChecked(true);
                     state_.jumpTo(move);
                   });
    addPointEdits(menu, move);
    menu.addAction(tr("Seams towards this point"), this, [this, move, operation] {
      // The direction of aligned seams, seen from the middle of what is built.
      const auto box = view_->scene().bounds();
      const viewport::Point p = state_.path()->position(move);
      const double angle =
          radToDeg(std::atan2(p[1] - 0.5 * (box[2] + box[3]), p[0] - 0.5 * (box[0] + box[1])));
      const auto set = [&](const char* key, Value value) {
        return project::Command{
            "operation.set_param",
            Value::object(
                {{"id", operation}, {"section", "path"}, {"key", key}, {"value", value}})};
      };
      runAll(tr("Seams towards a point"),
             {set("seam", "aligned"), set("seam_direction", std::round(angle * 10) / 10)});
    });
  }
  menu.addSeparator();
  for (const char* id : {"view.fit", "view.cell", "view.section", "view.measure"}) {
    menu.addAction(actions_->action(id));
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
