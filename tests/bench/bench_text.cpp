// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text of robot programs: a million KRL lines of 8 numbers with 3 decimals, by the fixed-decimals
// writer and by std::to_chars into a buffer of the right size. One run, in turns; the bytes must be
// equal.

#include "wcam/program/text_writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr std::size_t kLines = 1'000'000;
constexpr std::size_t kNumbers = 8;
constexpr std::size_t kLongestLine = 200;
constexpr int kRepetitions = 7;
constexpr double kGoal = 3.0;

using Line = std::array<double, kNumbers>;
constexpr std::array<std::string_view, kNumbers + 1> kLiterals = {
    "LIN {X ", ",Y ", ",Z ", ",A ", ",B ", ",C ", ",E1 ", ",E2 ", "} C_DIS\n"};

/// Positions within metres, angles within a turn; none that is printed as a zero with a sign.
std::vector<Line> makeLines() {
  std::mt19937_64 random(1);
  std::vector<Line> lines(kLines);
  for (Line& line : lines) {
    for (std::size_t i = 0; i < kNumbers; ++i) {
      const double range = i < 3 ? 2000.0 : 180.0;
      const double unit = static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0;
      line[i] = std::abs(unit) * range < 0.001 ? 1.0 : unit * range;
    }
  }
  return lines;
}

/// Both writers keep their memory from run to run, as a program that writes many files does.
class Own {
public:
  std::string_view write(const std::vector<Line>& lines) {
    out_.clear();
    for (const Line& v : lines) {
      out_.text(kLiterals[0]).fixed<3>(v[0]).text(kLiterals[1]).fixed<3>(v[1]);
      out_.text(kLiterals[2]).fixed<3>(v[2]).text(kLiterals[3]).fixed<3>(v[3]);
      out_.text(kLiterals[4]).fixed<3>(v[4]).text(kLiterals[5]).fixed<3>(v[5]);
      out_.text(kLiterals[6]).fixed<3>(v[6]).text(kLiterals[7]).fixed<3>(v[7]);
      out_.text(kLiterals[8]);
    }
    return out_.view();
  }

private:
  wcam::program::TextWriter out_{kLines * kLongestLine};
};

class ToChars {
public:
  std::string_view write(const std::vector<Line>& lines) {
    at_ = buffer_.data();
    for (const Line& v : lines) {
      literal(kLiterals[0]), number(v[0]), literal(kLiterals[1]), number(v[1]);
      literal(kLiterals[2]), number(v[2]), literal(kLiterals[3]), number(v[3]);
      literal(kLiterals[4]), number(v[4]), literal(kLiterals[5]), number(v[5]);
      literal(kLiterals[6]), number(v[6]), literal(kLiterals[7]), number(v[7]);
      literal(kLiterals[8]);
    }
    return {buffer_.data(), static_cast<std::size_t>(at_ - buffer_.data())};
  }

private:
  void literal(std::string_view text) {
    std::memcpy(at_, text.data(), text.size());
    at_ += text.size();
  }

  void number(double value) {
    at_ =
        std::to_chars(at_, buffer_.data() + buffer_.size(), value, std::chars_format::fixed, 3).ptr;
  }

  std::string buffer_ = std::string(kLines * kLongestLine, '\0');
  char* at_ = nullptr;
};

template <class Writer>
double timeOf(Writer& writer, const std::vector<Line>& lines, std::string_view& text) {
  const auto begin = std::chrono::steady_clock::now();
  text = writer.write(lines);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void print(const char* name, std::vector<double> times, std::size_t bytes) {
  std::sort(times.begin(), times.end());
  const double best = times.front();
  std::printf("%-22s min %.3f s  median %.3f s  %.1f ns/number  %.0f MB/s\n", name, best,
              times[times.size() / 2], best * 1e9 / static_cast<double>(kLines * kNumbers),
              static_cast<double>(bytes) / best / 1e6);
}

}  // namespace

int main() {
  const std::vector<Line> lines = makeLines();
  std::vector<double> own;
  std::vector<double> anchor;
  Own ownWriter;
  ToChars toChars;
  std::string_view ownText;
  std::string_view anchorText;
  for (int i = 0; i < kRepetitions; ++i) {
    anchor.push_back(timeOf(toChars, lines, anchorText));
    own.push_back(timeOf(ownWriter, lines, ownText));
    if (ownText != anchorText) {
      std::printf("the texts differ\n");
      return 1;
    }
  }
  print("std::to_chars fixed 3", anchor, anchorText.size());
  print("TextWriter", own, ownText.size());
  const double ratio =
      *std::min_element(anchor.begin(), anchor.end()) / *std::min_element(own.begin(), own.end());
  std::printf("ratio %.2f (goal %.1f), %zu bytes equal\n", ratio, kGoal, ownText.size());
  return 0;
}
