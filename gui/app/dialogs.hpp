// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/project/run.hpp"

#include "session.hpp"
#include "widgets/param_form.hpp"

#include <QDialog>

#include <optional>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;
class QTextBrowser;

namespace wcam::gui {

/// New project: an empty one on a plate, or an example to start from, with a cell.
class NewDialog : public QDialog {
  Q_OBJECT

public:
  explicit NewDialog(QWidget* parent = nullptr);
  /// With the post-processor of the chosen cell's controller.
  /// @throws Error for a template that cannot be read
  [[nodiscard]] project::Document document(const plugin::PluginHost& plugins) const;

private:
  QListWidget* templates_;
  QComboBox* cell_;
  QLabel* about_;
};

/// Import of a part: settings and what they give, before anything is changed.
class ImportDialog : public QDialog {
  Q_OBJECT

public:
  ImportDialog(Session& session, const std::filesystem::path& file, QWidget* parent = nullptr);
  ~ImportDialog() override;

  /// The commands that add the part.
  [[nodiscard]] std::vector<project::Command> commands() const;
  [[nodiscard]] std::string id() const;

private:
  void preview();
  void show(const io::ImportedPart& part, const std::vector<Diagnostic>& findings);

  Session& session_;
  std::filesystem::path file_;
  Value options_ = Value::object();
  std::optional<geometry::Box> bounds_;
  JobRunner runner_;
  QLineEdit* id_;
  QCheckBox* drop_;
  ParamForm* form_;
  QTextBrowser* report_;
  QProgressBar* progress_;
  QDialogButtonBox* buttons_;
};

/// Chooses a strategy with a picture and a sentence each, and what it works on.
class OperationDialog : public QDialog {
  Q_OBJECT

public:
  explicit OperationDialog(Session& session, QWidget* parent = nullptr);
  [[nodiscard]] std::vector<project::Command> commands() const;
  [[nodiscard]] std::string id() const;

private:
  void show();

  Session& session_;
  QListWidget* strategies_;
  QLabel* about_;
  QLineEdit* id_;
  QComboBox* part_;
  QComboBox* substrate_;
  QComboBox* guide_;
  QComboBox* process_;
  QDialogButtonBox* buttons_;
};

/// Writes the stored outputs; the same as `camcli --project`.
class ExportDialog : public QDialog {
  Q_OBJECT

public:
  explicit ExportDialog(Session& session, QWidget* parent = nullptr);
  ~ExportDialog() override;

  [[nodiscard]] bool running() const { return runner_.busy(); }

public slots:
  void reject() override;

private:
  void start();
  void show(const project::RunResult& result);

  Session& session_;
  JobRunner runner_;
  QListWidget* outputs_;
  QListWidget* operations_;
  QLineEdit* folder_;
  QCheckBox* tables_;
  QCheckBox* check_;
  QTextBrowser* report_;
  QProgressBar* progress_;
  QPushButton* run_;
};

/// An id that no node of a list has, from a wanted text.
std::string freeId(const project::Document& document,
                   const std::string& list,
                   const std::string& wanted);
/// The text as an id: lower case letters, digits, '_', '-', '.'.
std::string idFrom(const QString& text);

}  // namespace wcam::gui
