// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "theme.hpp"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace wcam::gui {

namespace {

QPalette paletteOf(bool dark) {
  const QColor window = dark ? QColor(37, 41, 48) : QColor(243, 245, 248);
  const QColor base = dark ? QColor(28, 31, 37) : QColor(255, 255, 255);
  const QColor other = dark ? QColor(33, 37, 44) : QColor(247, 249, 251);
  const QColor text = dark ? QColor(226, 230, 236) : QColor(32, 38, 46);
  const QColor button = dark ? QColor(48, 53, 62) : QColor(250, 251, 253);
  const QColor accent = dark ? QColor(74, 150, 230) : QColor(28, 112, 200);
  const QColor grey = dark ? QColor(122, 130, 140) : QColor(150, 157, 166);
  QPalette palette(text, button, dark ? QColor(70, 76, 86) : QColor(255, 255, 255),
                   dark ? QColor(20, 22, 26) : QColor(160, 166, 174),
                   dark ? QColor(78, 85, 96) : QColor(190, 196, 204), text, Qt::white, base,
                   window);
  palette.setColor(QPalette::AlternateBase, other);
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, accent);
  palette.setColor(QPalette::ToolTipBase, dark ? QColor(58, 64, 74) : QColor(255, 255, 255));
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::PlaceholderText, grey);
  for (const auto role : {QPalette::Text, QPalette::WindowText, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, grey);
  }
  return palette;
}

// The list of a combo box is a list, not a menu: with a style sheet Fusion draws the chosen entry
// of such a menu white on white.
constexpr const char* kSheet = R"(
QToolTip { padding: 4px; border: 1px solid palette(mid); }
QMainWindow::separator { width: 4px; height: 4px; background: palette(window); }
QDockWidget { titlebar-close-icon: none; titlebar-normal-icon: none; }
QDockWidget::title { padding: 5px 8px; background: palette(window); font-weight: bold; }
QTreeView { border: none; show-decoration-selected: 1; }
QTreeView::item { padding: 3px 2px; }
QTableView { border: none; }
QHeaderView::section { padding: 3px 6px; border: none; border-bottom: 1px solid palette(mid); background: palette(window); }
QLineEdit, QComboBox { padding: 2px 5px; border: 1px solid palette(mid); border-radius: 4px; background: palette(base); min-height: 18px; }
QLineEdit:focus, QComboBox:focus { border: 1px solid palette(highlight); }
QLineEdit:disabled { background: palette(window); }
QComboBox { combobox-popup: 0; }
QComboBox QAbstractItemView { border: 1px solid palette(mid); background: palette(base); color: palette(text); selection-background-color: palette(highlight); selection-color: palette(highlighted-text); }
QToolBar { border: none; border-bottom: 1px solid palette(mid); spacing: 3px; padding: 3px; }
QToolBar QToolButton { padding: 4px; border-radius: 4px; border: 1px solid transparent; }
QToolBar QToolButton:hover { background: palette(base); border: 1px solid palette(mid); }
QToolBar QToolButton:checked { background: palette(base); border: 1px solid palette(highlight); }
QToolButton#formGroup { border: none; border-bottom: 1px solid palette(mid); padding: 4px 0px; font-weight: bold; text-align: left; }
QLabel#formError { color: #d0342c; padding-left: 2px; }
QLabel#formUnit { color: palette(placeholder-text); }
QStatusBar { border-top: 1px solid palette(mid); }
QStatusBar::item { border: none; }
QProgressBar { border: 1px solid palette(mid); border-radius: 4px; text-align: center; max-height: 16px; }
QProgressBar::chunk { background: palette(highlight); border-radius: 3px; }
QTabBar::tab { padding: 5px 12px; }
QMenu::item { padding: 4px 28px 4px 22px; }
)";

}  // namespace

bool systemIsDark() {
  return QApplication::palette().color(QPalette::Window).lightness() < 128;
}

void applyTheme(bool dark) {
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  const QPalette palette = paletteOf(dark);
  QApplication::setPalette(palette);
  // The style sheet knows no role for placeholders in Qt 6.4.
  QString sheet = kSheet;
  sheet.replace("palette(placeholder-text)", palette.color(QPalette::PlaceholderText).name());
  qApp->setStyleSheet(sheet);
}

}  // namespace wcam::gui
