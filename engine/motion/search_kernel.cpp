// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Includes nothing with inline functions that other files use too: it is compiled with options of
// its own (no traps, no errno; the arithmetic stays strict).

#include "search_kernel.hpp"

// One clone per instruction set, chosen at load time. Sanitizers do not stand the resolvers.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define WCAM_VECTOR_CLONES \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define WCAM_VECTOR_CLONES
#endif

namespace wcam::motion::detail {

namespace {

constexpr float kHalfTurn = 3.14159265F;
constexpr float kFullTurn = 6.28318531F;
/// A speed beyond this many times the greatest is as bad as any.
constexpr float kWorst = 16.0F;

/// Lanes worked on at a time: the sums stay in registers and the first cache level.
constexpr int kBlock = 96;

}  // namespace

#define WCAM_INLINE static inline __attribute__((always_inline))

/// Adds the rows' costs of one block.
WCAM_INLINE void addRow(const float* to,
                        const float* from,
                        int fromStride,
                        const StepCost& cost,
                        int row,
                        int count,
                        float* sum,
                        float* fastest) {
  const float weight = cost.weight[row];
  const float inverse = cost.inverseSpeed2[row];
  if (cost.wraps[row]) {
    for (int n = 0; n < count; ++n) {
      float d = to[n] - from[n * fromStride];
      d = d > kHalfTurn ? d - kFullTurn : d;
      d = d < -kHalfTurn ? d + kFullTurn : d;
      const float square = d * d;
      sum[n] += weight * square;
      const float ratio = inverse * square;
      fastest[n] = ratio > fastest[n] ? ratio : fastest[n];
    }
  } else {
    for (int n = 0; n < count; ++n) {
      const float d = to[n] - from[n * fromStride];
      const float square = d * d;
      sum[n] += weight * square;
      const float ratio = inverse * square;
      fastest[n] = ratio > fastest[n] ? ratio : fastest[n];
    }
  }
}

WCAM_INLINE void keepBest(const float* sum,
                          const float* fastest,
                          float tooFast,
                          int count,
                          std::int32_t candidate,
                          float* best,
                          std::int32_t* choice) {
  for (int n = 0; n < count; ++n) {
    const float over = fastest[n] > kWorst ? kWorst : fastest[n];
    const float total = sum[n] + (fastest[n] > 1.0F ? tooFast * over : 0.0F);
    const bool better = total < best[n];
    best[n] = better ? total : best[n];
    choice[n] = better ? candidate : choice[n];
  }
}

WCAM_VECTOR_CLONES void relaxLanes(const float* const* to,
                                   const float* const* from,
                                   const float* fromCost,
                                   float base,
                                   const StepCost& cost,
                                   int lanes,
                                   std::int32_t candidate,
                                   float* best,
                                   std::int32_t* choice) {
  for (int begin = 0; begin < lanes; begin += kBlock) {
    const int count = lanes - begin < kBlock ? lanes - begin : kBlock;
    alignas(64) float sum[kBlock];
    alignas(64) float fastest[kBlock];
    for (int n = 0; n < count; ++n) {
      sum[n] = fromCost[begin + n] + base;
      fastest[n] = 0.0F;
    }
    for (int row = 0; row < kSearchRows; ++row) {
      if (to[row] != nullptr) {
        addRow(to[row] + begin, from[row] + begin, 1, cost, row, count, sum, fastest);
      }
    }
    keepBest(sum, fastest, cost.tooFast, count, candidate, best + begin, choice + begin);
  }
}

WCAM_VECTOR_CLONES void relaxFromOne(const float* const* to,
                                     const float* from,
                                     float base,
                                     const StepCost& cost,
                                     int lanes,
                                     std::int32_t candidate,
                                     float* best,
                                     std::int32_t* choice) {
  for (int begin = 0; begin < lanes; begin += kBlock) {
    const int count = lanes - begin < kBlock ? lanes - begin : kBlock;
    alignas(64) float sum[kBlock];
    alignas(64) float fastest[kBlock];
    for (int n = 0; n < count; ++n) {
      sum[n] = base;
      fastest[n] = 0.0F;
    }
    for (int row = 0; row < kSearchRows; ++row) {
      if (to[row] != nullptr) {
        addRow(to[row] + begin, from + row, 0, cost, row, count, sum, fastest);
      }
    }
    keepBest(sum, fastest, cost.tooFast, count, candidate, best + begin, choice + begin);
  }
}

}  // namespace wcam::motion::detail
