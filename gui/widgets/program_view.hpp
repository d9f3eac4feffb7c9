// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/program_text.hpp"
#include "model/view_state.hpp"

#include <QWidget>

#include <memory>

class QComboBox;
class QLabel;
class QPlainTextEdit;

namespace wcam::gui {

/// The program as it will be exported, of one output: the line of the present move is marked, and a
/// click on a line goes to its move.
class ProgramView : public QWidget {
  Q_OBJECT

public:
  explicit ProgramView(ViewState& state, QWidget* parent = nullptr);
  ~ProgramView() override;

  /// Outputs that can be shown.
  void setOutputs(const QStringList& ids);
  [[nodiscard]] QString output() const;
  void setProgram(std::shared_ptr<const ProgramText> program);
  void setMessage(const QString& message);

  [[nodiscard]] QPlainTextEdit& editor() { return *text_; }

  /// Line of the present move in the shown file, −1 when it has none.
  [[nodiscard]] int markedLine() const { return marked_; }

signals:
  /// The user chose an output, or the view became visible: its program is wanted.
  void wanted();

protected:
  void showEvent(QShowEvent* event) override;

private:
  void showFile(int index);
  void showMove();
  void jump();

  ViewState& state_;
  int listener_ = 0;
  QComboBox* output_;
  QComboBox* file_;
  QLabel* note_;
  QPlainTextEdit* text_;
  std::shared_ptr<const ProgramText> program_;
  int marked_ = -1;
  bool following_ = false;
  bool browsing_ = false;
};

}  // namespace wcam::gui
