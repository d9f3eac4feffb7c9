// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_palette.hpp"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace wcam::gui {

namespace {

/// True when all letters of the pattern come in order; shorter spans are better matches.
int scoreOf(const QString& text, const QString& pattern) {
  if (const qsizetype at = text.indexOf(pattern, 0, Qt::CaseInsensitive); at >= 0) {
    return static_cast<int>(at);
  }
  qsizetype from = 0;
  for (const QChar c : pattern) {
    const qsizetype at = text.indexOf(c, from, Qt::CaseInsensitive);
    if (at < 0) {
      return -1;
    }
    from = at + 1;
  }
  return 1000 + static_cast<int>(from);
}

}  // namespace

CommandPalette::CommandPalette(const ActionCatalog& catalog, QWidget* parent)
    : QDialog(parent, Qt::Dialog | Qt::FramelessWindowHint), catalog_(catalog) {
  setObjectName("commandPalette");
  setWindowTitle(tr("Command palette"));
  search_ = new QLineEdit(this);
  search_->setPlaceholderText(tr("Type the name of a command"));
  search_->installEventFilter(this);
  list_ = new QListWidget(this);
  list_->setFocusPolicy(Qt::NoFocus);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(search_);
  layout->addWidget(list_);
  connect(search_, &QLineEdit::textChanged, this, &CommandPalette::filter);
  connect(search_, &QLineEdit::returnPressed, this, &CommandPalette::run);
  connect(list_, &QListWidget::itemClicked, this, &CommandPalette::run);
  resize(520, 380);
  filter({});
}

void CommandPalette::filter(const QString& text) {
  list_->clear();
  std::vector<std::pair<int, QAction*>> found;
  for (const ActionCatalog::Entry& entry : catalog_.entries()) {
    if (entry.id.isEmpty() || !entry.action->isEnabled() || entry.action->menu() != nullptr) {
      continue;
    }
    const QString name =
        QString(entry.menu).remove('&') + " › " + QString(entry.action->text()).remove('&');
    if (const int score = scoreOf(name, text.trimmed()); score >= 0) {
      found.push_back({text.isEmpty() ? 0 : score, entry.action});
      entry.action->setProperty("paletteName", name);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [score, action] : found) {
    QString label = action->property("paletteName").toString();
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    if (!keys.isEmpty()) {
      label += "   [" + keys + "]";
    }
    auto* item = new QListWidgetItem(action->icon(), label, list_);
    item->setData(Qt::UserRole, action->objectName());
    item->setToolTip(action->statusTip());
  }
  list_->setCurrentRow(0);
}

void CommandPalette::run() {
  const QListWidgetItem* item = list_->currentItem();
  if (item == nullptr) {
    return;
  }
  QAction* action = catalog_.action(item->data(Qt::UserRole).toString());
  accept();
  // After the dialog is gone, so that focus and dialogs of the action are right.
  QTimer::singleShot(0, action, &QAction::trigger);
}

bool CommandPalette::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int row = list_->currentRow();
    if (key == Qt::Key_Down || key == Qt::Key_Up) {
      list_->setCurrentRow(std::clamp(row + (key == Qt::Key_Down ? 1 : -1), 0, list_->count() - 1));
      return true;
    }
  }
  return QDialog::eventFilter(object, event);
}

}  // namespace wcam::gui
