// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/ascii.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>

namespace wcam::program {

namespace {

// What the letters of Unicode's Latin blocks are without their marks: their compatibility
// decomposition, and the usual spelling of those that have none. A blank: more than one letter, or
// none, see kSpellings.
constexpr std::uint32_t kFirstLatin = 0xC0;
constexpr std::string_view kLatin =
    "AAAAAA CEEEEIIIIDNOOOOOxOUUUUY  aaaaaa ceeeeiiiidnooooo/ouuuuy yAaAaAaCc"
    "CcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIi  JjKkkLlLlLl  LlNnNnNn   OoOo"
    "Oo  RrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs B        D   EE  f     "
    "Kk      Oo             Uu                            AaIiOoUuUuUuUuUu Aa"
    "Aa  GgGgKkOoOo  j   Gg  NnAa    AaAaEeEeIiIiOoOoRrRrUuUuSsTt  Hh      Aa"
    "EeOoOoOoOoYy                            ";
constexpr std::uint32_t kFirstAdditional = 0x1E00;
constexpr std::string_view kAdditional =
    "AaBbBbBbCcDdDdDdDdDdEeEeEeEeEeFfGgHhHhHhHhHhIiIiKkKkKkLlLlLlLlMmMmMmNnNn"
    "NnNnOoOoOoOoPpPpRrRrRrRrSsSsSsSsSsTtTtTtTtUuUuUuUuUuVvVvWwWwWwWwWwXxXxYy"
    "ZzZzZzhtwy s    AaAaAaAaAaAaAaAaAaAaAaAaEeEeEeEeEeEeEeEeIiIiOoOoOoOoOoOo"
    "OoOoOoOoOoOoUuUuUuUuUuUuUuYyYyYyYy      ";

struct Spelling {
  std::uint32_t code = 0;
  std::string_view ascii;
};

/// In the order of their codes.
constexpr auto kSpellings = std::to_array<Spelling>({
    {0xA0, " "},     {0xA9, "(c)"},   {0xAA, "a"},      {0xAB, "<<"},    {0xAE, "(R)"},
    {0xB0, "deg"},   {0xB1, "+-"},    {0xB2, "2"},      {0xB3, "3"},     {0xB5, "u"},
    {0xB7, "."},     {0xB9, "1"},     {0xBA, "o"},      {0xBB, ">>"},    {0xBC, "1/4"},
    {0xBD, "1/2"},   {0xBE, "3/4"},   {0xC6, "AE"},     {0xDE, "TH"},    {0xDF, "ss"},
    {0xE6, "ae"},    {0xFE, "th"},    {0x132, "IJ"},    {0x133, "ij"},   {0x14A, "NG"},
    {0x14B, "ng"},   {0x152, "OE"},   {0x153, "oe"},    {0x1C4, "DZ"},   {0x1C5, "Dz"},
    {0x1C6, "dz"},   {0x1C7, "LJ"},   {0x1C8, "Lj"},    {0x1C9, "lj"},   {0x1CA, "NJ"},
    {0x1CB, "Nj"},   {0x1CC, "nj"},   {0x1F1, "DZ"},    {0x1F2, "Dz"},   {0x1F3, "dz"},
    {0x1E9E, "SS"},  {0x2009, " "},   {0x2010, "-"},    {0x2011, "-"},   {0x2012, "-"},
    {0x2013, "-"},   {0x2014, "-"},   {0x2018, "'"},    {0x2019, "'"},   {0x201A, "'"},
    {0x201C, "\""},  {0x201D, "\""},  {0x201E, "\""},   {0x2026, "..."}, {0x202F, " "},
    {0x20AC, "EUR"}, {0x2116, "No."}, {0x2122, "(TM)"}, {0x2212, "-"},   {0xFB01, "fi"},
    {0xFB02, "fl"},
});

/// Marks that follow the letter that they belong to, as file names of some systems have them.
bool isMark(std::uint32_t code) {
  return code >= 0x300 && code <= 0x36F;
}

/// Stands for bytes that are no character.
constexpr std::uint32_t kReplacement = 0xFFFD;

/// The character at a place, which moves behind it. What is no UTF-8 counts as one unknown
/// character: a line break that is written in two bytes must not reach a program.
std::uint32_t next(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::uint32_t first = byte(at++);
  if (first < 0x80) {
    return first;
  }
  const int more = first >= 0xF8   ? 0
                   : first >= 0xF0 ? 3
                   : first >= 0xE0 ? 2
                   : first >= 0xC0 ? 1
                                   : 0;
  std::uint32_t code = first & (0x3FU >> static_cast<unsigned>(more));
  int taken = 0;
  for (; taken < more && at < text.size() && (byte(at) & 0xC0U) == 0x80U; ++taken) {
    code = (code << 6U) | (byte(at++) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 4> kSmallest = {0, 0x80, 0x800, 0x10000};
  const bool whole = more > 0 && taken == more;
  return whole && code >= kSmallest[static_cast<std::size_t>(more)] ? code : kReplacement;
}

char letterOf(std::uint32_t code) {
  if (code >= kFirstLatin && code - kFirstLatin < kLatin.size()) {
    return kLatin[code - kFirstLatin];
  }
  if (code >= kFirstAdditional && code - kFirstAdditional < kAdditional.size()) {
    return kAdditional[code - kFirstAdditional];
  }
  return ' ';
}

}  // namespace

std::string toAscii(std::string_view text, char unknown) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::uint32_t code = next(text, at);
    if (code < 0x80) {
      result += static_cast<char>(code);
    } else if (const char letter = letterOf(code); letter != ' ') {
      result += letter;
    } else if (!isMark(code)) {
      const auto known =
          std::lower_bound(kSpellings.begin(), kSpellings.end(), code,
                           [](const Spelling& own, std::uint32_t c) { return own.code < c; });
      if (known != kSpellings.end() && known->code == code) {
        result += known->ascii;
      } else {
        result += unknown;
      }
    }
  }
  return result;
}

}  // namespace wcam::program
