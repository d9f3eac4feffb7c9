// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/diagnostic.hpp"
#include "wcam/project/commands.hpp"

#include "icons.hpp"
#include "project_tree.hpp"

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <QWidget>

#include <vector>

class QLineEdit;
class QTableView;
class QToolButton;

namespace wcam::gui {

/// A row: a finding of the engine, or what kept a node from its result.
struct FindingRow {
  Status status = Status::Information;
  QString code;
  QString place;
  QString message;
  QString remedy;
  Place jump;                                ///< of an operation's point
  NodeRef node;                              ///< what to select
  std::vector<project::Command> apply = {};  ///< what puts it right; none: a hint
};

FindingRow rowOf(const Diagnostic& diagnostic);

/// A finding in one line: code, place, message, remedy.
QString lineText(const Diagnostic& diagnostic);

/// Findings with a filter; a double click tells where to jump, a button applies a remedy.
class DiagnosticsTable : public QWidget {
  Q_OBJECT

public:
  explicit DiagnosticsTable(QWidget* parent = nullptr);

  void setRows(std::vector<FindingRow> rows);

  [[nodiscard]] int count(Status status) const;

  [[nodiscard]] const std::vector<FindingRow>& rows() const { return rows_; }

  [[nodiscard]] int shownRows() const;

signals:
  void activated(const wcam::gui::FindingRow& row);
  void applied(const wcam::gui::FindingRow& row);

private:
  class Model;
  class Filter;
  class ApplyDelegate;
  void updateButtons();
  /// The row of the model behind an index of the table.
  [[nodiscard]] const FindingRow& rowAt(const QModelIndex& index) const;
  void apply(const QModelIndex& index);

  std::vector<FindingRow> rows_;
  Model* model_;
  Filter* filter_;
  QTableView* table_;
  QLineEdit* search_;
  QToolButton* apply_;
  std::vector<std::pair<Status, QToolButton*>> buttons_;
};

}  // namespace wcam::gui
