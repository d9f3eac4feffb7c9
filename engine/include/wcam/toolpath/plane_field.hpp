// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/toolpath/layer_levels.hpp"
#include "wcam/toolpath/slice_field.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace wcam::toolpath {

/// Which parallel planes are wanted. Lengths in mm.
struct PlaneStackOptions {
  LayerWish layers;               ///< the base is the one of the stack
  double endHeight = 0.0;         ///< no plane above this height over the base; 0: the whole part
  std::optional<Vec3> direction;  ///< any length; otherwise the substrate's build direction
};

/// Parallel planes {up·p = base + level}.
struct PlaneStack {
  Vec3 up = Vec3::UnitZ();
  double base = 0.0;
  std::vector<LayerLevel> levels;
  double step = 0.0;  ///< that the layers got, mm
  /// Per part the height above the base at which it ends in a face or a border; NaN where it ends
  /// in a point, where a height was given at which the stack ends, and where it lies below the
  /// substrate.
  std::vector<double> ends;
  double tolerance = 0.0;  ///< of the parts' flat faces, mm
};

/// The planes that meet what stands above the substrate. On a plate they count from its top; with
/// an own direction or an uneven substrate from the part's lowest point. A step is fitted to the
/// highest part that ends in a face or a border.
/// @throws Error(JobFailed) when the whole part lies below the substrate, Error(InvalidArgument)
/// for a direction without length or a step that gives over a million planes
/// Cost: O(vertices + triangles).
PlaneStack planeStack(const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                      const Substrate& substrate,
                      const PlaneStackOptions& options);

/// φ(p) = up·p − base: heights of parallel planes. The stack must outlive the field.
class PlaneField : public LayerField {
public:
  explicit PlaneField(const PlaneStack& stack) : stack_(stack) {}

  [[nodiscard]] double scalar(const Vec3& p) const override;
  [[nodiscard]] double residual(const Vec3& p, std::size_t level) const override;
  [[nodiscard]] Vec3 gradient(const Vec3& p, std::size_t level) const override;

private:
  const PlaneStack& stack_;
};

}  // namespace wcam::toolpath
