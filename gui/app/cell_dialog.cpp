// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cell_dialog.hpp"

#include "wcam/base/file_io.hpp"

#include "node_form.hpp"
#include "widgets/icons.hpp"
#include "widgets/text.hpp"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace wcam::gui {

CellDialog::CellDialog(const std::string& present,
                       const std::filesystem::path& folder,
                       QWidget* parent)
    : QDialog(parent) {
  setObjectName("cellDialog");
  setWindowTitle(tr("Choose a cell"));
  cells_ = new QListWidget(this);
  cells_->setObjectName("cells");
  cells_->setWordWrap(true);
  cells_->setSpacing(3);
  const auto add = [this](const QString& text, const QString& path) {
    auto* item = new QListWidgetItem(icon("cell"), text, cells_);
    item->setData(Qt::UserRole, path);
    return item;
  };
  for (const ShippedCell& cell : shippedCells()) {
    QListWidgetItem* item = add(qt(cell.name) + "\n" + qt(cell.description), qt(cell.path));
    if (cell.path == present) {
      cells_->setCurrentItem(item);
    }
  }
  // One of the project's own.
  if (!present.empty() && cells_->currentItem() == nullptr) {
    cells_->setCurrentItem(add(qt(present), qt(present)));
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  QPushButton* other = buttons->addButton(tr("Other file…"), QDialogButtonBox::ActionRole);
  other->setObjectName("otherCell");
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(cells_, 1);
  layout->addWidget(buttons);
  const auto enable = [this, buttons] {
    buttons->button(QDialogButtonBox::Ok)->setEnabled(cells_->currentItem() != nullptr);
  };
  connect(cells_, &QListWidget::currentRowChanged, this, enable);
  connect(cells_, &QListWidget::itemDoubleClicked, this, &QDialog::accept);
  connect(other, &QPushButton::clicked, this, [this, folder] { chooseFile(folder); });
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  enable();
  resize(560, 520);
}

void CellDialog::chooseFile(const std::filesystem::path& folder) {
  const QString file = QFileDialog::getOpenFileName(this, tr("Choose a cell"), qt(pathText(folder)),
                                                    tr("Cells (*.json)"));
  if (!file.isEmpty()) {
    auto* item = new QListWidgetItem(icon("cell"), QFileInfo(file).fileName(), cells_);
    item->setData(Qt::UserRole, file);
    cells_->setCurrentItem(item);
    accept();
  }
}

std::string CellDialog::path() const {
  const QListWidgetItem* item = cells_->currentItem();
  return item != nullptr ? utf8(item->data(Qt::UserRole).toString()) : std::string();
}

}  // namespace wcam::gui
