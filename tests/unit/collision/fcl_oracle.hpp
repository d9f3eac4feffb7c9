// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/collision/cell_collision.hpp"

#include <memory>
#include <string>

namespace wcam::collision::test {

/// The whole scene asked of FCL alone: each shape, each rod of the deposit, every pair that
/// CellCollision compares, by FCL's own geometry and broad phase.
class FclOracle {
public:
  FclOracle(const CellCollision& collision, const cell::Cell& cell);
  ~FclOracle();

  /// True when anything overlaps; `what` names the pair.
  [[nodiscard]] bool collides(const CellState& state, std::string* what) const;
  /// Least distance of all pairs of shapes that CellCollision compares, the deposit left out, mm; 0
  /// where they overlap.
  [[nodiscard]] double shapeDistance(const CellState& state) const;
  /// The torch alone with the deposit.
  [[nodiscard]] bool torchCollides(const ToolState& state) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wcam::collision::test
