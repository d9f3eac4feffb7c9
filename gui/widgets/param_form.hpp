// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/param.hpp"

#include <QTimer>
#include <QWidget>

#include <map>
#include <set>
#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace wcam::gui {

/// A group of parameters of a form: a schema and the values that stand in the document.
struct FormSection {
  std::string id;  ///< "params", "path", ...
  QString title;
  ParamSchema schema;
  Value values;  ///< sparse object
  bool readOnly = false;
  /// Parameters whose text is a list of ids: what there is to choose from. Its label is shown, its
  /// key is stored.
  std::map<std::string, std::vector<ParamChoice>> lists = {};
  /// Indices that files count from 0 and people from 1; negative ones are the same in both.
  std::set<std::string> indices = {};
};

/// A form made from schemas: search, groups, levels, units, limits, errors at their fields, reset
/// to the default. Knows nothing of documents: it tells what was edited. Its widgets are made in
/// several turns of the event loop; who asks for one of them gets all at once.
class ParamForm : public QWidget {
  Q_OBJECT

public:
  explicit ParamForm(QWidget* parent = nullptr);

  /// @param identity of what is edited; the same identity keeps fields, focus and scroll position
  void setSections(const std::string& identity,
                   const QString& title,
                   std::vector<FormSection> sections);
  void clear();

  /// Field of a parameter, for tests; null when it is not there.
  [[nodiscard]] QWidget* field(const std::string& section, const std::string& key);
  /// The error that stands at a field; empty when there is none.
  [[nodiscard]] QString errorAt(const std::string& section, const std::string& key);
  /// Number of parameters whose widgets are made: those that were shown since the form was built.
  [[nodiscard]] std::size_t filledRows() const;

  /// How often the form was built anew: not for other values of the same parameters.
  [[nodiscard]] int builds() const { return builds_; }

  /// Shows an error of the command at the field that was edited last.
  void showError(const std::string& section, const std::string& key, const QString& error);
  /// Takes what is typed into the field that has the focus, as if it was left.
  void commit();
  void focusSearch();
  /// Opens and focuses the field of a parameter.
  void focusField(const std::string& section, const std::string& key);

signals:
  /// A value in file units, or null for the default.
  void edited(const std::string& section, const std::string& key, const wcam::Value& value);

private:
  /// Widgets cost far more than values: those of a row are made when it is shown first.
  struct Row {
    std::string section;
    ParamDef def;
    QWidget* box = nullptr;  ///< everything of the row
    QLabel* label = nullptr;
    QWidget* field = nullptr;
    QLabel* error = nullptr;
    QToolButton* reset = nullptr;
    QToolButton* group = nullptr;
    Value value;
    QString problem;                 ///< with the value of the document
    std::vector<ParamChoice> items;  ///< to choose from
    bool isList = false;
    bool isIndex = false;
    bool shown = false;
    bool isSet = false;
    bool enabled = true;
    bool readOnly = false;
  };

  void rebuild();
  void addRow(const FormSection& section,
              const ParamDef& def,
              QToolButton* group,
              QVBoxLayout* layout);
  void fill(Row& row);
  /// Makes the next widgets; the last time shows them all.
  void buildSome(std::size_t most);
  void buildRest();
  QWidget* makeField(Row& row);
  QWidget* makeList(Row& row);
  [[nodiscard]] static QString textOf(const Row& row);
  void takeValues();
  void showValue(Row& row, bool changed);
  void filter();
  void commitText(const std::string& section, const std::string& key, const QString& text);
  /// A row with its widgets; null when there is no such parameter.
  [[nodiscard]] Row* find(const std::string& section, const std::string& key);

  std::string identity_;
  std::vector<FormSection> sections_;
  std::vector<Row> rows_;
  std::vector<std::pair<QWidget*, std::vector<std::size_t>>> groups_;
  std::map<std::string, bool> collapsed_;
  QLabel* title_;
  QLineEdit* search_;
  QComboBox* level_;
  QScrollArea* scroll_;
  QWidget* body_ = nullptr;
  QTimer building_;
  bool complete_ = false;  ///< the widgets of all rows to be shown are made
  int builds_ = 0;
};

}  // namespace wcam::gui
