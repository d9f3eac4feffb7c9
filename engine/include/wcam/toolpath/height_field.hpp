// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/toolpath/layer_levels.hpp"
#include "wcam/toolpath/slice_field.hpp"

#include <vector>

namespace wcam::toolpath {

/// φ(p) = height above the substrate along the build direction: its levels are the substrate's
/// surface moved up (substrate propagation, Chalvin A36). Exact where the substrate is exact. Both
/// arguments must outlive the field.
class HeightField : public LayerField {
public:
  HeightField(const Substrate& substrate, const std::vector<LayerLevel>& levels)
      : substrate_(substrate), levels_(levels) {}

  [[nodiscard]] double scalar(const Vec3& p) const override;
  [[nodiscard]] double residual(const Vec3& p, std::size_t level) const override;
  [[nodiscard]] Vec3 gradient(const Vec3& p, std::size_t level) const override;
  /// Beside a body the height counts from the plane of its frame: the field is torn at the body's
  /// steep sides.
  [[nodiscard]] double largestJump(double edgeLength) const override;

private:
  const Substrate& substrate_;
  const std::vector<LayerLevel>& levels_;
};

/// Layers above a substrate.
struct HeightLevels {
  std::vector<LayerLevel> levels;
  double step = 0.0;         ///< that the layers got, mm
  std::vector<double> ends;  ///< as in PlaneStack
  double tolerance = 0.0;    ///< of the parts' flat faces, mm
};

/// Levels firstLayer·step, (firstLayer + 1)·step, … up to the highest point of the parts above the
/// substrate. @throws Error(JobFailed) when all of it lies below, Error(InvalidArgument) for a step
/// that gives over a million levels
HeightLevels heightLevels(const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                          const Substrate& substrate,
                          LayerWish wish,
                          double endHeight);

}  // namespace wcam::toolpath
