// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/view_state.hpp"

#include <QWidget>

namespace wcam::gui {

/// Vertical slider with two thumbs: the layers that are shown. Keys: ↑ ↓ move the chosen thumb,
/// Tab-free ← → choose it, Shift ×5, Home, End; X (in the window) shows a single layer.
class LayerSlider : public QWidget {
  Q_OBJECT

public:
  explicit LayerSlider(ViewState& state, QWidget* parent = nullptr);
  ~LayerSlider() override;

  [[nodiscard]] QSize sizeHint() const override { return {74, 300}; }

  [[nodiscard]] QSize minimumSizeHint() const override { return {74, 120}; }

  /// Where a thumb is, for tests and accessibility.
  [[nodiscard]] QPoint thumb(bool upper) const;

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  enum class Grip { None, Lower, Upper, Both };

  [[nodiscard]] double yOf(int layer) const;
  [[nodiscard]] int layerAt(double y) const;
  void setThumb(bool upper, int layer);

  ViewState& state_;
  int listener_ = 0;
  Grip grip_ = Grip::None;
  bool upperChosen_ = true;
  int gripLayer_ = 0;
  int gripLower_ = 0;
  int gripUpper_ = 0;
};

}  // namespace wcam::gui
