// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/names.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/sha256.hpp"
#include "wcam/base/text.hpp"
#include "wcam/program/ascii.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace wcam::program {

namespace {

bool isLetter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

constexpr std::size_t kHashLength = 3;
/// Two characters of the name, a mark and the hash.
constexpr std::size_t kShortestName = kHashLength + 3;

/// Three characters 0-9 A-Z that depend on the whole text.
std::string hashText(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  // 12 hexadecimal digits are far more than 36^3 and fit 64 bits.
  std::uint64_t number = std::stoull(sha256Hex(text).substr(0, 12), nullptr, 16);
  std::string result;
  for (std::size_t i = 0; i < kHashLength; ++i) {
    result += kDigits[number % kDigits.size()];
    number /= kDigits.size();
  }
  return result;
}

}  // namespace

std::string controllerName(std::string_view text,
                           std::size_t maxLength,
                           std::string_view fallback) {
  WCAM_ASSERT(maxLength >= kShortestName);
  std::string name;
  for (const char c : toAscii(text, '_')) {
    if (name.empty() && !isLetter(c)) {
      // A leading digit is worth keeping behind a letter; leading marks are not.
      name += isDigit(c) ? std::string("P") + c : std::string();
      continue;
    }
    name += isLetter(c) ? upper(c) : (isDigit(c) ? c : '_');
  }
  while (name.ends_with('_')) {
    name.pop_back();
  }
  if (name.empty()) {
    name = fallback;
  }
  if (name.size() > maxLength) {
    name = name.substr(0, maxLength - kHashLength - 1) + '_' + hashText(text);
  }
  return name;
}

bool isReserved(std::string_view name, const NameRules& rules) {
  constexpr std::array<std::string_view, 4> kDevices = {"CON", "PRN", "AUX", "NUL"};
  constexpr std::size_t kPortLength = 4;  // COM1, LPT1
  const bool port = name.size() == kPortLength && isDigit(name.back()) &&
                    (name.starts_with("COM") || name.starts_with("LPT"));
  return port || std::find(kDevices.begin(), kDevices.end(), name) != kDevices.end() ||
         std::find(rules.reserved.begin(), rules.reserved.end(), name) != rules.reserved.end();
}

std::vector<std::string> partNames(std::string_view wanted,
                                   std::size_t parts,
                                   const NameRules& rules) {
  const std::size_t maxLength = rules.longest;
  const std::string text = isReserved(controllerName(wanted, maxLength), rules)
                               ? "P_" + std::string(wanted)
                               : std::string(wanted);
  const std::size_t width = std::to_string(parts).size();
  if (maxLength < kShortestName + width + 1) {
    throw Error(ErrorCode::InvalidArgument,
                wcam::text("names of %1 characters have no room for %2 numbered programs",
                           {std::to_string(maxLength), std::to_string(parts)}),
                {}, "allow longer names or more points per program");
  }
  const std::string main = controllerName(text, maxLength);
  const std::string stem = controllerName(text, maxLength - width - 1);
  // Where the main name itself ends in a number, another mark keeps the parts apart from it.
  const std::string mark = main.starts_with(stem + "_") ? "P" : "_";
  std::vector<std::string> names{main};
  for (std::size_t i = 1; i <= parts; ++i) {
    const std::string number = std::to_string(i);
    std::string name = stem + mark;
    name.append(width - number.size(), '0').append(number);
    names.push_back(std::move(name));
  }
  return names;
}

std::string asciiComment(std::string_view text) {
  std::string result = toAscii(text, '?');
  for (char& c : result) {
    const auto code = static_cast<unsigned char>(c);
    c = code < 0x20 || code == 0x7F ? ' ' : c;
  }
  return result;
}

bool keepsName(std::string_view text, std::string_view name) {
  return std::equal(text.begin(), text.end(), name.begin(), name.end(), [](char a, char b) {
    return upper(a) == b || (b == '_' && (a == '-' || a == ' ' || a == '.'));
  });
}

std::vector<std::string> wrapComment(std::string_view text, std::size_t width) {
  const std::string ascii = asciiComment(text);
  std::string_view rest = trimText(ascii);
  std::vector<std::string> lines;
  while (rest.size() > width) {
    std::size_t cut = rest.rfind(' ', width);
    cut = cut == std::string_view::npos || cut == 0 ? width : cut;
    lines.emplace_back(trimText(rest.substr(0, cut)));
    rest = trimText(rest.substr(cut));
  }
  if (!rest.empty() || lines.empty()) {
    lines.emplace_back(rest);
  }
  return lines;
}

}  // namespace wcam::program
