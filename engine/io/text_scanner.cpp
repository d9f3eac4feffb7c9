// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_scanner.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <system_error>

namespace wcam::io {

namespace {

constexpr char kCtrlZ = '\x1a';

bool isLineEnd(char c) noexcept {
  return c == '\n' || c == '\r';
}

bool isBlank(char c) noexcept {
  return c == ' ' || (c >= '\t' && c <= '\r') || c == '\0' || c == kCtrlZ;
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

void appendUtf8(std::string& text, std::uint32_t code) {
  if (code < 0x80) {
    text.push_back(static_cast<char>(code));
    return;
  }
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  constexpr std::array<std::uint32_t, 4> kLead{0, 0xC0, 0xE0, 0xF0};
  text.push_back(
      static_cast<char>(kLead[static_cast<std::size_t>(more)] | code >> 6U * unsigned(more)));
  for (int k = more - 1; k >= 0; --k) {
    text.push_back(static_cast<char>(0x80U | (code >> 6U * unsigned(k) & 0x3FU)));
  }
}

/// @param bytes after the mark
std::string fromUtf16(std::string_view bytes, bool bigEndian) {
  const auto unit = [&](std::size_t i) -> std::uint32_t {
    const auto first = static_cast<unsigned char>(bytes[i]);
    const auto second = static_cast<unsigned char>(bytes[i + 1]);
    return bigEndian ? first << 8U | second : second << 8U | first;
  };
  std::string text;
  text.reserve(bytes.size() / 2 + 1);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    std::uint32_t code = unit(i);
    const bool high = code >= 0xD800 && code < 0xDC00;
    const std::uint32_t low = high && i + 3 < bytes.size() ? unit(i + 2) : 0;
    if (high && low >= 0xDC00 && low < 0xE000) {
      code = 0x10000U + ((code - 0xD800U) << 10U) + (low - 0xDC00U);
      i += 2;
    } else if (code >= 0xD800 && code < 0xE000) {
      code = 0xFFFD;  // half of a pair
    }
    appendUtf8(text, code);
  }
  return text;
}

}  // namespace

std::string_view withoutByteOrderMark(std::string_view bytes) noexcept {
  return bytes.starts_with("\xEF\xBB\xBF") ? bytes.substr(3) : bytes;
}

PlainText::PlainText(std::string_view bytes) : original_(withoutByteOrderMark(bytes)) {
  const bool little = bytes.starts_with("\xFF\xFE");
  if (little || bytes.starts_with("\xFE\xFF")) {
    converted_ = fromUtf16(bytes.substr(2), !little);
  }
}

bool looksLikeText(std::string_view bytes) noexcept {
  constexpr std::size_t kLookedAt = 4096;
  std::string_view head = bytes.substr(0, kLookedAt);
  while (!head.empty() && (head.back() == '\0' || head.back() == kCtrlZ)) {
    head.remove_suffix(1);
  }
  return std::all_of(head.begin(), head.end(), [](char c) {
    return static_cast<unsigned char>(c) >= 0x20 || (isBlank(c) && c != '\0');
  });
}

std::size_t utf8Length(std::string_view text) noexcept {
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
    const std::size_t length = utf8Length(text);
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
    if (isLineEnd(text_[position_])) {
      takeLineEnd();
    } else {
      ++position_;
    }
  }
  return takeWord();
}

void TextScanner::takeLineEnd() noexcept {
  const bool pair = text_.substr(position_, 2) == "\r\n";
  position_ += pair ? 2 : 1;
  ++line_;
}

std::string_view TextScanner::peekWord() const {
  TextScanner ahead = *this;
  return ahead.word();
}

bool TextScanner::atLineEnd() const noexcept {
  std::size_t at = position_;
  while (at < text_.size() && isBlank(text_[at]) && !isLineEnd(text_[at])) {
    ++at;
  }
  return at >= text_.size() || isLineEnd(text_[at]);
}

std::string_view TextScanner::wordOnLine() {
  while (position_ < text_.size() && isBlank(text_[position_]) && !isLineEnd(text_[position_])) {
    ++position_;
  }
  return takeWord();
}

std::string_view TextScanner::restOfLine() {
  std::size_t begin = position_;
  while (position_ < text_.size() && !isLineEnd(text_[position_])) {
    ++position_;
  }
  std::size_t end = position_;
  if (position_ < text_.size()) {
    takeLineEnd();
  }
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

namespace {

/// A Fortran number in the notation of C; empty when it is none or too long.
std::string_view withPlainExponent(std::string_view word, std::array<char, 64>& buffer) noexcept {
  const std::size_t exponent = word.find_first_of("dD");
  const bool digits = word.find_first_not_of("0123456789.+-dD") == std::string_view::npos;
  if (exponent == 0 || exponent == std::string_view::npos || !digits ||
      word.size() > buffer.size()) {
    return {};
  }
  std::copy(word.begin(), word.end(), buffer.begin());
  buffer[exponent] = 'e';
  return {buffer.data(), word.size()};
}

std::optional<double> scanPlainNumber(std::string_view word) noexcept {
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

}  // namespace

std::optional<double> scanNumber(std::string_view word) noexcept {
  const std::optional<double> number = scanPlainNumber(word);
  std::array<char, 64> buffer;
  return number ? number : scanPlainNumber(withPlainExponent(word, buffer));
}

}  // namespace wcam::io
