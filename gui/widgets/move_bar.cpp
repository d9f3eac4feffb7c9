// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "move_bar.hpp"

#include "icons.hpp"
#include "text.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyleOptionSlider>
#include <QToolButton>

#include <algorithm>
#include <array>

namespace wcam::gui {

namespace {

constexpr int kFrameMs = 33;
constexpr std::array<int, 7> kSpeeds = {1, 2, 5, 10, 20, 50, 100};

/// A click on the groove goes to that place at once.
class JumpSlider : public QSlider {
public:
  using QSlider::QSlider;

protected:
  void mousePressEvent(QMouseEvent* event) override {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const QRect handle =
        style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
    if (event->button() == Qt::LeftButton && !handle.contains(event->position().toPoint())) {
      setValue(QStyle::sliderValueFromPosition(minimum(), maximum(),
                                               event->position().toPoint().x() - handle.width() / 2,
                                               width() - handle.width()));
    }
    QSlider::mousePressEvent(event);
  }
};

QToolButton* button(QWidget* parent, const char* name, const QString& tip) {
  auto* made = new QToolButton(parent);
  made->setObjectName(name);
  made->setToolTip(tip);
  made->setAccessibleName(tip);
  made->setAutoRaise(true);
  return made;
}

}  // namespace

QString timeText(double seconds) {
  const auto whole = static_cast<qint64>(seconds);
  if (whole >= 3600) {
    return QString("%1:%2:%3")
        .arg(whole / 3600)
        .arg(whole / 60 % 60, 2, 10, QChar('0'))
        .arg(whole % 60, 2, 10, QChar('0'));
  }
  return QString("%1:%2")
      .arg(whole / 60)
      .arg(figureText(seconds - static_cast<double>(whole / 60 * 60), 1), 4, QChar('0'));
}

MoveBar::MoveBar(ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setObjectName("moveBar");
  first_ = button(this, "moveFirst", tr("To the start"));
  back_ = button(this, "moveBack", tr("One move back"));
  play_ = button(this, "movePlay", tr("Play or pause (Space)"));
  forward_ = button(this, "moveForward", tr("One move forward"));
  last_ = button(this, "moveLast", tr("To the end"));
  back_->setAutoRepeat(true);
  forward_->setAutoRepeat(true);
  speed_ = new QComboBox(this);
  speed_->setObjectName("moveSpeed");
  speed_->setToolTip(tr("Speed of the playback"));
  speed_->setAccessibleName(speed_->toolTip());
  for (const int factor : kSpeeds) {
    speed_->addItem(QString("×%1").arg(factor), factor);
  }
  slider_ = new JumpSlider(Qt::Horizontal, this);
  slider_->setObjectName("moveSlider");
  slider_->setAccessibleName(tr("Move shown"));
  place_ = new QLabel(this);
  place_->setObjectName("movePlace");
  place_->setMinimumWidth(place_->fontMetrics().horizontalAdvance("88888 / 88888"));
  place_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  time_ = new QLabel(this);
  time_->setObjectName("moveTime");
  time_->setMinimumWidth(time_->fontMetrics().horizontalAdvance("8:88:88 / 8:88:88"));
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 3, 6, 3);
  layout->setSpacing(2);
  for (QToolButton* b : {first_, back_, play_, forward_, last_}) {
    layout->addWidget(b);
  }
  layout->addWidget(speed_);
  layout->addSpacing(6);
  layout->addWidget(slider_, 1);
  layout->addWidget(place_);
  layout->addSpacing(8);
  layout->addWidget(time_);
  updateIcons();

  connect(first_, &QToolButton::clicked, this, [this] { state_.setMove(state_.begin()); });
  connect(last_, &QToolButton::clicked, this, [this] { state_.setMove(state_.end()); });
  connect(back_, &QToolButton::clicked, this,
          [this] { state_.setMove(std::max(state_.move(), state_.begin() + 1) - 1); });
  connect(forward_, &QToolButton::clicked, this, [this] { state_.setMove(state_.move() + 1); });
  connect(play_, &QToolButton::clicked, this, [this] { state_.setPlaying(!state_.playing()); });
  connect(speed_, &QComboBox::activated, this,
          [this] { state_.setSpeed(speed_->currentData().toInt()); });
  connect(slider_, &QSlider::valueChanged, this, [this](int value) {
    state_.setPlaying(false);
    state_.setMove(static_cast<std::size_t>(value));
  });
  tick_.setInterval(kFrameMs);
  tick_.setTimerType(Qt::PreciseTimer);
  connect(&tick_, &QTimer::timeout, this,
          [this] { state_.advance(static_cast<double>(clock_.restart()) / 1000.0); });
  listener_ = state_.listen([this](unsigned changes) { show(changes); });
  show(~0U);
}

MoveBar::~MoveBar() {
  state_.forget(listener_);
}

void MoveBar::updateIcons() {
  first_->setIcon(icon("first"));
  back_->setIcon(icon("back"));
  play_->setIcon(icon(state_.playing() ? "pause" : "play"));
  forward_->setIcon(icon("forward"));
  last_->setIcon(icon("last"));
}

void MoveBar::show(unsigned changes) {
  const bool has = state_.path() && state_.path()->size() > 0;
  setEnabled(has);
  if ((changes & ViewState::PlayingChanged) != 0) {
    play_->setIcon(icon(state_.playing() ? "pause" : "play"));
    if (state_.playing() && !tick_.isActive()) {
      clock_.start();
      tick_.start();
    } else if (!state_.playing()) {
      tick_.stop();
    }
    const int index = speed_->findData(static_cast<int>(state_.speed()));
    speed_->setCurrentIndex(index);
  }
  const QSignalBlocker block(slider_);
  if (!has) {
    slider_->setRange(0, 0);
    place_->clear();
    time_->clear();
    return;
  }
  slider_->setRange(static_cast<int>(state_.begin()), static_cast<int>(state_.end()) - 1);
  slider_->setPageStep(std::max(static_cast<int>(state_.end() - state_.begin()) / 20, 1));
  slider_->setValue(static_cast<int>(state_.move()));
  place_->setText(QString("%1 / %2")
                      .arg(state_.move() - state_.begin() + 1)
                      .arg(state_.end() - state_.begin()));
  time_->setText(
      QString("%1 / %2").arg(timeText(state_.time()), timeText(state_.path()->totalTime())));
}

}  // namespace wcam::gui
