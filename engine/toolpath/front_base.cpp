// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "front_base.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/level_set.hpp"
#include "wcam/toolpath/height_field.hpp"

#include "level_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath {

using geometry::HalfEdges;
using geometry::PartSurface;

namespace {

/// On the substrate within this length (a mesh file's numbers) or this part of the part's size.
constexpr double kOnSubstrate = 1e-3;
constexpr double kOnSubstrateRelative = 1e-5;
/// Rounding of heights, in parts of the part's size.
constexpr double kSnap = 1e-12;
/// A triangle lies flat on the substrate when its normal points down within this cosine.
constexpr double kFlatCosine = 0.9;

/// Edges of the mesh against their direction, so that material and growth have their sides.
class BorderCurve : public SampledCurve {
public:
  BorderCurve(const SurfacePatch& patch, std::vector<std::uint32_t> halfEdges, bool closed)
      : patch_(&patch), halfEdges_(std::move(halfEdges)), closed_(closed) {}

  [[nodiscard]] std::size_t pieces() const override { return halfEdges_.size(); }

  [[nodiscard]] bool closed() const override { return closed_; }

  [[nodiscard]] bool exact() const override { return patch_->exact(); }

  [[nodiscard]] ContourPoint at(std::size_t piece, double w) const override {
    const std::uint32_t h = halfEdges_[piece];
    const double fraction = 1.0 - w;
    ContourPoint point;
    // The ends are the mesh's vertices, shared by both pieces.
    if (w <= 0.0 || w >= 1.0) {
      const auto& t = patch_->part().mesh.triangles[h / 3];
      point.p = patch_->part().mesh.vertices[t[(h % 3 + (w <= 0.0 ? 1 : 0)) % 3]];
    } else {
      point.p = patch_->edgePoint(h, fraction);
    }
    const geometry::Vec2 uv =
        patch_->project(h / 3, patch_->onHalfEdge(h / 3, h, fraction), point.p);
    point.n = patch_->normal(h / 3, uv, patch_->surface(h / 3, uv));
    return point;
  }

  [[nodiscard]] Vec3 tangent(std::size_t piece, double w) const override {
    constexpr double kNear = 1e-3;
    const Vec3 t = w < 0.5 ? Vec3(at(piece, kNear).p - at(piece, 0.0).p)
                           : Vec3(at(piece, 1.0).p - at(piece, 1.0 - kNear).p);
    return t.norm() > 0.0 ? Vec3(t.normalized()) : Vec3(Vec3::Zero());
  }

private:
  const SurfacePatch* patch_;
  std::vector<std::uint32_t> halfEdges_;
  bool closed_;
};

/// What a base made of level curves refers to.
struct LevelBase {
  explicit LevelBase(const Substrate& substrate) : field(substrate, levels) {}

  std::vector<LayerLevel> levels{{0.0, Vec3::UnitZ(), 0.0}};
  HeightField field;
  std::optional<geometry::BrepEvaluator> evaluator;
};

FrontBase leavingCurves(const SurfacePatch& patch,
                        const Substrate& substrate,
                        const std::vector<double>& heights,
                        double size,
                        const JobContext& context) {
  const PartSurface& part = patch.part();
  auto level = std::make_shared<LevelBase>(substrate);
  if (part.exact()) {
    level->evaluator.emplace(*part.brep);
  }
  FrontBase base;
  base.covered.resize(heights.size());
  for (std::size_t v = 0; v < heights.size(); ++v) {
    base.covered[v] = heights[v] < 0.0;
  }
  const std::vector<double> zero{0.0};
  const auto contours =
      geometry::traceLevels(part.mesh, part.halfEdges, heights, zero,
                            {kSnap * size, geometry::flatTolerance(part.mesh)}, context);
  std::size_t unrefined = 0;
  for (const geometry::LevelContour& contour : contours[0]) {
    auto curve = std::make_unique<LevelCurve>(part, level->evaluator ? &*level->evaluator : nullptr,
                                              &level->field, 0, size);
    unrefined += curve->assign(contour);
    TracedCurve traced;
    for (const CurveSegment& segment : curve->segments()) {
      traced.triangles.push_back(segment.triangle);
    }
    traced.curve = std::move(curve);
    base.curves.push_back(std::move(traced));
  }
  if (unrefined > 0) {
    context.add({Severity::Warning,
                 "slicing.refinement_failed",
                 text("%1 nodes of the base curve keep their place on the tessellation",
                      {std::to_string(unrefined)}),
                 "lower the tessellation's chord tolerance",
                 {},
                 {{"nodes", static_cast<double>(unrefined)}}});
  }
  base.keepAlive = level;
  return base;
}

/// Half-edges at which the wall begins: on the substrate, with no wall on their other side.
std::vector<std::uint32_t> rimHalfEdges(const PartSurface& part,
                                        const std::vector<bool>& on,
                                        const std::vector<bool>& flat) {
  std::vector<std::uint32_t> rim;
  for (std::uint32_t h = 0; h < 3 * part.mesh.triangles.size(); ++h) {
    const auto& t = part.mesh.triangles[h / 3];
    if (flat[h / 3] || !on[t[h % 3]] || !on[t[(h % 3 + 1) % 3]]) {
      continue;
    }
    const std::uint32_t twin = part.halfEdges.twin(h);
    if (twin == HalfEdges::kNone || flat[twin / 3]) {
      rim.push_back(h);
    }
  }
  return rim;
}

/// Chains of half-edges, each beginning where the one before it begins (they run backwards).
void chainRim(const SurfacePatch& patch, const std::vector<std::uint32_t>& rim, FrontBase& base) {
  const PartSurface& part = patch.part();
  const auto from = [&](std::uint32_t h) { return part.mesh.triangles[h / 3][h % 3]; };
  const auto to = [&](std::uint32_t h) { return part.mesh.triangles[h / 3][(h % 3 + 1) % 3]; };
  std::vector<std::uint32_t> byEnd(part.mesh.vertices.size(), HalfEdges::kNone);
  std::vector<bool> isStart(part.mesh.vertices.size(), false);
  for (auto it = rim.rbegin(); it != rim.rend(); ++it) {
    byEnd[to(*it)] = *it;
    isStart[from(*it)] = true;
  }
  std::vector<bool> used(3 * part.mesh.triangles.size(), false);
  const auto follow = [&](std::uint32_t first) {
    std::vector<std::uint32_t> chain;
    std::uint32_t h = first;
    while (h != HalfEdges::kNone && !used[h]) {
      used[h] = true;
      chain.push_back(h);
      h = byEnd[from(h)];
    }
    TracedCurve traced;
    for (const std::uint32_t e : chain) {
      traced.triangles.push_back(e / 3);
    }
    const bool closed = to(first) == from(chain.back());
    traced.curve = std::make_unique<BorderCurve>(patch, std::move(chain), closed);
    base.curves.push_back(std::move(traced));
  };
  // Open chains begin where no other one ends.
  for (const std::uint32_t h : rim) {
    if (!used[h] && !isStart[to(h)]) {
      follow(h);
    }
  }
  for (const std::uint32_t h : rim) {
    if (!used[h]) {
      follow(h);
    }
  }
}

}  // namespace

FrontBase findFrontBase(const SurfacePatch& patch,
                        const Substrate& substrate,
                        const JobContext& context) {
  const PartSurface& part = patch.part();
  const auto& vertices = part.mesh.vertices;
  const double size = std::max(1.0, part.mesh.bounds().diagonal());
  const double tolerance = std::max(kOnSubstrate, kOnSubstrateRelative * size);
  std::vector<double> heights(vertices.size());
  std::vector<bool> on(vertices.size());
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    heights[v] = substrate.heightAbove(vertices[v]);
    on[v] = std::abs(heights[v]) <= tolerance;
    least = std::min(least, heights[v]);
    most = std::max(most, heights[v]);
  }
  if (!(most > tolerance)) {
    throw Error(ErrorCode::CheckFailed, "the whole part lies below the substrate", "slicing",
                "raise the part or lower the substrate");
  }
  if (least < -tolerance) {
    return leavingCurves(patch, substrate, heights, size, context);
  }
  std::vector<bool> flat(part.mesh.triangles.size());
  FrontBase base;
  base.covered.assign(vertices.size(), false);
  for (std::size_t t = 0; t < flat.size(); ++t) {
    const auto& c = part.mesh.triangles[t];
    flat[t] =
        on[c[0]] && on[c[1]] && on[c[2]] && part.mesh.normal(t).dot(substrate.up()) < -kFlatCosine;
    if (flat[t]) {
      base.covered[c[0]] = base.covered[c[1]] = base.covered[c[2]] = true;
    }
  }
  chainRim(patch, rimHalfEdges(part, on, flat), base);
  if (base.curves.empty()) {
    throw Error(ErrorCode::JobFailed,
                text("the part does not touch the substrate along a curve; its lowest point is %1 "
                     "mm above it",
                     {formatFixed(least, 3)}),
                "slicing", "move the part onto the substrate, or a little into it");
  }
  return base;
}

}  // namespace wcam::toolpath
