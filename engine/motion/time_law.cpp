// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/motion/speed_law.hpp"

#include "plan_detail.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion {

namespace detail {

double jointTime(const Cell& cell,
                 const cell::JointVector& from,
                 const cell::JointVector& to,
                 double ratio) {
  double time = 0.0;
  for (int j = 0; j < cell.jointCount(); ++j) {
    time = std::max(time, std::abs(to(j) - from(j)) / (ratio * cell.joint(j).maxSpeed));
  }
  return time;
}

std::vector<JointBounds> jointBounds(const Cell& cell, const TimeLawParams& params) {
  std::vector<JointBounds> bounds;
  for (int j = 0; j < cell.jointCount(); ++j) {
    const cell::Joint& joint = cell.joint(j);
    if (!(joint.maxSpeed > 0.0)) {
      throw Error(ErrorCode::JobFailed, text("joint %1 has no greatest speed", {joint.name}),
                  text("cell %1", {cell.name}), "add \"max_speed\" to the joint in the cell file");
    }
    JointBounds own{joint.maxSpeed, joint.maxAcceleration, joint.maxJerk};
    if (!std::isfinite(own.acceleration) && params.accelerationTime > 0.0) {
      own.acceleration = own.speed / params.accelerationTime;
    }
    bounds.push_back(own);
  }
  return bounds;
}

bool stopsAfter(const Motion& motion, std::size_t i) {
  const std::vector<Waypoint>& points = motion.waypoints;
  return i == 0 || i + 1 == points.size() || points[i + 1].kind == MoveKind::Joint ||
         points[i].kind == MoveKind::Joint || points[i].arc != points[i + 1].arc;
}

}  // namespace detail

namespace {

/// Points nearer than this (mm) are the same place: a direction between them would be rounding.
constexpr double kSamePlace = 1e-9;
/// Joints that need less time than this (s) do not move.
constexpr double kNoTime = 1e-12;
constexpr std::size_t kCheckEvery = 4096;

double lengthBetween(const Waypoint& a, const Waypoint& b) {
  return (b.T_part_tcp.translation() - a.T_part_tcp.translation()).norm();
}

/// A joint move: every joint from rest to rest, the slowest decides.
double jointMoveTime(const Waypoint& from,
                     const Waypoint& to,
                     const std::vector<JointBounds>& bounds,
                     double ratio) {
  double time = 0.0;
  for (std::size_t j = 0; j < bounds.size(); ++j) {
    JointBounds own = bounds[j];
    own.speed *= ratio;
    const auto i = static_cast<Eigen::Index>(j);
    time = std::max(time, restToRest(to.joints(i) - from.joints(i), own));
  }
  return time;
}

/// The time of a segment when speeds may change at once: its length over the wanted speed, or
/// longer when a joint could not follow.
double plainTime(const cell::Cell& cell, const Waypoint& from, const Waypoint& to, double length) {
  const double step = detail::jointTime(cell, from.joints, to.joints, 1.0);
  return to.speed > 0.0 ? std::max(step, length / to.speed) : step;
}

/// The linear moves between two stops as a path for speedLaw.
class Run {
public:
  Run(const cell::Cell& cell, const SpeedLimits& limits) : limits_(limits), cell_(cell) {
    path_.joints = cell.jointCount();
  }

  void begin(const Waypoint& point, std::size_t index) {
    path_.q.clear();
    path_.length.clear();
    path_.speed.clear();
    limits_.tangents.clear();
    share_.clear();
    indices_.clear();
    append(point, index, 0.0, 0.0, Eigen::Vector3d::Zero(), 0.0);
  }

  /// A point at which nothing moves takes the time and place of the one before.
  void add(const Waypoint& before, const Waypoint& point, std::size_t index) {
    const Eigen::Vector3d step = point.T_part_tcp.translation() - before.T_part_tcp.translation();
    const double length = step.norm();
    if (length > kSamePlace) {
      append(point, index, length,
             point.speed > 0.0 ? point.speed : std::numeric_limits<double>::infinity(),
             step / length, 1.0);
      return;
    }
    // The torch turns on the spot: the time of the slowest joint is the measure of the way.
    const double time = detail::jointTime(cell_, before.joints, point.joints, 1.0);
    if (time > kNoTime) {
      const double speed = point.speed > 0.0 ? point.speed : 1.0;
      append(point, index, time * speed, speed, Eigen::Vector3d::Zero(), 0.0);
    }
  }

  /// Writes times and speeds from the time of the first point on.
  void finish(std::vector<Waypoint>& points, std::size_t last, const JobContext& context) {
    const SpeedLaw law = speedLaw(path_, limits_, context);
    const double start = points[indices_.front()].time;
    for (std::size_t k = 0; k < indices_.size(); ++k) {
      const std::size_t next = k + 1 < indices_.size() ? indices_[k + 1] : last + 1;
      for (std::size_t i = indices_[k]; i < next; ++i) {
        points[i].time = start + law.time[k];
        points[i].tcpSpeed = law.speed[k] * share_[k];
      }
    }
  }

private:
  void append(const Waypoint& point,
              std::size_t index,
              double length,
              double speed,
              const Eigen::Vector3d& tangent,
              double share) {
    path_.q.insert(path_.q.end(), point.joints.data(), point.joints.data() + point.joints.size());
    path_.length.push_back(length);
    path_.speed.push_back(speed);
    if (std::isfinite(limits_.pathAcceleration)) {
      limits_.tangents.insert(limits_.tangents.end(), tangent.data(), tangent.data() + 3);
    }
    share_.push_back(share);
    indices_.push_back(index);
  }

  SpeedLimits limits_;
  const cell::Cell& cell_;
  SpeedPath path_;
  std::vector<double> share_;  ///< 1 where the path is that of the TCP, 0 where it only turns
  std::vector<std::size_t> indices_;
};

void feedWire(const TimeLawParams& params, std::vector<Waypoint>& points) {
  for (std::size_t i = 1; params.wireFollowsSpeed && i < points.size(); ++i) {
    const double step = points[i].time - points[i - 1].time;
    if (!points[i].arc || !(points[i].speed > 0.0) || !(step > 0.0)) {
      continue;
    }
    const double ratio = lengthBetween(points[i - 1], points[i]) / (step * points[i].speed);
    points[i].wireSpeed *= std::clamp(ratio, params.leastWireRatio, 1.0);
  }
}

}  // namespace

void applyTimeLaw(Motion& motion,
                  const cell::Cell& cell,
                  const TimeLawParams& params,
                  double jointSpeedRatio,
                  const JobContext& context) {
  std::vector<Waypoint>& points = motion.waypoints;
  if (points.empty()) {
    return;
  }
  SpeedLimits limits;
  limits.joints = detail::jointBounds(cell, params);
  limits.blend = params.cornerRadius.value();
  if (params.tcpAcceleration > 0.0) {
    limits.pathAcceleration = params.tcpAcceleration;
  }
  const bool plain =
      !std::isfinite(limits.pathAcceleration) &&
      std::all_of(limits.joints.begin(), limits.joints.end(),
                  [](const JointBounds& b) { return !std::isfinite(b.acceleration); });
  Run run(cell, limits);
  points[0].time = 0.0;
  points[0].tcpSpeed = 0.0;
  run.begin(points[0], 0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (i % kCheckEvery == 0) {
      context.check();
    }
    Waypoint& point = points[i];
    const Waypoint& before = points[i - 1];
    if (point.kind == MoveKind::Joint || plain) {
      const double length = lengthBetween(before, point);
      const double step = point.kind == MoveKind::Joint
                              ? jointMoveTime(before, point, limits.joints, jointSpeedRatio)
                              : plainTime(cell, before, point, length);
      point.time = before.time + step;
      point.tcpSpeed = step > 0.0 ? length / step : 0.0;
      run.begin(point, i);
      continue;
    }
    run.add(before, point, i);
    if (detail::stopsAfter(motion, i)) {
      run.finish(points, i, context);
      run.begin(point, i);
    }
  }
  feedWire(params, points);
}

}  // namespace wcam::motion
