// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/toolpath/height_field.hpp"

#include "wcam/base/error.hpp"
#include "wcam/geometry/level_set.hpp"

#include <algorithm>
#include <limits>

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

HeightLevels heightLevels(const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                          const Substrate& substrate,
                          LayerWish wish,
                          double endHeight) {
  HeightLevels result;
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double most = -1.0;
  double flat = -1.0;
  for (const auto& part : parts) {
    std::vector<double> heights;
    heights.reserve(part->mesh.vertices.size());
    double top = -std::numeric_limits<double>::infinity();
    for (const Vec3& v : part->mesh.vertices) {
      heights.push_back(substrate.heightAbove(v));
      top = std::max(top, heights.back());
    }
    const double tolerance = geometry::flatTolerance(part->mesh);
    result.tolerance = std::max(result.tolerance, tolerance);
    most = std::max(most, top);
    const bool ends =
        top > tolerance && endsFlat(part->mesh, part->halfEdges, heights, 2.0 * tolerance);
    result.ends.push_back(ends ? top : kNone);
    flat = ends ? std::max(flat, top) : flat;
  }
  if (!(most > 0.0)) {
    throw Error(ErrorCode::CheckFailed, "the whole part lies below the substrate", "slicing",
                "raise the part or lower the substrate");
  }
  if (wish.last == LastLayer::Fit && flat > 0.0) {
    wish.step = layersUpTo(flat, wish, result.tolerance).step;
  }
  wish.last = LastLayer::Leave;
  result.step = wish.step;
  const double end = endHeight > 0.0 ? std::min(most, endHeight) : most;
  const LayerSteps steps = layersUpTo(end, wish, result.tolerance);
  for (std::size_t k = 0; k < steps.count; ++k) {
    result.levels.push_back(
        {(wish.firstLayer + static_cast<double>(k)) * steps.step, substrate.up(), steps.step});
  }
  if (end < most) {
    std::fill(result.ends.begin(), result.ends.end(), kNone);
  }
  return result;
}

}  // namespace wcam::toolpath
