// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reeb_graph.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace wcam::geometry {

namespace {

constexpr std::uint32_t kNone = HalfEdges::kNone;

class Simplifier {
public:
  Simplifier(ReebGraph graph, double least)
      : graph_(std::move(graph)),
        least_(least),
        into_(graph_.arcs.size()),
        alive_(graph_.arcs.size(), true),
        down_(graph_.nodes.size()),
        up_(graph_.nodes.size()) {
    for (std::uint32_t a = 0; a < graph_.arcs.size(); ++a) {
      into_[a] = a;
      down_[graph_.arcs[a].to].insert(a);
      up_[graph_.arcs[a].from].insert(a);
    }
    for (std::uint32_t a = 0; a < graph_.arcs.size(); ++a) {
      offer(a);
    }
  }

  ReebGraph run() {
    do {
      while (!open_.empty()) {
        const std::uint32_t arc = open_.begin()->second;
        open_.erase(open_.begin());
        if (!cancel(arc)) {
          stuck_.insert({length(arc), arc});
        }
      }
    } while (contractOne());
    return packed();
  }

private:
  [[nodiscard]] double length(std::uint32_t a) const {
    return graph_.nodes[graph_.arcs[a].to].level - graph_.nodes[graph_.arcs[a].from].level;
  }

  /// Puts an arc up for removal when it is short.
  void offer(std::uint32_t a) {
    stuck_.erase({length(a), a});
    if (length(a) <= least_) {
      open_.insert({length(a), a});
    }
  }

  void withdraw(std::uint32_t a) {
    open_.erase({length(a), a});
    stuck_.erase({length(a), a});
  }

  void offerAround(std::uint32_t node) {
    for (const std::uint32_t a : down_[node]) {
      offer(a);
    }
    for (const std::uint32_t a : up_[node]) {
      offer(a);
    }
  }

  /// Takes an arc out; its triangles go to `heir`.
  void remove(std::uint32_t a, std::uint32_t heir) {
    withdraw(a);
    up_[graph_.arcs[a].from].erase(a);
    down_[graph_.arcs[a].to].erase(a);
    alive_[a] = false;
    into_[a] = heir;
  }

  /// Joins the two arcs of a node that changes nothing any more.
  void splice(std::uint32_t node) {
    if (down_[node].size() == 1 && up_[node].size() == 1) {
      const std::uint32_t below = *down_[node].begin();
      const std::uint32_t above = *up_[node].begin();
      const std::uint32_t top = graph_.arcs[above].to;
      remove(above, below);
      withdraw(below);
      down_[node].clear();
      graph_.arcs[below].to = top;
      down_[top].insert(below);
      offerAround(graph_.arcs[below].from);
      offerAround(top);
      return;
    }
    offerAround(node);
  }

  /// Removes a dead end beside another way or one of two ways. Returns false when the arc is
  /// neither.
  bool cancel(std::uint32_t a) {
    const auto [from, to] = graph_.arcs[a];
    const bool blindBelow = down_[from].empty() && up_[from].size() == 1;
    const bool blindAbove = up_[to].empty() && down_[to].size() == 1;
    if (blindBelow && down_[to].size() > 1) {
      const auto sibling =
          std::find_if(down_[to].begin(), down_[to].end(), [&](std::uint32_t b) { return b != a; });
      remove(a, up_[to].empty() ? *sibling : *up_[to].begin());
      splice(to);
      return true;
    }
    if (blindAbove && up_[from].size() > 1) {
      const auto sibling =
          std::find_if(up_[from].begin(), up_[from].end(), [&](std::uint32_t b) { return b != a; });
      remove(a, down_[from].empty() ? *sibling : *down_[from].begin());
      splice(from);
      return true;
    }
    for (const std::uint32_t b : up_[from]) {
      if (b != a && graph_.arcs[b].to == to) {
        remove(a, b);
        splice(from);
        splice(to);
        return true;
      }
    }
    return false;
  }

  /// Whether a way other than the arc itself leads up from its start to its end.
  [[nodiscard]] bool hasDetour(std::uint32_t a) const {
    const auto [from, to] = graph_.arcs[a];
    std::vector<std::uint32_t> stack;
    std::set<std::uint32_t> seen;
    for (const std::uint32_t b : up_[from]) {
      if (b != a) {
        stack.push_back(graph_.arcs[b].to);
      }
    }
    while (!stack.empty()) {
      const std::uint32_t node = stack.back();
      stack.pop_back();
      if (node == to) {
        return true;
      }
      if (graph_.nodes[node].level > graph_.nodes[to].level || !seen.insert(node).second) {
        continue;
      }
      for (const std::uint32_t b : up_[node]) {
        stack.push_back(graph_.arcs[b].to);
      }
    }
    return false;
  }

  /// Draws the ends of the shortest arc together. A piece without neighbours stays.
  bool contractOne() {
    for (const auto& stuck : stuck_) {
      const std::uint32_t a = stuck.second;
      const std::uint32_t from = graph_.arcs[a].from;
      const std::uint32_t to = graph_.arcs[a].to;
      if (down_[from].size() + up_[from].size() + down_[to].size() + up_[to].size() == 2 ||
          hasDetour(a)) {
        continue;
      }
      // All ways must still lead upwards.
      const double low = graph_.nodes[from].level;
      const double high = graph_.nodes[to].level;
      const bool keepLow = std::all_of(down_[to].begin(), down_[to].end(), [&](std::uint32_t b) {
        return b == a || graph_.nodes[graph_.arcs[b].from].level <= low;
      });
      const bool keepHigh = std::all_of(up_[from].begin(), up_[from].end(), [&](std::uint32_t b) {
        return b == a || graph_.nodes[graph_.arcs[b].to].level >= high;
      });
      if (keepLow || keepHigh) {
        contract(a, keepLow);
        return true;
      }
    }
    return false;
  }

  /// The first other arc at the ends of an arc, the one above if there is one.
  [[nodiscard]] std::uint32_t neighbourOf(std::uint32_t a) const {
    const auto [from, to] = graph_.arcs[a];
    for (const auto* arcs : {&up_[to], &down_[from], &down_[to], &up_[from]}) {
      for (const std::uint32_t b : *arcs) {
        if (b != a) {
          return b;
        }
      }
    }
    return a;
  }

  void contract(std::uint32_t arc, bool keepLow) {
    const auto [from, to] = graph_.arcs[arc];
    const std::uint32_t kept = keepLow ? from : to;
    const std::uint32_t gone = keepLow ? to : from;
    remove(arc, neighbourOf(arc));
    for (const std::uint32_t b : down_[gone]) {
      withdraw(b);
      graph_.arcs[b].to = kept;
      down_[kept].insert(b);
    }
    for (const std::uint32_t b : up_[gone]) {
      withdraw(b);
      graph_.arcs[b].from = kept;
      up_[kept].insert(b);
    }
    down_[gone].clear();
    up_[gone].clear();
    splice(kept);
  }

  ReebGraph packed() {
    ReebGraph result;
    std::vector<std::uint32_t> newNode(graph_.nodes.size(), kNone);
    for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) {
      if (!down_[n].empty() || !up_[n].empty()) {
        newNode[n] = static_cast<std::uint32_t>(result.nodes.size());
        result.nodes.push_back(graph_.nodes[n]);
      }
    }
    std::vector<std::uint32_t> newArc(graph_.arcs.size(), kNone);
    for (std::uint32_t a = 0; a < graph_.arcs.size(); ++a) {
      if (alive_[a]) {
        newArc[a] = static_cast<std::uint32_t>(result.arcs.size());
        result.arcs.push_back({newNode[graph_.arcs[a].from], newNode[graph_.arcs[a].to]});
      }
    }
    result.arcOfTriangle = std::move(graph_.arcOfTriangle);
    for (std::uint32_t& arc : result.arcOfTriangle) {
      if (arc != kNone) {
        while (into_[arc] != arc) {
          arc = into_[arc] = into_[into_[arc]];
        }
        arc = newArc[arc];
      }
    }
    return result;
  }

  ReebGraph graph_;
  double least_;
  std::vector<std::uint32_t> into_;  ///< arc that took an arc's triangles; itself while it lives
  std::vector<bool> alive_;
  std::vector<std::set<std::uint32_t>> down_;  ///< per node: arcs that end there
  std::vector<std::set<std::uint32_t>> up_;
  std::set<std::pair<double, std::uint32_t>> open_;   ///< short arcs, shortest first
  std::set<std::pair<double, std::uint32_t>> stuck_;  ///< short arcs that cannot be cancelled
};

}  // namespace

ReebGraph simplified(ReebGraph graph, double least) {
  return Simplifier(std::move(graph), least).run();
}

}  // namespace wcam::geometry
