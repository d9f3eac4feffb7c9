// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/geodesic.hpp"

#include "wcam/base/error.hpp"

#include "geodesic_seeds.hpp"
#include "intrinsic_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wcam::geometry {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Width of a bucket of the queue in typical edges: narrower ones are not worth their number,
/// wider ones visit vertices twice.
constexpr double kBucketWidth = 0.25;
constexpr std::size_t kMostBuckets = std::size_t{1} << 16;
/// A smaller gain, in parts of the typical edge, is not worth a second visit.
constexpr double kLeastGain = 1e-6;
/// Fronts of a greater radius, in parts of the edge, are straight within rounding.
constexpr double kStraight = 1e5;
/// A front that converges is not followed nearer to its focus than this part of a triangle's
/// height beyond the corner that it reaches.
constexpr double kNearFocus = 1.1;
/// Radii that are so near, in parts of the edge, belong to a point source: its distances differ
/// like the radii.
constexpr double kNearPoint = 16.0;
/// Radii whose sum falls short of the edge by more than rounding and curvature explain have no
/// common source; squared.
constexpr double kOneSource = 0.95;
/// A way along an edge and one beside it that differ by less than this part of the step are one
/// wave.
constexpr double kGraze = 0.005;
/// A ray may pass an end of the edge by this part of its length; the distance is then at most 1e-4
/// edges too small.
constexpr double kBeside = 0.01;
/// Vertices of the queue whose data is fetched while others are visited.
constexpr std::size_t kAhead = 4;
/// Visits between two looks at the request to cancel.
constexpr std::size_t kVisitsPerCheck = 1 << 16;

struct Wave {
  double distance = kInfinity;
  double radius = 0.0;  ///< of the front, mm; negative where it converges
};

/// A wave that crosses the edge ab and reaches the corner c, seen in units of the edge: all x and y
/// are times the length of ab.
struct Triangle {
  double square;     ///< of the length of ab
  double x;          ///< (c − a)·(b − a)
  double twiceArea;  ///< y of c
};

/// Radius of the front between two vertices.
double meanRadius(double a, double b, double edgeSquare) {
  if (a >= 0.0 && b >= 0.0 && a + b < kNearPoint * std::sqrt(edgeSquare)) {
    return 0.5 * (a + b);
  }
  if (std::isinf(a) || std::isinf(b)) {
    return std::isinf(a) ? (std::isinf(b) ? a : 2.0 * b) : 2.0 * a;
  }
  const double sum = a + b;
  return sum != 0.0 ? 2.0 * a * b / sum : kStraightFront;
}

/// Where the straight way to c enters: through the edge, or beyond one of its ends.
enum class Entry { Inside, BeyondA, BeyondB };

struct Arrival {
  Entry entry = Entry::Inside;
  Wave wave;
};

/// Whether a place on the edge is beyond its ends, 0 and `end`. A ray that grazes an end still
/// counts as crossing: beside a border it is the only one there is.
bool outside(double place, double end) {
  return place < -kBeside * end || place > (1.0 + kBeside) * end;
}

/// Distance of c from the source of which a and b know distance and front: the source is unfolded
/// into the plane of the triangle, where its distances to a and b differ like theirs.
Arrival cross(const Wave& a, const Wave& b, const Triangle& t) {
  Arrival arrival;
  const double difference = a.distance - b.distance;
  const double across = t.square - difference * difference;
  if (!(across > 0.0)) {
    arrival.entry = difference > 0.0 ? Entry::BeyondB : Entry::BeyondA;
    return arrival;
  }
  double r = meanRadius(a.radius, b.radius, t.square);
  const double mean = 0.5 * (a.distance + b.distance);
  if (!(r * r < kStraight * kStraight * t.square)) {
    const double sine = std::sqrt(across);
    // Times the edge's length: the way along the front's normal.
    const double low = t.x * sine + difference * t.twiceArea;
    if (outside(low, t.square * sine)) {
      arrival.entry = low < 0.0 ? Entry::BeyondA : Entry::BeyondB;
      return arrival;
    }
    arrival.wave.distance = a.distance + (sine * t.twiceArea - difference * t.x) / t.square;
    arrival.wave.radius = kStraightFront;
    return arrival;
  }
  if (r < 0.0) {
    // The focus stays beyond c.
    const double least =
        0.25 * t.square + kNearFocus * kNearFocus * t.twiceArea * t.twiceArea / t.square;
    r = r * r < least ? -std::sqrt(least) : r;
  }
  if (r >= 0.0 && 4.0 * r * r < kOneSource * t.square) {
    // No place has these distances to both: two sources.
    const double ac = t.twiceArea * t.twiceArea + t.x * t.x;
    const double bc = t.twiceArea * t.twiceArea + (t.x - t.square) * (t.x - t.square);
    const double length = std::sqrt(t.square);
    arrival.entry =
        length * difference + std::sqrt(ac) < std::sqrt(bc) ? Entry::BeyondA : Entry::BeyondB;
    return arrival;
  }
  const double sourceX = r * difference + 0.5 * t.square;
  const double height = 0.5 * std::sqrt(across * std::max(0.0, 4.0 * r * r - t.square));
  const double sourceY = r < 0.0 ? height : -height;
  // The line from c through the source meets the edge at x = low / span.
  const double span = r < 0.0 ? sourceY - t.twiceArea : t.twiceArea - sourceY;
  const double low =
      r < 0.0 ? t.x * sourceY - sourceX * t.twiceArea : sourceX * t.twiceArea - t.x * sourceY;
  if (outside(low, t.square * span)) {
    arrival.entry = low < 0.0 ? Entry::BeyondA : Entry::BeyondB;
    return arrival;
  }
  const double dx = t.x - sourceX;
  const double dy = t.twiceArea - sourceY;
  const double reach = std::sqrt((dx * dx + dy * dy) / t.square);
  arrival.wave.distance = r < 0.0 ? mean - r - reach : mean - r + reach;
  arrival.wave.radius = r < 0.0 ? -reach : reach;
  return arrival;
}

/// One run of the propagation.
class Propagation {
public:
  Propagation(const IntrinsicMesh& mesh, double limit)
      : mesh_(mesh),
        limit_(limit),
        waves_(mesh.vertexCount()),
        waiting_(mesh.vertexCount(), 0),
        kind_(mesh.vertexCount(), Kind::Crossed) {
    leastGain_ = kLeastGain * mesh.typicalEdge();
    width_ = std::max(kBucketWidth * mesh.typicalEdge(),
                      mesh.longestEdge() / static_cast<double>(kMostBuckets / 2));
    const double span = width_ > 0.0 ? mesh.longestEdge() / width_ : 0.0;
    buckets_.resize(static_cast<std::size_t>(span) + 4);
  }

  void seed(const std::vector<GeodesicSeed>& seeds) {
    for (const GeodesicSeed& s : seeds) {
      Wave& wave = waves_[s.vertex];
      if (s.distance < wave.distance) {
        wave = {s.distance, s.radius};
        kind_[s.vertex] = s.distance == 0.0 ? Kind::Source : Kind::Crossed;
      }
      if (s.fan) {
        kind_[s.vertex] = Kind::Fan;
      }
    }
    for (const GeodesicSeed& s : seeds) {
      push(s.vertex);
    }
  }

  std::vector<double> run(const JobContext& context) {
    std::size_t visits = 0;
    while (queued_ > 0) {
      if (static_cast<double>(current_) * width_ > limit_) {
        break;
      }
      auto& bucket = buckets_[current_ % buckets_.size()];
      // Visits may add to the bucket.
      for (std::size_t i = 0; i < bucket.size(); ++i) {
        const std::uint32_t v = bucket[i];
        if (i + 2 * kAhead < bucket.size()) {
          mesh_.prefetchCorners(bucket[i + 2 * kAhead]);
        }
        if (i + kAhead < bucket.size()) {
          mesh_.prefetchTriangles(bucket[i + kAhead]);
        }
        if (waiting_[v] != 0) {
          waiting_[v] = 0;
          visit(v);
          if (++visits % kVisitsPerCheck == 0) {
            context.check();
          }
        }
      }
      queued_ -= bucket.size();
      bucket.clear();
      ++current_;
    }
    std::vector<double> distance(waves_.size());
    for (std::size_t v = 0; v < distance.size(); ++v) {
      distance[v] = waves_[v].distance <= limit_ ? waves_[v].distance : kInfinity;
    }
    return distance;
  }

private:
  /// Where the wave of a vertex comes from.
  enum class Kind : std::uint8_t {
    Crossed,  ///< through a triangle
    Along,    ///< along an edge
    Source,   ///< it lies on a smooth part of the source
    Fan       ///< it lies on the source, ways leave it in all directions
  };

  void push(std::uint32_t v) {
    waiting_[v] = 1;
    const auto wanted = width_ > 0.0 ? static_cast<std::size_t>(waves_[v].distance / width_) : 0;
    buckets_[std::max(wanted, current_) % buckets_.size()].push_back(v);
    ++queued_;
  }

  void visit(std::uint32_t v) {
    for (const std::uint32_t* it = mesh_.cornersBegin(v); it != mesh_.cornersEnd(v); ++it) {
      const std::uint32_t c = *it % 3;
      const FlatTriangle& t = mesh_.triangle(*it / 3);
      const std::uint32_t n = c == 2 ? 0 : c + 1;
      const std::uint32_t p = c == 0 ? 2 : c - 1;
      const double x = 0.5 * (t.square[c] + t.square[p] - t.square[n]);
      update(v, t.corner[n], t.corner[p], {t.square[c], x, t.twiceArea}, t.square[p], t.square[n]);
      update(v, t.corner[p], t.corner[n], {t.square[p], x, t.twiceArea}, t.square[c], t.square[n]);
    }
  }

  /// @param ac, bc squares of the lengths of these edges
  void update(
      std::uint32_t a, std::uint32_t b, std::uint32_t c, const Triangle& t, double ac, double bc) {
    const Wave& from = waves_[a];
    const Wave& beside = waves_[b];
    const double before = waves_[c].distance;
    // What comes through the edge is not nearer than both of its ends.
    if (before <= std::min(from.distance, beside.distance)) {
      return;
    }
    if (waiting_[b] != 0 || beside.distance == kInfinity) {
      along(a, c, ac, before);  // through the edge when b is visited
      return;
    }
    const Arrival arrival = cross(from, beside, t);
    if (arrival.entry == Entry::Inside) {
      // Near a focus the front misleads; no point is farther than along an edge.
      const double fromA = arrival.wave.distance - from.distance;
      if (fromA > 0.0 && fromA * fromA > ac) {
        along(a, c, ac, before);
        return;
      }
      const double fromB = arrival.wave.distance - beside.distance;
      if (fromB > 0.0 && fromB * fromB > bc) {
        along(b, c, bc, before);
        return;
      }
      offer(c, arrival.wave, arrival.wave.distance - 0.5 * (from.distance + beside.distance),
            before);
    } else if (arrival.entry == Entry::BeyondA) {
      along(a, c, ac, before);
    } else {
      along(b, c, bc, before);
    }
  }

  /// The way along the edge from a to c.
  void along(std::uint32_t a, std::uint32_t c, double square, double before) {
    const Wave& from = waves_[a];
    // Most offers fail, so the root waits.
    const double room = before - from.distance;
    if (room <= 0.0 || square >= room * room) {
      return;
    }
    const double length = std::sqrt(square);
    const double distance = from.distance + length;
    const double gain = before - distance;
    if (gain <= leastGain_) {
      return;
    }
    if (kind_[c] == Kind::Crossed && gain < kGraze * length) {
      // The same wave, seen a little better along the edge.
      waves_[c].distance = distance;
      push(c);
      return;
    }
    const bool fresh = kind_[a] == Kind::Fan || (kind_[a] != Kind::Source && mesh_.bends(a));
    waves_[c] = {distance, bent(fresh ? length : from.radius + length, c, length)};
    kind_[c] = Kind::Along;
    push(c);
  }

  /// Takes a wave that crosses an edge when it is nearer than what the vertex has, or as near as
  /// the way along an edge, which says nothing of the front.
  void offer(std::uint32_t c, const Wave& wave, double step, double before) {
    const double gain = before - wave.distance;
    if (gain > leastGain_) {
      waves_[c].distance = wave.distance;
    } else if (kind_[c] != Kind::Along || gain < -kGraze * std::abs(step)) {
      return;
    }
    waves_[c].radius = bent(wave.radius, c, step);
    kind_[c] = Kind::Crossed;
    push(c);
  }

  /// Radius of a front after a step on a curved surface: its curvature κ follows κ' = −κ² − K.
  [[nodiscard]] double bent(double radius, std::uint32_t v, double step) const {
    const double bend = mesh_.curvature(v) * step;
    if (std::isinf(radius)) {
      return bend != 0.0 ? -1.0 / bend : radius;
    }
    const double denominator = 1.0 - bend * radius;
    return denominator != 0.0 ? radius / denominator : kStraightFront;
  }

  const IntrinsicMesh& mesh_;
  double limit_;
  double leastGain_ = 0.0;
  double width_ = 0.0;
  std::vector<Wave> waves_;
  std::vector<std::uint8_t> waiting_;
  std::vector<Kind> kind_;
  std::vector<std::vector<std::uint32_t>> buckets_;
  std::size_t current_ = 0;
  std::size_t queued_ = 0;
};

}  // namespace

namespace {

/// Edges of the mesh that the intrinsic one does not have are ways, too. Sweeps until nothing
/// changes; few vertices do, so two or three sweeps are the rule.
void shortenAlongEdges(const TriangleMesh& mesh, double limit, std::vector<double>& distance) {
  constexpr int kMostSweeps = 100;
  bool changed = true;
  for (int sweep = 0; changed && sweep < kMostSweeps; ++sweep) {
    changed = false;
    for (const auto& corners : mesh.triangles) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t a = corners[c];
        const std::uint32_t b = corners[(c + 1) % 3];
        const double length = (mesh.vertices[b] - mesh.vertices[a]).norm();
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
          const double way = distance[from] + length;
          // Less than this is rounding.
          if (way <= limit && way < distance[to] - kLeastGain * length) {
            distance[to] = way;
            changed = true;
          }
        }
      }
    }
  }
}

}  // namespace

struct GeodesicSolver::Impl {
  Impl(const TriangleMesh& m, const HalfEdges& h) : mesh(m), halfEdges(h), intrinsic(m, h) {}

  const TriangleMesh& mesh;
  const HalfEdges& halfEdges;
  IntrinsicMesh intrinsic;
};

GeodesicSolver::GeodesicSolver(const TriangleMesh& mesh, const HalfEdges& halfEdges)
    : impl_(std::make_unique<Impl>(mesh, halfEdges)) {}

GeodesicSolver::~GeodesicSolver() = default;
GeodesicSolver::GeodesicSolver(GeodesicSolver&&) noexcept = default;
GeodesicSolver& GeodesicSolver::operator=(GeodesicSolver&&) noexcept = default;

std::vector<double> GeodesicSolver::distance(const GeodesicSource& source,
                                             double limit,
                                             const JobContext& context) const {
  Propagation propagation(impl_->intrinsic, limit);
  propagation.seed(geodesicSeeds(impl_->mesh, impl_->halfEdges, source));
  std::vector<double> result = propagation.run(context);
  if (impl_->intrinsic.flips() > 0) {
    shortenAlongEdges(impl_->mesh, limit, result);
  }
  return result;
}

}  // namespace wcam::geometry
