// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/cut_mesh.hpp"
#include "wcam/geometry/topology_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace wcam::geometry {

namespace {

constexpr std::uint32_t kNone = HalfEdges::kNone;

/// Groups of triangles that grow together.
class Groups {
public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  std::uint32_t of(std::uint32_t i) {
    while (parent_[i] != i) {
      i = parent_[i] = parent_[parent_[i]];
    }
    return i;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a);
    b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::uint32_t> parent_;
};

/// A mesh edge on a cut: the triangles below and above it.
struct Contact {
  double level = 0.0;
  std::uint32_t below = 0;
  std::uint32_t above = 0;
  double length = 0.0;
};

/// Joins the triangles of a cut surface to pieces: what lies between two cuts first, then across
/// cuts where one curve goes on as one.
class PieceMaker {
public:
  PieceMaker(const CutSurface& cut, const std::vector<double>& levels, double least)
      : cut_(cut),
        levels_(levels.begin(), levels.end()),
        least_(least),
        groups_(cut.surface.mesh.triangles.size()) {
    joinWithinSlabs();
  }

  std::vector<FieldPiece> run() {
    do {
      joinThrough();
    } while (joinSmall());
    return pieces();
  }

private:
  [[nodiscard]] bool valid(std::uint32_t t) const {
    const auto& corners = cut_.surface.mesh.triangles[t];
    return std::all_of(corners.begin(), corners.end(),
                       [&](std::uint32_t v) { return std::isfinite(cut_.field[v]); });
  }

  [[nodiscard]] std::pair<double, double> range(std::uint32_t t) const {
    const auto& [a, b, c] = cut_.surface.mesh.triangles[t];
    return std::minmax({cut_.field[a], cut_.field[b], cut_.field[c]});
  }

  void joinWithinSlabs() {
    const TriangleMesh& mesh = cut_.surface.mesh;
    for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
      const std::uint32_t twin = cut_.surface.halfEdges.twin(h);
      if (twin == kNone || twin < h || !valid(h / 3) || !valid(twin / 3)) {
        continue;
      }
      const std::uint32_t a = mesh.triangles[h / 3][h % 3];
      const std::uint32_t b = mesh.triangles[h / 3][(h % 3 + 1) % 3];
      const double level = cut_.field[a];
      if (level != cut_.field[b] || levels_.count(level) == 0) {
        groups_.join(h / 3, twin / 3);
        continue;
      }
      const bool firstBelow = range(h / 3).first < level;
      const bool secondBelow = range(twin / 3).first < level;
      const bool firstFlat = range(h / 3).first == range(h / 3).second;
      const bool secondFlat = range(twin / 3).first == range(twin / 3).second;
      if (firstBelow == secondBelow && !firstFlat && !secondFlat) {
        groups_.join(h / 3, twin / 3);  // a ridge that only touches the level
        continue;
      }
      // A flat triangle counts as above what is below it and as below the rest.
      const bool swapped = firstBelow == secondBelow ? secondFlat && !firstFlat : secondBelow;
      contacts_.push_back({level, swapped ? twin / 3 : h / 3, swapped ? h / 3 : twin / 3,
                           (mesh.vertices[b] - mesh.vertices[a]).norm()});
    }
  }

  /// Joins two groups wherever at a level they touch each other and nothing else.
  void joinThrough() {
    for (const double level : levels_) {
      std::map<std::uint32_t, std::set<std::uint32_t>> above;
      std::map<std::uint32_t, std::set<std::uint32_t>> below;
      for (const Contact& contact : contacts_) {
        const std::uint32_t low = groups_.of(contact.below);
        const std::uint32_t high = groups_.of(contact.above);
        if (contact.level == level && low != high) {
          above[low].insert(high);
          below[high].insert(low);
        }
      }
      for (const auto& [low, highs] : above) {
        if (highs.size() == 1 && below[*highs.begin()].size() == 1) {
          groups_.join(low, *highs.begin());
        }
      }
    }
  }

  /// Joins each group with a small span to the one with which it shares most of its border, the
  /// smallest first.
  bool joinSmall() {
    std::map<std::uint32_t, std::pair<double, double>> spans;
    for (std::uint32_t t = 0; t < cut_.surface.mesh.triangles.size(); ++t) {
      if (valid(t)) {
        const auto [low, high] = range(t);
        const auto [it, made] = spans.try_emplace(groups_.of(t), low, high);
        it->second = {std::min(it->second.first, low), std::max(it->second.second, high)};
      }
    }
    std::map<std::uint32_t, std::map<std::uint32_t, double>> shared;
    for (const Contact& contact : contacts_) {
      const std::uint32_t a = groups_.of(contact.below);
      const std::uint32_t b = groups_.of(contact.above);
      if (a != b) {
        shared[a][b] += contact.length;
        shared[b][a] += contact.length;
      }
    }
    std::vector<std::pair<double, std::uint32_t>> small;
    for (const auto& [group, span] : spans) {
      if (span.second - span.first <= least_ && shared.count(group) != 0) {
        small.emplace_back(span.second - span.first, group);
      }
    }
    std::sort(small.begin(), small.end());
    std::set<std::uint32_t> touched;
    for (const auto& [span, group] : small) {
      if (touched.count(group) != 0) {
        continue;  // has grown: the next round looks at it again
      }
      std::uint32_t best = kNone;
      double most = -1.0;
      for (const auto& [other, length] : shared[group]) {
        if (length > most) {
          best = other;
          most = length;
        }
      }
      groups_.join(group, best);
      touched.insert({group, best});
    }
    return !small.empty();
  }

  std::vector<FieldPiece> pieces() {
    struct Entry {
      double from = std::numeric_limits<double>::infinity();
      double to = -std::numeric_limits<double>::infinity();
      std::vector<bool> keep;
    };

    const std::size_t count = cut_.surface.mesh.triangles.size();
    std::map<std::uint32_t, Entry> entries;
    for (std::uint32_t t = 0; t < count; ++t) {
      if (valid(t)) {
        Entry& entry = entries[groups_.of(t)];
        entry.keep.resize(count, false);
        entry.keep[t] = true;
        entry.from = std::min(entry.from, range(t).first);
        entry.to = std::max(entry.to, range(t).second);
      }
    }
    std::vector<std::pair<double, std::uint32_t>> order;
    for (const auto& [group, entry] : entries) {
      order.emplace_back(entry.from, group);
    }
    std::sort(order.begin(), order.end());
    std::map<std::uint32_t, std::size_t> indexOf;
    std::vector<FieldPiece> result;
    for (const auto& [from, group] : order) {
      indexOf[group] = result.size();
      SubSurface sub = keepTriangles(cut_.surface, entries[group].keep);
      FieldPiece piece;
      for (const std::uint32_t v : sub.vertexOf) {
        piece.field.push_back(cut_.field[v]);
      }
      piece.surface = std::move(sub.surface);
      piece.from = from;
      piece.to = entries[group].to;
      result.push_back(std::move(piece));
    }
    std::set<std::pair<std::size_t, std::size_t>> links;
    for (const Contact& contact : contacts_) {
      const std::size_t low = indexOf[groups_.of(contact.below)];
      const std::size_t high = indexOf[groups_.of(contact.above)];
      if (low != high && result[low].from < contact.level && contact.level < result[high].to) {
        links.emplace(low, high);
      }
    }
    for (const auto& [low, high] : links) {
      result[low].above.push_back(high);
      result[high].below.push_back(low);
    }
    return result;
  }

  const CutSurface& cut_;
  std::set<double> levels_;
  double least_;
  Groups groups_;
  std::vector<Contact> contacts_;
};

}  // namespace

std::vector<FieldPiece> splitAtSaddles(const PartSurface& surface,
                                       const std::vector<double>& field,
                                       double least,
                                       const JobContext& context) {
  const FieldTopology topology = fieldTopology(surface.mesh, surface.halfEdges, field, least);
  std::set<double> saddles;
  for (const TopologyEvent& event : topology.events) {
    if (event.kind != TopologyEvent::Kind::Begin && event.kind != TopologyEvent::Kind::End) {
      saddles.insert(event.level);
    }
  }
  context.check();
  const std::vector<double> levels(saddles.begin(), saddles.end());
  const CutSurface cut = cutAtLevels(surface, field, levels);
  context.check();
  return PieceMaker(cut, levels, least).run();
}

}  // namespace wcam::geometry
