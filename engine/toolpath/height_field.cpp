// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/toolpath/height_field.hpp"

#include "wcam/base/error.hpp"

#include <algorithm>

namespace wcam::toolpath {

double HeightField::scalar(const Vec3& p) const {
  return substrate_.heightAbove(p);
}

double HeightField::residual(const Vec3& p, std::size_t level) const {
  return substrate_.exactHeightAbove(p).value - levels_[level].value;
}

Vec3 HeightField::gradient(const Vec3& p, std::size_t) const {
  return substrate_.exactHeightAbove(p).gradient;
}

double HeightField::largestJump(double edgeLength) const {
  // The height of a substrate's slope may change faster than the length; a true tear jumps by the
  // height of the body.
  constexpr double kSteepest = 20.0;
  return kSteepest * edgeLength;
}

std::vector<LayerLevel> heightLevels(
    const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
    const Substrate& substrate,
    double step,
    double firstLayer,
    double endHeight) {
  double most = -1.0;
  for (const auto& part : parts) {
    for (const Vec3& v : part->mesh.vertices) {
      most = std::max(most, substrate.heightAbove(v));
    }
  }
  if (!(most > 0.0)) {
    throw Error(ErrorCode::JobFailed, "the whole part lies below the substrate", "slicing",
                "raise the part or lower the substrate");
  }
  const double end = endHeight > 0.0 ? std::min(most, endHeight) : most;
  constexpr double kRounding = 1e-9;
  constexpr std::size_t kMostLevels = 1000000;
  std::vector<LayerLevel> levels;
  for (std::size_t k = 0; levels.size() <= kMostLevels; ++k) {
    const double value = (firstLayer + static_cast<double>(k)) * step;
    if (value > end + kRounding * step) {
      return levels;
    }
    levels.push_back({value, substrate.up(), step});
  }
  throw Error(ErrorCode::InvalidArgument, "the step gives more than a million layers", "step",
              "choose a larger step");
}

}  // namespace wcam::toolpath
