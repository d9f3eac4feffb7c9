// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"

#include "piece_layers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <utility>

namespace wcam::branches {

namespace {

constexpr std::array<std::pair<std::string_view, Method>, 4> kMethods = {{
    {"common", Method::Common},
    {"geodesic", Method::Geodesic},
    {"isovalues", Method::IsoValues},
    {"spiral", Method::Spiral},
}};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

[[noreturn]] void refuse(std::string_view item, const Text& why) {
  throw Error(
      ErrorCode::InvalidArgument, text("'%1' %2", {std::string(item), why}),
      "slicing of branching parts, pieces",
      "write NUMBER=METHOD with commas between, as in '1=spiral, 3=isovalues', or *=METHOD; "
      "methods: common, geodesic, isovalues, spiral");
}

Method methodOf(std::string_view item, std::string_view word) {
  for (const auto& [name, method] : kMethods) {
    if (name == word) {
      return method;
    }
  }
  refuse(item, "names no method");
}

}  // namespace

Method PieceMethods::of(std::size_t piece) const {
  const auto found = own.find(piece);
  return found == own.end() ? rest : found->second;
}

bool PieceMethods::common() const {
  return rest == Method::Common && std::all_of(own.begin(), own.end(), [](const auto& entry) {
           return entry.second == Method::Common;
         });
}

PieceMethods parsePieceMethods(const std::string& text) {
  PieceMethods methods;
  std::string_view left = text;
  while (!trimmed(left).empty()) {
    const auto comma = left.find(',');
    const std::string_view item = trimmed(left.substr(0, comma));
    left = comma == std::string_view::npos ? std::string_view() : left.substr(comma + 1);
    const auto sign = item.find('=');
    if (sign == std::string_view::npos) {
      refuse(item, "has no '='");
    }
    const std::string_view piece = trimmed(item.substr(0, sign));
    const Method method = methodOf(item, trimmed(item.substr(sign + 1)));
    if (piece == "*") {
      methods.rest = method;
      continue;
    }
    std::size_t number = 0;
    const auto [end, code] = std::from_chars(piece.data(), piece.data() + piece.size(), number);
    if (code != std::errc() || end != piece.data() + piece.size() || piece.empty()) {
      refuse(item, "begins with no number of a piece");
    }
    if (!methods.own.emplace(number, method).second) {
      refuse(item, "names a piece twice");
    }
  }
  return methods;
}

}  // namespace wcam::branches
