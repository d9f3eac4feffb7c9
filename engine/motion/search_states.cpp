// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search_states.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/cell/unwrap.hpp"

#include "vertical_tolerance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace wcam::motion::detail {

namespace {

constexpr double kTurn = 2.0 * kPi;
constexpr double kTorchStep = kTurn / kTorchSamples;
constexpr double kTableStep = kTurn / kTableSamples;
/// A rung at the latest after this bend of the path, the tool axis or the positioner's reference.
/// Half a torch sample: between rungs the samples then follow by at most one step.
constexpr double kBend = 0.5 * kTorchStep;
constexpr int kMaxCoarsening = 8;
/// Way between rungs at most where the robot is no arm, mm.
constexpr double kLongest = 50.0;

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double referenceStep(const Positioning& aligned, std::size_t a, std::size_t b) {
  return std::max(std::abs(aligned.joints[a][0] - aligned.joints[b][0]),
                  std::abs(aligned.joints[a][1] - aligned.joints[b][1]));
}

/// Rungs of a segment with a given bend; `longest` bounds the way between rungs.
void addRungs(const Task& task,
              const Positioning& aligned,
              std::size_t index,
              double bend,
              double longest,
              std::vector<Rung>& rungs) {
  const Segment& segment = task.runs.segments[index];
  std::size_t last = segment.first;
  double way = 0.0;
  double time = 0.0;
  for (std::size_t i = segment.first; i <= segment.last; ++i) {
    const Target& target = task.targets[i];
    const bool first = i == segment.first;
    if (!first) {
      const double step = (target.p - task.targets[i - 1].p).norm();
      way += step;
      time += target.waypoint.speed > 0.0 ? step / target.waypoint.speed : 0.0;
    }
    bool keep = first || i == segment.last || way >= longest;
    if (!keep) {
      // Looked at with the next target, so that the far side of a corner or jump is kept too.
      const std::size_t next = i + 1;
      keep = angleBetween(target.along, task.targets[last].along) >= bend ||
             angleBetween(target.axis, task.targets[last].axis) >= bend ||
             referenceStep(aligned, i, last) >= bend ||
             angleBetween(target.along, task.targets[next].along) >= bend ||
             referenceStep(aligned, i, next) >= bend;
    }
    if (keep) {
      Rung rung;
      rung.target = i;
      rung.segment = index;
      rung.steps = first ? 1 : i - last;
      rung.time = time;
      rung.firstOfSegment = first;
      rung.firstOfRun = first && (index == 0 || task.runs.segments[index - 1].run != segment.run);
      rungs.push_back(rung);
      last = i;
      way = 0.0;
      time = 0.0;
    }
  }
}

}  // namespace

std::vector<Rung> chooseRungs(const Task& task, std::size_t family, std::size_t most) {
  std::vector<Rung> rungs;
  double bend = kBend;
  // A straight line needs few states; a run of 1/20 of the reach moves the joints by a few degrees.
  double longest = task.cell.arm ? cell::armReach(*task.cell.arm) / 40.0 : kLongest;
  for (int k = 0; k < kMaxCoarsening; ++k) {
    rungs.clear();
    for (std::size_t s = 0; s < task.runs.segments.size(); ++s) {
      addRungs(task, task.references[family], s, bend, longest, rungs);
    }
    if (rungs.size() <= most) {
      break;
    }
    bend *= 1.5;
    longest *= 1.5;
  }
  return rungs;
}

StateBuilder::StateBuilder(const Task& task, const SearchFrame& frame)
    : task_(task),
      frame_(frame),
      model_(task.cell),
      hasTable_(!task.cell.partCarried() && task.cell.positionerJoints() > 0) {}

double StateBuilder::tableStep() const {
  return kTableStep;
}

FreeChoice StateBuilder::choice(std::size_t target, double tableOffset, double torchSample) const {
  FreeChoice choice;
  choice.torchRotation = frame_.gauge[target] + torchSample * kTorchStep;
  choice.lead = frame_.lead;
  choice.lateral = frame_.lateral;
  choice.positioner = task_.references[frame_.family].joints[target];
  if (hasTable_) {
    choice.positioner[static_cast<std::size_t>(task_.cell.positionerJoints() - 1)] += tableOffset;
  }
  return choice;
}

/// Table samples that keep the build direction within the tolerance, and the reference itself.
void StateBuilder::chooseTables(const Rung& rung, RungStates& states) const {
  states.tables.clear();
  states.tableValues.clear();
  const Positioning& aligned = task_.references[frame_.family];
  const auto last = static_cast<std::size_t>(std::max(task_.cell.positionerJoints() - 1, 0));
  const double reference = aligned.joints[rung.target][last];
  const double allowed = allowedVerticalError(task_.params, aligned.residual[rung.target]);
  for (int k = -kTableSamples / 2; k < kTableSamples / 2; ++k) {
    const double value = reference + k * kTableStep;
    if (k != 0) {
      if (!hasTable_ || !frame_.moveTable ||
          cell::limitExcess(task_.cell.joint(task_.cell.jointCount() - 1), value) > 0.0) {
        continue;
      }
      PositionerValues values = aligned.joints[rung.target];
      values[last] = value;
      if (verticalError(task_.cell, task_.targets[rung.target].up, values) > allowed) {
        continue;
      }
    }
    states.tables.push_back(k);
    states.tableValues.push_back(value);
  }
}

void StateBuilder::build(const Rung& rung, RungStates& states) const {
  chooseTables(rung, states);
  const std::size_t tables = states.tables.size();
  for (int r = 0; r < kSearchRows; ++r) {
    const bool used = r < 6 ? r < task_.cell.robotJoints()
                            : task_.cell.arm && task_.params.cableLimit.value() > 0.0;
    states.rows[r].resize(used ? tables * 2 * kLanes : 0);
  }
  states.cost.assign(tables * kLanes, 0.0F);
  solve(rung, states);
  for (std::size_t table = 0; table < tables; ++table) {
    addCosts(rung, table, states);
  }
  addTravel(rung, states);
}

namespace {

/// Cosine and sine of each torch sample.
std::vector<geometry::Vec2> sampleTurns() {
  std::vector<geometry::Vec2> turns;
  for (int k = 0; k < kTorchSamples; ++k) {
    turns.emplace_back(std::cos(k * kTorchStep), std::sin(k * kTorchStep));
  }
  return turns;
}

}  // namespace

/// Inverse kinematics of all states in blocks.
void StateBuilder::solve(const Rung& rung, RungStates& states) const {
  using cell::Branch;
  const cell::Cell& cell = task_.cell;
  if (!cell.arm) {
    solveEach(rung, states);
    return;
  }
  const Target& target = task_.targets[rung.target];
  // About 80 kB that would not fit every stack.
  thread_local const auto poses = std::make_unique<cell::PoseBlock>();
  thread_local const auto joints = std::make_unique<cell::JointBlock>();
  const std::size_t total = states.tables.size() * kTorchSamples;
  const Pose T_tcp_flange = cell.T_flange_tcp.inverse();
  Pose fan = Pose::Identity();
  Pose fanTool = Pose::Identity();
  static const std::vector<geometry::Vec2> turns = sampleTurns();
  for (std::size_t begin = 0; begin < total; begin += cell::PoseBlock::kSize) {
    const int count =
        static_cast<int>(std::min<std::size_t>(cell::PoseBlock::kSize, total - begin));
    for (int n = 0; n < count; ++n) {
      const std::size_t pose = begin + static_cast<std::size_t>(n);
      const std::size_t table = pose / kTorchSamples;
      const std::size_t sample = pose % kTorchSamples;
      if (sample == 0 || n == 0 || cell.partCarried()) {
        Pose T_part_tcp;
        const FreeChoice own = choice(rung.target, states.tables[table] * kTableStep,
                                      cell.partCarried() ? static_cast<double>(sample) : 0.0);
        fan = flangePose(cell, target, own, &T_part_tcp);
        // Torch carried: the other samples turn it about the tool axis.
        fanTool = fan * cell.T_flange_tcp;
      }
      if (cell.partCarried()) {
        poses->set(n, fan);
      } else {
        Eigen::Matrix3d turned;
        turned.col(0) = turns[sample].x() * fanTool.linear().col(0) +
                        turns[sample].y() * fanTool.linear().col(1);
        turned.col(1) = turns[sample].x() * fanTool.linear().col(1) -
                        turns[sample].y() * fanTool.linear().col(0);
        turned.col(2) = fanTool.linear().col(2);
        Pose flange = Pose::Identity();
        flange.linear() = turned * T_tcp_flange.linear();
        flange.translation() = fanTool.translation() + turned * T_tcp_flange.translation();
        poses->set(n, flange);
      }
    }
    cell::inverseBlock(*cell.arm, *poses, count, *joints);
    // Branch and joint outside: each block's row is read from its beginning to its end.
    std::array<std::size_t, cell::PoseBlock::kSize> at{};
    for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n) {
      const std::size_t pose = begin + n;
      at[n] = pose / kTorchSamples * 2 * kLanes + pose % kTorchSamples * Branch::kCount;
    }
    const float unreachable = SearchPenalty::kUnreachable * static_cast<float>(rung.steps);
    for (std::size_t b = 0; b < Branch::kCount; ++b) {
      for (std::size_t j = 0; j < 6; ++j) {
        float* const row = states.rows[j].data() + b;
        for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n) {
          row[at[n]] = static_cast<float>(joints->joints[b][j][n]);
        }
      }
      float* const cost = states.cost.data() + begin * Branch::kCount + b;
      for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n) {
        cost[n * Branch::kCount] += joints->reachable[b & 1U][n] == 0.0 ? unreachable : 0.0F;
      }
    }
  }
}

/// The same of robots that are no arms, pose by pose; branches and rotations that the robot does
/// not have are never taken. Their singularity margins are looked at here.
void StateBuilder::solveEach(const Rung& rung, RungStates& states) const {
  using cell::InverseKinematics;
  const cell::Cell& cell = task_.cell;
  const InverseKinematics& inverse = *cell.inverse;
  const auto branches = static_cast<std::size_t>(inverse.branches());
  const double margin = std::sin(task_.params.wristMargin.value());
  const auto steps = static_cast<float>(rung.steps);
  std::array<cell::InverseSolution, InverseKinematics::kMostBranches> solutions;
  for (std::size_t pose = 0; pose < states.tables.size() * kTorchSamples; ++pose) {
    const std::size_t table = pose / kTorchSamples;
    const std::size_t sample = pose % kTorchSamples;
    const bool taken = sample == 0 || inverse.freeRotation();
    if (taken) {
      Pose T_part_tcp;
      const FreeChoice own =
          choice(rung.target, states.tables[table] * kTableStep, static_cast<double>(sample));
      inverse.solveAll(flangePose(cell, task_.targets[rung.target], own, &T_part_tcp), solutions);
    }
    for (std::size_t b = 0; b < InverseKinematics::kMostBranches; ++b) {
      const cell::InverseSolution& solution = solutions[b < branches ? b : 0];
      const std::size_t at = table * 2 * kLanes + sample * InverseKinematics::kMostBranches + b;
      float& cost = states.cost[pose * InverseKinematics::kMostBranches + b];
      for (int j = 0; j < cell.robotJoints(); ++j) {
        states.rows[j][at] = static_cast<float>(solution.joints(j));
      }
      cost += taken && b < branches ? 0.0F : SearchPenalty::kNever;
      cost += solution.reachable ? 0.0F : SearchPenalty::kUnreachable * steps;
      cost +=
          marginSine(cell, solution.wristSine) < margin ? SearchPenalty::kSingular * steps : 0.0F;
    }
  }
}

namespace {

/// A full turn of the sum's joints is a full turn of the sum.
bool wholeTurns(const CellModel& model, const cell::JointSum& sum) {
  for (std::size_t j = 0; j < sum.factors.size(); ++j) {
    const double factor = sum.factors[j];
    if (factor != 0.0 && (std::abs(factor) != 1.0 || !model.periodic(static_cast<int>(j)))) {
      return false;
    }
  }
  return true;
}

}  // namespace

/// Limits, singularity margins, twist and objectives of the states of one table sample; the second
/// half of each row.
void StateBuilder::addCosts(const Rung& rung, std::size_t table, RungStates& states) const {
  const cell::Cell& cell = task_.cell;
  const MotionParams& params = task_.params;
  float* cost = states.cost.data() + table * kLanes;
  const std::size_t base = table * 2 * kLanes;
  const auto weight = static_cast<float>(params.weightLimits * static_cast<double>(rung.steps) /
                                         static_cast<double>(frame_.points));
  const auto steps = static_cast<float>(rung.steps);
  for (int j = 0; j < cell.robotJoints(); ++j) {
    const cell::Joint& joint = cell.joint(j);
    if (joint.endless) {
      continue;
    }
    RangeCost range;
    range.middle = static_cast<float>(0.5 * (joint.min + joint.max));
    range.half = static_cast<float>(0.5 * (joint.max - joint.min));
    range.weight = weight;
    range.outside = steps * SearchPenalty::kOutside;
    range.beyond = steps * SearchPenalty::kBeyond * static_cast<float>(model_.asAngle(j, 1.0));
    range.wraps = model_.periodic(j);
    addRangeCost(states.rows[j].data() + base, range, kLanes, cost);
  }
  if (cell.arm) {
    addArmCosts(rung, table, states);
  }
  addSumCosts(rung, table, states);
  PositionerValues values = task_.references[frame_.family].joints[rung.target];
  if (hasTable_) {
    values[static_cast<std::size_t>(cell.positionerJoints() - 1)] = states.tableValues[table];
  }
  double shared = 0.0;
  if (params.weightGravity > 0.0) {
    const double angle = radToDeg(verticalError(cell, task_.targets[rung.target].up, values));
    shared += params.weightGravity * angle * angle * static_cast<double>(rung.steps) /
              static_cast<double>(frame_.points);
  }
  float branches[cell::Branch::kCount];
  for (int k = 0; k < cell::Branch::kCount; ++k) {
    const cell::Branch branch = cell::Branch::fromIndex(k);
    const int unusual = cell.arm ? (branch.elbowDown ? 1 : 0) + (branch.backwards ? 2 : 0) : 0;
    branches[k] = static_cast<float>(shared) +
                  (mayUse(cell, params, k) ? 0.0F : SearchPenalty::kNever) +
                  (rung.firstOfRun ? SearchPenalty::kUnusual * static_cast<float>(unusual) : 0.0F);
  }
  addBranchCost(branches, kLanes, cost);
  for (auto& row : states.rows) {
    if (!row.empty()) {
      std::copy_n(row.data() + base, kLanes, row.data() + base + kLanes);
    }
  }
}

/// Sums of joints that the cell limits, of the turns that lie best.
void StateBuilder::addSumCosts(const Rung& rung, std::size_t table, RungStates& states) const {
  float* cost = states.cost.data() + table * kLanes;
  const std::size_t base = table * 2 * kLanes;
  const auto steps = static_cast<float>(rung.steps);
  for (const cell::JointSum& sum : task_.cell.sums) {
    std::array<float, kLanes> values{};
    for (int j = 0; j < task_.cell.robotJoints(); ++j) {
      const auto factor = static_cast<float>(sum.factors[static_cast<std::size_t>(j)]);
      for (std::size_t n = 0; n < kLanes && factor != 0.0F; ++n) {
        values[n] += factor * states.rows[j][base + n];
      }
    }
    RangeCost range;
    range.middle = static_cast<float>(0.5 * (sum.min + sum.max));
    range.half = static_cast<float>(0.5 * (sum.max - sum.min));
    range.weight = 0.0F;
    range.outside = steps * SearchPenalty::kOutside;
    range.beyond = steps * SearchPenalty::kBeyond *
                   static_cast<float>(model_.asAngle(CellModel::firstOf(sum), 1.0));
    range.wraps = wholeTurns(model_, sum);
    addRangeCost(values.data(), range, kLanes, cost);
  }
}

/// Singularity margins and cable twist of an arm.
void StateBuilder::addArmCosts(const Rung& rung, std::size_t table, RungStates& states) const {
  const cell::Arm& arm = *task_.cell.arm;
  const MotionParams& params = task_.params;
  float* cost = states.cost.data() + table * kLanes;
  const std::size_t base = table * 2 * kLanes;
  const auto steps = static_cast<float>(rung.steps);
  // Wrist and elbow bends are linear in the canonical angles.
  const float* row2 = states.rows[1].data() + base;
  const float* row3 = states.rows[2].data() + base;
  const float* row5 = states.rows[4].data() + base;
  const float singular = steps * SearchPenalty::kSingular;
  addFoldCost(row5, row5,
              {static_cast<float>(arm.gain(4, 4)), 0.0F, static_cast<float>(arm.offset(4)),
               static_cast<float>(params.wristMargin.value()), singular},
              kLanes, cost);
  // Stretched where −d4·cos c3 + r4·sin c3 = 0.
  addFoldCost(row2, row3,
              {static_cast<float>(arm.gain(2, 1)), static_cast<float>(arm.gain(2, 2)),
               static_cast<float>(arm.offset(2) - std::atan2(arm.d4, arm.r4)),
               static_cast<float>(params.elbowMargin.value()), singular},
              kLanes, cost);
  const double limit = params.cableLimit.value();
  if (limit > 0.0) {
    const float sign = arm.gain(3, 3) * arm.gain(5, 5) < 0.0 ? -1.0F : 1.0F;
    addTwistCost(states.rows[3].data() + base, states.rows[5].data() + base,
                 {sign, static_cast<float>(params.cableZero.value()), static_cast<float>(limit),
                  steps * SearchPenalty::kTwist},
                 kLanes, states.rows[6].data() + base, cost);
  }
}

/// Reach of the travel moves beside a bead's end, which take the same free choice.
void StateBuilder::addTravel(const Rung& rung, RungStates& states) const {
  const Segment& segment = task_.runs.segments[rung.segment];
  std::vector<std::size_t> travel;
  if (rung.target == segment.first) {
    for (std::size_t i = segment.begin; i < segment.first; ++i) {
      travel.push_back(i);
    }
  }
  if (rung.target == segment.last) {
    for (std::size_t i = segment.last + 1; i < segment.end; ++i) {
      travel.push_back(i);
    }
  }
  if (travel.empty()) {
    return;
  }
  Rung beside = rung;
  beside.steps = 1;
  beside.firstOfRun = false;
  RungStates own;
  own.tables = states.tables;
  own.tableValues = states.tableValues;
  for (const std::size_t i : travel) {
    beside.target = i;
    for (int r = 0; r < kSearchRows; ++r) {
      own.rows[r].resize(states.rows[r].size());
    }
    own.cost.assign(states.cost.size(), 0.0F);
    solve(beside, own);
    for (std::size_t table = 0; table < own.tables.size(); ++table) {
      addCosts(beside, table, own);
    }
    for (std::size_t n = 0; n < own.cost.size(); ++n) {
      states.cost[n] += own.cost[n];
    }
  }
}

}  // namespace wcam::motion::detail
