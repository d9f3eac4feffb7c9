// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/validate.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"

#include <cmath>
#include <map>

namespace wcam::program {

namespace {

/// Greatest entry of RᵀR − I that a rotation of doubles may have after the products of a long
/// kinematic chain; a scaled or sheared matrix is off by far more.
constexpr double kRotationTolerance = 1e-9;
constexpr int kMaxJoints = JointVector::MaxRowsAtCompileTime;

bool isRigid(const Pose& pose) {
  const Eigen::Matrix3d rotation = pose.linear();
  return ((rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).array().abs() <=
          kRotationTolerance)
             .all() &&
         rotation.determinant() > 0.0;
}

bool isConfiguration(std::string_view text) {
  return text.size() == 3 && (text[0] == 'N' || text[0] == 'F') &&
         (text[1] == 'U' || text[1] == 'D') && (text[2] == 'T' || text[2] == 'B');
}

class Checker {
public:
  explicit Checker(const Program& program) : program_(program) {}

  std::vector<Diagnostic> run() {
    checkCell();
    for (const Instruction& instruction : program_.instructions) {
      origin_ = instruction.origin;
      std::visit([this](const auto& action) { check(action); }, instruction.action);
    }
    if (!moved_) {
      violation("no_motion", "the program has no move", "give the operation a toolpath");
    }
    if (arc_) {
      violation("arc_left_on", "the arc is still on at the end", "end the program with arc off");
    }
    if (layer_ || bead_) {
      violation("marks", "a layer or bead mark is left open", "close every mark");
    }
    std::vector<Diagnostic> result;
    for (const std::string& code : order_) {
      result.push_back(found_.at(code));
    }
    return result;
  }

private:
  void finding(Severity severity,
               const std::string& rule,
               const Text& message,
               const Text& remedy) {
    const std::string code = "program." + rule;
    const auto [it, first] = found_.try_emplace(code);
    if (first) {
      order_.push_back(code);
      it->second = {severity,
                    code,
                    message,
                    remedy,
                    {program_.name, origin_.layer, origin_.bead, origin_.point},
                    {{"count", 0.0}}};
    }
    it->second.data.front().second += 1.0;
  }

  void violation(const std::string& rule, const Text& message, const Text& remedy) {
    finding(Severity::Violation, rule, message, remedy);
  }

  void requireFinite(bool finite, const Text& what) {
    if (!finite) {
      violation("number_not_finite", text("%1 is not finite", {what}),
                "report this: a stage before failed");
    }
  }

  void checkCell() {
    const CellFacts& cell = program_.cell;
    const int joints = cell.robotJoints + cell.positionerJoints;
    if (cell.robotJoints < 1 || cell.positionerJoints < 0 || joints > kMaxJoints) {
      violation("cell",
                text("a cell has 1 to %1 joints, not %2 + %3",
                     {std::to_string(kMaxJoints), std::to_string(cell.robotJoints),
                      std::to_string(cell.positionerJoints)}),
                "correct the cell");
    }
    const auto fits = [joints](std::size_t size) {
      return size == 0 || (joints > 0 && size == static_cast<std::size_t>(joints));
    };
    if (!fits(cell.linearJoint.size()) || !fits(cell.jointSpeeds.size()) ||
        !fits(cell.jointNames.size())) {
      violation("cell",
                "names, kinds and speeds of joints must be given for all joints or for none",
                "correct the cell");
    }
    if (!isConfiguration(cell.configuration)) {
      violation("configuration",
                text("configuration '%1' is not one of N/F, U/D, T/B", {cell.configuration}),
                "write it like NUT");
    }
  }

  void checkTarget(const Target& target) {
    const auto joints = program_.cell.robotJoints + program_.cell.positionerJoints;
    if (target.joints.size() != joints) {
      violation("joint_count",
                text("a position has %1 joints, the cell %2",
                     {std::to_string(target.joints.size()), std::to_string(joints)}),
                "plan the motion again with this cell");
    }
    requireFinite(target.joints.allFinite(), "a joint value");
    const bool finite =
        target.T_base_tcp.matrix().allFinite() && target.T_table_tcp.matrix().allFinite();
    requireFinite(finite, "a pose");
    if (finite && !(isRigid(target.T_base_tcp) && isRigid(target.T_table_tcp))) {
      violation("pose_not_rigid", "a pose is not a rotation with a translation",
                "report this: a stage before failed");
    }
    if (!target.configuration.empty() && !isConfiguration(target.configuration)) {
      violation("configuration",
                text("configuration '%1' is not one of N/F, U/D, T/B", {target.configuration}),
                "write it like NUT");
    }
  }

  void checkSpeed(double speed) {
    requireFinite(std::isfinite(speed), "a speed");
    if (std::isfinite(speed) && speed <= 0.0) {
      violation("speed", "a linear or circular move needs a speed above 0",
                "set the travel speeds of the operation");
    }
  }

  void move(bool joint) {
    if (!moved_ && !joint) {
      violation(
          "first_move", "the first move is not a joint move",
          "approach the first point with a joint move, so that the robot configuration is known");
    }
    moved_ = true;
  }

  void check(const MoveJoint& action) {
    move(true);
    checkTarget(action.target);
    requireFinite(std::isfinite(action.speedRatio), "a speed ratio");
    if (!(action.speedRatio > 0.0 && action.speedRatio <= 1.0)) {
      violation("speed_ratio", "the speed ratio of a joint move is not in (0, 1]",
                "set it between 0 and 1");
    }
    if (arc_) {
      finding(Severity::Warning, "joint_move_with_arc",
              "a joint move with the arc on: its path and speed are not controlled",
              "use linear moves inside a bead");
    }
  }

  void check(const MoveLinear& action) {
    move(false);
    checkTarget(action.target);
    checkSpeed(action.speed);
  }

  void check(const MoveCircular& action) {
    move(false);
    checkTarget(action.via);
    checkTarget(action.target);
    checkSpeed(action.speed);
  }

  void check(const ArcOn& action) {
    if (!moved_) {
      violation("arc_before_motion", "the arc goes on before the first move",
                "move to the start point first");
    }
    if (arc_) {
      violation("arc_twice", "the arc goes on while it is on", "put arc off between the beads");
    }
    if (action.job < 0) {
      violation("job", "a welding job has a negative number", "choose a job of the welding source");
    }
    arc_ = true;
  }

  void check(const ArcOff& action) {
    if (!arc_) {
      violation("arc_off_twice", "the arc goes off while it is off", "put arc on before the bead");
    }
    checkTime(action.craterTime);
    arc_ = false;
  }

  void check(const SetProcess& action) {
    requireFinite(std::isfinite(action.wireSpeed), "a wire speed");
    if (action.wireSpeed < 0.0) {
      violation("wire_speed", "a wire speed is negative", "set the wire speed of the process");
    }
  }

  void check(const Wait& action) { checkTime(action.seconds); }

  void checkTime(double seconds) {
    requireFinite(std::isfinite(seconds), "a time");
    if (seconds < 0.0) {
      violation("time", "a time is negative", "set it to 0 or more");
    }
  }

  void check(const SetIo& action) {
    if (action.output < 1) {
      violation("output", "outputs are counted from 1", "choose an output of the controller");
    }
  }

  void check(const Comment&) {}

  void check(const LayerBegin&) { mark(!layer_ && !bead_, layer_, true); }

  void check(const LayerEnd&) { mark(layer_ && !bead_, layer_, false); }

  void check(const BeadBegin&) { mark(!bead_, bead_, true); }

  void check(const BeadEnd&) { mark(bead_, bead_, false); }

  void mark(bool allowed, bool& state, bool next) {
    if (!allowed) {
      violation("marks", "layer and bead marks do not nest", "close every mark before the next");
    }
    state = next;
  }

  const Program& program_;
  Origin origin_;
  bool moved_ = false;
  bool arc_ = false;
  bool layer_ = false;
  bool bead_ = false;
  std::map<std::string, Diagnostic> found_;
  std::vector<std::string> order_;
};

}  // namespace

std::vector<Diagnostic> validate(const Program& program) {
  return Checker(program).run();
}

void requireValid(const Program& program) {
  std::vector<std::string> lines;
  for (const Diagnostic& diagnostic : validate(program)) {
    if (diagnostic.severity == Severity::Violation) {
      lines.push_back(toLine(diagnostic));
    }
  }
  if (!lines.empty()) {
    throw Error(ErrorCode::JobFailed,
                text("the program cannot be printed:\n  %1", {joinText(lines, "\n  ")}),
                program.name);
  }
}

}  // namespace wcam::program
