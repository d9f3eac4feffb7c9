// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "diagnostics_table.hpp"

#include "text.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <set>

namespace wcam::gui {

FindingRow rowOf(const Diagnostic& diagnostic) {
  FindingRow row;
  row.status = diagnostic.severity == Severity::Violation ? Status::Error
               : diagnostic.severity == Severity::Warning ? Status::Warning
                                                          : Status::Information;
  row.code = qt(diagnostic.code);
  row.message = engineText(diagnostic.message);
  row.remedy = engineText(diagnostic.remedy);
  row.jump = diagnostic.place;
  if (!diagnostic.place.operation.empty()) {
    row.node = {"operations", diagnostic.place.operation};
    row.place = qt(diagnostic.place.operation);
  }
  // People count from 1.
  if (diagnostic.place.layer >= 0) {
    row.place += DiagnosticsTable::tr(" layer %1").arg(diagnostic.place.layer + 1);
  }
  if (diagnostic.place.bead >= 0) {
    row.place += DiagnosticsTable::tr(" bead %1").arg(diagnostic.place.bead + 1);
  }
  if (diagnostic.place.point >= 0) {
    row.place += DiagnosticsTable::tr(" point %1").arg(diagnostic.place.point + 1);
  }
  return row;
}

QString lineText(const Diagnostic& diagnostic) {
  const FindingRow row = rowOf(diagnostic);
  return row.code + (row.place.isEmpty() ? QString() : " [" + row.place.trimmed() + "]") + ": " +
         row.message + (row.remedy.isEmpty() ? QString() : " (" + row.remedy + ")");
}

class DiagnosticsTable::Model : public QAbstractTableModel {
public:
  Model(const std::vector<FindingRow>& rows, QObject* parent)
      : QAbstractTableModel(parent), rows_(rows) {}

  void begin() { beginResetModel(); }

  void end() { endResetModel(); }

  [[nodiscard]] int rowCount(const QModelIndex& parent) const override {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
  }

  [[nodiscard]] int columnCount(const QModelIndex& parent) const override {
    return parent.isValid() ? 0 : 5;
  }

  [[nodiscard]] QVariant headerData(int section,
                                    Qt::Orientation orientation,
                                    int role) const override {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
      return {};
    }
    switch (section) {
      case 1:
        return DiagnosticsTable::tr("Place");
      case 2:
        return DiagnosticsTable::tr("Finding");
      case 3:
        return DiagnosticsTable::tr("Remedy");
      case 4:
        return DiagnosticsTable::tr("Code");
      default:
        return {};
    }
  }

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override {
    const FindingRow& row = rows_[static_cast<std::size_t>(index.row())];
    if (role == Qt::UserRole) {
      return static_cast<int>(row.status);
    }
    if (role == Qt::DecorationRole && index.column() == 0) {
      return statusIcon(row.status);
    }
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) {
      return {};
    }
    switch (index.column()) {
      case 1:
        return row.place;
      case 2:
        return row.message;
      case 3:
        return row.remedy;
      case 4:
        return row.code;
      default:
        return {};
    }
  }

private:
  const std::vector<FindingRow>& rows_;
};

class DiagnosticsTable::Filter : public QSortFilterProxyModel {
public:
  using QSortFilterProxyModel::QSortFilterProxyModel;

  void setHidden(const std::set<int>& hidden) {
    hidden_ = hidden;
    invalidateFilter();
  }

protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    const int status = sourceModel()->index(row, 0, parent).data(Qt::UserRole).toInt();
    return hidden_.count(status) == 0 && QSortFilterProxyModel::filterAcceptsRow(row, parent);
  }

  [[nodiscard]] bool lessThan(const QModelIndex& a, const QModelIndex& b) const override {
    if (a.column() == 0) {
      return a.data(Qt::UserRole).toInt() > b.data(Qt::UserRole).toInt();
    }
    return QSortFilterProxyModel::lessThan(a, b);
  }

private:
  std::set<int> hidden_;
};

DiagnosticsTable::DiagnosticsTable(QWidget* parent) : QWidget(parent) {
  setObjectName("diagnostics");
  model_ = new Model(rows_, this);
  filter_ = new Filter(this);
  filter_->setSourceModel(model_);
  filter_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  filter_->setFilterKeyColumn(-1);
  table_ = new QTableView(this);
  table_->setObjectName("diagnosticsTable");
  table_->setAccessibleName(tr("Findings"));
  table_->setModel(filter_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(0, Qt::AscendingOrder);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setAlternatingRowColors(true);
  table_->setShowGrid(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(24);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setTabKeyNavigation(false);
  table_->setColumnWidth(0, 28);
  table_->setColumnWidth(1, 190);
  table_->setColumnWidth(2, 420);
  table_->setColumnWidth(3, 320);
  search_ = new QLineEdit(this);
  search_->setObjectName("diagnosticsFilter");
  search_->setPlaceholderText(tr("Filter findings"));
  search_->setClearButtonEnabled(true);
  search_->setMaximumWidth(280);
  auto* top = new QHBoxLayout;
  top->setContentsMargins(6, 4, 6, 0);
  const auto addButton = [&](Status status, const QString& tip) {
    auto* made = new QToolButton(this);
    made->setCheckable(true);
    made->setChecked(true);
    made->setIcon(statusIcon(status));
    made->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    connect(made, &QToolButton::toggled, this, [this] {
      std::set<int> hidden;
      for (const auto& [s, b] : buttons_) {
        if (!b->isChecked()) {
          hidden.insert(static_cast<int>(s));
        }
      }
      filter_->setHidden(hidden);
    });
    buttons_.push_back({status, made});
    top->addWidget(made);
  };
  addButton(Status::Error, tr("Show errors and violations"));
  addButton(Status::Warning, tr("Show warnings"));
  addButton(Status::Information, tr("Show information"));
  top->addStretch(1);
  top->addWidget(search_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  layout->addLayout(top);
  layout->addWidget(table_, 1);
  connect(search_, &QLineEdit::textChanged, filter_, &QSortFilterProxyModel::setFilterFixedString);
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
    const int row = filter_->mapToSource(index).row();
    // The answer may set new rows.
    const FindingRow copy = rows_[static_cast<std::size_t>(row)];
    emit activated(copy);
  });
  updateButtons();
}

void DiagnosticsTable::setRows(std::vector<FindingRow> rows) {
  model_->begin();
  rows_ = std::move(rows);
  model_->end();
  updateButtons();
}

int DiagnosticsTable::count(Status status) const {
  return static_cast<int>(std::count_if(rows_.begin(), rows_.end(),
                                        [&](const FindingRow& r) { return r.status == status; }));
}

int DiagnosticsTable::shownRows() const {
  return filter_->rowCount();
}

void DiagnosticsTable::updateButtons() {
  for (const auto& [status, made] : buttons_) {
    made->setText(QString::number(count(status)));
  }
}

}  // namespace wcam::gui
