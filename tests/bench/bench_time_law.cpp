// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The speed law of 8 joints under speed and acceleration limits, against the same law with plain
// halving for every linear programme (tests/support/plain_speed_law.hpp). Equal durations are
// checked; the law with jerk limits is timed beside it.
//
//   bench_time_law [--points N] [--reps R]

#include "plain_speed_law.hpp"
#include "timing.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>

namespace {

using wcam::motion::SpeedLaw;
using wcam::motion::SpeedLimits;
using wcam::motion::SpeedPath;

constexpr int kJoints = 8;
constexpr double kEqual = 1e-9;  ///< relative difference of the durations

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

/// Sums of slow waves, 1 mm between the points: what a planned bead looks like.
SpeedPath wavyPath(std::size_t points) {
  std::mt19937_64 random(1);
  SpeedPath path;
  path.joints = kJoints;
  constexpr int kWaves = 3;
  double amplitude[kJoints][kWaves];
  double frequency[kJoints][kWaves];
  double phase[kJoints][kWaves];
  for (int j = 0; j < kJoints; ++j) {
    for (int k = 0; k < kWaves; ++k) {
      frequency[j][k] = uniform(random, 0.002, 0.05);
      amplitude[j][k] = uniform(random, 0.001, 0.01) / frequency[j][k];
      phase[j][k] = uniform(random, 0, 6);
    }
  }
  path.q.reserve(points * kJoints);
  for (std::size_t i = 0; i < points; ++i) {
    for (int j = 0; j < kJoints; ++j) {
      double q = 0.0;
      for (int k = 0; k < kWaves; ++k) {
        q += amplitude[j][k] * std::sin(frequency[j][k] * static_cast<double>(i) + phase[j][k]);
      }
      path.q.push_back(q);
    }
    path.length.push_back(1.0);
    path.speed.push_back(200.0);
  }
  return path;
}

SpeedLimits limitsOf(double acceleration) {
  SpeedLimits limits;
  std::mt19937_64 random(2);
  for (int j = 0; j < kJoints; ++j) {
    limits.joints.push_back({uniform(random, 2, 4), acceleration * uniform(random, 0.5, 1.5)});
  }
  return limits;
}

std::size_t option(int argc, char** argv, const char* name, std::size_t fallback) {
  for (int i = 1; i + 1 < argc; ++i) {
    if (std::strcmp(argv[i], name) == 0) {
      return static_cast<std::size_t>(std::strtoull(argv[i + 1], nullptr, 10));
    }
  }
  return fallback;
}

/// One comparison; false when the durations differ.
bool compare(const char* what, const SpeedPath& path, const SpeedLimits& limits, std::size_t reps) {
  wcam::bench::Times own;
  wcam::bench::Times plain;
  double ownDuration = 0.0;
  double plainDuration = 0.0;
  for (std::size_t k = 0; k < reps; ++k) {
    ownDuration = own.measure([&] { return wcam::motion::speedLaw(path, limits); }).duration;
    plainDuration = plain.measure([&] { return wcam::test::plainSpeedLaw(path, limits); }).duration;
  }
  const double difference = std::abs(ownDuration - plainDuration) / plainDuration;
  const auto points = static_cast<double>(path.size());
  std::printf(
      "%-22s own %7.1f ms (%5.1f ns/point)  plain %8.1f ms  ratio %5.1f  durations %.6f s "
      "and %.6f s, difference %.1e\n",
      what, own.min() * 1e3, own.min() / points * 1e9, plain.min() * 1e3, plain.min() / own.min(),
      ownDuration, plainDuration, difference);
  return difference <= kEqual;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t points = option(argc, argv, "--points", 1000000);
  const std::size_t reps = option(argc, argv, "--reps", 3);
  const SpeedPath path = wavyPath(points);
  std::printf("%zu points, %d joints, 1 thread\n", points, kJoints);
  bool equal = compare("wanted speed mostly", path, limitsOf(400.0), reps);
  equal = compare("accelerations mostly", path, limitsOf(4.0), reps) && equal;
  SpeedLimits jerk = limitsOf(4.0);
  for (auto& bounds : jerk.joints) {
    bounds.jerk = 20.0 * bounds.acceleration;
  }
  wcam::bench::Times times;
  double duration = 0.0;
  for (std::size_t k = 0; k < reps; ++k) {
    duration = times.measure([&] { return wcam::motion::speedLaw(path, jerk); }).duration;
  }
  std::printf("%-22s own %7.1f ms, %.6f s\n", "with jerk limits", times.min() * 1e3, duration);
  if (!equal) {
    std::printf("the durations differ\n");
    return 1;
  }
  return 0;
}
