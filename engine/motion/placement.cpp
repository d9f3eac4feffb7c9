// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/placement.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/positioner.hpp"
#include "wcam/cell/unwrap.hpp"

#include "cell_model.hpp"
#include "plan_detail.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::motion {

namespace {

using cell::Cell;
using cell::JointVector;
using geometry::Pose;
using geometry::Vec3;
using toolpath::PathPoint;

const double kComfortAngle = degToRad(30.0);
constexpr double kComfortAxis = 200.0;  // mm
constexpr double kComfortDexterity = 0.3;
constexpr double kComfortClearance = 20.0;  // mm
/// Places per question for a cancel.
constexpr std::size_t kGrain = 1;
/// Choices of configuration and rotation whose collisions are looked at, the best first.
constexpr std::size_t kCollisionTries = 4;

/// A point of the path with what is deposited before it.
struct Sample {
  const PathPoint* point;
  std::size_t number;
};

std::vector<Sample> samplesOf(const toolpath::Toolpath& path, std::size_t wanted) {
  std::vector<Sample> all;
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::Bead& bead : layer.beads) {
      for (const PathPoint& point : bead.points) {
        all.push_back({&point, all.size()});
      }
    }
  }
  if (all.size() <= wanted) {
    return all;
  }
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < wanted; ++k) {
    samples.push_back(all[k * (all.size() - 1) / (wanted - 1)]);
  }
  return samples;
}

/// Positioner values of all samples, following one solution.
std::vector<std::array<double, 2>> positionerCourse(const Cell& cell,
                                                    const std::vector<Sample>& samples,
                                                    std::size_t family) {
  std::vector<std::array<double, 2>> course(samples.size());
  if (cell.partCarried()) {
    return course;
  }
  std::array<double, 2> previous{};
  const JointVector neutral = cell::neutralJoints(cell);
  for (int j = 0; j < cell.positionerJoints(); ++j) {
    previous[static_cast<std::size_t>(j)] = neutral(cell.robotJoints() + j);
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const cell::PositionerResult result =
        cell::alignToVertical(cell, samples[i].point->up, previous);
    std::array<std::array<double, 2>, 2> solutions{};
    std::array<double, 2> cost{};
    for (std::size_t k = 0; k < 2; ++k) {
      solutions[k] = result.solutions[k].joints;
      for (int j = 0; j < cell.positionerJoints(); ++j) {
        const int joint = cell.robotJoints() + j;
        double& value = solutions[k][static_cast<std::size_t>(j)];
        if (cell::periodicJoint(cell, joint)) {
          value =
              cell::turnInLimits(cell.joint(joint), value, previous[static_cast<std::size_t>(j)]);
        }
        cost[k] += std::abs(value - previous[static_cast<std::size_t>(j)]) +
                   1e3 * cell::limitExcess(cell.joint(joint), value);
      }
    }
    std::size_t chosen = cost[0] <= cost[1] ? 0 : 1;
    if (i == 0) {
      chosen = result.count == 2 ? family : 0;
    }
    previous = course[i] = solutions[chosen];
  }
  return course;
}

Pose flangeAt(const Cell& cell,
              const PathPoint& point,
              const std::array<double, 2>& positioner,
              double rotation) {
  if (cell.partCarried()) {
    Pose T_base_part = Pose::Identity();
    T_base_part.linear() = cell.T_base_tcp.linear() * cell::axisToVertical(point.axis, rotation);
    T_base_part.translation() = cell.T_base_tcp.translation() - T_base_part.linear() * point.p;
    return T_base_part * (cell.T_flange_table * cell.T_table_part).inverse();
  }
  const Pose T_base_part = cell::chainPose(cell.positioner, positioner.data()) * cell.T_table_part;
  Pose tcp = Pose::Identity();
  tcp.linear() = cell::frameWithZ(T_base_part.linear() * point.axis, rotation);
  tcp.translation() = T_base_part * point.p;
  return tcp * cell.T_flange_tcp.inverse();
}

double comfort(double margin, double comfortable) {
  return std::min(margin / comfortable, 1.0);
}

/// A choice of configuration and rotation at a place, over all samples.
struct Choice {
  PartPlace place;
  std::vector<JointVector> joints;
};

/// Judges one place.
class Judge {
public:
  Judge(const Cell& cell,
        const std::vector<Sample>& samples,
        const MotionParams& params,
        const PlacementSearch& search)
      : cell_(cell), samples_(samples), params_(params), search_(search) {}

  PartPlace judge(PartPlace place, const collision::CellCollision* collision) const {
    Cell cell = cell_;
    cell.T_table_part = cell_.T_table_part * place.pose();
    std::vector<Choice> choices;
    const std::size_t families = !cell.partCarried() && cell.positionerJoints() == 2 ? 2 : 1;
    for (std::size_t family = 0; family < families; ++family) {
      const auto course = positionerCourse(cell, samples_, family);
      addChoices(cell, course, place, choices);
    }
    std::stable_sort(choices.begin(), choices.end(),
                     [](const Choice& a, const Choice& b) { return a.place.betterThan(b.place); });
    if (choices.size() > kCollisionTries) {
      choices.resize(kCollisionTries);
    }
    std::unique_ptr<collision::CellCollision> model;
    if (collision != nullptr) {
      model = collision->moved(cell.T_table_part);
    }
    PartPlace best;
    for (std::size_t k = 0; k < choices.size(); ++k) {
      finish(cell, model.get(), choices[k]);
      if (k == 0 || choices[k].place.betterThan(best)) {
        best = choices[k].place;
      }
      if (best.failing == 0 && best.score >= 1.0) {
        break;
      }
    }
    return best;
  }

private:
  void addChoices(const Cell& cell,
                  const std::vector<std::array<double, 2>>& course,
                  const PartPlace& place,
                  std::vector<Choice>& choices) const {
    const cell::InverseKinematics& inverse = *cell.inverse;
    const auto branches = static_cast<std::size_t>(inverse.branches());
    const int rotations =
        inverse.freeRotation()
            ? std::max(1, static_cast<int>(std::lround(2 * kPi / search_.rotationStep)))
            : 1;
    for (int r = 0; r < rotations; ++r) {
      const double rotation =
          cell::wrapAngle(params_.torchRotation.value() + r * 2 * kPi / rotations);
      std::array<Choice, cell::InverseKinematics::kMostBranches> of;
      std::array<cell::InverseSolution, cell::InverseKinematics::kMostBranches> result;
      for (std::size_t b = 0; b < branches; ++b) {
        Choice& choice = of[b];
        choice.place = place;
        choice.place.branch = inverse.branchName(static_cast<int>(b));
        choice.place.torchRotation = rotation;
        choice.place.limitMargin = choice.place.wristBend = choice.place.elbowBend =
            choice.place.axisDistance = std::numeric_limits<double>::infinity();
      }
      for (std::size_t i = 0; i < samples_.size(); ++i) {
        const Pose flange = flangeAt(cell, *samples_[i].point, course[i], rotation);
        if (detail::isFollowed(cell)) {
          for (std::size_t b = 0; b < branches; ++b) {
            const bool first = of[b].joints.empty();
            result[b] = inverse.solve(flange, static_cast<int>(b),
                                      first ? nullptr : of[b].joints.back().data());
          }
        } else {
          inverse.solveAll(flange, result);
        }
        for (std::size_t b = 0; b < branches; ++b) {
          addSample(cell, result[b], course[i], of[b]);
        }
      }
      for (std::size_t b = 0; b < branches; ++b) {
        if (detail::mayUse(cell, params_, static_cast<int>(b))) {
          score(of[b].place);
          choices.push_back(std::move(of[b]));
        }
      }
    }
  }

  void addSample(const Cell& cell,
                 const cell::InverseSolution& solution,
                 const std::array<double, 2>& positioner,
                 Choice& choice) const {
    JointVector q(cell.jointCount());
    double margin = std::numeric_limits<double>::infinity();
    for (int j = 0; j < cell.jointCount(); ++j) {
      const cell::Joint& joint = cell.joint(j);
      q(j) = j < cell.robotJoints() ? solution.joints(j)
                                    : positioner[static_cast<std::size_t>(j - cell.robotJoints())];
      if (cell::periodicJoint(cell, j)) {
        const double near = choice.joints.empty() ? 0.0 : choice.joints.back()(j);
        q(j) = cell::turnInLimits(joint, q(j), near);
      }
      const double own = cell::limitMargin(joint, q(j));
      margin = std::min(margin, joint.prismatic() ? own / detail::kLengthPerRadian : own);
    }
    for (const cell::JointSum& sum : cell.sums) {
      const double excess = detail::sumExcess(sum, q);
      margin = excess > 0.0 ? std::min(margin, -excess) : margin;
    }
    choice.joints.push_back(q);
    PartPlace& place = choice.place;
    const double wrist = std::asin(std::min(detail::marginSine(cell, solution.wristSine), 1.0));
    const double elbow = std::asin(std::min(solution.elbowSine, 1.0));
    const bool good = solution.reachable && margin >= 0.0 && wrist >= params_.wristMargin.value() &&
                      elbow >= params_.elbowMargin.value() &&
                      solution.axisDistance >= params_.shoulderMargin.value();
    place.failing += good ? 0 : 1;
    place.reachMissing = std::max(place.reachMissing, solution.missing);
    place.limitMargin = std::min(place.limitMargin, margin);
    place.wristBend = std::min(place.wristBend, wrist);
    place.elbowBend = std::min(place.elbowBend, elbow);
    place.axisDistance = std::min(place.axisDistance, solution.axisDistance);
  }

  void score(PartPlace& place) const {
    place.score =
        std::min({comfort(place.limitMargin, kComfortAngle),
                  comfort(place.wristBend - params_.wristMargin.value(), kComfortAngle),
                  comfort(place.elbowBend - params_.elbowMargin.value(), kComfortAngle),
                  comfort(place.axisDistance - params_.shoulderMargin.value(), kComfortAxis)});
  }

  /// Dexterity and collisions of a choice.
  void finish(const Cell& cell, const collision::CellCollision* collision, Choice& choice) const {
    PartPlace& place = choice.place;
    place.dexterity = 1.0;
    for (const JointVector& q : choice.joints) {
      place.dexterity = std::min(place.dexterity, cell::dexterity(cell, q));
    }
    place.score =
        std::min(place.score, comfort(place.dexterity - params_.minDexterity, kComfortDexterity));
    if (collision == nullptr) {
      return;
    }
    std::vector<collision::CellState> states;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      states.push_back({choice.joints[i], samples_[i].number});
    }
    std::vector<float> clearance(states.size());
    collision->evaluate(states, clearance);
    place.clearance = std::numeric_limits<double>::infinity();
    const double safety = collision->settings().safetyDistance;
    for (const float value : clearance) {
      // Below the safety distance is a warning, as it is when the motion is checked.
      place.failing += value + safety < 0.0 ? 1 : 0;
      place.clearance = std::min(place.clearance, static_cast<double>(value));
    }
    place.score = std::min(place.score, comfort(place.clearance, kComfortClearance));
  }

  const Cell& cell_;
  const std::vector<Sample>& samples_;
  const MotionParams& params_;
  const PlacementSearch& search_;
};

std::vector<double> axisValues(double range, double step) {
  std::vector<double> values;
  const int n = static_cast<int>(range / step + 1e-9);
  for (int k = -n; k <= n; ++k) {
    values.push_back(k * step);
  }
  return values;
}

void addGrid(const PlacementSearch& search, std::vector<PartPlace>& places) {
  const int turns = std::max(1, static_cast<int>(std::lround(2 * kPi / search.turnStep)));
  for (const double z : axisValues(search.rangeZ, search.step)) {
    for (const double y : axisValues(search.rangeY, search.step)) {
      for (const double x : axisValues(search.rangeX, search.step)) {
        for (int t = 0; t < turns; ++t) {
          PartPlace place;
          place.move = Vec3(x, y, z);
          place.turn = cell::wrapAngle(t * 2 * kPi / turns);
          if (place.move != Vec3::Zero() || t != 0) {
            places.push_back(place);
          }
        }
      }
    }
  }
}

/// Neighbours of a place at half the steps of the level before.
std::vector<PartPlace> neighbours(const PartPlace& centre,
                                  const PlacementSearch& search,
                                  int level) {
  const double scale = std::pow(0.5, level);
  std::vector<PartPlace> places;
  const auto add = [&](const Vec3& move, double turn) {
    PartPlace place;
    place.move = centre.move + move;
    place.turn = cell::wrapAngle(centre.turn + turn);
    const Vec3 range(search.rangeX, search.rangeY, search.rangeZ);
    if ((place.move.cwiseAbs() - range).maxCoeff() <= 1e-9) {
      places.push_back(place);
    }
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double s : {1.0, -1.0}) {
      Vec3 move = Vec3::Zero();
      move(axis) = s * scale * search.step;
      add(move, 0.0);
    }
  }
  for (const double s : {1.0, -1.0}) {
    add(Vec3::Zero(), s * scale * search.turnStep);
  }
  return places;
}

void judgeAll(const Judge& judge,
              const collision::CellCollision* collision,
              std::size_t begin,
              PlacementMap& map,
              const JobContext& context) {
  parallelFor(
      map.places.size() - begin, kGrain,
      [&](std::size_t i) { map.places[begin + i] = judge.judge(map.places[begin + i], collision); },
      context);
  for (std::size_t i = begin; i < map.places.size(); ++i) {
    if (map.places[i].betterThan(map.places[map.best])) {
      map.best = i;
    }
  }
}

}  // namespace

bool PartPlace::betterThan(const PartPlace& other) const {
  return failing != other.failing ? failing < other.failing : score > other.score;
}

Pose PartPlace::pose() const {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix();
  pose.translation() = move;
  return pose;
}

PlacementMap searchPlacement(const toolpath::Toolpath& path,
                             const cell::Cell& cell,
                             const collision::CellCollision* collision,
                             const MotionParams& params,
                             const PlacementSearch& search,
                             const JobContext& context) {
  detail::checkBranch(cell, params, text("cell %1", {cell.name}));
  if (!(search.step > 0.0) || !(search.turnStep > 0.0) || !(search.rotationStep > 0.0) ||
      search.samples < 2) {
    throw Error(ErrorCode::InvalidArgument, "the steps of the search must be greater than 0", {},
                "give a step in mm and a turn step in degrees");
  }
  const std::vector<Sample> samples = samplesOf(path, search.samples);
  PlacementMap map;
  map.places.emplace_back();
  if (samples.empty()) {
    return map;
  }
  const Judge judge(cell, samples, params, search);
  map.places.front() = judge.judge(map.places.front(), collision);
  addGrid(search, map.places);
  judgeAll(judge, collision, 1, map, context);
  context.report(0.8);
  for (int level = 1; level <= search.refinements; ++level) {
    // As long as a step of this size helps.
    for (int step = 0; step < 8; ++step) {
      const std::size_t before = map.best;
      const std::size_t begin = map.places.size();
      for (const PartPlace& place : neighbours(map.places[map.best], search, level)) {
        map.places.push_back(place);
      }
      judgeAll(judge, collision, begin, map, context);
      if (map.best == before) {
        break;
      }
    }
  }
  context.report(1.0);
  return map;
}

}  // namespace wcam::motion
