// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodesic_seeds.hpp"

#include "wcam/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace wcam::geometry {

namespace {

constexpr std::uint32_t kNone = HalfEdges::kNone;
/// Weights below this are rounding of a point on an edge or at a corner.
constexpr double kNoWeight = 1e-12;
/// Weights may leave [0,1] and their sum 1 by this.
constexpr double kWeightSlack = 1e-6;
/// A curve that turns more than this (rad) at a point has a corner there, no curvature.
constexpr double kCornerTurn = 0.35;
/// A front that converges counts as straight from half its radius on.
constexpr double kLeastGrowth = 0.5;
/// Triangles that are unfolded one beyond the other around the source.
constexpr std::size_t kSeedDepth = 3;

[[noreturn]] void throwOffMesh(const Text& what) {
  throw Error(ErrorCode::InvalidArgument,
              text("the source of the distance does not lie on the mesh: %1", {what}),
              "geodesic distance", "give vertices, points and edges of this mesh");
}

/// A point of a curve with the curvature vector of the curve there, zero at corners and ends.
struct CurvePlace {
  Vec3 p = Vec3::Zero();
  Vec3 curvature = Vec3::Zero();
  bool corner = false;  ///< the curve ends or has a corner: it acts as a point there too
};

Vec3 curvatureAt(const Vec3& before, const Vec3& at, const Vec3& after, bool& corner) {
  const Vec3 a = at - before;
  const Vec3 b = after - at;
  const double la = a.norm();
  const double lb = b.norm();
  if (!(la > 0.0) || !(lb > 0.0)) {
    corner = true;
    return Vec3::Zero();
  }
  const Vec3 turn = b / lb - a / la;
  corner = turn.norm() > kCornerTurn;
  return corner ? Vec3(Vec3::Zero()) : Vec3(2.0 * turn / (la + lb));
}

class SeedMaker {
public:
  SeedMaker(const TriangleMesh& mesh, const HalfEdges& halfEdges)
      : mesh_(mesh), halfEdges_(halfEdges) {}

  void addVertex(std::uint32_t v) {
    if (v >= mesh_.vertices.size()) {
      throwOffMesh(text("vertex %1 does not exist", {std::to_string(v)}));
    }
    seeds_.push_back({v, 0.0, 0.0, true});
  }

  void addPoint(const MeshPoint& point) {
    check(point);
    const CurvePlace place{position(mesh_, point), Vec3::Zero(), true};
    // On an edge or at a corner the neighbours see the point as well.
    for (const std::uint32_t t : trianglesAt(point)) {
      seedCorners(t, place, place);
    }
  }

  void addCurve(const std::vector<MeshPoint>& curve, std::size_t index) {
    if (curve.size() == 1) {
      addPoint(curve.front());
      return;
    }
    std::vector<CurvePlace> places(curve.size());
    for (std::size_t i = 0; i < curve.size(); ++i) {
      check(curve[i]);
      places[i].p = position(mesh_, curve[i]);
    }
    const std::size_t last = curve.size() - 1;
    const bool closed = last > 1 && samePlace(places.front().p, places.back().p);
    for (std::size_t i = 0; i <= last; ++i) {
      const bool end = i == 0 || i == last;
      if (end && !closed) {
        places[i].corner = true;
        continue;
      }
      places[i].curvature = curvatureAt(places[end ? last - 1 : i - 1].p, places[i].p,
                                        places[end ? 1 : i + 1].p, places[i].corner);
    }
    for (std::size_t i = 0; i < last; ++i) {
      addSegment(curve[i], curve[i + 1], places[i], places[i + 1], index);
    }
  }

  void addEdges(const std::vector<std::uint32_t>& edges) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> byStart;
    for (const std::uint32_t h : edges) {
      if (h >= 3 * mesh_.triangles.size()) {
        throwOffMesh(text("half-edge %1 does not exist", {std::to_string(h)}));
      }
      byStart.emplace_back(startOf(h), h);
    }
    std::sort(byStart.begin(), byStart.end());
    std::vector<std::uint32_t> ends;
    for (const std::uint32_t h : edges) {
      // The edge that follows, when there is exactly one.
      const auto range =
          std::equal_range(byStart.begin(), byStart.end(), std::pair(endOf(h), std::uint32_t{0}),
                           [](const auto& a, const auto& b) { return a.first < b.first; });
      const bool single = range.second - range.first == 1;
      addEdgeEnd(h, single ? range.first->second : kNone);
      seeds_.push_back({startOf(h), 0.0, kStraightFront});
      const CurvePlace from{mesh_.vertices[startOf(h)], Vec3::Zero(), false};
      const CurvePlace to{mesh_.vertices[endOf(h)], Vec3::Zero(), false};
      if (halfEdges_.twin(h) != kNone) {
        seedCorners(h / 3, from, to);
        seedCorners(halfEdges_.twin(h) / 3, from, to);
      }
      ends.push_back(endOf(h));
    }
    // A chain of edges begins with a corner, too.
    std::sort(ends.begin(), ends.end());
    for (const std::uint32_t h : edges) {
      if (!std::binary_search(ends.begin(), ends.end(), startOf(h))) {
        seeds_.push_back({startOf(h), 0.0, kStraightFront, true});
      }
    }
  }

  std::vector<GeodesicSeed> take() { return std::move(seeds_); }

private:
  [[nodiscard]] std::uint32_t startOf(std::uint32_t h) const {
    return mesh_.triangles[h / 3][h % 3];
  }

  [[nodiscard]] std::uint32_t endOf(std::uint32_t h) const {
    return mesh_.triangles[h / 3][(h % 3 + 1) % 3];
  }

  static bool samePlace(const Vec3& a, const Vec3& b) {
    return (a - b).norm() <= kNoWeight * (a.norm() + b.norm());
  }

  void check(const MeshPoint& point) const {
    if (point.triangle >= mesh_.triangles.size()) {
      throwOffMesh(text("triangle %1 does not exist", {std::to_string(point.triangle)}));
    }
    double sum = 0.0;
    for (const double w : point.weights) {
      sum += w;
      if (!(w >= -kWeightSlack)) {
        throwOffMesh("a point has a negative weight");
      }
    }
    if (!(std::abs(sum - 1.0) <= kWeightSlack)) {
      throwOffMesh("the weights of a point do not sum to 1");
    }
  }

  /// Vertices on which a point stands.
  [[nodiscard]] std::vector<std::uint32_t> supportOf(const MeshPoint& point) const {
    std::vector<std::uint32_t> support;
    for (std::size_t c = 0; c < 3; ++c) {
      if (point.weights[c] > kNoWeight) {
        support.push_back(mesh_.triangles[point.triangle][c]);
      }
    }
    return support;
  }

  /// Triangles that hold a point: its own, those across its edge, or all around its vertex.
  [[nodiscard]] std::vector<std::uint32_t> trianglesAt(const MeshPoint& point) const {
    const std::vector<std::uint32_t> support = supportOf(point);
    std::vector<std::uint32_t> found{point.triangle};
    // Grows over edges as long as the neighbours hold the point; a ring is small.
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (std::uint32_t h = 3 * found[i]; h < 3 * found[i] + 3; ++h) {
        const std::uint32_t twin = halfEdges_.twin(h);
        if (twin != kNone && holds(twin / 3, support) &&
            std::find(found.begin(), found.end(), twin / 3) == found.end()) {
          found.push_back(twin / 3);
        }
      }
    }
    return found;
  }

  [[nodiscard]] bool holds(std::uint32_t t, const std::vector<std::uint32_t>& support) const {
    const auto& corners = mesh_.triangles[t];
    return std::all_of(support.begin(), support.end(), [&corners](std::uint32_t v) {
      return std::find(corners.begin(), corners.end(), v) != corners.end();
    });
  }

  void addSegment(const MeshPoint& a,
                  const MeshPoint& b,
                  const CurvePlace& from,
                  const CurvePlace& to,
                  std::size_t curve) {
    const std::vector<std::uint32_t> support = supportOf(b);
    bool found = false;
    for (const std::uint32_t t : trianglesAt(a)) {
      if (holds(t, support)) {
        found = true;
        seedCorners(t, from, to);
      }
    }
    if (!found) {
      throwOffMesh(
          text("two consecutive points of curve %1 share no triangle", {std::to_string(curve)}));
    }
  }

  /// Distance of the corners of a triangle to a segment in it, and of the corners beyond its edges
  /// to which straight ways lead: where the intrinsic mesh is another one, its triangles need them.
  void seedCorners(std::uint32_t t, const CurvePlace& from, const CurvePlace& to) {
    const auto& corners = mesh_.triangles[t];
    const Vec3& origin = mesh_.vertices[corners[0]];
    const Vec3 edge = mesh_.vertices[corners[1]] - origin;
    const Vec3 n = edge.cross(Vec3(mesh_.vertices[corners[2]] - origin));
    const double length = edge.norm();
    const double twiceArea = n.norm();
    const bool flat = length > 0.0 && twiceArea > 0.0;
    const Vec3 x = flat ? Vec3(edge / length) : Vec3(Vec3::UnitX());
    const Vec3 y = flat ? Vec3((n / twiceArea).cross(x)) : Vec3(Vec3::UnitY());
    const auto lay = [&](const Vec3& v) { return Vec2(x.dot(v), y.dot(v)); };
    Segment segment{lay(from.p - origin), lay(to.p - origin), lay(from.curvature),
                    lay(to.curvature),    from.corner,        to.corner};
    std::array<Vec2, 3> places;
    for (std::size_t c = 0; c < 3; ++c) {
      places[c] = lay(mesh_.vertices[corners[c]] - origin);
      seedVertex(corners[c], places[c], segment, {});
    }
    if (!flat) {
      return;
    }
    for (std::uint32_t c = 0; c < 3; ++c) {
      std::vector<std::array<Vec2, 2>> gates{{places[c], places[(c + 1) % 3]}};
      seedBeyond(3 * t + c, segment, gates);
    }
  }

  /// A piece of the source laid flat.
  struct Segment {
    Vec2 from, to;
    Vec2 curvatureFrom, curvatureTo;
    bool cornerFrom, cornerTo;
  };

  /// @param gates edges (right end, left end) through which the way must go
  /// @return whether a straight way leads there
  bool seedVertex(std::uint32_t v,
                  const Vec2& place,
                  const Segment& segment,
                  const std::vector<std::array<Vec2, 2>>& gates) {
    const Vec2 chord = segment.to - segment.from;
    const Vec2 offset = place - segment.from;
    const double square = chord.squaredNorm();
    const double along = square > 0.0 ? offset.dot(chord) / square : 0.0;
    const double w = std::clamp(along, 0.0, 1.0);
    const Vec2 way = offset - w * chord;
    const Vec2 foot = segment.from + w * chord;
    const auto side = [](const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); };
    for (const auto& gate : gates) {
      if (side(way, gate[0] - foot) * side(way, gate[1] - foot) > 0.0) {
        return false;
      }
    }
    const double d = way.norm();
    const bool besideEnd = square == 0.0 ? segment.cornerFrom
                           : along < 0.0 ? segment.cornerFrom
                                         : along > 1.0 && segment.cornerTo;
    const Vec2 curvature = (1.0 - w) * segment.curvatureFrom + w * segment.curvatureTo;
    const double bend = d > 0.0 ? -curvature.dot(way) / d : 0.0;
    const bool atEnd = (w == 0.0 && segment.cornerFrom) || (w == 1.0 && segment.cornerTo);
    seeds_.push_back({v, d, besideEnd ? d : frontRadius(bend, d), d == 0.0 && atEnd});
    return true;
  }

  /// Unfolds the triangle beyond a half-edge, whose place is the last gate.
  void seedBeyond(std::uint32_t h,
                  const Segment& segment,
                  std::vector<std::array<Vec2, 2>>& gates) {
    const std::uint32_t twin = halfEdges_.twin(h);
    if (twin == kNone || gates.size() > kSeedDepth) {
      return;
    }
    const auto [a, b] = gates.back();
    const std::uint32_t apex = mesh_.triangles[twin / 3][(twin % 3 + 2) % 3];
    const Vec3& pa = mesh_.vertices[startOf(h)];
    const Vec3 edge = mesh_.vertices[endOf(h)] - pa;
    const Vec3 offset = mesh_.vertices[apex] - pa;
    const double square = edge.squaredNorm();
    if (!(square > 0.0)) {
      return;
    }
    const double along = offset.dot(edge) / square;
    const double height = edge.cross(offset).norm() / square;
    const Vec2 flat = b - a;
    // The triangle lies on the right of its neighbour's edge.
    const Vec2 place = a + along * flat + height * Vec2(flat.y(), -flat.x());
    seedVertex(apex, place, segment, gates);
    // The twin runs from b to a, then to the apex.
    const std::uint32_t second = twin - twin % 3 + (twin % 3 + 1) % 3;
    const std::uint32_t third = twin - twin % 3 + (twin % 3 + 2) % 3;
    gates.push_back({a, place});
    seedBeyond(second, segment, gates);
    gates.back() = {place, b};
    seedBeyond(third, segment, gates);
    gates.pop_back();
  }

  /// Radius of a front at distance d from a curve of this curvature.
  static double frontRadius(double curvature, double d) {
    const double growth = 1.0 + curvature * d;
    return curvature == 0.0 || growth < kLeastGrowth ? kStraightFront : growth / curvature;
  }

  /// The end of h in a chain of edges: curvature seen from the triangles inside, or a corner.
  /// @param next the edge that follows, or kNone
  void addEdgeEnd(std::uint32_t h, std::uint32_t next) {
    if (next == kNone) {
      seeds_.push_back({endOf(h), 0.0, kStraightFront, true});
      return;
    }
    bool corner = false;
    const Vec3 curvature = curvatureAt(mesh_.vertices[startOf(h)], mesh_.vertices[endOf(h)],
                                       mesh_.vertices[endOf(next)], corner);
    const Vec3 n = mesh_.normal(h / 3) + mesh_.normal(next / 3);
    const Vec3 inward = n.cross(mesh_.vertices[endOf(next)] - mesh_.vertices[startOf(h)]);
    const double scale = inward.norm();
    // Inside the surface the front of one side spreads and that of the other converges.
    const bool border = halfEdges_.twin(h) == kNone && halfEdges_.twin(next) == kNone;
    const double bend = border && scale > 0.0 ? -curvature.dot(inward) / scale : 0.0;
    seeds_.push_back({endOf(h), 0.0, frontRadius(bend, 0.0), corner});
  }

  const TriangleMesh& mesh_;
  const HalfEdges& halfEdges_;
  std::vector<GeodesicSeed> seeds_;
};

}  // namespace

std::vector<GeodesicSeed> geodesicSeeds(const TriangleMesh& mesh,
                                        const HalfEdges& halfEdges,
                                        const GeodesicSource& source) {
  SeedMaker maker(mesh, halfEdges);
  maker.addEdges(source.borderEdges);
  for (std::size_t i = 0; i < source.curves.size(); ++i) {
    if (!source.curves[i].empty()) {
      maker.addCurve(source.curves[i], i);
    }
  }
  for (const MeshPoint& point : source.points) {
    maker.addPoint(point);
  }
  for (const std::uint32_t v : source.vertices) {
    maker.addVertex(v);
  }
  std::vector<GeodesicSeed> seeds = maker.take();
  if (seeds.empty()) {
    throw Error(ErrorCode::InvalidArgument, "the distance has no source", "geodesic distance",
                "give at least one vertex, point, curve or border edge");
  }
  return seeds;
}

}  // namespace wcam::geometry
