// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/reversals.hpp"

#include "wcam/cell/kinematics.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion {

namespace {

/// Follows one joint from extreme to extreme.
class ExtremeFollower {
public:
  /// @return the waypoint of the extreme that the joint has just left, or −1
  int next(double value, std::size_t index, double deadBand) {
    if (!started_) {
      started_ = true;
      extreme_ = value;
      extremeIndex_ = index;
      return -1;
    }
    if (direction_ == 0) {
      if (std::abs(value - extreme_) > deadBand) {
        direction_ = value > extreme_ ? 1 : -1;
        take(value, index);
      }
      return -1;
    }
    if ((value - extreme_) * direction_ >= 0.0) {
      take(value, index);
      return -1;
    }
    if (std::abs(value - extreme_) <= deadBand) {
      return -1;
    }
    const int turned = static_cast<int>(extremeIndex_);
    direction_ = -direction_;
    take(value, index);
    return turned;
  }

  [[nodiscard]] int direction() const { return direction_; }

private:
  void take(double value, std::size_t index) {
    extreme_ = value;
    extremeIndex_ = index;
  }

  bool started_ = false;
  int direction_ = 0;
  double extreme_ = 0.0;
  std::size_t extremeIndex_ = 0;
};

}  // namespace

std::vector<Reversal> jointReversals(const Motion& motion,
                                     const cell::Cell& cell,
                                     double deadBand) {
  std::vector<Reversal> reversals;
  std::vector<ExtremeFollower> followers(static_cast<std::size_t>(cell.jointCount()));
  for (std::size_t i = 0; i < motion.waypoints.size(); ++i) {
    const Waypoint& point = motion.waypoints[i];
    for (int j = 0; j < cell.jointCount(); ++j) {
      ExtremeFollower& follower = followers[static_cast<std::size_t>(j)];
      const int at = follower.next(point.joints(j), i, deadBand);
      if (at >= 0) {
        const Waypoint& turned = motion.waypoints[static_cast<std::size_t>(at)];
        Reversal reversal;
        reversal.waypoint = static_cast<std::size_t>(at);
        reversal.joint = j;
        reversal.direction = follower.direction();
        reversal.time = turned.time;
        if (cell.joint(j).backlash > 0.0) {
          // The joint's side lags behind by the backlash: the TCP stays back against the new
          // motion.
          reversal.effect = -reversal.direction * cell.joint(j).backlash *
                            cell::partJacobian(cell, turned.joints).col(j);
        }
        reversals.push_back(reversal);
      }
    }
  }
  std::stable_sort(reversals.begin(), reversals.end(),
                   [](const Reversal& a, const Reversal& b) { return a.waypoint < b.waypoint; });
  return reversals;
}

}  // namespace wcam::motion
