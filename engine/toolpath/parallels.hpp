// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/aabb_tree.hpp"
#include "wcam/geometry/brep.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/iso_parametric.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace wcam::toolpath {

/// A parallel of a body of revolution: p(α) = centre + radius·(cos α·e1 + sin α·e2).
struct Parallel {
  Vec3 centre = Vec3::Zero();
  Vec3 e1 = Vec3::UnitX();
  Vec3 e2 = Vec3::UnitY();
  double radius = 0.0;
  double alongAxis = 0.0;   ///< direction of the profile at the parallel: its part along the axis
  double alongSpoke = 0.0;  ///< and its part away from the axis

  [[nodiscard]] Vec3 at(double angle) const {
    return centre + radius * (std::cos(angle) * e1 + std::sin(angle) * e2);
  }
};

/// A part of a parallel from one angle up to a greater one; a whole turn is closed.
struct ParallelArc {
  double from = 0.0;
  double to = 0.0;
  bool closed = false;
};

/// Finds where parallels lie on a part that may be a sector, or have holes: between the part's
/// borders and above the substrate.
class ParallelCutter {
public:
  /// @param roundness distance from the ideal surface that the part may have, mm
  ParallelCutter(const geometry::PartSurface& part,
                 const Axis& axis,
                 const Substrate& substrate,
                 double roundness);

  /// Arcs in ascending order; one closed arc where the parallel meets no border.
  /// @param onEnd the parallel is the part's end, from which borders of facets may be as far as
  /// the part may be from a body of revolution
  [[nodiscard]] std::vector<ParallelArc> arcs(const Parallel& parallel, bool onEnd = false) const;

private:
  [[nodiscard]] Vec3 onBorder(std::uint32_t halfEdge, double w) const;
  void addBorderCrossings(const Parallel& parallel,
                          double tolerance,
                          std::vector<double>& angles) const;
  void addSubstrateCrossings(const Parallel& parallel, std::vector<double>& angles) const;
  [[nodiscard]] bool onPart(const Parallel& parallel, double from, double to) const;

  const geometry::PartSurface& part_;
  Axis axis_;
  const Substrate& substrate_;
  double roundness_;
  double tolerance_;  ///< of a border that is a parallel, mm
  std::optional<geometry::BrepEvaluator> evaluator_;
  std::optional<geometry::AabbTree> tree_;
  std::vector<std::uint32_t> borders_;
  bool level_ = true;  ///< the axis stands on a plate: parallels keep their height
};

}  // namespace wcam::toolpath
