// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/text.hpp"

#include "main_window.hpp"
#include "model/program_text.hpp"
#include "widgets/program_view.hpp"
#include "widgets/text.hpp"

#include <QLabel>
#include <QProgressBar>
#include <QRegularExpression>
#include <QTabWidget>
#include <QToolButton>

namespace wcam::gui {

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
    } else if (shown->path == nullptr) {
      badge = waiting;
    } else {
      std::size_t counts[3] = {0, 0, 0};
      for (const Diagnostic& d : shown->path->result().findings) {
        ++counts[static_cast<int>(d.severity)];
      }
      for (const Diagnostic& d : shown->outputFindings) {
        ++counts[static_cast<int>(d.severity)];
      }
      badge.status = counts[2] > 0 ? Status::Error : counts[1] > 0 ? Status::Warning : Status::Ok;
      badge.tip = tr("%n layer(s)", nullptr, shown->path->layerCount()) + "\n" +
                  tr("%1 violations, %2 warnings").arg(counts[2]).arg(counts[1]);
    }
  }
  // Edits that find nothing, or only a part, say so; those with no finding need no badge.
  for (const GeneratedOperation& operation : results.operations) {
    if (stale || !operation.path || operation.outdated) {
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
    badges[{"cell", {}}] = results.cellError ? Badge{Status::Error, errorText(*results.cellError)}
                           : results.cell    ? Badge{Status::Ok, qt(results.cell->description)}
                                             : Badge{};
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
  const auto addError = [&rows](const Error& error, const NodeRef& node, const QString& place,
                                const std::vector<project::Command>& remedy = {}) {
    FindingRow row;
    row.status = Status::Error;
    row.code = qt(toString(error.code()));
    row.message = engineText(error.whatText());
    row.remedy = engineText(error.hintText());
    row.node = node;
    row.place = place;
    row.apply = remedy;
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
  if (results.cellError) {
    addError(*results.cellError, {"cell", {}}, tr("cell"));
  }
  for (const GeneratedPart& part : results.parts) {
    if (part.error) {
      addError(*part.error, {"parts", part.id}, qt(part.id));
    }
  }
  for (const GeneratedOperation& operation : results.operations) {
    // What is wrong with the cell is told once.
    const bool ofCell = operation.error && results.cellError &&
                        operation.error->messageText() == results.cellError->messageText();
    if (operation.error && !ofCell) {
      addError(*operation.error, {"operations", operation.id}, qt(operation.id), operation.remedy);
    }
  }
  for (const Diagnostic& finding : results.findings) {
    // The first save brings the files to the project.
    if (!session_->file().empty() || finding.code != "project.path_absolute") {
      rows.push_back(rowOf(finding));
    }
  }
  for (const GeneratedOperation& operation : results.operations) {
    // Those of an old path are about layers that may be gone.
    if (operation.path && !operation.outdated) {
      const project::OperationResult& result = operation.path->result();
      for (std::size_t i = 0; i < result.findings.size(); ++i) {
        rows.push_back(rowOf(result.findings[i]));
        if (i < result.remedies.size()) {
          rows.back().apply = result.remedies[i];
        }
      }
      for (const Diagnostic& finding : operation.outputFindings) {
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
  const GeneratedOperation* shownResult = session_->generated().operation(shownOperation());
  const bool outdated = shownResult != nullptr && shownResult->outdated;
  if (!stale) {
    scene_->setStale(outdated);
  } else if (!staleDelay_.isActive()) {
    staleDelay_.start();
  }
  staleNote_->setText(stale ? tr("Out of date — F5 computes it")
                            : tr("The last path that could be computed — see Findings"));
  staleNote_->setVisible((stale || outdated) && !running && state_.path() != nullptr);
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
                         .arg(QString("%1 min").arg(figureText(path->totalTime() / 60.0, 1))));
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
  const GeneratedOperation* shown = session_->generated().operation(shownOperation());
  const bool outdated = shown != nullptr && shown->outdated;
  if (!path || output == nullptr || path->result().program == nullptr || outdated) {
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

void MainWindow::applyRemedy(const FindingRow& row) {
  if (runAll(tr("Remedy: %1").arg(row.remedy), row.apply)) {
    hideNotice();
  }
}

void MainWindow::jump(const FindingRow& row) {
  if (!row.node.empty()) {
    tree_->select(row.node);
  }
  if (row.jump.layer >= 0 && state_.path()) {
    if (const auto move = state_.path()->find(row.jump.layer, row.jump.bead, row.jump.point)) {
      state_.jumpTo(*move);
      scene_->lookAt(state_.path()->position(*move));
    }
  }
  // A file that is missing can be found again.
  if (row.code == "input-not-found" && row.node.list == "parts") {
    locateFile("parts", row.node.id);
  }
}

}  // namespace wcam::gui
