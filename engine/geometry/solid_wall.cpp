// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/solid_wall.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/base/sha256.hpp"
#include "wcam/geometry/aabb_tree.hpp"
#include "wcam/geometry/cut_mesh.hpp"
#include "wcam/geometry/refine.hpp"
#include "wcam/geometry/surface_projector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace wcam::geometry {

namespace {

constexpr std::size_t kGrain = 256;
/// Two sides look at each other when their normals are farther apart than 120 degrees: walls may
/// taper by 30 degrees on either side.
constexpr double kOpposed = -0.5;
/// What is thicker than this many usual thicknesses is not seen across the wall but along it.
constexpr double kThickest = 3.0;
/// A ray starts this part of the part's size below its own triangle.
constexpr double kLeave = 1e-9;
/// Areas of sides that differ by less (relative) are equal: the two sides of a flat wall.
constexpr double kEqualArea = 1e-6;
/// Edges of the refined outer side in usual thicknesses: the middle surface follows a thickness
/// that changes along a flat face.
constexpr double kEdge = 4.0;

enum class Colour : signed char { Rim = -1, Outer = 0, Inner = 1 };

[[noreturn]] void refuse(const Text& why) {
  throw Error(ErrorCode::JobFailed, why, "working surface of a solid wall",
              "take the whole surface, or pick the faces of the working surface");
}

/// What a ray into the material meets.
struct Opposite {
  std::uint32_t triangle = HalfEdges::kNone;
  double distance = 0.0;
};

double areaOf(const TriangleMesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  return 0.5 * (mesh.vertices[v[1]] - mesh.vertices[v[0]])
                   .cross(Vec3(mesh.vertices[v[2]] - mesh.vertices[v[0]]))
                   .norm();
}

std::vector<Opposite> lookAcross(const TriangleMesh& mesh, const JobContext& context) {
  const AabbTree tree(mesh);
  const double leave = kLeave * mesh.bounds().diagonal();
  std::vector<Opposite> opposite(mesh.triangles.size());
  parallelFor(
      mesh.triangles.size(), kGrain,
      [&](std::size_t t) {
        const Vec3 n = mesh.normal(t);
        if (n.isZero()) {
          return;
        }
        const auto& v = mesh.triangles[t];
        const Vec3 centre = (mesh.vertices[v[0]] + mesh.vertices[v[1]] + mesh.vertices[v[2]]) / 3.0;
        const auto hit = tree.firstHit(centre - leave * n, -n);
        if (hit && hit->triangle != t && n.dot(mesh.normal(hit->triangle)) <= kOpposed) {
          opposite[t] = {hit->triangle, hit->distance + leave};
        }
      },
      context);
  return opposite;
}

/// Distance below which half of the opposed area lies.
double usualThickness(const std::vector<Opposite>& opposite, const std::vector<double>& area) {
  std::vector<std::size_t> order;
  double total = 0.0;
  for (std::size_t t = 0; t < opposite.size(); ++t) {
    if (opposite[t].triangle != HalfEdges::kNone) {
      order.push_back(t);
      total += area[t];
    }
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return opposite[a].distance != opposite[b].distance
               ? opposite[a].distance < opposite[b].distance
               : a < b;
  });
  double sum = 0.0;
  for (const std::size_t t : order) {
    sum += area[t];
    if (sum >= 0.5 * total) {
      return opposite[t].distance;
    }
  }
  return 0.0;
}

/// Groups of triangles that edges join and that agree in a label; by lowest triangle.
struct Groups {
  std::vector<std::uint32_t> of;  ///< per triangle
  std::size_t count = 0;
};

template <class Label>
Groups groupsOf(const HalfEdges& halfEdges, std::size_t triangles, const Label& label) {
  Groups groups;
  groups.of.assign(triangles, HalfEdges::kNone);
  std::vector<std::uint32_t> open;
  for (std::uint32_t seed = 0; seed < triangles; ++seed) {
    if (groups.of[seed] != HalfEdges::kNone) {
      continue;
    }
    const auto index = static_cast<std::uint32_t>(groups.count++);
    groups.of[seed] = index;
    open.push_back(seed);
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        const std::uint32_t twin = halfEdges.twin(h);
        if (twin == HalfEdges::kNone) {
          continue;
        }
        const std::uint32_t next = twin / 3;
        if (groups.of[next] == HalfEdges::kNone && label(next) == label(t)) {
          groups.of[next] = index;
          open.push_back(next);
        }
      }
    }
  }
  return groups;
}

/// Area with which two groups see each other.
struct Sight {
  std::uint32_t from;
  std::uint32_t to;
  double area;
};

std::vector<Sight> sightsOf(const Groups& groups,
                            const std::vector<Opposite>& opposite,
                            const std::vector<bool>& wall,
                            const std::vector<double>& area) {
  std::vector<Sight> sights;
  for (std::size_t t = 0; t < opposite.size(); ++t) {
    const std::uint32_t u = opposite[t].triangle;
    if (wall[t] && wall[u]) {
      const auto [low, high] = std::minmax(groups.of[t], groups.of[u]);
      sights.push_back({low, high, area[t]});
    }
  }
  std::stable_sort(sights.begin(), sights.end(), [](const Sight& a, const Sight& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  });
  std::vector<Sight> merged;
  for (const Sight& sight : sights) {
    if (!merged.empty() && merged.back().from == sight.from && merged.back().to == sight.to) {
      merged.back().area += sight.area;
    } else {
      merged.push_back(sight);
    }
  }
  // The strongest first: they decide the colours.
  std::stable_sort(merged.begin(), merged.end(),
                   [](const Sight& a, const Sight& b) { return a.area > b.area; });
  return merged;
}

/// Groups in two sides so that those that see each other differ: union with parity. Groups that see
/// each other, directly or by others, make one wall.
class Sides {
public:
  explicit Sides(std::size_t groups) : parent_(groups), parity_(groups, 0) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  struct Root {
    std::uint32_t group;
    int parity;
  };

  [[nodiscard]] Root root(std::uint32_t g) const {
    int parity = 0;
    while (parent_[g] != g) {
      parity ^= parity_[g];
      g = parent_[g];
    }
    return {g, parity};
  }

  /// @return false when they have the same colour already
  bool oppose(std::uint32_t a, std::uint32_t b) {
    const Root ra = root(a);
    const Root rb = root(b);
    if (ra.group == rb.group) {
      return ra.parity != rb.parity;
    }
    const auto [low, high] = std::minmax(ra.group, rb.group);
    parent_[high] = low;
    parity_[high] = ra.parity ^ rb.parity ^ 1;
    return true;
  }

private:
  std::vector<std::uint32_t> parent_;
  std::vector<int> parity_;
};

/// Per wall the parity of its outer side: the larger one; of equal ones that which lies farther
/// along x, then y, then z.
std::vector<int> outerSides(const TriangleMesh& mesh,
                            const std::vector<double>& area,
                            const std::vector<std::uint32_t>& wallOf,
                            const std::vector<int>& parity,
                            std::size_t walls) {
  struct Side {
    double area = 0.0;
    Vec3 moment = Vec3::Zero();
  };

  std::vector<std::array<Side, 2>> sides(walls);
  for (std::size_t t = 0; t < area.size(); ++t) {
    if (wallOf[t] != HalfEdges::kNone) {
      Side& side = sides[wallOf[t]][static_cast<std::size_t>(parity[t])];
      const auto& v = mesh.triangles[t];
      side.area += area[t];
      side.moment +=
          area[t] / 3.0 * (mesh.vertices[v[0]] + mesh.vertices[v[1]] + mesh.vertices[v[2]]);
    }
  }
  const double rounding = kEqualArea * mesh.bounds().diagonal();
  std::vector<int> outer(walls, 0);
  for (std::size_t w = 0; w < walls; ++w) {
    const auto& [a, b] = sides[w];
    if (!(std::abs(a.area - b.area) <= kEqualArea * std::max(a.area, b.area))) {
      outer[w] = a.area > b.area ? 0 : 1;
    } else if (a.area > 0.0) {
      const Vec3 apart = a.moment / a.area - b.moment / b.area;
      for (int k = 2; k >= 0; --k) {
        if (std::abs(apart[k]) > rounding) {
          outer[w] = apart[k] > 0.0 ? 0 : 1;
        }
      }
    }
  }
  return outer;
}

/// Rims between walls of one colour take it: the ring around the bottom of a cup, single triangles
/// whose ray missed.
void joinRims(const TriangleMesh& mesh, const HalfEdges& halfEdges, std::vector<Colour>& colour) {
  const Groups groups = groupsOf(halfEdges, mesh.triangles.size(),
                                 [&](std::uint32_t t) { return static_cast<int>(colour[t]); });
  std::vector<std::array<bool, 2>> touches(groups.count, {false, false});
  for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
    const std::uint32_t twin = halfEdges.twin(h);
    if (twin != HalfEdges::kNone && colour[h / 3] == Colour::Rim &&
        colour[twin / 3] != Colour::Rim) {
      touches[groups.of[h / 3]][static_cast<std::size_t>(colour[twin / 3])] = true;
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& touch = touches[groups.of[t]];
    if (colour[t] == Colour::Rim && touch[0] != touch[1]) {
      colour[t] = touch[0] ? Colour::Outer : Colour::Inner;
    }
  }
}

/// Faces of CAD parts are kept whole: each takes the colour of most of its area.
void keepFacesWhole(const PartSurface& part,
                    const std::vector<double>& area,
                    std::vector<Colour>& colour) {
  if (!part.exact()) {
    return;
  }
  std::vector<std::array<double, 3>> votes(static_cast<std::size_t>(part.brep->faceCount()),
                                           {0.0, 0.0, 0.0});
  for (std::size_t t = 0; t < colour.size(); ++t) {
    votes[static_cast<std::size_t>(part.binding.face[t])]
         [static_cast<std::size_t>(static_cast<int>(colour[t]) + 1)] += area[t];
  }
  for (std::size_t t = 0; t < colour.size(); ++t) {
    const auto& vote = votes[static_cast<std::size_t>(part.binding.face[t])];
    const auto most = std::max_element(vote.begin(), vote.end()) - vote.begin();
    colour[t] = static_cast<Colour>(most - 1);
  }
}

struct ColouredWall {
  std::vector<Colour> colour;
  double thickness = 0.0;  ///< usual
};

ColouredWall colourWall(const PartSurface& part,
                        const std::vector<double>& area,
                        const JobContext& context) {
  if (part.mesh.triangles.empty()) {
    refuse("the part has no triangles");
  }
  const std::vector<Opposite> opposite = lookAcross(part.mesh, context);
  ColouredWall result;
  result.thickness = usualThickness(opposite, area);
  if (!(result.thickness > 0.0)) {
    refuse("the part is no solid wall: nowhere do two sides of it look at each other");
  }
  std::vector<bool> wall(opposite.size());
  for (std::size_t t = 0; t < wall.size(); ++t) {
    wall[t] = opposite[t].triangle != HalfEdges::kNone &&
              opposite[t].distance <= kThickest * result.thickness;
  }
  const Groups groups =
      groupsOf(part.halfEdges, wall.size(), [&](std::uint32_t t) { return bool(wall[t]); });
  Sides sides(groups.count);
  std::vector<bool> seen(groups.count, false);
  double agreed = 0.0;
  double contradicted = 0.0;
  for (const Sight& sight : sightsOf(groups, opposite, wall, area)) {
    (sides.oppose(sight.from, sight.to) ? agreed : contradicted) += sight.area;
    seen[sight.from] = seen[sight.to] = true;
  }
  if (contradicted > agreed) {
    refuse(part.halfEdges.closed()
               ? "the part is no solid wall: its two sides are not parted by rims (a bulk part, or "
                 "one as thick as high)"
               : "the part is an open surface, no solid wall: it is its own working surface");
  }
  std::vector<std::uint32_t> wallOf(wall.size(), HalfEdges::kNone);
  std::vector<int> parity(wall.size(), 0);
  for (std::size_t t = 0; t < wall.size(); ++t) {
    if (wall[t] && seen[groups.of[t]]) {
      const Sides::Root root = sides.root(groups.of[t]);
      wallOf[t] = root.group;
      parity[t] = root.parity;
    }
  }
  const std::vector<int> outerParity = outerSides(part.mesh, area, wallOf, parity, groups.count);
  result.colour.assign(wall.size(), Colour::Rim);
  for (std::size_t t = 0; t < wall.size(); ++t) {
    if (wallOf[t] != HalfEdges::kNone) {
      result.colour[t] = parity[t] == outerParity[wallOf[t]] ? Colour::Outer : Colour::Inner;
    }
  }
  joinRims(part.mesh, part.halfEdges, result.colour);
  keepFacesWhole(part, area, result.colour);
  return result;
}

PartSurface sideOf(const PartSurface& part, const std::vector<Colour>& colour, Colour wanted) {
  std::vector<bool> keep(colour.size());
  for (std::size_t t = 0; t < keep.size(); ++t) {
    keep[t] = colour[t] == wanted;
  }
  return keepTriangles(part, keep).surface;
}

/// Distance of each vertex of a surface to the opposite side, and the nearest points there.
struct Across {
  std::vector<Vec3> foot;
  std::vector<double> distance;
};

Across measureAcross(const PartSurface& from, const PartSurface& to, const JobContext& context) {
  const SurfaceProjector projector(to);
  const auto feet = projector.project(from.mesh.vertices, context);
  Across across;
  across.foot.reserve(feet.size());
  across.distance.reserve(feet.size());
  for (std::size_t v = 0; v < feet.size(); ++v) {
    across.foot.push_back(feet[v].p);
    across.distance.push_back((feet[v].p - from.mesh.vertices[v]).norm());
  }
  return across;
}

WallThickness summarise(const TriangleMesh& mesh, std::vector<double> atVertex) {
  WallThickness result;
  std::size_t thinnest = 0;
  std::size_t thickest = 0;
  for (std::size_t v = 0; v < atVertex.size(); ++v) {
    thinnest = atVertex[v] < atVertex[thinnest] ? v : thinnest;
    thickest = atVertex[v] > atVertex[thickest] ? v : thickest;
  }
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    const double area = areaOf(mesh, t);
    sum += area * (atVertex[v[0]] + atVertex[v[1]] + atVertex[v[2]]) / 3.0;
    total += area;
  }
  result.min = atVertex[thinnest];
  result.max = atVertex[thickest];
  result.mean = total > 0.0 ? sum / total : result.min;
  result.thinnest = mesh.vertices[thinnest];
  result.thickest = mesh.vertices[thickest];
  result.atVertex = std::move(atVertex);
  return result;
}

const char* nameOf(WallSide side) {
  switch (side) {
    case WallSide::Outer:
      return "outer";
    case WallSide::Inner:
      return "inner";
    case WallSide::Middle:
      return "middle";
  }
  return "";
}

}  // namespace

SolidWall solidWall(const PartSurface& part, WallSide side, const JobContext& context) {
  std::vector<double> area(part.mesh.triangles.size());
  for (std::size_t t = 0; t < area.size(); ++t) {
    area[t] = areaOf(part.mesh, t);
  }
  const ColouredWall coloured = colourWall(part, area, context.portion(0.0, 0.4));
  PartSurface outer = sideOf(part, coloured.colour, Colour::Outer);
  const PartSurface inner = sideOf(part, coloured.colour, Colour::Inner);
  if (outer.mesh.triangles.empty() || inner.mesh.triangles.empty()) {
    refuse("the part is no solid wall: it has only one side");
  }
  SolidWall wall;
  const JobContext measuring = context.portion(0.4, 1.0);
  if (side == WallSide::Middle) {
    outer = refineSurface(outer, kEdge * coloured.thickness, measuring);
    const Across across = measureAcross(outer, inner, measuring);
    wall.surface.mesh = outer.mesh;
    for (std::size_t v = 0; v < across.foot.size(); ++v) {
      wall.surface.mesh.vertices[v] = 0.5 * (outer.mesh.vertices[v] + across.foot[v]);
    }
    wall.surface.halfEdges = HalfEdges(wall.surface.mesh);
    wall.thickness = summarise(wall.surface.mesh, across.distance);
  } else {
    const bool isOuter = side == WallSide::Outer;
    const Across across =
        measureAcross(isOuter ? outer : inner, isOuter ? inner : outer, measuring);
    wall.surface = isOuter ? std::move(outer) : inner;
    wall.thickness = summarise(wall.surface.mesh, across.distance);
  }
  wall.surface.hash = Sha256().text("solid wall").text(part.hash).text(nameOf(side)).hex();
  return wall;
}

}  // namespace wcam::geometry
