// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

/// The inner loops of the graph search on plain arrays. Private to this module. Compiled once per
/// instruction set; no reduction crosses lanes, so every set gives the same result.
namespace wcam::motion::detail {

/// Rows of a state: six joints and the cable's twist.
inline constexpr int kSearchRows = 7;

/// Cost of a step per row: weight·Δ², and a penalty where a row goes faster than it can.
struct StepCost {
  float weight[kSearchRows];
  float inverseSpeed2[kSearchRows];  ///< 1/(greatest step)²
  bool wraps[kSearchRows];           ///< a difference of a full turn is none
  float tooFast;                     ///< penalty per (step/greatest step)², from 1 on
};

/// best[n] = min over candidates of base + cost of the step from `from` row lane n to `to` lane n;
/// choice[n] = `candidate` where this one is better.
void relaxLanes(const float* const* to,
                const float* const* from,
                const float* fromCost,
                float base,
                const StepCost& cost,
                int lanes,
                std::int32_t candidate,
                float* best,
                std::int32_t* choice);

/// The same from one state to all lanes.
void relaxFromOne(const float* const* to,
                  const float* from,
                  float base,
                  const StepCost& cost,
                  int lanes,
                  std::int32_t candidate,
                  float* best,
                  std::int32_t* choice);

}  // namespace wcam::motion::detail
