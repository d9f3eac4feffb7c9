// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/vector_clones.hpp"

#include "speed_law_detail.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

/// A factor of x at the zone's end that is smaller than this part of the bound over the greatest x
/// there does not bind it.
constexpr double kNoFactor = 1e-13;
constexpr int kMaxNewton = 64;
/// First guess of a zone's result over that of its neighbour.
constexpr double kBeyond = 1.02;
/// Half width of a strip that binds nothing.
constexpr double kUnbound = 1e300;

/// The acceleration of joint j in a zone of length ℓ from slope k0 to k1 with x from a to b is
/// (q' s̈ + q'' x) = (k·(b − a) + 2·(k1 − k0)·x) / (2ℓ): linear in s, extreme at the ends.
struct ZoneRows {
  const double* k0;
  const double* k1;
  double bound;  ///< 2ℓ
};

template <int W>
WCAM_CLONED bool fits(const ZoneRows& rows, double a, double b) {
  const double step = b - a;
  double worst[W];
  for (int j = 0; j < W; ++j) {
    const double turn = 2.0 * (rows.k1[j] - rows.k0[j]);
    const double atStart = std::abs(rows.k0[j] * step + turn * a);
    const double atEnd = std::abs(rows.k1[j] * step + turn * b);
    worst[j] = atStart > atEnd ? atStart : atEnd;
  }
  for (int n = W / 2; n > 0; n /= 2) {
    for (int j = 0; j < n; ++j) {
      worst[j] = worst[j] > worst[j + n] ? worst[j] : worst[j + n];
    }
  }
  return worst[0] <= rows.bound;
}

/// The rows of a zone as strips |b − slope·a| ≤ half of the plane of x at its start and its end.
/// Rows that the end hardly enters bound the start alone.
template <int W>
struct Strips {
  static constexpr int kCount = 2 * W;
  double slope[kCount];
  double half[kCount];
  double greatestStart = 0.0;

  WCAM_CLONED Strips(const ZoneRows& rows, double start, double top) : greatestStart(start) {
    double alpha[kCount];
    double beta[kCount];
    for (int j = 0; j < W; ++j) {
      alpha[j] = 2.0 * rows.k1[j] - 3.0 * rows.k0[j];
      beta[j] = rows.k0[j];
      alpha[W + j] = -rows.k1[j];
      beta[W + j] = 3.0 * rows.k1[j] - 2.0 * rows.k0[j];
    }
    const double least = kNoFactor * rows.bound;
    double alone[kCount];
    for (int i = 0; i < kCount; ++i) {
      const double size = std::abs(beta[i]);
      const bool enters = size * top > least;
      const double inverse = 1.0 / (enters ? beta[i] : 1.0);
      slope[i] = enters ? -alpha[i] * inverse : 0.0;
      half[i] = enters ? rows.bound * std::abs(inverse) : kUnbound;
      alone[i] = enters ? 0.0 : std::abs(alpha[i]);
    }
    const double most = greatestOf(alone);
    if (most * greatestStart > rows.bound) {
      greatestStart = rows.bound / most;
    }
  }

  static WCAM_CLONED double greatestOf(const double (&v)[kCount]) {
    double lanes[kCount / 2];
    for (int i = 0; i < kCount / 2; ++i) {
      lanes[i] = v[i] > v[i + kCount / 2] ? v[i] : v[i + kCount / 2];
    }
    for (int n = kCount / 4; n > 0; n /= 2) {
      for (int i = 0; i < n; ++i) {
        lanes[i] = lanes[i] > lanes[i + n] ? lanes[i] : lanes[i + n];
      }
    }
    return lanes[0];
  }
};

/// Bounds of the end at a given start, with the slopes of the strips that make them.
struct EndRange {
  double low = 0.0;
  double lowSlope = 0.0;
  double high = 0.0;
  double highSlope = 0.0;
};

template <int W>
WCAM_CLONED EndRange endRange(const Strips<W>& strips, double start, double top) {
  // Extremes in a tree of lanes, the slopes carried along.
  constexpr int kHalf = W;
  double high[kHalf];
  double highSlope[kHalf];
  double low[kHalf];
  double lowSlope[kHalf];
  for (int i = 0; i < kHalf; ++i) {
    const double a = strips.slope[i];
    const double b = strips.slope[i + kHalf];
    const double highA = a * start + strips.half[i];
    const double highB = b * start + strips.half[i + kHalf];
    const double lowA = a * start - strips.half[i];
    const double lowB = b * start - strips.half[i + kHalf];
    high[i] = highA < highB ? highA : highB;
    highSlope[i] = highA < highB ? a : b;
    low[i] = lowA > lowB ? lowA : lowB;
    lowSlope[i] = lowA > lowB ? a : b;
  }
  for (int n = kHalf / 2; n > 0; n /= 2) {
    for (int i = 0; i < n; ++i) {
      highSlope[i] = high[i] < high[i + n] ? highSlope[i] : highSlope[i + n];
      high[i] = high[i] < high[i + n] ? high[i] : high[i + n];
      lowSlope[i] = low[i] > low[i + n] ? lowSlope[i] : lowSlope[i + n];
      low[i] = low[i] > low[i + n] ? low[i] : low[i + n];
    }
  }
  return {low[0] > 0.0 ? low[0] : 0.0, low[0] > 0.0 ? lowSlope[0] : 0.0,
          high[0] < top ? high[0] : top, high[0] < top ? highSlope[0] : 0.0};
}

/// Greatest x at the zone's start, at most `cap`, from which the end can be met below `top`. The
/// gap high − low is concave in the start and not negative at 0: Newton steps from the right
/// towards its zero, from a little beyond the neighbouring zone's result where the zero lies before
/// it.
template <int W>
WCAM_CLONED double greatestStart(const ZoneRows& rows, double cap, double top, double near) {
  if (fits<W>(rows, cap, top)) {
    return cap;
  }
  const Strips<W> strips(rows, cap, top);
  const double rightEnd = strips.greatestStart;
  bool guessed = near * kBeyond < rightEnd;
  double a = guessed ? near * kBeyond : rightEnd;
  for (int step = 0; step < kMaxNewton; ++step) {
    const EndRange range = endRange<W>(strips, a, top);
    const double gap = range.high - range.low;
    if (gap >= 0.0 && guessed) {
      a = rightEnd;  // the guess was before the zero
      guessed = false;
      continue;
    }
    guessed = false;
    if (gap >= 0.0) {
      return a;
    }
    const double slope = range.highSlope - range.lowSlope;
    const double next = slope < 0.0 ? a - gap / slope : 0.0;
    if (!(next < a)) {
      return a;  // rounding: the zero is here
    }
    a = std::max(next, 0.0);
  }
  return 0.0;
}

/// Greatest x at the zone's end, at most `top`, after a start from which there is one.
template <int W>
WCAM_CLONED double greatestEnd(const ZoneRows& rows, double start, double top) {
  if (fits<W>(rows, start, top)) {
    return top;
  }
  const EndRange range = endRange<W>(Strips<W>(rows, start, top), start, top);
  return std::max({range.high, std::min(range.low, top), 0.0});
}

template <int W>
WCAM_CLONED void reach(const SpeedPieces& p, SpeedNodes& nodes) {
  const std::size_t n = p.cap.size();
  const double* slope = p.slope.data();
  nodes.before[n - 1] = 0.0;
  nodes.after[n - 1] = 0.0;
  for (std::size_t i = n - 1; i > 0; --i) {
    const double reached = nodes.before[i] + 2.0 * p.gain[i] * p.straight[i];
    const double after = std::min({p.zoneCap[i - 1], p.cap[i], reached});
    nodes.after[i - 1] = after;
    if (p.zone[i - 1] > 0.0) {
      const ZoneRows rows{slope + (i - 1) * W, slope + i * W, 2.0 * p.zone[i - 1]};
      nodes.before[i - 1] = greatestStart<W>(rows, p.zoneCap[i - 1], after, nodes.before[i]);
    } else {
      nodes.before[i - 1] = after;
    }
  }
  nodes.before[0] = 0.0;
  nodes.after[0] = 0.0;
  for (std::size_t i = 1; i < n; ++i) {
    const double reached = nodes.after[i - 1] + 2.0 * p.gain[i] * p.straight[i];
    const double before = std::min(nodes.before[i], reached);
    nodes.before[i] = before;
    if (p.zone[i] > 0.0) {
      const ZoneRows rows{slope + i * W, slope + (i + 1) * W, 2.0 * p.zone[i]};
      nodes.after[i] = greatestEnd<W>(rows, before, nodes.after[i]);
    } else {
      nodes.after[i] = std::min(before, nodes.after[i]);
    }
  }
}

}  // namespace

WCAM_VECTOR_CLONES void reachSpeeds(const SpeedPieces& pieces, SpeedNodes& nodes) {
  if (pieces.width == 4) {
    reach<4>(pieces, nodes);
  } else if (pieces.width == 8) {
    reach<8>(pieces, nodes);
  } else {
    reach<16>(pieces, nodes);
  }
}

}  // namespace wcam::motion::detail
