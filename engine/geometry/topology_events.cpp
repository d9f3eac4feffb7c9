// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/topology_events.hpp"

#include "wcam/base/error.hpp"

#include "reeb_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace wcam::geometry {

namespace {

constexpr std::uint32_t kNone = HalfEdges::kNone;

/// Sweeps the vertices upwards and keeps for every crossed edge the arc of its level curve. Only
/// where curves join or part is a curve walked along, so regular vertices cost their own edges.
///
/// A vertex at which several fans of triangles touch counts once for each fan, and triangles with a
/// corner outside the field do not exist.
class Sweep {
public:
  Sweep(const TriangleMesh& mesh, const HalfEdges& halfEdges, const std::vector<double>& field)
      : mesh_(mesh), halfEdges_(halfEdges), field_(field) {
    active_.resize(mesh.triangles.size());
    for (std::size_t t = 0; t < active_.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      active_[t] = std::isfinite(field[a]) && std::isfinite(field[b]) && std::isfinite(field[c]) &&
                   a != b && b != c && c != a;
    }
    makeFans();
    orderFans();
  }

  ReebGraph run() {
    arcOf_.assign(3 * mesh_.triangles.size(), kNone);
    graph_.arcOfTriangle.assign(mesh_.triangles.size(), kNone);
    std::vector<std::uint32_t> order(fans_.size());
    for (std::uint32_t f = 0; f < fans_.size(); ++f) {
      order[rank_[f]] = f;
    }
    for (const std::uint32_t fan : order) {
      pass(fan);
    }
    return std::move(graph_);
  }

private:
  struct Fan {
    std::uint32_t vertex;
    std::uint32_t first;  ///< half-edge out of the vertex; of an open fan the clockwise end
    bool closed;
  };

  /// An edge at the vertex that is passed.
  struct Spoke {
    std::uint32_t halfEdge;  ///< one of the edge's half-edges
    bool up;                 ///< its other end is higher
  };

  [[nodiscard]] std::uint32_t twin(std::uint32_t h) const {
    const std::uint32_t other = halfEdges_.twin(h);
    return other != kNone && active_[other / 3] ? other : kNone;
  }

  [[nodiscard]] static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }

  [[nodiscard]] static std::uint32_t previous(std::uint32_t h) {
    return h % 3 == 0 ? h + 2 : h - 1;
  }

  /// The half-edge by which both sides know an edge.
  [[nodiscard]] std::uint32_t edge(std::uint32_t h) const {
    const std::uint32_t other = twin(h);
    return other == kNone ? h : std::min(h, other);
  }

  void makeFans() {
    fanOf_.assign(3 * mesh_.triangles.size(), kNone);
    for (std::uint32_t corner = 0; corner < fanOf_.size(); ++corner) {
      if (!active_[corner / 3] || fanOf_[corner] != kNone) {
        continue;
      }
      std::uint32_t first = corner;
      bool closed = false;
      while (twin(first) != kNone && !closed) {
        first = next(twin(first));
        closed = first == corner;
      }
      const auto fan = static_cast<std::uint32_t>(fans_.size());
      fans_.push_back({mesh_.triangles[corner / 3][corner % 3], first, closed});
      for (std::uint32_t h = first; h != kNone && fanOf_[h] == kNone; h = twin(previous(h))) {
        fanOf_[h] = fan;
      }
    }
  }

  void orderFans() {
    std::vector<std::uint32_t> order(fans_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::make_tuple(field_[fans_[a].vertex], fans_[a].vertex, a) <
             std::make_tuple(field_[fans_[b].vertex], fans_[b].vertex, b);
    });
    rank_.resize(fans_.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      rank_[order[i]] = i;
    }
  }

  [[nodiscard]] std::uint32_t rankAtStart(std::uint32_t h) const { return rank_[fanOf_[h]]; }

  [[nodiscard]] std::uint32_t rankAtEnd(std::uint32_t h) const { return rank_[fanOf_[next(h)]]; }

  /// Spokes of a fan in turn.
  void spokesOf(const Fan& fan, std::uint32_t rank) {
    spokes_.clear();
    std::uint32_t h = fan.first;
    while (true) {
      spokes_.push_back({edge(h), rankAtEnd(h) > rank});
      const std::uint32_t back = previous(h);
      const std::uint32_t following = twin(back);
      if (following == fan.first) {
        return;
      }
      if (following == kNone) {
        spokes_.push_back({edge(back), rankAtStart(back) > rank});
        return;
      }
      h = following;
    }
  }

  /// Half-edge through which the curve just above `rank` leaves the triangle that it enters through
  /// h.
  [[nodiscard]] std::uint32_t across(std::uint32_t h, std::uint32_t rank) const {
    const std::uint32_t apex = previous(h);
    const bool apexUp = rankAtStart(apex) > rank;
    const bool endUp = rankAtEnd(h) > rank;
    return apexUp == endUp ? apex : next(h);
  }

  /// Gives all edges of the curve just above `rank` through the edge h to an arc.
  void paint(std::uint32_t h, std::uint32_t rank, std::uint32_t arc) {
    arcOf_[edge(h)] = arc;
    for (const std::uint32_t side : {h, twin(h)}) {
      for (std::uint32_t at = side; at != kNone;) {
        const std::uint32_t out = across(at, rank);
        if (edge(out) == edge(h)) {
          return;  // a loop
        }
        arcOf_[edge(out)] = arc;
        at = twin(out);
      }
    }
  }

  /// The triangles whose highest corner is the vertex belong to the arc that ends or passes here.
  void claimTriangles(const Fan& fan, std::uint32_t rank) {
    std::uint32_t h = fan.first;
    do {
      if (rankAtEnd(h) < rank && rankAtStart(previous(h)) < rank) {
        graph_.arcOfTriangle[h / 3] = arcOf_[edge(h)];
      }
      h = twin(previous(h));
    } while (h != kNone && h != fan.first);
  }

  void pass(std::uint32_t fanIndex) {
    const Fan& fan = fans_[fanIndex];
    const std::uint32_t rank = rank_[fanIndex];
    spokesOf(fan, rank);
    claimTriangles(fan, rank);
    std::vector<std::uint32_t>& below = below_;
    below.clear();
    std::size_t changes = 0;
    std::size_t ups = 0;
    for (std::size_t i = 0; i < spokes_.size(); ++i) {
      const Spoke& spoke = spokes_[i];
      changes += i > 0 && spoke.up != spokes_[i - 1].up ? 1U : 0U;
      ups += spoke.up ? 1U : 0U;
      if (!spoke.up) {
        below.push_back(arcOf_[spoke.halfEdge]);
      }
    }
    changes += fan.closed && spokes_.front().up != spokes_.back().up ? 1U : 0U;
    if (changes == (fan.closed ? 2U : 1U)) {
      for (const Spoke& spoke : spokes_) {
        if (spoke.up) {
          arcOf_[spoke.halfEdge] = below.front();
        }
      }
      return;
    }
    std::sort(below.begin(), below.end());
    below.erase(std::unique(below.begin(), below.end()), below.end());
    passCritical(fan.vertex, rank, below, ups);
  }

  void passCritical(std::uint32_t vertex,
                    std::uint32_t rank,
                    const std::vector<std::uint32_t>& below,
                    std::size_t ups) {
    const auto firstNew = static_cast<std::uint32_t>(graph_.arcs.size());
    std::uint32_t nextArc = firstNew;
    if (ups > 0) {
      for (const Spoke& spoke : spokes_) {
        const std::uint32_t arc = arcOf_[spoke.halfEdge];
        if (spoke.up && (arc == kNone || arc < firstNew)) {
          paint(spoke.halfEdge, rank, nextArc++);
        }
      }
    }
    if (below.size() == 1 && nextArc == firstNew + 1) {
      // An open curve closes or a loop opens at a border: it remains one curve.
      paint(firstUp(), rank, below.front());
      return;
    }
    const auto node = static_cast<std::uint32_t>(graph_.nodes.size());
    graph_.nodes.push_back({vertex, field_[vertex]});
    for (const std::uint32_t arc : below) {
      graph_.arcs[arc].to = node;
    }
    for (std::uint32_t arc = firstNew; arc < nextArc; ++arc) {
      graph_.arcs.push_back({node, node});
    }
  }

  [[nodiscard]] std::uint32_t firstUp() const {
    return std::find_if(spokes_.begin(), spokes_.end(), [](const Spoke& s) { return s.up; })
        ->halfEdge;
  }

  const TriangleMesh& mesh_;
  const HalfEdges& halfEdges_;
  const std::vector<double>& field_;
  std::vector<bool> active_;
  std::vector<Fan> fans_;
  std::vector<std::uint32_t> fanOf_;  ///< per corner = half-edge out of it
  std::vector<std::uint32_t> rank_;   ///< per fan
  std::vector<std::uint32_t> arcOf_;  ///< per edge (lower half-edge) that the level crosses
  std::vector<Spoke> spokes_;
  std::vector<std::uint32_t> below_;
  ReebGraph graph_;
};

/// Events of a graph: what its nodes do to the number of curves.
std::vector<TopologyEvent> eventsOf(const ReebGraph& graph, const TriangleMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> down(graph.nodes.size());
  std::vector<std::size_t> up(graph.nodes.size(), 0);
  for (std::uint32_t a = 0; a < graph.arcs.size(); ++a) {
    down[graph.arcs[a].to].push_back(graph.arcs[a].from);
    ++up[graph.arcs[a].from];
  }
  std::vector<std::uint32_t> order(graph.nodes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::make_tuple(graph.nodes[a].level, graph.nodes[a].vertex, a) <
           std::make_tuple(graph.nodes[b].level, graph.nodes[b].vertex, b);
  });
  std::vector<std::uint32_t> parent(graph.nodes.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t n) {
    while (parent[n] != n) {
      n = parent[n] = parent[parent[n]];
    }
    return n;
  };
  std::vector<TopologyEvent> events;
  for (const std::uint32_t n : order) {
    const auto add = [&](TopologyEvent::Kind kind) {
      const ReebGraph::Node& node = graph.nodes[n];
      events.push_back({kind, node.level, mesh.vertices[node.vertex], node.vertex});
    };
    // A flat ring begins (or ends) as two curves at once.
    for (std::size_t i = 0; down[n].empty() && i < up[n]; ++i) {
      add(TopologyEvent::Kind::Begin);
    }
    for (std::size_t i = 0; i < down[n].size(); ++i) {
      const std::uint32_t from = root(down[n][i]);
      const bool joined = from == root(n);
      if (i > 0 && up[n] > 0) {
        add(joined ? TopologyEvent::Kind::Handle : TopologyEvent::Kind::Merge);
      }
      parent[from] = root(n);
    }
    for (std::size_t i = 1; !down[n].empty() && i < up[n]; ++i) {
      add(TopologyEvent::Kind::Split);
    }
    for (std::size_t i = 0; up[n] == 0 && i < down[n].size(); ++i) {
      add(TopologyEvent::Kind::End);
    }
  }
  return events;
}

}  // namespace

ReebGraph reebGraph(const TriangleMesh& mesh,
                    const HalfEdges& halfEdges,
                    const std::vector<double>& field) {
  return Sweep(mesh, halfEdges, field).run();
}

FieldTopology fieldTopology(const TriangleMesh& mesh,
                            const HalfEdges& halfEdges,
                            const std::vector<double>& field,
                            double least) {
  if (field.size() != mesh.vertices.size() || !(least >= 0.0)) {
    throw Error(
        ErrorCode::InvalidArgument,
        "the field must have one value per vertex and the least branch must not be negative",
        "topology of a field");
  }
  ReebGraph graph = simplified(reebGraph(mesh, halfEdges, field), least);
  FieldTopology result;
  result.events = eventsOf(graph, mesh);
  std::vector<std::uint32_t> order(graph.arcs.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto key = [&](std::uint32_t arc) {
      const ReebGraph::Node& from = graph.nodes[graph.arcs[arc].from];
      const ReebGraph::Node& to = graph.nodes[graph.arcs[arc].to];
      return std::make_tuple(from.level, from.vertex, to.level, to.vertex, arc);
    };
    return key(a) < key(b);
  });
  std::vector<std::uint32_t> branchOfArc(graph.arcs.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    branchOfArc[order[i]] = i;
  }
  for (const std::uint32_t a : order) {
    const ReebGraph::Arc& arc = graph.arcs[a];
    FieldBranch branch;
    branch.from = graph.nodes[arc.from].level;
    branch.to = graph.nodes[arc.to].level;
    for (const std::uint32_t b : order) {
      if (graph.arcs[b].to == arc.from) {
        branch.below.push_back(branchOfArc[b]);
      }
      if (graph.arcs[b].from == arc.to) {
        branch.above.push_back(branchOfArc[b]);
      }
    }
    result.branches.push_back(std::move(branch));
  }
  result.branchOf.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t arc = graph.arcOfTriangle[t];
    result.branchOf[t] = arc == kNone ? kNone : branchOfArc[arc];
  }
  return result;
}

}  // namespace wcam::geometry
