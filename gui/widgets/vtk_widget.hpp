// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/view.hpp"

#include <QOpenGLFramebufferObject>
#include <QOpenGLWidget>
#include <QPoint>
#include <QTimer>

#include <memory>

namespace wcam::gui {

/// The 3D view in a Qt window: gives the context, copies the picture, turns mouse and keys into
/// camera moves and picks. The recipe of DESIGN 12.
class VtkWidget : public QOpenGLWidget {
  Q_OBJECT

public:
  explicit VtkWidget(QWidget* parent = nullptr);
  ~VtkWidget() override;

  [[nodiscard]] viewport::View& view() { return *view_; }

  [[nodiscard]] viewport::Scene& scene() { return view_->scene(); }

  /// Draws soon; many calls make one picture. A scene that takes long is drawn in portions between
  /// events, while the picture before stays; when it changes again meanwhile, a coarse picture is
  /// shown until it rests.
  void redraw() { request(false); }

  /// What clicks and hovering look for.
  void setWanted(viewport::View::Wanted wanted) { wanted_ = wanted; }

  /// The present picture in full detail. Needs a shown window.
  [[nodiscard]] QImage picture();

  /// Surface format that QApplication needs before it starts.
  static void prepareFormat();

signals:
  /// A click without a drag.
  void clicked(const viewport::Pick& pick, Qt::KeyboardModifiers modifiers);
  /// The mouse rests on something; kind None when it left.
  void hovered(const viewport::Pick& pick, const QPoint& global);
  void contextMenuAt(const viewport::Pick& pick, const QPoint& global);
  void painted();

protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

private:
  void release();
  /// @param moving more pictures will follow at once
  void request(bool moving);
  /// Draws the scene or a portion of it. A timer calls this, so that never one event has to draw
  /// the scene and the window as well.
  void draw();
  /// Draws what fits into one frame. @return false when the picture has to come in portions
  bool drawWhole();
  /// Keeps what was drawn, for this widget to be painted with.
  void keep();
  [[nodiscard]] QSize pixels() const;
  [[nodiscard]] viewport::Pick pickAt(const QPointF& at) const;

  std::unique_ptr<viewport::View> view_;
  viewport::View::Wanted wanted_;
  QPointF last_;
  QPointF pressed_;
  bool dragged_ = false;
  QTimer hover_;
  QTimer still_;  ///< until a coarse picture becomes a fine one
  QTimer draw_;
  QTimer compose_;  ///< shows what was drawn, in a turn of the event loop of its own
  std::unique_ptr<QOpenGLFramebufferObject> shown_;
  bool changed_ = true;  ///< the picture is not that of the scene
  bool moving_ = false;
  bool portions_ = false;  ///< a picture is being drawn in portions
  QMetaObject::Connection contextGone_;
};

}  // namespace wcam::gui
