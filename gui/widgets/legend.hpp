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

  /// As narrow as its texts allow: it stands over the 3D view.
  [[nodiscard]] QSize sizeHint() const override;

  /// Width that the 3D view leaves free for it, whatever it shows, pixels.
  static constexpr int kReserved = 112;

signals:
  void chooseQuantity();

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
  [[nodiscard]] QString title() const;
  /// The texts below the title.
  [[nodiscard]] QStringList rows() const;

  ViewState& state_;
  Coloured colours_;
};

}  // namespace wcam::gui
