// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "plot.hpp"

#include "wcam/base/quantity.hpp"

#include "text.hpp"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wcam::gui {

namespace {

const std::array<QColor, 8> kCurves = {
    QColor(52, 130, 210),  QColor(230, 140, 40), QColor(80, 170, 90),   QColor(205, 70, 75),
    QColor(145, 105, 190), QColor(150, 110, 90), QColor(220, 120, 185), QColor(110, 120, 130)};
const QColor kLimit(208, 52, 44);

/// A round step that cuts a span into about `count` parts.
double stepOf(double span, int count) {
  const double raw = span / std::max(count, 1);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

/// Multiples of a step from low to high; few, whatever the numbers.
std::vector<double> ticks(double low, double high, double step) {
  constexpr int kMostTicks = 1000;
  std::vector<double> values;
  const double first = std::ceil(low / step);
  for (int i = 0; i < kMostTicks && (first + i) * step <= high; ++i) {
    values.push_back((first + i) * step);
  }
  return values;
}

}  // namespace

Plot::Plot(QWidget* parent) : QWidget(parent) {
  setMinimumHeight(80);
  setFocusPolicy(Qt::ClickFocus);
  setCursor(Qt::CrossCursor);
}

void Plot::setData(std::vector<double> times, std::vector<Series> series, const QString& unit) {
  const bool same =
      times.size() == times_.size() && !times.empty() && times.back() == times_.back();
  times_ = std::move(times);
  series_ = std::move(series);
  unit_ = unit;
  low_ = std::numeric_limits<double>::infinity();
  high_ = -low_;
  for (const Series& s : series_) {
    for (const float v : s.values) {
      if (std::isfinite(v)) {
        low_ = std::min(low_, static_cast<double>(v));
        high_ = std::max(high_, static_cast<double>(v));
      }
    }
  }
  if (!(low_ <= high_)) {
    low_ = 0.0;
    high_ = 1.0;
  }
  // Limits are shown when the curve comes near them.
  for (const Series& s : series_) {
    if (s.limits) {
      const double reach = 0.6 * (high_ - low_);
      if (std::isfinite(s.limits->first) && s.limits->first > low_ - reach) {
        low_ = std::min(low_, static_cast<double>(s.limits->first));
      }
      if (std::isfinite(s.limits->second) && s.limits->second < high_ + reach) {
        high_ = std::max(high_, static_cast<double>(s.limits->second));
      }
    }
  }
  const double margin = high_ > low_ ? 0.08 * (high_ - low_) : std::max(std::abs(high_) * 0.1, 0.5);
  low_ -= margin;
  high_ += margin;
  if (!same) {
    showAll();
  }
  dirty_ = true;
  update();
}

void Plot::showAll() {
  from_ = times_.empty() ? 0.0 : times_.front();
  to_ = times_.empty() ? 1.0 : std::max(times_.back(), from_ + 1e-6);
  dirty_ = true;
  update();
}

void Plot::setCursorTime(double time) {
  cursor_ = time;
  update();
}

QRectF Plot::area() const {
  return QRectF(rect()).adjusted(58, 8, -12, -24);
}

double Plot::xOf(double time) const {
  const QRectF box = area();
  return box.left() + (time - from_) / (to_ - from_) * box.width();
}

double Plot::timeAt(double x) const {
  const QRectF box = area();
  return from_ + (x - box.left()) / std::max(box.width(), 1.0) * (to_ - from_);
}

void Plot::draw() {
  const double ratio = devicePixelRatioF();
  picture_ = QPixmap((QSizeF(size()) * ratio).toSize());
  picture_.setDevicePixelRatio(ratio);
  picture_.fill(palette().color(QPalette::Base));
  dirty_ = false;
  QPainter painter(&picture_);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF box = area();
  const QColor grid = palette().color(QPalette::Mid);
  const QColor text = palette().color(QPalette::Text);
  const auto yOf = [&](double v) {
    return box.bottom() - (v - low_) / (high_ - low_) * box.height();
  };
  QColor faint = grid;
  faint.setAlpha(90);
  const double yStep = stepOf(high_ - low_, std::max(static_cast<int>(box.height() / 34), 2));
  for (const double v : ticks(low_, high_, yStep)) {
    painter.setPen(faint);
    painter.drawLine(QPointF(box.left(), yOf(v)), QPointF(box.right(), yOf(v)));
    painter.setPen(text);
    painter.drawText(QRectF(0, yOf(v) - 9, box.left() - 6, 18), Qt::AlignRight | Qt::AlignVCenter,
                     shortFigure(std::abs(v) < 1e-9 * yStep ? 0.0 : v, 5));
  }
  const double xStep = stepOf(to_ - from_, std::max(static_cast<int>(box.width() / 110), 2));
  for (const double t : ticks(from_, to_, xStep)) {
    painter.setPen(faint);
    painter.drawLine(QPointF(xOf(t), box.top()), QPointF(xOf(t), box.bottom()));
    painter.setPen(text);
    painter.drawText(QRectF(xOf(t) - 50, box.bottom() + 4, 100, 18),
                     Qt::AlignHCenter | Qt::AlignTop, shortFigure(t, 6) + " s");
  }
  painter.setPen(text);
  painter.drawText(QRectF(2, 0, box.left() - 8, 16), Qt::AlignLeft, unit_);
  painter.setClipRect(box);
  for (const Series& s : series_) {
    if (s.limits) {
      painter.setPen(QPen(kLimit, 1.2, Qt::DashLine));
      for (const float limit : {s.limits->first, s.limits->second}) {
        if (std::isfinite(limit)) {
          painter.drawLine(QPointF(box.left(), yOf(limit)), QPointF(box.right(), yOf(limit)));
        }
      }
    }
  }
  const auto first = static_cast<std::size_t>(
      std::lower_bound(times_.begin(), times_.end(), from_) - times_.begin());
  const auto last = static_cast<std::size_t>(std::upper_bound(times_.begin(), times_.end(), to_) -
                                             times_.begin());
  for (const Series& s : series_) {
    painter.setPen(QPen(s.colour, 1.5));
    QPainterPath path;
    bool open = false;
    // Of all points in a pixel column the lowest and the highest are drawn.
    long column = std::numeric_limits<long>::min();
    double lowest = 0.0;
    double highest = 0.0;
    double lastX = 0.0;
    const auto put = [&](double x, double y) {
      if (open) {
        path.lineTo(x, y);
      } else {
        path.moveTo(x, y);
      }
      open = true;
    };
    const auto flush = [&] {
      if (column != std::numeric_limits<long>::min()) {
        put(lastX, yOf(lowest));
        if (highest > lowest) {
          put(lastX, yOf(highest));
        }
      }
      column = std::numeric_limits<long>::min();
    };
    for (std::size_t i = first > 0 ? first - 1 : 0; i < std::min(last + 1, s.values.size()); ++i) {
      const double v = s.values[i];
      if (!std::isfinite(v)) {
        flush();
        open = false;
        continue;
      }
      const double x = xOf(times_[i]);
      const long here = std::lround(x);
      if (here != column) {
        flush();
        column = here;
        lowest = highest = v;
        lastX = x;
      } else {
        lowest = std::min(lowest, v);
        highest = std::max(highest, v);
      }
    }
    flush();
    painter.drawPath(path);
  }
  painter.setClipping(false);
  painter.setPen(grid);
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(box);
  double x = box.left() + 8;
  for (const Series& s : series_) {
    painter.setPen(QPen(s.colour, 3));
    painter.drawLine(QPointF(x, box.top() + 10), QPointF(x + 14, box.top() + 10));
    painter.setPen(text);
    const double w = painter.fontMetrics().horizontalAdvance(s.name);
    painter.drawText(QRectF(x + 19, box.top() + 1, w + 4, 18), Qt::AlignVCenter, s.name);
    x += w + 36;
  }
}

void Plot::paintEvent(QPaintEvent*) {
  if (dirty_) {
    draw();
  }
  QPainter painter(this);
  painter.drawPixmap(0, 0, picture_);
  const QRectF box = area();
  const double x = xOf(cursor_);
  if (!times_.empty() && x >= box.left() && x <= box.right()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
    painter.drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
    const auto at = static_cast<std::size_t>(
        std::lower_bound(times_.begin(), times_.end(), cursor_ - 1e-9) - times_.begin());
    QStringList values;
    for (const Series& s : series_) {
      if (at < s.values.size() && std::isfinite(s.values[at])) {
        values.append(QString::number(static_cast<double>(s.values[at]), 'f', 2));
      }
    }
    if (!values.isEmpty()) {
      const QString label = values.join(" · ") + " " + unit_;
      const double w = painter.fontMetrics().horizontalAdvance(label) + 10;
      const double left = std::clamp(x + 6, box.left(), std::max(box.right() - w, box.left()));
      painter.setBrush(palette().color(QPalette::ToolTipBase));
      painter.setPen(palette().color(QPalette::Mid));
      painter.drawRoundedRect(QRectF(left, box.bottom() - 24, w, 20), 3, 3);
      painter.setPen(palette().color(QPalette::ToolTipText));
      painter.drawText(QRectF(left, box.bottom() - 24, w, 20), Qt::AlignCenter, label);
    }
  }
}

void Plot::resizeEvent(QResizeEvent*) {
  dirty_ = true;
}

void Plot::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) {
    dirty_ = true;
    update();
  }
  QWidget::changeEvent(event);
}

void Plot::wheelEvent(QWheelEvent* event) {
  if (times_.empty()) {
    return;
  }
  const double factor = std::pow(0.998, event->angleDelta().y());
  const double t = timeAt(event->position().x());
  from_ = std::max(t + (from_ - t) * factor, times_.front());
  to_ = std::min(std::max(t + (to_ - t) * factor, from_ + 1e-3), times_.back());
  dirty_ = true;
  update();
}

void Plot::mousePressEvent(QMouseEvent* event) {
  pressedX_ = lastX_ = event->position().x();
  dragged_ = false;
}

void Plot::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton || times_.empty()) {
    return;
  }
  const double x = event->position().x();
  if (!dragged_ && std::abs(x - pressedX_) < 4.0) {
    return;
  }
  dragged_ = true;
  const double shift =
      std::clamp(timeAt(lastX_) - timeAt(x), times_.front() - from_, times_.back() - to_);
  from_ += shift;
  to_ += shift;
  lastX_ = x;
  dirty_ = true;
  update();
}

void Plot::mouseReleaseEvent(QMouseEvent* event) {
  if (!dragged_ && !times_.empty()) {
    emit picked(std::clamp(timeAt(event->position().x()), times_.front(), times_.back()));
  }
}

void Plot::mouseDoubleClickEvent(QMouseEvent*) {
  showAll();
}

// --- joints

namespace {

std::vector<double> timesOf(const PathModel& path) {
  std::vector<double> times(path.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] = path.time(i);
  }
  return times;
}

/// Degrees of a joint that turns, mm of one that slides.
double jointUnit(const cell::Joint& joint) {
  return joint.prismatic() ? 1.0 : radToDeg(1.0);
}

/// Position (0), speed (1) or acceleration (2) of a joint in degrees and seconds.
std::vector<float> jointValues(const PathModel& path, int joint, int kind) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> values(path.size(), kNone);
  const double unit = jointUnit(path.result().cell->joint(joint));
  const auto angle = [&](std::size_t i) { return unit * path.waypoint(i)->joints[joint]; };
  const auto speed = [&](std::size_t i) {
    const double dt = path.time(i) - path.time(i - 1);
    return dt > 1e-9 ? (angle(i) - angle(i - 1)) / dt : std::numeric_limits<double>::quiet_NaN();
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path.waypoint(i) == nullptr) {
      continue;
    }
    if (kind == 0) {
      values[i] = static_cast<float>(angle(i));
    } else if (kind == 1 && i > 0) {
      values[i] = static_cast<float>(speed(i));
    } else if (kind == 2 && i > 1) {
      const double dt = 0.5 * (path.time(i) - path.time(i - 2));
      values[i] = dt > 1e-9 ? static_cast<float>((speed(i) - speed(i - 1)) / dt) : kNone;
    }
  }
  return values;
}

std::pair<float, float> jointLimits(const cell::Joint& joint, int kind) {
  const double unit = jointUnit(joint);
  if (kind == 0) {
    return {static_cast<float>(unit * joint.min), static_cast<float>(unit * joint.max)};
  }
  const auto most = static_cast<float>(unit * (kind == 1 ? joint.maxSpeed : joint.maxAcceleration));
  return {-most, most};
}

}  // namespace

JointPlot::JointPlot(ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setObjectName("jointPlot");
  kind_ = new QComboBox(this);
  kind_->setAccessibleName(tr("What is plotted"));
  kind_->addItems({tr("Position"), tr("Speed"), tr("Acceleration")});
  joint_ = new QComboBox(this);
  joint_->setAccessibleName(tr("Joint"));
  plot_ = new Plot(this);
  auto* side = new QVBoxLayout;
  side->addWidget(kind_);
  side->addWidget(joint_);
  side->addStretch(1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->addLayout(side);
  layout->addWidget(plot_, 1);
  const auto again = [this] {
    dirty_ = true;
    rebuild();
  };
  connect(kind_, &QComboBox::activated, this, again);
  connect(joint_, &QComboBox::activated, this, again);
  connect(plot_, &Plot::picked, this, [this](double time) {
    if (state_.path()) {
      state_.jumpTo(state_.path()->moveAt(time));
    }
  });
  listener_ = state_.listen([this](unsigned changes) {
    if ((changes & ViewState::PathChanged) != 0) {
      dirty_ = true;
      if (isVisible()) {
        rebuild();
      }
    }
    plot_->setCursorTime(state_.time());
  });
}

JointPlot::~JointPlot() {
  state_.forget(listener_);
}

void JointPlot::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  rebuild();
}

void JointPlot::rebuild() {
  if (!dirty_) {
    return;
  }
  dirty_ = false;
  const auto path = state_.path();
  const cell::Cell* cell = path ? path->result().cell.get() : nullptr;
  if (cell == nullptr || path->size() == 0 || path->waypoint(0) == nullptr) {
    plot_->setData({}, {}, {});
    return;
  }
  if (joint_->count() != cell->jointCount() + 1) {
    joint_->clear();
    joint_->addItem(tr("All, % of limits"));
    for (int j = 0; j < cell->jointCount(); ++j) {
      joint_->addItem(qt(cell->joint(j).name));
    }
  }
  const int kind = kind_->currentIndex();
  static const std::array<const char*, 3> kTurning = {"°", "°/s", "°/s²"};
  static const std::array<const char*, 3> kSliding = {"mm", "mm/s", "mm/s²"};
  std::vector<Series> series;
  if (joint_->currentIndex() > 0) {
    const int j = joint_->currentIndex() - 1;
    series.push_back({qt(cell->joint(j).name),
                      kCurves[static_cast<std::size_t>(j) % kCurves.size()],
                      jointValues(*path, j, kind), jointLimits(cell->joint(j), kind)});
    plot_->setData(
        timesOf(*path), std::move(series),
        (cell->joint(j).prismatic() ? kSliding : kTurning)[static_cast<std::size_t>(kind)]);
  } else {
    for (int j = 0; j < cell->jointCount(); ++j) {
      const auto limits = jointLimits(cell->joint(j), kind);
      std::vector<float> values = jointValues(*path, j, kind);
      const float middle = 0.5F * (limits.first + limits.second);
      const float half = 0.5F * (limits.second - limits.first);
      if (!std::isfinite(half) || half <= 0.0F) {
        continue;  // endless, or not known
      }
      for (float& v : values) {
        v = 100.0F * (v - middle) / half;
      }
      series.push_back({qt(cell->joint(j).name),
                        kCurves[static_cast<std::size_t>(j) % kCurves.size()], std::move(values),
                        std::pair(-100.0F, 100.0F)});
    }
    plot_->setData(timesOf(*path), std::move(series), "%");
  }
  plot_->setCursorTime(state_.time());
}

// --- process

ProcessPlot::ProcessPlot(ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setObjectName("processPlot");
  kind_ = new QComboBox(this);
  kind_->setAccessibleName(tr("What is plotted"));
  kind_->addItems({tr("Height and distance"), tr("Travel and TCP speed"), tr("Wire feed"),
                   tr("Bead width"), tr("Tilt and overhang"), tr("Margins")});
  plot_ = new Plot(this);
  auto* side = new QVBoxLayout;
  side->addWidget(kind_);
  side->addStretch(1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->addLayout(side);
  layout->addWidget(plot_, 1);
  connect(kind_, &QComboBox::activated, this, [this] {
    dirty_ = true;
    rebuild();
  });
  connect(plot_, &Plot::picked, this, [this](double time) {
    if (state_.path()) {
      state_.jumpTo(state_.path()->moveAt(time));
    }
  });
  listener_ = state_.listen([this](unsigned changes) {
    if ((changes & ViewState::PathChanged) != 0) {
      dirty_ = true;
      if (isVisible()) {
        rebuild();
      }
    }
    plot_->setCursorTime(state_.time());
  });
}

ProcessPlot::~ProcessPlot() {
  state_.forget(listener_);
}

void ProcessPlot::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  rebuild();
}

void ProcessPlot::rebuild() {
  if (!dirty_) {
    return;
  }
  dirty_ = false;
  const auto path = state_.path();
  if (!path || path->size() == 0) {
    plot_->setData({}, {}, {});
    return;
  }
  static const std::array<std::vector<Quantity>, 6> kShown = {
      {{Quantity::Height, Quantity::Distance},
       {Quantity::TravelSpeed, Quantity::TcpSpeed},
       {Quantity::WireSpeed},
       {Quantity::Width},
       {Quantity::Tilt, Quantity::Overhang},
       {Quantity::LimitMargin, Quantity::Singularity}}};
  const process::ProcessParams& process = path->result().process;
  std::vector<Series> series;
  const auto& shown = kShown[static_cast<std::size_t>(kind_->currentIndex())];
  for (const Quantity quantity : shown) {
    Series s{nameOf(quantity), kCurves[series.size()], path->values(quantity), {}};
    if (quantity == Quantity::Height) {
      s.limits = {static_cast<float>(process.heightMin.value()),
                  static_cast<float>(process.heightMax.value())};
    } else if (quantity == Quantity::TravelSpeed) {
      s.limits = {static_cast<float>(process.speedMin.value()),
                  static_cast<float>(process.speedMax.value())};
    }
    series.push_back(std::move(s));
  }
  plot_->setData(timesOf(*path), std::move(series), qt(unitOf(shown.front())));
  plot_->setCursorTime(state_.time());
}

}  // namespace wcam::gui
