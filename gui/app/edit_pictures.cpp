// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "edit_pictures.hpp"

#include <QApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPixmap>

namespace wcam::gui {

namespace {

constexpr int kWidth = 144;
constexpr int kHeight = 108;
constexpr int kLayers = 6;
const QColor kPlain(46, 110, 180);
const QColor kChanged(232, 140, 50);

void pen(QPainter& p, const QColor& colour, double width = 6.0) {
  p.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  p.setBrush(Qt::NoBrush);
}

double height(int layer) {
  return 92.0 - 13.0 * layer;
}

void layer(QPainter& p, int index, const QColor& colour, double from = 32.0, double to = 112.0) {
  pen(p, colour);
  p.drawLine(QPointF(from, height(index)), QPointF(to, height(index)));
}

void arrow(QPainter& p, QPointF from, QPointF to) {
  pen(p, kChanged, 4.0);
  p.drawLine(from, to);
  const QLineF line(to, from);
  for (const double turn : {30.0, -30.0}) {
    QLineF barb = line;
    barb.setLength(11.0);
    barb.setAngle(line.angle() + turn);
    p.drawLine(barb);
  }
}

void ring(QPainter& p, double from) {
  pen(p, kPlain);
  p.drawEllipse(QPointF(72, 56), 50, 30);
  p.setPen(Qt::NoPen);
  p.setBrush(kPlain.darker(150));
  p.drawEllipse(QPointF(122, 56), 7, 7);
  pen(p, kChanged, 4.0);
  p.drawArc(QRectF(30, 34, 84, 44), static_cast<int>(from * 16), 80 * 16);
  p.setPen(Qt::NoPen);
  p.setBrush(kChanged);
  p.drawEllipse(QPointF(84, 27), 8, 8);
}

void stack(QPainter& p, int first, int last, const QColor& changed) {
  for (int i = 0; i < kLayers; ++i) {
    layer(p, i, i >= first && i <= last ? changed : kPlain);
  }
}

void torch(QPainter& p, double angle) {
  p.save();
  p.translate(72, 86);
  p.rotate(angle);
  pen(p, kChanged, 9.0);
  p.drawLine(QPointF(0, -16), QPointF(0, -62));
  pen(p, kChanged, 3.0);
  p.drawLine(QPointF(0, 0), QPointF(0, -14));
  p.restore();
}

void draw(QPainter& p, toolpath::EditType type) {
  using toolpath::EditType;
  switch (type) {
    case EditType::MoveSeam:
      return ring(p, 0.0);
    case EditType::DeleteLayers: {
      QColor gone = kChanged;
      gone.setAlphaF(0.3);
      stack(p, 2, 3, gone);
      pen(p, kChanged, 4.0);
      p.drawLine(QPointF(58, 43), QPointF(86, 71));
      p.drawLine(QPointF(86, 43), QPointF(58, 71));
      return;
    }
    case EditType::RepeatLayers:
      stack(p, 3, 5, kChanged);
      return arrow(p, {126, 90}, {126, 30});
    case EditType::SetSpeed:
    case EditType::SetWire:
      for (int i = 0; i < kLayers; ++i) {
        layer(p, i, kPlain);
        layer(p, i, kChanged, 60, 96);
      }
      if (type == EditType::SetSpeed) {
        arrow(p, {60, 14}, {100, 14});
      } else {
        arrow(p, {78, 2}, {78, 22});
      }
      return;
    case EditType::Pause:
      stack(p, 9, 9, kChanged);
      pen(p, kChanged, 9.0);
      p.drawLine(QPointF(62, 36), QPointF(62, 76));
      p.drawLine(QPointF(84, 36), QPointF(84, 76));
      return;
    case EditType::Reverse:
      layer(p, 2, kPlain, 30, 114);
      arrow(p, {40, 44}, {104, 44});
      return arrow(p, {104, 84}, {40, 84});
    case EditType::SetLead:
      layer(p, 0, kPlain, 20, 124);
      arrow(p, {88, 78}, {122, 78});
      return torch(p, 28.0);
    case EditType::SetLateral:
      pen(p, kPlain, 3.0);
      p.setBrush(kPlain);
      p.drawEllipse(QPointF(72, 92), 14, 6);
      return torch(p, -28.0);
  }
}

}  // namespace

QIcon editPicture(toolpath::EditType type) {
  QPixmap pixmap(kWidth, kHeight);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QApplication::palette().color(QPalette::Mid), 1));
  painter.setBrush(QApplication::palette().color(QPalette::Window));
  painter.drawRoundedRect(QRectF(0.5, 0.5, kWidth - 1, kHeight - 1), 8, 8);
  draw(painter, type);
  painter.end();
  return QIcon(pixmap);
}

}  // namespace wcam::gui
