// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vtk_widget.hpp"

#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QSurfaceFormat>
#include <QWheelEvent>

#include <cmath>

namespace wcam::gui {

namespace {

// A press that moves less is a click, pixels.
constexpr double kClickReach = 4.0;
constexpr int kHoverMs = 120;
constexpr int kStillMs = 250;
// What was drawn in less is shown in the same turn of the event loop, ms.
constexpr int kQuickMs = 15;
constexpr int kComposeMs = 4;
// Results change other widgets as well: those are painted first, in a turn of their own, ms.
constexpr int kAfterMs = 5;
constexpr int kPortionMs = 1;
constexpr double kKeyTurn = 30.0;  // pixels of the mouse that an arrow key stands for

}  // namespace

void VtkWidget::prepareFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
}

VtkWidget::VtkWidget(QWidget* parent)
    : QOpenGLWidget(parent), view_(std::make_unique<viewport::View>()) {
  setObjectName("viewport");
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(240, 180);
  setAccessibleName(tr("3D view"));
  hover_.setSingleShot(true);
  hover_.setInterval(kHoverMs);
  connect(&hover_, &QTimer::timeout, this,
          [this] { emit hovered(pickAt(last_), mapToGlobal(last_.toPoint())); });
  still_.setSingleShot(true);
  still_.setInterval(kStillMs);
  compose_.setSingleShot(true);
  compose_.setInterval(kComposeMs);
  connect(&compose_, &QTimer::timeout, this, qOverload<>(&QWidget::update));
  draw_.setSingleShot(true);
  connect(&draw_, &QTimer::timeout, this, &VtkWidget::draw);
  connect(&still_, &QTimer::timeout, this, [this] { request(false); });
}

VtkWidget::~VtkWidget() {
  QObject::disconnect(contextGone_);
  release();
}

void VtkWidget::release() {
  if (view_->ready()) {
    makeCurrent();
    shown_.reset();
    view_->releaseGl();
    doneCurrent();
  }
}

void VtkWidget::initializeGL() {
  // Runs again when the widget goes to another window.
  QSurface* surface = context()->surface();
  view_->setMakeCurrent([this, surface] { context()->makeCurrent(surface); });
  view_->initializeGl();
  QObject::disconnect(contextGone_);
  contextGone_ =
      connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { release(); });
}

QSize VtkWidget::pixels() const {
  return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1});
}

void VtkWidget::resizeGL(int /*width*/, int /*height*/) {
  view_->resize(pixels().width(), pixels().height());
  changed_ = true;
}

void VtkWidget::request(bool moving) {
  changed_ = true;
  moving_ = moving_ || moving || portions_ || still_.isActive();
  draw_.start(moving_ ? 0 : kAfterMs);
}

void VtkWidget::keep() {
  makeCurrent();
  if (!shown_ || shown_->size() != pixels()) {
    shown_ = std::make_unique<QOpenGLFramebufferObject>(pixels());
  }
  QOpenGLExtraFunctions* gl = context()->extraFunctions();
  gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, view_->framebuffer());
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, shown_->handle());
  gl->glDisable(GL_SCISSOR_TEST);
  gl->glBlitFramebuffer(0, 0, pixels().width(), pixels().height(), 0, 0, pixels().width(),
                        pixels().height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

bool VtkWidget::drawWhole() {
  using viewport::Scene;
  const bool none = !shown_ || shown_->size() != pixels();
  const bool fits = view_->fitsOneFrame();
  if (!fits && !moving_ && !none) {
    return false;
  }
  changed_ = moving_ = portions_ = false;
  still_.stop();
  view_->render(fits ? Scene::Detail::Fine : Scene::Detail::Coarse);
  keep();
  if (!fits) {
    still_.start();
  }
  return true;
}

void VtkWidget::draw() {
  if (!view_->ready() || !isVisible()) {
    return;  // it is drawn when it is painted
  }
  QElapsedTimer clock;
  clock.start();
  makeCurrent();
  bool complete = true;
  if (!changed_ || !drawWhole()) {
    complete = view_->renderPortion(changed_);
    changed_ = moving_ = false;
    portions_ = !complete;
    if (complete) {
      keep();
    }
  }
  doneCurrent();
  if (complete && clock.elapsed() < kQuickMs) {
    update();
  } else if (complete) {
    compose_.start();
  } else {
    draw_.start(kPortionMs);
  }
}

void VtkWidget::paintGL() {
  if (!shown_ || shown_->size() != pixels()) {
    drawWhole();
  } else if (changed_) {
    draw_.start(0);  // it changed while it was hidden
  }
  makeCurrent();
  QOpenGLExtraFunctions* gl = context()->extraFunctions();
  const int w = pixels().width();
  const int h = pixels().height();
  gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, shown_->handle());
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  gl->glDisable(GL_SCISSOR_TEST);
  gl->glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  // Qt mixes the widget with what lies behind it: nothing may shine through.
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  emit painted();
}

QImage VtkWidget::picture() {
  if (view_->ready()) {
    makeCurrent();
    draw_.stop();
    still_.stop();
    view_->render(viewport::Scene::Detail::Fine);
    keep();
    changed_ = moving_ = portions_ = false;
    doneCurrent();
  }
  return grabFramebuffer();
}

viewport::Pick VtkWidget::pickAt(const QPointF& at) const {
  const double ratio = devicePixelRatioF();
  return view_->pick(at.x() * ratio, at.y() * ratio, wanted_);
}

void VtkWidget::mousePressEvent(QMouseEvent* event) {
  pressed_ = last_ = event->position();
  dragged_ = false;
  hover_.stop();
}

void VtkWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF move = event->position() - last_;
  last_ = event->position();
  if (event->buttons() == Qt::NoButton) {
    hover_.start();
    return;
  }
  const QPointF all = event->position() - pressed_;
  if (!dragged_ && std::hypot(all.x(), all.y()) < kClickReach) {
    last_ = pressed_;
    return;
  }
  dragged_ = true;
  const bool pan = (event->buttons() & (Qt::MiddleButton | Qt::RightButton)) != 0 ||
                   (event->modifiers() & Qt::ShiftModifier) != 0;
  const double ratio = devicePixelRatioF();
  if (pan) {
    view_->pan(move.x() * ratio, move.y() * ratio);
  } else {
    view_->orbit(move.x(), move.y());
  }
  request(true);
}

void VtkWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (dragged_) {
    return;
  }
  if (event->button() == Qt::LeftButton) {
    emit clicked(pickAt(event->position()), event->modifiers());
  } else if (event->button() == Qt::RightButton) {
    emit contextMenuAt(pickAt(event->position()), event->globalPosition().toPoint());
  }
}

void VtkWidget::wheelEvent(QWheelEvent* event) {
  const double ratio = devicePixelRatioF();
  view_->zoom(std::pow(1.0015, event->angleDelta().y()), event->position().x() * ratio,
              event->position().y() * ratio);
  request(true);
}

void VtkWidget::keyPressEvent(QKeyEvent* event) {
  const double ratio = devicePixelRatioF();
  const auto zoom = [&](double factor) {
    view_->zoom(factor, 0.5 * width() * ratio, 0.5 * height() * ratio);
  };
  switch (event->key()) {
    case Qt::Key_Left:
      view_->orbit(-kKeyTurn, 0.0);
      break;
    case Qt::Key_Right:
      view_->orbit(kKeyTurn, 0.0);
      break;
    case Qt::Key_Up:
      view_->orbit(0.0, -kKeyTurn);
      break;
    case Qt::Key_Down:
      view_->orbit(0.0, kKeyTurn);
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      zoom(1.15);
      break;
    case Qt::Key_Minus:
      zoom(1.0 / 1.15);
      break;
    default:
      QOpenGLWidget::keyPressEvent(event);
      return;
  }
  request(true);
}

void VtkWidget::leaveEvent(QEvent* event) {
  hover_.stop();
  emit hovered({}, QPoint());
  QOpenGLWidget::leaveEvent(event);
}

}  // namespace wcam::gui
