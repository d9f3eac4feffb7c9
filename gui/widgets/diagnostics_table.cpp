// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "diagnostics_table.hpp"

#include "text.hpp"

#include <QApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPainter>
#include <QStyleOptionButton>
#include <QStyledItemDelegate>
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

namespace {

enum Column {
  kStatusColumn,
  kPlaceColumn,
  kMessageColumn,
  kRemedyColumn,
  kApplyColumn,
  kCodeColumn
};

constexpr int kColumns = 6;
constexpr int kButtonRoom = 14;  // beside the text of a button, pixels

}  // namespace

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
    return parent.isValid() ? 0 : kColumns;
  }

  [[nodiscard]] QVariant headerData(int section,
                                    Qt::Orientation orientation,
                                    int role) const override {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
      return {};
    }
    switch (section) {
      case kPlaceColumn:
        return DiagnosticsTable::tr("Place");
      case kMessageColumn:
        return DiagnosticsTable::tr("Finding");
      case kRemedyColumn:
        return DiagnosticsTable::tr("Remedy");
      case kCodeColumn:
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
    if (role == Qt::DecorationRole && index.column() == kStatusColumn) {
      return statusIcon(row.status);
    }
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) {
      return {};
    }
    switch (index.column()) {
      case kPlaceColumn:
        return row.place;
      case kMessageColumn:
        return row.message;
      case kRemedyColumn:
        if (role == Qt::ToolTipRole && !row.remedy.isEmpty()) {
          return row.remedy + "\n" +
                 (row.apply.empty()
                      ? DiagnosticsTable::tr("A hint: it was not proven on the whole operation.")
                      : DiagnosticsTable::tr("This was tried on the whole operation."));
        }
        return row.remedy;
      case kApplyColumn:
        return row.apply.empty() ? QVariant()
               : role == Qt::ToolTipRole
                   ? DiagnosticsTable::tr("Applies the remedy, as one step that can be undone")
                   : DiagnosticsTable::tr("Apply");
      case kCodeColumn:
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
    if (a.column() == kStatusColumn) {
      return a.data(Qt::UserRole).toInt() > b.data(Qt::UserRole).toInt();
    }
    return QSortFilterProxyModel::lessThan(a, b);
  }

private:
  std::set<int> hidden_;
};

/// A button in the rows whose remedy can be applied.
class DiagnosticsTable::ApplyDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter,
             const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, QModelIndex());
    const QString text = index.data().toString();
    if (text.isEmpty()) {
      return;
    }
    QStyleOptionButton button;
    button.rect = option.rect.adjusted(2, 1, -2, -1);
    button.text = text;
    button.state = QStyle::State_Enabled | QStyle::State_Raised;
    button.palette = option.palette;
    button.fontMetrics = option.fontMetrics;
    QApplication::style()->drawControl(QStyle::CE_PushButton, &button, painter);
  }
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
  table_->setColumnWidth(kStatusColumn, 28);
  table_->setColumnWidth(kPlaceColumn, 190);
  table_->setColumnWidth(kMessageColumn, 420);
  table_->setColumnWidth(kRemedyColumn, 320);
  table_->setColumnWidth(kApplyColumn,
                         fontMetrics().horizontalAdvance(tr("Apply")) + 2 * kButtonRoom);
  table_->setItemDelegateForColumn(kApplyColumn, new ApplyDelegate(table_));
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
  // The same for the keyboard and for people who read the row first.
  apply_ = new QToolButton(this);
  apply_->setObjectName("applyRemedy");
  apply_->setText(tr("Apply remedy"));
  apply_->setToolTip(
      tr("Applies the remedy of the selected finding, as one step that can be undone"));
  apply_->setEnabled(false);
  top->addWidget(apply_);
  connect(apply_, &QToolButton::clicked, this, [this] { apply(table_->currentIndex()); });
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& index) {
            apply_->setEnabled(index.isValid() && !rowAt(index).apply.empty());
          });
  connect(table_, &QTableView::clicked, this, [this](const QModelIndex& index) {
    if (index.column() == kApplyColumn) {
      apply(index);
    }
  });
  top->addStretch(1);
  top->addWidget(search_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  layout->addLayout(top);
  layout->addWidget(table_, 1);
  connect(search_, &QLineEdit::textChanged, filter_, &QSortFilterProxyModel::setFilterFixedString);
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
    if (index.column() != kApplyColumn) {
      // The answer may set new rows.
      const FindingRow copy = rowAt(index);
      emit activated(copy);
    }
  });
  updateButtons();
}

const FindingRow& DiagnosticsTable::rowAt(const QModelIndex& index) const {
  return rows_[static_cast<std::size_t>(filter_->mapToSource(index).row())];
}

void DiagnosticsTable::apply(const QModelIndex& index) {
  if (index.isValid() && !rowAt(index).apply.empty()) {
    const FindingRow copy = rowAt(index);
    emit applied(copy);
  }
}

void DiagnosticsTable::setRows(std::vector<FindingRow> rows) {
  apply_->setEnabled(false);
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
