// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/cut_path.hpp"

#include "wcam/base/error.hpp"

#include <queue>

#include <algorithm>
#include <limits>
#include <utility>

namespace wcam::geometry {

namespace {

/// Edges around each vertex, in flat lists.
struct EdgeStar {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> edges;

  EdgeStar(const HalfEdges& halfEdges, std::size_t vertices) : first(vertices + 1, 0) {
    const auto count = static_cast<std::uint32_t>(halfEdges.edgeCount());
    for (std::uint32_t e = 0; e < count; ++e) {
      for (const std::uint32_t v : halfEdges.edgeVertices(e)) {
        ++first[v + 1];
      }
    }
    for (std::size_t v = 0; v < vertices; ++v) {
      first[v + 1] += first[v];
    }
    edges.resize(first.back());
    std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
    for (std::uint32_t e = 0; e < count; ++e) {
      for (const std::uint32_t v : halfEdges.edgeVertices(e)) {
        edges[fill[v]++] = e;
      }
    }
  }
};

std::uint32_t otherEnd(const HalfEdges& halfEdges, std::uint32_t edge, std::uint32_t vertex) {
  const auto& ends = halfEdges.edgeVertices(edge);
  return ends[0] == vertex ? ends[1] : ends[0];
}

/// Small union-find over the triangles around one vertex.
class Fan {
public:
  explicit Fan(std::size_t count) : parent_(count) {
    for (std::size_t i = 0; i < count; ++i) {
      parent_[i] = i;
    }
  }

  std::size_t find(std::size_t i) {
    while (parent_[i] != i) {
      i = parent_[i] = parent_[parent_[i]];
    }
    return i;
  }

  void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

private:
  std::vector<std::size_t> parent_;
};

}  // namespace

std::vector<std::uint32_t> edgePath(const TriangleMesh& mesh,
                                    const HalfEdges& halfEdges,
                                    const std::vector<std::uint32_t>& from,
                                    const std::vector<std::uint32_t>& to) {
  const std::size_t count = mesh.vertices.size();
  const EdgeStar star(halfEdges, count);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<double> distance(count, kFar);
  std::vector<std::uint32_t> previous(count, HalfEdges::kNone);
  std::vector<char> target(count, 0);
  for (const std::uint32_t v : to) {
    target[v] = 1;
  }
  using Item = std::pair<double, std::uint32_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for (const std::uint32_t v : from) {
    distance[v] = 0.0;
    queue.emplace(0.0, v);
  }
  while (!queue.empty()) {
    const auto [reached, v] = queue.top();
    queue.pop();
    if (reached > distance[v]) {
      continue;
    }
    if (target[v] != 0) {
      std::vector<std::uint32_t> path;
      for (std::uint32_t at = v; at != HalfEdges::kNone; at = previous[at]) {
        path.push_back(at);
      }
      std::reverse(path.begin(), path.end());
      return path;
    }
    for (std::uint32_t i = star.first[v]; i < star.first[v + 1]; ++i) {
      const std::uint32_t next = otherEnd(halfEdges, star.edges[i], v);
      const double through = reached + (mesh.vertices[next] - mesh.vertices[v]).norm();
      if (through < distance[next]) {
        distance[next] = through;
        previous[next] = v;
        queue.emplace(through, next);
      }
    }
  }
  return {};
}

PathCut cutAlong(const TriangleMesh& mesh, const std::vector<std::uint32_t>& path) {
  PathCut cut;
  cut.mesh = mesh;
  cut.left = cut.right = path;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    cut.original.push_back(v);
  }
  // Places of the path's vertices, and the triangles around them.
  std::vector<std::uint32_t> place(mesh.vertices.size(), HalfEdges::kNone);
  for (std::uint32_t i = 0; i < path.size(); ++i) {
    place[path[i]] = i;
  }
  std::vector<std::vector<std::uint32_t>> around(path.size());
  std::vector<char> found(path.empty() ? 0 : path.size() - 1, 0);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t at = place[mesh.triangles[t][c]];
      if (at == HalfEdges::kNone) {
        continue;
      }
      around[at].push_back(3 * t + c);
      const std::uint32_t next = place[mesh.triangles[t][(c + 1) % 3]];
      if (next != HalfEdges::kNone && (next == at + 1 || at == next + 1)) {
        found[std::min(at, next)] = 1;
      }
    }
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i] == 0) {
      throw Error(ErrorCode::InvalidArgument,
                  text("vertices %1 and %2 share no edge",
                       {std::to_string(path[i]), std::to_string(path[i + 1])}),
                  "cut along a path", "");
    }
  }
  const auto onPath = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t i = place[a];
    const std::uint32_t j = place[b];
    return i != HalfEdges::kNone && j != HalfEdges::kNone && (i == j + 1 || j == i + 1);
  };
  for (std::uint32_t i = 0; i < path.size(); ++i) {
    const std::uint32_t v = path[i];
    const std::vector<std::uint32_t>& fan = around[i];
    Fan sides(fan.size());
    std::size_t leftOne = fan.size();
    for (std::size_t a = 0; a < fan.size(); ++a) {
      const auto& ta = mesh.triangles[fan[a] / 3];
      const std::uint32_t after = ta[(fan[a] % 3 + 1) % 3];   // half-edge v → after
      const std::uint32_t before = ta[(fan[a] % 3 + 2) % 3];  // half-edge before → v
      if ((place[after] == i + 1 && onPath(v, after)) ||
          (i > 0 && place[before] == i - 1 && onPath(v, before))) {
        leftOne = a;
      }
      for (std::size_t b = 0; b < fan.size(); ++b) {
        // The next triangle around v shares the edge (v, before) as its (v, after).
        const auto& tb = mesh.triangles[fan[b] / 3];
        if (a != b && tb[(fan[b] % 3 + 1) % 3] == before && !onPath(v, before)) {
          sides.join(a, b);
        }
      }
    }
    const bool split =
        leftOne < fan.size() &&
        std::any_of(fan.begin(), fan.end(), [&](const std::uint32_t& corner) {
          return sides.find(static_cast<std::size_t>(&corner - fan.data())) != sides.find(leftOne);
        });
    if (!split) {
      continue;
    }
    const auto copy = static_cast<std::uint32_t>(cut.mesh.vertices.size());
    cut.mesh.vertices.push_back(mesh.vertices[v]);
    cut.original.push_back(v);
    cut.right[i] = copy;
    for (std::size_t a = 0; a < fan.size(); ++a) {
      if (sides.find(a) != sides.find(leftOne)) {
        cut.mesh.triangles[fan[a] / 3][fan[a] % 3] = copy;
      }
    }
  }
  cut.halfEdges = HalfEdges(cut.mesh);
  return cut;
}

}  // namespace wcam::geometry
