// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "speed_law_detail.hpp"
#include "speed_rows.hpp"

#include <algorithm>
#include <cmath>

// Rows are never passed to a function that is not inlined.
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace wcam::motion::detail {

namespace {

/// Accelerations beyond this are none (mm/s²): keeps sums and products finite.
constexpr double kMostGain = 1e12;
/// A change of slope below this part of the slopes is no corner.
constexpr double kNoCorner = 1e-9;
const double kHalfRoot = std::sqrt(0.5);

double finiteInverse(double limit) {
  return std::isfinite(limit) ? 1.0 / limit : 0.0;
}

/// What is the same for all points; joints beyond the path's own have no limits. Rows of 8 joints
/// each: B of them.
template <int B>
struct Common {
  static constexpr int kWidth = B * kRowLanes;
  double perSpeed[kWidth] = {};
  double perGain[kWidth] = {};
  double pathGain = 0.0;  ///< greatest s̈ by the path's own acceleration
  bool curved = false;    ///< that acceleration counts in the zones

  explicit Common(const SpeedLimits& limits) {
    for (std::size_t j = 0; j < limits.joints.size(); ++j) {
      perSpeed[j] = finiteInverse(limits.joints[j].speed);
      perGain[j] = finiteInverse(limits.joints[j].acceleration);
    }
    pathGain = std::min(limits.pathAcceleration * kHalfRoot, kMostGain);
    curved = std::isfinite(limits.pathAcceleration) && !limits.tangents.empty();
  }
};

/// Slopes, caps and gains of the segments that end at the points [begin, end).
template <int B>
WCAM_CLONED void addSegments(const SpeedPath& path,
                             const Common<B>& common,
                             std::size_t begin,
                             std::size_t end,
                             SpeedPieces& pieces) {
  constexpr std::size_t kWidth = B * kRowLanes;
  const auto joints = static_cast<std::size_t>(path.joints);
  double padded[2][kWidth] = {};
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t own = i - pieces.first;
    const double* to = path.q.data() + i * joints;
    const double* from = to - joints;
    if (joints < kWidth) {
      for (std::size_t j = 0; j < joints; ++j) {
        padded[0][j] = from[j];
        padded[1][j] = to[j];
      }
      from = padded[0];
      to = padded[1];
    }
    const double inverse = 1.0 / path.length[i];
    Row slowest{};
    Row hardest{};
    for (int r = 0; r < B; ++r) {
      const int lane = r * kRowLanes;
      const Row q1 = (loadRow(to + lane) - loadRow(from + lane)) * inverse;
      const Row k = q1 * loadRow(common.perGain + lane);
      storeRow(k, pieces.slope.data() + own * kWidth + lane);
      slowest = greater(slowest, sizeOf(q1) * loadRow(common.perSpeed + lane));
      hardest = greater(hardest, sizeOf(k));
    }
    const double mostPerSpeed = greatestOf(slowest);
    const double mostPerGain = greatestOf(hardest);
    double speed = std::min(path.speed[i], kMostSpeed);
    if (mostPerSpeed * speed > 1.0) {
      speed = 1.0 / mostPerSpeed;
    }
    pieces.cap[own] = speed * speed;
    pieces.gain[own] = mostPerGain * common.pathGain > 1.0 ? 1.0 / mostPerGain : common.pathGain;
  }
}

/// True where no joint changes its slope: the zone of such a point would only hinder a change of
/// acceleration in it.
template <int B>
WCAM_CLONED bool isStraight(const double* k) {
  Row most{};
  for (int r = 0; r < B; ++r) {
    const Row k0 = loadRow(k + r * kRowLanes);
    const Row k1 = loadRow(k + (B + r) * kRowLanes);
    most = greater(most, sizeOf(k1 - k0) - kNoCorner * (sizeOf(k0) + sizeOf(k1)));
  }
  return greatestOf(most) <= 0.0;
}

/// Lengths of the zones of the points [begin, end), and what the path's own curvature allows in
/// them.
template <int B>
WCAM_CLONED void addZones(const SpeedPath& path,
                          const SpeedLimits& limits,
                          const Common<B>& common,
                          std::size_t begin,
                          std::size_t end,
                          SpeedPieces& pieces) {
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t own = i - pieces.first;
    double turn = 0.0;
    if (common.curved) {
      const double* t = limits.tangents.data() + 3 * i;
      turn = std::hypot(t[3] - t[0], t[4] - t[1], t[5] - t[2]);
    }
    double cap = std::min(pieces.cap[own], pieces.cap[own + 1]);
    double zone = 0.0;
    if (turn > kNoCorner || !isStraight<B>(pieces.slope.data() + own * Common<B>::kWidth)) {
      const double half = std::min({limits.blend, 0.5 * path.length[i], 0.5 * path.length[i + 1]});
      zone = 2.0 * half;
      if (half == 0.0) {
        cap = 0.0;
      } else if (turn > kNoCorner) {
        cap = std::min(cap, limits.pathAcceleration * kHalfRoot * zone / turn);
      }
    }
    pieces.zone[own] = zone;
    pieces.zoneCap[own] = cap;
  }
}

template <int B>
WCAM_CLONED void fill(const SpeedPath& path,
                      const SpeedLimits& limits,
                      std::size_t begin,
                      std::size_t end,
                      SpeedPieces& pieces) {
  const std::size_t n = path.size();
  const std::size_t last = std::min(end + 1, n);
  pieces.first = begin - 1;
  pieces.width = Common<B>::kWidth;
  pieces.resize(last - pieces.first);
  const Common<B> common(limits);
  addSegments<B>(path, common, std::max<std::size_t>(pieces.first, 1), last, pieces);
  addZones<B>(path, limits, common, std::max<std::size_t>(pieces.first, 1), std::min(end, n - 1),
              pieces);
  // The ends of the path have no zone, and the path is at rest there.
  if (pieces.first == 0) {
    pieces.zone[0] = 0.0;
    pieces.zoneCap[0] = 0.0;
  }
  if (end == n) {
    pieces.zone[n - 1 - pieces.first] = 0.0;
    pieces.zoneCap[n - 1 - pieces.first] = 0.0;
  }
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t own = i - pieces.first;
    pieces.straight[own] =
        std::max(path.length[i] - 0.5 * (pieces.zone[own - 1] + pieces.zone[own]), 0.0);
  }
}

}  // namespace

void SpeedPieces::resize(std::size_t points) {
  slope.resize((points + 1) * static_cast<std::size_t>(width));
  for (std::vector<double>* values : {&straight, &zone, &cap, &gain, &zoneCap}) {
    values->resize(points);
  }
}

WCAM_VECTOR_CLONES void fillPieces(const SpeedPath& path,
                                   const SpeedLimits& limits,
                                   std::size_t begin,
                                   std::size_t end,
                                   SpeedPieces& pieces) {
  if (path.joints <= kRowLanes) {
    fill<1>(path, limits, begin, end, pieces);
  } else {
    fill<2>(path, limits, begin, end, pieces);
  }
}

SpeedPieces makePieces(const SpeedPath& path, const SpeedLimits& limits) {
  SpeedPieces pieces;
  fillPieces(path, limits, 1, path.size(), pieces);
  return pieces;
}

}  // namespace wcam::motion::detail
