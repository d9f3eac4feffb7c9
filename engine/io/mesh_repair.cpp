// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_repair.hpp"

#include "wcam/base/json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <unordered_map>

namespace wcam::io {

using geometry::HalfEdges;
using geometry::TriangleMesh;
using geometry::Vec3;

namespace {

/// A triangle lower than this share of its longest edge has no direction: what is left of its
/// height is the rounding of single-precision files.
constexpr double kFlatRatio = 1e-7;

bool usesVertexTwice(const std::array<std::uint32_t, 3>& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Removes the triangles that are marked.
Dropped dropMarked(TriangleMesh& mesh, const std::vector<bool>& marked) {
  Dropped dropped;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!marked[t]) {
      mesh.triangles[kept++] = mesh.triangles[t];
    } else if (dropped.count++ == 0) {
      dropped.first = mesh.vertices[mesh.triangles[t][0]];
    }
  }
  mesh.triangles.resize(kept);
  return dropped;
}

struct DuplicateKey {
  std::uint32_t middle;
  std::uint32_t highest;
  std::uint32_t triangle;

  friend bool operator<(const DuplicateKey& a, const DuplicateKey& b) {
    if (a.middle != b.middle) {
      return a.middle < b.middle;
    }
    return a.highest != b.highest ? a.highest < b.highest : a.triangle < b.triangle;
  }
};

/// Calls body for every set of two or more triangles of the same vertices. O(n)
template <class Body>
void forEqualTriangles(const TriangleMesh& mesh, const Body& body) {
  // Buckets by lowest vertex, filled by counting.
  std::vector<std::uint32_t> start(mesh.vertices.size() + 1, 0);
  for (const auto& t : mesh.triangles) {
    ++start[std::min({t[0], t[1], t[2]}) + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<DuplicateKey> keys(mesh.triangles.size());
  std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> v = mesh.triangles[t];
    std::sort(v.begin(), v.end());
    keys[fill[v[0]]++] = {v[1], v[2], t};
  }
  const auto same = [](const DuplicateKey& a, const DuplicateKey& b) {
    return a.middle == b.middle && a.highest == b.highest;
  };
  for (std::size_t v = 0; v + 1 < start.size(); ++v) {
    std::sort(keys.begin() + start[v], keys.begin() + start[v + 1]);
    for (std::size_t i = start[v]; i < start[v + 1];) {
      std::size_t end = i + 1;
      while (end < start[v + 1] && same(keys[i], keys[end])) {
        ++end;
      }
      if (end - i > 1) {
        body(std::span<const DuplicateKey>(keys).subspan(i, end - i));
      }
      i = end;
    }
  }
}

/// Do the corners follow each other as their sorted numbers do?
bool turnsLeft(const std::array<std::uint32_t, 3>& t) {
  return (t[0] < t[1]) == ((t[1] < t[2]) == (t[0] < t[2]));
}

/// Cell of a point in a grid of the given step.
struct Cell {
  std::int64_t x, y, z;

  friend bool operator==(const Cell&, const Cell&) = default;
};

struct CellHash {
  std::size_t operator()(const Cell& c) const {
    auto h = static_cast<std::uint64_t>(c.x) * 0x9E3779B97F4A7C15U;
    h = (h ^ (h >> 29U) ^ static_cast<std::uint64_t>(c.y)) * 0xC2B2AE3D27D4EB4FU;
    h = (h ^ (h >> 29U) ^ static_cast<std::uint64_t>(c.z)) * 0x165667B19E3779F9U;
    return h ^ (h >> 32U);
  }
};

std::uint32_t rootOf(std::vector<std::uint32_t>& parent, std::uint32_t v) {
  while (parent[v] != v) {
    parent[v] = parent[parent[v]];
    v = parent[v];
  }
  return v;
}

std::vector<std::uint32_t> borderVertices(const TriangleMesh& mesh, const HalfEdges& halfEdges) {
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
    if (halfEdges.twin(h) == HalfEdges::kNone) {
      vertices.push_back(mesh.triangles[h / 3][h % 3]);
      vertices.push_back(mesh.triangles[h / 3][(h + 1) % 3]);
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Joins each point with the earlier ones in the cells around it.
void joinNear(const std::vector<Vec3>& points,
              const std::vector<std::uint32_t>& candidates,
              double tolerance,
              std::vector<std::uint32_t>& parent) {
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells;
  // Cells are relative to the first point, so that their numbers stay small.
  const Vec3 origin = points[candidates.front()];
  for (const std::uint32_t v : candidates) {
    const Vec3 q = (points[v] - origin) / tolerance;
    const Cell c{std::llround(std::floor(q.x())), std::llround(std::floor(q.y())),
                 std::llround(std::floor(q.z()))};
    for (std::int64_t n = 0; n < 27; ++n) {
      const auto it = cells.find({c.x + n % 3 - 1, c.y + n / 3 % 3 - 1, c.z + n / 9 - 1});
      if (it == cells.end()) {
        continue;
      }
      for (const std::uint32_t w : it->second) {
        if ((points[v] - points[w]).squaredNorm() <= tolerance * tolerance) {
          const std::uint32_t a = rootOf(parent, v);
          const std::uint32_t b = rootOf(parent, w);
          parent[std::max(a, b)] = std::min(a, b);
        }
      }
    }
    cells[c].push_back(v);
  }
}

}  // namespace

std::string positionText(const Vec3& p) {
  const auto text = [](double x) { return formatReal(std::round(x * 1e6) / 1e6 + 0.0); };
  return "(" + text(p.x()) + ", " + text(p.y()) + ", " + text(p.z()) + ")";
}

Dropped dropDegenerate(TriangleMesh& mesh) {
  std::vector<bool> marked(mesh.triangles.size());
  std::transform(mesh.triangles.begin(), mesh.triangles.end(), marked.begin(), usesVertexTwice);
  return dropMarked(mesh, marked);
}

Dropped dropDuplicates(TriangleMesh& mesh) {
  std::vector<bool> marked(mesh.triangles.size(), false);
  forEqualTriangles(mesh, [&marked](std::span<const DuplicateKey> equal) {
    for (const DuplicateKey& key : equal.subspan(1)) {
      marked[key.triangle] = true;
    }
  });
  return dropMarked(mesh, marked);
}

Dropped dropInnerWalls(TriangleMesh& mesh) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  forEqualTriangles(mesh, [&](std::span<const DuplicateKey> equal) {
    if (equal.size() == 2 && turnsLeft(mesh.triangles[equal[0].triangle]) !=
                                 turnsLeft(mesh.triangles[equal[1].triangle])) {
      pairs.push_back({equal[0].triangle, equal[1].triangle});
    }
  });
  if (pairs.empty()) {
    return {};
  }

  // Edges of the pairs: how many pairs and how many other triangles meet there, and the last pair.
  struct Meeting {
    std::size_t pairs = 0;
    std::size_t others = 0;
    std::uint32_t last = 0;
  };

  std::unordered_map<std::uint64_t, Meeting> edges;
  const auto edgeOf = [&mesh](std::uint32_t triangle, std::size_t k) {
    const auto& t = mesh.triangles[triangle];
    const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
    return (std::uint64_t{low} << 32U) | high;
  };
  std::vector<bool> paired(mesh.triangles.size(), false);
  std::vector<std::uint32_t> patch(pairs.size());
  std::iota(patch.begin(), patch.end(), 0U);
  const auto root = [&patch](std::uint32_t p) {
    while (patch[p] != p) {
      p = patch[p] = patch[patch[p]];
    }
    return p;
  };
  for (std::uint32_t p = 0; p < pairs.size(); ++p) {
    paired[pairs[p][0]] = paired[pairs[p][1]] = true;
    for (std::size_t k = 0; k < 3; ++k) {
      Meeting& meeting = edges[edgeOf(pairs[p][0], k)];
      if (meeting.pairs++ > 0) {
        patch[root(p)] = root(meeting.last);
      }
      meeting.last = p;
    }
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3 && !paired[t]; ++k) {
      if (const auto found = edges.find(edgeOf(t, k)); found != edges.end()) {
        ++found->second.others;
      }
    }
  }
  // A patch is a wall between bodies when its whole border lies on what both have besides it. The
  // border of a sheet with two sides is free.
  std::vector<bool> bordered(pairs.size(), false);
  std::vector<bool> free(pairs.size(), false);
  for (std::uint32_t p = 0; p < pairs.size(); ++p) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Meeting& meeting = edges.at(edgeOf(pairs[p][0], k));
      if (meeting.pairs == 1) {
        bordered[root(p)] = true;
        free[root(p)] = free[root(p)] || meeting.others < 2;
      }
    }
  }
  std::vector<bool> marked(mesh.triangles.size(), false);
  for (std::uint32_t p = 0; p < pairs.size(); ++p) {
    const bool inner = bordered[root(p)] && !free[root(p)];
    marked[pairs[p][0]] = marked[pairs[p][1]] = inner;
  }
  return dropMarked(mesh, marked);
}

void dropUnusedVertices(TriangleMesh& mesh) {
  std::vector<std::uint32_t> newIndex(mesh.vertices.size(), HalfEdges::kNone);
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      newIndex[v] = 0;
    }
  }
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (newIndex[v] != HalfEdges::kNone) {
      mesh.vertices[kept] = mesh.vertices[v];
      newIndex[v] = kept++;
    }
  }
  mesh.vertices.resize(kept);
  for (auto& t : mesh.triangles) {
    t = {newIndex[t[0]], newIndex[t[1]], newIndex[t[2]]};
  }
}

Dropped countFlat(const TriangleMesh& mesh) {
  Dropped flat;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[1]] - mesh.vertices[t[0]];
    const Vec3 b = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    if (a.cross(b).norm() <= kFlatRatio * longest && flat.count++ == 0) {
      flat.first = mesh.vertices[t[0]];
    }
  }
  return flat;
}

std::size_t stitchBorders(TriangleMesh& mesh, const HalfEdges& halfEdges, double tolerance) {
  const std::vector<std::uint32_t> candidates = borderVertices(mesh, halfEdges);
  if (candidates.empty() || !(tolerance > 0.0)) {
    return 0;
  }
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0U);
  joinNear(mesh.vertices, candidates, tolerance, parent);
  std::size_t joined = 0;
  for (const std::uint32_t v : candidates) {
    parent[v] = rootOf(parent, v);
    joined += parent[v] != v ? 1 : 0;
  }
  for (auto& t : mesh.triangles) {
    t = {parent[t[0]], parent[t[1]], parent[t[2]]};
  }
  return joined;
}

}  // namespace wcam::io
