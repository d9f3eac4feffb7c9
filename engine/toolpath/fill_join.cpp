// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fill_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace wcam::toolpath::detail {

namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
/// A bridge that comes this near to a bead, in parts of its length, touches it.
constexpr double kTouch = 1e-6;

/// A place on a loop: on the edge from point `edge`, at `fraction` of it.
struct LoopPlace {
  std::size_t edge = 0;
  double fraction = 0.0;
  Vec2 p = Vec2::Zero();
  double distance = std::numeric_limits<double>::infinity();
};

LoopPlace nearestOn(const Polyline2& loop, const Vec2& p) {
  LoopPlace best;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2& a = loop[i];
    const Vec2 d = loop[(i + 1) % loop.size()] - a;
    const double length2 = d.squaredNorm();
    const double s = length2 > 0.0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
    const double distance = (p - a - s * d).norm();
    if (distance < best.distance) {
      best = {i, s, a + s * d, distance};
    }
  }
  return best;
}

Vec2 middleOfLongestEdge(const Polyline2& loop) {
  std::size_t longest = 0;
  double length = -1.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double l = (loop[(i + 1) % loop.size()] - loop[i]).norm();
    // A hair longer is not longer: equal edges would change places with rounding.
    constexpr double kEqual = 1e-6;
    if (l > length * (1.0 + kEqual)) {
      length = l;
      longest = i;
    }
  }
  return 0.5 * (loop[longest] + loop[(longest + 1) % loop.size()]);
}

/// The goal that is nearest to the loop.
Vec2 nearestGoal(const Polyline2& loop, const std::vector<Vec2>& goals) {
  Vec2 best = goals.front();
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2& goal : goals) {
    const double distance = nearestOn(loop, goal).distance;
    constexpr double kEqual = 1e-6;
    if (distance < least * (1.0 - kEqual)) {
      least = distance;
      best = goal;
    }
  }
  return best;
}

/// Once around from a place, back to it.
Polyline2 around(const Polyline2& loop, const LoopPlace& start) {
  Polyline2 path{start.p};
  const std::size_t n = loop.size();
  for (std::size_t k = 1; k <= n; ++k) {
    const Vec2& p = loop[(start.edge + k) % n];
    if (p != path.back()) {
      path.push_back(p);
    }
  }
  if (path.back() != start.p) {
    path.push_back(start.p);
  }
  return path;
}

/// Takes a length off the end; at most half of the path.
void trimEnd(Polyline2& path, double length) {
  length = std::min(length, 0.5 * geometry::polylineLength(path, false));
  while (path.size() > 2) {
    const double last = (path.back() - path[path.size() - 2]).norm();
    if (last > length) {
      break;
    }
    length -= last;
    path.pop_back();
  }
  const Vec2 d = path.back() - path[path.size() - 2];
  if (d.norm() > length) {
    path.back() -= length / d.norm() * d;
  }
}

struct Node {
  const Polyline2* loop = nullptr;
  std::size_t parent = kNone;
  std::size_t children = 0;
  std::size_t child = kNone;
};

/// The loops of all insets; each hangs on the nearest loop of the inset before.
std::vector<Node> loopTree(const std::vector<Region2>& insets, double spacing) {
  std::vector<Node> nodes;
  std::size_t before = 0;
  std::size_t from = 0;
  for (const Region2& inset : insets) {
    const std::size_t begin = nodes.size();
    for (const Polyline2& loop : inset.loops) {
      Node node{&loop, kNone, 0, kNone};
      // Parallel curves are one spacing apart wherever both exist: the middle of the longest edge
      // is such a place.
      double nearest = std::numeric_limits<double>::infinity();
      const Vec2 probe = middleOfLongestEdge(loop);
      for (std::size_t k = before; k < from; ++k) {
        const double d = nearestOn(*nodes[k].loop, probe).distance;
        if (d < nearest) {
          nearest = d;
          node.parent = k;
        }
      }
      constexpr double kSlack = 1.5;
      if (nearest > kSlack * spacing) {
        node.parent = kNone;
      }
      nodes.push_back(node);
    }
    before = begin;
    from = nodes.size();
  }
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (nodes[k].parent != kNone) {
      ++nodes[nodes[k].parent].children;
      nodes[nodes[k].parent].child = k;
    }
  }
  return nodes;
}

bool staysInside(const Vec2& a, const Vec2& b, const Region2& region) {
  const double length = (b - a).norm();
  double inside = 0.0;
  for (const Polyline2& piece : geometry::clipPolyline({a, b}, region)) {
    inside += geometry::polylineLength(piece, false);
  }
  // Ends on the border itself are inside or not by rounding.
  constexpr double kRounding = 1e-6;
  return inside >= (1.0 - kRounding) * length;
}

/// Whether the segment from a to b crosses or touches the path, other than at its own ends.
bool crosses(const Vec2& a, const Vec2& b, const Polyline2& path) {
  const double touch = kTouch * (b - a).norm();
  const auto side = [](const Vec2& p, const Vec2& q, const Vec2& r) {
    const Vec2 u = q - p;
    const Vec2 v = r - p;
    return u.x() * v.y() - u.y() * v.x();
  };
  const auto near = [&](const Vec2& p, const Vec2& q, const Vec2& r) {
    const Vec2 d = q - p;
    const double length2 = d.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp((r - p).dot(d) / length2, 0.0, 1.0) : 0.0;
    return (r - p - t * d).norm() <= touch;
  };
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec2& c = path[i];
    const Vec2& d = path[i + 1];
    if (side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0) {
      return true;
    }
    const bool shared = c == a || c == b || d == a || d == b;
    if (near(a, b, c) && c != a && c != b) {
      return true;
    }
    if (near(a, b, d) && d != a && d != b) {
      return true;
    }
    if (!shared && (near(c, d, a) || near(c, d, b))) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<Polyline2> spirals(const std::vector<Region2>& insets,
                               double spacing,
                               const std::vector<Vec2>& goals) {
  const std::vector<Node> nodes = loopTree(insets, spacing);
  std::vector<Polyline2> result;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const bool begins = nodes[k].parent == kNone || nodes[nodes[k].parent].children != 1;
    if (!begins) {
      continue;
    }
    std::vector<const Polyline2*> chain;
    for (std::size_t i = k;; i = nodes[i].child) {
      chain.push_back(nodes[i].loop);
      if (nodes[i].children != 1) {
        break;
      }
    }
    // Starts from inside to outside: straight across, where all loops of the chain exist.
    std::vector<LoopPlace> starts(chain.size());
    Vec2 anchor =
        goals.empty() ? middleOfLongestEdge(*chain.back()) : nearestGoal(*chain.back(), goals);
    for (std::size_t i = chain.size(); i-- > 0;) {
      starts[i] = nearestOn(*chain[i], anchor);
      anchor = starts[i].p;
    }
    Polyline2 path;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      Polyline2 turn = around(*chain[i], starts[i]);
      // The last turn ends beside its start: the round ends of the bead close it.
      trimEnd(turn, i + 1 < chain.size() ? spacing : 0.5 * spacing);
      // Where the next loop is not straight across, the bridge would cut through a turn.
      if (!path.empty() &&
          (crosses(path.back(), turn.front(), path) || crosses(path.back(), turn.front(), turn))) {
        result.push_back(std::move(path));
        path.clear();
      }
      path.insert(path.end(), turn.begin(), turn.end());
    }
    result.push_back(std::move(path));
  }
  return result;
}

std::vector<Polyline2> joinPieces(const std::vector<Joinable>& pieces,
                                  const Region2& region,
                                  double reach) {
  std::vector<char> used(pieces.size(), 0);
  std::vector<Polyline2> result;

  struct Choice {
    std::size_t piece = kNone;
    std::size_t way = 0;
    bool reversed = false;
    double distance = std::numeric_limits<double>::infinity();
  };

  const auto oriented = [&](const Choice& c) {
    Polyline2 path = pieces[c.piece].ways[c.way];
    if (c.reversed) {
      std::reverse(path.begin(), path.end());
    }
    return path;
  };
  const auto nearest = [&](const Vec2& end, double limit, bool bridged) {
    std::vector<Choice> choices;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t w = 0; used[i] == 0 && w < pieces[i].ways.size(); ++w) {
        const Polyline2& way = pieces[i].ways[w];
        choices.push_back({i, w, false, (way.front() - end).norm()});
        choices.push_back({i, w, true, (way.back() - end).norm()});
      }
    }
    std::erase_if(choices, [&](const Choice& c) { return c.distance > limit; });
    std::stable_sort(choices.begin(), choices.end(),
                     [](const Choice& a, const Choice& b) { return a.distance < b.distance; });
    for (const Choice& c : choices) {
      const Polyline2& way = pieces[c.piece].ways[c.way];
      const Vec2& start = c.reversed ? way.back() : way.front();
      if (!bridged || (staysInside(end, start, region) && !crosses(end, start, way) &&
                       !crosses(end, start, result.back()))) {
        return c;
      }
    }
    return Choice{};
  };
  for (std::size_t left = pieces.size(); left > 0;) {
    Choice choice;
    if (result.empty()) {
      choice = {0, 0, false, 0.0};
    } else {
      choice = nearest(result.back().back(), reach, true);
      if (choice.piece == kNone) {
        choice = nearest(result.back().back(), std::numeric_limits<double>::infinity(), false);
        result.emplace_back();
      }
    }
    if (result.empty()) {
      result.emplace_back();
    }
    const Polyline2 path = oriented(choice);
    result.back().insert(result.back().end(), path.begin(), path.end());
    used[choice.piece] = 1;
    --left;
  }
  return result;
}

}  // namespace wcam::toolpath::detail
