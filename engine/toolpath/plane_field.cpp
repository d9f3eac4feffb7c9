// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/plane_field.hpp"

#include "wcam/base/error.hpp"

#include <algorithm>
#include <limits>

namespace wcam::toolpath {

namespace {

/// Lowest and highest plane position of what stands above the substrate.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double position) {
    low = std::min(low, position);
    high = std::max(high, position);
  }
};

Extent extentAboveSubstrate(const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                            const Substrate& substrate,
                            const Vec3& up) {
  Extent extent;
  for (const auto& part : parts) {
    const geometry::TriangleMesh& mesh = part->mesh;
    std::vector<double> height(mesh.vertices.size());
    for (std::size_t v = 0; v < height.size(); ++v) {
      height[v] = substrate.heightAbove(mesh.vertices[v]);
      if (height[v] >= 0.0) {
        extent.add(up.dot(mesh.vertices[v]));
      }
    }
    // Where an edge passes through the substrate, the part begins on it.
    for (const auto& triangle : mesh.triangles) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t a = triangle[c];
        const std::uint32_t b = triangle[(c + 1) % 3];
        if ((height[a] < 0.0) != (height[b] < 0.0)) {
          const double s = height[a] / (height[a] - height[b]);
          extent.add(up.dot(mesh.vertices[a] + s * (mesh.vertices[b] - mesh.vertices[a])));
        }
      }
    }
  }
  return extent;
}

std::vector<LayerLevel> levelsBetween(const PlaneStackOptions& options,
                                      const Vec3& up,
                                      double low,
                                      double high) {
  const double end = options.endHeight > 0.0 ? std::min(high, options.endHeight) : high;
  // A level that rounding puts a hair above the top is still the top.
  constexpr double kRounding = 1e-9;
  std::vector<LayerLevel> levels;
  constexpr std::size_t kMostLevels = 1000000;
  for (std::size_t k = 0; levels.size() <= kMostLevels; ++k) {
    const double value = (options.firstLayer + static_cast<double>(k)) * options.step;
    if (value > end + kRounding * options.step) {
      return levels;
    }
    if (value >= low - kRounding * options.step) {
      levels.push_back({value, up, options.step});
    }
  }
  throw Error(ErrorCode::InvalidArgument, "the step gives more than a million layers", "step",
              "choose a larger step");
}

}  // namespace

PlaneStack planeStack(const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                      const Substrate& substrate,
                      const PlaneStackOptions& options) {
  PlaneStack stack;
  stack.up = options.direction.value_or(substrate.up());
  if (!(stack.up.norm() > 0.0)) {
    throw Error(ErrorCode::InvalidArgument, "the build direction has no length", "direction",
                "give a vector such as [0, 0, 1]");
  }
  if (!(options.step > 0.0)) {
    throw Error(ErrorCode::InvalidArgument, "the step is not above 0", "step", "give a step in mm");
  }
  if (options.direction) {
    stack.up.normalize();
  }
  const Extent extent = extentAboveSubstrate(parts, substrate, stack.up);
  if (!(extent.low <= extent.high)) {
    throw Error(ErrorCode::JobFailed, "the whole part lies below the substrate", "planar slicing",
                "raise the part or lower the substrate");
  }
  const bool fromPlate = substrate.isPlate() && !options.direction;
  stack.base = fromPlate ? stack.up.dot(substrate.pose().translation()) : extent.low;
  stack.levels =
      levelsBetween(options, stack.up, extent.low - stack.base, extent.high - stack.base);
  return stack;
}

double PlaneField::scalar(const Vec3& p) const {
  return stack_.up.dot(p) - stack_.base;
}

double PlaneField::residual(const Vec3& p, std::size_t level) const {
  return scalar(p) - stack_.levels[level].value;
}

Vec3 PlaneField::gradient(const Vec3&, std::size_t) const {
  return stack_.up;
}

}  // namespace wcam::toolpath
