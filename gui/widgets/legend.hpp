// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/colours.hpp"
#include "model/view_state.hpp"

#include <QWidget>

namespace wcam::gui {

/// What the colours mean, over the 3D view. A double click edits the range, a click in the title
/// chooses another quantity.
class Legend : public QWidget {
  Q_OBJECT

public:
  explicit Legend(ViewState& state, QWidget* parent = nullptr);
  void setColours(const Coloured& colours);
  /// Asks for limits; empty texts bring back those of the values.
  void editRange();

  [[nodiscard]] QSize sizeHint() const override;

signals:
  void chooseQuantity();

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
  ViewState& state_;
  Coloured colours_;
};

}  // namespace wcam::gui
