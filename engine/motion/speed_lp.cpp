// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "speed_law_detail.hpp"

#include <algorithm>
#include <cmath>

// Vectorised for the processor found at run time. Products, sums and extremes only, without
// contraction: the same bits on every processor.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define WCAM_CLONES __attribute__((target_clones("default", "avx2", "arch=skylake-avx512")))
#else
#define WCAM_CLONES
#endif

namespace wcam::motion::detail {

namespace {

/// A factor of x at the zone's end that is smaller than this part of the bound over the greatest x
/// there does not bind it.
constexpr double kNoFactor = 1e-13;
constexpr int kMaxNewton = 64;

/// The acceleration of joint j in a zone of length ℓ from slope k0 to k1 with x from a to b is
/// (q' s̈ + q'' x) = (k·(b − a) + 2·(k1 − k0)·x) / (2ℓ): linear in s, extreme at the ends.
struct ZoneRows {
  const double* k0;
  const double* k1;
  double bound;  ///< 2ℓ
};

template <int W>
inline bool fits(const ZoneRows& rows, double a, double b) {
  const double step = b - a;
  double worst[W];
  for (int j = 0; j < W; ++j) {
    const double turn = 2.0 * (rows.k1[j] - rows.k0[j]);
    const double atStart = std::abs(rows.k0[j] * step + turn * a);
    const double atEnd = std::abs(rows.k1[j] * step + turn * b);
    worst[j] = atStart > atEnd ? atStart : atEnd;
  }
  double most = 0.0;
  for (int j = 0; j < W; ++j) {
    most = worst[j] > most ? worst[j] : most;
  }
  return most <= rows.bound;
}

/// Bounds of b at a given a: low(a) ≤ b ≤ high(a), each the extreme of lines, with their slopes.
struct EndRange {
  double low = 0.0;
  double lowSlope = 0.0;
  double high = 0.0;
  double highSlope = 0.0;
  double greatestStart = 0.0;  ///< of a, by rows without b
};

/// One strip |alpha·a + beta·b| ≤ bound.
inline void addStrip(
    double alpha, double beta, double bound, double a, double top, EndRange& range) {
  if (std::abs(beta) * top <= kNoFactor * bound) {
    if (std::abs(alpha) * range.greatestStart > bound) {
      range.greatestStart = bound / std::abs(alpha);
    }
    return;
  }
  const double slope = -alpha / beta;
  const double half = bound / std::abs(beta);
  const double centre = slope * a;
  if (centre + half < range.high) {
    range.high = centre + half;
    range.highSlope = slope;
  }
  if (centre - half > range.low) {
    range.low = centre - half;
    range.lowSlope = slope;
  }
}

template <int W>
inline EndRange endRange(const ZoneRows& rows, double a, double top, double greatestStart) {
  EndRange range;
  range.high = top;
  range.greatestStart = greatestStart;
  for (int j = 0; j < W; ++j) {
    const double k0 = rows.k0[j];
    const double k1 = rows.k1[j];
    if (k0 == 0.0 && k1 == 0.0) {
      continue;
    }
    addStrip(2.0 * k1 - 3.0 * k0, k0, rows.bound, a, top, range);
    addStrip(-k1, 3.0 * k1 - 2.0 * k0, rows.bound, a, top, range);
  }
  return range;
}

/// Greatest x at the zone's start, at most `cap`, from which the end can be met below `top`. The
/// gap high − low is concave in a and not negative at 0: Newton steps from the right end in its
/// zero.
template <int W>
inline double greatestStart(const ZoneRows& rows, double cap, double top) {
  if (fits<W>(rows, cap, top)) {
    return cap;
  }
  double a = cap;
  for (int step = 0; step < kMaxNewton; ++step) {
    const EndRange range = endRange<W>(rows, a, top, cap);
    if (range.greatestStart < a) {
      a = range.greatestStart;
      continue;
    }
    const double gap = range.high - range.low;
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

template <int W>
inline double greatestEnd(const ZoneRows& rows, double start, double top) {
  if (fits<W>(rows, start, top)) {
    return top;
  }
  const EndRange range = endRange<W>(rows, start, top, start);
  return std::max({range.high, std::min(range.low, top), 0.0});
}

template <int W>
inline void reach(const SpeedPieces& p, SpeedNodes& nodes) {
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
      nodes.before[i - 1] = greatestStart<W>(rows, p.zoneCap[i - 1], after);
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

WCAM_CLONES void reach4(const SpeedPieces& pieces, SpeedNodes& nodes) {
  reach<4>(pieces, nodes);
}

WCAM_CLONES void reach8(const SpeedPieces& pieces, SpeedNodes& nodes) {
  reach<8>(pieces, nodes);
}

WCAM_CLONES void reach12(const SpeedPieces& pieces, SpeedNodes& nodes) {
  reach<12>(pieces, nodes);
}

}  // namespace

void reachSpeeds(const SpeedPieces& pieces, SpeedNodes& nodes) {
  if (pieces.width == 4) {
    reach4(pieces, nodes);
  } else if (pieces.width == 8) {
    reach8(pieces, nodes);
  } else {
    reach12(pieces, nodes);
  }
}

}  // namespace wcam::motion::detail
