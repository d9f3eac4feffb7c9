// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/text.hpp"
#include "wcam/project/html_report.hpp"

#include "cell_dialog.hpp"
#include "dialogs.hpp"
#include "edit_dialog.hpp"
#include "main_window.hpp"
#include "node_form.hpp"
#include "pdf_report.hpp"
#include "placing.hpp"
#include "widgets/text.hpp"

#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>

#include <algorithm>

namespace wcam::gui {

namespace {

constexpr int kMaxRecent = 10;
constexpr const char* kNodeFormat = "application/x-wcam-node+json";

QString projectFilter() {
  return MainWindow::tr("WCAM projects (*.wcam)");
}

QString partFilter() {
  QStringList patterns;
  for (const std::string& extension : io::importExtensions()) {
    patterns.append("*" + qt(extension));
    patterns.append("*" + qt(extension).toUpper());
  }
  return MainWindow::tr("CAD and mesh files (%1)").arg(patterns.join(" "));
}

bool isPartFile(const QString& file) {
  const std::string extension = utf8("." + QFileInfo(file).suffix().toLower());
  const auto& known = io::importExtensions();
  return std::find(known.begin(), known.end(), extension) != known.end();
}

/// The list in which a node stands; null when there is none.
const Value* listOf(const project::Document& document, const NodeRef& node) {
  const bool isEdit = node.list == "edits";
  const Value* list = document.tree().find(isEdit ? "operations" : node.list);
  if (list == nullptr || !list->isArray()) {
    return nullptr;
  }
  if (!isEdit) {
    return list;
  }
  for (const Value& operation : list->asArray()) {
    if (operation.at("id").asString() == operationOf(node)) {
      return operation.find("edits");
    }
  }
  return nullptr;
}

/// The id of a node in its list.
std::string ownId(const NodeRef& node) {
  return node.list == "edits" ? editIdOf(node) : node.id;
}

/// Position of a node in its list; the size of the list when it is not there.
std::size_t placeOf(const Value& list, const NodeRef& node) {
  std::size_t at = 0;
  while (at < list.size() && list.asArray()[at].at("id").asString() != ownId(node)) {
    ++at;
  }
  return at;
}

const Value* nodeOf(const project::Document& document, const NodeRef& node) {
  const Value* list = listOf(document, node);
  const std::size_t at = list != nullptr ? placeOf(*list, node) : 0;
  return list != nullptr && at < list->size() ? &list->asArray()[at] : nullptr;
}

/// A command about a node.
project::Command nodeCommand(const NodeRef& node, const std::string& verb, Value args) {
  args.set("id", ownId(node));
  if (node.list == "edits") {
    args.set("operation", operationOf(node));
  }
  return {nounOf(node.list) + "." + verb, args};
}

/// The same kind of node beside it, with another id.
NodeRef siblingOf(const NodeRef& node, const std::string& id) {
  return node.list == "edits" ? editRef(operationOf(node), id) : NodeRef{node.list, id};
}

std::string freeIdBeside(const project::Document& document,
                         const NodeRef& node,
                         const std::string& wanted) {
  return node.list == "edits" ? freeEditId(document, operationOf(node), wanted)
                              : freeId(document, node.list, wanted);
}

}  // namespace

bool MainWindow::run(const project::Command& command, const std::string& mergeKey) {
  if (const auto error = session_->apply(command, mergeKey)) {
    notify(Status::Error, errorText(*error));
    return false;
  }
  return true;
}

bool MainWindow::runAll(const QString& label, const std::vector<project::Command>& commands) {
  if (const auto error = session_->applyAll(utf8(label), commands)) {
    notify(Status::Error, errorText(*error));
    return false;
  }
  return true;
}

// --- files

bool MainWindow::mayDiscard() {
  if (!session_->modified()) {
    return true;
  }
  QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"),
                  tr("The project has changes that are not saved:"), QMessageBox::NoButton, this);
  box.setObjectName("unsavedBox");
  QStringList steps;
  const std::vector<Text> labels = session_->history().labels();
  const std::size_t done = session_->history().position();
  constexpr std::size_t kShown = 6;
  for (std::size_t i = done > kShown ? done - kShown : 0; i < done && i < labels.size(); ++i) {
    steps.append(engineText(labels[i]));
  }
  box.setInformativeText(steps.join("\n"));
  box.addButton(QMessageBox::Save);
  box.addButton(QMessageBox::Discard);
  box.addButton(QMessageBox::Cancel);
  switch (box.exec()) {
    case QMessageBox::Save:
      return save();
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

void MainWindow::newProject() {
  if (!mayDiscard()) {
    return;
  }
  NewDialog dialog(this);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  try {
    session_->create(dialog.document(session_->plugins()));
    state_.setColour(Quantity::Layer);
    hideNotice();
  } catch (const Error& error) {
    notify(Status::Error, errorText(error));
  }
}

void MainWindow::openDialog() {
  const QString folder =
      session_->file().empty() ? QDir::homePath() : qt(pathText(session_->file().parent_path()));
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open project"), folder, projectFilter());
  if (!file.isEmpty()) {
    openFile(utf8(file));
  }
}

void MainWindow::offerReload() {
  auto* box = new QMessageBox(
      QMessageBox::Question, tr("The project file has changed"),
      (session_->modified()
           ? tr("Another program has changed %1. Read the file again and lose what you have not "
                "saved, or keep what is open here and replace the file when saving?")
           : tr("Another program has changed %1. Read the file again, or keep what is open here "
                "and replace the file when saving?"))
          .arg(qt(session_->file().filename().string())),
      QMessageBox::NoButton, this);
  box->setObjectName("reloadBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* reload = box->addButton(tr("Read again"), QMessageBox::AcceptRole);
  QPushButton* keep = box->addButton(tr("Keep what is open"), QMessageBox::RejectRole);
  connect(box, &QMessageBox::buttonClicked, this, [this, reload, keep](QAbstractButton* button) {
    try {
      if (button == reload) {
        session_->open(session_->file());
      } else if (button == keep) {
        session_->keepOwn();
      }
    } catch (const Error& error) {
      notify(Status::Error, errorText(error));
    }
  });
  box->open();
}

bool MainWindow::offerRecovery(const std::filesystem::path& file) {
  // What another program is working on is not lost.
  if (!project::recoverable(std::filesystem::absolute(file)) ||
      !session_->holderOf(file).isEmpty()) {
    return false;
  }
  QMessageBox box(QMessageBox::Question, tr("Recover the project"),
                  tr("%1 was not closed properly. Changes that were not saved can be recovered.")
                      .arg(qt(file.filename().string())),
                  QMessageBox::NoButton, this);
  box.setObjectName("recoverBox");
  QPushButton* recover = box.addButton(tr("Recover"), QMessageBox::AcceptRole);
  box.addButton(tr("Open as saved"), QMessageBox::RejectRole);
  box.exec();
  return box.clickedButton() == static_cast<QAbstractButton*>(recover);
}

void MainWindow::offerUntitledWork() {
  const std::optional<project::Document> work = Session::untitledWork();
  if (!work) {
    return;
  }
  QMessageBox box(
      QMessageBox::Question, tr("Recover the project"),
      tr("The program was not closed properly. The project that was never saved can be recovered."),
      QMessageBox::NoButton, this);
  box.setObjectName("recoverBox");
  QPushButton* recover = box.addButton(tr("Recover"), QMessageBox::AcceptRole);
  box.addButton(QMessageBox::Discard);
  box.exec();
  if (box.clickedButton() == static_cast<QAbstractButton*>(recover)) {
    session_->recover(*work);
    setWindowModified(session_->modified());
  } else {
    session_->forgetUntitled();
  }
}

bool MainWindow::openFile(const std::filesystem::path& file) {
  if (isPartFile(qt(pathText(file)))) {
    importFiles({qt(pathText(file))});
    return true;
  }
  if (!mayDiscard()) {
    return false;
  }
  try {
    const bool recovered = offerRecovery(file);
    const std::vector<Diagnostic> findings = session_->open(file, recovered);
    remember(session_->file());
    hideNotice();
    tree_->select({"operations", shownOperation()});
    for (const Diagnostic& finding : findings) {
      if (finding.severity != Severity::Information) {
        notify(Status::Warning, lineText(finding));
      }
    }
    if (!session_->lockedBy().isEmpty()) {
      std::error_code ignored;
      const std::filesystem::path saved = project::autosavePath(session_->file());
      notify(
          Status::Warning,
          (std::filesystem::exists(saved, ignored)
               ? tr("Another program has this project open (%1), with changes that are not saved "
                    "(%2). It can be changed here, but only saved under another name.")
                     .arg(session_->lockedBy(), qt(pathText(saved.filename())))
               : tr("Another program has this project open (%1). It can be changed "
                    "here, but only saved under "
                    "another name.")
                     .arg(session_->lockedBy())));
    } else if (recovered) {
      notify(Status::Information,
             tr("The changes that were not saved are back. Save the project to keep them."));
    }
    return true;
  } catch (const Error& error) {
    notify(Status::Error, errorText(error));
    return false;
  }
}

void MainWindow::remember(const std::filesystem::path& file) {
  QSettings settings;
  QStringList files = settings.value("recent").toStringList();
  const QString name = qt(pathText(file));
  files.removeAll(name);
  files.prepend(name);
  settings.setValue("recent", files.mid(0, kMaxRecent));
}

bool MainWindow::save() {
  if (session_->file().empty() || !session_->lockedBy().isEmpty()) {
    return saveAsDialog();
  }
  try {
    session_->save();
    showTitle();
    return true;
  } catch (const Error& error) {
    notify(Status::Error, errorText(error));
    return false;
  }
}

bool MainWindow::saveAsDialog() {
  QString name = qt(pathText(session_->base()));
  name = QFileDialog::getSaveFileName(this, tr("Save project"), name, projectFilter());
  if (name.isEmpty()) {
    return false;
  }
  if (QFileInfo(name).suffix().isEmpty()) {
    name += ".wcam";
  }
  return saveTo(utf8(name));
}

bool MainWindow::saveTo(const std::filesystem::path& file) {
  try {
    session_->saveAs(file);
    remember(session_->file());
    showTitle();
    return true;
  } catch (const Error& error) {
    notify(Status::Error, errorText(error));
    return false;
  }
}

// --- parts

void MainWindow::importDialog() {
  const QStringList files =
      QFileDialog::getOpenFileNames(this, tr("Import part"), QDir::homePath(), partFilter());
  importFiles(files);
}

void MainWindow::importFiles(const QStringList& files) {
  for (const QString& file : files) {
    if (session_->document().readOnly()) {
      notify(Status::Error,
             tr("The project was written by a newer version and cannot be changed."));
      return;
    }
    ImportDialog dialog(*session_, pathFromText(utf8(file)), this);
    if (dialog.exec() == QDialog::Accepted &&
        runAll(tr("Import %1").arg(QFileInfo(file).fileName()), dialog.commands())) {
      tree_->select({"parts", dialog.id()});
      setPartStyle(viewport::PartStyle::Solid);
      actions_->action("view.part_solid")->setChecked(true);
    }
  }
}

void MainWindow::locateFile(const std::string& list, const std::string& id) {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Where is the file of %1?").arg(qt(id)),
                                   qt(pathText(session_->base().parent_path())), partFilter());
  if (file.isEmpty()) {
    return;
  }
  std::filesystem::path path = pathFromText(utf8(file));
  const std::filesystem::path relative = path.lexically_relative(session_->base().parent_path());
  if (!relative.empty() && *relative.begin() != "..") {
    path = relative;
  }
  run({nounOf(list) + ".set",
       Value::object(
           {{"id", id},
            {"file", Value::object({{"path", path.generic_string()}, {"sha256", ""}})}})});
}

void MainWindow::chooseCell() {
  const std::filesystem::path folder = session_->base().parent_path();
  CellDialog dialog(session_->document().project().cell.path, folder, this);
  if (dialog.exec() != QDialog::Accepted || dialog.path().empty()) {
    return;
  }
  std::string chosen = dialog.path();
  const std::filesystem::path path = pathFromText(chosen);
  if (path.is_absolute()) {
    const std::filesystem::path relative = path.lexically_relative(folder);
    if (!relative.empty() && *relative.begin() != "..") {
      chosen = relative.generic_string();
    }
  }
  run({"cell.set", Value::object({{"file", Value::object({{"path", chosen}, {"sha256", ""}})}})});
}

void MainWindow::dropPart() {
  const project::Project& project = session_->document().project();
  NodeRef node = tree_->selected();
  if (node.list != "parts" || node.id.empty()) {
    node = {"parts", project.parts.empty() ? std::string() : project.parts.front().id};
  }
  const project::Part* part = project.part(node.id);
  const GeneratedPart* shown = session_->generated().part(node.id);
  const int face = chosenFace_;
  chosenFace_ = -1;
  if (part == nullptr || shown == nullptr || !shown->part) {
    notify(Status::Warning, tr("The part must be read before it can be placed."));
    return;
  }
  const project::Substrate* substrate =
      project.substrates.empty() ? nullptr : &project.substrates.front();
  const geometry::Pose T_part_plate =
      substrate != nullptr ? project::toPose(substrate->placement) : geometry::Pose::Identity();
  const project::Placement placement =
      placedOn(*shown->part->surface, project::toPose(part->placement), T_part_plate, face);
  Value value = Value::object();
  const auto vector = [](const std::array<double, 3>& v) {
    return Value(Value::Array{Value(v[0]), Value(v[1]), Value(v[2])});
  };
  value.set("position_mm", vector(placement.positionMm));
  if (placement.rotationDeg != std::array<double, 3>{}) {
    value.set("rotation_deg", vector(placement.rotationDeg));
  }
  run({"part.set", Value::object({{"id", node.id}, {"placement", value}})});
}

// --- nodes

void MainWindow::addOperation() {
  OperationDialog dialog(*session_, this);
  if (dialog.exec() == QDialog::Accepted &&
      runAll(tr("Add operation %1").arg(qt(dialog.id())), dialog.commands())) {
    tree_->select({"operations", dialog.id()});
  }
}

void MainWindow::addNode(const std::string& list) {
  const project::Document& document = session_->document();
  Value args = Value::object();
  if (list == "substrates") {
    args =
        Value::object({{"id", freeId(document, list, "plate")},
                       {"type", "plate"},
                       {"size_mm", Value(Value::Array{Value(300.0), Value(300.0), Value(10.0)})}});
  } else if (list == "guides") {
    args = Value::object({{"id", freeId(document, list, "guide")},
                          {"type", "formula"},
                          {"x", "0"},
                          {"y", "0"},
                          {"z", "100*t"}});
  } else if (list == "processes") {
    args = Value::object({{"id", freeId(document, list, "wire")}, {"params", Value::object()}});
  } else if (list == "outputs") {
    args = Value::object({{"id", freeId(document, list, "output")}, {"post", "wcam.post.fanuc"}});
  }
  if (run({nounOf(list) + ".add", args})) {
    tree_->select({list, args.at("id").asString()});
  }
}

void MainWindow::removeNode() {
  const NodeRef node = tree_->selected();
  if (!node.id.empty()) {
    run(nodeCommand(node, "remove", Value::object()));
  }
}

void MainWindow::renameNode() {
  const NodeRef node = tree_->selected();
  if (node.id.empty()) {
    return;
  }
  bool ok = false;
  const QString old = qt(ownId(node));
  const QString to = QInputDialog::getText(this, tr("Rename"), tr("New id of %1").arg(old),
                                           QLineEdit::Normal, old, &ok);
  const std::string id = utf8(to.trimmed());
  if (ok && run(nodeCommand(node, "rename", Value::object({{"to", id}})))) {
    tree_->select(siblingOf(node, id));
  }
}

void MainWindow::copyNode() {
  const NodeRef node = tree_->selected();
  const Value* value = nodeOf(session_->document(), node);
  if (value == nullptr) {
    return;
  }
  const QByteArray text = QByteArray::fromStdString(
      toCanonicalJson(Value::object({{"list", node.list}, {"node", *value}})));
  auto* mime = new QMimeData;
  mime->setData(kNodeFormat, text);
  mime->setText(QString::fromUtf8(text));
  QApplication::clipboard()->setMimeData(mime);
}

void MainWindow::pasteNode() {
  const QMimeData* mime = QApplication::clipboard()->mimeData();
  const QByteArray text =
      mime->hasFormat(kNodeFormat) ? mime->data(kNodeFormat) : mime->text().toUtf8();
  try {
    const Value copied = parseJson(text.toStdString(), "clipboard");
    NodeRef node{copied.at("list").asString(), copied.at("node").at("id").asString()};
    if (node.list == "edits") {
      // An edit goes to the operation that is shown.
      node = editRef(shownOperation(), node.id);
    }
    addCopy(node, copied.at("node"));
  } catch (const Error&) {
    notify(Status::Warning, tr("The clipboard holds no node of a project."));
  }
}

void MainWindow::duplicateNode() {
  const NodeRef node = tree_->selected();
  if (const Value* value = nodeOf(session_->document(), node)) {
    addCopy(node, *value);
  }
}

void MainWindow::addCopy(const NodeRef& node, Value value) {
  const NodeRef copy =
      siblingOf(node, freeIdBeside(session_->document(), node, value.at("id").asString()));
  if (run(nodeCommand(copy, "add", std::move(value)))) {
    tree_->select(copy);
  }
}

void MainWindow::moveNode(int by) {
  const NodeRef node = tree_->selected();
  const Value* list = listOf(session_->document(), node);
  if (list == nullptr || node.id.empty()) {
    return;
  }
  const auto to = static_cast<std::int64_t>(placeOf(*list, node)) + by;
  if (to >= 0 && to < static_cast<std::int64_t>(list->size())) {
    run(nodeCommand(node, "move", Value::object({{"index", to}})));
  }
}

void MainWindow::showExport() {
  ExportDialog dialog(*session_, this);
  dialog.exec();
}

void MainWindow::saveReport() {
  const std::filesystem::path base = session_->base();
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save report"), qt(pathText(base.parent_path() / (base.stem().string() + ".html"))),
      tr("Web pages (*.html);;PDF documents (*.pdf)"));
  if (!file.isEmpty()) {
    writeReport(pathFromText(utf8(file)));
  }
}

void MainWindow::writeReport(const std::filesystem::path& file) {
  // What is seen now goes to the end of the page.
  std::string picture;
  if (view_ != nullptr) {
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    view_->picture().save(&buffer, "PNG");
    picture = "<img alt=\"\" style=\"max-width:100%\" src=\"data:image/png;base64," +
              png.toBase64().toStdString() + "\">";
  }
  session_->tasks().start(
      {utf8(tr("Report")),
       [file, picture, pipeline = session_->pipeline()](const JobContext& context) {
         project::RunRequest request;
         request.folder = file.parent_path();
         request.checkOnly = true;
         request.plan.write(file, "the report");
         const project::RunResult result = project::runProject(pipeline, request, context);
         std::string html = project::htmlReport(pipeline.document(), result);
         html.insert(std::min(html.rfind("</body>"), html.size()), picture);
         if (file.extension() == ".pdf") {
           const QByteArray pdf = pdfReport(html);
           writeFileAtomically(
               file, std::string_view(pdf.constData(), static_cast<std::size_t>(pdf.size())));
         } else {
           writeFileAtomically(file, html);
         }
       },
       [this, file](const std::optional<Error>& error) {
         if (!error) {
           notify(Status::Ok, tr("The report is written to %1").arg(qt(pathText(file))));
         } else if (error->code() != ErrorCode::Cancelled) {
           notify(Status::Error, errorText(*error));
         }
       }});
}

}  // namespace wcam::gui
