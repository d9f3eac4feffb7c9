// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wcam {

/// Something the program says, kept so that it can be said in another language: an English pattern
/// with places %1 to %9 and what stands in them. `str()` is the English text. A text without
/// arguments is taken literally, whatever it contains.
///
/// Two kinds of text have no arguments. Literals (`const char*`, `text("...")`) are words of the
/// program and are translated wherever they stand. Strings are words from elsewhere (names,
/// figures, messages of a plugin): as an argument they are left alone, on their own they are looked
/// up.
class Text {
public:
  Text() = default;
  Text(const char* words);
  Text(std::string words);
  /// The pattern should be a literal: packaging/update-translations collects those of
  /// `text("...")`.
  Text(std::string pattern, std::vector<Text> arguments);

  /// The English text.
  [[nodiscard]] std::string str() const;

  explicit operator std::string() const { return str(); }

  [[nodiscard]] bool empty() const noexcept { return pattern_.empty(); }

  [[nodiscard]] const std::string& pattern() const noexcept { return pattern_; }

  [[nodiscard]] const std::vector<Text>& arguments() const noexcept { return arguments_; }

  /// Words from elsewhere, see above.
  [[nodiscard]] bool foreign() const noexcept { return foreign_; }

  /// Texts are equal when they read alike in English.
  friend bool operator==(const Text& a, const Text& b) { return a.str() == b.str(); }

private:
  std::string pattern_;
  std::vector<Text> arguments_;
  bool foreign_ = false;
};

std::ostream& operator<<(std::ostream& stream, const Text& text);

/// The one maker of what has arguments: `text("joint %1 is %2 deg beyond its limit", {name,
/// excess})`. Whole sentences in one pattern, no halves; one pattern per form (singular, plural).
Text text(const char* pattern, std::vector<Text> arguments = {});

/// "a, b, c" for the separator ", ", as nested texts: parts keep their languages.
Text joinTexts(const std::vector<Text>& parts, const std::string& separator);

/// The translation of a pattern, or the pattern itself where there is none.
using TranslateFunction = std::function<std::string(const std::string& pattern)>;

/// The text in another language: each pattern is translated, from the outside in. A place without
/// an argument stays as it is; a % in an argument is never a place.
std::string render(const Text& text, const TranslateFunction& translate);

std::vector<std::string> splitText(std::string_view text, char separator);
std::string_view trimText(std::string_view text) noexcept;
std::string joinText(const std::vector<std::string>& parts, std::string_view separator);
/// Locale-free; the whole text must be a finite number.
std::optional<double> parseReal(std::string_view text) noexcept;
/// Fixed number of decimals, locale-free, "-0.000" written as "0.000".
std::string formatFixed(double number, int decimals);
/// The candidate with the smallest edit distance, when close enough to be a likely typing error.
std::optional<std::string> nearestName(std::string_view name,
                                       const std::vector<std::string>& candidates);
/// True for 1..64 characters of [a-z0-9_.-] that start with a letter or digit: ids in projects and
/// plugins.
bool isValidId(std::string_view id) noexcept;

}  // namespace wcam
