// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/geometry/geodesic.hpp"

#include "wall_decomposition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace wcam::toolpath {

namespace {

using geometry::HalfEdges;
using geometry::MeshPoint;

/// Half-edges of the edges of a border loop, in its order and whichever way it runs.
std::vector<std::uint32_t> loopHalfEdges(const geometry::PartSurface& part,
                                         const std::vector<std::uint32_t>& loop) {
  const HalfEdges& halfEdges = part.halfEdges;
  std::vector<std::pair<std::array<std::uint32_t, 2>, std::uint32_t>> border;
  for (std::uint32_t e = 0; e < halfEdges.edgeCount(); ++e) {
    const std::uint32_t h = halfEdges.halfEdgeOf(e);
    if (halfEdges.twin(h) == HalfEdges::kNone) {
      border.emplace_back(halfEdges.edgeVertices(e), h);
    }
  }
  std::sort(border.begin(), border.end());
  std::vector<std::uint32_t> edges;
  edges.reserve(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto ends = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
    const std::array<std::uint32_t, 2> key{ends.first, ends.second};
    const auto found = std::lower_bound(border.begin(), border.end(), std::pair{key, 0U});
    edges.push_back(found != border.end() && found->first == key ? found->second
                                                                 : HalfEdges::kNone);
  }
  return edges;
}

/// The point at fraction w from vertex `from` on a half-edge that has it as one end.
MeshPoint pointOnHalfEdge(const geometry::TriangleMesh& mesh,
                          std::uint32_t halfEdge,
                          std::uint32_t from,
                          double w) {
  MeshPoint point;
  point.triangle = halfEdge / 3;
  const std::uint32_t corner = halfEdge % 3;
  const bool forward = mesh.triangles[point.triangle][corner] == from;
  point.weights = {0.0, 0.0, 0.0};
  point.weights[corner] = forward ? 1.0 - w : w;
  point.weights[(corner + 1) % 3] = forward ? w : 1.0 - w;
  return point;
}

/// Points of the lower loop at equal arc lengths, in the direction of travel.
std::vector<MeshPoint> startPoints(const Wall& wall, std::size_t count) {
  // The loop runs with the material on its left; the bead runs the other way (t × n = up).
  std::vector<std::uint32_t> loop(wall.limits.lower.rbegin(), wall.limits.lower.rend());
  const Loop points(loopPoints(wall.part->mesh, loop));
  const std::vector<std::uint32_t> edges = loopHalfEdges(*wall.part, loop);
  std::vector<MeshPoint> starts;
  std::size_t i = 0;
  double begin = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const double wanted = points.length() * static_cast<double>(k) / static_cast<double>(count);
    double size = (points.points()[(i + 1) % loop.size()] - points.points()[i]).norm();
    while (i + 1 < loop.size() && begin + size < wanted) {
      begin += size;
      ++i;
      size = (points.points()[(i + 1) % loop.size()] - points.points()[i]).norm();
    }
    if (edges[i] != HalfEdges::kNone) {
      starts.push_back(
          pointOnHalfEdge(wall.part->mesh, edges[i], loop[i],
                          size > 0.0 ? std::clamp((wanted - begin) / size, 0.0, 1.0) : 0.0));
    }
  }
  return starts;
}

/// A curve by its places on the level curves of the wall: arc length on each in parts of its
/// length, followed from level to level without a jump.
struct PlacedCurve {
  Generatrix curve;
  std::vector<double> places;
};

/// How far the next curve is ahead on a level, in parts of the loop: little on the lowest, where
/// curves start in order, and from there on what both have drifted.
double ahead(const PlacedCurve& from, const PlacedCurve& to, std::size_t level) {
  // Starts that touch may stand in reverse order by rounding.
  constexpr double kReversed = 0.75;
  const double apart = to.places.front() - from.places.front();
  const double start = apart - std::floor(apart);
  return (start > kReversed ? start - 1.0 : start) + (to.places[level] - to.places.front()) -
         (from.places[level] - from.places.front());
}

std::vector<double> placesOf(const Generatrix& curve, const WallLoops& levels) {
  std::vector<double> places;
  const auto last = static_cast<double>(levels.loops.size() - (levels.closure ? 0 : 1));
  for (std::size_t k = 0; k < levels.loops.size(); ++k) {
    const Loop& loop = levels.loops[k];
    const double place =
        loop.nearest(curve.at(static_cast<double>(k) / last * curve.length())) / loop.length();
    places.push_back(k > 0 ? place + std::round(places.back() - place) : place);
  }
  return places;
}

/// The curve half way between two others on every level. Halving on the surface also fills gaps as
/// wide as half the part, where the mean of two points lies inside it.
PlacedCurve median(const WallLoops& levels, const PlacedCurve& a, const PlacedCurve& b) {
  std::vector<Vec3> points;
  std::vector<double> places;
  for (std::size_t k = 0; k < levels.loops.size(); ++k) {
    places.push_back(a.places[k] + 0.5 * ahead(a, b, k));
    points.push_back(levels.loops[k].at(places.back() * levels.loops[k].length()));
  }
  if (levels.closure) {
    points.push_back(*levels.closure);
  }
  return {Generatrix(std::move(points)), std::move(places)};
}

double widestGap(const WallLoops& levels, const PlacedCurve& a, const PlacedCurve& b) {
  double widest = 0.0;
  for (std::size_t k = 0; k < levels.loops.size(); ++k) {
    widest = std::max(widest, ahead(a, b, k) * levels.loops[k].length());
  }
  return widest;
}

/// Inserts medians until no gap between neighbours is wider than `coverage` (M14, with the width of
/// the gap on the surface as its measure).
void fillGaps(Generatrices& result,
              const WallLoops& levels,
              double coverage,
              const JobContext& context) {
  // Each round halves the gaps.
  constexpr int kRounds = 16;
  std::vector<PlacedCurve> curves;
  for (Generatrix& curve : result.curves) {
    std::vector<double> places = placesOf(curve, levels);
    curves.push_back({std::move(curve), std::move(places)});
  }
  const std::size_t before = curves.size();
  for (int round = 0; round < kRounds; ++round) {
    context.check();
    std::vector<PlacedCurve> filled;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const PlacedCurve& next = curves[(i + 1) % curves.size()];
      filled.push_back(curves[i]);
      if (widestGap(levels, curves[i], next) > coverage) {
        filled.push_back(median(levels, curves[i], next));
      }
    }
    const bool done = filled.size() == curves.size();
    curves = std::move(filled);
    if (done) {
      break;
    }
  }
  result.filled = curves.size() - before;
  result.curves.clear();
  for (PlacedCurve& placed : curves) {
    result.curves.push_back(std::move(placed.curve));
  }
}

}  // namespace

Generatrices decomposeByGeodesics(const Wall& wall,
                                  const GeneratrixOptions& options,
                                  const JobContext& context) {
  const geometry::PartSurface& part = *wall.part;
  const geometry::GeodesicSolver solver(part.mesh, part.halfEdges);
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  Generatrices result;
  geometry::GeodesicSource target;
  if (wall.upper) {
    target.borderEdges = loopHalfEdges(part, wall.limits.upper);
  } else {
    // The closure point is the farthest from the lower border (M15, Eq. 3.10).
    geometry::GeodesicSource lower;
    lower.borderEdges = loopHalfEdges(part, wall.limits.lower);
    const std::vector<double> away = solver.distance(lower, kNoLimit, context);
    std::uint32_t closure = 0;
    double farthest = -1.0;
    for (std::uint32_t v = 0; v < away.size(); ++v) {
      if (std::isfinite(away[v]) && away[v] > farthest) {
        farthest = away[v];
        closure = v;
      }
    }
    target.vertices = {closure};
    result.closes = true;
    result.closure = part.mesh.vertices[closure];
  }
  const std::vector<double> distance =
      solver.distance(target, kNoLimit, context.portion(0.0, 0.4, "distance"));
  std::vector<Loop> limits{wall.lower};
  if (wall.upper) {
    limits.push_back(*wall.upper);
  }
  const std::size_t count =
      options.count > 0 ? options.count : curveCount(limits, options.sampling);
  const std::vector<MeshPoint> starts = startPoints(wall, count);
  std::vector<std::vector<Vec3>> paths(starts.size());
  constexpr std::size_t kPathGrain = 8;
  parallelFor(
      starts.size(), kPathGrain,
      [&](std::size_t i) {
        for (const MeshPoint& point :
             geometry::descend(part.mesh, part.halfEdges, distance, starts[i])) {
          paths[i].push_back(geometry::position(part.mesh, point));
        }
        if (result.closes && !paths[i].empty()) {
          paths[i].push_back(result.closure);
        }
      },
      context);
  for (std::vector<Vec3>& path : paths) {
    if (path.size() < 2) {
      throw Error(ErrorCode::JobFailed, "no way leads from the lower border to the upper limit",
                  "continuous spiral", "the part must be one connected surface: repair it");
    }
    std::vector<Vec3> points;
    for (const geometry::ProjectedPoint& point : wall.projector->project(path, context)) {
      points.push_back(point.p);
    }
    result.curves.emplace_back(std::move(points));
  }
  // Neighbours spread and close up along a part of varying section; a gap is far wider than that.
  constexpr double kGap = 3.0;
  double around = 0.0;
  for (const Loop& limit : limits) {
    around = std::max(around, limit.length());
  }
  const double coverage = options.coverage > 0.0
                              ? options.coverage
                              : std::max(options.step, kGap * around / static_cast<double>(count));
  const WallLoops levels = loopsOf(wall, options.step, context.portion(0.6, 0.9, "levels"));
  fillGaps(result, levels, coverage, context);
  return result;
}

}  // namespace wcam::toolpath
