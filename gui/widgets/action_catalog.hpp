// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QObject>
#include <QString>

#include <functional>
#include <map>
#include <utility>
#include <vector>

class QMenuBar;
class QMenu;

namespace wcam::gui {

/// Every action of the program with its id, text and keys: menus, tool bar, command palette and the
/// test of the keyboard come from it.
class ActionCatalog : public QObject {
  Q_OBJECT

public:
  using QObject::QObject;

  struct Entry {
    QString id;    ///< "file.open", stable
    QString menu;  ///< title of the menu
    QAction* action = nullptr;
  };

  /// @param icon name for icon(), may be empty
  QAction* add(const QString& id,
               const QString& menu,
               const QString& text,
               const QString& help,
               const QString& shortcut,
               const QString& icon,
               const std::function<void()>& run);

  /// Called with the id of an action before it runs.
  void setBefore(std::function<void(const QString& id)> before) { before_ = std::move(before); }

  /// An enabled action of the menus with these keys; null when there is none.
  [[nodiscard]] QAction* actionOf(const QKeySequence& keys) const;

  /// A line between the entries of a menu.
  void separate(const QString& menu);

  [[nodiscard]] QAction* action(const QString& id) const;

  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

  /// Fills a menu bar, one menu per title in the order of their first entries.
  void fill(QMenuBar& bar) const;
  [[nodiscard]] QMenu* menu(const QString& title) const;
  /// Icons take the colours of the palette.
  void updateIcons() const;

private:
  std::vector<Entry> entries_;
  std::function<void(const QString&)> before_;
  mutable std::map<QString, QMenu*> menus_;
};

}  // namespace wcam::gui
