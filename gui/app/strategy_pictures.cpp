// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "strategy_pictures.hpp"

#include <QApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPixmap>

#include <cmath>
#include <functional>
#include <map>

namespace wcam::gui {

namespace {

constexpr int kWidth = 144;
constexpr int kHeight = 108;
const QColor kLow(46, 110, 180);
const QColor kHigh(232, 140, 50);

QColor between(double t) {
  return QColor::fromRgbF(kLow.redF() + t * (kHigh.redF() - kLow.redF()),
                          kLow.greenF() + t * (kHigh.greenF() - kLow.greenF()),
                          kLow.blueF() + t * (kHigh.blueF() - kLow.blueF()));
}

void bead(QPainter& p, double t, const QPainterPath& path) {
  p.setPen(QPen(between(t), 5.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  p.setBrush(Qt::NoBrush);
  p.drawPath(path);
}

QPainterPath line(double x1, double y1, double x2, double y2) {
  QPainterPath path(QPointF(x1, y1));
  path.lineTo(x2, y2);
  return path;
}

QPainterPath arc(double cx, double y, double rx, double ry) {
  QPainterPath path;
  path.arcMoveTo(QRectF(cx - rx, y - ry, 2 * rx, 2 * ry), 180);
  path.arcTo(QRectF(cx - rx, y - ry, 2 * rx, 2 * ry), 180, 180);
  return path;
}

using Draw = std::function<void(QPainter&)>;

void planar(QPainter& p) {
  for (int i = 0; i < 9; ++i) {
    bead(p, i / 8.0, line(38, 92 - 9 * i, 106, 92 - 9 * i));
  }
}

/// Layers normal to a bent guide.
void guide(QPainter& p) {
  for (int i = 0; i < 10; ++i) {
    const double a = 0.165 * i;
    bead(p, i / 9.0,
         line(118 - 24 * std::cos(a), 96 - 24 * std::sin(a), 118 - 84 * std::cos(a),
              96 - 84 * std::sin(a)));
  }
}

/// Layers that follow each other at one distance on a curved wall.
void curved(QPainter& p) {
  for (int i = 0; i < 8; ++i) {
    QPainterPath path(QPointF(34, 94 - 9.5 * i));
    path.cubicTo(58, 78 - 9.5 * i, 86, 104 - 9.5 * i, 110, 88 - 9.5 * i);
    bead(p, i / 7.0, path);
  }
}

void spiral(QPainter& p) {
  for (int i = 0; i < 9; ++i) {
    bead(p, i / 8.0, line(40, 95 - 9 * i, 104, 90 - 9 * i));
  }
}

void bulk(QPainter& p) {
  for (int i = 0; i < 4; ++i) {
    QPainterPath path;
    path.addRoundedRect(QRectF(24 + 11 * i, 20 + 11 * i, 96 - 22 * i, 68 - 22 * i), 12 - 2 * i,
                        12 - 2 * i);
    bead(p, 1.0 - i / 3.0, path);
  }
}

void radial(QPainter& p) {
  for (int i = 0; i < 7; ++i) {
    QPainterPath path;
    path.addEllipse(QPointF(72, 54), 10 + 6.5 * i, 10 + 6.5 * i);
    p.save();
    p.setClipRect(0, 0, kWidth, kHeight);
    bead(p, i / 6.0, path);
    p.restore();
  }
}

void branches(QPainter& p) {
  for (int i = 0; i < 4; ++i) {
    bead(p, i / 9.0, line(58, 94 - 9 * i, 86, 94 - 9 * i));
  }
  for (int i = 0; i < 5; ++i) {
    bead(p, 0.4 + i / 8.0, line(40 - 2.0 * i, 56 - 9 * i, 62 - 2.0 * i, 58 - 9 * i));
    bead(p, 0.4 + i / 8.0, line(82 + 2.0 * i, 58 - 9 * i, 104 + 2.0 * i, 56 - 9 * i));
  }
}

void cladding(QPainter& p) {
  p.setPen(Qt::NoPen);
  p.setBrush(QColor(150, 156, 164));
  p.drawRoundedRect(QRectF(20, 50, 104, 42), 4, 4);
  for (int i = 0; i < 8; ++i) {
    bead(p, i / 7.0, line(28 + 12.5 * i, 44, 28 + 12.5 * i, 43));
  }
}

void domes(QPainter& p) {
  for (int i = 0; i < 7; ++i) {
    bead(p, i / 6.0, arc(72, 60 - 0.0 * i, 12 + 6.5 * i, 8 + 4.5 * i));
  }
}

void imported(QPainter& p) {
  QPainterPath path(QPointF(24, 88));
  for (int i = 0; i < 6; ++i) {
    path.lineTo(i % 2 == 0 ? 118 : 26, 84 - 13 * i);
    path.lineTo(i % 2 == 0 ? 118 : 26, 74 - 13 * i);
  }
  bead(p, 0.5, path);
}

const std::map<std::string, Draw>& drawings() {
  static const std::map<std::string, Draw> kAll = {
      {"planar", planar},    {"guide", guide},       {"constant", curved},   {"geodesic", curved},
      {"isovalues", curved}, {"isoparam", domes},    {"spiral", spiral},     {"bulk", bulk},
      {"radial", radial},    {"branches", branches}, {"cladding", cladding}, {"import", imported}};
  return kAll;
}

}  // namespace

QIcon strategyPicture(const std::string& id) {
  QPixmap pixmap(kWidth, kHeight);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor back = QApplication::palette().color(QPalette::Window);
  painter.setPen(QPen(QApplication::palette().color(QPalette::Mid), 1));
  painter.setBrush(back);
  painter.drawRoundedRect(QRectF(0.5, 0.5, kWidth - 1, kHeight - 1), 8, 8);
  const auto found = drawings().find(id.substr(id.rfind('.') + 1));
  (found != drawings().end() ? found->second : Draw(planar))(painter);
  painter.end();
  return QIcon(pixmap);
}

}  // namespace wcam::gui
