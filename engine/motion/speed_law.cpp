// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/speed_law.hpp"

#include "wcam/base/error.hpp"

#include "speed_law_detail.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

namespace wcam::motion {

namespace {

using detail::SpeedNodes;
using detail::SpeedPieces;

/// Rounding of a limit that is met.
constexpr double kMet = 1.0 + 1e-9;
/// Points that are worked on at once: their pieces stay in the processor's cache.
constexpr std::size_t kBlock = 1024;

/// Time from speed a to speed b over a straight piece, going as fast as gain and cap allow.
double straightTime(double length, double a, double b, double gain, double cap) {
  const double top = std::min(cap, 0.5 * (a + b) + gain * length);
  const double va = std::sqrt(a);
  const double vb = std::sqrt(b);
  const double vt = std::sqrt(std::max({top, a, b}));
  const double ramps = ((top > a ? top - a : 0.0) + (top > b ? top - b : 0.0)) / (2.0 * gain);
  const double flat = std::max(length - ramps, 0.0);
  return (vt - va) / gain + (vt - vb) / gain + (vt > 0.0 ? flat / vt : 0.0);
}

/// Times and speeds of the points [begin, end) of a block, in the place of their nodes.
/// @param previous the node after point begin − 1
/// @param time after the zone of point begin − 1
/// @return the same after the block's last zone
double putLaw(const SpeedPieces& pieces,
              std::size_t begin,
              std::size_t end,
              double previous,
              double time,
              SpeedLaw& law) {
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t k = i - pieces.first;
    const double before = law.time[i];
    const double after = law.speed[i];
    if (pieces.straight[k] > 0.0) {
      time += straightTime(pieces.straight[k], previous, before, pieces.gain[k], pieces.cap[k]);
    }
    const double v = std::sqrt(0.5 * (before + after));
    const double half = 0.5 * pieces.zone[k];
    law.time[i] = time;
    if (half > 0.0) {
      law.time[i] = time + 2.0 * half / (std::sqrt(before) + v);
      time = law.time[i] + 2.0 * half / (std::sqrt(after) + v);
    }
    law.speed[i] = v;
    previous = after;
  }
  return time;
}

/// Block by block, back and forth: the pieces of a block are made twice, which is cheaper than to
/// fetch those of a long path from memory. Until a block is done, the times hold the nodes before
/// its points and the speeds those after them.
SpeedLaw accelerationLimited(const SpeedPath& path,
                             const SpeedLimits& limits,
                             const JobContext& context) {
  const std::size_t n = path.size();
  SpeedLaw law{std::vector<double>(n), std::vector<double>(n), 0.0};
  double* before = law.time.data();
  double* after = law.speed.data();
  SpeedPieces pieces;
  const std::size_t blocks = (n - 1 + kBlock - 1) / kBlock;
  const auto blockEnd = [n](std::size_t block) { return std::min(n, 1 + (block + 1) * kBlock); };
  for (std::size_t block = blocks; block-- > 0;) {
    context.check();
    const std::size_t begin = 1 + block * kBlock;
    detail::fillPieces(path, limits, begin, blockEnd(block), pieces);
    detail::reachBackward(pieces, begin, blockEnd(block), before, after);
  }
  before[0] = 0.0;
  after[0] = 0.0;
  double previous = 0.0;
  for (std::size_t block = 0; block < blocks; ++block) {
    context.check();
    const std::size_t begin = 1 + block * kBlock;
    const std::size_t end = blockEnd(block);
    if (blocks > 1) {
      detail::fillPieces(path, limits, begin, end, pieces);
    }
    detail::reachForward(pieces, begin, end, previous, before, after);
    const double last = after[end - 1];
    law.duration = putLaw(pieces, begin, end, previous, law.duration, law);
    previous = last;
  }
  return law;
}

/// The least cap within `reach` before and after each node: what an average over time may still
/// see.
void widenCaps(const SpeedPath& path, double reach, SpeedPieces& pieces) {
  const std::size_t n = path.size();
  std::vector<double> at(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    at[i] = at[i - 1] + path.length[i];
  }
  std::vector<double> least(n, 0.0);
  // Segments and zones as places with a cap: the lesser of both counts for the segment.
  std::vector<double> own(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    own[i] = pieces.cap[i];
    if (i + 1 < n) {
      own[i] = std::min(own[i], pieces.zoneCap[i]);
    }
    if (i > 1) {
      own[i] = std::min(own[i], pieces.zoneCap[i - 1]);
    }
  }
  std::deque<std::size_t> window;
  std::size_t next = 1;
  for (std::size_t i = 1; i < n; ++i) {
    while (next < n && at[next - 1] <= at[i] + reach) {
      while (!window.empty() && own[window.back()] >= own[next]) {
        window.pop_back();
      }
      window.push_back(next++);
    }
    while (at[window.front()] < at[i - 1] - reach) {
      window.pop_front();
    }
    least[i] = own[window.front()];
  }
  for (std::size_t i = 1; i < n; ++i) {
    pieces.cap[i] = least[i];
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    pieces.zoneCap[i] = std::min(least[i], least[i + 1]);
  }
}

/// Time in which a joint that moves builds up its acceleration; 0 without jerk limits.
double jerkTime(const SpeedPath& path, const SpeedLimits& limits) {
  const auto joints = static_cast<std::size_t>(path.joints);
  double time = 0.0;
  for (std::size_t j = 0; j < joints; ++j) {
    const JointBounds& bounds = limits.joints[j];
    if (!std::isfinite(bounds.jerk) || !std::isfinite(bounds.acceleration)) {
      continue;
    }
    bool moves = false;
    for (std::size_t i = 1; i < path.size() && !moves; ++i) {
      moves = path.q[i * joints + j] != path.q[j];
    }
    time = moves ? std::max(time, bounds.acceleration / bounds.jerk) : time;
  }
  return time;
}

void slowDown(double factor, SpeedLaw& law) {
  for (double& time : law.time) {
    time *= factor;
  }
  for (double& speed : law.speed) {
    speed /= factor;
  }
  law.duration *= factor;
}

/// One attempt with a given window of the average.
detail::FilteredLaw filteredLaw(const SpeedPath& path,
                                const SpeedLimits& limits,
                                double window,
                                const JobContext& context) {
  context.check();
  SpeedPieces pieces = detail::makePieces(path, limits);
  const double fastest = std::sqrt(*std::max_element(pieces.cap.begin(), pieces.cap.end()));
  const SpeedPieces free = pieces;
  widenCaps(path, fastest * window, pieces);
  SpeedNodes nodes{std::vector<double>(path.size()), std::vector<double>(path.size())};
  detail::reachSpeeds(pieces, nodes);
  std::vector<detail::SpeedInterval> intervals;
  std::vector<std::size_t> marks;
  detail::speedIntervals(pieces, nodes, intervals, marks);
  return detail::averageLaw(path, limits, free, intervals, window, context);
}

/// The average over the jerk time; once more with a longer one where accelerations change sign
/// faster than that; what is left is slowed down as a whole.
SpeedLaw jerkLimited(const SpeedPath& path,
                     const SpeedLimits& limits,
                     double window,
                     const JobContext& context) {
  detail::FilteredLaw result = filteredLaw(path, limits, window, context);
  constexpr double kTwice = 2.0;
  if (result.jerkShare > kMet) {
    detail::FilteredLaw longer =
        filteredLaw(path, limits, window * std::min(result.jerkShare, kTwice), context);
    const double first = std::cbrt(std::max(result.jerkShare, 1.0)) * result.law.duration;
    const double second = std::cbrt(std::max(longer.jerkShare, 1.0)) * longer.law.duration;
    if (second < first) {
      result = std::move(longer);
    }
  }
  const double factor = std::max(
      {1.0, result.speedShare, std::sqrt(result.accelerationShare), std::cbrt(result.jerkShare)});
  if (factor > kMet) {
    slowDown(factor, result.law);
  }
  return result.law;
}

/// Points at which the path stops, its two ends with them: an average over time would pass them.
std::vector<std::size_t> stopsOf(const SpeedPath& path, const SpeedLimits& limits) {
  const SpeedPieces pieces = detail::makePieces(path, limits);
  std::vector<std::size_t> stops = {0};
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    if (pieces.zoneCap[i] == 0.0) {
      stops.push_back(i);
    }
  }
  stops.push_back(path.size() - 1);
  return stops;
}

SpeedPath part(const SpeedPath& path, std::size_t from, std::size_t to) {
  const auto cut = [](const std::vector<double>& v, std::size_t begin, std::size_t end) {
    return std::vector<double>(v.begin() + static_cast<std::ptrdiff_t>(begin),
                               v.begin() + static_cast<std::ptrdiff_t>(end));
  };
  const auto joints = static_cast<std::size_t>(path.joints);
  return {path.joints, cut(path.q, from * joints, (to + 1) * joints),
          cut(path.length, from, to + 1), cut(path.speed, from, to + 1)};
}

SpeedLaw jerkLimitedBetweenStops(const SpeedPath& path,
                                 const SpeedLimits& limits,
                                 const JobContext& context) {
  const std::vector<std::size_t> stops = stopsOf(path, limits);
  SpeedLaw law;
  law.time.assign(path.size(), 0.0);
  law.speed.assign(path.size(), 0.0);
  for (std::size_t k = 1; k < stops.size(); ++k) {
    const SpeedPath piece = part(path, stops[k - 1], stops[k]);
    SpeedLimits own = limits;
    if (!limits.tangents.empty()) {
      own.tangents.assign(
          limits.tangents.begin() + static_cast<std::ptrdiff_t>(3 * stops[k - 1]),
          limits.tangents.begin() + static_cast<std::ptrdiff_t>(3 * (stops[k] + 1)));
    }
    const double window = jerkTime(piece, own);
    const SpeedLaw found = window > 0.0 ? jerkLimited(piece, own, window, context)
                                        : accelerationLimited(piece, own, context);
    for (std::size_t i = 1; i < piece.size(); ++i) {
      law.time[stops[k - 1] + i] = law.duration + found.time[i];
      law.speed[stops[k - 1] + i] = found.speed[i];
    }
    law.duration += found.duration;
  }
  return law;
}

}  // namespace

SpeedLaw speedLaw(const SpeedPath& path, const SpeedLimits& limits, const JobContext& context) {
  const std::size_t n = path.size();
  WCAM_ASSERT(path.joints >= 0 && path.joints <= SpeedPath::kMaxJoints);
  WCAM_ASSERT(path.q.size() == n * static_cast<std::size_t>(path.joints));
  WCAM_ASSERT(limits.joints.size() == static_cast<std::size_t>(path.joints));
  if (n < 2) {
    return {std::vector<double>(n, 0.0), std::vector<double>(n, 0.0), 0.0};
  }
  return jerkTime(path, limits) > 0.0 ? jerkLimitedBetweenStops(path, limits, context)
                                      : accelerationLimited(path, limits, context);
}

double restToRest(double distance, const JointBounds& bounds) {
  const double d = std::abs(distance);
  if (d == 0.0) {
    return 0.0;
  }
  const double v = bounds.speed;
  const double a = bounds.acceleration;
  const double j = bounds.jerk;
  if (!std::isfinite(a) && !std::isfinite(j)) {
    return std::isfinite(v) ? d / v : 0.0;
  }
  // Time to reach a speed from rest; twice the way there is speed × time.
  const auto rise = [a, j](double speed) {
    if (!std::isfinite(j)) {
      return speed / a;
    }
    const double knee = std::isfinite(a) ? a * a / j : std::numeric_limits<double>::infinity();
    return speed >= knee ? speed / a + a / j : 2.0 * std::sqrt(speed / j);
  };
  double top = std::min(v, detail::kMostSpeed);
  if (top * rise(top) > d) {
    // The speed at which both ramps make the whole way: monotone, found by halving.
    double low = 0.0;
    constexpr int kHalvings = 200;
    for (int i = 0; i < kHalvings && low < top; ++i) {
      const double middle = 0.5 * (low + top);
      if (middle <= low || middle >= top) {
        break;
      }
      (middle * rise(middle) > d ? top : low) = middle;
    }
  }
  return d / top + rise(top);
}

}  // namespace wcam::motion
