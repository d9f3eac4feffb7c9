// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "krl_writer.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/program/names.hpp"

#include <algorithm>
#include <cmath>

namespace kuka {

namespace {

using namespace wcam::program;  // NOLINT: the instruction set is the vocabulary of this file
using wcam::Error;
using wcam::ErrorCode;

constexpr std::size_t kRemarkLength = 78;
constexpr double kMmPerMetre = 1000.0;
constexpr int kFifthAxis = 4;

/// Positions go into the turning table's frame.
bool inTableFrame(const Program& program, const Dialect& dialect) {
  return dialect.coupled && program.cell.positionerJoints > 0 && !program.cell.partCarried;
}

/// An axis this near to 0 (rad) is on both sides of it by rounding.
constexpr double kNearZero = 0.001 * wcam::kPi / 180.0;

void printRemark(TextWriter& out, const std::string& text) {
  for (const std::string& piece : wrapComment(text, kRemarkLength)) {
    out.text("; ").text(piece).text("\n");
  }
}

/// One line, however long.
void printFrame(TextWriter& out, const std::string& name, const Pose& pose) {
  const Eigen::Vector3d p = pose.translation();
  const Eigen::Vector3d abc = wcam::cell::toKukaAbc(pose.linear()) * (180.0 / wcam::kPi);
  out.text("; ").text(name).text(" = {X ").fixed<3>(p.x()).text(",Y ").fixed<3>(p.y());
  out.text(",Z ").fixed<3>(p.z()).text(",A ").fixed<4>(abc.x()).text(",B ").fixed<4>(abc.y());
  out.text(",C ").fixed<4>(abc.z()).text("}\n");
}

std::string baseName(const Dialect& dialect) {
  return dialect.base > 0 ? "BASE_DATA[" + std::to_string(dialect.base) + "]" : "$NULLFRAME";
}

std::string machineName(const Dialect& dialect) {
  return "MACHINE_DEF[" + std::to_string(dialect.machine) + "]";
}

/// What the program was planned with: an operator compares it with the controller.
void printProvenance(TextWriter& out, const Program& program, const Dialect& dialect) {
  const CellFacts& cell = program.cell;
  printRemark(out, "Project " + program.projectName + ", operation " + program.name);
  printRemark(out, "Cell " + cell.cellName);
  if (!cell.robotName.empty() || !cell.torchName.empty()) {
    printRemark(out, "Robot " + cell.robotName + ", torch " + cell.torchName);
  }
  printFrame(out, "TOOL_DATA[" + std::to_string(dialect.tool) + "]",
             cell.partCarried ? cell.T_flange_table : cell.T_flange_tcp);
  printFrame(out, baseName(dialect), cell.partCarried ? cell.T_base_tcp : Pose::Identity());
  if (cell.positionerJoints > 0) {
    printFrame(out, machineName(dialect) + ".ROOT", cell.T_base_root);
    printFrame(out, "Table with external axes at 0", cell.T_base_table);
  }
  if (program.process.wireDiameter > 0.0) {
    printRemark(out, "Wire " + wcam::formatFixed(program.process.wireDiameter, 2) + " mm at " +
                         wcam::formatFixed(wcam::toFileUnit(wcam::QuantityKind::WireSpeed,
                                                            program.process.wireSpeed),
                                           3) +
                         " m/min");
  }
  printRemark(out, "Job " + std::to_string(program.process.job));
}

/// Interrupt, basic motion data, tool and base.
void printInitialisation(TextWriter& out, const Program& program, const Dialect& dialect) {
  out.text(
      ";FOLD INI\n"
      "GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )\n"
      "INTERRUPT ON 3\n"
      "BAS (#INITMOV,0 )\n"
      ";ENDFOLD\n"
      "$BWDSTART = FALSE\n"
      "$ADVANCE = ");
  out.integer(dialect.advance)
      .text("\n$TOOL = TOOL_DATA[")
      .integer(dialect.tool)
      .text("]\n$BASE = ");
  const std::string base = baseName(dialect);
  if (inTableFrame(program, dialect)) {
    const std::string machine = machineName(dialect);
    out.text("EK(" + machine + ".ROOT, " + machine + ".MECH_TYPE, " + base + ")\n");
  } else {
    out.text(base).text("\n");
  }
  // #TCP: the torch stands, and the robot guides the part below it.
  out.text(program.cell.partCarried ? "$IPO_MODE = #TCP\n" : "$IPO_MODE = #BASE\n");
  if (dialect.externalAxisCount > 0) {
    out.text("$ACT_EX_AX = ").integer(dialect.externalAxisCount).text("\n");
  }
  if (dialect.approximation == Approximation::Distance) {
    out.text("$APO.CDIS = ").fixed<3>(dialect.approximationDistance.value()).text("\n");
  } else if (dialect.approximation == Approximation::Velocity) {
    out.text("$APO.CVEL = ").integer(dialect.approximationVelocity).text("\n");
  }
}

void printHead(TextWriter& out,
               const std::string& name,
               const Program& program,
               const Dialect& dialect) {
  out.text("&ACCESS RVP\n&REL 1\n&PARAM EDITMASK = *\nDEF ").text(name).text(" ( )\n");
  printProvenance(out, program, dialect);
  printInitialisation(out, program, dialect);
}

long long axisPercent(const MoveJoint& move) {
  return std::clamp<long long>(std::llround(100.0 * move.speedRatio), 1, 100);
}

class MovePrinter {
public:
  MovePrinter(TextWriter& out, const Program& program, const Dialect& dialect, ModalState& state)
      : out_(out), program_(program), cell_(program.cell), dialect_(dialect), state_(state) {}

  void print(const MoveJoint& move) {
    axisSpeed(axisPercent(move));
    out_.text("PTP ");
    if (dialect_.mode == Mode::Joint || dialect_.ptp == Ptp::Axes || ambiguous(move.target)) {
      axes(move.target);
    } else {
      pose(move.target, true);
    }
    endPtp(move.stop);
  }

  void print(const MoveLinear& move) {
    if (dialect_.mode == Mode::Joint) {
      printByAxes(move.target, move.speed, move.stop);
      return;
    }
    pathSpeed(move.speed);
    out_.text("LIN ");
    pose(move.target, false);
    endPath(move.stop);
  }

  void print(const MoveCircular& move) {
    if (dialect_.mode == Mode::Joint) {
      printByAxes(move.via, move.speed, false);
      printByAxes(move.target, move.speed, move.stop);
      return;
    }
    pathSpeed(move.speed);
    out_.text("CIRC ");
    pose(move.via, false);
    out_.text(",");
    pose(move.target, false);
    endPath(move.stop);
  }

  void print(const ArcOn& arc) {
    state_.job = arc.job;
    arc_ = true;
    if (dryRun()) {
      printRemark(out_, "Arc on: left out, dry run");
    } else if (dialect_.arc == Arc::Output) {
      print(SetIo{dialect_.arcOutput, true});
    } else if (dialect_.arc == Arc::Template) {
      lines(dialect_.arcOn, 0.0);
    }
  }

  void print(const ArcOff& arc) {
    arc_ = false;
    if (dryRun()) {
      printRemark(out_, "Arc off: left out, dry run");
      return;
    }
    if (dialect_.arc == Arc::Template) {
      lines(dialect_.arcOff, arc.craterTime);
      return;
    }
    if (arc.craterTime > 0.0) {
      print(Wait{arc.craterTime});
    }
    if (dialect_.arc == Arc::Output) {
      print(SetIo{dialect_.arcOutput, false});
    }
  }

  void print(const SetProcess& process) {
    if (!dialect_.wireVariable.empty() && !dryRun()) {
      // An assignment between moves is carried out in the advance run, several moves too early.
      out_.text(arc_ ? "TRIGGER WHEN DISTANCE=0 DELAY=0 DO " : "")
          .text(dialect_.wireVariable)
          .text(" = ");
      out_.fixed<3>(wcam::toFileUnit(wcam::QuantityKind::WireSpeed, process.wireSpeed)).text("\n");
    }
  }

  void print(const Wait& wait) { out_.text("WAIT SEC ").fixed<3>(wait.seconds).text("\n"); }

  void print(const SetIo& io) {
    out_.text("$OUT[").integer(io.output).text(io.on ? "] = TRUE\n" : "] = FALSE\n");
  }

  void print(const Comment& comment) { printRemark(out_, comment.text); }

  void print(const LayerBegin& layer) {
    if (dialect_.comments != Comments::None) {
      printRemark(out_, "Layer " + std::to_string(layer.layer + 1));
    }
  }

  void print(const BeadBegin& bead) {
    if (dialect_.comments == Comments::Beads) {
      printRemark(out_, "Layer " + std::to_string(bead.layer + 1) + " bead " +
                            std::to_string(bead.bead + 1));
    }
  }

  void print(const LayerEnd&) {}

  void print(const BeadEnd&) {}

private:
  /// PTP moves are too fast for a bead.
  [[nodiscard]] bool dryRun() const { return dialect_.mode == Mode::Joint; }

  /// Would status or turn be decided by rounding?
  [[nodiscard]] bool ambiguous(const Target& target) const {
    for (int i = 0; i < cell_.robotJoints; ++i) {
      if (std::abs(std::remainder(target.joints[i], wcam::kPi)) < kNearZero &&
          (std::abs(target.joints[i]) < kNearZero || i == kFifthAxis)) {
        return true;
      }
    }
    return false;
  }

  void pathSpeed(double speed) {
    // Robots of this brand move along paths with 3 m/s at most.
    constexpr double kFastest = 3.0;
    const double metres = speed / kMmPerMetre;
    const std::int64_t digits = fixedDigits(metres, dialect_.speedDecimals);
    if (digits == 0 || metres > kFastest) {
      throw Error(ErrorCode::JobFailed,
                  wcam::text("a speed of %1 mm/s cannot be written to $VEL.CP",
                             {wcam::formatFixed(speed, 6)}),
                  program_.name, "use speeds up to 3 m/s, and more decimals for slow ones");
    }
    if (pathSpeed_.changes(digits)) {
      out_.text("$VEL.CP = ").digits(digits, dialect_.speedDecimals).text("\n");
    }
  }

  void axisSpeed(long long percent) {
    if (axisSpeed_.changes(percent)) {
      out_.text("BAS (#VEL_PTP,").integer(percent).text(" )\n");
    }
  }

  /// A path move as a PTP to axis values that takes the same time, as far as whole percents of the
  /// axis speeds allow.
  void printByAxes(const Target& target, double speed, bool stop) {
    if (cell_.jointSpeeds.empty()) {
      throw Error(ErrorCode::JobFailed,
                  "the speed of moves to axis values needs the axis speeds of the cell",
                  program_.name, "add the joint speeds to the cell, or set mode=cartesian");
    }
    if (state_.target) {
      axisSpeed(percentFor(*state_.target, target, speed));
    }
    out_.text("PTP ");
    axes(target);
    endPtp(stop);
  }

  long long percentFor(const Target& from, const Target& to, double speed) {
    const double length = (to.T_table_tcp.translation() - from.T_table_tcp.translation()).norm();
    double fullSpeedTime = 0.0;
    for (Eigen::Index i = 0; i < to.joints.size(); ++i) {
      fullSpeedTime = std::max(fullSpeedTime, std::abs(to.joints[i] - from.joints[i]) /
                                                  cell_.jointSpeeds[static_cast<std::size_t>(i)]);
    }
    if (length <= 0.0 || fullSpeedTime <= 0.0) {
      return 1;
    }
    const double wanted = 100.0 * fullSpeedTime * speed / length;
    const auto percent = std::llround(std::clamp(wanted, 1.0, 100.0));
    state_.worstAxisSpeedError = std::max(state_.worstAxisSpeedError,
                                          std::abs(static_cast<double>(percent) - wanted) / wanted);
    return percent;
  }

  void axes(const Target& target) {
    remember(target);
    out_.text("{");
    for (int i = 0; i < cell_.robotJoints; ++i) {
      out_.text(i == 0 ? "A" : ",A").integer(i + 1).text(" ");
      joint(target, i);
    }
    externalAxes(target);
    out_.text("}");
  }

  void externalAxes(const Target& target) {
    for (int i = 0; i < cell_.positionerJoints; ++i) {
      out_.text(",E").integer(i + 1).text(" ");
      joint(target, cell_.robotJoints + i);
    }
  }

  void joint(const Target& target, int index) {
    const bool linear =
        !cell_.linearJoint.empty() && cell_.linearJoint[static_cast<std::size_t>(index)];
    if (linear) {
      out_.fixed(target.joints[index], dialect_.lengthDecimals);
    } else {
      out_.fixed(wcam::radToDeg(target.joints[index]), dialect_.angleDecimals);
    }
  }

  void pose(const Target& target, bool withStatus) {
    remember(target);
    const Pose pose = poseOf(target);
    const Eigen::Vector3d p = pose.translation();
    const Eigen::Vector3d abc = angles(pose.linear());
    constexpr std::array<std::string_view, 3> kLengths = {"{X ", ",Y ", ",Z "};
    constexpr std::array<std::string_view, 3> kAngles = {",A ", ",B ", ",C "};
    for (std::size_t i = 0; i < 3; ++i) {
      out_.text(kLengths[i]).fixed(p[static_cast<Eigen::Index>(i)], dialect_.lengthDecimals);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      out_.text(kAngles[i])
          .fixed(wcam::radToDeg(abc[static_cast<Eigen::Index>(i)]), dialect_.angleDecimals);
    }
    if (withStatus) {
      printStatus(target);
    }
    externalAxes(target);
    out_.text("}");
  }

  /// The tool in the base. Of a carried part: the table with the part in the frame of the torch.
  [[nodiscard]] Pose poseOf(const Target& target) const {
    if (cell_.partCarried) {
      return target.T_table_tcp.inverse();
    }
    return inTableFrame(program_, dialect_) ? target.T_table_tcp : target.T_base_tcp;
  }

  void remember(const Target& target) {
    if (!target.configuration.empty()) {
      state_.configuration = target.configuration;
    }
    state_.target = target;
  }

  /// A, B, C; at the gimbal lock, where only A ± C counts, A stays as it was.
  Eigen::Vector3d angles(const Eigen::Matrix3d& rotation) {
    // Keeping A within this distance of the lock turns the tool by less than 1e-5 degrees.
    constexpr double kLock = 1e-7;
    Eigen::Vector3d abc = wcam::cell::toKukaAbc(rotation);
    if (state_.abc && std::hypot(rotation(0, 0), rotation(1, 0)) < kLock) {
      const double a = state_.abc->x();
      const Eigen::Matrix3d rest = wcam::cell::rotationZ(-a) * rotation;
      abc = {a, std::atan2(-rest(2, 0), rest(0, 0)), std::atan2(-rest(1, 2), rest(1, 1))};
    }
    if (state_.abc && dialect_.angleRange == AngleRange::Continuous) {
      for (const Eigen::Index i : {0, 2}) {
        abc[i] = (*state_.abc)[i] + wcam::cell::wrapAngle(abc[i] - (*state_.abc)[i]);
      }
    }
    state_.abc = abc;
    return abc;
  }

  /// S: bit 0 wrist centre behind axis 1, bit 1 elbow up (A3 beyond the stretched arm), bit 2
  /// wrist. T: bit i set when axis i + 1 is negative.
  void printStatus(const Target& target) {
    out_.text(",S 'B")
        .text(dialect_.status.empty() ? status(target) : dialect_.status)
        .text("',T 'B");
    for (int i = cell_.robotJoints - 1; i >= 0; --i) {
      out_.text(target.joints[i] < 0.0 ? "1" : "0");
    }
    out_.text("'");
  }

  [[nodiscard]] std::string status(const Target& target) const {
    const double a5 = target.joints[kFifthAxis];
    const bool wrist = (a5 < 0.0 && a5 >= -wcam::kPi) || a5 >= wcam::kPi;
    const bool elbowUp = state_.configuration[1] == 'U';
    const bool overhead = state_.configuration[2] == 'B';
    return std::string(wrist ? "1" : "0") + (elbowUp ? "1" : "0") + (overhead ? "1" : "0");
  }

  void endPtp(bool stop) {
    out_.text(stop || dialect_.approximation == Approximation::None ? "\n" : " C_PTP\n");
  }

  void endPath(bool stop) {
    if (stop || dialect_.approximation == Approximation::None) {
      out_.text("\n");
    } else {
      out_.text(dialect_.approximation == Approximation::Distance ? " C_DIS\n" : " C_VEL\n");
    }
  }

  /// The user's lines with {job} and {crater} filled in.
  void lines(const std::string& text, double craterTime) {
    for (std::string line : wcam::splitText(text, '|')) {
      replace(line, "{job}", std::to_string(state_.job));
      replace(line, "{crater}", wcam::formatFixed(craterTime, 3));
      out_.text(wcam::trimText(line)).text("\n");
    }
  }

  static void replace(std::string& text, std::string_view key, const std::string& value) {
    for (std::size_t at = text.find(key); at != std::string::npos;
         at = text.find(key, at + value.size())) {
      text.replace(at, key.size(), value);
    }
  }

  TextWriter& out_;
  const Program& program_;
  const CellFacts& cell_;
  const Dialect& dialect_;
  ModalState& state_;
  ModalNumber pathSpeed_;
  ModalNumber axisSpeed_;
  bool arc_ = false;  ///< on
};

}  // namespace

int linesOf(const Action& action, const Dialect& dialect) {
  if (const auto* comment = std::get_if<Comment>(&action)) {
    return static_cast<int>(wrapComment(comment->text, kRemarkLength).size());
  }
  if (std::holds_alternative<LayerEnd>(action) || std::holds_alternative<BeadEnd>(action)) {
    return 0;
  }
  if (std::holds_alternative<LayerBegin>(action)) {
    return dialect.comments != Comments::None ? 1 : 0;
  }
  if (std::holds_alternative<BeadBegin>(action)) {
    return dialect.comments == Comments::Beads ? 1 : 0;
  }
  if (std::holds_alternative<SetProcess>(action)) {
    return dialect.wireVariable.empty() || dialect.mode == Mode::Joint ? 0 : 1;
  }
  constexpr int kSpeedAndMove = 2;
  if (std::holds_alternative<MoveCircular>(action)) {
    return 2 * kSpeedAndMove;  // two PTP in joint mode
  }
  if (targetCount(action) > 0) {
    return kSpeedAndMove;
  }
  if (std::holds_alternative<ArcOn>(action)) {
    return static_cast<int>(wcam::splitText(dialect.arcOn, '|').size());
  }
  if (std::holds_alternative<ArcOff>(action)) {
    return std::max(2, static_cast<int>(wcam::splitText(dialect.arcOff, '|').size()));
  }
  return 1;
}

std::vector<int> linesInOrder(std::span<const Instruction> instructions, const Dialect& dialect) {
  std::vector<int> lines;
  lines.reserve(instructions.size());
  ModalNumber pathSpeed;
  ModalNumber axisSpeed;
  for (const Instruction& instruction : instructions) {
    const Action& action = instruction.action;
    const auto* joint = std::get_if<MoveJoint>(&action);
    const auto* linear = std::get_if<MoveLinear>(&action);
    const auto* circular = std::get_if<MoveCircular>(&action);
    if (dialect.mode == Mode::Joint || (!joint && !linear && !circular)) {
      lines.push_back(linesOf(action, dialect));
    } else if (joint != nullptr) {
      lines.push_back(axisSpeed.changes(axisPercent(*joint)) ? 2 : 1);
    } else {
      const double speed = linear != nullptr ? linear->speed : circular->speed;
      lines.push_back(
          pathSpeed.changes(fixedDigits(speed / kMmPerMetre, dialect.speedDecimals)) ? 2 : 1);
    }
  }
  return lines;
}

int headLines(const Program& program, const Dialect& dialect) {
  TextWriter head;
  printHead(head, "PROGRAM", program, dialect);
  const std::string_view text = head.view();
  // The end, and the speeds of path and axes that hold where a part begins.
  constexpr int kSpeeds = 2;
  return 1 + kSpeeds + static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

std::string printProgram(const NamedPart& part,
                         const Program& program,
                         const Dialect& dialect,
                         ModalState& state,
                         const wcam::JobContext& context) {
  constexpr std::size_t kCheckInterval = 1024;
  constexpr std::size_t kBytesPerLine = 100;
  TextWriter out(4096 + kBytesPerLine * part.size());
  printHead(out, part.name, program, dialect);
  MovePrinter printer(out, program, dialect, state);
  std::size_t count = 0;
  part.forEach([&](const Instruction& instruction) {
    if (count++ % kCheckInterval == 0) {
      context.check();
    }
    std::visit([&printer](const auto& action) { printer.print(action); }, instruction.action);
  });
  out.text("END\n");
  return out.take();
}

std::string printMain(const std::string& name,
                      const Program& program,
                      std::span<const std::string> parts,
                      const Dialect& dialect) {
  TextWriter out;
  printHead(out, name, program, dialect);
  for (const std::string& part : parts) {
    out.text(part).text(" ( )\n");
  }
  out.text("END\n");
  return out.take();
}

}  // namespace kuka
