// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/from_motion.hpp"

#include "wcam/cell/controller.hpp"
#include "wcam/cell/inverse.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/unwrap.hpp"
#include "wcam/program/wire.hpp"

#include <optional>

namespace wcam::program {

namespace {

/// Sine of the angle to a singularity within which both configurations beside it are the same
/// posture: below what any controller resolves.
constexpr double kSamePosture = 1e-6;
/// The same of the wrist centre beside axis 1, mm.
constexpr double kOnAxisOne = 1e-3;

/// Configuration of an arm along a path: where two of them are the same posture, the one before
/// stays, since a controller refuses a change in a linear move.
class Configurations {
public:
  explicit Configurations(const cell::Cell& cell) : cell_(cell) {}

  /// "NUT" of these joints; empty for a robot without configurations.
  std::string of(const JointVector& joints) {
    if (!cell_.arm) {
      return {};
    }
    cell::Branch found = cell::branchOf(*cell_.arm, joints.data());
    if (before_) {
      const cell::SingularityMeasures near = cell_.inverse->measures(joints.data());
      found.flipped = near.wristSine < kSamePosture ? before_->flipped : found.flipped;
      found.elbowDown = near.elbowSine < kSamePosture ? before_->elbowDown : found.elbowDown;
      found.backwards = near.axisDistance < kOnAxisOne ? before_->backwards : found.backwards;
    }
    before_ = found;
    return found.name();
  }

private:
  const cell::Cell& cell_;
  std::optional<cell::Branch> before_;
};

CellFacts factsOf(const cell::Cell& cell) {
  CellFacts facts;
  facts.cellName = cell.name;
  facts.robotName = cell.robotName;
  facts.torchName = cell.torchName;
  facts.controller = cell::controllerOf(cell.source);
  facts.robotJoints = cell.robotJoints();
  facts.positionerJoints = cell.positionerJoints();
  facts.partCarried = cell.partCarried();
  for (int j = 0; j < cell.jointCount(); ++j) {
    facts.jointNames.push_back(cell.joint(j).name);
    facts.linearJoint.push_back(cell.joint(j).prismatic());
    facts.jointSpeeds.push_back(cell.joint(j).maxSpeed);
  }
  if (cell.partCarried()) {
    facts.T_flange_table = cell.T_flange_table;
    facts.T_base_tcp = cell.T_base_tcp;
  } else {
    facts.T_flange_tcp = cell.T_flange_tcp;
    facts.T_base_root = cell.positioner.T_root_first;
    facts.T_base_table = cell::T_base_table(cell, JointVector::Zero(cell.jointCount()));
  }
  return facts;
}

/// Emits instructions and keeps track of what is open.
class Builder {
public:
  Builder(Program& program, const cell::Cell& cell, const ArcSettings& arc)
      : program_(program), cell_(cell), arc_(arc), configurations_(cell) {}

  void add(const motion::Waypoint& point, const motion::Waypoint* next) {
    const Origin origin{point.layer, point.bead, point.point};
    if (point.layer != layer_) {
      endBead();
      endLayer();
      if (point.layer >= 0) {
        layer_ = point.layer;
        put(LayerBegin{layer_}, {layer_, -1, -1});
      }
    }
    const bool arcAfter = next != nullptr && next->arc;
    if (!arcOn_ && arcAfter) {
      bead_ = point.bead;
      put(BeadBegin{layer_, bead_}, {layer_, bead_, -1});
    }
    move(point, origin, point.arc != arcAfter || point.pause > 0.0);
    if (arcOn_ && arcAfter) {
      inBead(point);
    }
    if (point.pause > 0.0) {
      put(Wait{point.pause}, origin);
    }
    if (arcAfter && wireSpeed_ != next->wireSpeed) {
      // Before the arc, and within a bead where the feed changes.
      wireSpeed_ = next->wireSpeed;
      put(SetProcess{wireSpeed_}, origin);
    }
    if (!arcOn_ && arcAfter) {
      put(ArcOn{arc_.job}, origin);
      arcOn_ = true;
    } else if (arcOn_ && !arcAfter) {
      beadEnds();
      put(ArcOff{arc_.craterTime}, origin);
      arcOn_ = false;
      endBead();
    }
  }

  void finish() {
    endBead();
    endLayer();
  }

private:
  void put(Action action, const Origin& origin) {
    program_.instructions.push_back({std::move(action), origin});
  }

  void endBead() {
    if (bead_ >= 0) {
      put(BeadEnd{layer_, bead_}, {layer_, bead_, -1});
      bead_ = -1;
    }
  }

  void endLayer() {
    if (layer_ >= 0) {
      put(LayerEnd{layer_}, {layer_, -1, -1});
      layer_ = -1;
    }
  }

  /// Target of joint values, without a configuration.
  [[nodiscard]] Target targetOf(const JointVector& joints) const {
    Target target;
    target.joints = joints;
    target.T_base_tcp = cell::T_base_tcp(cell_, joints);
    target.T_table_tcp = cell::T_base_table(cell_, joints).inverse() * target.T_base_tcp;
    return target;
  }

  /// Remembers a place for a cut at regular intervals.
  void inBead(const motion::Waypoint& point) {
    constexpr std::size_t kInterval = 100;
    if (++inBead_ % kInterval == 0) {
      if (auto above = liftedFrom(point.joints)) {
        lifts_.push_back({program_.instructions.size() - 1, std::move(*above), arc_.liftSpeed,
                          arc_.jointSpeedRatio});
      }
    }
  }

  /// Short beads are never cut.
  void beadEnds() {
    constexpr std::size_t kLongBead = 1000;
    if (inBead_ > kLongBead) {
      program_.lifts.insert(program_.lifts.end(), lifts_.begin(), lifts_.end());
    }
    lifts_.clear();
    inBead_ = 0;
  }

  /// The same posture with the torch lifted off along its axis; none where the robot cannot.
  [[nodiscard]] std::optional<Target> liftedFrom(const JointVector& joints) const {
    const Pose T_table_tcp =
        cell::T_base_table(cell_, joints).inverse() * cell::T_base_tcp(cell_, joints);
    const Pose lifted = T_table_tcp * Pose(Eigen::Translation3d(0.0, 0.0, arc_.liftHeight));
    const Pose T_base_flange =
        cell_.partCarried()
            ? Pose(cell_.T_base_tcp * lifted.inverse() * cell_.T_flange_table.inverse())
            : Pose(cell::T_base_table(cell_, joints) * lifted * cell_.T_flange_tcp.inverse());
    const cell::InverseSolution found =
        cell_.inverse->solve(T_base_flange, cell_.inverse->branchOf(joints.data()), joints.data());
    if (!found.reachable) {
      return std::nullopt;
    }
    JointVector above = joints;
    for (int j = 0; j < cell_.robotJoints(); ++j) {
      above(j) = cell::turnInLimits(cell_.joint(j), found.joints(j), joints(j));
      if (cell::limitExcess(cell_.joint(j), above(j)) > 0.0) {
        return std::nullopt;
      }
    }
    return targetOf(above);
  }

  void move(const motion::Waypoint& point, const Origin& origin, bool stop) {
    Target target = targetOf(point.joints);
    const std::string configuration = configurations_.of(point.joints);
    if (configuration_.empty() && !configuration.empty()) {
      program_.cell.configuration = configuration;  // the first move
    } else if (configuration != configuration_) {
      target.configuration = configuration;
    }
    configuration_ = configuration;
    if (point.kind == motion::MoveKind::Joint) {
      put(MoveJoint{target, arc_.jointSpeedRatio, stop}, origin);
    } else {
      put(MoveLinear{target, point.speed, stop}, origin);
    }
  }

  Program& program_;
  const cell::Cell& cell_;
  ArcSettings arc_;
  Configurations configurations_;
  std::string configuration_;  ///< of the target before
  int layer_ = -1;
  int bead_ = -1;
  bool arcOn_ = false;
  double wireSpeed_ = -1.0;
  std::size_t inBead_ = 0;   ///< moves of the open bead so far
  std::vector<Lift> lifts_;  ///< of the open bead
};

}  // namespace

Program programFromMotion(const motion::PlannedMotion& planned,
                          const cell::Cell& cell,
                          const ArcSettings& arc,
                          const std::string& operation,
                          const std::string& projectName,
                          const JobContext& context) {
  Program program;
  program.name = operation;
  program.projectName = projectName;
  program.cell = factsOf(cell);
  program.process = {arc.wireDiameter, arc.wireSpeed, arc.job};
  const motion::Motion& motion = planned.motion;
  // Marks and arcs are few against the moves; growing by halves would take the memory twice.
  program.instructions.reserve(motion.waypoints.size() + motion.waypoints.size() / 8);
  Builder builder(program, cell, arc);
  constexpr std::size_t kCheckEvery = 4096;
  for (std::size_t i = 0; i < motion.waypoints.size(); ++i) {
    if (i % kCheckEvery == 0) {
      context.check();
    }
    builder.add(motion.waypoints[i],
                i + 1 < motion.waypoints.size() ? &motion.waypoints[i + 1] : nullptr);
  }
  builder.finish();
  // What the whole program is welded with, where edits have changed it everywhere.
  if (const WireSpeeds speeds = wireSpeeds(program); speeds.changes == 0 && speeds.greatest > 0.0) {
    program.process.wireSpeed = speeds.greatest;
  }
  return program;
}

}  // namespace wcam::program
