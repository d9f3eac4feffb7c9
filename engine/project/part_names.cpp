// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "part_names.hpp"

#include "wcam/base/text.hpp"

#include <charconv>
#include <string_view>

namespace wcam::project::detail {

namespace {

/// The argument of "part %1" in a pattern, from 0; -1 where there is none.
int partArgument(const std::string& pattern) {
  constexpr std::string_view kWords = "part %";
  const std::size_t at = pattern.find(kWords);
  if (at == std::string::npos || at + kWords.size() >= pattern.size() ||
      (at > 0 && pattern[at - 1] != ' ')) {
    return -1;
  }
  const char digit = pattern[at + kWords.size()];
  return digit >= '1' && digit <= '9' ? digit - '1' : -1;
}

Text named(const Text& text, const std::vector<std::string>& ids) {
  if (text.arguments().empty()) {
    return text;
  }
  const int part = partArgument(text.pattern());
  std::vector<Text> arguments;
  for (std::size_t i = 0; i < text.arguments().size(); ++i) {
    const Text& argument = text.arguments()[i];
    std::size_t number = 0;
    if (static_cast<int>(i) == part && argument.foreign()) {
      const std::string& digits = argument.pattern();
      const auto [end, error] =
          std::from_chars(digits.data(), digits.data() + digits.size(), number);
      number = error == std::errc() && end == digits.data() + digits.size() ? number : 0;
    }
    arguments.push_back(number >= 1 && number <= ids.size() ? Text("'" + ids[number - 1] + "'")
                                                            : named(argument, ids));
  }
  return {text.pattern(), std::move(arguments)};
}

}  // namespace

std::vector<Diagnostic> withPartNames(std::vector<Diagnostic> findings,
                                      const std::vector<std::string>& ids) {
  for (Diagnostic& finding : findings) {
    finding.message = named(finding.message, ids);
    finding.remedy = named(finding.remedy, ids);
  }
  return findings;
}

}  // namespace wcam::project::detail
