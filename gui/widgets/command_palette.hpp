// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "action_catalog.hpp"

#include <QDialog>

class QLineEdit;
class QListWidget;

namespace wcam::gui {

/// Finds and runs any action by a few letters of its name.
class CommandPalette : public QDialog {
  Q_OBJECT

public:
  explicit CommandPalette(const ActionCatalog& catalog, QWidget* parent = nullptr);

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  void filter(const QString& text);
  void run();

  const ActionCatalog& catalog_;
  QLineEdit* search_;
  QListWidget* list_;
};

}  // namespace wcam::gui
