// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/text.hpp"
#include "wcam/cell/joint_text.hpp"
#include "wcam/cell/unwrap.hpp"

#include "cell_model.hpp"
#include "plan_detail.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

/// A speed that is lower by more than this (relative) was held back by a joint.
constexpr double kSlower = 1e-9;
/// Rounding of an angle on its limit, rad.
constexpr double kOnLimit = 1e-9;
constexpr std::size_t kCheckEvery = 4096;
/// The first rotary joint of a Cartesian machine.
constexpr int kFirstRotary = 3;

/// The worst of a kind of finding in one bead. The place is the worst point of the bead itself, a
/// travel move (−1) only where no point of the bead is concerned.
struct Worst {
  std::size_t count = 0;
  double value = 0.0;
  double extra = 0.0;
  int joint = -1;
  int point = -1;

  void add(double badness, int atPoint, int atJoint = -1, double more = 0.0) {
    if (count == 0 || badness > value) {
      value = badness;
      joint = atJoint;
      extra = more;
    }
    if (atPoint >= 0 && (point < 0 || badness > pointValue_)) {
      point = atPoint;
      pointValue_ = badness;
    }
    ++count;
  }

private:
  double pointValue_ = 0.0;
};

Text points(std::size_t count) {
  return count == 1 ? text("1 point") : text("%1 points", {std::to_string(count)});
}

std::string degText(double rad) {
  return formatFixed(radToDeg(rad), 3) + " deg";
}

/// Findings of one bead with its travel moves.
class BeadFindings {
public:
  BeadFindings(const Cell& cell, const MotionParams& params, Place place)
      : cell_(cell),
        model_(cell),
        params_(params),
        place_(std::move(place)),
        limits_(static_cast<std::size_t>(cell.jointCount())),
        steps_(limits_.size()),
        turns_(limits_.size()),
        sums_(cell.sums.size()) {}

  void add(const Waypoint& point, const Waypoint* before, const PointState& state) {
    if (!point.reachable) {
      unreachable_.add(state.missing, point.point, -1, state.missingTilt);
    } else {
      addSingularities(point, state);
      if (point.arc && state.dexterity < params_.minDexterity) {
        dexterity_.add(-static_cast<double>(state.dexterity), point.point);
      }
    }
    if (point.verticalError > params_.verticalTolerance.value()) {
      vertical_.add(point.verticalError, point.point);
    }
    if (point.reachable && point.tilt > params_.tiltTolerance.value() + kOnLimit) {
      tilt_.add(point.tilt, point.point);
    }
    addTwist(point);
    for (std::size_t j = 0; j < limits_.size(); ++j) {
      const auto joint = static_cast<int>(j);
      const double excess = cell::limitExcess(cell_.joint(joint), point.joints(joint));
      if (excess > 0.0 && (point.reachable || joint >= cell_.robotJoints())) {
        limits_[j].add(excess, point.point, joint, point.joints(joint));
      }
      if (before != nullptr) {
        addStep(point, *before, joint);
      }
    }
    for (std::size_t k = 0; k < sums_.size() && point.reachable; ++k) {
      const double excess = sumExcess(cell_.sums[k], point.joints);
      if (excess > 0.0) {
        sums_[k].add(excess, point.point, CellModel::firstOf(cell_.sums[k]),
                     cell_.sums[k].value(point.joints));
      }
    }
    if (before != nullptr && point.arc && point.reachable && before->reachable &&
        point.tcpSpeed < point.speed * (1.0 - kSlower) && jointsTooSlow(point, *before)) {
      addSlowdown(point, *before);
    }
  }

  void report(const JobContext& context) const {
    reportReach(context);
    reportLimits(context);
    reportSums(context);
    reportSingularities(context);
    reportSteps(context);
    reportRest(context);
  }

private:
  void addSingularities(const Waypoint& point, const PointState& state) {
    if (state.wristSine < std::sin(params_.wristMargin.value())) {
      wrist_.add(-std::asin(std::min(1.0, static_cast<double>(state.wristSine))), point.point);
    }
    if (state.elbowSine < std::sin(params_.elbowMargin.value())) {
      elbow_.add(-std::asin(std::min(1.0, static_cast<double>(state.elbowSine))), point.point);
    }
    if (state.axisDistance < params_.shoulderMargin.value()) {
      shoulder_.add(-static_cast<double>(state.axisDistance), point.point);
    }
  }

  void addTwist(const Waypoint& point) {
    if (params_.cableLimit.value() > 0.0 && point.reachable) {
      const double twist = model_.cableTwist(point.joints, params_.cableZero.value());
      if (std::abs(twist) > params_.cableLimit.value() + kOnLimit) {
        cable_.add(std::abs(twist), point.point, -1, twist);
      }
    }
  }

  void addStep(const Waypoint& point, const Waypoint& before, int joint) {
    const double step = point.joints(joint) - before.joints(joint);
    const auto j = static_cast<std::size_t>(joint);
    if (point.kind == MoveKind::Joint) {
      // More than half a turn in a travel move: a full turn was taken back.
      if (std::abs(step) > kPi && cell::periodicJoint(cell_, joint)) {
        turns_[j].add(std::abs(step), point.point, joint);
      }
    } else if (!cell_.joint(joint).prismatic() && std::abs(step) > params_.maxJointStep.value() &&
               point.reachable && before.reachable) {
      steps_[j].add(std::abs(step), point.point, joint);
    }
  }

  /// A joint's speed holds the torch back; what its acceleration does is told by reportSpeeds.
  [[nodiscard]] bool jointsTooSlow(const Waypoint& point, const Waypoint& before) const {
    const double length = (point.T_part_tcp.translation() - before.T_part_tcp.translation()).norm();
    return jointTime(cell_, before.joints, point.joints, 1.0) * point.speed >
           length * (1.0 + kSlower);
  }

  void addSlowdown(const Waypoint& point, const Waypoint& before) {
    double slowest = 0.0;
    int joint = -1;
    for (int j = 0; j < cell_.jointCount(); ++j) {
      const double time = std::abs(point.joints(j) - before.joints(j)) / cell_.joint(j).maxSpeed;
      if (time > slowest) {
        slowest = time;
        joint = j;
      }
    }
    slow_.add(-point.tcpSpeed / point.speed, point.point, joint, point.tcpSpeed);
  }

  void put(const JobContext& context,
           Severity severity,
           const char* code,
           Text message,
           Text remedy,
           const Worst& worst,
           std::vector<std::pair<std::string, double>> data) const {
    Place place = place_;
    place.point = worst.point;
    data.emplace_back("points", static_cast<double>(worst.count));
    context.add({severity, code, std::move(message), std::move(remedy), place, std::move(data)});
  }

  std::string valueText(const Worst& worst) const {
    return cell::jointText(cell_.joint(worst.joint), worst.value);
  }

  std::string unitOf(const Worst& worst) const { return cell::jointUnit(cell_.joint(worst.joint)); }

  double toUnit(const Worst& worst, double value) const {
    return cell::toJointUnit(cell_.joint(worst.joint), value);
  }

  Text nameOf(const Worst& worst) const {
    return worst.joint < 0 ? text("a joint") : text("joint %1", {cell_.joint(worst.joint).name});
  }

  void reportReach(const JobContext& context) const {
    if (unreachable_.count > 0) {
      const bool turned = unreachable_.extra > 0.0;
      const char* pattern =
          cell_.arm ? (turned ? "%1 out of the robot's reach; the wrist misses up to %2 mm and %3"
                              : "%1 out of the robot's reach; the wrist misses up to %2 mm")
                    : (turned ? "%1 out of the robot's reach; the tool misses up to %2 mm and %3"
                              : "%1 out of the robot's reach; the tool misses up to %2 mm");
      put(context, Severity::Violation, "motion.unreachable",
          text(pattern, {points(unreachable_.count), formatFixed(unreachable_.value, 1),
                         degText(unreachable_.extra)}),
          "move the part in the cell, change the rotation about the torch or the configuration, or "
          "lower the safe height when only travel moves are concerned",
          unreachable_, {{"missing_mm", unreachable_.value}});
    }
  }

  void reportLimits(const JobContext& context) const {
    for (const Worst& worst : limits_) {
      if (worst.count > 0) {
        put(context, Severity::Violation, "motion.joint_limit",
            text("%1 exceeds its limit by up to %2 at %3",
                 {nameOf(worst), valueText(worst), points(worst.count)}),
            "change the rotation about the torch, the configuration or the place of the part",
            worst,
            {{"joint", worst.joint + 1.0},
             {"excess_" + unitOf(worst), toUnit(worst, worst.value)},
             {"value_" + unitOf(worst), toUnit(worst, worst.extra)}});
      }
    }
  }

  void reportSums(const JobContext& context) const {
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      const Worst& worst = sums_[k];
      if (worst.count > 0) {
        put(context, Severity::Violation, "motion.joint_limit",
            text("the sum %1 exceeds its limit by up to %2 at %3",
                 {cell_.sums[k].name, valueText(worst), points(worst.count)}),
            "change the rotation about the torch or the configuration", worst,
            {{"joint", worst.joint + 1.0},
             {"excess_" + unitOf(worst), toUnit(worst, worst.value)},
             {"value_" + unitOf(worst), toUnit(worst, worst.extra)}});
      }
    }
  }

  /// What lies in line at a singularity of the orientation.
  [[nodiscard]] Text wristText() const {
    const std::string bend = degText(-wrist_.value);
    switch (cell_.inverse->method()) {
      case cell::InverseMethod::Arm:
        return text("wrist singularity: axes 4 and 6 are in line but for %1 at %2",
                    {bend, points(wrist_.count)});
      case cell::InverseMethod::Cartesian:
        return text("singularity: the tool is in line with axis %3 but for %1 at %2",
                    {bend, points(wrist_.count), cell_.joint(kFirstRotary).name});
      case cell::InverseMethod::Numeric:
        break;
    }
    return text("singularity: a joint moves the tool as the others do but for %1 at %2",
                {bend, points(wrist_.count)});
  }

  void reportSingularities(const JobContext& context) const {
    const Text remedy =
        text("change the rotation about the torch, the tool tilt or the place of the part");
    if (wrist_.count > 0) {
      put(context, Severity::Warning, "motion.singularity", wristText(), remedy, wrist_,
          {{"wrist_bend_deg", radToDeg(-wrist_.value)}});
    }
    if (elbow_.count > 0) {
      put(context, Severity::Warning, "motion.singularity",
          text("elbow singularity: the arm is stretched or folded but for %1 at %2",
               {degText(-elbow_.value), points(elbow_.count)}),
          remedy, elbow_, {{"elbow_bend_deg", radToDeg(-elbow_.value)}});
    }
    if (shoulder_.count > 0) {
      put(context, Severity::Warning, "motion.singularity",
          text("shoulder singularity: the wrist centre is %1 mm from axis 1 at %2",
               {formatFixed(-shoulder_.value, 1), points(shoulder_.count)}),
          remedy, shoulder_, {{"axis_distance_mm", -shoulder_.value}});
    }
  }

  void reportSteps(const JobContext& context) const {
    for (const Worst& worst : steps_) {
      if (worst.count > 0) {
        put(context, Severity::Warning, "motion.joint_step",
            text("%1 turns by up to %2 between neighbouring points",
                 {nameOf(worst), degText(worst.value)}),
            "change the rotation about the torch or the configuration, so that the motion keeps "
            "away from a singularity",
            worst, {{"joint", worst.joint + 1.0}, {"step_deg", radToDeg(worst.value)}});
      }
    }
    for (const Worst& worst : turns_) {
      if (worst.count > 0) {
        put(context, Severity::Information, "motion.configuration_change",
            text("%1 turns by %2 in a travel move", {nameOf(worst), degText(worst.value)}),
            "check the cables", worst,
            {{"joint", worst.joint + 1.0}, {"step_deg", radToDeg(worst.value)}});
      }
    }
  }

  void reportRest(const JobContext& context) const {
    if (slow_.count > 0) {
      put(context, Severity::Warning, "motion.speed_limited",
          text("%1 slows the torch down to %2 mm/s (%3 % of the wanted speed) at %4",
               {nameOf(slow_), formatFixed(slow_.extra, 2), formatFixed(-slow_.value * 100.0, 1),
                points(slow_.count)}),
          "lower the travel speed, smooth the path (axis_rate bounds the turn of its build "
          "direction), or keep away from singularities",
          slow_,
          {{"joint", slow_.joint + 1.0},
           {"speed_mm_s", slow_.extra},
           {"speed_ratio", -slow_.value}});
    }
    if (dexterity_.count > 0) {
      put(context, Severity::Warning, "motion.low_dexterity",
          text("the dexterity falls to %1 at %2",
               {formatFixed(-dexterity_.value, 4), points(dexterity_.count)}),
          "change the rotation about the torch or the place of the part", dexterity_,
          {{"dexterity", -dexterity_.value}});
    }
    if (vertical_.count > 0) {
      put(context, Severity::Warning, "motion.not_vertical",
          text("the build direction is up to %1 off the vertical at %2",
               {degText(vertical_.value), points(vertical_.count)}),
          "the positioner's axes cannot turn it further; choose another build direction", vertical_,
          {{"angle_deg", radToDeg(vertical_.value)}});
    }
    if (tilt_.count > 0) {
      put(context, Severity::Violation, "motion.tilt",
          text("the torch leans by up to %1 from the path's tool axis at %2; allowed are %3",
               {degText(tilt_.value), points(tilt_.count), degText(params_.tiltTolerance.value())}),
          "raise tilt_tolerance if the process bears it, or choose another redundancy mode", tilt_,
          {{"tilt_deg", radToDeg(tilt_.value)}});
    }
    if (cable_.count > 0) {
      put(context, Severity::Violation, "motion.cable_twist",
          text("the torch's cable is twisted by up to %1 at %2; its limit is %3 to both sides",
               {degText(cable_.extra), points(cable_.count), degText(params_.cableLimit.value())}),
          "change the rotation about the torch or the configuration, or raise cable_limit if the "
          "cable bears it; check the cable's zero",
          cable_,
          {{"twist_deg", radToDeg(cable_.extra)},
           {"limit_deg", radToDeg(params_.cableLimit.value())},
           {"excess_deg", radToDeg(cable_.value - params_.cableLimit.value())}});
    }
  }

  const Cell& cell_;
  CellModel model_;
  const MotionParams& params_;
  Place place_;
  Worst unreachable_, wrist_, elbow_, shoulder_, dexterity_, vertical_, slow_, cable_, tilt_;
  std::vector<Worst> limits_, steps_, turns_, sums_;
};

}  // namespace

void reportFindings(const Cell& cell,
                    const Motion& motion,
                    const std::vector<PointState>& states,
                    const MotionParams& params,
                    const std::string& operationId,
                    const JobContext& context) {
  const std::vector<Waypoint>& points = motion.waypoints;
  std::size_t i = 0;
  while (i < points.size()) {
    const int layer = points[i].layer;
    const int bead = points[i].bead;
    BeadFindings findings(cell, params, {operationId, layer, bead, -1});
    for (; i < points.size() && points[i].layer == layer && points[i].bead == bead; ++i) {
      if (i % kCheckEvery == 0) {
        context.check();
      }
      findings.add(points[i], i > 0 ? &points[i - 1] : nullptr, states[i]);
    }
    findings.report(context);
  }
}

}  // namespace wcam::motion::detail
