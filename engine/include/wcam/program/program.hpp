// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/joints.hpp"
#include "wcam/geometry/types.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// The robot-neutral program (DESIGN 9): a small closed set of instructions, each knowing where it
/// comes from. A post-processor is a pure printer of it. Units: mm, rad, s, mm/s.
namespace wcam::program {

using cell::JointVector;
using geometry::Pose;

/// Layer, bead and point an instruction comes from; −1 where none.
struct Origin {
  int layer = -1;
  int bead = -1;
  int point = -1;
};

/// A robot position in all the forms that a robot language may want.
struct Target {
  JointVector joints;                   ///< controller values: robot joints, then positioner joints
  Pose T_base_tcp = Pose::Identity();   ///< in the robot base frame
  Pose T_table_tcp = Pose::Identity();  ///< in the frame of the table that carries the part: the
                                        ///< positioner's, or the one on the flange
  /// Robot configuration as in CellFacts::configuration; empty: that of the target before.
  std::string configuration = {};
};

struct MoveJoint {
  Target target;
  double speedRatio = 0.1;  ///< part of the maximal joint speed, 0..1
  bool stop = true;         ///< stop exactly here (FINE), or pass (CNT, approximation)
};

struct MoveLinear {
  Target target;
  double speed = 0.0;  ///< TCP speed relative to the part, mm/s
  bool stop = false;
};

/// A target apart from the move that holds it: few moves are circular, and an instruction is as
/// large as the largest of them. Copies are copies of the target.
class TargetApart {
public:
  TargetApart(Target target = {}) : target_(std::make_unique<Target>(std::move(target))) {}

  TargetApart(const TargetApart& other) : TargetApart(*other.target_) {}

  TargetApart(TargetApart&&) noexcept = default;

  TargetApart& operator=(TargetApart other) noexcept {
    target_ = std::move(other.target_);
    return *this;
  }

  ~TargetApart() = default;

  operator const Target&() const { return *target_; }

  const Target* operator->() const { return target_.get(); }

  Target* operator->() { return target_.get(); }

private:
  std::unique_ptr<Target> target_;
};

struct MoveCircular {
  TargetApart via;
  Target target;
  double speed = 0.0;
  bool stop = false;
};

struct ArcOn {
  int job = 1;  ///< job number of the welding source
};

struct ArcOff {
  double craterTime = 0.0;  ///< s of crater fill
};

struct SetProcess {
  double wireSpeed = 0.0;  ///< mm/s
};

struct Wait {
  double seconds = 0.0;
};

struct SetIo {
  int output = 0;
  bool on = false;
};

struct Comment {
  std::string text;
};

struct LayerBegin {
  int layer = 0;
};

struct LayerEnd {
  int layer = 0;
};

struct BeadBegin {
  int layer = 0;
  int bead = 0;
};

struct BeadEnd {
  int layer = 0;
  int bead = 0;
};

using Action = std::variant<MoveJoint,
                            MoveLinear,
                            MoveCircular,
                            ArcOn,
                            ArcOff,
                            SetProcess,
                            Wait,
                            SetIo,
                            Comment,
                            LayerBegin,
                            LayerEnd,
                            BeadBegin,
                            BeadEnd>;

struct Instruction {
  Action action;
  Origin origin;
};

/// What a printer must know of the cell.
struct CellFacts {
  std::string cellName;
  std::string robotName = {};
  std::string torchName = {};
  std::string controller = {};  ///< make of the controller as the cell names it; empty: not known
  int robotJoints = 6;
  int positionerJoints = 0;
  bool partCarried = false;
  std::vector<std::string> jointNames;
  std::vector<bool> linearJoint;  ///< per joint: mm instead of rad; empty: all are rotations
  /// Greatest speed of each joint, rad/s or mm/s; empty when not known. Needed by languages that
  /// give the speed of a joint move per axis.
  std::vector<double> jointSpeeds = {};
  Pose T_flange_tcp = Pose::Identity();    ///< torch carried: the tool frame of the controller
  Pose T_flange_table = Pose::Identity();  ///< part carried: the same, with the part
  Pose T_base_tcp = Pose::Identity();      ///< part carried: the fixed torch
  Pose T_base_root = Pose::Identity();     ///< frame that the positioner's first joint starts from
  Pose T_base_table = Pose::Identity();    ///< the positioner's table with all its joints at 0
  /// Robot configuration at the first move, per FANUC ("NUT": no-flip/flip, up/down, toward/back).
  std::string configuration = "NUT";
};

/// The process that a program was planned with.
struct ProcessFacts {
  double wireDiameter = 0.0;  ///< mm; 0: not known
  double wireSpeed = 0.0;     ///< mm/s
  int job = 1;
};

/// A place in a long bead where a program may be cut: the torch leaves the bead for a safe point
/// and comes back from there.
struct Lift {
  std::size_t instruction = 0;  ///< index of the move that ends at the place
  Target above;                 ///< the safe point, along the tool axis
  double speed = 0.0;           ///< of the moves between place and safe point, mm/s
  double speedRatio = 0.1;      ///< of the joint move to the safe point
};

struct Program {
  std::string name;  ///< operation id
  std::string projectName;
  CellFacts cell;
  std::vector<Instruction> instructions;
  ProcessFacts process = {};
  std::vector<Lift> lifts = {};  ///< in the order of the instructions
};

}  // namespace wcam::program
