// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "text.hpp"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

namespace wcam::gui {

namespace {

QLocale plainLocale() {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale;
}

/// The figures among the arguments of a text in the user's language.
Text withLocalFigures(const Text& text) {
  if (text.arguments().empty()) {
    return text.foreign() ? Text(utf8(localFigure(qt(text.pattern())))) : text;
  }
  std::vector<Text> arguments;
  arguments.reserve(text.arguments().size());
  for (const Text& argument : text.arguments()) {
    arguments.push_back(withLocalFigures(argument));
  }
  return {text.pattern(), std::move(arguments)};
}

}  // namespace

QString figureText(double value, int decimals) {
  return plainLocale().toString(value, 'f', decimals);
}

QString shortFigure(double value, int digits) {
  return plainLocale().toString(value, 'g', digits);
}

QString listSeparator() {
  return QLocale().decimalPoint() == "," ? QStringLiteral("; ") : QStringLiteral(", ");
}

QString localFigure(const QString& text) {
  static const QRegularExpression kFigure(
      QStringLiteral("^[-+]?[0-9]+\\.[0-9]+(e[-+]?[0-9]+)?( [^0-9 ]\\S*)?$"));
  const QString point = QLocale().decimalPoint();
  if (point == "." || !kFigure.match(text).hasMatch()) {
    return text;
  }
  QString local = text;
  return local.replace(local.indexOf('.'), 1, point);
}

QString errorText(const Error& error) {
  QString text = engineText(error.whatText());
  if (!error.hint().empty()) {
    text +=
        "\n" + QCoreApplication::translate("text", "Hint: %1").arg(engineText(error.hintText()));
  }
  return text;
}

QString nameOf(Quantity quantity) {
  switch (quantity) {
    case Quantity::Layer:
      return QCoreApplication::translate("text", "Layer");
    case Quantity::Feature:
      return QCoreApplication::translate("text", "Feature");
    case Quantity::Height:
      return QCoreApplication::translate("text", "Bead height");
    case Quantity::Distance:
      return QCoreApplication::translate("text", "Inter-layer distance");
    case Quantity::Width:
      return QCoreApplication::translate("text", "Bead width");
    case Quantity::TravelSpeed:
      return QCoreApplication::translate("text", "Travel speed");
    case Quantity::TcpSpeed:
      return QCoreApplication::translate("text", "Predicted TCP speed");
    case Quantity::WireSpeed:
      return QCoreApplication::translate("text", "Wire feed speed");
    case Quantity::Tilt:
      return QCoreApplication::translate("text", "Torch tilt");
    case Quantity::Overhang:
      return QCoreApplication::translate("text", "Overhang");
    case Quantity::ReachMargin:
      return QCoreApplication::translate("text", "Reach margin");
    case Quantity::Singularity:
      return QCoreApplication::translate("text", "Distance to wrist singularity");
    case Quantity::LimitMargin:
      return QCoreApplication::translate("text", "Joint-limit margin");
    case Quantity::Clearance:
      return QCoreApplication::translate("text", "Distance to collision");
    case Quantity::Finding:
      return QCoreApplication::translate("text", "Findings");
    case Quantity::Time:
      return QCoreApplication::translate("text", "Time");
  }
  return {};
}

QString kindName(Quantity quantity, int kind) {
  if (quantity == Quantity::Finding) {
    switch (kind) {
      case 0:
        return QCoreApplication::translate("text", "Nothing found");
      case 1:
        return QCoreApplication::translate("text", "Information");
      case 2:
        return QCoreApplication::translate("text", "Warning");
      default:
        return QCoreApplication::translate("text", "Violation");
    }
  }
  switch (static_cast<toolpath::BeadFeature>(kind)) {
    case toolpath::BeadFeature::Wall:
      return QCoreApplication::translate("text", "Wall");
    case toolpath::BeadFeature::Inset:
      return QCoreApplication::translate("text", "Inset");
    case toolpath::BeadFeature::Fill:
      return QCoreApplication::translate("text", "Fill");
    case toolpath::BeadFeature::Junction:
      return QCoreApplication::translate("text", "Junction");
    case toolpath::BeadFeature::Cladding:
      return QCoreApplication::translate("text", "Cladding");
    case toolpath::BeadFeature::Imported:
      return QCoreApplication::translate("text", "Imported");
  }
  return QString::number(kind);
}

QString engineText(const Text& text) {
  const auto translate = [](const std::string& pattern) {
    return utf8(QCoreApplication::translate("engine", pattern.c_str()));
  };
  // Words from elsewhere on their own are looked up as they stand.
  return qt(render(
      text.arguments().empty() || QLocale().decimalPoint() == "." ? text : withLocalFigures(text),
      translate));
}

}  // namespace wcam::gui
