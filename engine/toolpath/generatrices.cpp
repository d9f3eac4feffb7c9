// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/generatrices.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/level_set.hpp"

#include "wall_decomposition.hpp"
#include "wall_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath {

Generatrix::Generatrix(std::vector<Vec3> points) : points_(std::move(points)) {
  arc_.push_back(0.0);
  for (std::size_t i = 1; i < points_.size(); ++i) {
    arc_.push_back(arc_.back() + (points_[i] - points_[i - 1]).norm());
  }
}

Vec3 Generatrix::at(double arc) const {
  const auto next = std::upper_bound(arc_.begin(), arc_.end(), arc);
  if (next == arc_.begin()) {
    return points_.front();
  }
  if (next == arc_.end()) {
    return points_.back();
  }
  const auto i = static_cast<std::size_t>(next - arc_.begin());
  const double w = (arc - arc_[i - 1]) / (arc_[i] - arc_[i - 1]);
  return points_[i - 1] + w * (points_[i] - points_[i - 1]);
}

std::vector<Vec3> loopPoints(const geometry::TriangleMesh& mesh,
                             const std::vector<std::uint32_t>& vertices) {
  std::vector<Vec3> points;
  points.reserve(vertices.size());
  for (const std::uint32_t v : vertices) {
    points.push_back(mesh.vertices[v]);
  }
  return points;
}

Loop orientedLike(Loop loop, const Loop& reference) {
  // Places around the loop that vote; loops that are neighbours agree nearly everywhere.
  constexpr int kVotes = 32;
  double sum = 0.0;
  for (int i = 0; i < kVotes; ++i) {
    const double arc = loop.length() * i / kVotes;
    sum += loop.direction(arc).dot(reference.direction(reference.nearest(loop.at(arc))));
  }
  return sum < 0.0 ? loop.reversed() : loop;
}

std::size_t curveCount(const std::vector<Loop>& loops, const Sampling& sampling) {
  // A spiral of more points per revolution than this serves no robot.
  constexpr std::size_t kMost = 4096;
  constexpr std::size_t kLeast = 12;
  std::size_t count = kLeast;
  for (const Loop& loop : loops) {
    const double bySpacing = std::ceil(loop.length() / sampling.maxSpacing);
    count =
        std::max(count, static_cast<std::size_t>(std::min(bySpacing, static_cast<double>(kMost))));
  }
  const auto deviates = [&](std::size_t n) {
    return std::any_of(loops.begin(), loops.end(),
                       [&](const Loop& loop) { return loop.deviation(n) > sampling.chordError; });
  };
  while (count < kMost && deviates(count)) {
    count = std::min(kMost, count + std::max<std::size_t>(count / 4, 1));
  }
  return count;
}

namespace {

/// Levels of a field that lie about `spacing` apart on the surface, the field's ends left out.
std::vector<double> evenLevels(const MeanHeight& height, double spacing) {
  const auto count = static_cast<std::size_t>(std::ceil(height.total() / spacing));
  std::vector<double> levels;
  for (std::size_t k = 1; k < count; ++k) {
    levels.push_back(
        height.levelAt(height.total() * static_cast<double>(k) / static_cast<double>(count)));
  }
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

[[noreturn]] void refuseBranches(double level,
                                 const geometry::LevelContour& second,
                                 std::size_t count) {
  const Vec3& p = second.points.front();
  throw Error(
      ErrorCode::JobFailed,
      text("the part branches: at %1 % of its height there are %2 curves, one of them at (%3, %4, "
           "%5)",
           {formatFixed(100.0 * level, 1), std::to_string(count), formatFixed(p.x(), 1),
            formatFixed(p.y(), 1), formatFixed(p.z(), 1)}),
      "continuous spiral",
      "a spiral needs a part with a single branch: slice it with the strategy for branches, "
      "or select the faces of one branch");
}

/// The level curves of a field, lowest first, all in the direction of travel.
std::vector<Loop> levelLoops(const Wall& wall,
                             const WallField& field,
                             const std::vector<double>& levels,
                             const JobContext& context) {
  const geometry::PartSurface& part = *wall.part;
  constexpr double kFieldSnap = 1e-11;
  const auto traced = geometry::traceLevels(part.mesh, part.halfEdges, field.values, levels,
                                            kFieldSnap * field.end, context);
  std::vector<Loop> loops;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const geometry::LevelContour* only = nullptr;
    std::size_t count = 0;
    for (const geometry::LevelContour& contour : traced[k]) {
      if (contour.points.size() > 2) {
        only = &contour;
        ++count;
      }
    }
    if (count != 1 || !only->closed) {
      if (count > 1) {
        refuseBranches(levels[k] / field.end, *only, count);
      }
      throw Error(ErrorCode::JobFailed,
                  text("the curve at %1 % of the part's height is not closed",
                       {formatFixed(100.0 * levels[k] / field.end, 1)}),
                  "continuous spiral",
                  "a spiral runs around a tube or a cap: close slits in the surface, or slice it "
                  "with open beads");
    }
    std::vector<Vec3> points;
    for (const geometry::ProjectedPoint& point : wall.projector->project(only->points, context)) {
      points.push_back(point.p);
    }
    loops.emplace_back(std::move(points));
  }
  return loops;
}

}  // namespace

WallLoops loopsOf(const Wall& wall, double spacing, const JobContext& context) {
  const geometry::PartSurface& part = *wall.part;
  const WallField field = wallField(part, wall.limits, context.portion(0.0, 0.6, "field"));
  const std::vector<double> levels =
      evenLevels(MeanHeight(part.mesh, field.values, field.end), spacing);
  WallLoops result;
  result.loops = levelLoops(wall, field, levels, context.portion(0.6, 1.0, "levels"));
  if (result.loops.empty()) {
    throw Error(ErrorCode::JobFailed, "the part is lower than one layer", "continuous spiral",
                "choose a smaller step");
  }
  result.loops.insert(result.loops.begin(), orientedLike(wall.lower, result.loops.front()));
  if (wall.upper) {
    result.loops.push_back(orientedLike(*wall.upper, result.loops.back()));
  }
  if (field.closure) {
    result.closure = part.mesh.vertices[*field.closure];
  }
  return result;
}

namespace {

/// From a start on the first loop to the nearest point of each next one: arc lengths, and how long
/// the way is (M19).
std::pair<std::vector<double>, double> chainFrom(const std::vector<Loop>& loops, double start) {
  std::vector<double> arcs{start};
  double length = 0.0;
  Vec3 here = loops.front().at(start);
  for (std::size_t k = 1; k < loops.size(); ++k) {
    arcs.push_back(loops[k].nearest(here));
    const Vec3 next = loops[k].at(arcs.back());
    length += (next - here).norm();
    here = next;
  }
  return {std::move(arcs), length};
}

}  // namespace

Generatrices decomposeByIsoValues(const Wall& wall,
                                  const GeneratrixOptions& options,
                                  const JobContext& context) {
  // Chords of a generatrix between levels half a step apart cut the arc by less than the step's own
  // chord does.
  constexpr double kLevelsPerStep = 2.0;
  const WallLoops wallLoops =
      loopsOf(wall, options.step / kLevelsPerStep, context.portion(0.0, 0.7, "levels"));
  const std::vector<Loop>& loops = wallLoops.loops;
  // Starts that compete for the principal generatrix.
  constexpr int kStarts = 48;
  std::vector<double> principal;
  double shortest = std::numeric_limits<double>::infinity();
  for (int s = 0; s < kStarts; ++s) {
    context.check();
    auto [arcs, length] = chainFrom(loops, loops.front().length() * s / kStarts);
    // Symmetric parts have many equal ways: the first one stays.
    constexpr double kTie = 1e-9;
    if (length < shortest * (1.0 - kTie)) {
      shortest = length;
      principal = std::move(arcs);
    }
  }
  const std::size_t count = options.count > 0 ? options.count : curveCount(loops, options.sampling);
  std::vector<std::vector<Vec3>> curves(count);
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const std::vector<Vec3> around = loops[k].resampled(count, principal[k]);
    for (std::size_t i = 0; i < count; ++i) {
      curves[i].push_back(around[i]);
    }
  }
  Generatrices result;
  if (wallLoops.closure) {
    result.closes = true;
    result.closure = *wallLoops.closure;
    for (std::vector<Vec3>& curve : curves) {
      curve.push_back(result.closure);
    }
  }
  for (std::vector<Vec3>& curve : curves) {
    result.curves.emplace_back(std::move(curve));
  }
  return result;
}

Generatrices decomposeWall(const geometry::PartSurface& part,
                           const WallLimits& limits,
                           const GeneratrixOptions& options,
                           const JobContext& context) {
  if (limits.lower.size() < 3) {
    throw Error(ErrorCode::JobFailed, "the part has no lower border to start from",
                "continuous spiral",
                "a closed surface has no border: select the faces of the wall, without the bottom");
  }
  const geometry::SurfaceProjector projector(part);
  Wall wall{&part, &projector, limits, Loop(loopPoints(part.mesh, limits.lower)), std::nullopt};
  if (!limits.upper.empty()) {
    wall.upper.emplace(loopPoints(part.mesh, limits.upper));
  }
  switch (options.method) {
    case Decomposition::IsoValues:
      return decomposeByIsoValues(wall, options, context);
    case Decomposition::Geodesic:
      return decomposeByGeodesics(wall, options, context);
    case Decomposition::Envelope:
      return decomposeByEnvelope(wall, options, context);
  }
  return {};
}

}  // namespace wcam::toolpath
