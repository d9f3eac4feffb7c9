// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <ostream>
#include <utility>

namespace wcam {

namespace {
std::string rendered(const Text& text, const TranslateFunction& translate, bool argument) {
  if (argument && text.foreign()) {
    return text.pattern();
  }
  std::string pattern = translate ? translate(text.pattern()) : text.pattern();
  const std::vector<Text>& arguments = text.arguments();
  if (arguments.empty()) {
    return pattern;
  }
  std::string result;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const char digit = pattern[i] == '%' && i + 1 < pattern.size() ? pattern[i + 1] : '0';
    const auto place = static_cast<std::size_t>(digit - '1');
    if (digit >= '1' && digit <= '9' && place < arguments.size()) {
      result += rendered(arguments[place], translate, true);
      ++i;
    } else {
      result += pattern[i];
    }
  }
  return result;
}

/// In halves, so that the nesting of a list of any length stays shallow.
Text joined(const Text* parts, std::size_t count, const std::string& pattern) {
  if (count == 1) {
    return *parts;
  }
  const std::size_t half = count / 2;
  std::vector<Text> halves;
  halves.reserve(2);
  halves.push_back(joined(parts, half, pattern));
  halves.push_back(joined(parts + half, count - half, pattern));
  return {pattern, std::move(halves)};
}
}  // namespace

Text::Text(const char* words) : pattern_(words) {}

Text::Text(std::string words) : pattern_(std::move(words)), foreign_(true) {}

Text::Text(std::string pattern, std::vector<Text> arguments)
    : pattern_(std::move(pattern)), arguments_(std::move(arguments)) {}

std::string Text::str() const {
  return arguments_.empty() ? pattern_ : rendered(*this, {}, false);
}

std::ostream& operator<<(std::ostream& stream, const Text& text) {
  return stream << text.str();
}

Text text(const char* pattern, std::vector<Text> arguments) {
  return {pattern, std::move(arguments)};
}

Text joinTexts(const std::vector<Text>& parts, const std::string& separator) {
  return parts.empty() ? Text() : joined(parts.data(), parts.size(), "%1" + separator + "%2");
}

std::string render(const Text& text, const TranslateFunction& translate) {
  return rendered(text, translate, false);
}

std::vector<std::string> splitText(std::string_view text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = text.find(separator, begin);
    parts.emplace_back(text.substr(begin, end == std::string_view::npos ? end : end - begin));
    if (end == std::string_view::npos) {
      return parts;
    }
    begin = end + 1;
  }
}

std::string_view trimText(std::string_view text) noexcept {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) {
    return {};
  }
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

std::string joinText(const std::vector<std::string>& parts, std::string_view separator) {
  std::string result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    result += i == 0 ? "" : separator;
    result += parts[i];
  }
  return result;
}

std::optional<double> parseReal(std::string_view text) noexcept {
  text = trimText(text);
  if (text.starts_with('+') && !text.starts_with("+-")) {
    text.remove_prefix(1);
  }
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size() ||
      !std::isfinite(number)) {
    return std::nullopt;
  }
  return number;
}

std::string formatFixed(double number, int decimals) {
  // Room for the largest double in fixed notation.
  char buffer[400];
  const auto [end, error] =
      std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::fixed, decimals);
  std::string text(buffer, error == std::errc{} ? end : buffer);
  if (!text.empty() && text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) {
    text.erase(0, 1);
  }
  return text;
}

std::optional<std::string> nearestName(std::string_view name,
                                       const std::vector<std::string>& candidates) {
  std::optional<std::string> best;
  std::size_t bestDistance = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    std::vector<std::size_t> row(candidate.size() + 1);
    for (std::size_t j = 0; j <= candidate.size(); ++j) {
      row[j] = j;
    }
    for (std::size_t i = 1; i <= name.size(); ++i) {
      std::size_t diagonal = row[0];
      row[0] = i;
      for (std::size_t j = 1; j <= candidate.size(); ++j) {
        const std::size_t replaced = diagonal + (name[i - 1] == candidate[j - 1] ? 0 : 1);
        diagonal = row[j];
        row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
      }
    }
    if (row.back() < bestDistance) {
      bestDistance = row.back();
      best = candidate;
    }
  }
  return best;
}

bool isValidId(std::string_view id) noexcept {
  const auto alphanumeric = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
  return !id.empty() && id.size() <= 64 && alphanumeric(id.front()) &&
         std::all_of(id.begin(), id.end(),
                     [&](char c) { return alphanumeric(c) || c == '_' || c == '-' || c == '.'; });
}

}  // namespace wcam
