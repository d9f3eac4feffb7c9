// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"

#include "model/path_model.hpp"

#include <QString>

#include <string>

namespace wcam::gui {

inline QString qt(const std::string& text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

inline std::string utf8(const QString& text) {
  return text.toUtf8().toStdString();
}

/// A figure as the user's language writes it, without marks between thousands.
QString figureText(double value, int decimals);
/// The same with as many digits as it needs, at most `digits`.
QString shortFigure(double value, int digits);
/// Between the numbers of a vector: where the comma is the decimal point, a semicolon.
QString listSeparator();
/// A text that files write with decimal points as the user's language writes it: a figure, perhaps
/// with a unit. Anything else stays as it is.
QString localFigure(const QString& text);

/// Message, place and hint of an error as camcli tells them, in the language of the program.
QString errorText(const Error& error);

/// Translated name of a quantity.
QString nameOf(Quantity quantity);

/// Name of a kind of a quantity of kinds.
QString kindName(Quantity quantity, int kind);

/// The engine's texts (labels and helps of parameters, findings, errors) in the language of the
/// program: from the context "engine" of the translations; the English text where there is none.
QString engineText(const Text& text);

}  // namespace wcam::gui
