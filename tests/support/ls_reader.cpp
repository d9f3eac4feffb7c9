// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ls_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace wcam::test {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

struct LsPosition {
  std::vector<double> joints;
  std::vector<double> external;
  std::optional<Eigen::Isometry3d> pose;
  std::string configuration;
  std::vector<int> turns;
  int userFrame = -1;
  int toolFrame = -1;
  bool group2 = false;
};

struct LsFile {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<std::string> instructions;  ///< without number and ';'
  std::map<int, LsPosition> positions;
};

/// R about Z after P about Y after W about X.
Eigen::Isometry3d poseOf(const std::array<double, 6>& v) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << v[0], v[1], v[2];
  pose.linear() = (Eigen::AngleAxisd(v[5] * kDegree, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(v[4] * kDegree, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(v[3] * kDegree, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return pose;
}

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

class LsParser {
public:
  LsParser(std::string file, ReadJob& job) : file_(std::move(file)), job_(job) {}

  LsFile parse(std::string_view text) {
    const auto lines = linesOf(text);
    std::size_t i = 0;
    if (lines.empty() || !lines[0].starts_with("/PROG")) {
      problem("does not begin with /PROG");
      return {};
    }
    Scanner head(lines[i++]);
    head.accept("/PROG");
    result_.name = head.word();
    if (i >= lines.size() || lines[i++] != "/ATTR") {
      problem("/ATTR is missing");
    }
    std::string attributes;
    for (; i < lines.size() && lines[i] != "/MN"; ++i) {
      attributes += lines[i];
    }
    parseAttributes(attributes);
    parseInstructions(lines, ++i);
    std::string positions;
    for (++i; i < lines.size() && lines[i] != "/END"; ++i) {
      positions.append(lines[i]).push_back(' ');
    }
    if (i >= lines.size()) {
      problem("/END is missing");
    }
    parsePositions(positions);
    return std::move(result_);
  }

private:
  void problem(const std::string& text) { job_.problems.push_back(file_ + ": " + text); }

  void parseAttributes(const std::string& text) {
    std::size_t begin = 0;
    for (std::size_t end = text.find(';'); end != std::string::npos; end = text.find(';', begin)) {
      const std::string item = text.substr(begin, end - begin);
      const std::size_t equal = item.find('=');
      if (equal == std::string::npos) {
        problem("attribute without '=': " + item);
      } else {
        Scanner key(item);
        Scanner value(std::string_view(item).substr(equal + 1));
        value.skip();
        result_.attributes[key.word()] = std::string(value.rest());
      }
      begin = end + 1;
    }
  }

  void parseInstructions(const std::vector<std::string_view>& lines, std::size_t& i) {
    int expected = 1;
    std::string pending;
    for (; i < lines.size() && lines[i] != "/POS"; ++i) {
      std::string_view line = lines[i];
      if (pending.empty()) {
        // "%4d:": at least four columns for the number.
        const std::size_t colon = line.find(':');
        Scanner scanner(line);
        const auto number = scanner.integer();
        if (!number || *number != expected || colon == std::string_view::npos ||
            colon != std::max<std::size_t>(4, std::to_string(expected).size())) {
          problem("line " + std::to_string(expected) +
                  " is not numbered as such: " + std::string(line));
        }
        ++expected;
        line.remove_prefix(colon == std::string_view::npos ? 0 : colon + 1);
      } else {
        Scanner scanner(line);
        if (!scanner.accept(":")) {
          problem("continuation without ':': " + std::string(line));
        }
        line = scanner.rest();
      }
      pending += line;
      const std::size_t end = pending.find(';');
      if (end != std::string::npos) {
        if (pending.find_first_not_of(" ;", end) != std::string::npos) {
          problem("text after ';': " + pending);
        }
        result_.instructions.push_back(pending.substr(0, end));
        pending.clear();
      }
    }
    if (!pending.empty()) {
      problem("line without ';': " + pending);
    }
    if (i >= lines.size()) {
      problem("/POS is missing");
    }
    if (result_.attributes["LINE_COUNT"] != std::to_string(expected - 1)) {
      problem("LINE_COUNT is " + result_.attributes["LINE_COUNT"] + ", there are " +
              std::to_string(expected - 1) + " lines");
    }
  }

  void parsePositions(std::string_view text) {
    Scanner scanner(text);
    int expected = 1;
    while (!scanner.done()) {
      if (!scanner.accept("P[")) {
        problem("P[ expected at: " + std::string(scanner.rest().substr(0, 40)));
        return;
      }
      const auto number = scanner.integer();
      if (!number || *number != expected || !scanner.accept("]") || !scanner.accept("{")) {
        problem("positions are not numbered one after the other at " + std::to_string(expected));
        return;
      }
      ++expected;
      LsPosition position;
      if (!parseGroups(scanner, position)) {
        problem("position " + std::to_string(*number) +
                " cannot be read at: " + std::string(scanner.rest().substr(0, 40)));
        return;
      }
      result_.positions.emplace(*number, std::move(position));
    }
  }

  bool parseGroups(Scanner& scanner, LsPosition& position) {
    int group = 1;
    while (scanner.accept("GP")) {
      if (scanner.integer() != group || !scanner.accept(":") || group > 2 ||
          !parseGroup(scanner, position, group)) {
        return false;
      }
      ++group;
    }
    return group > 1 && scanner.accept("}") && scanner.accept(";");
  }

  bool parseGroup(Scanner& scanner, LsPosition& position, int group) {
    if (!scanner.accept("UF") || !scanner.accept(":")) {
      return false;
    }
    const auto userFrame = scanner.integer();
    if (!userFrame || !scanner.accept(",") || !scanner.accept("UT") || !scanner.accept(":")) {
      return false;
    }
    const auto toolFrame = scanner.integer();
    if (!toolFrame || !scanner.accept(",")) {
      return false;
    }
    if (group == 2) {
      position.group2 = true;
      return parseJoints(scanner, position.external);
    }
    position.userFrame = *userFrame;
    position.toolFrame = *toolFrame;
    if (scanner.accept("CONFIG")) {
      return parseConfiguration(scanner, position) && parsePose(scanner, position);
    }
    return parseJoints(scanner, position.joints);
  }

  bool parseJoints(Scanner& scanner, std::vector<double>& joints) {
    do {
      if (!scanner.accept("J") || scanner.integer() != static_cast<int>(joints.size()) + 1 ||
          !scanner.accept("=")) {
        return false;
      }
      int decimals = 0;
      const auto value = scanner.real(&decimals);
      if (!value || !(scanner.accept("deg") || scanner.accept("mm"))) {
        return false;
      }
      job_.fewestJointDecimals = std::min(job_.fewestJointDecimals, decimals);
      joints.push_back(*value);
    } while (scanner.accept(","));
    return true;
  }

  static bool parseConfiguration(Scanner& scanner, LsPosition& position) {
    if (!scanner.accept(":") || !scanner.accept("'")) {
      return false;
    }
    for (int i = 0; i < 3; ++i) {
      position.configuration += scanner.word();
    }
    while (scanner.accept(",")) {
      const auto turn = scanner.integer();
      if (!turn) {
        break;
      }
      position.turns.push_back(*turn);
    }
    return position.configuration.size() == 3 && position.turns.size() == 3 &&
           scanner.accept("'") && scanner.accept(",");
  }

  static bool parsePose(Scanner& scanner, LsPosition& position) {
    constexpr std::array<std::string_view, 6> kKeys = {"X", "Y", "Z", "W", "P", "R"};
    std::array<double, 6> values{};
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
      if ((i > 0 && !scanner.accept(",")) || !scanner.accept(kKeys[i]) || !scanner.accept("=")) {
        return false;
      }
      const auto value = scanner.real();
      if (!value || !scanner.accept(i < 3 ? "mm" : "deg")) {
        return false;
      }
      values[i] = *value;
    }
    position.pose = poseOf(values);
    return true;
  }

  std::string file_;
  ReadJob& job_;
  LsFile result_;
};

/// Executes the instructions of programs.
class LsRunner {
public:
  LsRunner(const std::map<std::string, LsFile>& programs, bool provenance, ReadJob& job)
      : programs_(programs), provenance_(provenance), job_(job) {}

  void run(const std::string& name, int depth = 0) {
    const auto found = programs_.find(name);
    if (found == programs_.end() || depth > 1) {
      problem("CALL of an unknown program " + name);
      return;
    }
    const LsFile* const caller = std::exchange(current_, &found->second);
    called_.insert(name);
    used_.clear();
    for (const std::string& instruction : current_->instructions) {
      execute(instruction, depth);
    }
    for (const auto& [number, position] : current_->positions) {
      if (!used_.contains(number)) {
        problem("P[" + std::to_string(number) + "] is not used");
      }
    }
    job_.positions[name] = current_->positions.size();
    ++job_.programs;
    current_ = caller;
  }

  /// The program as an operator starts it, from wherever the robot stands.
  void runAlone(const std::string& name) {
    run(name);
    current_ = &programs_.at(name);
    if (!job_.moves.empty()) {
      const auto firstArc = std::find_if(job_.moves.begin(), job_.moves.end(),
                                         [](const ReadMove& move) { return move.arc; });
      if (job_.moves.front().kind != ReadKind::Joint) {
        problem("started alone, it does not begin with a joint move");
      }
      // The joint move to a safe point, the approach to the bead, and only then the arc.
      constexpr auto kBeforeArc = 2;
      if (firstArc != job_.moves.end() && firstArc - job_.moves.begin() < kBeforeArc) {
        problem("started alone, the arc goes on without an approach");
      }
    }
    if (arc_) {
      problem("started alone, it leaves the arc on");
    }
  }

  void finish() {
    if (arc_) {
      problem("the arc is on at the end");
    }
    for (const auto& [name, file] : programs_) {
      if (!called_.contains(name)) {
        job_.problems.push_back(name + ": is never called");
      }
    }
  }

private:
  void problem(const std::string& text) {
    job_.problems.push_back((current_ != nullptr ? current_->name : std::string()) + ": " + text);
  }

  void execute(const std::string& instruction, int depth) {
    Scanner scanner(instruction);
    if (scanner.accept("!")) {
      comment(scanner);
    } else if (scanner.accept("J P[")) {
      motion(scanner, ReadKind::Joint);
    } else if (scanner.accept("L P[")) {
      motion(scanner, ReadKind::Linear);
    } else if (scanner.accept("C P[")) {
      motion(scanner, ReadKind::Circular);
    } else if (scanner.accept("Arc Start[")) {
      arc(scanner, true);
    } else if (scanner.accept("Arc End[")) {
      arc(scanner, false);
    } else if (scanner.accept("CALL")) {
      run(scanner.word(), depth + 1);
    } else if (!plain(scanner)) {
      problem("unknown instruction: " + instruction);
    }
  }

  bool plain(Scanner& scanner) {
    if (scanner.accept("WAIT")) {
      const auto seconds = scanner.real();
      job_.waits.push_back(seconds.value_or(-1.0));
      return seconds && scanner.accept("(sec)") && scanner.done();
    }
    if (scanner.accept("UFRAME_NUM=")) {
      userFrame_ = scanner.integer().value_or(-2);
      return scanner.done();
    }
    if (scanner.accept("UTOOL_NUM=")) {
      toolFrame_ = scanner.integer().value_or(-2);
      return scanner.done();
    }
    if (scanner.accept("DO[")) {
      const auto output = scanner.integer();
      ++job_.outputs[output.value_or(-1)];
      return output && scanner.accept("]=") && (scanner.accept("ON") || scanner.accept("OFF")) &&
             scanner.done();
    }
    if (scanner.accept("R[")) {
      return scanner.integer() && scanner.accept("]=") && scanner.real() && scanner.done();
    }
    return scanner.accept("PAYLOAD[") && scanner.integer() && scanner.accept("]") && scanner.done();
  }

  void comment(Scanner& scanner) {
    const std::string text(scanner.rest());
    const std::size_t end = text.find_last_not_of(' ');
    job_.comments.push_back(text.substr(0, end + 1));
    readFrame(job_.comments.back());
    if (job_.comments.back().size() > 32) {
      problem("a comment is longer than 32 characters: " + job_.comments.back());
    }
  }

  /// "NAME X 1.0" to "NAME R 6.0", one number a comment.
  void readFrame(const std::string& comment) {
    constexpr std::string_view kKeys = "XYZWPR";
    const std::size_t key = comment.find_last_of(' ');
    if (key == std::string::npos || key < 2 || comment[key - 2] != ' ' ||
        kKeys.find(comment[key - 1]) == std::string_view::npos) {
      return;
    }
    Scanner scanner(std::string_view(comment).substr(key));
    const auto value = scanner.real();
    if (!value || !scanner.done()) {
      return;
    }
    const std::string name = comment.substr(0, key - 2);
    std::array<double, 6>& numbers = numbers_[name];
    numbers[kKeys.find(comment[key - 1])] = *value;
    if (comment[key - 1] == 'R') {
      job_.frames[name] = poseOf(numbers);
    }
  }

  void arc(Scanner& scanner, bool on) {
    const auto schedule = scanner.integer();
    if (!schedule || !scanner.accept("]") || !scanner.done()) {
      problem("arc schedule expected");
    } else if (on) {
      job_.arcSchedules.push_back(*schedule);
    }
    if (arc_ == on || job_.moves.empty()) {
      problem("arc on and off do not take turns after a move");
    }
    arc_ = on;
  }

  void motion(Scanner& scanner, ReadKind kind) {
    std::vector<ReadMove> moves;
    moves.push_back(moveTo(scanner));
    if (kind == ReadKind::Circular) {
      moves.front().kind = ReadKind::CircularVia;
      if (!scanner.accept("P[")) {
        problem("a circular move needs two positions");
        return;
      }
      moves.push_back(moveTo(scanner));
    }
    ReadMove& move = moves.back();
    move.kind = kind;
    const auto speed = scanner.real();
    move.speed = speed.value_or(0.0);
    bool unit = false;
    if (kind == ReadKind::Joint) {
      unit = scanner.accept("%");
    } else if (scanner.accept("mm/sec")) {
      unit = true;
    } else if (scanner.accept("cm/min")) {
      unit = true;
      move.speed /= 6.0;
    }
    if (!unit || !(move.speed > 0.0) || (kind == ReadKind::Joint && move.speed > 100.0)) {
      problem("speed expected before: " + std::string(scanner.rest()));
    }
    termination(scanner, move);
    move.coordinated = scanner.accept("COORD");
    move.remote = scanner.accept("RTCP");
    if (move.remote && (move.coordinated || userFrame_ < 1)) {
      problem("RTCP needs a user frame that can be set, and excludes COORD");
    }
    if (!scanner.done() ||
        (move.coordinated && (move.external.empty() || kind == ReadKind::Joint))) {
      problem("motion option cannot be used: " + std::string(scanner.rest()));
    }
    moves.front().speed = move.speed;
    job_.moves.insert(job_.moves.end(), moves.begin(), moves.end());
  }

  void termination(Scanner& scanner, ReadMove& move) {
    if (scanner.accept("FINE")) {
      move.stop = true;
    } else if (scanner.accept("CNT")) {
      const auto value = scanner.integer();
      if (!value || *value < 0 || *value > 100) {
        problem("CNT takes 0 to 100");
      }
    } else {
      problem("FINE or CNT expected before: " + std::string(scanner.rest()));
    }
  }

  ReadMove moveTo(Scanner& scanner) {
    ReadMove move;
    move.program = current_->name;
    move.arc = arc_;
    const int number = scanner.integer().value_or(-1);
    scanner.accept("]");
    const auto found = current_->positions.find(number);
    if (found == current_->positions.end()) {
      problem("P[" + std::to_string(number) + "] is not defined");
      return move;
    }
    used_.insert(number);
    const LsPosition& position = found->second;
    if (position.userFrame != userFrame_ || position.toolFrame != toolFrame_) {
      problem("P[" + std::to_string(number) + "] has other frames than the program has set");
    }
    move.tool = "UTOOL[" + std::to_string(toolFrame_) + "]";
    move.base = "UFRAME[" + std::to_string(userFrame_) + "]";
    if (provenance_ && (!job_.frames.contains(move.tool) ||
                        (userFrame_ > 0 && !job_.frames.contains(move.base)))) {
      problem("the program does not say what it was planned with: " + move.tool + " " + move.base);
    }
    move.cartesian = position.pose.has_value();
    move.pose = position.pose.value_or(Eigen::Isometry3d::Identity());
    move.joints = position.joints;
    move.external = position.external;
    move.configuration = position.configuration;
    move.turns = position.turns;
    return move;
  }

  const std::map<std::string, LsFile>& programs_;
  bool provenance_;
  ReadJob& job_;
  const LsFile* current_ = nullptr;
  std::set<std::string> called_;
  std::set<int> used_;
  bool arc_ = false;
  int userFrame_ = -1;
  int toolFrame_ = -1;
  std::map<std::string, std::array<double, 6>> numbers_;
};

void lintFile(const std::string& fileName,
              const LsFile& file,
              std::size_t longestName,
              ReadJob& job) {
  const auto problem = [&](const std::string& text) {
    job.problems.push_back(fileName + ": " + text);
  };
  const std::string& name = file.name;
  const bool letters = std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
  if (name.empty() || name.size() > longestName || !letters || name.front() < 'A') {
    problem("'" + name + "' is not a program name");
  }
  static const std::set<std::string> kNoNames = {"END", "WAIT", "SIGNAL", "CALL", "PROGRAM", "CON",
                                                 "AUX", "PRN",  "NUL",    "COM1", "LPT1"};
  if (kNoNames.contains(name)) {
    problem("'" + name + "' means something else");
  }
  if (fileName != name + ".LS") {
    problem("file and program have different names");
  }
  const auto attribute = [&file](const std::string& key) {
    const auto found = file.attributes.find(key);
    return found == file.attributes.end() ? std::string() : found->second;
  };
  constexpr std::size_t kCommentWithQuotes = 18;
  if (attribute("COMMENT").size() > kCommentWithQuotes) {
    problem("the program comment is longer than 16 characters");
  }
  const bool group2 = std::any_of(file.positions.begin(), file.positions.end(),
                                  [](const auto& item) { return item.second.group2; });
  const bool everyGroup2 = std::all_of(file.positions.begin(), file.positions.end(),
                                       [](const auto& item) { return item.second.group2; });
  const std::string expected = file.positions.empty() ? "*,*" : (group2 ? "1,1" : "1,*");
  const std::string mask = attribute("DEFAULT_GROUP");
  if (!mask.starts_with(expected) || (mask.size() != 9 && mask.size() != 13) ||
      (group2 && !everyGroup2)) {
    problem("DEFAULT_GROUP " + mask + " does not fit the positions");
  }
}

}  // namespace

ReadJob readLs(const std::vector<std::pair<std::string, std::string>>& files,
               std::size_t longestName,
               bool provenance) {
  ReadJob job;
  std::map<std::string, LsFile> programs;
  std::string first;
  for (const auto& [fileName, text] : files) {
    LsFile file = LsParser(fileName, job).parse(text);
    lintFile(fileName, file, longestName, job);
    first = first.empty() ? file.name : first;
    if (!programs.emplace(file.name, std::move(file)).second) {
      job.problems.push_back(fileName + ": a program of this name exists already");
    }
  }
  LsRunner runner(programs, provenance, job);
  runner.run(first);
  runner.finish();
  for (const auto& [name, file] : programs) {
    if (file.positions.empty() || programs.size() == 1) {
      continue;
    }
    ReadJob alone;
    LsRunner(programs, provenance, alone).runAlone(name);
    job.problems.insert(job.problems.end(), alone.problems.begin(), alone.problems.end());
  }
  return job;
}

}  // namespace wcam::test
