// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/cell/unwrap.hpp"

#include "cell_model.hpp"
#include "plan_detail.hpp"
#include "vertical_tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

namespace wcam::motion {

namespace {

using detail::ArmState;
using detail::CellModel;

constexpr std::size_t kGrain = 256;
/// Rounding of joint speeds and angles: a value this far beyond its bound is on it (relative, rad).
constexpr double kSlack = 1e-9;
/// Excess of a speed ratio is cut off here, so that one jump does not hide everything else.
constexpr double kWorstSpeed = 10.0;
/// A penetration of this size counts as an excess of 1, mm.
constexpr double kClearanceUnit = 10.0;
constexpr double kMillimetreToMicrometre = 1e3;

/// Sums over a chunk of waypoints.
struct Partial {
  ObjectiveValues sums{};
  std::array<std::size_t, kConstraintCount> broken{};
  double excess = 0.0;
  std::size_t points = 0;  ///< on beads

  double& operator[](Objective o) { return sums[static_cast<std::size_t>(o)]; }

  void breaks(Constraint constraint, double by) {
    ++broken[static_cast<std::size_t>(constraint)];
    excess += by;
  }

  void add(const Partial& other) {
    for (std::size_t k = 0; k < sums.size(); ++k) {
      sums[k] += other.sums[k];
    }
    for (std::size_t k = 0; k < broken.size(); ++k) {
      broken[k] += other.broken[k];
    }
    excess += other.excess;
    points += other.points;
  }
};

bool onBead(const Waypoint& point) {
  return point.point >= 0;
}

bool sameBead(const Waypoint& a, const Waypoint& b) {
  return onBead(a) && onBead(b) && a.layer == b.layer && a.bead == b.bead;
}

class Judge {
public:
  Judge(const Motion& motion, const cell::Cell& cell, const MotionParams& params)
      : points_(motion.waypoints), cell_(cell), params_(params), model_(cell) {
    for (int j = 0; j < cell.jointCount(); ++j) {
      const cell::Joint& joint = cell.joint(j);
      const auto k = static_cast<std::size_t>(j);
      transition_[k] = 1.0 / model_.travelRange(j);
      acceleration_[k] = detail::accelerationScale(joint);
      jerk_[k] = detail::jerkScale(joint);
      const double sigma = model_.resolution(j, params.jointResolution.value());
      variance_[k] = sigma * sigma;
    }
  }

  /// Everything of waypoint i and of the step that ends there.
  void add(std::size_t i, Partial& sums) const {
    const Waypoint& point = points_[i];
    addPosture(point, sums);
    addDirections(point, sums);
    if (i == 0) {
      return;
    }
    const Waypoint& before = points_[i - 1];
    if (!sameBead(point, before)) {
      addTransition(point, before, sums);
      return;
    }
    addStep(point, before, sums);
    if (i + 1 < points_.size() && sameBead(point, points_[i + 1])) {
      addAcceleration(i, sums);
    }
  }

private:
  void addPosture(const Waypoint& point, Partial& sums) const {
    if (!point.reachable) {
      sums.breaks(Constraint::Reach, 1.0);
    }
    double centred = 0.0;
    double beyond = 0.0;
    for (int j = 0; j < cell_.jointCount(); ++j) {
      const cell::Joint& joint = cell_.joint(j);
      if (point.reachable || j >= cell_.robotJoints()) {
        beyond += model_.asAngle(j, cell::limitExcess(joint, point.joints(j)));
      }
      if (!joint.endless) {
        const double r = (2.0 * point.joints(j) - joint.min - joint.max) / (joint.max - joint.min);
        centred += r * r;
      }
    }
    for (const cell::JointSum& sum : cell_.sums) {
      beyond += point.reachable ? sumExcess(sum, point.joints) : 0.0;
    }
    if (beyond > 0.0) {
      sums.breaks(Constraint::Limits, beyond);
    }
    if (!point.reachable) {
      return;
    }
    const ArmState state = model_.armState(point.joints);
    if (onBead(point)) {
      ++sums.points;
      sums[Objective::Limits] += centred;
      sums[Objective::Dexterity] += (1.0 - state.dexterity) * (1.0 - state.dexterity);
      double uncertainty = 0.0;
      for (int j = 0; j < cell_.robotJoints(); ++j) {
        uncertainty +=
            variance_[static_cast<std::size_t>(j)] * state.jacobian.col(j).head<3>().squaredNorm();
      }
      sums[Objective::Uncertainty] +=
          uncertainty * kMillimetreToMicrometre * kMillimetreToMicrometre;
      const double least = params_.minDexterity;
      if (state.dexterity < least) {
        sums.breaks(Constraint::Dexterity, (least - state.dexterity) / least);
      }
    }
    const double shortfall =
        std::max({relativeShortfall(state.wristSine, std::sin(params_.wristMargin.value())),
                  relativeShortfall(state.elbowSine, std::sin(params_.elbowMargin.value())),
                  relativeShortfall(state.axisDistance, params_.shoulderMargin.value())});
    if (shortfall > 0.0) {
      sums.breaks(Constraint::Singularity, shortfall);
    }
    const double limit = params_.cableLimit.value();
    if (limit > 0.0) {
      const double twist =
          std::abs(model_.cableTwist(point.joints, params_.cableZero.value())) - limit;
      if (twist > kSlack) {
        sums.breaks(Constraint::Cable, twist);
      }
    }
  }

  [[nodiscard]] double sumExcess(const cell::JointSum& sum, const cell::JointVector& q) const {
    return model_.asAngle(model_.firstOf(sum), detail::sumExcess(sum, q));
  }

  static double relativeShortfall(double value, double least) {
    return value < least ? (least - value) / least : 0.0;
  }

  void addDirections(const Waypoint& point, Partial& sums) const {
    if (onBead(point) && point.reachable) {
      const double angle = radToDeg(point.verticalError);
      sums[Objective::Gravity] += angle * angle;
    }
    const double leaning =
        point.verticalError - detail::allowedVerticalError(params_, point.leastVerticalError);
    if (leaning > kSlack) {
      sums.breaks(Constraint::Vertical, leaning);
    }
    const double tilt = point.tilt - params_.tiltTolerance.value();
    if (tilt > kSlack) {
      sums.breaks(Constraint::Tilt, tilt);
    }
  }

  void addTransition(const Waypoint& point, const Waypoint& before, Partial& sums) const {
    double sum = 0.0;
    for (int j = 0; j < cell_.jointCount(); ++j) {
      const double step = model_.inUnit(j, point.joints(j) - before.joints(j));
      sum += transition_[static_cast<std::size_t>(j)] * step * step;
    }
    sums[Objective::Transition] += sum;
  }

  /// Time of a step at the wanted speed, s.
  static double wantedTime(const Waypoint& point, const Waypoint& before) {
    const double length = (point.T_part_tcp.translation() - before.T_part_tcp.translation()).norm();
    return point.speed > 0.0 ? length / point.speed : 0.0;
  }

  void addStep(const Waypoint& point, const Waypoint& before, Partial& sums) const {
    const double time = wantedTime(point, before);
    double worst = 0.0;
    double squares = 0.0;
    for (int j = 0; j < cell_.jointCount(); ++j) {
      const double step = point.joints(j) - before.joints(j);
      const double degrees = model_.inUnit(j, step);
      const bool robot = j < cell_.robotJoints();
      if (robot) {
        sums[Objective::Motion] += model_.motionWeight(j) * degrees * degrees;
      } else {
        sums[Objective::Positioner] += degrees * degrees / 360.0;
      }
      if (robot && cell_.joint(j).endless && !cell_.partCarried()) {
        sums[Objective::Winding] += degrees * degrees / 360.0;
      }
      const double allowed = cell_.joint(j).maxSpeed * time + kSlack;
      worst = std::max(worst, std::abs(step) / allowed);
      if (time > 0.0) {
        const double ratio = step / (cell_.joint(j).maxSpeed * time);
        squares += ratio * ratio;
      }
    }
    sums[Objective::Speed] += squares;
    if (worst > 1.0 && point.reachable && before.reachable) {
      // The least loss: what the joints' speeds alone cost (see predictedLoss).
      const double slower = 1.0 - 1.0 / worst;
      sums[Objective::TcpSpeed] += slower * slower;
      if (worst > 1.0 + kSlack) {
        sums.breaks(Constraint::Speed, std::min(worst - 1.0, kWorstSpeed));
      }
    }
  }

  cell::JointVector acceleration(std::size_t i, double h0, double h1) const {
    return 2.0 *
           ((points_[i + 1].joints - points_[i].joints) / h1 -
            (points_[i].joints - points_[i - 1].joints) / h0) /
           (h0 + h1);
  }

  void addAcceleration(std::size_t i, Partial& sums) const {
    const double h0 = wantedTime(points_[i], points_[i - 1]);
    const double h1 = wantedTime(points_[i + 1], points_[i]);
    if (!(h0 > 0.0 && h1 > 0.0)) {
      return;
    }
    const cell::JointVector a = acceleration(i, h0, h1);
    for (int j = 0; j < cell_.jointCount(); ++j) {
      const double ratio = a(j) / acceleration_[static_cast<std::size_t>(j)];
      sums[Objective::Acceleration] += ratio * ratio;
    }
    if (i + 2 >= points_.size() || !sameBead(points_[i], points_[i + 2])) {
      return;
    }
    const double h2 = wantedTime(points_[i + 2], points_[i + 1]);
    if (!(h2 > 0.0)) {
      return;
    }
    const cell::JointVector next = acceleration(i + 1, h1, h2);
    for (int j = 0; j < cell_.jointCount(); ++j) {
      const double jerk = 3.0 * (next(j) - a(j)) / (h0 + h1 + h2);
      const double ratio = jerk / jerk_[static_cast<std::size_t>(j)];
      sums[Objective::Jerk] += ratio * ratio;
    }
  }

  std::span<const Waypoint> points_;
  const cell::Cell& cell_;
  const MotionParams& params_;
  CellModel model_;
  std::array<double, 12> transition_{}, acceleration_{}, jerk_{}, variance_{};
};

void addCollisions(const Motion& motion,
                   const collision::Clearance& clearance,
                   const JobContext& context,
                   Partial& sums) {
  const std::vector<float> distances = detail::clearanceOf(motion, clearance, context);
  for (const float distance : distances) {
    if (distance < 0.0F) {
      sums.breaks(Constraint::Collision, -static_cast<double>(distance) / kClearanceUnit);
    }
  }
}

/// The loss by the prediction of time and speed, accelerations and corners included. Motions that
/// are only compared, and not by this, are not timed for it.
std::optional<double> predictedLoss(const Motion& motion,
                                    const cell::Cell& cell,
                                    const MotionParams& params,
                                    const JobContext& context) {
  if (motion.waypoints.back().time > 0.0) {
    return detail::speedLoss(motion);
  }
  if (!(params.weightTcpSpeed > 0.0)) {
    return std::nullopt;
  }
  Motion timed = motion;
  applyTimeLaw(timed, cell, params, params.jointSpeedRatio, context.withOwnDiagnostics());
  return detail::speedLoss(timed);
}

bool isMean(Objective objective) {
  switch (objective) {
    case Objective::Motion:
    case Objective::Positioner:
    case Objective::Winding:
    case Objective::Transition:
      return false;
    default:
      return true;
  }
}

}  // namespace

namespace detail {

double accelerationScale(const cell::Joint& joint) {
  return std::isfinite(joint.maxAcceleration) ? joint.maxAcceleration : joint.maxSpeed / kRampTime;
}

double jerkScale(const cell::Joint& joint) {
  return std::isfinite(joint.maxJerk) ? joint.maxJerk : accelerationScale(joint) / kRampTime;
}

double sumExcess(const cell::JointSum& sum, const cell::JointVector& q) {
  const double value = sum.value(q);
  const double excess = std::max({sum.min - value, value - sum.max, 0.0});
  return excess <= kSlack ? 0.0 : excess;
}

double speedLoss(const Motion& motion) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < motion.waypoints.size(); ++i) {
    const Waypoint& point = motion.waypoints[i];
    if (!onBead(point) || !point.reachable) {
      continue;
    }
    ++count;
    if (i > 0 && sameBead(point, motion.waypoints[i - 1]) && motion.waypoints[i - 1].reachable &&
        point.speed > 0.0) {
      const double slower = std::max(0.0, 1.0 - point.tcpSpeed / point.speed);
      sum += slower * slower;
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

std::vector<float> clearanceOf(const Motion& motion,
                               const collision::Clearance& clearance,
                               const JobContext& context) {
  std::vector<float> distances(motion.waypoints.size(), 0.0F);
  std::vector<collision::CellState> states;
  for (std::size_t begin = 0; begin < distances.size(); begin += kStatesBetweenChecks) {
    context.check();
    const std::size_t count = std::min(kStatesBetweenChecks, distances.size() - begin);
    states.clear();
    for (std::size_t i = begin; i < begin + count; ++i) {
      states.push_back({motion.waypoints[i].joints, motion.waypoints[i].deposited});
    }
    clearance.evaluate(states, std::span(distances).subspan(begin, count));
  }
  return distances;
}

}  // namespace detail

Evaluation evaluateMotion(const Motion& motion,
                          const cell::Cell& cell,
                          const MotionParams& given,
                          const JobContext& context,
                          const collision::Clearance* clearance) {
  const MotionParams params = detail::withCable(given, cell);
  Evaluation result;
  if (motion.waypoints.empty()) {
    return result;
  }
  const std::size_t count = motion.waypoints.size();
  const Judge judge(motion, cell, params);
  std::vector<Partial> parts((count + kGrain - 1) / kGrain);
  parallelForChunks(
      count, kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          judge.add(i, parts[begin / kGrain]);
        }
      },
      context);
  Partial whole;
  for (const Partial& part : parts) {
    whole.add(part);
  }
  if (clearance != nullptr) {
    addCollisions(motion, *clearance, context, whole);
  }
  const ObjectiveValues weights = params.weights();
  const double points = std::max<double>(1.0, static_cast<double>(whole.points));
  const std::optional<double> loss = predictedLoss(motion, cell, params, context);
  if (loss) {
    whole[Objective::TcpSpeed] = *loss * points;
  }
  for (std::size_t k = 0; k < kObjectiveCount; ++k) {
    const double scale = isMean(static_cast<Objective>(k)) ? 1.0 / points : 1.0;
    result.objectives[k] = whole.sums[k] * scale;
    result.cost += weights[k] * result.objectives[k];
  }
  result.broken = whole.broken;
  result.excess = whole.excess;
  return result;
}

}  // namespace wcam::motion
