// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_scanner.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>

namespace wcam::io {

namespace {

bool isBlank(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

char lower(char c) noexcept {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Longest piece of a damaged file in a message.
constexpr std::size_t kQuotedSize = 24;

/// Number of continuation bytes after a UTF-8 lead byte, or -1.
int continuationCount(unsigned char lead) noexcept {
  if (lead < 0x80) {
    return 0;
  }
  if (lead >= 0xC2 && lead <= 0xDF) {
    return 1;
  }
  if (lead >= 0xE0 && lead <= 0xEF) {
    return 2;
  }
  return lead >= 0xF0 && lead <= 0xF4 ? 3 : -1;
}

/// Length of the valid UTF-8 sequence at the start of a text, 0 when there is none.
std::size_t sequenceLength(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const int more = continuationCount(byte(0));
  if (more < 0 || text.size() <= static_cast<std::size_t>(more)) {
    return 0;
  }
  for (std::size_t i = 1; i <= static_cast<std::size_t>(more); ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) {
      return 0;
    }
  }
  // Overlong forms, surrogates and numbers beyond Unicode.
  const bool bad = (byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xED && byte(1) > 0x9F) ||
                   (byte(0) == 0xF0 && byte(1) < 0x90) || (byte(0) == 0xF4 && byte(1) > 0x8F);
  return bad ? 0 : static_cast<std::size_t>(more) + 1;
}

}  // namespace

std::string quoted(std::string_view word) {
  std::string text(1, '\'');
  for (const char c : word.substr(0, kQuotedSize)) {
    text.push_back(c >= ' ' && c <= '~' ? c : '?');
  }
  text.push_back('\'');
  return text;
}

std::string printableName(std::string_view text) {
  std::string name;
  while (!text.empty()) {
    const std::size_t length = sequenceLength(text);
    const bool control = static_cast<unsigned char>(text.front()) < 0x20 || text.front() == 0x7F;
    if (length == 0 || control) {
      name.push_back(control ? ' ' : '?');
    } else {
      name.append(text.substr(0, length));
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return name;
}

std::string_view TextScanner::takeWord() {
  const std::size_t begin = position_;
  while (position_ < text_.size() && !isBlank(text_[position_])) {
    ++position_;
  }
  return text_.substr(begin, position_ - begin);
}

std::string_view TextScanner::word() {
  while (position_ < text_.size() && isBlank(text_[position_])) {
    line_ += text_[position_] == '\n' ? 1 : 0;
    ++position_;
  }
  return takeWord();
}

std::string_view TextScanner::wordOnLine() {
  while (position_ < text_.size() && isBlank(text_[position_]) && text_[position_] != '\n') {
    ++position_;
  }
  return takeWord();
}

std::string_view TextScanner::restOfLine() {
  std::size_t begin = position_;
  const std::size_t lineEnd = text_.find('\n', position_);
  std::size_t end = lineEnd == std::string_view::npos ? text_.size() : lineEnd;
  position_ = lineEnd == std::string_view::npos ? text_.size() : lineEnd + 1;
  line_ += lineEnd == std::string_view::npos ? 0 : 1;
  while (begin < end && isBlank(text_[begin])) {
    ++begin;
  }
  while (end > begin && isBlank(text_[end - 1])) {
    --end;
  }
  return text_.substr(begin, end - begin);
}

bool equalNoCase(std::string_view word, std::string_view lowerCase) noexcept {
  if (word.size() != lowerCase.size()) {
    return false;
  }
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (lower(word[i]) != lowerCase[i]) {
      return false;
    }
  }
  return true;
}

std::optional<double> scanNumber(std::string_view word) noexcept {
  if (!word.empty() && word.front() == '+') {
    word.remove_prefix(1);
    if (!word.empty() && word.front() == '-') {
      return std::nullopt;
    }
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || word.empty()) {
    return std::nullopt;
  }
  if (error == std::errc::result_out_of_range) {
    // Too small when the exponent is negative or there is none ("0.000…1").
    const std::size_t exponent = word.find_first_of("eE");
    const bool large = exponent == std::string_view::npos
                           ? word.find_first_not_of("-0") < word.find('.')
                           : exponent + 1 < word.size() && word[exponent + 1] != '-';
    value = large ? std::numeric_limits<double>::infinity() : 0.0;
  } else if (error != std::errc()) {
    return std::nullopt;
  }
  return value;
}

}  // namespace wcam::io
