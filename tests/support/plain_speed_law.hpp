// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/motion/speed_law.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

/// The law of wcam/motion/speed_law.hpp without jerk limits, written down plainly: every linear
/// programme by halving. Reference of tests and benchmark.
namespace wcam::test {

/// A zone: slopes before and after, length, accelerations.
struct PlainZone {
  std::vector<double> before;
  std::vector<double> after;
  double length = 0.0;
};

/// Values of x at the end that keep all joints within their limits for a value at the start.
inline bool endInterval(const PlainZone& zone,
                        const std::vector<motion::JointBounds>& joints,
                        double start,
                        double top,
                        double* low,
                        double* high) {
  *low = 0.0;
  *high = top;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const double a = joints[j].acceleration;
    if (!std::isfinite(a)) {
      continue;
    }
    const double c = (zone.after[j] - zone.before[j]) / zone.length;
    // s̈ = (end − start)/(2·length); q̈ = q'·s̈ + q''·x at both ends.
    for (const bool atEnd : {false, true}) {
      const double k = (atEnd ? zone.after[j] : zone.before[j]) / (2.0 * zone.length);
      const double ofEnd = k + (atEnd ? c : 0.0);
      const double rest = (-k + (atEnd ? 0.0 : c)) * start;
      if (std::abs(ofEnd) * top <= 1e-13 * a) {
        if (std::abs(rest) > a * (1.0 + 1e-12)) {
          return false;
        }
        continue;
      }
      const double x1 = (-a - rest) / ofEnd;
      const double x2 = (a - rest) / ofEnd;
      *low = std::max(*low, std::min(x1, x2));
      *high = std::min(*high, std::max(x1, x2));
    }
  }
  return *low <= *high;
}

inline motion::SpeedLaw plainSpeedLaw(const motion::SpeedPath& path,
                                      const motion::SpeedLimits& limits) {
  const std::size_t n = path.size();
  const auto joints = static_cast<std::size_t>(path.joints);
  std::vector<std::vector<double>> slope(n, std::vector<double>(joints, 0.0));
  std::vector<double> cap(n, 0.0);
  std::vector<double> gain(n, 1e12);
  std::vector<double> half(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    double speed = path.speed[i];
    for (std::size_t j = 0; j < joints; ++j) {
      slope[i][j] = (path.q[i * joints + j] - path.q[(i - 1) * joints + j]) / path.length[i];
      if (slope[i][j] != 0.0) {
        speed = std::min(speed, limits.joints[j].speed / std::abs(slope[i][j]));
        gain[i] = std::min(gain[i], limits.joints[j].acceleration / std::abs(slope[i][j]));
      }
    }
    cap[i] = speed * speed;
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    half[i] = std::min({limits.blend, path.length[i] / 2, path.length[i + 1] / 2});
  }
  std::vector<double> before(n, 0.0);
  std::vector<double> after(n, 0.0);
  const auto straight = [&](std::size_t i) {
    return std::max(path.length[i] - half[i - 1] - half[i], 0.0);
  };
  double low = 0.0;
  double high = 0.0;
  for (std::size_t i = n - 1; i-- > 1;) {
    const double own = std::min(cap[i], cap[i + 1]);
    after[i] = std::min(own, before[i + 1] + 2.0 * gain[i + 1] * straight(i + 1));
    const PlainZone zone{slope[i], slope[i + 1], 2.0 * half[i]};
    double feasible = 0.0;
    double beyond = own;
    for (int step = 0; step < 60 && feasible < beyond; ++step) {
      const double middle = 0.5 * (feasible + beyond);
      (endInterval(zone, limits.joints, middle, after[i], &low, &high) ? feasible : beyond) =
          middle;
    }
    before[i] = feasible;
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    before[i] = std::min(before[i], after[i - 1] + 2.0 * gain[i] * straight(i));
    const PlainZone zone{slope[i], slope[i + 1], 2.0 * half[i]};
    endInterval(zone, limits.joints, before[i], after[i], &low, &high);
    after[i] = std::max(high, 0.0);
  }
  motion::SpeedLaw law;
  law.time.assign(n, 0.0);
  law.speed.assign(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    const double x0 = after[i - 1];
    const double x1 = before[i];
    const double way = straight(i);
    const double top = std::max({std::min(cap[i], 0.5 * (x0 + x1) + gain[i] * way), x0, x1});
    const double ramps = (2.0 * top - x0 - x1) / (2.0 * gain[i]);
    law.duration += (2.0 * std::sqrt(top) - std::sqrt(x0) - std::sqrt(x1)) / gain[i];
    if (way > ramps) {
      law.duration += (way - ramps) / std::sqrt(top);
    }
    const double middle = std::sqrt(0.5 * (before[i] + after[i]));
    law.speed[i] = middle;
    if (half[i] > 0.0) {
      law.duration += 2.0 * half[i] / (std::sqrt(before[i]) + middle);
    }
    law.time[i] = law.duration;
    if (half[i] > 0.0) {
      law.duration += 2.0 * half[i] / (std::sqrt(after[i]) + middle);
    }
  }
  return law;
}

}  // namespace wcam::test
