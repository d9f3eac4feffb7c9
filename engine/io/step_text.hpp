// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace wcam::io {

/// A STEP file in UTF-8.
struct RecodedStep {
  std::string text;
  /// Encoding that its strings were taken for ("GB18030"); empty when it could not be found and
  /// their letters were replaced.
  std::string encoding;
  std::size_t strings = 0;  ///< that were converted
};

/// Converts strings in a national encoding, which older CAD systems write as they are: GB18030,
/// Shift-JIS, EUC-JP, Big5, Windows-1252 (with Latin-1) and Windows-1251. The encoding is found
/// from the letters that are usual in each. Nothing for a file that is ASCII or UTF-8.
std::optional<RecodedStep> recodeStep(std::string_view bytes);

/// The entities of a STEP file by number: text after the equals sign, without the semicolon.
using StepEntities = std::unordered_map<std::uint64_t, std::string_view>;

StepEntities stepEntities(std::string_view text);

/// Reads the parameters of an entity one after the other. What does not fit gives nothing and
/// leaves the cursor at the place.
class StepCursor {
public:
  explicit StepCursor(std::string_view text) : text_(text) {}

  /// Name before a parenthesis; empty for a complex instance.
  std::string_view keyword();
  /// Takes the character when it is next, after blanks and comments.
  bool take(char c);
  std::optional<std::string_view> string();  ///< as written, without the quotes
  std::optional<double> number();
  std::optional<std::uint64_t> reference();
  /// Takes one value of any kind.
  bool skip();

  [[nodiscard]] std::size_t position() const noexcept { return position_; }

private:
  void blanks();

  std::string_view text_;
  std::size_t position_ = 0;
};

/// Other files with shapes that an assembly refers to, as written.
std::vector<std::string> externalFilesOf(std::string_view text);

}  // namespace wcam::io
