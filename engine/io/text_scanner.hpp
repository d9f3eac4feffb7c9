// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace wcam::io {

/// Words and lines of a text in memory; blanks are space, tab, CR, LF, form feed.
class TextScanner {
public:
  explicit TextScanner(std::string_view text) : text_(text) {}

  /// Next word over line ends; empty at the end.
  std::string_view word();
  /// Next word on this line; empty at the end of the line.
  std::string_view wordOnLine();
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

  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
};

bool equalNoCase(std::string_view word, std::string_view lowerCase) noexcept;

/// A number as files have it: also with a leading '+', "nan" and "inf"; too large counts as
/// infinite, too small as 0. Independent of the locale.
std::optional<double> scanNumber(std::string_view word) noexcept;

/// The start of a word of a damaged file for a message: quoted, other bytes than plain text as '?'.
std::string quoted(std::string_view word);

/// A name out of a file as valid UTF-8 on one line; text in another encoding loses its letters
/// beyond ASCII.
std::string printableName(std::string_view text);

}  // namespace wcam::io
