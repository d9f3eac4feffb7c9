// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "edit_dialog.hpp"

#include "wcam/toolpath/edits.hpp"

#include "edit_pictures.hpp"
#include "widgets/text.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace wcam::gui {

std::string freeEditId(const project::Document& document,
                       const std::string& operation,
                       const std::string& wanted) {
  const project::Operation* found = document.project().operation(operation);
  const auto taken = [found](const std::string& id) {
    return found != nullptr &&
           std::any_of(found->edits.begin(), found->edits.end(),
                       [&id](const project::OperationEdit& edit) { return edit.id == id; });
  };
  std::string id = wanted;
  for (int i = 2; taken(id); ++i) {
    id = wanted + "-" + std::to_string(i);
  }
  return id;
}

EditDialog::EditDialog(const project::Document& document,
                       const std::string& operation,
                       QWidget* parent)
    : QDialog(parent), document_(document) {
  setObjectName("editDialog");
  setWindowTitle(tr("Add an edit of the toolpath"));
  types_ = new QListWidget(this);
  types_->setObjectName("editTypes");
  types_->setAccessibleName(tr("What the edit does"));
  types_->setIconSize({72, 54});
  types_->setSpacing(2);
  types_->setWordWrap(true);
  for (const toolpath::EditTypeInfo& info : toolpath::editTypes()) {
    auto* item = new QListWidgetItem(
        editPicture(info.type), engineText(info.name) + "\n" + engineText(info.summary), types_);
    item->setData(Qt::UserRole, QString(info.key));
  }
  operation_ = new QComboBox(this);
  operation_->setObjectName("editOperation");
  for (const project::Operation& known : document.project().operations) {
    operation_->addItem(qt(known.id), qt(known.id));
  }
  operation_->setCurrentIndex(std::max(0, operation_->findData(qt(operation))));
  id_ = new QLineEdit(this);
  id_->setObjectName("editId");
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  auto* form = new QFormLayout;
  form->addRow(tr("Operation"), operation_);
  form->addRow(tr("Id"), id_);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(types_, 1);
  layout->addLayout(form);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(types_, &QListWidget::itemActivated, this, &QDialog::accept);
  connect(types_, &QListWidget::currentRowChanged, this, &EditDialog::proposeId);
  connect(operation_, &QComboBox::currentIndexChanged, this, &EditDialog::proposeId);
  types_->setCurrentRow(0);
  resize(560, 620);
}

void EditDialog::proposeId() {
  id_->setText(qt(freeEditId(document_, operation(), type())));
}

std::string EditDialog::operation() const {
  return utf8(operation_->currentData().toString());
}

std::string EditDialog::id() const {
  return utf8(id_->text().trimmed());
}

std::string EditDialog::type() const {
  const QListWidgetItem* item = types_->currentItem();
  return item != nullptr ? utf8(item->data(Qt::UserRole).toString()) : std::string();
}

}  // namespace wcam::gui
