// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "facets.hpp"

#include "wcam/geometry/aabb_tree.hpp"
#include "wcam/geometry/segment_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wcam::radial {

namespace {

using geometry::Vec3;

/// Facets that dip below their corners by more than this part of a step are real flats: the layers
/// follow them.
constexpr double kDip = 0.25;
/// On a facet or an edge, in parts of the part's size: halving edges rounds.
constexpr double kOn = 1e-9;

/// The facets and border edges whose corners have one value.
class RoundFacets {
public:
  RoundFacets(const geometry::PartSurface& part,
              const std::function<double(const Vec3&)>& field,
              double step,
              double tolerance)
      : field_(field), step_(step), tolerance_(tolerance) {
    const geometry::TriangleMesh& mesh = part.mesh;
    std::vector<double> values;
    values.reserve(mesh.vertices.size());
    for (const Vec3& p : mesh.vertices) {
      values.push_back(field(p));
      lowest_ = std::min(lowest_, values.back());
    }
    const double lowest = lowest_;
    bool roundStart = false;
    facets_.vertices = mesh.vertices;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& c = mesh.triangles[t];
      const double high = std::max({values[c[0]], values[c[1]], values[c[2]]});
      const double low = std::min({values[c[0]], values[c[1]], values[c[2]]});
      const Vec3 centre = (mesh.vertices[c[0]] + mesh.vertices[c[1]] + mesh.vertices[c[2]]) / 3.0;
      if (high - low <= tolerance && isRound(centre, high)) {
        facets_.triangles.push_back(c);
        facetValues_.push_back(high);
        roundStart = roundStart || low <= lowest + tolerance;
      }
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = c[k];
        const std::uint32_t b = c[(k + 1) % 3];
        if (part.halfEdges.twin(3 * t + k) == geometry::HalfEdges::kNone &&
            std::abs(values[a] - values[b]) <= tolerance &&
            isRound(0.5 * (mesh.vertices[a] + mesh.vertices[b]), std::max(values[a], values[b]))) {
          edges_.push_back({mesh.vertices[a], mesh.vertices[b], std::max(values[a], values[b])});
          roundStart = roundStart || std::min(values[a], values[b]) <= lowest + tolerance;
        }
      }
    }
    // What lies beside a chord of the inner border is not before the start.
    lowest_ = roundStart ? lowest : -std::numeric_limits<double>::infinity();
    std::sort(edges_.begin(), edges_.end(),
              [](const Edge& a, const Edge& b) { return a.value < b.value; });
    buildEdges();
    on_ = kOn * std::max(1.0, mesh.bounds().diagonal());
  }

  [[nodiscard]] bool empty() const { return facets_.triangles.empty() && edges_.empty(); }

  /// Values at points of the part.
  [[nodiscard]] std::vector<double> at(const std::vector<Vec3>& points) const {
    const geometry::AabbTree tree(facets_);
    std::vector<double> values;
    values.reserve(points.size());
    for (const Vec3& p : points) {
      double value = field_(p);
      if (!facets_.triangles.empty()) {
        const auto hit = tree.closestPoint(p);
        if (hit && hit->distance <= on_) {
          value = std::max(value, facetValues_[hit->triangle]);
        }
      }
      value = std::max(value, edgeValue(p, value));
      values.push_back(std::max(value, lowest_));
    }
    return values;
  }

private:
  struct Edge {
    Vec3 a;
    Vec3 b;
    double value;
  };

  /// Edges of one value, such as one border.
  struct Ring {
    double value;
    geometry::SegmentTree tree;
  };

  [[nodiscard]] bool isRound(const Vec3& middle, double value) const {
    return value - field_(middle) <= kDip * step_;
  }

  void buildEdges() {
    for (const Edge& edge : edges_) {
      if (rings_.empty() || edge.value - rings_.back().value > tolerance_) {
        rings_.push_back({edge.value, {}});
      }
      rings_.back().tree.add(edge.a, edge.b);
    }
    for (Ring& ring : rings_) {
      ring.tree.build();
    }
  }

  [[nodiscard]] double edgeValue(const Vec3& p, double value) const {
    // Chords dip by a part of the step at most: only rings just above may hold the point.
    const auto first = std::lower_bound(rings_.begin(), rings_.end(), value - tolerance_,
                                        [](const Ring& ring, double v) { return ring.value < v; });
    for (auto ring = first; ring != rings_.end() && ring->value <= value + kDip * step_; ++ring) {
      if (ring->tree.distance(p, 2.0 * on_) <= on_) {
        return ring->value;
      }
    }
    return value;
  }

  const std::function<double(const Vec3&)>& field_;
  double step_;
  double tolerance_;
  double on_ = 0.0;
  double lowest_ = std::numeric_limits<double>::infinity();
  geometry::TriangleMesh facets_;
  std::vector<double> facetValues_;
  std::vector<Edge> edges_;
  std::vector<Ring> rings_;
};

}  // namespace

std::vector<double> valuesOnFacets(const geometry::PartSurface& given,
                                   const geometry::PartSurface& refined,
                                   const std::function<double(const geometry::Vec3&)>& field,
                                   double step,
                                   double tolerance) {
  if (!given.exact()) {
    const RoundFacets round(given, field, step, tolerance);
    if (!round.empty()) {
      return round.at(refined.mesh.vertices);
    }
  }
  std::vector<double> values;
  values.reserve(refined.mesh.vertices.size());
  for (const Vec3& p : refined.mesh.vertices) {
    values.push_back(field(p));
  }
  return values;
}

}  // namespace wcam::radial
