// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/text_writer.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace wcam::program {

namespace detail {

namespace {

constexpr std::array<char, 200> digitPairs() {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < 100; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}

[[noreturn]] void unprintable(double value) {
  throw Error(ErrorCode::InvalidArgument, std::isfinite(value)
                                              ? "a number is too large for a robot program"
                                              : "a number that is not finite cannot be printed");
}

/// Room for the largest double in fixed notation.
using LongNumber = std::array<char, 400>;

std::string_view formatExactly(LongNumber& buffer, double value, int decimals) {
  if (!std::isfinite(value)) {
    unprintable(value);
  }
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                          std::chars_format::fixed, decimals);
  WCAM_ASSERT(error == std::errc{});
  return {buffer.data(), static_cast<std::size_t>(end - buffer.data())};
}

}  // namespace

const std::array<char, 200> kDigitPairs = digitPairs();

char* writeLarge(char* out, std::uint64_t number) noexcept {
  char digits[20];
  char* begin = digits + sizeof digits;
  while (number >= 100) {
    begin -= 2;
    std::memcpy(begin, kDigitPairs.data() + 2 * (number % 100), 2);
    number /= 100;
  }
  if (number >= 10) {
    begin -= 2;
    std::memcpy(begin, kDigitPairs.data() + 2 * number, 2);
  } else {
    *--begin = static_cast<char>('0' + number);
  }
  const auto size = static_cast<std::size_t>(digits + sizeof digits - begin);
  std::memcpy(out, begin, size);
  return out + size;
}

std::uint64_t roundScaledExactly(double magnitude, int decimals) {
  constexpr std::uint64_t kLimit = 1'000'000'000'000'000'000U;
  LongNumber buffer;
  std::uint64_t digits = 0;
  for (const char c : formatExactly(buffer, magnitude, decimals)) {
    if (c != '.') {
      digits = 10 * digits + static_cast<std::uint64_t>(c - '0');
      if (digits >= kLimit) {
        unprintable(magnitude);
      }
    }
  }
  return digits;
}

}  // namespace detail

TextWriter& TextWriter::integer(std::int64_t number, std::size_t width) {
  const std::size_t begin = size_;
  char* const first = room(kNumberSize);
  // Negating as unsigned is defined for the smallest integer, too.
  const auto magnitude =
      number < 0 ? 0U - static_cast<std::uint64_t>(number) : static_cast<std::uint64_t>(number);
  size_ += static_cast<std::size_t>(write(first, number < 0, magnitude, 0, 1) - first);
  alignRight(begin, width);
  return *this;
}

TextWriter& TextWriter::fixed(double value, int decimals, std::size_t width) {
  WCAM_ASSERT(decimals >= 0 && decimals <= kMaxDecimals);
  const std::size_t begin = size_;
  const auto index = static_cast<std::size_t>(decimals);
  std::uint64_t rounded = 0;
  if (detail::roundScaled(std::abs(value), detail::kPowers[index], rounded)) {
    char* const first = room(kNumberSize);
    size_ += static_cast<std::size_t>(
        write(first, value < 0.0, rounded, decimals, detail::kIntegerPowers[index]) - first);
  } else {
    fixedSlowly(value, decimals);
  }
  alignRight(begin, width);
  return *this;
}

TextWriter& TextWriter::digits(std::int64_t digits, int decimals, std::size_t width) {
  WCAM_ASSERT(decimals >= 0 && decimals <= kMaxDecimals);
  const std::size_t begin = size_;
  const auto magnitude =
      digits < 0 ? 0U - static_cast<std::uint64_t>(digits) : static_cast<std::uint64_t>(digits);
  char* const first = room(kNumberSize);
  size_ +=
      static_cast<std::size_t>(write(first, digits < 0, magnitude, decimals,
                                     detail::kIntegerPowers[static_cast<std::size_t>(decimals)]) -
                               first);
  alignRight(begin, width);
  return *this;
}

std::string TextWriter::take() {
  buffer_.resize(size_);
  size_ = 0;
  return std::exchange(buffer_, std::string());
}

void TextWriter::grow(std::size_t size) {
  constexpr std::size_t kSmallest = 4096;
  buffer_.resize(std::max({kSmallest, 2 * buffer_.size(), size_ + size}));
}

TextWriter& TextWriter::fixedSlowly(double value, int decimals) {
  detail::LongNumber buffer;
  std::string_view number = detail::formatExactly(buffer, value, decimals);
  if (number.front() == '-' && number.find_first_not_of("-0.") == std::string_view::npos) {
    number.remove_prefix(1);
  }
  return text(number);
}

void TextWriter::alignRight(std::size_t begin, std::size_t width) {
  const std::size_t length = size_ - begin;
  if (length >= width) {
    return;
  }
  const std::size_t missing = width - length;
  room(missing);
  std::memmove(buffer_.data() + begin + missing, buffer_.data() + begin, length);
  std::memset(buffer_.data() + begin, ' ', missing);
  size_ += missing;
}

}  // namespace wcam::program
