// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "dialogs.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/text.hpp"
#include "wcam/io/import.hpp"
#include "wcam/plugin/locations.hpp"
#include "wcam/project/new_outputs.hpp"
#include "wcam/project/project_file.hpp"

#include "node_form.hpp"
#include "strategy_pictures.hpp"
#include "widgets/icons.hpp"
#include "widgets/text.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <algorithm>

namespace wcam::gui {

namespace {

JobRunner::Post postTo(QObject* object) {
  return [object](std::function<void()> call) {
    QMetaObject::invokeMethod(QCoreApplication::instance(), std::move(call), Qt::QueuedConnection);
    static_cast<void>(object);
  };
}

}  // namespace

std::string idFrom(const QString& text) {
  std::string id;
  for (const QChar c : text.toLower().normalized(QString::NormalizationForm_KD)) {
    const char l = c.toLatin1();
    if ((l >= 'a' && l <= 'z') || (l >= '0' && l <= '9') ||
        (!id.empty() && (l == '_' || l == '-' || l == '.'))) {
      id += l;
    } else if (!id.empty() && c.isSpace()) {
      id += '-';
    }
  }
  constexpr std::size_t kLongest = 48;
  return id.empty() ? "node" : id.substr(0, kLongest);
}

std::string freeId(const project::Document& document,
                   const std::string& list,
                   const std::string& wanted) {
  std::vector<std::string> taken;
  if (const Value* nodes = document.tree().find(list)) {
    for (const Value& node : nodes->asArray()) {
      taken.push_back(node.at("id").asString());
    }
  }
  std::string id = wanted;
  for (int i = 2; std::find(taken.begin(), taken.end(), id) != taken.end(); ++i) {
    id = wanted + "-" + std::to_string(i);
  }
  return id;
}

// --- new

NewDialog::NewDialog(QWidget* parent) : QDialog(parent) {
  setObjectName("newDialog");
  setWindowTitle(tr("New project"));
  templates_ = new QListWidget(this);
  templates_->setObjectName("templates");
  auto* empty = new QListWidgetItem(icon("substrate"), tr("Empty project on a plate"), templates_);
  empty->setData(Qt::UserRole, QString());
  std::vector<std::filesystem::path> found;
  std::error_code ignored;
  for (const auto& entry :
       std::filesystem::directory_iterator(plugin::dataFolder() / "projects", ignored)) {
    const std::filesystem::path file = entry.path() / (entry.path().filename().string() + ".wcam");
    if (std::filesystem::exists(file, ignored)) {
      found.push_back(file);
    }
  }
  std::sort(found.begin(), found.end());
  for (const auto& file : found) {
    auto* item = new QListWidgetItem(icon("operation"),
                                     tr("Example: %1").arg(qt(file.stem().string())), templates_);
    item->setData(Qt::UserRole, qt(pathText(file)));
  }
  cell_ = new QComboBox(this);
  cell_->setObjectName("newCell");
  for (const ShippedCell& cell : shippedCells()) {
    cell_->addItem(qt(cell.name), qt(cell.path));
    cell_->setItemData(cell_->count() - 1, qt(cell.description), Qt::ToolTipRole);
  }
  // The cell that `camcli new` takes.
  cell_->setCurrentIndex(std::max(cell_->findData(qt(std::string(project::kShippedPrefix) +
                                                     "cells/" + project::kDefaultCell + ".json")),
                                  0));
  about_ = new QLabel(this);
  about_->setWordWrap(true);
  auto* form = new QFormLayout(this);
  form->addRow(templates_);
  form->addRow(about_);
  form->addRow(tr("Robot cell"), cell_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(templates_, &QListWidget::itemDoubleClicked, this, &QDialog::accept);
  connect(templates_, &QListWidget::currentRowChanged, this, [this](int row) {
    about_->setText(
        row <= 0 ? tr("A plate, process parameters for steel wire of 1.2 mm and one output. Import "
                      "a part next, then add an operation.")
                 : tr("A copy of the example. Saving it copies its part beside the project."));
    cell_->setEnabled(row <= 0);
  });
  templates_->setCurrentRow(0);
  resize(440, 380);
}

project::Document NewDialog::document(const plugin::PluginHost& plugins) const {
  const QString file = templates_->currentItem()->data(Qt::UserRole).toString();
  if (file.isEmpty()) {
    const std::string cell = utf8(cell_->currentData().toString());
    Value tree = Value::object({{"format", project::kFormatName},
                                {"format_version", project::kFormatVersion},
                                {"name", Session::kUntitled}});
    if (!cell.empty()) {
      tree.set("cell", Value::object({{"path", cell}, {"sha256", ""}}));
    }
    tree.set("parts", Value::array());
    const std::filesystem::path cellFile =
        cell.empty() ? std::filesystem::path() : project::resolvePath({}, {cell, ""});
    tree.set("substrates", Value(Value::Array{project::newPlate(cellFile)}));
    tree.set("processes",
             Value(Value::Array{Value::object({{"id", "wire"}, {"params", Value::object()}})}));
    tree.set("operations", Value::array());
    tree.set("outputs", project::newOutputs(plugins, cellFile));
    return project::Document::parse(tree);
  }
  // The files of the example are named in full until the project is saved.
  const std::filesystem::path path = pathFromText(utf8(file));
  Value tree = project::loadProject(path).document.tree();
  for (const char* list : {"parts", "guides", "processes", "operations"}) {
    const std::size_t count = tree.contains(list) ? tree.at(list).size() : 0;
    for (std::size_t i = 0; i < count; ++i) {
      Value& node = tree.findMutable(list)->mutableArray()[i];
      if (Value* ref = node.findMutable("file")) {
        const std::string own = ref->at("path").asString();
        if (own.rfind(project::kShippedPrefix, 0) != 0) {
          ref->set("path", pathText(std::filesystem::weakly_canonical(path.parent_path() / own)));
        }
      }
    }
  }
  return project::Document::parse(tree, pathText(path));
}

// --- import

ImportDialog::ImportDialog(Session& session, const std::filesystem::path& file, QWidget* parent)
    : QDialog(parent), session_(session), file_(file), runner_(postTo(this)) {
  setObjectName("importDialog");
  setWindowTitle(tr("Import %1").arg(qt(file.filename().string())));
  id_ = new QLineEdit(qt(freeId(session.document(), "parts", idFrom(qt(file.stem().string())))),
                      this);
  id_->setObjectName("importId");
  drop_ = new QCheckBox(tr("Stand it in the middle of the plate"), this);
  drop_->setObjectName("importDrop");
  form_ = new ParamForm(this);
  report_ = new QTextBrowser(this);
  report_->setObjectName("importReport");
  progress_ = new QProgressBar(this);
  progress_->setRange(0, 0);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons_->button(QDialogButtonBox::Ok)->setText(tr("Import"));
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(false);
  auto* left = new QVBoxLayout;
  auto* top = new QFormLayout;
  top->addRow(tr("Id of the part"), id_);
  left->addLayout(top);
  left->addWidget(drop_);
  left->addWidget(form_, 1);
  auto* right = new QVBoxLayout;
  right->addWidget(report_, 1);
  right->addWidget(progress_);
  auto* columns = new QHBoxLayout;
  columns->addLayout(left, 1);
  columns->addLayout(right, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(columns, 1);
  layout->addWidget(buttons_);
  form_->setSections("import", tr("How the file is read"),
                     {{"import", tr("Import"), io::importOptionsSchema().params(), options_}});
  connect(form_, &ParamForm::edited, this,
          [this](const std::string&, const std::string& key, const Value& value) {
            if (value.isNull()) {
              options_.remove(key);
            } else {
              options_.set(key, value);
            }
            form_->setSections(
                "import", tr("How the file is read"),
                {{"import", tr("Import"), io::importOptionsSchema().params(), options_}});
            preview();
          });
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  resize(820, 520);
  preview();
}

ImportDialog::~ImportDialog() = default;

void ImportDialog::preview() {
  progress_->show();
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(false);
  auto part = std::make_shared<io::ImportedPart>();
  auto findings = std::make_shared<std::vector<Diagnostic>>();
  const Value options = options_;
  runner_.start({"import",
                 [part, findings, options, file = file_](const JobContext& context) {
                   const JobContext own = context.withOwnDiagnostics();
                   *part = io::importPart(file, io::importOptionsSchema().read(options),
                                          geometry::Pose::Identity(), own);
                   *findings = own.diagnostics().items();
                 },
                 [this, part, findings](const std::optional<Error>& error) {
                   if (error && error->code() == ErrorCode::Cancelled) {
                     return;
                   }
                   progress_->hide();
                   if (error) {
                     bounds_.reset();
                     report_->setHtml("<p style='color:#d0342c'>" +
                                      errorText(*error).toHtmlEscaped().replace("\n", "<br/>") +
                                      "</p>");
                     return;
                   }
                   show(*part, *findings);
                 }});
}

void ImportDialog::show(const io::ImportedPart& part, const std::vector<Diagnostic>& findings) {
  const io::ImportReport& r = part.report;
  bounds_ = r.bounds;
  const geometry::Vec3 size = r.bounds.max - r.bounds.min;
  QString html = "<table cellpadding='3'>";
  const auto row = [&html](const QString& name, const QString& value) {
    html += "<tr><td><b>" + name + "</b></td><td>" + value.toHtmlEscaped() + "</td></tr>";
  };
  row(tr("Format"), qt(r.format));
  row(tr("Unit"),
      r.unitReason.empty() ? qt(r.unit) : tr("%1 (%2)").arg(qt(r.unit), engineText(r.unitReason)));
  row(tr("Size"), QString("%1 × %2 × %3 mm")
                      .arg(size.x(), 0, 'f', 2)
                      .arg(size.y(), 0, 'f', 2)
                      .arg(size.z(), 0, 'f', 2));
  row(tr("Triangles"), QString("%L1").arg(r.triangles));
  if (r.faces > 0) {
    row(tr("CAD faces and edges"), QString("%1 / %2").arg(r.faces).arg(r.edges));
    row(tr("Free curves"), QString::number(r.freeEdges));
  }
  row(tr("Closed"),
      r.closed ? tr("yes") : tr("no, %n border(s)", nullptr, static_cast<int>(r.borders.size())));
  row(tr("Pieces"), QString::number(r.components));
  row(tr("Area"), QString("%L1 mm²").arg(r.area, 0, 'f', 0));
  if (r.volume) {
    row(tr("Volume"), QString("%L1 mm³").arg(*r.volume, 0, 'f', 0));
  }
  for (const io::ImportedBody& body : r.bodies) {
    row(tr("Body"), qt(body.name.empty() ? body.kind : body.name + " (" + body.kind + ")"));
  }
  html += "</table>";
  if (!findings.empty()) {
    html += "<p><b>" + tr("What was found and repaired") + "</b></p><ul>";
    for (const Diagnostic& d : findings) {
      html +=
          "<li>" + engineText(d.message).toHtmlEscaped() +
          (d.remedy.empty() ? QString() : ": <i>" + engineText(d.remedy).toHtmlEscaped() + "</i>") +
          "</li>";
    }
    html += "</ul>";
  }
  report_->setHtml(html);
  // A part that lies off the origin is put on the plate by default.
  const bool placed = std::abs(r.bounds.min.z()) < 1e-3;
  if (!drop_->property("asked").toBool()) {
    drop_->setChecked(!placed);
    drop_->setProperty("asked", true);
  }
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(true);
  buttons_->button(QDialogButtonBox::Ok)->setDefault(true);
}

std::string ImportDialog::id() const {
  return utf8(id_->text().trimmed());
}

std::vector<project::Command> ImportDialog::commands() const {
  std::string path = pathText(std::filesystem::absolute(file_));
  if (!session_.file().empty()) {
    const std::filesystem::path relative =
        std::filesystem::absolute(file_).lexically_relative(session_.file().parent_path());
    if (!relative.empty() && *relative.begin() != "..") {
      path = relative.generic_string();
    }
  }
  Value args =
      Value::object({{"id", id()}, {"file", Value::object({{"path", path}, {"sha256", ""}})}});
  if (options_.size() > 0) {
    args.set("import", options_);
  }
  if (drop_->isChecked() && bounds_) {
    const geometry::Vec3 middle = 0.5 * (bounds_->min + bounds_->max);
    args.set(
        "placement",
        Value::object({{"position_mm", Value(Value::Array{Value(-middle.x()), Value(-middle.y()),
                                                          Value(-bounds_->min.z())})}}));
  }
  return {{"part.add", args}};
}

// --- operation

OperationDialog::OperationDialog(Session& session, QWidget* parent)
    : QDialog(parent), session_(session) {
  setObjectName("operationDialog");
  setWindowTitle(tr("Add an operation"));
  const project::Project& project = session.document().project();
  strategies_ = new QListWidget(this);
  strategies_->setObjectName("strategies");
  strategies_->setIconSize({72, 54});
  strategies_->setSpacing(2);
  for (const plugin::ComponentEntry& entry : session.plugins().components()) {
    if (entry.kind != plugin::ComponentKind::Slicing) {
      continue;
    }
    QString sentence;
    bool broken = false;
    try {
      sentence = engineText(session.plugins().info(entry.id).summary);
    } catch (const Error& error) {
      sentence = errorText(error);
      broken = true;
    }
    auto* item = new QListWidgetItem(strategyPicture(entry.id),
                                     engineText(entry.name) + "\n" + sentence, strategies_);
    item->setData(Qt::UserRole, qt(entry.id));
    item->setData(Qt::UserRole + 1, qt(entry.name));
    if (broken) {
      item->setFlags(Qt::NoItemFlags);
    }
  }
  strategies_->setWordWrap(true);
  about_ = new QLabel(this);
  about_->setWordWrap(true);
  id_ = new QLineEdit(this);
  id_->setObjectName("operationId");
  const auto combo = [&](const char* name, const auto& nodes, bool optional) {
    auto* box = new QComboBox(this);
    box->setObjectName(name);
    if (optional) {
      box->addItem(tr("none"), QString());
    }
    for (const auto& node : nodes) {
      box->addItem(qt(node.id), qt(node.id));
    }
    return box;
  };
  part_ = combo("operationPart", project.parts, true);
  part_->setCurrentIndex(project.parts.empty() ? 0 : 1);
  substrate_ = combo("operationSubstrate", project.substrates, false);
  guide_ = combo("operationGuide", project.guides, true);
  process_ = combo("operationProcess", project.processes, false);
  if (project.substrates.empty()) {
    substrate_->addItem(tr("a new plate"), "plate");
  }
  if (project.processes.empty()) {
    process_->addItem(tr("new parameters"), "wire");
  }
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  auto* form = new QFormLayout;
  form->addRow(tr("Id"), id_);
  form->addRow(tr("Part"), part_);
  form->addRow(tr("Substrate"), substrate_);
  form->addRow(tr("Guide curve"), guide_);
  form->addRow(tr("Process"), process_);
  form->addRow(about_);
  auto* columns = new QHBoxLayout;
  columns->addWidget(strategies_, 3);
  columns->addLayout(form, 2);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(columns, 1);
  layout->addWidget(buttons_);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(strategies_, &QListWidget::currentRowChanged, this, &OperationDialog::show);
  connect(guide_, &QComboBox::currentIndexChanged, this, &OperationDialog::show);
  for (int i = 0; i < strategies_->count(); ++i) {
    if (strategies_->item(i)->data(Qt::UserRole).toString() == "wcam.slicing.planar") {
      strategies_->setCurrentRow(i);
    }
  }
  resize(860, 560);
}

void OperationDialog::show() {
  const QListWidgetItem* item = strategies_->currentItem();
  if (item == nullptr) {
    return;
  }
  const std::string strategy = utf8(item->data(Qt::UserRole).toString());
  const std::string last = strategy.substr(strategy.rfind('.') + 1);
  id_->setText(qt(freeId(session_.document(), "operations", idFrom(qt(last)))));
  QString note;
  try {
    const plugin::ComponentInfo info = session_.plugins().info(strategy);
    if (info.needsGuide && guide_->currentData().toString().isEmpty()) {
      note = info.automaticGuide.empty()
                 ? tr("This strategy needs a guide curve. Right-click an edge in the 3D view to "
                      "make one.")
                 : tr("Without a guide curve the strategy makes one itself.");
    }
    if (info.needsFile) {
      note = tr("This strategy reads a path from a file, which is chosen in its parameters.");
    }
  } catch (const Error& error) {
    note = errorText(error);
  }
  about_->setText(note);
}

std::string OperationDialog::id() const {
  return utf8(id_->text().trimmed());
}

std::vector<project::Command> OperationDialog::commands() const {
  std::vector<project::Command> commands;
  const project::Project& project = session_.document().project();
  if (project.substrates.empty()) {
    const std::filesystem::path cell = project.cell.path.empty()
                                           ? std::filesystem::path()
                                           : project::resolvePath(session_.base(), project.cell);
    commands.push_back({"substrate.add", project::newPlate(cell)});
  }
  if (project.processes.empty()) {
    commands.push_back(
        {"process.add", Value::object({{"id", "wire"}, {"params", Value::object()}})});
  }
  const std::string strategy = utf8(strategies_->currentItem()->data(Qt::UserRole).toString());
  Value parts = Value::array();
  if (const std::string part = utf8(part_->currentData().toString()); !part.empty()) {
    parts.push(part);
  }
  Value args = Value::object({{"id", id()},
                              {"strategy", strategy},
                              {"parts", parts},
                              {"substrate", utf8(substrate_->currentData().toString())},
                              {"process", utf8(process_->currentData().toString())}});
  if (const std::string guide = utf8(guide_->currentData().toString()); !guide.empty()) {
    args.set("guide", guide);
  }
  try {
    const plugin::ComponentInfo info = session_.plugins().info(strategy);
    if (info.needsGuide && !args.contains("guide") && !info.automaticGuide.empty()) {
      args.set("params", Value::object({{info.automaticGuide, Value(true)}}));
    }
  } catch (const Error&) {
    // The result tells what is wrong with the plugin.
    args.remove("params");
  }
  commands.push_back({"operation.add", args});
  return commands;
}

}  // namespace wcam::gui
