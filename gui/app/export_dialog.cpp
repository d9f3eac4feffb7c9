// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"
#include "wcam/project/run.hpp"

#include "dialogs.hpp"
#include "widgets/diagnostics_table.hpp"
#include "widgets/icons.hpp"
#include "widgets/text.hpp"

#include <QCheckBox>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QTextBrowser>
#include <QToolButton>
#include <QUrl>

#include <algorithm>

namespace wcam::gui {

namespace {

QListWidget* checkList(QWidget* parent, const char* name) {
  auto* list = new QListWidget(parent);
  list->setObjectName(name);
  list->setMaximumHeight(120);
  return list;
}

void addChecked(QListWidget* list, const QString& text, const std::string& id, bool on) {
  auto* item = new QListWidgetItem(text, list);
  item->setData(Qt::UserRole, qt(id));
  item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
  item->setCheckState(on ? Qt::Checked : Qt::Unchecked);
}

std::vector<std::string> checkedOf(const QListWidget* list) {
  std::vector<std::string> ids;
  for (int i = 0; i < list->count(); ++i) {
    if (list->item(i)->checkState() == Qt::Checked) {
      ids.push_back(utf8(list->item(i)->data(Qt::UserRole).toString()));
    }
  }
  return ids;
}

QString red(const QString& text) {
  return "<span style='color:#d0342c'>" + text.toHtmlEscaped().replace("\n", "<br/>") + "</span>";
}

}  // namespace

ExportDialog::ExportDialog(Session& session, QWidget* parent)
    : QDialog(parent), session_(session), runner_([](std::function<void()> call) {
        QMetaObject::invokeMethod(QCoreApplication::instance(), std::move(call),
                                  Qt::QueuedConnection);
      }) {
  setObjectName("exportDialog");
  setWindowTitle(tr("Export programs"));
  const project::Project& project = session.document().project();
  outputs_ = checkList(this, "exportOutputs");
  for (const project::Output& output : project.outputs) {
    addChecked(outputs_, QString("%1 — %2").arg(qt(output.id), qt(output.post)), output.id, true);
  }
  operations_ = checkList(this, "exportOperations");
  for (const project::Operation& operation : project.operations) {
    addChecked(operations_, qt(operation.id), operation.id, operation.enabled);
  }
  const std::filesystem::path base = session.base();
  folder_ = new QLineEdit(qt(pathText(base.parent_path() / (base.stem().string() + "-out"))), this);
  folder_->setObjectName("exportFolder");
  auto* browse = new QToolButton(this);
  browse->setIcon(icon("open"));
  browse->setAccessibleName(tr("Choose a folder"));
  auto* folderLine = new QHBoxLayout;
  folderLine->addWidget(folder_, 1);
  folderLine->addWidget(browse);
  tables_ = new QCheckBox(tr("Also write tables of all points (CSV)"), this);
  check_ = new QCheckBox(tr("Only check, write nothing"), this);
  report_ = new QTextBrowser(this);
  report_->setObjectName("exportReport");
  report_->setOpenExternalLinks(true);
  progress_ = new QProgressBar(this);
  progress_->setRange(0, 1000);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  run_ = buttons->addButton(tr("Export"), QDialogButtonBox::ActionRole);
  run_->setObjectName("exportRun");
  run_->setDefault(true);
  auto* form = new QFormLayout(this);
  form->addRow(tr("Outputs"), outputs_);
  form->addRow(tr("Operations"), operations_);
  form->addRow(tr("Folder"), folderLine);
  form->addRow(tables_);
  form->addRow(check_);
  form->addRow(report_);
  form->addRow(progress_);
  form->addRow(buttons);
  progress_->hide();
  connect(browse, &QToolButton::clicked, this, [this] {
    const QString folder =
        QFileDialog::getExistingDirectory(this, tr("Choose a folder"), folder_->text());
    if (!folder.isEmpty()) {
      folder_->setText(folder);
    }
  });
  connect(run_, &QPushButton::clicked, this, &ExportDialog::start);
  connect(buttons, &QDialogButtonBox::rejected, this, &ExportDialog::reject);
  runner_.setProgress([this](double fraction, const std::string& label) {
    progress_->setValue(static_cast<int>(1000 * fraction));
    progress_->setFormat(engineText(label) + " %p%");
  });
  resize(620, 640);
}

ExportDialog::~ExportDialog() = default;

void ExportDialog::reject() {
  // The first press stops the export, the second one closes.
  if (runner_.busy()) {
    runner_.cancel();
    return;
  }
  QDialog::reject();
}

void ExportDialog::start() {
  if (runner_.busy()) {
    return;
  }
  project::RunRequest request;
  request.folder = pathFromText(utf8(folder_->text()));
  request.operations = checkedOf(operations_);
  request.posts = checkedOf(outputs_);
  request.tables = tables_->isChecked();
  request.checkOnly = check_->isChecked();
  if (request.operations.empty() || (request.posts.empty() && !request.checkOnly)) {
    report_->setHtml(red(request.operations.empty() ? tr("Choose at least one operation.")
                                                    : tr("Choose at least one output.")));
    return;
  }
  auto result = std::make_shared<project::RunResult>();
  run_->setEnabled(false);
  progress_->setValue(0);
  progress_->show();
  report_->clear();
  runner_.start({utf8(tr("Export")),
                 [result, request, pipeline = session_.pipeline()](const JobContext& context) {
                   *result = project::runProject(pipeline, request, context);
                 },
                 [this, result](const std::optional<Error>& error) {
                   run_->setEnabled(true);
                   progress_->hide();
                   if (error) {
                     report_->setHtml(error->code() == ErrorCode::Cancelled
                                          ? tr("Cancelled: nothing was written.")
                                          : red(errorText(*error)));
                     return;
                   }
                   show(*result);
                 }});
}

void ExportDialog::show(const project::RunResult& result) {
  QString html;
  for (const project::RunFailure& failure : result.failures) {
    html += "<p>" + red(errorText(failure.error)) + "</p>";
  }
  for (const project::KeptBack& kept : result.keptBack) {
    html += "<p>" +
            red(kept.output.empty()
                    ? tr("Operation '%1' violates checks and gets no robot program.")
                          .arg(qt(kept.operation))
                    : tr("Output '%1' of operation '%2' violates checks and is not written.")
                          .arg(qt(kept.output), qt(kept.operation))) +
            "</p>";
  }
  if (result.exitCode() == 0) {
    html += "<p><b>" +
            (result.written ? tr("Everything is written.") : tr("Everything is in order.")) +
            "</b></p>";
  }
  if (!result.files.empty() && result.written) {
    const QString folder = folder_->text();
    html += QString("<p><a href='%1'>%2</a></p><ul>")
                .arg(QUrl::fromLocalFile(folder).toString(), folder.toHtmlEscaped());
    for (const project::WrittenFile& file : result.files) {
      html += tr("<li>%1 (%L2 bytes)</li>").arg(qt(file.path).toHtmlEscaped()).arg(file.bytes);
    }
    html += "</ul>";
  }
  if (!result.leftFiles.empty()) {
    QStringList left;
    for (const std::string& file : result.leftFiles) {
      left.append(qt(file));
    }
    html +=
        "<p>" +
        tr("Not written again and perhaps out of date: %1").arg(left.join(", ")).toHtmlEscaped() +
        "</p>";
  }
  for (const project::OperationResult& operation : result.operations) {
    for (const Diagnostic& d : operation.findings) {
      if (d.severity != Severity::Information) {
        html += "<p><small>" + lineText(d).toHtmlEscaped() + "</small></p>";
      }
    }
  }
  report_->setHtml(html);
}

}  // namespace wcam::gui
