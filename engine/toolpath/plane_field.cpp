// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/plane_field.hpp"

#include "wcam/base/error.hpp"
#include "wcam/geometry/level_set.hpp"

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

/// Per part the height at which it ends in a face or a border.
void findEnds(const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
              PlaneStack& stack) {
  for (const auto& part : parts) {
    std::vector<double> heights;
    heights.reserve(part->mesh.vertices.size());
    double top = -std::numeric_limits<double>::infinity();
    for (const Vec3& p : part->mesh.vertices) {
      heights.push_back(stack.up.dot(p) - stack.base);
      top = std::max(top, heights.back());
    }
    const double tolerance = geometry::flatTolerance(part->mesh);
    stack.tolerance = std::max(stack.tolerance, tolerance);
    const bool flat =
        top > tolerance && endsFlat(part->mesh, part->halfEdges, heights, 2.0 * tolerance);
    stack.ends.push_back(flat ? top : std::numeric_limits<double>::quiet_NaN());
  }
}

/// @param low lowest point above the substrate
void makeLevels(const PlaneStackOptions& options, double low, double high, PlaneStack& stack) {
  LayerWish wish = options.layers;
  const double end = options.endHeight > 0.0 ? std::min(high, options.endHeight) : high;
  double flat = -std::numeric_limits<double>::infinity();
  for (const double value : stack.ends) {
    flat = std::isnan(value) ? flat : std::max(flat, value);
  }
  if (wish.last == LastLayer::Fit && std::isfinite(flat)) {
    wish.step = layersUpTo(flat, wish, stack.tolerance).step;
  }
  wish.last = LastLayer::Leave;
  stack.step = wish.step;
  const LayerSteps steps = layersUpTo(end, wish, stack.tolerance);
  for (std::size_t k = 0; k < steps.count; ++k) {
    const double value = (wish.firstLayer + static_cast<double>(k)) * steps.step;
    if (value >= low - stack.tolerance) {
      stack.levels.push_back({value, stack.up, steps.step});
    }
  }
  if (end < high) {
    std::fill(stack.ends.begin(), stack.ends.end(), std::numeric_limits<double>::quiet_NaN());
  }
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
  if (!(options.layers.step > 0.0)) {
    throw Error(ErrorCode::InvalidArgument, "the step is not above 0", "step", "give a step in mm");
  }
  if (options.direction) {
    stack.up.normalize();
  }
  const Extent extent = extentAboveSubstrate(parts, substrate, stack.up);
  if (!(extent.low <= extent.high)) {
    throw Error(ErrorCode::CheckFailed, "the whole part lies below the substrate", "planar slicing",
                "raise the part or lower the substrate");
  }
  const bool fromPlate = substrate.isPlate() && !options.direction;
  stack.base = fromPlate ? stack.up.dot(substrate.pose().translation()) : extent.low;
  findEnds(parts, stack);
  makeLevels(options, extent.low - stack.base, extent.high - stack.base, stack);
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
