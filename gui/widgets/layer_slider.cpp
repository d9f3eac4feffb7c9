// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "layer_slider.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace wcam::gui {

namespace {

constexpr double kMargin = 36.0;
constexpr double kThumb = 8.0;
constexpr int kTrack = 22;  // x of the track

}  // namespace

LayerSlider::LayerSlider(ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setObjectName("layerSlider");
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Layers shown"));
  setToolTip(tr("Layers shown: drag the thumbs, or the bar between them; X shows a single layer"));
  listener_ = state_.listen([this](unsigned changes) {
    if ((changes & (ViewState::LayersChanged | ViewState::PathChanged)) != 0) {
      update();
    }
  });
}

LayerSlider::~LayerSlider() {
  state_.forget(listener_);
}

double LayerSlider::yOf(int layer) const {
  const int count = std::max(state_.layerCount() - 1, 1);
  return kMargin + (height() - 2.0 * kMargin) * (1.0 - static_cast<double>(layer) / count);
}

int LayerSlider::layerAt(double y) const {
  const int count = std::max(state_.layerCount() - 1, 1);
  const double t = 1.0 - (y - kMargin) / std::max(height() - 2.0 * kMargin, 1.0);
  return std::clamp(static_cast<int>(std::lround(t * count)), 0,
                    std::max(state_.layerCount() - 1, 0));
}

QPoint LayerSlider::thumb(bool upper) const {
  return {kTrack, static_cast<int>(std::lround(yOf(upper ? state_.upper() : state_.lower())))};
}

void LayerSlider::setThumb(bool upper, int layer) {
  if (state_.single()) {
    state_.setLayers(layer, layer);
  } else if (upper) {
    state_.setLayers(std::min(state_.lower(), layer), layer);
  } else {
    state_.setLayers(layer, std::max(state_.upper(), layer));
  }
}

void LayerSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor line = palette().color(QPalette::Mid);
  const QColor accent =
      isEnabled() && state_.layerCount() > 0 ? palette().color(QPalette::Highlight) : line;
  const double top = yOf(state_.upper());
  const double bottom = yOf(state_.lower());
  painter.setPen(Qt::NoPen);
  painter.setBrush(line);
  painter.drawRoundedRect(QRectF(kTrack - 2, kMargin, 4, height() - 2 * kMargin), 2, 2);
  if (state_.layerCount() == 0) {
    return;
  }
  painter.setBrush(accent);
  painter.drawRoundedRect(QRectF(kTrack - 3, top, 6, bottom - top), 3, 3);
  const auto drawThumb = [&](double y, int layer, bool chosen, bool above) {
    painter.setPen(QPen(palette().color(QPalette::Window), 2));
    painter.setBrush(accent);
    painter.drawEllipse(QPointF(kTrack, y), kThumb, kThumb);
    if (chosen && hasFocus()) {
      painter.setPen(QPen(accent, 1.5));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(QPointF(kTrack, y), kThumb + 3, kThumb + 3);
    }
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF box(kTrack + kThumb + 5, y - 9 + (above ? -4 : 4), width() - kTrack - kThumb - 6,
                     18);
    painter.drawText(box, Qt::AlignVCenter | Qt::AlignLeft, QString::number(layer + 1));
  };
  const bool apart = std::abs(bottom - top) > 1.0;
  if (!state_.single() && (apart || state_.lower() != state_.upper())) {
    drawThumb(bottom, state_.lower(), !upperChosen_, false);
  }
  drawThumb(top, state_.upper(), upperChosen_ || state_.single(), apart);
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(QRectF(0, 2, width(), 18), Qt::AlignCenter,
                   tr("%n layer(s)", nullptr, state_.layerCount()));
}

void LayerSlider::mousePressEvent(QMouseEvent* event) {
  if (state_.layerCount() == 0 || event->button() != Qt::LeftButton) {
    return;
  }
  const double y = event->position().y();
  const double toUpper = std::abs(y - yOf(state_.upper()));
  const double toLower = std::abs(y - yOf(state_.lower()));
  const double reach = kThumb + 4.0;
  if (state_.single() || (toUpper <= reach && toUpper <= toLower)) {
    grip_ = Grip::Upper;
  } else if (toLower <= reach) {
    grip_ = Grip::Lower;
  } else if (y > yOf(state_.upper()) && y < yOf(state_.lower()) &&
             state_.upper() - state_.lower() + 1 < state_.layerCount()) {
    grip_ = Grip::Both;
  } else {
    grip_ = toUpper <= toLower ? Grip::Upper : Grip::Lower;
    setThumb(grip_ == Grip::Upper, layerAt(y));
  }
  upperChosen_ = grip_ != Grip::Lower;
  gripLayer_ = layerAt(y);
  gripLower_ = state_.lower();
  gripUpper_ = state_.upper();
  update();
}

void LayerSlider::mouseMoveEvent(QMouseEvent* event) {
  if (grip_ == Grip::None) {
    return;
  }
  const int layer = layerAt(event->position().y());
  if (grip_ == Grip::Both) {
    const int shift =
        std::clamp(layer - gripLayer_, -gripLower_, state_.layerCount() - 1 - gripUpper_);
    state_.setLayers(gripLower_ + shift, gripUpper_ + shift);
  } else if (grip_ == Grip::Upper) {
    setThumb(true, state_.single() ? layer : std::max(layer, state_.lower()));
  } else {
    setThumb(false, std::min(layer, state_.upper()));
  }
}

void LayerSlider::mouseReleaseEvent(QMouseEvent*) {
  grip_ = Grip::None;
}

void LayerSlider::mouseDoubleClickEvent(QMouseEvent*) {
  if (!state_.single()) {
    state_.setLayers(0, state_.layerCount() - 1);
  }
}

void LayerSlider::wheelEvent(QWheelEvent* event) {
  const int step = event->angleDelta().y() > 0 ? 1 : -1;
  const int at = upperChosen_ || state_.single() ? state_.upper() : state_.lower();
  setThumb(upperChosen_, at + step);
  event->accept();
}

void LayerSlider::keyPressEvent(QKeyEvent* event) {
  const int step = (event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier)) != 0 ? 5 : 1;
  const bool upper = upperChosen_ || state_.single();
  const int at = upper ? state_.upper() : state_.lower();
  switch (event->key()) {
    case Qt::Key_Up:
      setThumb(upper, std::min(at + step, state_.layerCount() - 1));
      break;
    case Qt::Key_Down:
      setThumb(upper, std::max(at - step, 0));
      break;
    case Qt::Key_Left:
    case Qt::Key_Right:
      upperChosen_ = event->key() == Qt::Key_Left;
      break;
    case Qt::Key_Home:
      setThumb(upper, 0);
      break;
    case Qt::Key_End:
      setThumb(upper, state_.layerCount() - 1);
      break;
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  update();
}

}  // namespace wcam::gui
