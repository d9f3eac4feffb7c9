// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/base_curve.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/level_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace wcam::toolpath {

namespace {

using geometry::HalfEdges;
using geometry::MeshPoint;
using geometry::PartSurface;

constexpr std::uint32_t kNone = HalfEdges::kNone;
constexpr const char* kPlace = "base of the part";
constexpr std::size_t kVertexGrain = 4096;
/// A border that is partly on the substrate leaves it at corners: steeper than this (sine) the next
/// edge rises. A slanted or wavy rim leaves smoothly, and stays one border.
constexpr double kLeavesSteeply = 0.5;
/// What stands on less than this part of a border does not stand on it.
constexpr double kStandingPart = 0.02;
/// A border turns by more than this at the corner between its side and its top (cosine of 45°).
constexpr double kCorner = 0.70710678118654752440;
/// Rounding of a height, in parts of the part's size.
constexpr double kHeightSnap = 1e-11;

std::string describe(const Vec3& p) {
  return formatFixed(p.x(), 2) + ", " + formatFixed(p.y(), 2) + ", " + formatFixed(p.z(), 2);
}

/// Component of each vertex, numbered by the lowest vertex; vertices without triangle get a
/// component of their own, which is left out.
struct Components {
  std::vector<std::size_t> of;
  std::size_t count = 0;
};

Components connectedPieces(const geometry::TriangleMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&parent](std::uint32_t v) {
    while (parent[v] != v) {
      parent[v] = parent[parent[v]];
      v = parent[v];
    }
    return v;
  };
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      used[v] = true;
      const std::uint32_t a = root(t[0]);
      const std::uint32_t b = root(v);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  Components pieces;
  constexpr std::size_t kUnset = std::numeric_limits<std::size_t>::max();
  pieces.of.assign(mesh.vertices.size(), kUnset);
  for (std::uint32_t v = 0; v < parent.size(); ++v) {
    if (used[v]) {
      // The root is the lowest vertex, so it has its number already.
      pieces.of[v] = root(v) == v ? pieces.count++ : pieces.of[root(v)];
    }
  }
  return pieces;
}

/// What is known of a piece before its base is.
struct Piece {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  std::uint32_t lowestVertex = 0;
  std::vector<std::size_t> loops;  ///< its borders

  [[nodiscard]] bool crosses() const {
    return lowest < -kSubstrateContact && highest > kSubstrateContact;
  }

  [[nodiscard]] bool below() const {
    return highest <= kSubstrateContact && lowest < -kSubstrateContact;
  }
};

MeshPoint atStart(std::uint32_t h) {
  MeshPoint point{h / 3, {0.0, 0.0, 0.0}};
  point.weights[h % 3] = 1.0;
  return point;
}

MeshPoint onHalfEdge(std::uint32_t h, double fraction) {
  MeshPoint point{h / 3, {0.0, 0.0, 0.0}};
  point.weights[h % 3] = 1.0 - fraction;
  point.weights[(h % 3 + 1) % 3] = fraction;
  return point;
}

class BaseFinder {
public:
  BaseFinder(const PartSurface& surface, const Substrate& substrate, const JobContext& context)
      : surface_(surface), mesh_(surface.mesh), context_(context) {
    height_.resize(mesh_.vertices.size());
    parallelFor(
        height_.size(), kVertexGrain,
        [&](std::size_t v) { height_[v] = substrate.heightAbove(mesh_.vertices[v]); }, context);
    Components pieces = connectedPieces(mesh_);
    base_.component = std::move(pieces.of);
    pieces_.resize(pieces.count);
    base_.kind.assign(pieces.count, BaseKind::None);
    for (std::uint32_t v = 0; v < height_.size(); ++v) {
      if (base_.component[v] < pieces_.size()) {
        Piece& piece = pieces_[base_.component[v]];
        piece.highest = std::max(piece.highest, height_[v]);
        if (height_[v] < piece.lowest) {
          piece.lowest = height_[v];
          piece.lowestVertex = v;
        }
      }
    }
    collectBorders();
  }

  PartBase run() {
    base_.side.resize(height_.size());
    for (std::uint32_t v = 0; v < height_.size(); ++v) {
      const std::size_t k = base_.component[v];
      const bool crossed = k < pieces_.size() && pieces_[k].crosses();
      base_.side[v] = height_[v] < (crossed ? 0.0 : -kSubstrateContact) ? -1 : 1;
    }
    bool any = false;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      any = findPiece(k) || any;
    }
    if (!any && !floating_.empty()) {
      throw Error(ErrorCode::JobFailed, floatingMessage(floating_.front()), kPlace,
                  "lower the part by that much, or select an open working surface (faces) of it");
    }
    if (!any) {
      throw Error(ErrorCode::CheckFailed, "the whole part lies below the substrate", kPlace,
                  "raise the part or lower the substrate");
    }
    for (const std::size_t k : floating_) {
      context_.add({Severity::Warning,
                    "slicing.piece_without_base",
                    text("%1; it gets no layer", {floatingMessage(k)}),
                    "join the piece to the others, or slice it as a part of its own",
                    {},
                    placeData(mesh_.vertices[pieces_[k].lowestVertex], pieces_[k].lowest)});
    }
    return std::move(base_);
  }

private:
  [[nodiscard]] std::uint32_t startOf(std::uint32_t h) const {
    return mesh_.triangles[h / 3][h % 3];
  }

  [[nodiscard]] std::uint32_t endOf(std::uint32_t h) const {
    return mesh_.triangles[h / 3][(h % 3 + 1) % 3];
  }

  void collectBorders() {
    const HalfEdges& halfEdges = surface_.halfEdges;
    std::vector<bool> visited(3 * mesh_.triangles.size(), false);
    const auto next = [](std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; };
    for (std::uint32_t start = 0; start < visited.size(); ++start) {
      if (halfEdges.twin(start) != kNone || visited[start]) {
        continue;
      }
      BaseLoop loop;
      for (std::uint32_t h = start; !visited[h];) {
        visited[h] = true;
        loop.halfEdges.push_back(h);
        loop.vertices.push_back(startOf(h));
        loop.points.push_back(atStart(h));
        h = next(h);
        while (halfEdges.twin(h) != kNone) {
          h = next(halfEdges.twin(h));
        }
      }
      // Closes in the triangle of the last edge.
      loop.points.push_back(onHalfEdge(loop.halfEdges.back(), 1.0));
      loop.component = base_.component[loop.vertices.front()];
      measure(loop);
      pieces_[loop.component].loops.push_back(loops_.size());
      loops_.push_back(std::move(loop));
    }
  }

  void measure(BaseLoop& loop) const {
    loop.lowest = std::numeric_limits<double>::infinity();
    loop.highest = -loop.lowest;
    double sum = 0.0;
    Vec3 before = Vec3::Zero();
    double heightBefore = 0.0;
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const Vec3 p = position(mesh_, loop.points[i]);
      const double h = valueAt(mesh_, height_, loop.points[i]);
      loop.lowest = std::min(loop.lowest, h);
      loop.highest = std::max(loop.highest, h);
      if (i > 0) {
        const double length = (p - before).norm();
        loop.length += length;
        sum += 0.5 * (h + heightBefore) * length;
      }
      before = p;
      heightBefore = h;
    }
    loop.mean = loop.length > 0.0 ? sum / loop.length : loop.lowest;
  }

  /// The stretch of a border between two of its half-edges, the last one not included.
  [[nodiscard]] BaseLoop stretch(const BaseLoop& loop, std::size_t first, std::size_t count) const {
    BaseLoop part;
    part.closed = false;
    part.component = loop.component;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t h = loop.halfEdges[(first + i) % loop.halfEdges.size()];
      part.halfEdges.push_back(h);
      part.vertices.push_back(startOf(h));
      part.points.push_back(atStart(h));
    }
    part.points.push_back(onHalfEdge(part.halfEdges.back(), 1.0));
    part.vertices.push_back(endOf(part.halfEdges.back()));
    measure(part);
    return part;
  }

  [[nodiscard]] double rise(std::uint32_t h) const {
    const double length = (mesh_.vertices[endOf(h)] - mesh_.vertices[startOf(h)]).norm();
    return length > 0.0 ? std::abs(height_[endOf(h)] - height_[startOf(h)]) / length : 0.0;
  }

  [[nodiscard]] Vec3 directionOf(std::uint32_t h) const {
    return (mesh_.vertices[endOf(h)] - mesh_.vertices[startOf(h)]).normalized();
  }

  /// Stretches of a border between half-edges that are not `inside`: first half-edge and number.
  /// None when all or no half-edges are inside.
  template <class Inside>
  [[nodiscard]] static std::vector<std::pair<std::size_t, std::size_t>> stretches(
      std::size_t size, const Inside& inside) {
    std::size_t begin = 0;
    while (begin < size && inside(begin)) {
      ++begin;
    }
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t i = 0; begin < size && i < size;) {
      std::size_t count = 0;
      while (i + count < size && inside((begin + i + count) % size)) {
        ++count;
      }
      if (count > 0) {
        found.emplace_back((begin + i) % size, count);
      }
      i += count + 1;
    }
    return found;
  }

  /// The stretches of a border on which a sheet stands: those on the substrate that end at corners.
  /// Empty for borders that lie on it as a whole or not at all.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> standing(
      const BaseLoop& loop) const {
    const std::size_t size = loop.halfEdges.size();
    const auto lies = [&](std::size_t i) {
      const std::uint32_t h = loop.halfEdges[i];
      return std::abs(height_[startOf(h)]) <= kSubstrateContact &&
             std::abs(height_[endOf(h)]) <= kSubstrateContact;
    };
    auto found = stretches(size, lies);
    const bool holds = std::all_of(found.begin(), found.end(), [&](const auto& part) {
      const auto [first, count] = part;
      return rise(loop.halfEdges[(first + size - 1) % size]) >= kLeavesSteeply &&
             rise(loop.halfEdges[(first + count) % size]) >= kLeavesSteeply &&
             stretch(loop, first, count).length >= kStandingPart * loop.length;
    });
    return holds ? found : decltype(found){};
  }

  /// Adds the top of a sheet whose border is partly below or on the substrate (`low`): between two
  /// such stretches the border goes up a side, along the top and down a side. Without corners there
  /// is no top.
  template <class Low>
  void addTops(const BaseLoop& loop, const Low& low) {
    const std::size_t size = loop.halfEdges.size();
    for (const auto& [first, count] : stretches(size, [&low](std::size_t i) { return !low(i); })) {
      std::vector<std::size_t> corners;
      for (std::size_t i = 1; i < count; ++i) {
        const Vec3 before = directionOf(loop.halfEdges[(first + i - 1) % size]);
        const Vec3 after = directionOf(loop.halfEdges[(first + i) % size]);
        if (before.dot(after) < kCorner) {
          corners.push_back(i);
        }
      }
      if (corners.size() >= 2) {
        base_.upper.push_back(
            stretch(loop, (first + corners.front()) % size, corners.back() - corners.front()));
      }
    }
  }

  /// @return whether something of the piece is built
  bool findPiece(std::size_t k) {
    const Piece& piece = pieces_[k];
    if (piece.below()) {
      context_.add({Severity::Warning,
                    "slicing.piece_below_substrate",
                    "a piece of the part lies below the substrate and gets no layer",
                    "raise the part, or remove the piece",
                    {},
                    placeData(mesh_.vertices[piece.lowestVertex], piece.lowest)});
      return false;
    }
    if (piece.crosses()) {
      intersect(k);
    } else if (!piece.loops.empty()) {
      chooseBorders(k);
    } else if (piece.lowest > kSubstrateContact) {
      floating_.push_back(k);
      return false;
    } else {
      chooseContact(k);
    }
    return true;
  }

  static std::vector<std::pair<std::string, double>> placeData(const Vec3& p, double height) {
    return {{"x_mm", p.x()}, {"y_mm", p.y()}, {"z_mm", p.z()}, {"height_mm", height}};
  }

  void addUpper(std::size_t index) {
    if (loops_[index].mean > 0.0) {
      base_.upper.push_back(loops_[index]);
    }
  }

  void intersect(std::size_t k) {
    base_.kind[k] = BaseKind::Intersection;
    std::vector<double> field(height_.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t v = 0; v < field.size(); ++v) {
      if (base_.component[v] == k) {
        field[v] = height_[v];
      }
    }
    const std::vector<double> levels{0.0};
    const double size = std::max(1.0, mesh_.bounds().diagonal());
    const auto curves =
        geometry::traceLevels(mesh_, surface_.halfEdges, field, levels,
                              {kHeightSnap * size, geometry::flatTolerance(mesh_)}, context_);
    for (const geometry::LevelContour& contour : curves[0]) {
      BaseLoop loop;
      loop.closed = contour.closed;
      loop.component = k;
      for (std::size_t i = 0; i < contour.points.size(); ++i) {
        loop.points.push_back(onHalfEdge(contour.halfEdges[i], contour.fractions[i]));
      }
      if (loop.closed) {
        loop.points.push_back(loop.points.front());
      }
      measure(loop);
      base_.source.curves.push_back(loop.points);
      base_.lower.push_back(std::move(loop));
    }
    for (const std::size_t i : pieces_[k].loops) {
      const BaseLoop& loop = loops_[i];
      if (loop.lowest < -kSubstrateContact && loop.highest > kSubstrateContact) {
        addTops(loop, [&](std::size_t at) {
          const std::uint32_t h = loop.halfEdges[at];
          return height_[startOf(h)] < 0.0 || height_[endOf(h)] < 0.0;
        });
      } else {
        addUpper(i);
      }
    }
  }

  [[nodiscard]] static bool onSubstrate(const BaseLoop& loop) {
    return std::max(-loop.lowest, loop.highest) <= kSubstrateContact;
  }

  void addLower(const BaseLoop& loop) {
    base_.source.borderEdges.insert(base_.source.borderEdges.end(), loop.halfEdges.begin(),
                                    loop.halfEdges.end());
    base_.lower.push_back(loop);
  }

  void chooseBorders(std::size_t k) {
    base_.kind[k] = BaseKind::Border;
    const std::vector<std::size_t>& loops = pieces_[k].loops;
    double least = std::numeric_limits<double>::infinity();
    bool any = false;
    for (const std::size_t i : loops) {
      least = std::min(least, loops_[i].mean);
      any = any || onSubstrate(loops_[i]) || !standing(loops_[i]).empty();
    }
    const std::size_t before = base_.lower.size();
    for (const std::size_t i : loops) {
      const BaseLoop& loop = loops_[i];
      if (any ? onSubstrate(loop) : loop.mean <= least + kSubstrateContact) {
        addLower(loop);
        continue;
      }
      const auto feet = any ? standing(loop) : std::vector<std::pair<std::size_t, std::size_t>>{};
      if (feet.empty()) {
        addUpper(i);
        continue;
      }
      std::vector<bool> low(loop.halfEdges.size(), false);
      for (const auto& [first, count] : feet) {
        addLower(stretch(loop, first, count));
        for (std::size_t at = 0; at < count; ++at) {
          low[(first + at) % low.size()] = true;
        }
      }
      addTops(loop, [&low](std::size_t at) { return low[at]; });
    }
    const std::size_t count = base_.lower.size() - before;
    if (!any) {
      reportGap(base_.lower.back());
    }
    if (count > 1) {
      const Vec3 p = mesh_.vertices[base_.lower.back().vertices.front()];
      context_.add({Severity::Warning,
                    "slicing.several_lower_borders",
                    text("the part stands on %1 borders; layers grow from all of them and meet",
                         {std::to_string(count)}),
                    "split the part where they meet, or choose the working surface with one lower "
                    "border",
                    {},
                    {{"borders", static_cast<double>(count)},
                     {"x_mm", p.x()},
                     {"y_mm", p.y()},
                     {"z_mm", p.z()}}});
    }
  }

  void reportGap(const BaseLoop& loop) {
    const std::uint32_t v = *std::max_element(
        loop.vertices.begin(), loop.vertices.end(),
        [this](std::uint32_t a, std::uint32_t b) { return height_[a] < height_[b]; });
    context_.add({Severity::Warning,
                  "slicing.base_off_substrate",
                  text("the lowest border of the part does not lie on the substrate: it is %1 to "
                       "%2 mm above it, most at %3",
                       {formatFixed(loop.lowest, 3), formatFixed(loop.highest, 3),
                        describe(mesh_.vertices[v])}),
                  "move the part or the substrate, or extend the part below the substrate so that "
                  "it is cut there",
                  {},
                  placeData(mesh_.vertices[v], height_[v])});
  }

  [[nodiscard]] Text floatingMessage(std::size_t k) const {
    const Piece& piece = pieces_[k];
    return text(
        "a closed surface without a border does not touch the substrate: its lowest point "
        "%1 is %2 mm above it",
        {describe(mesh_.vertices[piece.lowestVertex]), formatFixed(piece.lowest, 3)});
  }

  void chooseContact(std::size_t k) {
    base_.kind[k] = BaseKind::Contact;
    const auto touches = [&](std::uint32_t v) {
      return base_.component[v] == k && height_[v] <= kSubstrateContact;
    };
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!inContact(t, touches)) {
        continue;
      }
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        const std::uint32_t twin = surface_.halfEdges.twin(h);
        if (twin != kNone && !inContact(twin / 3, touches)) {
          base_.source.borderEdges.push_back(twin);
        }
      }
    }
    for (std::uint32_t v = 0; v < height_.size(); ++v) {
      if (touches(v)) {
        contact_.push_back(v);
      }
    }
    addContactVertices();
  }

  template <class Touches>
  [[nodiscard]] bool inContact(std::uint32_t t, const Touches& touches) const {
    const auto& corners = mesh_.triangles[t];
    return std::all_of(corners.begin(), corners.end(), touches);
  }

  /// Vertices on the rim of the contact are source by its edges; the others by themselves.
  void addContactVertices() {
    std::vector<bool> rim(height_.size(), false);
    for (const std::uint32_t h : base_.source.borderEdges) {
      rim[startOf(h)] = true;
      rim[mesh_.triangles[h / 3][(h % 3 + 1) % 3]] = true;
    }
    for (const std::uint32_t v : contact_) {
      if (!rim[v]) {
        base_.source.vertices.push_back(v);
      }
    }
    contact_.clear();
  }

  const PartSurface& surface_;
  const geometry::TriangleMesh& mesh_;
  const JobContext& context_;
  std::vector<double> height_;
  std::vector<Piece> pieces_;
  std::vector<BaseLoop> loops_;
  std::vector<std::uint32_t> contact_;
  std::vector<std::size_t> floating_;  ///< closed pieces above the substrate
  PartBase base_;
};

}  // namespace

PartBase findBase(const PartSurface& surface,
                  const Substrate& substrate,
                  const JobContext& context) {
  if (surface.mesh.triangles.empty()) {
    throw Error(ErrorCode::JobFailed, "the part has no triangles", kPlace, "import another file");
  }
  return BaseFinder(surface, substrate, context).run();
}

std::vector<double> distanceFromBase(const PartSurface& surface,
                                     const PartBase& base,
                                     const JobContext& context) {
  const geometry::GeodesicSolver solver(surface.mesh, surface.halfEdges);
  std::vector<double> distance =
      solver.distance(base.source, std::numeric_limits<double>::infinity(), context);
  for (std::size_t v = 0; v < distance.size(); ++v) {
    if (!std::isfinite(distance[v])) {
      distance[v] = std::numeric_limits<double>::quiet_NaN();
    } else if (base.side[v] < 0) {
      distance[v] = -distance[v];
    }
  }
  return distance;
}

}  // namespace wcam::toolpath
