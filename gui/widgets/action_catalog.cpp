// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "action_catalog.hpp"

#include "icons.hpp"

#include <QMenu>
#include <QMenuBar>

namespace wcam::gui {

QAction* ActionCatalog::add(const QString& id,
                            const QString& menu,
                            const QString& text,
                            const QString& help,
                            const QString& shortcut,
                            const QString& icon,
                            const std::function<void()>& run) {
  auto* action = new QAction(text, this);
  action->setObjectName(id);
  action->setStatusTip(help);
  if (!shortcut.isEmpty()) {
    action->setShortcut(QKeySequence::fromString(shortcut, QKeySequence::PortableText));
  }
  const QString plain = QString(text).remove('&').remove("…");
  const QString keys = action->shortcut().toString(QKeySequence::NativeText);
  action->setToolTip(QString("<b>%1</b>%2<br/>%3")
                         .arg(plain.toHtmlEscaped(), keys.isEmpty() ? QString() : " (" + keys + ")",
                              help.toHtmlEscaped()));
  // "icon" is a property of QAction itself.
  action->setProperty("iconName", icon);
  if (!icon.isEmpty()) {
    action->setIcon(gui::icon(icon));
  }
  if (run) {
    connect(action, &QAction::triggered, this, [this, id, run] {
      if (before_) {
        before_(id);
      }
      run();
    });
  }
  entries_.push_back({id, menu, action});
  return action;
}

void ActionCatalog::separate(const QString& menu) {
  auto* line = new QAction(this);
  line->setSeparator(true);
  entries_.push_back({QString(), menu, line});
}

QAction* ActionCatalog::action(const QString& id) const {
  for (const Entry& entry : entries_) {
    if (entry.id == id) {
      return entry.action;
    }
  }
  return nullptr;
}

QAction* ActionCatalog::actionOf(const QKeySequence& keys) const {
  for (const Entry& entry : entries_) {
    if (entry.action->isEnabled() && !keys.isEmpty() && entry.action->shortcuts().contains(keys)) {
      return entry.action;
    }
  }
  return nullptr;
}

void ActionCatalog::fill(QMenuBar& bar) const {
  for (const Entry& entry : entries_) {
    QMenu*& menu = menus_[entry.menu];
    if (menu == nullptr) {
      menu = bar.addMenu(entry.menu);
      menu->setToolTipsVisible(false);
    }
    menu->addAction(entry.action);
  }
}

QMenu* ActionCatalog::menu(const QString& title) const {
  const auto found = menus_.find(title);
  return found != menus_.end() ? found->second : nullptr;
}

void ActionCatalog::updateIcons() const {
  for (const Entry& entry : entries_) {
    const QString name = entry.action->property("iconName").toString();
    if (!name.isEmpty()) {
      entry.action->setIcon(gui::icon(name));
    }
  }
}

}  // namespace wcam::gui
