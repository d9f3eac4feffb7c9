// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "krl_reader.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace wcam::test {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
/// Greatest path speed that $VEL.CP takes, m/s.
constexpr double kFastest = 3.0;

struct KrlFile {
  std::string name;
  std::vector<std::string> statements;
};

/// The fields of a position aggregate, by name; bit fields separately.
struct Aggregate {
  std::map<std::string, double> fields;
  std::map<std::string, std::string> bits;
};

/// A about Z, then B about the new Y, then C about the new X.
Eigen::Isometry3d poseOf(const Aggregate& aggregate) {
  const auto& f = aggregate.fields;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << f.at("X"), f.at("Y"), f.at("Z");
  pose.linear() = (Eigen::AngleAxisd(f.at("A") * kDegree, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(f.at("B") * kDegree, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(f.at("C") * kDegree, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return pose;
}

class KrlParser {
public:
  KrlParser(std::string file, ReadJob& job) : file_(std::move(file)), job_(job) {}

  KrlFile parse(std::string_view text) {
    KrlFile result;
    int folds = 0;
    bool ended = false;
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      const std::string line(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
      Scanner scanner(line);
      if (scanner.done() || scanner.accept("&")) {
        continue;
      }
      if (ended) {
        problem("text after END: " + line);
      } else if (scanner.accept(";FOLD")) {
        ++folds;
      } else if (scanner.accept(";ENDFOLD")) {
        --folds;
      } else if (scanner.accept(";")) {
        scanner.skip();
        job_.comments.emplace_back(scanner.rest());
        readFrame(job_.comments.back());
      } else if (result.name.empty()) {
        if (!scanner.accept("DEF ")) {
          problem("DEF expected: " + line);
        }
        result.name = scanner.word();
        if (!scanner.accept("(") || !scanner.accept(")")) {
          problem("DEF needs ( )");
        }
      } else if (line == "END") {
        ended = true;
      } else {
        result.statements.push_back(line);
      }
    }
    if (!ended || folds != 0) {
      problem("END or ENDFOLD is missing");
    }
    return result;
  }

private:
  void problem(const std::string& text) { job_.problems.push_back(file_ + ": " + text); }

  /// "NAME = {X 1,Y 2,Z 3,A 4,B 5,C 6}" in a comment.
  void readFrame(const std::string& comment) {
    const std::size_t equal = comment.find(" = {");
    if (equal == std::string::npos) {
      return;
    }
    Scanner scanner(std::string_view(comment).substr(equal + 3));
    Aggregate aggregate;
    scanner.accept("{");
    do {
      const std::string key = scanner.word();
      aggregate.fields[key] = scanner.real().value_or(1e9);
    } while (scanner.accept(","));
    constexpr std::size_t kFields = 6;
    if (!scanner.accept("}") || aggregate.fields.size() != kFields) {
      problem("frame in a comment: " + comment);
      return;
    }
    job_.frames[comment.substr(0, equal)] = poseOf(aggregate);
  }

  std::string file_;
  ReadJob& job_;
};

class KrlRunner {
public:
  KrlRunner(const std::map<std::string, KrlFile>& programs, int arcOutput, ReadJob& job)
      : programs_(programs), arcOutput_(arcOutput), job_(job) {}

  void run(const std::string& name, int depth = 0) {
    const KrlFile& file = programs_.at(name);
    const std::string caller = std::exchange(current_, name);
    called_.insert(name);
    const std::size_t before = job_.moves.size();
    for (const std::string& statement : file.statements) {
      execute(statement, depth);
    }
    if (std::none_of(file.statements.begin(), file.statements.end(), [](const std::string& line) {
          return line.starts_with("BAS (#INITMOV,0 )");
        })) {
      problem("BAS (#INITMOV,0 ) is missing");
    }
    job_.positions[name] = job_.moves.size() - before;
    ++job_.programs;
    current_ = caller;
  }

  /// The program as an operator starts it, from wherever the robot stands.
  void runAlone(const std::string& name) {
    run(name);
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
    current_ = "job";
    if (arc_) {
      problem("the arc is on at the end");
    }
    for (const auto& item : programs_) {
      if (!called_.contains(item.first)) {
        problem(item.first + " is never called");
      }
    }
  }

private:
  void problem(const std::string& text) { job_.problems.push_back(current_ + ": " + text); }

  void execute(const std::string& statement, int depth) {
    Scanner scanner(statement);
    if (scanner.accept("PTP ")) {
      motion(scanner, ReadKind::Joint);
    } else if (scanner.accept("LIN ")) {
      motion(scanner, ReadKind::Linear);
    } else if (scanner.accept("CIRC ")) {
      motion(scanner, ReadKind::Circular);
    } else if (scanner.accept("WAIT SEC")) {
      const auto seconds = scanner.real();
      job_.waits.push_back(seconds.value_or(-1.0));
      if (!seconds || !scanner.done()) {
        problem("WAIT SEC without value");
      }
    } else if (scanner.accept("BAS")) {
      basicMotion(scanner);
    } else if (scanner.accept("GLOBAL INTERRUPT DECL") || scanner.accept("INTERRUPT ON")) {
      return;
    } else if (scanner.accept("TRIGGER WHEN DISTANCE=0 DELAY=0 DO ")) {
      if (!arc_) {
        problem("a trigger without an arc: " + statement);
      }
      assignment(std::string(scanner.rest()));
    } else if (statement.find('=') != std::string::npos || scanner.rest().starts_with("$")) {
      // The advance run carries it out some moves before its place.
      if (arc_ && !scanner.rest().starts_with("$")) {
        problem("a variable changes in the advance run with the arc on: " + statement);
      }
      assignment(statement);
    } else {
      const std::string name = scanner.word();
      if (!scanner.accept("(") || !scanner.accept(")") || !programs_.contains(name) || depth > 0) {
        problem("unknown statement: " + statement);
      } else {
        run(name, depth + 1);
      }
    }
  }

  void basicMotion(Scanner& scanner) {
    scanner.accept("(");
    if (scanner.accept("#INITMOV,0")) {
      // It puts the speeds back to their defaults.
      pathSpeed_ = 0.0;
      axisSpeed_ = 0;
    } else if (scanner.accept("#VEL_PTP,")) {
      axisSpeed_ = scanner.integer().value_or(0);
      if (axisSpeed_ < 1 || axisSpeed_ > 100) {
        problem("#VEL_PTP takes 1 to 100 percent");
      }
    } else {
      problem("unknown BAS call");
    }
    if (!scanner.accept(")") || !scanner.done()) {
      problem("BAS call does not end");
    }
  }

  void assignment(const std::string& statement) {
    const std::size_t equal = statement.find('=');
    Scanner left(std::string_view(statement).substr(0, equal));
    Scanner right(equal == std::string::npos ? std::string_view()
                                             : std::string_view(statement).substr(equal + 1));
    if (equal == std::string::npos || right.done()) {
      problem("assignment without value: " + statement);
      return;
    }
    if (left.accept("$VEL.CP")) {
      pathSpeed_ = right.real().value_or(0.0);
      if (!(pathSpeed_ > 0.0 && pathSpeed_ <= kFastest)) {
        problem("$VEL.CP is in m/s and above 0: " + statement);
      }
    } else if (left.accept("$OUT[")) {
      output(left.integer().value_or(-1), right.accept("TRUE"));
    } else if (left.accept("$BASE")) {
      setBase(right);
    } else if (left.accept("$TOOL")) {
      tool_ = std::string(right.rest());
      if (!job_.frames.contains(tool_)) {
        problem("the program does not say what it was planned with: " + tool_);
      }
    } else if (left.accept("$IPO_MODE")) {
      remote_ = right.accept("#TCP");
      ipo_ = remote_ || right.accept("#BASE");
    } else if (left.accept("$ACT_EX_AX")) {
      activeExternal_ = right.integer();
    }
  }

  void setBase(Scanner& right) {
    right.skip();
    std::string name(right.rest());
    coupled_ = name.starts_with("EK(");
    if (coupled_) {
      const std::size_t comma = name.rfind(", ");
      const std::string root = name.substr(3, name.find(',') - 3);
      if (!job_.frames.contains(root)) {
        problem("the program does not say what it was planned with: " + root);
      }
      name = name.substr(comma + 2, name.size() - comma - 3);
    }
    if (!job_.frames.contains(name)) {
      problem("the program does not say what it was planned with: " + name);
    }
    base_ = name;
  }

  void output(int number, bool on) {
    if (number != arcOutput_) {
      ++job_.outputs[number];
      return;
    }
    if (arc_ == on || job_.moves.empty()) {
      problem("arc on and off do not take turns after a move");
    }
    arc_ = on;
    if (on) {
      job_.arcSchedules.push_back(number);
    }
  }

  void motion(Scanner& scanner, ReadKind kind) {
    if (base_.empty() || tool_.empty() || !ipo_) {
      problem("a move before $BASE, $TOOL and $IPO_MODE are set");
    }
    std::vector<ReadMove> moves;
    moves.push_back(moveTo(scanner, kind));
    if (kind == ReadKind::Circular) {
      moves.front().kind = ReadKind::CircularVia;
      if (!scanner.accept(",")) {
        problem("CIRC needs two positions");
      }
      moves.push_back(moveTo(scanner, kind));
    }
    const bool blended = kind == ReadKind::Joint
                             ? scanner.accept("C_PTP")
                             : scanner.accept("C_DIS") || scanner.accept("C_VEL");
    if (!scanner.done()) {
      problem("text after a move: " + std::string(scanner.rest()));
    }
    moves.back().stop = !blended;
    for (const ReadMove& move : moves) {
      lint(move);
      job_.moves.push_back(move);
    }
  }

  void lint(const ReadMove& move) {
    const bool joint = move.kind == ReadKind::Joint;
    if (job_.moves.empty() && (!joint || (move.cartesian && move.configuration.empty()))) {
      problem("the first move must be a PTP with S and T");
    }
    if (!job_.moves.empty() && job_.moves.front().external.size() != move.external.size()) {
      problem("external axes come and go");
    }
    if (activeExternal_ && *activeExternal_ != static_cast<int>(move.external.size())) {
      problem("$ACT_EX_AX does not fit the external axes");
    }
    if (!(move.speed > 0.0)) {
      problem("a move before its speed is set");
    }
    if (!joint && !move.cartesian) {
      problem("LIN and CIRC take Cartesian positions");
    }
  }

  ReadMove moveTo(Scanner& scanner, ReadKind kind) {
    ReadMove move;
    move.kind = kind;
    move.program = current_;
    move.arc = arc_;
    move.tool = tool_;
    move.base = base_;
    move.coupled = coupled_;
    move.remote = remote_;
    move.speed = kind == ReadKind::Joint ? axisSpeed_ : pathSpeed_ * 1000.0;
    const Aggregate aggregate = parseAggregate(scanner);
    const auto has = [&aggregate](const std::string& key) {
      return aggregate.fields.contains(key);
    };
    constexpr int kAxes = 6;
    move.cartesian = has("X");
    if (move.cartesian && has("Y") && has("Z") && has("A") && has("B") && has("C")) {
      move.pose = poseOf(aggregate);
    } else if (!move.cartesian) {
      for (int i = 1; i <= kAxes && has("A" + std::to_string(i)); ++i) {
        move.joints.push_back(aggregate.fields.at("A" + std::to_string(i)));
      }
    }
    for (int i = 1; has("E" + std::to_string(i)); ++i) {
      move.external.push_back(aggregate.fields.at("E" + std::to_string(i)));
    }
    const std::size_t expected =
        (move.cartesian ? kAxes : move.joints.size()) + move.external.size();
    if (aggregate.fields.size() != expected || (!move.cartesian && move.joints.size() != kAxes)) {
      problem("a position lacks fields or has others");
    }
    if (const auto status = aggregate.bits.find("S"); status != aggregate.bits.end()) {
      move.configuration = status->second;
    }
    if (const auto turn = aggregate.bits.find("T"); turn != aggregate.bits.end()) {
      for (auto it = turn->second.rbegin(); it != turn->second.rend(); ++it) {
        move.turns.push_back(*it == '1' ? 1 : 0);
      }
    }
    return move;
  }

  Aggregate parseAggregate(Scanner& scanner) {
    Aggregate aggregate;
    if (!scanner.accept("{")) {
      problem("position expected: " + std::string(scanner.rest().substr(0, 40)));
      return aggregate;
    }
    do {
      const std::string key = scanner.word();
      if (scanner.accept("'B")) {
        aggregate.bits[key] = scanner.word();
        if (!scanner.accept("'")) {
          problem("bits do not end");
        }
        continue;
      }
      int decimals = 0;
      const auto value = scanner.real(&decimals);
      if (!value || aggregate.fields.contains(key)) {
        problem("field " + key + " has no value or stands twice");
        return aggregate;
      }
      if (key.size() == 2 && key[0] == 'A') {
        job_.fewestJointDecimals = std::min(job_.fewestJointDecimals, decimals);
      }
      aggregate.fields[key] = *value;
    } while (scanner.accept(","));
    if (!scanner.accept("}")) {
      problem("position does not end: " + std::string(scanner.rest().substr(0, 40)));
    }
    return aggregate;
  }

  const std::map<std::string, KrlFile>& programs_;
  int arcOutput_;
  ReadJob& job_;
  std::string current_;
  std::set<std::string> called_;
  std::string base_;
  std::string tool_;
  bool coupled_ = false;
  bool remote_ = false;
  bool ipo_ = false;
  bool arc_ = false;
  double pathSpeed_ = 0.0;
  int axisSpeed_ = 0;
  std::optional<int> activeExternal_;
};

void lintName(const std::string& fileName, const std::string& name, ReadJob& job) {
  constexpr std::size_t kLongestName = 24;
  const bool letters = std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  });
  if (name.empty() || name.size() > kLongestName || !letters ||
      (name[0] >= '0' && name[0] <= '9')) {
    job.problems.push_back(fileName + ": '" + name + "' is not a program name");
  }
  static const std::set<std::string> kNoNames = {"END",  "LIN", "PTP",  "WAIT",     "SIGNAL", "BAS",
                                                 "LOOP", "DEF", "POS",  "IR_STOPM", "CON",    "AUX",
                                                 "PRN",  "NUL", "COM1", "LPT1"};
  if (kNoNames.contains(name)) {
    job.problems.push_back(fileName + ": '" + name + "' means something else");
  }
  if (fileName != name + ".src") {
    job.problems.push_back(fileName + ": file and program have different names");
  }
}

}  // namespace

ReadJob readKrl(const std::vector<std::pair<std::string, std::string>>& files, int arcOutput) {
  ReadJob job;
  std::map<std::string, KrlFile> programs;
  std::string first;
  for (const auto& [fileName, text] : files) {
    KrlFile file = KrlParser(fileName, job).parse(text);
    lintName(fileName, file.name, job);
    first = first.empty() ? file.name : first;
    if (!programs.emplace(file.name, std::move(file)).second) {
      job.problems.push_back(fileName + ": a program of this name exists already");
    }
  }
  KrlRunner runner(programs, arcOutput, job);
  if (!first.empty()) {
    runner.run(first);
  }
  runner.finish();
  for (const auto& [name, file] : programs) {
    if (job.positions[name] == 0 || programs.size() == 1 || name == first) {
      continue;
    }
    ReadJob alone;
    alone.frames = job.frames;
    KrlRunner(programs, arcOutput, alone).runAlone(name);
    job.problems.insert(job.problems.end(), alone.problems.begin(), alone.problems.end());
  }
  return job;
}

}  // namespace wcam::test
