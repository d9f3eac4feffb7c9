// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/view_state.hpp"

#include <QPixmap>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QComboBox;

namespace wcam::gui {

/// A curve of a plot. NaN leaves a gap.
struct Series {
  QString name;
  QColor colour;
  std::vector<float> values;
  std::optional<std::pair<float, float>> limits;  ///< drawn as a band that must be kept
};

/// Curves over time, drawn by pixel columns so that a million points stay fluid. Wheel zooms, a
/// drag moves, a double click shows everything; a click chooses a time.
class Plot : public QWidget {
  Q_OBJECT

public:
  explicit Plot(QWidget* parent = nullptr);
  void setData(std::vector<double> times, std::vector<Series> series, const QString& unit);
  void setCursorTime(double time);
  void showAll();

  [[nodiscard]] const std::vector<Series>& series() const { return series_; }

signals:
  void picked(double time);

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
  void draw();
  [[nodiscard]] QRectF area() const;
  [[nodiscard]] double xOf(double time) const;
  [[nodiscard]] double timeAt(double x) const;

  std::vector<double> times_;
  std::vector<Series> series_;
  QString unit_;
  double from_ = 0.0;
  double to_ = 1.0;
  double low_ = 0.0;
  double high_ = 1.0;
  double cursor_ = 0.0;
  QPixmap picture_;
  bool dirty_ = true;
  double pressedX_ = 0.0;
  double lastX_ = 0.0;
  bool dragged_ = false;
};

/// Joints over time against their limits: position, speed, acceleration; one joint, or all as a
/// share of their limits.
class JointPlot : public QWidget {
  Q_OBJECT

public:
  explicit JointPlot(ViewState& state, QWidget* parent = nullptr);
  ~JointPlot() override;

  [[nodiscard]] Plot& plot() { return *plot_; }

protected:
  void showEvent(QShowEvent* event) override;

private:
  void rebuild();

  ViewState& state_;
  int listener_ = 0;
  QComboBox* kind_;
  QComboBox* joint_;
  Plot* plot_;
  bool dirty_ = true;
};

/// Process over time: bead height and width, travel and predicted TCP speed, wire feed.
class ProcessPlot : public QWidget {
  Q_OBJECT

public:
  explicit ProcessPlot(ViewState& state, QWidget* parent = nullptr);
  ~ProcessPlot() override;

  [[nodiscard]] Plot& plot() { return *plot_; }

protected:
  void showEvent(QShowEvent* event) override;

private:
  void rebuild();

  ViewState& state_;
  int listener_ = 0;
  QComboBox* kind_;
  Plot* plot_;
  bool dirty_ = true;
};

}  // namespace wcam::gui
