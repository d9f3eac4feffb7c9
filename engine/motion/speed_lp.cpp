// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "speed_law_detail.hpp"
#include "speed_rows.hpp"

#include <algorithm>

// Rows are never passed to a function that is not inlined.
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace wcam::motion::detail {

namespace {

/// A factor of x at the zone's end that is smaller than this part of the bound over the greatest x
/// there does not bind it.
constexpr double kNoFactor = 1e-13;
constexpr int kMaxNewton = 64;
/// First guess of a zone's result over what the two zones after it lead to expect.
constexpr double kBeyond = 1.005;
/// A change from zone to zone that is greater says nothing of the next one.
constexpr double kMostTrend = 2.0;
/// Half width of a strip that binds nothing.
constexpr double kUnbound = 1e300;

/// The acceleration of joint j in a zone of length ℓ from slope k0 to k1 with x from a to b is
/// (q' s̈ + q'' x) = (k·(b − a) + 2·(k1 − k0)·x) / (2ℓ): linear in s, extreme at the ends.
struct ZoneRows {
  const double* k0;
  const double* k1;
  double bound;  ///< 2ℓ
};

/// Rows of 8 joints each: B of them.
template <int B>
WCAM_CLONED bool fits(const ZoneRows& rows, double a, double b) {
  const double step = b - a;
  Row most{};
  for (int r = 0; r < B; ++r) {
    const Row k0 = loadRow(rows.k0 + r * kRowLanes);
    const Row k1 = loadRow(rows.k1 + r * kRowLanes);
    const Row turn = 2.0 * (k1 - k0);
    most = greater(most, sizeOf(k0 * step + turn * a));
    most = greater(most, sizeOf(k1 * step + turn * b));
  }
  return greatestOf(most) <= rows.bound;
}

/// The rows of a zone as strips |b − slope·a| ≤ half of the plane of x at its start and its end.
/// Rows that the end hardly enters bound the start alone.
template <int B>
struct Strips {
  static constexpr int kRows = 2 * B;
  Row slope[kRows];
  Row half[kRows];
  double greatestStart = 0.0;

  WCAM_CLONED Strips(const ZoneRows& rows, double start, double top) : greatestStart(start) {
    Row most{};
    for (int r = 0; r < B; ++r) {
      const Row k0 = loadRow(rows.k0 + r * kRowLanes);
      const Row k1 = loadRow(rows.k1 + r * kRowLanes);
      most = greater(most, add(r, 2.0 * k1 - 3.0 * k0, k0, rows.bound, top));
      most = greater(most, add(B + r, -k1, 3.0 * k1 - 2.0 * k0, rows.bound, top));
    }
    const double greatest = greatestOf(most);
    if (greatest * greatestStart > rows.bound) {
      greatestStart = rows.bound / greatest;
    }
  }

private:
  /// @return the sizes of alpha of the joints that bound the start alone
  WCAM_CLONED Row add(int r, const Row& alpha, const Row& beta, double bound, double top) {
    const RowBits enters = sizeOf(beta) * top > kNoFactor * bound;
    const Row inverse = 1.0 / (enters ? beta : Row{} + 1.0);
    slope[r] = enters ? -alpha * inverse : Row{};
    half[r] = enters ? bound * sizeOf(inverse) : Row{} + kUnbound;
    return enters ? Row{} : sizeOf(alpha);
  }
};

/// Bounds of the end at a given start, with the slopes of the strips that make them.
struct EndRange {
  double low = 0.0;
  double lowSlope = 0.0;
  double high = 0.0;
  double highSlope = 0.0;
};

/// Values with the slopes that belong to them; the lesser of two.
struct SlopedRow {
  Row value;
  Row slope;

  WCAM_CLONED void keepLesser(const SlopedRow& other) {
    const RowBits own = value < other.value;
    value = own ? value : other.value;
    slope = own ? slope : other.slope;
  }

  /// All lanes become the least one.
  WCAM_CLONED void spreadLeast() {
    keepLesser({__builtin_shufflevector(value, value, 4, 5, 6, 7, 0, 1, 2, 3),
                __builtin_shufflevector(slope, slope, 4, 5, 6, 7, 0, 1, 2, 3)});
    keepLesser({__builtin_shufflevector(value, value, 2, 3, 0, 1, 6, 7, 4, 5),
                __builtin_shufflevector(slope, slope, 2, 3, 0, 1, 6, 7, 4, 5)});
    keepLesser({__builtin_shufflevector(value, value, 1, 0, 3, 2, 5, 4, 7, 6),
                __builtin_shufflevector(slope, slope, 1, 0, 3, 2, 5, 4, 7, 6)});
  }
};

template <int B>
WCAM_CLONED EndRange endRange(const Strips<B>& strips, double start, double top) {
  // The lower bounds with the other sign, so that both look for the least.
  SlopedRow high{strips.slope[0] * start + strips.half[0], strips.slope[0]};
  SlopedRow low{strips.half[0] - strips.slope[0] * start, -strips.slope[0]};
  for (int r = 1; r < Strips<B>::kRows; ++r) {
    const Row way = strips.slope[r] * start;
    high.keepLesser({way + strips.half[r], strips.slope[r]});
    low.keepLesser({strips.half[r] - way, -strips.slope[r]});
  }
  high.spreadLeast();
  low.spreadLeast();
  const double least = -low.value[0];
  const double most = high.value[0];
  return {least > 0.0 ? least : 0.0, least > 0.0 ? -low.slope[0] : 0.0, most < top ? most : top,
          most < top ? high.slope[0] : 0.0};
}

/// Greatest x at the zone's start, at most `cap`, from which the end can be met below `top`. The
/// gap high − low is concave in the start and not negative at 0: Newton steps from the right
/// towards its zero, from a little beyond what is expected where the zero lies before it.
/// @param endCap what `top` never exceeds: the strips do not depend on the zone after this one, so
/// that the processor makes them while it still works on that
template <int B>
WCAM_CLONED double greatestStart(
    const ZoneRows& rows, double cap, double endCap, double top, double expected) {
  if (fits<B>(rows, cap, top)) {
    return cap;
  }
  const Strips<B> strips(rows, cap, endCap);
  const double rightEnd = strips.greatestStart;
  bool guessed = expected * kBeyond < rightEnd;
  double a = guessed ? expected * kBeyond : rightEnd;
  for (int step = 0; step < kMaxNewton; ++step) {
    const EndRange range = endRange<B>(strips, a, top);
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
template <int B>
WCAM_CLONED double greatestEnd(const ZoneRows& rows, double start, double top) {
  if (fits<B>(rows, start, top)) {
    return top;
  }
  const EndRange range = endRange<B>(Strips<B>(rows, start, top), start, top);
  return std::max({range.high, std::min(range.low, top), 0.0});
}

template <int B>
WCAM_CLONED void backward(
    const SpeedPieces& p, std::size_t begin, std::size_t end, double* before, double* after) {
  constexpr std::size_t kWidth = B * kRowLanes;
  const double* slope = p.slope.data();
  double trend = 1.0;  // of x from one point to the one before it
  for (std::size_t i = end - 1; i >= begin; --i) {
    const std::size_t k = i - p.first;
    const double reached = before[i] + 2.0 * p.gain[k] * p.straight[k];
    const double top = std::min({p.zoneCap[k - 1], p.cap[k], reached});
    after[i - 1] = top;
    if (p.zone[k - 1] > 0.0) {
      const ZoneRows rows{slope + (k - 1) * kWidth, slope + k * kWidth, 2.0 * p.zone[k - 1]};
      before[i - 1] = greatestStart<B>(rows, p.zoneCap[k - 1], p.cap[k], top, before[i] * trend);
    } else {
      before[i - 1] = top;
    }
    const double change = before[i - 1] / before[i];
    trend = change > 1.0 / kMostTrend && change < kMostTrend ? change : 1.0;
  }
}

template <int B>
WCAM_CLONED void forward(const SpeedPieces& p,
                         std::size_t begin,
                         std::size_t end,
                         double previous,
                         double* before,
                         double* after) {
  constexpr std::size_t kWidth = B * kRowLanes;
  const double* slope = p.slope.data();
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t k = i - p.first;
    const double start = std::min(before[i], previous + 2.0 * p.gain[k] * p.straight[k]);
    before[i] = start;
    if (p.zone[k] > 0.0) {
      const ZoneRows rows{slope + k * kWidth, slope + (k + 1) * kWidth, 2.0 * p.zone[k]};
      previous = greatestEnd<B>(rows, start, after[i]);
    } else {
      previous = std::min(start, after[i]);
    }
    after[i] = previous;
  }
}

}  // namespace

WCAM_VECTOR_CLONES void reachBackward(
    const SpeedPieces& pieces, std::size_t begin, std::size_t end, double* before, double* after) {
  if (pieces.width == kRowLanes) {
    backward<1>(pieces, begin, end, before, after);
  } else {
    backward<2>(pieces, begin, end, before, after);
  }
}

WCAM_VECTOR_CLONES void reachForward(const SpeedPieces& pieces,
                                     std::size_t begin,
                                     std::size_t end,
                                     double previous,
                                     double* before,
                                     double* after) {
  if (pieces.width == kRowLanes) {
    forward<1>(pieces, begin, end, previous, before, after);
  } else {
    forward<2>(pieces, begin, end, previous, before, after);
  }
}

void reachSpeeds(const SpeedPieces& pieces, SpeedNodes& nodes) {
  const std::size_t n = pieces.cap.size();
  nodes.before[n - 1] = 0.0;
  nodes.after[n - 1] = 0.0;
  reachBackward(pieces, 1, n, nodes.before.data(), nodes.after.data());
  nodes.before[0] = 0.0;
  nodes.after[0] = 0.0;
  reachForward(pieces, 1, n, 0.0, nodes.before.data(), nodes.after.data());
}

}  // namespace wcam::motion::detail
