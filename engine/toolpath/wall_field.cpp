// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wall_field.hpp"

#include "wcam/base/error.hpp"
#include "wcam/geometry/geodesic.hpp"
#include "wcam/geometry/harmonic.hpp"
#include "wcam/geometry/surface_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath {

WallField wallField(const geometry::PartSurface& part,
                    const WallLimits& limits,
                    const JobContext& context) {
  WallField field;
  if (!limits.upper.empty()) {
    field.values = geometry::harmonicField(part.mesh, part.halfEdges,
                                           {{limits.lower, 0.0}, {limits.upper, 1.0}}, {}, context);
    return field;
  }
  geometry::GeodesicSource source;
  source.vertices = limits.lower;
  field.values = geometry::GeodesicSolver(part.mesh, part.halfEdges)
                     .distance(source, std::numeric_limits<double>::infinity(), context);
  field.end = -1.0;
  for (std::uint32_t v = 0; v < field.values.size(); ++v) {
    if (std::isfinite(field.values[v]) && field.values[v] > field.end) {
      field.end = field.values[v];
      field.closure = v;
    }
  }
  if (!(field.end > 0.0)) {
    throw Error(ErrorCode::JobFailed, "the distance from the border vanishes everywhere",
                "continuous spiral", "check that the part is a surface with a lower border");
  }
  return field;
}

MeanHeight::MeanHeight(const geometry::TriangleMesh& mesh,
                       const std::vector<double>& field,
                       double end)
    : end_(end) {
  // By the co-area formula ∫ds/|∇φ| over ∫ds of a slice of the field is its area over ∫|∇φ| dA.
  constexpr std::size_t kSlices = 256;
  std::vector<double> area(kSlices, 0.0);
  std::vector<double> weight(kSlices, 0.0);
  const std::vector<Vec3> gradients = geometry::triangleGradients(mesh, field);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const double middle = (field[a] + field[b] + field[c]) / 3.0;
    const double slope = gradients[t].norm();
    if (!std::isfinite(slope) || !std::isfinite(middle)) {
      continue;
    }
    const double size =
        0.5 *
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
    const auto slice = static_cast<std::size_t>(std::clamp(
        middle / end * static_cast<double>(kSlices), 0.0, static_cast<double>(kSlices - 1)));
    area[slice] += size;
    weight[slice] += size * slope;
  }
  reached_.assign(kSlices + 1, 0.0);
  double last = 0.0;
  for (std::size_t s = 0; s < kSlices; ++s) {
    last = weight[s] > 0.0 ? area[s] / weight[s] : last;
    reached_[s + 1] = reached_[s] + last * end / static_cast<double>(kSlices);
  }
}

double MeanHeight::at(double level) const {
  const auto slices = static_cast<double>(reached_.size() - 1);
  const double s = std::clamp(level / end_ * slices, 0.0, slices);
  const auto i = std::min(static_cast<std::size_t>(s), reached_.size() - 2);
  return reached_[i] + (s - static_cast<double>(i)) * (reached_[i + 1] - reached_[i]);
}

double MeanHeight::levelAt(double height) const {
  const auto next = std::lower_bound(reached_.begin() + 1, reached_.end() - 1, height);
  const auto i = static_cast<std::size_t>(next - reached_.begin());
  const double size = reached_[i] - reached_[i - 1];
  const double w = size > 0.0 ? std::clamp((height - reached_[i - 1]) / size, 0.0, 1.0) : 0.0;
  return end_ * (static_cast<double>(i - 1) + w) / static_cast<double>(reached_.size() - 1);
}

}  // namespace wcam::toolpath
