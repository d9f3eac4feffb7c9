// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/cut_path.hpp"
#include "wcam/geometry/harmonic.hpp"
#include "wcam/geometry/level_set.hpp"
#include "wcam/geometry/surface_point.hpp"
#include "wcam/geometry/surface_projector.hpp"
#include "wcam/toolpath/spiral.hpp"

#include "spiral_findings.hpp"
#include "wall_field.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {

namespace {

/// Stations at which the law of a revolution is tabulated; it is linear in the fraction.
constexpr std::size_t kStations = 64;

/// The wall opened from border to border, with its two coordinates.
struct OpenWall {
  geometry::PathCut cut;
  std::vector<double> height;    ///< mean height above the lower border, mm
  std::vector<double> fraction;  ///< of a revolution, 0 to 1 in the direction of travel
  double total = 0.0;            ///< mean height of the upper limit
};

OpenWall openWall(const geometry::PartSurface& part,
                  const WallLimits& limits,
                  const JobContext& context) {
  const WallField field = wallField(part, limits, context.portion(0.0, 0.4, "field"));
  const MeanHeight mean(part.mesh, field.values, field.end);
  const std::vector<std::uint32_t> path =
      geometry::edgePath(part.mesh, part.halfEdges, limits.lower,
                         field.closure ? std::vector<std::uint32_t>{*field.closure} : limits.upper);
  if (path.size() < 2) {
    throw Error(ErrorCode::JobFailed, "no way leads from the lower border to the upper limit",
                "continuous spiral", "the part must be one connected surface: repair it");
  }
  OpenWall wall;
  wall.cut = geometry::cutAlong(part.mesh, path);
  // Travel t with t × n = up crosses an upward path to its left.
  geometry::FixedValues begin{{}, 0.0};
  geometry::FixedValues end{{}, 1.0};
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (wall.cut.left[i] != wall.cut.right[i]) {
      begin.vertices.push_back(wall.cut.left[i]);
      end.vertices.push_back(wall.cut.right[i]);
    }
  }
  wall.fraction = geometry::harmonicField(wall.cut.mesh, wall.cut.halfEdges, {begin, end}, {},
                                          context.portion(0.4, 0.8, "turn fraction"));
  wall.total = mean.total();
  for (const std::uint32_t v : wall.cut.original) {
    wall.height.push_back(mean.at(field.values[v]));
  }
  return wall;
}

/// A table over the fraction of a revolution, read linearly.
double tableAt(const std::vector<double>& table, double next, double fraction) {
  const double s = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(table.size());
  const auto i = std::min(static_cast<std::size_t>(s), table.size() - 1);
  const double after = i + 1 < table.size() ? table[i + 1] : next;
  return table[i] + (s - static_cast<double>(i)) * (after - table[i]);
}

/// Linear continuation of a table to fraction 1.
double tableEnd(const std::vector<double>& table) {
  return 2.0 * table.back() - table[table.size() - 2];
}

struct TracedTurn {
  std::vector<Vec3> points;
  std::vector<double> heights;
};

class SpiralTracer {
public:
  explicit SpiralTracer(const OpenWall& wall)
      : wall_(wall), gradients_(geometry::triangleGradients(wall.cut.mesh, wall.height)) {}

  /// The curve height = law(fraction) from one side of the cut to the other.
  [[nodiscard]] TracedTurn trace(const SpiralTurn& turn, const JobContext& context) const {
    const double positionEnd = tableEnd(turn.position);
    std::vector<double> scalar(wall_.height.size());
    for (std::size_t v = 0; v < scalar.size(); ++v) {
      scalar[v] = wall_.height[v] - tableAt(turn.position, positionEnd, wall_.fraction[v]);
    }
    constexpr double kSnap = 1e-11;
    const std::vector<double> zero{0.0};
    const auto curves = geometry::traceLevels(wall_.cut.mesh, wall_.cut.halfEdges, scalar, zero,
                                              kSnap * wall_.total, context);
    const geometry::LevelContour* longest = nullptr;
    for (const geometry::LevelContour& curve : curves.front()) {
      if (longest == nullptr || curve.points.size() > longest->points.size()) {
        longest = &curve;
      }
    }
    TracedTurn traced;
    if (longest == nullptr) {
      return traced;
    }
    const double stepEnd = tableEnd(turn.step);
    for (std::size_t i = 0; i < longest->points.size(); ++i) {
      const std::uint32_t h = longest->halfEdges[i];
      const auto& triangle = wall_.cut.mesh.triangles[h / 3];
      const double a = wall_.fraction[triangle[h % 3]];
      const double b = wall_.fraction[triangle[(h % 3 + 1) % 3]];
      const double fraction = a + longest->fractions[i] * (b - a);
      const double slope = gradients_[h / 3].norm();
      traced.points.push_back(longest->points[i]);
      traced.heights.push_back(slope > 0.0 ? tableAt(turn.step, stepEnd, fraction) / slope : 0.0);
    }
    return traced;
  }

private:
  const OpenWall& wall_;
  std::vector<Vec3> gradients_;
};

/// Mesh noise of the gradients: heights that pass the range by less do not make it infeasible.
constexpr double kFieldNoise = 0.01;

/// Tells heights outside of the range, and where they are more than noise that the range cannot be
/// kept.
void judgeHeights(const SpiralHeights& heights, const SpiralWish& wish, const JobContext& context) {
  if (heights.excess <= kFieldNoise) {
    reportSpiralHeights(heights, context);
    return;
  }
  context.add(
      {Severity::Warning,
       "slicing.spiral_infeasible",
       text("%1 points of the spiral need a deposit outside of %2 to %3 mm; the worst is %4 "
            "mm",
            {std::to_string(heights.outside), formatFixed(heights.low, 3),
             formatFixed(heights.high, 3), formatFixed(heights.worst, 3)}),
       {},
       {{}, 0, 0, -1},
       {{"points", static_cast<double>(heights.outside)},
        {"deposit_mm", heights.worst},
        {"height_min_mm", std::min(heights.least, wish.heightMin)},
        {"height_max_mm", std::max(heights.greatest, wish.heightMax)}}});
}

void reportFieldSpiral(const SpiralPlan& plan,
                       const SpiralHeights& heights,
                       double meanLength,
                       const JobContext& context) {
  const bool measured = heights.points > 0;
  const double least = measured ? heights.least : plan.regularMin;
  const double greatest = measured ? heights.greatest : plan.regularMax;
  context.add({Severity::Information,
               "slicing.spiral",
               text("one bead of %1 revolutions, %2 to %3 mm deposit; mean generatrix %4 mm",
                    {std::to_string(plan.turns.size()), formatFixed(least, 3),
                     formatFixed(greatest, 3), formatFixed(meanLength, 2)}),
               "",
               {{}, 0, 0, -1},
               {{"revolutions", static_cast<double>(plan.turns.size())},
                {"start_revolutions", static_cast<double>(plan.startTurns)},
                {"end_revolutions", static_cast<double>(plan.endTurns)},
                {"deposit_min_mm", least},
                {"deposit_max_mm", greatest},
                {"mean_length_mm", meanLength},
                {"seam_step_mm", plan.largestSeamStep}}});
}

}  // namespace

SlicedLayers spiralOnField(const geometry::PartSurface& part,
                           const geometry::PartSurface& surface,
                           const WallLimits& limits,
                           const SpiralWish& wish,
                           const Sampling& sampling,
                           const JobContext& context) {
  const OpenWall wall = openWall(part, limits, context.portion(0.0, 0.5, "field"));
  const SpiralPlan plan = planSpiral(std::vector<double>(kStations, wall.total), wish);
  const SpiralTracer tracer(wall);
  const geometry::SurfaceProjector projector(surface);
  const JobContext tracing = context.portion(0.5, 1.0, "spiral");
  Contour bead;
  SpiralHeights heights;
  Vec3 up = Vec3::Zero();
  for (std::size_t k = 0; k < plan.turns.size(); ++k) {
    tracing.check();
    const TracedTurn turn = tracer.trace(plan.turns[k], JobContext());
    std::vector<ContourPoint> points;
    for (const geometry::ProjectedPoint& point : projector.project(turn.points)) {
      points.push_back({point.p, point.n, turn.heights[points.size()]});
    }
    if (points.size() < 2) {
      continue;
    }
    bead.turns.push_back(bead.points.size());
    const std::vector<std::size_t> kept = thinned(points, 0, points.size(), sampling);
    // A regular revolution ends where the next one begins.
    const bool continues = k + 1 < plan.turns.size() && k >= plan.startTurns &&
                           k + plan.endTurns + 1 < plan.turns.size();
    for (std::size_t i = 0; i + (continues ? 1 : 0) < kept.size(); ++i) {
      bead.points.push_back(points[kept[i]]);
      heights.add(points[kept[i]].height, plan.turns[k]);
    }
    for (std::size_t i = 1; i < points.size(); ++i) {
      up += (points[i].p - points[i - 1].p).cross(points[i].n);
    }
    tracing.report(static_cast<double>(k + 1) / static_cast<double>(plan.turns.size()));
  }
  if (bead.points.size() < 2) {
    throw Error(ErrorCode::JobFailed, "no revolution meets the part", "continuous spiral",
                "check the step and the part's borders");
  }
  judgeHeights(heights, wish, context);
  reportFieldSpiral(plan, heights, wall.total, context);
  SlicedLayers sliced;
  sliced.curved = true;
  SlicedLayer& layer = sliced.layers.emplace_back();
  layer.up = up.norm() > 0.0 ? Vec3(up.normalized()) : Vec3::UnitZ();
  layer.nominalHeight = wish.height;
  layer.contours.push_back(std::move(bead));
  return sliced;
}

}  // namespace wcam::toolpath
