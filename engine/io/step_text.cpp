// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_text.hpp"

#include "text_scanner.hpp"
#include <iconv.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>

namespace wcam::io {

namespace {

bool isHigh(char c) {
  return static_cast<unsigned char>(c) >= 0x80;
}

bool in(unsigned char c, unsigned low, unsigned high) {
  return c >= low && c <= high;
}

/// Points of a text in one encoding: those of letters that are usual in it count for it, others
/// against it. Nothing when the text cannot be in it.
using Points = std::optional<double>;

/// Encodings of two bytes: `pair` gives the points of a pair, nothing for an impossible one.
template <class Pair>
Points pointsOfPairs(std::string_view text, const Pair& pair) {
  double points = 0.0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!isHigh(text[i])) {
      continue;
    }
    const auto lead = static_cast<unsigned char>(text[i]);
    const auto trail = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : '\0');
    bool single = false;
    const Points own = pair(lead, trail, single);
    if (!own) {
      return std::nullopt;
    }
    points += *own;
    i += single ? 0 : 1;
  }
  return points;
}

Points gbPoints(std::string_view text) {
  return pointsOfPairs(text, [](unsigned char lead, unsigned char trail, bool&) -> Points {
    if (!in(lead, 0x81, 0xFE) || !(in(trail, 0x40, 0x7E) || in(trail, 0x80, 0xFE))) {
      return std::nullopt;
    }
    if (in(lead, 0xB0, 0xD7) && trail >= 0xA1) {
      return 2.0;  // the 3755 usual characters
    }
    return in(lead, 0xA1, 0xA9) && trail >= 0xA1 ? 0.0 : -1.0;
  });
}

Points shiftJisPoints(std::string_view text) {
  return pointsOfPairs(text, [](unsigned char lead, unsigned char trail, bool& single) -> Points {
    if (in(lead, 0xA1, 0xDF)) {
      single = true;
      return -0.5;
    }
    if (!(in(lead, 0x81, 0x9F) || in(lead, 0xE0, 0xFC)) ||
        !(in(trail, 0x40, 0x7E) || in(trail, 0x80, 0xFC))) {
      return std::nullopt;
    }
    const double bytes = trail >= 0x80 ? 2.0 : 1.0;
    const bool usual = in(lead, 0x82, 0x83) || in(lead, 0x88, 0x97);
    return usual ? bytes : lead == 0x81 ? 0.0 : -0.5;
  });
}

Points eucJpPoints(std::string_view text) {
  return pointsOfPairs(text, [](unsigned char lead, unsigned char trail, bool&) -> Points {
    if (!(in(lead, 0xA1, 0xFE) || lead == 0x8E) || !in(trail, 0xA1, 0xFE)) {
      return std::nullopt;
    }
    if (in(lead, 0xA4, 0xA5)) {
      return 3.0;  // kana, which Chinese names do not have
    }
    return in(lead, 0xB0, 0xCF) ? 1.8 : -0.5;
  });
}

Points big5Points(std::string_view text) {
  return pointsOfPairs(text, [](unsigned char lead, unsigned char trail, bool&) -> Points {
    if (!in(lead, 0x81, 0xFE) || !(in(trail, 0x40, 0x7E) || in(trail, 0xA1, 0xFE))) {
      return std::nullopt;
    }
    const double bytes = trail >= 0x80 ? 2.0 : 1.0;
    return in(lead, 0xA4, 0xC6) ? 0.9 * bytes : -0.5;
  });
}

/// Encodings of one byte, by the length of runs of letters beyond ASCII: accents stand alone,
/// Cyrillic words do not.
template <class Run>
Points pointsOfRuns(std::string_view text, const Run& run) {
  double points = 0.0;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && isHigh(text[end])) {
      ++end;
    }
    if (end > i) {
      points += run(text.substr(i, end - i));
    }
    i = std::max(end, i + 1);
  }
  return points;
}

Points latinPoints(std::string_view text) {
  return pointsOfRuns(text, [](std::string_view run) {
    const auto first = static_cast<unsigned char>(run[0]);
    if (run.size() == 1) {
      return first >= 0xA0 ? 0.9 : 0.1;
    }
    return run.size() == 2 && first >= 0xC0 ? 1.0 : -0.5 * static_cast<double>(run.size());
  });
}

Points cyrillicPoints(std::string_view text) {
  return pointsOfRuns(text, [](std::string_view run) {
    const auto letters = std::count_if(
        run.begin(), run.end(), [](char c) { return static_cast<unsigned char>(c) >= 0xC0; });
    return run.size() >= 3 ? 0.8 * static_cast<double>(letters)
                           : 0.3 * static_cast<double>(run.size());
  });
}

struct Encoding {
  const char* name;
  const char* iconvName;
  Points (*points)(std::string_view);
};

constexpr std::array<Encoding, 6> kEncodings{{{"GB18030", "GB18030", gbPoints},
                                              {"Shift-JIS", "CP932", shiftJisPoints},
                                              {"EUC-JP", "EUC-JP", eucJpPoints},
                                              {"Big5", "BIG5", big5Points},
                                              {"Windows-1252", "CP1252", latinPoints},
                                              {"Windows-1251", "CP1251", cyrillicPoints}}};
/// Points per byte beyond ASCII from which an encoding is believed.
constexpr double kBelieved = 0.5;

bool isUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = isHigh(text[i]) ? utf8Length(text.substr(i)) : 1;
    if (length == 0) {
      return false;
    }
    i += length;
  }
  return true;
}

class Converter {
public:
  explicit Converter(const char* encoding) : handle_(iconv_open("UTF-8", encoding)) {}

  ~Converter() {
    if (valid()) {
      iconv_close(handle_);
    }
  }

  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;

  [[nodiscard]] bool valid() const { return handle_ != reinterpret_cast<iconv_t>(-1); }

  /// Appends the text; bytes that have no meaning become U+FFFD.
  void append(std::string_view text, std::string& out) {
    auto* from = const_cast<char*>(text.data());
    std::size_t left = text.size();
    while (left > 0) {
      std::array<char, 256> buffer;
      char* to = buffer.data();
      std::size_t room = buffer.size();
      const std::size_t result = iconv(handle_, &from, &left, &to, &room);
      out.append(buffer.data(), static_cast<std::size_t>(to - buffer.data()));
      if (result == static_cast<std::size_t>(-1) && room >= 8) {
        out.append("\xEF\xBF\xBD");
        ++from;
        --left;
      }
    }
  }

private:
  iconv_t handle_;
};

/// Strings with letters beyond ASCII, as places in the text.
std::vector<std::string_view> foreignStrings(std::string_view text) {
  std::vector<std::string_view> strings;
  for (std::size_t i = text.find('\''); i != std::string_view::npos; i = text.find('\'', i)) {
    const std::size_t end = std::min(text.find('\'', i + 1), text.size());
    const std::string_view content = text.substr(i + 1, end - i - 1);
    if (std::any_of(content.begin(), content.end(), isHigh)) {
      strings.push_back(content);
    }
    i = std::min(end + 1, text.size());
  }
  return strings;
}

const Encoding* encodingOf(const std::vector<std::string_view>& strings) {
  std::string sample;
  for (const std::string_view text : strings) {
    sample.append(text).push_back('\n');
  }
  const auto high = static_cast<double>(std::count_if(sample.begin(), sample.end(), isHigh));
  const Encoding* best = nullptr;
  double bestPoints = kBelieved * high;
  for (const Encoding& encoding : kEncodings) {
    const Points points = encoding.points(sample);
    if (points && *points > bestPoints) {
      best = &encoding;
      bestPoints = *points;
    }
  }
  return best;
}

void appendReplaced(std::string_view text, std::string& out) {
  for (const char c : text) {
    if (isHigh(c)) {
      out.append("\xEF\xBF\xBD");
    } else {
      out.push_back(c);
    }
  }
}

bool isBlank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r') || c == '\0';
}

bool isWordLetter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

}  // namespace

std::optional<RecodedStep> recodeStep(std::string_view bytes) {
  if (std::none_of(bytes.begin(), bytes.end(), isHigh) || isUtf8(bytes)) {
    return std::nullopt;
  }
  const std::vector<std::string_view> strings = foreignStrings(bytes);
  const Encoding* encoding = encodingOf(strings);
  std::optional<Converter> converter;
  if (encoding != nullptr) {
    converter.emplace(encoding->iconvName);
  }
  RecodedStep result;
  result.strings = strings.size();
  if (converter && converter->valid()) {
    result.encoding = encoding->name;
  }
  const char* done = bytes.data();
  for (const std::string_view text : strings) {
    appendReplaced({done, static_cast<std::size_t>(text.data() - done)}, result.text);
    if (result.encoding.empty()) {
      appendReplaced(text, result.text);
    } else {
      converter->append(text, result.text);
    }
    done = text.data() + text.size();
  }
  appendReplaced({done, static_cast<std::size_t>(bytes.data() + bytes.size() - done)}, result.text);
  return result;
}

void StepCursor::blanks() {
  while (position_ < text_.size()) {
    if (isBlank(text_[position_])) {
      ++position_;
    } else if (text_.substr(position_, 2) == "/*") {
      const std::size_t end = text_.find("*/", position_ + 2);
      position_ = end == std::string_view::npos ? text_.size() : end + 2;
    } else {
      return;
    }
  }
}

std::string_view StepCursor::keyword() {
  blanks();
  const std::size_t begin = position_;
  while (position_ < text_.size() && isWordLetter(text_[position_])) {
    ++position_;
  }
  return text_.substr(begin, position_ - begin);
}

bool StepCursor::take(char c) {
  blanks();
  const bool there = position_ < text_.size() && text_[position_] == c;
  position_ += there ? 1 : 0;
  return there;
}

std::optional<std::string_view> StepCursor::string() {
  blanks();
  if (position_ >= text_.size() || text_[position_] != '\'') {
    return std::nullopt;
  }
  const std::size_t begin = position_ + 1;
  std::size_t end = text_.find('\'', begin);
  while (end != std::string_view::npos && text_.substr(end, 2) == "''") {
    end = text_.find('\'', end + 2);
  }
  if (end == std::string_view::npos) {
    return std::nullopt;
  }
  position_ = end + 1;
  return text_.substr(begin, end - begin);
}

std::optional<double> StepCursor::number() {
  blanks();
  std::size_t end = position_;
  while (end < text_.size() &&
         (isWordLetter(text_[end]) || text_[end] == '.' || text_[end] == '+')) {
    ++end;
  }
  std::string_view word = text_.substr(position_, end - position_);
  const std::optional<double> number = scanNumber(word);
  if (number) {
    position_ = end;
  }
  return number;
}

std::optional<std::uint64_t> StepCursor::reference() {
  blanks();
  if (position_ >= text_.size() || text_[position_] != '#') {
    return std::nullopt;
  }
  std::uint64_t number = 0;
  const char* begin = text_.data() + position_ + 1;
  const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), number);
  if (error != std::errc()) {
    return std::nullopt;
  }
  position_ = static_cast<std::size_t>(end - text_.data());
  return number;
}

bool StepCursor::skip() {
  std::size_t depth = 0;
  while (true) {
    blanks();
    if (position_ >= text_.size()) {
      return false;
    }
    const char c = text_[position_];
    if (c == '\'') {
      if (!string()) {
        return false;
      }
    } else if (c == '(') {
      ++depth;
      ++position_;
      continue;
    } else if (c == ')' || c == ',') {
      if (depth == 0) {
        return false;  // there is no value
      }
      depth -= c == ')' ? 1 : 0;
      ++position_;
      if (c == ',' || depth > 0) {
        continue;
      }
      return true;
    } else {
      ++position_;
    }
    // A simple value, or the name of a typed one, goes on to the next separator.
    blanks();
    const char next = position_ < text_.size() ? text_[position_] : ')';
    if (depth == 0 && (next == ',' || next == ')')) {
      return true;
    }
  }
}

StepEntities stepEntities(std::string_view text) {
  StepEntities entities;
  // A statement ends with a semicolon outside of strings and comments.
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '\'') {
      i = text.find('\'', i + 1);
    } else if (c == '/' && text.substr(i, 2) == "/*") {
      const std::size_t end = text.find("*/", i + 2);
      i = end == std::string_view::npos ? end : end + 1;
    } else if (c == ';') {
      const std::string_view statement = text.substr(begin, i - begin);
      StepCursor cursor(statement);
      const auto number = cursor.reference();
      if (number && cursor.take('=')) {
        entities.emplace(*number, statement.substr(cursor.position()));
      }
      begin = i + 1;
    }
    if (i == std::string_view::npos) {
      break;
    }
    ++i;
  }
  return entities;
}

std::vector<std::string> externalFilesOf(std::string_view text) {
  constexpr std::array<std::string_view, 16> kShapes{
      ".stp",    ".step",    ".p21", ".stpz", ".igs", ".iges", ".prt", ".sldprt",
      ".sldasm", ".catpart", ".ipt", ".x_t",  ".x_b", ".jt",   ".stl", ".sat"};
  std::vector<std::string> files;
  if (text.find("DOCUMENT_FILE") == std::string_view::npos) {
    return files;
  }
  for (const auto& [number, entity] : stepEntities(text)) {
    StepCursor cursor(entity);
    const bool document = cursor.keyword() == "DOCUMENT_FILE" && cursor.take('(');
    const auto name = document ? cursor.string() : std::nullopt;
    if (!name) {
      continue;
    }
    const std::size_t dot = name->rfind('.');
    const std::string_view extension =
        dot == std::string_view::npos ? std::string_view() : name->substr(dot);
    if (std::any_of(kShapes.begin(), kShapes.end(),
                    [&](std::string_view known) { return equalNoCase(extension, known); })) {
      files.push_back(printableName(*name));
    }
  }
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

}  // namespace wcam::io
