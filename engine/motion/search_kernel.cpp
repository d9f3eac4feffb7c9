// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Includes nothing with inline functions that other files use too: it is compiled with options of
// its own (no traps, no errno, no infinities; sums and products stay strict).

#include "search_kernel.hpp"

#include "wcam/base/vector_clones.hpp"

// The vectors are never passed to a function that is not inlined.
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace wcam::motion::detail {

namespace {

constexpr float kHalfTurn = 3.14159265F;
constexpr float kFullTurn = 6.28318531F;
constexpr int kBranches = 8;
/// No angle comes near: the difference of a row that does not wrap is never folded.
constexpr float kNoTurn = 1e30F;
/// A speed beyond this many times the greatest is as bad as any.
constexpr float kWorst = 16.0F;

/// One block of lanes. The compiler splits it where the registers are narrower.
using Lanes = float __attribute__((vector_size(kLaneBlock * sizeof(float))));
using Bits = std::int32_t __attribute__((vector_size(kLaneBlock * sizeof(std::int32_t))));

}  // namespace

static WCAM_CLONED Lanes load(const float* from) {
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

static WCAM_CLONED Lanes spread(float value) {
  const Lanes first{value};
  return __builtin_shufflevector(first, first, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
}

/// The sources one after the other for each block of lanes: the states to reach, the best costs and
/// the choices stay in registers. `kRows`: the first rows are used; `kOne`: a source is one state,
/// not one for each lane.
template <int kRows, bool kOne>
static WCAM_CLONED void relaxRows(const float* const* to,
                                  const StepSource* sources,
                                  int sourceCount,
                                  const StepCost& cost,
                                  int lanes,
                                  float* best,
                                  std::int32_t* choice) {
  float turn[kRows];
  for (int row = 0; row < kRows; ++row) {
    turn[row] = cost.wraps[row] ? kFullTurn : kNoTurn;
  }
  const Lanes worst = spread(kWorst);
  for (int begin = 0; begin < lanes; begin += kLaneBlock) {
    Lanes least = load(best + begin);
    Bits chosen;
    __builtin_memcpy(&chosen, choice + begin, sizeof chosen);
    Lanes target[kRows];
#pragma GCC unroll 8
    for (int row = 0; row < kRows; ++row) {
      target[row] = load(to[row] + begin);
    }
    for (int s = 0; s < sourceCount; ++s) {
      const StepSource& source = sources[s];
      Lanes sum = spread(source.base);
      sum += kOne ? spread(source.cost[0]) : load(source.cost + begin);
      Lanes fastest{};
#pragma GCC unroll 8
      for (int row = 0; row < kRows; ++row) {
        const Lanes from = kOne ? spread(source.rows[row][0]) : load(source.rows[row] + begin);
        const Lanes d = target[row] - from;
        Lanes way = (Lanes)((Bits)d & 0x7fffffff);  // without its sign
        const Lanes other = turn[row] - way;
        way = other < way ? other : way;
        const Lanes square = way * way;
        sum += cost.weight[row] * square;
        const Lanes ratio = cost.inverseSpeed2[row] * square;
        fastest = fastest < ratio ? ratio : fastest;
      }
      const Lanes over = worst < fastest ? worst : fastest;
      sum += fastest > 1.0F ? cost.tooFast * over : Lanes{};
      const Bits better = sum < least;
      least = better ? sum : least;
      chosen = better ? (source.start - Bits{}) : chosen;
    }
    __builtin_memcpy(best + begin, &least, sizeof least);
    __builtin_memcpy(choice + begin, &chosen, sizeof chosen);
  }
}

template <bool kOne>
static WCAM_CLONED void relax(const float* const* to,
                              const StepSource* sources,
                              int sourceCount,
                              const StepCost& cost,
                              int lanes,
                              float* best,
                              std::int32_t* choice) {
  if (to[kSearchRows - 1] == nullptr) {
    relaxRows<kSearchRows - 1, kOne>(to, sources, sourceCount, cost, lanes, best, choice);
  } else {
    relaxRows<kSearchRows, kOne>(to, sources, sourceCount, cost, lanes, best, choice);
  }
}

WCAM_VECTOR_CLONES void relaxLanes(const float* const* to,
                                   const StepSource* sources,
                                   int sourceCount,
                                   const StepCost& cost,
                                   int lanes,
                                   float* best,
                                   std::int32_t* choice) {
  relax<false>(to, sources, sourceCount, cost, lanes, best, choice);
}

WCAM_VECTOR_CLONES void relaxFromStates(const float* const* to,
                                        const StepSource* sources,
                                        int sourceCount,
                                        const StepCost& cost,
                                        int lanes,
                                        float* best,
                                        std::int32_t* choice) {
  relax<true>(to, sources, sourceCount, cost, lanes, best, choice);
}

static WCAM_CLONED float wrapped(float angle) {
  return angle - kFullTurn * __builtin_rintf(angle * (1.0F / kFullTurn));
}

static WCAM_CLONED float absolute(float value) {
  return value < 0.0F ? -value : value;
}

WCAM_VECTOR_CLONES void addRangeCost(const float* row,
                                     const RangeCost& range,
                                     int lanes,
                                     float* cost) {
  const RangeCost r = range;
  const float turn = r.wraps ? kFullTurn : 0.0F;
  for (int n = 0; n < lanes; ++n) {
    const float d = row[n] - r.middle;
    const float beyond = absolute(d - turn * __builtin_rintf(d * (1.0F / kFullTurn))) - r.half;
    const float relative = (beyond + r.half) / r.half;
    cost[n] +=
        r.weight * relative * relative + (beyond > 0.0F ? r.outside + r.beyond * beyond : 0.0F);
  }
}

WCAM_VECTOR_CLONES void addFoldCost(
    const float* rowA, const float* rowB, const FoldCost& fold, int lanes, float* cost) {
  const FoldCost f = fold;
  for (int n = 0; n < lanes; ++n) {
    const float bend = absolute(wrapped(f.gainA * rowA[n] + f.gainB * rowB[n] + f.offset));
    const float near = bend < kHalfTurn - bend ? bend : kHalfTurn - bend;
    cost[n] += near < f.margin ? f.penalty : 0.0F;
  }
}

WCAM_VECTOR_CLONES void addTwistCost(const float* rowA,
                                     const float* rowB,
                                     const TwistCost& twist,
                                     int lanes,
                                     float* row,
                                     float* cost) {
  const TwistCost t = twist;
  for (int n = 0; n < lanes; ++n) {
    row[n] = wrapped(rowA[n] + t.sign * rowB[n] - t.zero);
    const float over = absolute(row[n]) - t.most;
    cost[n] += over > 0.0F ? t.penalty * (1.0F + over) : 0.0F;
  }
}

WCAM_VECTOR_CLONES void addBranchCost(const float* values, int lanes, float* cost) {
  for (int n = 0; n < lanes; n += kBranches) {
    for (int b = 0; b < kBranches; ++b) {
      cost[n + b] += values[b];
    }
  }
}

}  // namespace wcam::motion::detail
