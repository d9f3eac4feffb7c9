// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPlainTextEdit>

namespace wcam::gui {

/// What happened, with the time: notes of the program and records of the engine's log.
class LogView : public QPlainTextEdit {
  Q_OBJECT

public:
  enum class Kind { Note, Warning, Error };

  explicit LogView(QWidget* parent = nullptr);
  ~LogView() override;
  void say(Kind kind, const QString& text);
};

}  // namespace wcam::gui
