// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/generatrices.hpp"

#include <optional>
#include <vector>

namespace wcam::toolpath {

/// A field that grows from the lower to the upper limit of a wall.
struct WallField {
  std::vector<double> values;            ///< 0 on the lower loop
  double end = 1.0;                      ///< value at the upper limit
  std::optional<std::uint32_t> closure;  ///< the highest vertex of a part that closes
};

/// Open walls: conduction between the two borders (M18). Closing parts: distance from the border
/// (M17). @throws Error(JobFailed) when the field vanishes
WallField wallField(const geometry::PartSurface& part,
                    const WallLimits& limits,
                    const JobContext& context);

/// Mean height of the level curves of a field above its zero: the integral of the mean of 1/|∇φ|.
class MeanHeight {
public:
  MeanHeight(const geometry::TriangleMesh& mesh, const std::vector<double>& field, double end);

  [[nodiscard]] double total() const noexcept { return reached_.back(); }

  [[nodiscard]] double at(double level) const;
  [[nodiscard]] double levelAt(double height) const;

private:
  double end_;
  std::vector<double> reached_;  ///< at equal steps of the field
};

}  // namespace wcam::toolpath
