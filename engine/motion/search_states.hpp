// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cell_model.hpp"
#include "plan_detail.hpp"
#include "search_kernel.hpp"

#include <cstdint>
#include <vector>

/// States of the graph search: branch × torch rotation × table angle at the targets that the search
/// looks at. Private to this module.
namespace wcam::motion::detail {

/// Samples of a full turn (DESIGN 9): 8·36·24 = 6912 states where both are free.
inline constexpr int kTorchSamples = 36;
inline constexpr int kTableSamples = 24;
inline constexpr int kLanes = kTorchSamples * cell::Branch::kCount;
static_assert(cell::InverseKinematics::kMostBranches == cell::Branch::kCount);

/// Costs of broken constraints in the search, far above any objective and far below each other.
struct SearchPenalty {
  static constexpr float kNever = 1e9F;        ///< a branch that the parameters do not allow
  static constexpr float kUnreachable = 1e6F;  ///< per target
  static constexpr float kOutside = 1e4F;      ///< per joint and target outside its limits …
  static constexpr float kBeyond = 1e4F;       ///< … and per rad beyond them
  static constexpr float kSingular = 1e3F;     ///< inside a singularity margin
  static constexpr float kTwist = 1e4F;        ///< beyond the cable's limit, and per rad
  static constexpr float kTooFast = 1e2F;      ///< per (step/greatest step)²
  static constexpr float kUnusual = 0.5F;      ///< per run: elbow down 1, shoulder to the back 2
};

/// A target that the search looks at.
struct Rung {
  std::size_t target = 0;
  std::size_t segment = 0;
  std::size_t steps = 1;  ///< targets since the rung before in the segment; 1 at its first
  double time = 0.0;      ///< of those steps at the wanted speed, s
  bool firstOfSegment = false;
  bool firstOfRun = false;
};

/// What the search works with besides the task.
struct SearchFrame {
  std::vector<Rung> rungs;
  std::size_t family = 0;     ///< of the gravity-aligned reference
  std::vector<double> gauge;  ///< torch rotation of sample 0 at every target, continuous
  bool fourWraps = true;      ///< axis 4 may pass a half turn
  bool moveTable = true;      ///< table samples besides the reference
  std::size_t points = 1;     ///< targets on beads
  double lead = 0.0;          ///< tilt of all states, rad
  double lateral = 0.0;
};

/// All states of a rung, joint-major. Lane = torch sample·8 + branch; each table sample has
/// 2·kLanes entries per row, the second half a copy, so that a cyclic shift is a plain offset.
struct RungStates {
  std::vector<int> tables;          ///< samples of the table, ascending, 0 among them
  std::vector<double> tableValues;  ///< controller value of each
  std::vector<float> rows[kSearchRows];
  std::vector<float> cost;  ///< state costs, tables.size()·kLanes

  [[nodiscard]] const float* row(int r, std::size_t table) const {
    return rows[r].data() + table * 2 * kLanes;
  }
};

/// Rungs of a task: ends of beads, corners, and between them as the path bends; at most about
/// `most`.
std::vector<Rung> chooseRungs(const Task& task, std::size_t family, std::size_t most);

class StateBuilder {
public:
  StateBuilder(const Task& task, const SearchFrame& frame);

  /// Joints and costs of all states of a rung. Thread-safe.
  void build(const Rung& rung, RungStates& states) const;

  [[nodiscard]] double tableStep() const;
  /// Free choice of a target for a table value and a torch sample (any turn).
  [[nodiscard]] FreeChoice choice(std::size_t target, double tableOffset, double torchSample) const;

private:
  void chooseTables(const Rung& rung, RungStates& states) const;
  void solve(const Rung& rung, RungStates& states) const;
  void solveEach(const Rung& rung, RungStates& states) const;
  void addCosts(const Rung& rung, std::size_t table, RungStates& states) const;
  void addArmCosts(const Rung& rung, std::size_t table, RungStates& states) const;
  void addSumCosts(const Rung& rung, std::size_t table, RungStates& states) const;
  void addTravel(const Rung& rung, RungStates& states) const;

  const Task& task_;
  const SearchFrame& frame_;
  CellModel model_;
  bool hasTable_;
};

}  // namespace wcam::motion::detail
