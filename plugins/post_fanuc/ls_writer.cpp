// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ls_writer.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/program/names.hpp"

#include <algorithm>
#include <cmath>

namespace fanuc {

namespace {

using namespace wcam::program;  // NOLINT: the instruction set is the vocabulary of this file

constexpr std::size_t kRemarkLength = 32;
constexpr std::size_t kProgramCommentLength = 16;
constexpr std::string_view kEnd = "    ;\n";
/// A joint this near (rad) to the border between two turn numbers is on both sides by rounding.
constexpr double kOnBorder = 0.001 * wcam::kPi / 180.0;
constexpr double kFullTurn = 2.0 * wcam::kPi;

/// Does the speed hold at the fixed torch?
bool remote(const Program& program, const Dialect& dialect) {
  return program.cell.partCarried && dialect.remoteTool;
}

/// The user frame that positions of the robot are in.
int userFrameOf(const Program& program, const Dialect& dialect) {
  return remote(program, dialect) ? dialect.remoteFrame : dialect.userFrame;
}

std::string number(double value, int decimals) {
  TextWriter out;
  return out.fixed(value, decimals).take();
}

void addFrame(std::vector<std::string>& remarks, const std::string& name, const Pose& pose) {
  constexpr int kLengthDecimals = 3;
  constexpr int kAngleDecimals = 4;
  const Eigen::Vector3d p = pose.translation();
  const Eigen::Vector3d wpr = wcam::cell::toFanucWpr(pose.linear());
  constexpr std::array<const char*, 3> kLengths = {" X ", " Y ", " Z "};
  constexpr std::array<const char*, 3> kAngles = {" W ", " P ", " R "};
  for (std::size_t i = 0; i < 3; ++i) {
    remarks.push_back(name + kLengths[i] +
                      number(p[static_cast<Eigen::Index>(i)], kLengthDecimals));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    remarks.push_back(name + kAngles[i] +
                      number(wcam::radToDeg(wpr[static_cast<Eigen::Index>(i)]), kAngleDecimals));
  }
}

/// What a program was planned with: an operator compares it with the controller.
std::vector<std::string> provenance(const Program& program, const Dialect& dialect) {
  const CellFacts& cell = program.cell;
  std::vector<std::string> remarks = {"Project " + program.projectName, "Operation " + program.name,
                                      "Cell " + cell.cellName};
  if (!cell.torchName.empty()) {
    remarks.push_back("Torch " + cell.torchName);
  }
  const std::string tool = "UTOOL[" + std::to_string(dialect.toolFrame) + "]";
  addFrame(remarks, tool, cell.partCarried ? cell.T_flange_table : cell.T_flange_tcp);
  const int frame = userFrameOf(program, dialect);
  const std::string user = "UFRAME[" + std::to_string(frame) + "]";
  if (frame > 0) {
    const bool onTable = dialect.mode == Mode::Cartesian && dialect.frame == Frame::Table;
    addFrame(remarks, user,
             remote(program, dialect) ? cell.T_base_tcp
                                      : (onTable ? cell.T_base_table : Pose::Identity()));
  } else {
    remarks.push_back(user + " robot base");
  }
  if (cell.positionerJoints > 0) {
    addFrame(remarks, "Positioner", cell.T_base_root);
    addFrame(remarks, "Table at 0", cell.T_base_table);
  }
  if (program.process.wireDiameter > 0.0) {
    remarks.push_back("Wire " + number(program.process.wireDiameter, 2) + " mm");
    remarks.push_back(
        "Wire speed " +
        number(wcam::toFileUnit(wcam::QuantityKind::WireSpeed, program.process.wireSpeed), 3) +
        " m/min");
  }
  remarks.push_back("Job " + std::to_string(program.process.job));
  return remarks;
}

std::vector<std::string> remarkLines(const std::string& text) {
  std::vector<std::string> lines = wrapComment(text, kRemarkLength);
  for (std::string& line : lines) {
    // A ';' would end the line.
    std::replace(line.begin(), line.end(), ';', ',');
  }
  return lines;
}

/// Full turns that a joint value is away from -180 to 180 degrees.
int turnOf(double value) {
  const double turns = std::floor((std::abs(value) + wcam::kPi) / kFullTurn);
  return static_cast<int>(value < 0.0 ? -turns : turns);
}

bool onTurnBorder(double value) {
  return std::abs(std::abs(std::remainder(value, kFullTurn)) - wcam::kPi) < kOnBorder;
}

/// Attributes of a program. Sizes are recomputed by the controller when it loads the file; dates
/// are fixed so that the same program gives the same bytes.
void printHeader(TextWriter& out,
                 const std::string& name,
                 const std::string& comment,
                 std::int64_t lines,
                 int motionGroups,
                 const Dialect& dialect) {
  const std::vector<std::string> shortened = wrapComment(comment, kProgramCommentLength);
  std::string quoted = shortened.front();
  std::replace(quoted.begin(), quoted.end(), '"', '\'');
  out.text("/PROG  ").text(name).text("\n/ATTR\nOWNER\t\t= MNEDITOR;\nCOMMENT\t\t= \"");
  out.text(quoted).text(
      "\";\nPROG_SIZE\t= 0;\n"
      "CREATE\t\t= DATE 00-01-01  TIME 00:00:00;\nMODIFIED\t= DATE 00-01-01  TIME 00:00:00;\n"
      "FILE_NAME\t= ;\nVERSION\t\t= 0;\nLINE_COUNT\t= ");
  out.integer(lines).text(
      ";\nMEMORY_SIZE\t= 0;\nPROTECT\t\t= READ_WRITE;\n"
      "TCD:  STACK_SIZE\t= 0,\n      TASK_PRIORITY\t= 50,\n      TIME_SLICE\t= 0,\n"
      "      BUSY_LAMP_OFF\t= 0,\n      ABORT_REQUEST\t= 0,\n      PAUSE_REQUEST\t= 0;\n"
      "DEFAULT_GROUP\t= ");
  for (int group = 0; group < dialect.groups(); ++group) {
    out.text(group == 0 ? "" : ",").text(group < motionGroups ? "1" : "*");
  }
  out.text(";\nCONTROL_CODE\t= 00000000 00000000;\n/MN\n");
}

class PartPrinter {
public:
  PartPrinter(const Program& program, const Dialect& dialect, ModalState& state)
      : program_(program),
        cell_(program.cell),
        dialect_(dialect),
        state_(state),
        userFrame_(userFrameOf(program, dialect)) {}

  void print(const NamedPart& part, const wcam::JobContext& context) {
    constexpr std::size_t kCheckInterval = 1024;
    for (const std::string& text : provenance(program_, dialect_)) {
      remark(text);
    }
    plain("UFRAME_NUM=").integer(userFrame_).text(kEnd);
    plain("UTOOL_NUM=").integer(dialect_.toolFrame).text(kEnd);
    if (dialect_.payload > 0) {
      plain("PAYLOAD[").integer(dialect_.payload).text("]").text(kEnd);
    }
    std::size_t count = 0;
    part.forEach([&](const Instruction& instruction) {
      if (count++ % kCheckInterval == 0) {
        context.check();
      }
      std::visit([this](const auto& action) { print(action); }, instruction.action);
    });
  }

  std::string assemble(const std::string& name, const std::string& comment) {
    TextWriter file(body_.size() + positions_.size() + 4096);
    printHeader(file, name, comment, lines_, cell_.positionerJoints > 0 ? 2 : 1, dialect_);
    file.text(body_.view()).text("/POS\n").text(positions_.view()).text("/END\n");
    return file.take();
  }

private:
  TextWriter& line() { return body_.integer(++lines_, 4).text(":"); }

  TextWriter& plain(std::string_view text) { return line().text("  ").text(text); }

  void print(const MoveJoint& move) {
    const auto percent = std::clamp<long long>(std::llround(100.0 * move.speedRatio), 1, 100);
    line().text("J P[").integer(addPosition(move.target, true)).text("] ").integer(percent);
    body_.text("% ");
    printTermination(move.stop);
    body_.text(kEnd);
  }

  void print(const MoveLinear& move) {
    line().text("L P[").integer(addPosition(move.target, false)).text("] ");
    printPathMove(move.speed, move.stop);
  }

  void print(const MoveCircular& move) {
    line().text("C P[").integer(addPosition(move.via, false)).text("]    \n    :  P[");
    body_.integer(addPosition(move.target, false)).text("] ");
    printPathMove(move.speed, move.stop);
  }

  void print(const ArcOn& arc) {
    state_.job = arc.job;
    printArc("Arc Start[", dialect_.arcStart);
  }

  void print(const ArcOff& arc) {
    if (dialect_.crater == Crater::Wait && arc.craterTime > 0.0) {
      print(Wait{arc.craterTime});
    }
    printArc("Arc End[", dialect_.arcEnd);
  }

  void printArc(std::string_view instruction, int schedule) {
    plain(instruction).integer(schedule > 0 ? schedule : state_.job).text("]").text(kEnd);
  }

  void print(const SetProcess& process) {
    if (dialect_.wireRegister > 0) {
      plain("R[").integer(dialect_.wireRegister).text("]=");
      body_.fixed<3>(wcam::toFileUnit(wcam::QuantityKind::WireSpeed, process.wireSpeed)).text(kEnd);
    }
  }

  void print(const Wait& wait) {
    plain("WAIT ").fixed(wait.seconds, 2, 6).text("(sec)").text(kEnd);
  }

  void print(const SetIo& io) {
    plain("DO[").integer(io.output).text(io.on ? "]=ON" : "]=OFF").text(kEnd);
  }

  void print(const Comment& comment) { remark(comment.text); }

  void print(const LayerBegin& layer) {
    if (dialect_.comments != Comments::None) {
      remark("Layer " + std::to_string(layer.layer + 1));
    }
  }

  void print(const BeadBegin& bead) {
    if (dialect_.comments == Comments::Beads) {
      remark("Layer " + std::to_string(bead.layer + 1) + " bead " + std::to_string(bead.bead + 1));
    }
  }

  void print(const LayerEnd&) {}

  void print(const BeadEnd&) {}

  void remark(const std::string& text) {
    for (const std::string& piece : remarkLines(text)) {
      plain("!").text(piece).text(kEnd);
    }
  }

  void printPathMove(double speed, bool stop) {
    const bool perMinute = dialect_.speedUnit == SpeedUnit::CmPerMinute;
    constexpr double kCmPerMinute = 6.0;  // of 1 mm/s
    const double number = perMinute ? speed * kCmPerMinute : speed;
    const std::int64_t digits = fixedDigits(number, dialect_.speedDecimals);
    if (digits == 0) {
      throw wcam::Error(
          wcam::ErrorCode::JobFailed,
          wcam::text("a speed of %1 mm/s would be written as 0", {std::to_string(speed)}),
          program_.name, "write speeds in cm/min or with more decimals");
    }
    const double printed =
        static_cast<double>(digits) / std::pow(10.0, static_cast<double>(dialect_.speedDecimals));
    state_.worstSpeedError = std::max(state_.worstSpeedError, std::abs(printed - number) / number);
    body_.digits(digits, dialect_.speedDecimals).text(perMinute ? "cm/min " : "mm/sec ");
    printTermination(stop);
    if (remote(program_, dialect_)) {
      body_.text(" RTCP");
    } else if (cell_.positionerJoints > 0 && dialect_.coordinated) {
      body_.text(" COORD");
    }
    body_.text(kEnd);
  }

  void printTermination(bool stop) {
    if (stop || dialect_.termination == Termination::Fine) {
      body_.text("FINE");
    } else {
      body_.text("CNT").integer(dialect_.cnt);
    }
  }

  std::int64_t addPosition(const Target& target, bool jointMove) {
    if (!target.configuration.empty()) {
      state_.configuration = target.configuration;
    }
    positions_.text("P[").integer(++positionCount_).text("]{\n");
    frameLine(1, userFrame_, dialect_.toolFrame);
    // Beside a border of the turn numbers a joint move needs the joints to know where to go.
    if (dialect_.mode == Mode::Joint || (jointMove && ambiguous(target))) {
      positions_.text("\n");
      printJoints(target, 0, cell_.robotJoints);
    } else {
      printPose(target);
    }
    if (cell_.positionerJoints > 0) {
      positions_.text("\n");
      frameLine(2, dialect_.positionerUserFrame, dialect_.positionerToolFrame);
      positions_.text("\n");
      printJoints(target, cell_.robotJoints, cell_.positionerJoints);
    }
    positions_.text("\n};\n");
    return positionCount_;
  }

  void frameLine(int group, int userFrame, int toolFrame) {
    positions_.text("   GP").integer(group).text(":\n\tUF : ").integer(userFrame);
    positions_.text(", UT : ").integer(toolFrame).text(",\t");
  }

  /// Joints of one group, counted from 1, three in a row.
  void printJoints(const Target& target, int first, int count) {
    constexpr int kPerRow = 3;
    for (int i = 0; i < count; ++i) {
      const int joint = first + i;
      const bool linear =
          !cell_.linearJoint.empty() && cell_.linearJoint[static_cast<std::size_t>(joint)];
      const double value = linear ? target.joints[joint] : wcam::radToDeg(target.joints[joint]);
      positions_.text(i == 0 ? "\t" : (i % kPerRow == 0 ? ",\n\t" : ",\t"));
      positions_.text("J").integer(i + 1).text("= ");
      positions_.fixed(value, dialect_.jointDecimals,
                       static_cast<std::size_t>(dialect_.jointDecimals) + 6);
      positions_.text(linear ? "  mm" : " deg");
    }
  }

  void printPose(const Target& target) {
    const Pose pose = poseOf(target);
    const Eigen::Vector3d p = pose.translation();
    const Eigen::Vector3d wpr = wcam::cell::toFanucWpr(pose.linear());
    printConfiguration(target);
    positions_.text("\tX = ");
    length(p.x()).text("  mm,\tY = ");
    length(p.y()).text("  mm,\tZ = ");
    length(p.z()).text("  mm,\n\tW = ");
    length(wcam::radToDeg(wpr.x())).text(" deg,\tP = ");
    length(wcam::radToDeg(wpr.y())).text(" deg,\tR = ");
    length(wcam::radToDeg(wpr.z())).text(" deg");
  }

  /// The tool frame in the user frame. Of a carried part: the part's table in the frame of the
  /// fixed torch, or in the robot base.
  [[nodiscard]] Pose poseOf(const Target& target) const {
    if (remote(program_, dialect_)) {
      return target.T_table_tcp.inverse();
    }
    if (cell_.partCarried) {
      return target.T_base_tcp * target.T_table_tcp.inverse();
    }
    return dialect_.frame == Frame::Table ? target.T_table_tcp : target.T_base_tcp;
  }

  [[nodiscard]] std::array<int, 3> turnAxes() const {
    return dialect_.turnAxes == TurnAxes::J1J4J6 ? std::array<int, 3>{0, 3, 5}
                                                 : std::array<int, 3>{3, 4, 5};
  }

  [[nodiscard]] bool ambiguous(const Target& target) const {
    const std::array<int, 3> axes = turnAxes();
    return std::any_of(axes.begin(), axes.end(),
                       [&](int joint) { return onTurnBorder(target.joints[joint]); });
  }

  TextWriter& length(double value) {
    return positions_.fixed(value, dialect_.cartesianDecimals,
                            static_cast<std::size_t>(dialect_.cartesianDecimals) + 6);
  }

  /// Letters, then how often three axes are turned beyond ±180°; on a border as before it.
  void printConfiguration(const Target& target) {
    const std::string& letters = state_.configuration;
    positions_.text("\tCONFIG : '");
    for (const char letter : letters) {
      positions_.text({&letter, 1}).text(letter == letters.back() ? "" : " ");
    }
    const std::array<int, 3> axes = turnAxes();
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const double value = target.joints[axes[i]];
      state_.turns[i] = onTurnBorder(value) ? state_.turns[i] : turnOf(value);
      if (std::abs(state_.turns[i]) > std::abs(state_.farthestTurn)) {
        state_.farthestTurn = state_.turns[i];
        state_.farthestTurnAxis = axes[i];
      }
      positions_.text(", ").integer(state_.turns[i]);
    }
    positions_.text("',\n");
  }

  const Program& program_;
  const CellFacts& cell_;
  const Dialect& dialect_;
  ModalState& state_;
  int userFrame_;
  TextWriter body_;
  TextWriter positions_;
  std::int64_t lines_ = 0;
  std::int64_t positionCount_ = 0;
};

}  // namespace

int linesOf(const Action& action, const Dialect& dialect) {
  if (const auto* comment = std::get_if<Comment>(&action)) {
    return static_cast<int>(remarkLines(comment->text).size());
  }
  if (std::holds_alternative<LayerEnd>(action) || std::holds_alternative<BeadEnd>(action)) {
    return 0;
  }
  if (std::holds_alternative<SetProcess>(action)) {
    return dialect.wireRegister > 0 ? 1 : 0;
  }
  constexpr int kWithCrater = 2;
  return std::holds_alternative<ArcOff>(action) ? kWithCrater : 1;
}

int headLines(const Program& program, const Dialect& dialect) {
  constexpr int kFrames = 3;  // UFRAME_NUM, UTOOL_NUM, PAYLOAD
  int lines = kFrames;
  for (const std::string& text : provenance(program, dialect)) {
    lines += static_cast<int>(remarkLines(text).size());
  }
  return lines;
}

std::string printPart(const NamedPart& part,
                      const std::string& comment,
                      const Program& program,
                      const Dialect& dialect,
                      ModalState& state,
                      const wcam::JobContext& context) {
  PartPrinter printer(program, dialect, state);
  printer.print(part, context);
  return printer.assemble(part.name, comment);
}

std::string printMain(const std::string& name,
                      const std::string& comment,
                      const Program& program,
                      std::span<const std::string> parts,
                      const Dialect& dialect) {
  TextWriter body;
  std::int64_t line = 0;
  for (const std::string& text : provenance(program, dialect)) {
    for (const std::string& piece : remarkLines(text)) {
      body.integer(++line, 4).text(":  !").text(piece).text(kEnd);
    }
  }
  for (const std::string& part : parts) {
    body.integer(++line, 4).text(":  CALL ").text(part).text(kEnd);
  }
  TextWriter file;
  printHeader(file, name, comment, line, 0, dialect);
  file.text(body.view()).text("/POS\n/END\n");
  return file.take();
}

}  // namespace fanuc
