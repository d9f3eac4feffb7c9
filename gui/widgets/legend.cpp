// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "legend.hpp"

#include "text.hpp"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFontMetrics>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QRegularExpressionValidator>

#include <algorithm>
#include <cmath>

namespace wcam::gui {

namespace {

constexpr int kTitle = 24;
constexpr int kRow = 19;
constexpr int kBar = 128;
constexpr int kNarrowest = 84;
constexpr int kWidest = 178;
constexpr int kTicks = 5;

QString number(double value, double span) {
  const int decimals =
      span > 0.0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(span))), 0, 4) : 2;
  return figureText(value, decimals);
}

}  // namespace

Legend::Legend(ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setObjectName("legend");
  setCursor(Qt::PointingHandCursor);
  setToolTip(tr("Click: another quantity. Double click: limits of the colours."));
}

void Legend::setColours(const Coloured& colours) {
  colours_.low = colours.low;
  colours_.high = colours.high;
  colours_.kinds = colours.kinds;
  colours_.empty = colours.empty;
  setVisible(state_.path() != nullptr);
  resize(sizeHint());
  update();
}

QString Legend::title() const {
  const QString unit = qt(unitOf(state_.colour()));
  return nameOf(state_.colour()) + (unit.isEmpty() ? QString() : " (" + unit + ")");
}

QStringList Legend::rows() const {
  if (colours_.empty) {
    return {tr("no values")};
  }
  QStringList rows;
  if (isKind(state_.colour())) {
    for (const int kind : colours_.kinds) {
      rows.append(kindName(state_.colour(), kind));
    }
    return rows;
  }
  const double span = static_cast<double>(colours_.high) - colours_.low;
  // Layers are whole: no more ticks than there are.
  const int most = state_.colour() == Quantity::Layer
                       ? std::min(kTicks, static_cast<int>(std::lround(span)) + 1)
                       : kTicks;
  const int ticks = span > 0.0 ? most : 1;
  for (int i = 0; i < ticks; ++i) {
    const double value = colours_.low + (ticks > 1 ? span * i / (ticks - 1) : 0.5 * span);
    rows.append(state_.colour() == Quantity::Layer ? QString::number(std::lround(value) + 1)
                                                   : number(value, span));
  }
  return rows;
}

QSize Legend::sizeHint() const {
  QFont bold = font();
  bold.setBold(true);
  int width = QFontMetrics(bold).horizontalAdvance(title()) + 22;
  for (const QString& row : rows()) {
    width = std::max(width, 38 + fontMetrics().horizontalAdvance(row) + 12);
  }
  width = std::clamp(width, kNarrowest, kWidest);
  const bool scale = !isKind(state_.colour()) && !colours_.empty;
  return {width, scale ? kTitle + kBar + 22
                       : kTitle + 10 + kRow * std::max(1, static_cast<int>(rows().size()))};
}

void Legend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor back = palette().color(QPalette::Base);
  back.setAlpha(218);
  painter.setPen(QPen(palette().color(QPalette::Mid), 1));
  painter.setBrush(back);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
  const QColor text = palette().color(QPalette::Text);
  painter.setPen(text);
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.drawText(QRectF(10, 3, width() - 16, kTitle), Qt::AlignVCenter | Qt::AlignLeft,
                   painter.fontMetrics().elidedText(title(), Qt::ElideRight, width() - 18));
  painter.setFont(font());
  if (colours_.empty) {
    painter.drawText(QRectF(10, kTitle, width() - 16, kRow), Qt::AlignVCenter, tr("no values"));
    return;
  }
  if (isKind(state_.colour())) {
    for (std::size_t i = 0; i < colours_.kinds.size(); ++i) {
      const double y = kTitle + 4 + kRow * static_cast<double>(i);
      const int kind = colours_.kinds[i];
      QColor c;
      if (state_.colour() == Quantity::Finding) {
        static const std::array<QColor, 4> kColours = {QColor(120, 170, 140), QColor(80, 140, 210),
                                                       QColor(240, 170, 40), QColor(215, 50, 50)};
        c = kColours[static_cast<std::size_t>(std::clamp(kind, 0, 3))];
      } else {
        const viewport::Colour rgb = kindColour(kind);
        c = QColor(rgb[0], rgb[1], rgb[2]);
      }
      painter.setPen(Qt::NoPen);
      painter.setBrush(c);
      painter.drawRoundedRect(QRectF(12, y + 3, 16, 12), 2, 2);
      painter.setPen(text);
      painter.drawText(QRectF(36, y, width() - 40, kRow), Qt::AlignVCenter,
                       kindName(state_.colour(), kind));
    }
    return;
  }
  const double span = static_cast<double>(colours_.high) - colours_.low;
  const double top = kTitle + 10;
  for (int y = 0; y < kBar; ++y) {
    const viewport::Colour rgb =
        scaleColour(span > 0.0 ? 1.0 - static_cast<double>(y) / (kBar - 1) : 0.35);
    painter.fillRect(QRectF(12, top + y, 18, 1.2), QColor(rgb[0], rgb[1], rgb[2]));
  }
  const QStringList ticks = rows();
  for (int i = 0; i < ticks.size(); ++i) {
    const double t = ticks.size() > 1 ? static_cast<double>(i) / (ticks.size() - 1) : 0.5;
    const double y = top + kBar * (1.0 - t);
    painter.drawText(QRectF(38, y - 9, width() - 40, 18), Qt::AlignVCenter, ticks[i]);
  }
  if (state_.range()) {
    painter.drawText(QRectF(38, kTitle - 8, width() - 46, 18), Qt::AlignRight | Qt::AlignVCenter,
                     "✎");
  }
}

void Legend::mousePressEvent(QMouseEvent* event) {
  if (event->position().y() < kTitle) {
    emit chooseQuantity();
  }
}

void Legend::mouseDoubleClickEvent(QMouseEvent*) {
  editRange();
}

void Legend::editRange() {
  if (isKind(state_.colour()) || colours_.empty) {
    return;
  }
  QDialog dialog(window());
  dialog.setObjectName("rangeDialog");
  dialog.setWindowTitle(tr("Limits of the colours"));
  auto* form = new QFormLayout(&dialog);
  form->addRow(new QLabel(tr("Empty: the limits of the values."), &dialog));
  auto* low = new QLineEdit(&dialog);
  auto* high = new QLineEdit(&dialog);
  low->setObjectName("rangeLow");
  high->setObjectName("rangeHigh");
  for (QLineEdit* line : {low, high}) {
    // With the decimal point of files or the comma of the language.
    static const QRegularExpression kNumber("[-+]?[0-9]*[.,]?[0-9]*([eE][-+]?[0-9]+)?");
    line->setValidator(new QRegularExpressionValidator(kNumber, line));
  }
  // People count layers from 1.
  const double first = state_.colour() == Quantity::Layer ? 1.0 : 0.0;
  const auto shown = [first](float value) { return shortFigure(value + first, 6); };
  if (state_.range()) {
    low->setText(shown(state_.range()->first));
    high->setText(shown(state_.range()->second));
  }
  low->setPlaceholderText(shown(colours_.low));
  high->setPlaceholderText(shown(colours_.high));
  const QString unit = qt(unitOf(state_.colour()));
  form->addRow(unit.isEmpty() ? tr("Lowest") : tr("Lowest (%1)").arg(unit), low);
  form->addRow(unit.isEmpty() ? tr("Highest") : tr("Highest (%1)").arg(unit), high);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  if (low->text().isEmpty() && high->text().isEmpty()) {
    state_.setRange(std::nullopt);
    return;
  }
  const auto valueOf = [first](const QLineEdit* line, float otherwise) {
    bool ok = false;
    const double value = QLocale::c().toDouble(QString(line->text()).replace(',', '.'), &ok);
    return ok ? static_cast<float>(value - first) : otherwise;
  };
  const float from = valueOf(low, colours_.low);
  const float to = valueOf(high, colours_.high);
  state_.setRange(std::pair(std::min(from, to), std::max(from, to)));
}

}  // namespace wcam::gui
