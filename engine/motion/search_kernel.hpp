// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

/// The inner loops of the graph search on plain arrays. Private to this module. Compiled once per
/// instruction set; no reduction crosses lanes, so every set gives the same result.
namespace wcam::motion::detail {

/// Rows of a state: six joints and the cable's twist.
inline constexpr int kSearchRows = 7;
/// Lanes worked on at once: one vector of the widest instruction set.
inline constexpr int kLaneBlock = 16;

/// Cost of a step per row: weight·Δ², and a penalty where a row goes faster than it can.
struct StepCost {
  float weight[kSearchRows];
  float inverseSpeed2[kSearchRows];  ///< 1/(greatest step)²
  bool wraps[kSearchRows];           ///< a difference of a full turn is none
  float tooFast;                     ///< penalty per (step/greatest step)², from 1 on
};

/// States before from which all lanes may be reached: lane n of the rung from lane n of these rows
/// (the last row is null where it is not used), at cost[n] + base.
struct StepSource {
  const float* rows[kSearchRows];
  const float* cost;
  float base;
  std::int32_t start;  ///< number of its lane 0, of the caller's choosing
};

/// best[n] = min(best[n], least cost of a step from lane n of a source to lane n); choice[n] = the
/// `start` of that source. `lanes` is a multiple of kLaneBlock.
void relaxLanes(const float* const* to,
                const StepSource* sources,
                int sourceCount,
                const StepCost& cost,
                int lanes,
                float* best,
                std::int32_t* choice);

/// The same from one state each, to all lanes: rows[r][0], cost[0].
void relaxFromStates(const float* const* to,
                     const StepSource* sources,
                     int sourceCount,
                     const StepCost& cost,
                     int lanes,
                     float* best,
                     std::int32_t* choice);

/// Cost of a joint's place in its range: weight·(relative distance from the middle)², and a penalty
/// beyond the limits.
struct RangeCost {
  float middle;
  float half;  ///< of the range
  float weight;
  float outside;  ///< penalty beyond the limits …
  float beyond;   ///< … and per rad
  bool wraps;     ///< of the turns of a value the one nearest to the middle counts
};

void addRangeCost(const float* row, const RangeCost& range, int lanes, float* cost);

/// Penalty where gainA·rowA + gainB·rowB + offset is nearer than `margin` to a multiple of a half
/// turn.
struct FoldCost {
  float gainA;
  float gainB;
  float offset;
  float margin;
  float penalty;
};

void addFoldCost(
    const float* rowA, const float* rowB, const FoldCost& fold, int lanes, float* cost);

/// twist = a + sign·b − zero in (−π, π]; penalty·(1 + excess) where |twist| exceeds `most`.
struct TwistCost {
  float sign;
  float zero;
  float most;
  float penalty;
};

void addTwistCost(const float* rowA,
                  const float* rowB,
                  const TwistCost& twist,
                  int lanes,
                  float* row,
                  float* cost);

/// cost[n] += values[n mod 8]: one value for each branch.
void addBranchCost(const float* values, int lanes, float* cost);

}  // namespace wcam::motion::detail
