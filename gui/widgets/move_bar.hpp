// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/view_state.hpp"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace wcam::gui {

/// Playback of the moves of the shown layers: start, back, play or pause, forward, end, speed, and
/// a slider over the moves with time and place.
class MoveBar : public QWidget {
  Q_OBJECT

public:
  explicit MoveBar(ViewState& state, QWidget* parent = nullptr);
  ~MoveBar() override;
  /// Icons take the colours of the palette.
  void updateIcons();

private:
  void show(unsigned changes);

  ViewState& state_;
  int listener_ = 0;
  QToolButton* first_;
  QToolButton* back_;
  QToolButton* play_;
  QToolButton* forward_;
  QToolButton* last_;
  QComboBox* speed_;
  QSlider* slider_;
  QLabel* place_;
  QLabel* time_;
  QTimer tick_;
  QElapsedTimer clock_;
};

/// "1:02:03" or "2:03.4".
QString timeText(double seconds);

}  // namespace wcam::gui
