// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/wall.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/cut_mesh.hpp"
#include "wcam/geometry/refine.hpp"
#include "wcam/toolpath/base_curve.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {

namespace {

[[noreturn]] void refuse(const Text& message, const Text& hint) {
  throw Error(ErrorCode::JobFailed, message, "wall", hint);
}

std::string placeOf(const Vec3& p) {
  return "(" + formatFixed(p.x(), 1) + ", " + formatFixed(p.y(), 1) + ", " + formatFixed(p.z(), 1) +
         ")";
}

/// The part without what lies below the substrate.
geometry::PartSurface aboveSubstrate(geometry::PartSurface part, const Substrate& substrate) {
  std::vector<double> height;
  height.reserve(part.mesh.vertices.size());
  for (const Vec3& p : part.mesh.vertices) {
    height.push_back(substrate.heightAbove(p));
  }
  const auto [low, high] = std::minmax_element(height.begin(), height.end());
  if (height.empty() || *high <= 0.0) {
    throw Error(ErrorCode::CheckFailed, "the whole part lies below the substrate", "wall",
                "raise the part or lower the substrate");
  }
  if (*low >= -kSubstrateContact) {
    return part;
  }
  const geometry::CutSurface cut = geometry::cutAtLevels(part, height, {0.0});
  std::vector<bool> keep;
  keep.reserve(cut.surface.mesh.triangles.size());
  for (const auto& [a, b, c] : cut.surface.mesh.triangles) {
    keep.push_back(std::max({cut.field[a], cut.field[b], cut.field[c]}) > 0.0);
  }
  return geometry::keepTriangles(cut.surface, keep).surface;
}

}  // namespace

WallPart prepareWall(const geometry::PartSurface& part,
                     const Substrate& substrate,
                     double edge,
                     const JobContext& context) {
  WallPart wall;
  wall.surface = aboveSubstrate(
      geometry::refineSurface(part, edge, context.portion(0.0, 0.8, "refinement")), substrate);
  if (wall.surface.halfEdges.closed()) {
    refuse(
        "the part is a closed surface without a border",
        "a thin wall is modelled by one open surface: select the faces of the wall, without bottom "
        "and top");
  }
  const PartBase base = findBase(wall.surface, substrate, context.portion(0.8, 1.0, "base"));
  if (base.kind.size() > 1) {
    refuse(text("the part consists of %1 separate pieces", {std::to_string(base.kind.size())}),
           "make one operation per piece: select the faces of one of them");
  }
  if (base.lower.size() != 1) {
    std::string places;
    for (const BaseLoop& loop : base.lower) {
      if (!loop.vertices.empty()) {
        places +=
            (places.empty() ? "" : ", ") + placeOf(wall.surface.mesh.vertices[loop.vertices[0]]);
      }
    }
    refuse(
        text("the part has %1 lower borders, near %2", {std::to_string(base.lower.size()), places}),
        "a wall stands on one: close the others, or slice the part with the strategy for branches");
  }
  if (base.upper.size() > 1) {
    refuse(text("the part has %1 upper borders, one near %2",
                {std::to_string(base.upper.size()),
                 placeOf(wall.surface.mesh.vertices[base.upper[1].vertices[0]])}),
           "close holes in the wall, or slice the part with the strategy for branches");
  }
  if (!base.lower.front().closed || base.lower.front().vertices.size() < 3) {
    refuse("the lower border is not a closed curve",
           "place the part so that it meets the substrate in "
           "one closed curve");
  }
  wall.limits.lower = base.lower.front().vertices;
  if (!base.upper.empty()) {
    wall.limits.upper = base.upper.front().vertices;
  }
  return wall;
}

}  // namespace wcam::toolpath
