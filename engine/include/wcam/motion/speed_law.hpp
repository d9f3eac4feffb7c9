// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"

#include <cstddef>
#include <limits>
#include <vector>

/// The speed law along a path whose length is the master: how fast the path parameter s can run so
/// that no joint exceeds its speed, acceleration or jerk. Knows nothing of robots.
///
/// Model of the controller: joints are straight lines over s between the points, and round each
/// corner within a zone: q' changes linearly over δ before and after the point, δ being the least
/// of the blending radius and half of both neighbouring segments. So dense points of a smooth path
/// make one smooth path, and a lone corner is as fast as its zone allows.
namespace wcam::motion {

/// Limits of one joint; infinite where there is none.
struct JointBounds {
  double speed = std::numeric_limits<double>::infinity();
  double acceleration = std::numeric_limits<double>::infinity();
  double jerk = std::numeric_limits<double>::infinity();
};

/// A path from rest to rest. Entry i of `length` and `speed` is of the segment that ends
/// at point i; entry 0 is not used.
struct SpeedPath {
  static constexpr int kMaxJoints = 12;
  int joints = 0;
  std::vector<double> q;       ///< points × joints
  std::vector<double> length;  ///< of the parameter s; greater than 0
  std::vector<double> speed;   ///< greatest ds/dt wanted; greater than 0, may be infinite

  [[nodiscard]] std::size_t size() const { return length.size(); }
};

struct SpeedLimits {
  std::vector<JointBounds> joints;
  double blend = 1.0;  ///< greatest δ, in units of s; 0: exact stop at every corner
  /// Greatest acceleration of the point on the path (of a path in space of unit speed), and the
  /// unit tangents of the segments (points × 3) for it; infinite: none, tangents may be empty.
  double pathAcceleration = std::numeric_limits<double>::infinity();
  std::vector<double> tangents;
};

/// The law at the points.
struct SpeedLaw {
  std::vector<double> time;   ///< s, from 0
  std::vector<double> speed;  ///< ds/dt
  double duration = 0.0;
};

/// The time-optimal law under speed and acceleration limits: forward and backward reachability of
/// x = ṡ² with an exact linear programme in two variables for each zone. Exact between the points
/// as well: within a zone s̈ is constant and q' linear, so that the joint accelerations are extreme
/// at its ends. With jerk limits the law is then averaged over time (the moving average that
/// controllers use), after caps were widened by the way of the average, and slowed down as a whole
/// where a limit would still be exceeded. The jerk that counts is q'·s⃛ + 3·q''·ṡ·s̈.
///
/// Linear in the number of points; about 0.05 µs per point of 8 joints where the wanted speed
/// leads, 0.1 µs where accelerations do, some µs with jerk limits.
/// A path with one point gives time 0. Deterministic on all processors.
SpeedLaw speedLaw(const SpeedPath& path,
                  const SpeedLimits& limits,
                  const JobContext& context = JobContext());

/// Time of a joint from rest to rest over `distance` with jerk-limited (S-shaped) profile.
double restToRest(double distance, const JointBounds& bounds);

}  // namespace wcam::motion
