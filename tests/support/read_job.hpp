// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include <cctype>
#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What the readers of robot languages have in common. They are written from the description of the
/// languages, not from the post-processors, and are the other half of every round trip.
namespace wcam::test {

enum class ReadKind { Joint, Linear, CircularVia, Circular };

/// A move as the text says it. Angles in degrees, lengths in mm.
struct ReadMove {
  ReadKind kind = ReadKind::Linear;
  bool cartesian = false;
  std::vector<double> joints;    ///< robot axes; empty for a Cartesian position
  std::vector<double> external;  ///< positioner axes
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< of a Cartesian position
  double speed = 0.0;  ///< mm/s along a path, percent of the axis speeds for a joint move
  bool stop = false;
  bool arc = false;           ///< the arc burns during the move
  bool coordinated = false;   ///< FANUC: COORD
  std::string configuration;  ///< FANUC: "NUT"; KUKA: the S bits
  std::vector<int> turns;     ///< FANUC: the three turn numbers; KUKA: the T bits, axis 1 first
  std::string tool;           ///< name of the tool frame that is active
  std::string base;           ///< name of the frame that Cartesian positions are in
  bool coupled = false;       ///< KUKA: that frame turns with the positioner
  bool remote = false;        ///< the tool stands and the robot guides the part
  std::string program;
};

/// The moves of a job in the order of execution, with everything that breaks the language's rules.
struct ReadJob {
  std::vector<ReadMove> moves;
  std::vector<std::string> problems;
  std::vector<std::string> comments;
  std::vector<int> arcSchedules;                 ///< one per arc start
  std::vector<double> waits;                     ///< s
  std::map<int, int> outputs;                    ///< switchings of each digital output
  std::map<std::string, std::size_t> positions;  ///< per program
  /// Frames that the comments say the program was planned with, by their names on the controller.
  std::map<std::string, Eigen::Isometry3d> frames;
  int fewestJointDecimals = 99;
  std::size_t programs = 0;
};

/// Reads a text from left to right; blanks between tokens are skipped.
class Scanner {
public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  void skip() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t')) {
      rest_.remove_prefix(1);
    }
  }

  [[nodiscard]] bool done() {
    skip();
    return rest_.empty();
  }

  bool accept(std::string_view token) {
    skip();
    if (!rest_.starts_with(token)) {
      return false;
    }
    rest_.remove_prefix(token.size());
    return true;
  }

  std::optional<int> integer() {
    skip();
    int value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{}) {
      return std::nullopt;
    }
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  /// A number in plain notation; `decimals` receives the digits behind its point.
  std::optional<double> real(int* decimals = nullptr) {
    skip();
    double value = 0.0;
    const char* const begin = rest_.data();
    const auto [end, error] =
        std::from_chars(begin, begin + rest_.size(), value, std::chars_format::fixed);
    if (error != std::errc{}) {
      return std::nullopt;
    }
    const std::string_view text(begin, static_cast<std::size_t>(end - begin));
    if (decimals != nullptr) {
      const std::size_t point = text.find('.');
      *decimals = point == std::string_view::npos ? 0 : static_cast<int>(text.size() - point - 1);
    }
    rest_.remove_prefix(text.size());
    return value;
  }

  /// Letters, digits and '_'.
  std::string word() {
    skip();
    std::size_t size = 0;
    while (size < rest_.size() &&
           (std::isalnum(static_cast<unsigned char>(rest_[size])) != 0 || rest_[size] == '_')) {
      ++size;
    }
    std::string result(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return result;
  }

  [[nodiscard]] std::string_view rest() const { return rest_; }

private:
  std::string_view rest_;
};

}  // namespace wcam::test
