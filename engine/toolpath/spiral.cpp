// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/spiral.hpp"

#include "wcam/base/text.hpp"
#include "wcam/geometry/surface_projector.hpp"

#include "spiral_findings.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {

namespace {

/// Build direction of a point, and the length of the chord that tells it.
struct Direction {
  Vec3 b = Vec3::Zero();
  double chord = 0.0;
};

/// b = t × n of every point with t from the neighbours, on one side only at the seam, where ramps
/// have a step.
std::vector<Direction> buildDirections(const std::vector<ContourPoint>& points,
                                       const std::vector<std::size_t>& turns) {
  std::vector<bool> first(points.size() + 1, false);
  for (const std::size_t turn : turns) {
    first[turn] = true;
  }
  first[points.size()] = true;
  std::vector<Direction> directions(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t before = first[i] ? i : i - 1;
    const std::size_t after = first[i + 1] ? i : i + 1;
    const Vec3 chord = points[after].p - points[before].p;
    const Vec3 b = chord.cross(points[i].n);
    directions[i] = {b.norm() > 0.0 ? Vec3(b.normalized()) : Vec3::Zero(), chord.norm()};
  }
  return directions;
}

/// H = D·cos θ, θ between the step along the generatrix and b (Diourté M23), whatever the tilt.
/// Where generatrices run together so that the path has no direction of its own the step itself is
/// the height.
double depositHeight(const Vec3& step, const Vec3& b, double chord) {
  constexpr double kNoDirection = 1e-3;
  return chord > kNoDirection * step.norm() ? step.dot(b) : step.norm();
}

/// Drops points that coincide with the one before, as filled generatrices with a common end give.
void dropCoincident(Contour& contour, double apart) {
  std::vector<ContourPoint> points;
  std::vector<std::size_t> turns;
  std::size_t turn = 0;
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    const bool begins = turn < contour.turns.size() && contour.turns[turn] == i;
    if (begins) {
      turns.push_back(points.size());
      ++turn;
    }
    if (begins || points.empty() || (points.back().p - contour.points[i].p).norm() > apart) {
      points.push_back(contour.points[i]);
    }
  }
  contour.points = std::move(points);
  contour.turns = std::move(turns);
}

}  // namespace

SlicedLayers spiralAlong(const geometry::PartSurface& part,
                         const Generatrices& generatrices,
                         const SpiralPlan& plan,
                         const SpiralWish& wish,
                         const JobContext& context,
                         const std::optional<Sampling>& thinning) {
  const std::vector<Generatrix>& curves = generatrices.curves;
  std::vector<Vec3> wanted;
  std::vector<Vec3> steps;
  std::vector<std::size_t> turns;
  for (const SpiralTurn& turn : plan.turns) {
    turns.push_back(wanted.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const Vec3 p = curves[i].at(turn.position[i]);
      wanted.push_back(p);
      steps.push_back(p - curves[i].at(turn.position[i] - turn.step[i]));
    }
  }
  if (wish.end == SpiralEnd::Mirrored) {
    // The last revolution runs back to where it meets the border on the seam.
    wanted.push_back(curves.front().points().back());
    steps.push_back(Vec3::Zero());
  }
  const geometry::SurfaceProjector projector(part);
  Contour contour;
  for (const geometry::ProjectedPoint& point :
       projector.project(wanted, context.portion(0.0, 0.9, "projection"))) {
    contour.points.push_back({point.p, point.n});
  }
  const std::vector<Direction> up = buildDirections(contour.points, turns);
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    contour.points[i].height = depositHeight(steps[i], up[i].b, up[i].chord);
  }
  if (wish.end == SpiralEnd::Mirrored && contour.points.size() > 1) {
    contour.points.back().height = contour.points[contour.points.size() - 2].height;
  }
  contour.turns = turns;
  SpiralHeights heights;
  for (std::size_t i = 0; i < plan.turns.size() * curves.size(); ++i) {
    heights.add(contour.points[i].height, plan.turns[i / curves.size()]);
  }
  reportSpiralHeights(heights, context);
  // The finding tells true heights; a bead needs a positive one.
  constexpr double kLeastBead = 0.01;
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    contour.points[i].height = std::max(contour.points[i].height, kLeastBead * wish.height);
  }
  // A small part of a layer: nothing that a robot or a bead could tell apart.
  constexpr double kCoincident = 1e-4;
  dropCoincident(contour, kCoincident * wish.height);
  if (thinning) {
    thinSpiral(contour, *thinning);
  }
  Vec3 mean = Vec3::Zero();
  for (const Direction& direction : up) {
    mean += direction.b;
  }
  SlicedLayers sliced;
  sliced.curved = true;
  SlicedLayer layer;
  layer.up = mean.norm() > 0.0 ? Vec3(mean.normalized()) : Vec3::UnitZ();
  layer.nominalHeight = wish.height;
  layer.contours.push_back(std::move(contour));
  sliced.layers.push_back(std::move(layer));
  double shortest = curves.front().length();
  double longest = shortest;
  for (const Generatrix& curve : curves) {
    shortest = std::min(shortest, curve.length());
    longest = std::max(longest, curve.length());
  }
  context.add(
      {Severity::Information,
       "slicing.spiral",
       text("one bead of %1 revolutions, %2 to %3 mm deposit; generatrices of %4 to %5 mm",
            {std::to_string(plan.turns.size()), formatFixed(plan.regularMin, 3),
             formatFixed(plan.regularMax, 3), formatFixed(shortest, 2), formatFixed(longest, 2)}),
       "",
       {{}, 0, 0, -1},
       {{"revolutions", static_cast<double>(plan.turns.size())},
        {"start_revolutions", static_cast<double>(plan.startTurns)},
        {"end_revolutions", static_cast<double>(plan.endTurns)},
        {"deposit_min_mm", plan.regularMin},
        {"deposit_max_mm", plan.regularMax},
        {"deposit_mean_mm", plan.regularMean},
        {"shortest_mm", shortest},
        {"longest_mm", longest},
        {"seam_step_mm", plan.largestSeamStep},
        {"generatrices", static_cast<double>(curves.size())},
        {"filled", static_cast<double>(generatrices.filled)}}});
  return sliced;
}

}  // namespace wcam::toolpath
