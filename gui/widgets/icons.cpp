// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "icons.hpp"

#include <QApplication>
#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPixmap>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

namespace wcam::gui {

namespace {

// Icons are drawn on a square of 24 and sharp at every size.
constexpr int kSquare = 24;

using Draw = std::function<void(QPainter&, const QColor& line, const QColor& accent)>;

void polyline(QPainter& p, std::initializer_list<QPointF> points) {
  p.drawPolyline(std::data(points), static_cast<int>(points.size()));
}

void polygon(QPainter& p, std::initializer_list<QPointF> points) {
  p.drawPolygon(std::data(points), static_cast<int>(points.size()));
}

void pen(QPainter& p, const QColor& c, double width = 1.8) {
  p.setPen(QPen(c, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  p.setBrush(Qt::NoBrush);
}

void fill(QPainter& p, const QColor& c) {
  p.setPen(QPen(c, 1.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  p.setBrush(c);
}

void triangle(QPainter& p, double x, bool right) {
  const double d = right ? 9.0 : -9.0;
  polygon(p, {{x, 5.0}, {x + d, 12.0}, {x, 19.0}});
}

void cube(QPainter& p, const QColor& line, const QColor& accent, int face) {
  const QPointF c(12, 12);
  const QPointF t(12, 3), l(4, 7.5), r(20, 7.5), bl(4, 16.5), br(20, 16.5), b(12, 21);
  p.setPen(Qt::NoPen);
  p.setBrush(accent);
  if (face == 0 || face == 3) {
    polygon(p, {t, r, c, l});
  }
  if (face == 1 || face == 3) {
    polygon(p, {l, c, b, bl});
  }
  if (face == 2) {
    polygon(p, {c, r, br, b});
  }
  pen(p, line, 1.5);
  polygon(p, {t, r, br, b, bl, l});
  polyline(p, {l, c, r});
  p.drawLine(c, b);
}

const std::map<QString, Draw>& drawings() {
  static const std::map<QString, Draw> kAll = {
      {"play",
       [](QPainter& p, const QColor& l, const QColor&) {
         fill(p, l);
         triangle(p, 8, true);
       }},
      {"pause",
       [](QPainter& p, const QColor& l, const QColor&) {
         fill(p, l);
         p.drawRect(QRectF(7, 5, 3.5, 14));
         p.drawRect(QRectF(13.5, 5, 3.5, 14));
       }},
      {"forward",
       [](QPainter& p, const QColor& l, const QColor&) {
         fill(p, l);
         triangle(p, 6, true);
         p.drawRect(QRectF(16, 5, 1.5, 14));
       }},
      {"back",
       [](QPainter& p, const QColor& l, const QColor&) {
         fill(p, l);
         triangle(p, 18, false);
         p.drawRect(QRectF(6.5, 5, 1.5, 14));
       }},
      {"first",
       [](QPainter& p, const QColor& l, const QColor&) {
         fill(p, l);
         triangle(p, 20, false);
         triangle(p, 13, false);
         p.drawRect(QRectF(3, 5, 1.2, 14));
       }},
      {"last",
       [](QPainter& p, const QColor& l, const QColor&) {
         fill(p, l);
         triangle(p, 4, true);
         triangle(p, 11, true);
         p.drawRect(QRectF(19.8, 5, 1.2, 14));
       }},
      {"new",
       [](QPainter& p, const QColor& l, const QColor& a) {
         pen(p, l);
         polygon(p, {{6, 3}, {14, 3}, {19, 8}, {19, 21}, {6, 21}});
         polyline(p, {{14, 3}, {14, 8}, {19, 8}});
         pen(p, a, 2.2);
         p.drawLine(QPointF(12.5, 11.5), QPointF(12.5, 18));
         p.drawLine(QPointF(9.2, 14.7), QPointF(15.8, 14.7));
       }},
      {"open",
       [](QPainter& p, const QColor& l, const QColor& a) {
         p.setPen(Qt::NoPen);
         p.setBrush(a);
         polygon(p, {{3, 19}, {7, 10.5}, {22, 10.5}, {18, 19}});
         pen(p, l);
         polyline(p, {{3, 19}, {3, 5}, {9, 5}, {11, 7.5}, {18.5, 7.5}, {18.5, 10.5}});
         polygon(p, {{3, 19}, {7, 10.5}, {22, 10.5}, {18, 19}});
       }},
      {"save",
       [](QPainter& p, const QColor& l, const QColor& a) {
         pen(p, l);
         polygon(p, {{4, 4}, {17, 4}, {20, 7}, {20, 20}, {4, 20}});
         p.drawRect(QRectF(8, 4, 7, 5));
         fill(p, a);
         p.drawRect(QRectF(7.5, 13, 9, 7));
       }},
      {"undo",
       [](QPainter& p, const QColor& l, const QColor&) {
         pen(p, l, 2.0);
         QPainterPath path(QPointF(5, 9));
         path.lineTo(14, 9);
         path.cubicTo(21, 9, 21, 19, 14, 19);
         path.lineTo(9, 19);
         p.drawPath(path);
         polyline(p, {{9.5, 4.5}, {5, 9}, {9.5, 13.5}});
       }},
      {"redo",
       [](QPainter& p, const QColor& l, const QColor&) {
         pen(p, l, 2.0);
         QPainterPath path(QPointF(19, 9));
         path.lineTo(10, 9);
         path.cubicTo(3, 9, 3, 19, 10, 19);
         path.lineTo(15, 19);
         p.drawPath(path);
         polyline(p, {{14.5, 4.5}, {19, 9}, {14.5, 13.5}});
       }},
      {"import",
       [](QPainter& p, const QColor& l, const QColor& a) {
         cube(p, l, Qt::transparent, -1);
         pen(p, a, 2.4);
         p.drawLine(QPointF(12, 1.5), QPointF(12, 10));
         polyline(p, {{8.5, 7}, {12, 10.5}, {15.5, 7}});
       }},
      {"part", [](QPainter& p, const QColor& l, const QColor& a) { cube(p, l, a, 3); }},
      {"top", [](QPainter& p, const QColor& l, const QColor& a) { cube(p, l, a, 0); }},
      {"front", [](QPainter& p, const QColor& l, const QColor& a) { cube(p, l, a, 1); }},
      {"right", [](QPainter& p, const QColor& l, const QColor& a) { cube(p, l, a, 2); }},
      {"iso", [](QPainter& p, const QColor& l, const QColor& a) { cube(p, l, a, 3); }},
      {"substrate",
       [](QPainter& p, const QColor& l, const QColor& a) {
         p.setPen(Qt::NoPen);
         p.setBrush(a);
         polygon(p, {{2, 14}, {12, 9}, {22, 14}, {12, 19}});
         pen(p, l, 1.5);
         polygon(p, {{2, 14}, {12, 9}, {22, 14}, {12, 19}});
         polyline(p, {{2, 14}, {2, 16.5}, {12, 21.5}, {22, 16.5}, {22, 14}});
         p.drawLine(QPointF(12, 19), QPointF(12, 21.5));
       }},
      {"guide",
       [](QPainter& p, const QColor& l, const QColor& a) {
         pen(p, a, 2.4);
         QPainterPath path(QPointF(4, 20));
         path.cubicTo(4, 8, 20, 16, 20, 4);
         p.drawPath(path);
         fill(p, l);
         p.drawEllipse(QPointF(4, 20), 2, 2);
         p.drawEllipse(QPointF(20, 4), 2, 2);
       }},
      {"process",
       [](QPainter& p, const QColor& l, const QColor& a) {
         pen(p, l, 1.8);
         polygon(p, {{8, 2}, {16, 2}, {16, 9}, {13, 14}, {11, 14}, {8, 9}});
         pen(p, a, 2.2);
         p.drawLine(QPointF(12, 16), QPointF(12, 18.5));
         p.drawLine(QPointF(8.5, 17), QPointF(6.5, 20));
         p.drawLine(QPointF(15.5, 17), QPointF(17.5, 20));
         p.drawLine(QPointF(4, 22), QPointF(20, 22));
       }},
      {"operation",
       [](QPainter& p, const QColor& l, const QColor& a) {
         for (int i = 0; i < 4; ++i) {
           pen(p, i == 0 ? a : l, 2.2);
           p.drawEllipse(QPointF(12, 7.0 + 3.8 * i), 8.0 - 0.4 * (3 - i), 3.0);
         }
       }},
      {"edit",
       [](QPainter& p, const QColor& l, const QColor& a) {
         pen(p, l, 2.2);
         for (int i = 0; i < 3; ++i) {
           p.drawLine(QPointF(3, 13.0 + 4 * i), QPointF(15 - 2.0 * i, 13.0 + 4 * i));
         }
         pen(p, a);
         polygon(p, {{11, 15}, {12, 11}, {19, 4}, {22, 7}, {15, 14}});
       }},
      {"output",
       [](QPainter& p, const QColor& l, const QColor& a) {
         pen(p, l);
         polygon(p, {{5, 3}, {13, 3}, {18, 8}, {18, 21}, {5, 21}});
         for (int i = 0; i < 3; ++i) {
           p.drawLine(QPointF(8, 11 + 3.0 * i), QPointF(14, 11 + 3.0 * i));
         }
         pen(p, a, 2.4);
         polyline(p, {{17, 13}, {21.5, 16}, {17, 19}});
       }},
      {"cell",
       [](QPainter& p, const QColor& l, const QColor& a) {
         pen(p, a, 3.2);
         polyline(p, {{7, 19}, {7, 10}, {14, 5}, {20, 10}});
         fill(p, l);
         for (const QPointF& at : {QPointF(7, 10), QPointF(14, 5), QPointF(20, 10)}) {
           p.drawEllipse(at, 2.0, 2.0);
         }
         p.drawRect(QRectF(3, 19, 9, 2.5));
       }},
      {"export",
       [](QPainter& p, const QColor& l, const QColor& a) {
         pen(p, l);
         polyline(p, {{8, 9}, {4, 9}, {4, 21}, {20, 21}, {20, 9}, {16, 9}});
         pen(p, a, 2.4);
         p.drawLine(QPointF(12, 2.5), QPointF(12, 15));
         polyline(p, {{8, 6.5}, {12, 2.5}, {16, 6.5}});
       }},
      {"add",
       [](QPainter& p, const QColor&, const QColor& a) {
         pen(p, a, 2.8);
         p.drawLine(QPointF(12, 4), QPointF(12, 20));
         p.drawLine(QPointF(4, 12), QPointF(20, 12));
       }},
      {"remove",
       [](QPainter& p, const QColor& l, const QColor&) {
         pen(p, l, 1.7);
         polygon(p, {{6, 7}, {18, 7}, {17, 21}, {7, 21}});
         p.drawLine(QPointF(4, 7), QPointF(20, 7));
         polyline(p, {{9, 7}, {9, 4}, {15, 4}, {15, 7}});
         p.drawLine(QPointF(10.3, 10.5), QPointF(10.6, 17.5));
         p.drawLine(QPointF(13.7, 10.5), QPointF(13.4, 17.5));
       }},
      {"fit",
       [](QPainter& p, const QColor& l, const QColor& a) {
         pen(p, l, 2.0);
         polyline(p, {{3, 8}, {3, 3}, {8, 3}});
         polyline(p, {{16, 3}, {21, 3}, {21, 8}});
         polyline(p, {{21, 16}, {21, 21}, {16, 21}});
         polyline(p, {{8, 21}, {3, 21}, {3, 16}});
         fill(p, a);
         p.drawRoundedRect(QRectF(8, 8, 8, 8), 1.5, 1.5);
       }},
      {"cancel",
       [](QPainter& p, const QColor&, const QColor&) {
         pen(p, QColor(200, 60, 50), 2.6);
         p.drawLine(QPointF(6, 6), QPointF(18, 18));
         p.drawLine(QPointF(18, 6), QPointF(6, 18));
       }},
      {"reset",
       [](QPainter& p, const QColor& l, const QColor&) {
         pen(p, l, 2.2);
         p.drawArc(QRectF(5, 5, 14, 14), 120 * 16, -290 * 16);
         polyline(p, {{4.5, 4}, {6.5, 9.2}, {11.8, 7.6}});
       }},
      {"section",
       [](QPainter& p, const QColor& l, const QColor& a) {
         p.setPen(Qt::NoPen);
         p.setBrush(a);
         polygon(p, {{4, 7.5}, {12, 3}, {12, 21}, {4, 16.5}});
         pen(p, l, 1.5);
         polygon(p, {{12, 3}, {20, 7.5}, {20, 16.5}, {12, 21}, {4, 16.5}, {4, 7.5}});
         p.drawLine(QPointF(12, 1), QPointF(12, 23));
       }},
      {"measure",
       [](QPainter& p, const QColor& l, const QColor& a) {
         pen(p, a, 2.2);
         p.drawLine(QPointF(4, 20), QPointF(20, 4));
         pen(p, l, 1.8);
         p.drawLine(QPointF(1.5, 17.5), QPointF(6.5, 22.5));
         p.drawLine(QPointF(17.5, 1.5), QPointF(22.5, 6.5));
       }},
      {"camera",
       [](QPainter& p, const QColor& l, const QColor& a) {
         pen(p, l, 1.8);
         p.drawRoundedRect(QRectF(2.5, 7, 19, 13), 2, 2);
         polyline(p, {{8, 7}, {9.5, 4}, {14.5, 4}, {16, 7}});
         fill(p, a);
         p.drawEllipse(QPointF(12, 13.5), 3.6, 3.6);
       }},
  };
  return kAll;
}

QPixmap drawn(const Draw& draw, int size, const QColor& line, const QColor& accent) {
  QPixmap pixmap(size, size);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(static_cast<double>(size) / kSquare, static_cast<double>(size) / kSquare);
  draw(painter, line, accent);
  return pixmap;
}

/// Draws an icon in the sizes that are asked for, each once: drawing all sizes of all icons at the
/// start would take a tenth of a second.
class DrawnIcon : public QIconEngine {
public:
  DrawnIcon(Draw draw, const QColor& line, const QColor& accent, const QColor& grey)
      : draw_(std::move(draw)), line_(line), accent_(accent), grey_(grey) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    const double ratio = painter->device()->devicePixelRatioF();
    painter->drawPixmap(rect, pixmap((QSizeF(rect.size()) * ratio).toSize(), mode, state));
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State /*state*/) override {
    const int side = std::max(1, std::min(size.width(), size.height()));
    const bool off = mode == QIcon::Disabled;
    QPixmap& made = made_[{side, off}];
    if (made.isNull()) {
      made = drawn(draw_, side, off ? grey_ : line_, off ? grey_ : accent_);
    }
    return made;
  }

  QList<QSize> availableSizes(QIcon::Mode /*mode*/, QIcon::State /*state*/) override {
    return {{16, 16}, {20, 20}, {24, 24}, {32, 32}, {48, 48}, {64, 64}, {128, 128}, {256, 256}};
  }

  [[nodiscard]] QIconEngine* clone() const override { return new DrawnIcon(*this); }

private:
  Draw draw_;
  QColor line_;
  QColor accent_;
  QColor grey_;
  std::map<std::pair<int, bool>, QPixmap> made_;  ///< by size and whether it is disabled
};

/// Icons that are shared by all who ask for them. Pixmaps must go before the application.
QHash<QString, QIcon>& keptIcons() {
  static QHash<QString, QIcon> kept;
  static const bool once = [] {
    qAddPostRoutine([] { keptIcons().clear(); });
    return true;
  }();
  static_cast<void>(once);
  return kept;
}

}  // namespace

QIcon icon(const QString& name) {
  const auto found = drawings().find(name);
  if (found == drawings().end()) {
    return {};
  }
  const QPalette palette = QApplication::palette();
  const QColor line = palette.color(QPalette::Active, QPalette::ButtonText);
  const QColor accent = palette.color(QPalette::Active, QPalette::Highlight);
  const QColor grey = palette.color(QPalette::Disabled, QPalette::ButtonText);
  const QString key = name + line.name() + accent.name() + grey.name();
  QIcon& kept = keptIcons()[key];
  if (kept.isNull()) {
    kept = QIcon(new DrawnIcon(found->second, line, accent, grey));
  }
  return kept;
}

QColor statusColour(Status status) {
  switch (status) {
    case Status::Ok:
      return {52, 160, 90};
    case Status::Stale:
    case Status::Running:
      return {130, 136, 146};
    case Status::Information:
      return {58, 128, 204};
    case Status::Warning:
      return {226, 150, 20};
    case Status::Error:
      return {208, 52, 44};
    case Status::None:
      break;
  }
  return Qt::transparent;
}

QIcon statusIcon(Status status) {
  if (status == Status::None) {
    return {};
  }
  QIcon& kept = keptIcons()[QString::number(static_cast<int>(status))];
  if (!kept.isNull()) {
    return kept;
  }
  const QColor colour = statusColour(status);
  const Draw draw = [status, colour](QPainter& p, const QColor&, const QColor&) {
    if (status == Status::Warning) {
      fill(p, colour);
      polygon(p, {{12, 4}, {21, 20}, {3, 20}});
    } else if (status == Status::Running || status == Status::Stale) {
      pen(p, colour, 2.6);
      if (status == Status::Running) {
        p.setPen(QPen(colour, 2.6, Qt::DotLine, Qt::RoundCap));
      }
      p.drawEllipse(QPointF(12, 12), 7, 7);
      return;
    } else {
      fill(p, colour);
      p.drawEllipse(QPointF(12, 12), 8.5, 8.5);
    }
    pen(p, Qt::white, 2.4);
    if (status == Status::Ok) {
      polyline(p, {{8, 12.2}, {11, 15.2}, {16, 9}});
    } else if (status == Status::Error) {
      p.drawLine(QPointF(9, 9), QPointF(15, 15));
      p.drawLine(QPointF(15, 9), QPointF(9, 15));
    } else if (status == Status::Warning) {
      p.drawLine(QPointF(12, 10), QPointF(12, 14));
      p.drawPoint(QPointF(12, 17.2));
    } else {
      p.drawLine(QPointF(12, 11.5), QPointF(12, 16));
      p.drawPoint(QPointF(12, 8));
    }
  };
  kept = QIcon(new DrawnIcon(draw, {}, {}, {}));
  return kept;
}

QIcon applicationIcon() {
  const Draw draw = [](QPainter& p, const QColor&, const QColor&) {
    p.setPen(Qt::NoPen);
    p.setBrush(QColor(34, 44, 60));
    p.drawRoundedRect(QRectF(0, 0, 24, 24), 5, 5);
    const std::array<QColor, 4> colours = {QColor(46, 78, 158), QColor(41, 137, 178),
                                           QColor(240, 160, 44), QColor(210, 62, 52)};
    for (int i = 0; i < 4; ++i) {
      p.setPen(QPen(colours[static_cast<std::size_t>(i)], 2.6, Qt::SolidLine, Qt::RoundCap));
      p.setBrush(Qt::NoBrush);
      p.drawArc(QRectF(5, 14.5 - 3.6 * i, 14, 5), 180 * 16, 180 * 16);
    }
  };
  return QIcon(new DrawnIcon(draw, {}, {}, {}));
}

}  // namespace wcam::gui
