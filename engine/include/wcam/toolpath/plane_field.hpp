// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/toolpath/slice_field.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace wcam::toolpath {

/// Which parallel planes are wanted. Lengths in mm.
struct PlaneStackOptions {
  double step = 2.0;
  double firstLayer = 1.0;        ///< height of the first plane above the base, in steps
  double endHeight = 0.0;         ///< no plane above this height over the base; 0: the whole part
  std::optional<Vec3> direction;  ///< any length; otherwise the substrate's build direction
};

/// Parallel planes {up·p = base + level}.
struct PlaneStack {
  Vec3 up = Vec3::UnitZ();
  double base = 0.0;
  std::vector<LayerLevel> levels;
};

/// The planes that meet what stands above the substrate. On a plate they count from its top; with
/// an own direction or an uneven substrate from the part's lowest point.
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
