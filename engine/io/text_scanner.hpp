// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace wcam::io {

/// A text without the byte order mark at its start.
std::string_view withoutByteOrderMark(std::string_view bytes) noexcept;

/// A text that may be UTF-16 (as some systems save it, with a byte order mark) as UTF-8 without
/// mark. Bytes of another encoding stay as they are.
class PlainText {
public:
  explicit PlainText(std::string_view bytes);

  [[nodiscard]] std::string_view view() const noexcept {
    return converted_.empty() ? original_ : std::string_view(converted_);
  }

private:
  std::string_view original_;
  std::string converted_;
};

/// True when the start of the bytes holds no control characters other than blanks. Zeros and
/// Ctrl-Z at their end do not count: some systems fill up with them.
bool looksLikeText(std::string_view bytes) noexcept;

/// Words and lines of a text in memory. Blanks are space, tab, line ends, form feed, and what fills
/// files up: zero and Ctrl-Z. Lines end with LF, CR LF or CR.
class TextScanner {
public:
  explicit TextScanner(std::string_view text) : text_(text) {}

  /// Next word over line ends; empty at the end.
  std::string_view word();
  /// Next word on this line; empty at the end of the line.
  std::string_view wordOnLine();
  /// The word that word() will give.
  [[nodiscard]] std::string_view peekWord() const;
  /// True when only blanks follow on this line.
  [[nodiscard]] bool atLineEnd() const noexcept;
  /// What is left of this line without blanks around it; moves to the next line.
  std::string_view restOfLine();

  void skipLine() { restOfLine(); }

  [[nodiscard]] bool atEnd() const noexcept { return position_ >= text_.size(); }

  /// Line of the last word, counted from 1.
  [[nodiscard]] std::size_t line() const noexcept { return line_; }

  [[nodiscard]] std::size_t position() const noexcept { return position_; }

  [[nodiscard]] double fractionDone() const noexcept {
    return text_.empty() ? 1.0 : static_cast<double>(position_) / static_cast<double>(text_.size());
  }

private:
  std::string_view takeWord();
  /// Takes the line end at the position.
  void takeLineEnd() noexcept;

  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
};

bool equalNoCase(std::string_view word, std::string_view lowerCase) noexcept;

/// A number as files have it: also with a leading '+', a Fortran exponent ("1.5D+02"), "nan" and
/// "inf"; too large counts as infinite, too small as 0. Independent of the locale.
std::optional<double> scanNumber(std::string_view word) noexcept;

/// The start of a word of a damaged file for a message: quoted, other bytes than plain text as '?'.
std::string quoted(std::string_view word);

/// Largest coordinate that is taken, in units of the file: a thousand times the way around the
/// Earth in mm. Squares and cubes of larger numbers overflow on the way.
inline constexpr double kLargestCoordinate = 1e13;

/// True for a number of at most kLargestCoordinate.
inline bool isCoordinate(double x) noexcept {
  return x >= -kLargestCoordinate && x <= kLargestCoordinate;
}

/// Length of the valid UTF-8 sequence at the start of a text that is not empty, 0 when there is
/// none.
std::size_t utf8Length(std::string_view text) noexcept;

/// A name out of a file as valid UTF-8 on one line; text in another encoding loses its letters
/// beyond ASCII.
std::string printableName(std::string_view text);

}  // namespace wcam::io
