// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/error.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

/// Fast text for robot programs: fixed decimals into one growing buffer, independent of the locale.
///
/// Numbers come out as std::to_chars(fixed, decimals) writes them, to the last digit, except that
/// nothing is written as "-0.000". The fast path scales and rounds to an integer; next to a tie,
/// where the scaled product might round the other way, and beyond 2^50 units of the last place
/// std::to_chars decides.
namespace wcam::program {

inline constexpr int kMaxDecimals = 9;

namespace detail {

inline constexpr std::array<double, kMaxDecimals + 1> kPowers = {1e0, 1e1, 1e2, 1e3, 1e4,
                                                                 1e5, 1e6, 1e7, 1e8, 1e9};
inline constexpr std::array<std::uint64_t, kMaxDecimals + 1> kIntegerPowers = {
    1U, 10U, 100U, 1000U, 10000U, 100000U, 1000000U, 10000000U, 100000000U, 1000000000U};

/// Two digits of every number from 00 to 99.
extern const std::array<char, 200> kDigitPairs;

/// |value|·10^decimals rounded to the nearest integer; false where that is not certain.
/// With scaled < 2^50 the fraction is exact, and the product is off by at most scaled·2^-53.
inline bool roundScaled(double magnitude, double power, std::uint64_t& rounded) noexcept {
  constexpr double kLimit = 0x1p50;
  const double scaled = magnitude * power;
  if (!(scaled < kLimit)) {
    return false;
  }
  const auto whole = static_cast<std::int64_t>(scaled);
  const double fraction = scaled - static_cast<double>(whole);
  rounded = static_cast<std::uint64_t>(whole) + (fraction > 0.5 ? 1U : 0U);
  return std::abs(fraction - 0.5) > scaled * 0x1p-52;
}

/// The same by std::to_chars. @throws Error(InvalidArgument) for a number that is not finite or
/// whose digits do not fit 64 bits
std::uint64_t roundScaledExactly(double magnitude, int decimals);

/// Digits of a number below 10000, without branches on its size. Writes 4 characters.
/// @return past the last digit
inline char* writeSmall(char* out, std::size_t number) noexcept {
  static_assert(std::endian::native == std::endian::little, "the first digit is the lowest byte");
  char digits[8];
  std::memcpy(digits, kDigitPairs.data() + 2 * (number / 100), 2);
  std::memcpy(digits + 2, kDigitPairs.data() + 2 * (number % 100), 2);
  const std::size_t leading = static_cast<std::size_t>(number < 1000) +
                              static_cast<std::size_t>(number < 100) +
                              static_cast<std::size_t>(number < 10);
  std::uint64_t word = 0;
  std::memcpy(&word, digits, 4);
  word >>= 8 * leading;
  std::memcpy(out, &word, 4);
  return out + 4 - leading;
}

/// Digits of a whole number, at most 20. @return past the last one
char* writeLarge(char* out, std::uint64_t number) noexcept;

inline char* writeWhole(char* out, std::uint64_t number) noexcept {
  constexpr std::uint64_t kSmall = 10000;
  return number < kSmall ? writeSmall(out, static_cast<std::size_t>(number))
                         : writeLarge(out, number);
}

/// Exactly `decimals` digits. @return past the last one
inline char* writeFraction(char* out, std::uint64_t fraction, int decimals) noexcept {
  char* const end = out + decimals;
  char* at = end;
  for (; decimals >= 2; decimals -= 2) {
    at -= 2;
    std::memcpy(at, kDigitPairs.data() + 2 * (fraction % 100), 2);
    fraction /= 100;
  }
  if (decimals == 1) {
    *--at = static_cast<char>('0' + fraction);
  }
  return end;
}

/// The same with decimals that the compiler knows.
template <int Decimals>
char* writeFraction(char* out, std::uint64_t fraction) noexcept {
  if constexpr (Decimals >= 2) {
    writeFraction<Decimals - 2>(out, fraction / 100);
    std::memcpy(out + Decimals - 2, kDigitPairs.data() + 2 * (fraction % 100), 2);
  } else if constexpr (Decimals == 1) {
    *out = static_cast<char>('0' + fraction);
  }
  return out + Decimals;
}

}  // namespace detail

/// The integer whose digits `value` is printed with: value in units of 10^-decimals, rounded. Equal
/// integers mean equal texts: what modal output has to compare.
/// @throws Error(InvalidArgument) for a number that is not finite, or beyond 18 digits
inline std::int64_t fixedDigits(double value, int decimals) {
  std::uint64_t rounded = 0;
  if (!detail::roundScaled(std::abs(value), detail::kPowers[static_cast<std::size_t>(decimals)],
                           rounded)) {
    rounded = detail::roundScaledExactly(std::abs(value), decimals);
  }
  const auto digits = static_cast<std::int64_t>(rounded);
  return value < 0.0 ? -digits : digits;
}

/// Remembers a printed number and tells whether the next one would be printed otherwise.
class ModalNumber {
public:
  /// True for the first digits and for others than the last ones.
  bool changes(std::int64_t digits) noexcept {
    const bool changed = !known_ || digits != digits_;
    known_ = true;
    digits_ = digits;
    return changed;
  }

  void forget() noexcept { known_ = false; }

private:
  bool known_ = false;
  std::int64_t digits_ = 0;
};

/// Appends text to a buffer. Members return the writer for chaining.
class TextWriter {
public:
  explicit TextWriter(std::size_t capacity = 4096) : buffer_(capacity, '\0') {}

  TextWriter& text(std::string_view text) {
    std::memcpy(room(text.size()), text.data(), text.size());
    size_ += text.size();
    return *this;
  }

  TextWriter& blanks(std::size_t count) {
    std::memset(room(count), ' ', count);
    size_ += count;
    return *this;
  }

  /// @param width the text is filled up with blanks on the left
  TextWriter& integer(std::int64_t number, std::size_t width = 0);

  /// A number with `Decimals` digits behind the point; none and no point for 0.
  /// @throws Error(InvalidArgument) for a number that is not finite
  template <int Decimals>
  TextWriter& fixed(double value) {
    static_assert(Decimals >= 0 && Decimals <= kMaxDecimals);
    std::uint64_t rounded = 0;
    if (!detail::roundScaled(std::abs(value), detail::kPowers[Decimals], rounded)) {
      return fixedSlowly(value, Decimals);
    }
    constexpr std::uint64_t kPower = detail::kIntegerPowers[Decimals];
    char* const begin = room(kNumberSize);
    *begin = '-';
    char* out = begin + static_cast<std::size_t>(value < 0.0 && rounded != 0);
    out = detail::writeWhole(out, rounded / kPower);
    if constexpr (Decimals > 0) {
      *out++ = '.';
      out = detail::writeFraction<Decimals>(out, rounded % kPower);
    }
    size_ += static_cast<std::size_t>(out - begin);
    return *this;
  }

  /// The same with decimals that are known at run time only, 0 to kMaxDecimals.
  TextWriter& fixed(double value, int decimals, std::size_t width = 0);

  /// Prints the digits that fixedDigits() returned.
  TextWriter& digits(std::int64_t digits, int decimals, std::size_t width = 0);

  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  [[nodiscard]] std::string_view view() const noexcept { return {buffer_.data(), size_}; }

  /// Forgets what was written and keeps the memory.
  void clear() noexcept { size_ = 0; }

  /// Hands over what was written; the writer is empty afterwards.
  [[nodiscard]] std::string take();

private:
  /// Longest number of the fast path: sign, 16 digits, a leading zero, the point.
  static constexpr std::size_t kNumberSize = 32;

  char* room(std::size_t size) {
    if (buffer_.size() - size_ < size) {
      grow(size);
    }
    return buffer_.data() + size_;
  }

  static char* write(
      char* out, bool negative, std::uint64_t rounded, int decimals, std::uint64_t power) noexcept {
    if (negative && rounded != 0) {
      *out++ = '-';
    }
    out = detail::writeWhole(out, rounded / power);
    if (decimals > 0) {
      *out++ = '.';
      out = detail::writeFraction(out, rounded % power, decimals);
    }
    return out;
  }

  void grow(std::size_t size);
  TextWriter& fixedSlowly(double value, int decimals);
  void alignRight(std::size_t begin, std::size_t width);

  std::string buffer_;
  std::size_t size_ = 0;
};

}  // namespace wcam::program
