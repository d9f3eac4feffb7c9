// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/geometry/geodesic.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wcam::geometry {

namespace {

constexpr std::uint32_t kNone = HalfEdges::kNone;
/// A weight below this part of a triangle counts as none: the point is on the edge.
constexpr double kOnEdge = 1e-9;

/// The way of steepest descent in one triangle: change of the corners' weights per mm.
struct Descent {
  std::array<double, 3> rate{};
  double slope = 0.0;  ///< decrease of the field per mm
};

/// Nothing where the field is flat or not defined, or the triangle has no area.
std::optional<Descent> descentIn(const TriangleMesh& mesh,
                                 const std::vector<double>& field,
                                 std::uint32_t t) {
  const auto& corners = mesh.triangles[t];
  const Vec3& origin = mesh.vertices[corners[0]];
  const Vec3 ab = mesh.vertices[corners[1]] - origin;
  const Vec3 ac = mesh.vertices[corners[2]] - origin;
  const Vec3 n = ab.cross(ac);
  const double square = n.squaredNorm();
  const double fb = field[corners[1]] - field[corners[0]];
  const double fc = field[corners[2]] - field[corners[0]];
  if (!(square > 0.0) || !std::isfinite(fb) || !std::isfinite(fc)) {
    return std::nullopt;
  }
  const Vec3 gradient = n.cross(Vec3(fc * ab - fb * ac)) / square;
  const double slope = gradient.norm();
  if (!(slope > 0.0)) {
    return std::nullopt;
  }
  const Vec3 way = -gradient / slope;
  Descent descent;
  descent.slope = slope;
  // The gradients of the weights are the edges turned by 90°.
  descent.rate[1] = n.dot(way.cross(ac)) / square;
  descent.rate[2] = n.dot(ab.cross(way)) / square;
  descent.rate[0] = -descent.rate[1] - descent.rate[2];
  return descent;
}

class Walker {
public:
  Walker(const TriangleMesh& mesh, const HalfEdges& halfEdges, const std::vector<double>& field)
      : mesh_(mesh), halfEdges_(halfEdges), field_(field) {}

  std::vector<MeshPoint> run(const MeshPoint& from) {
    path_.push_back(from);
    // The field decreases on the way, so no triangle is crossed twice; the bound is for rounding.
    const std::size_t most = 4 * mesh_.triangles.size() + 16;
    while (path_.size() < most && step()) {
    }
    return std::move(path_);
  }

private:
  [[nodiscard]] std::uint32_t cornerVertex(std::uint32_t t, std::size_t c) const {
    return mesh_.triangles[t][c % 3];
  }

  /// The corner on which a point lies, if it does.
  [[nodiscard]] static std::optional<std::uint32_t> cornerOf(const MeshPoint& point) {
    for (std::uint32_t c = 0; c < 3; ++c) {
      if (point.weights[c] >= 1.0 - kOnEdge) {
        return c;
      }
    }
    return std::nullopt;
  }

  /// The edge (from corner c to c+1) on which a point lies, if it does.
  [[nodiscard]] static std::optional<std::uint32_t> edgeOf(const MeshPoint& point) {
    for (std::uint32_t c = 0; c < 3; ++c) {
      if (point.weights[(c + 2) % 3] <= kOnEdge) {
        return c;
      }
    }
    return std::nullopt;
  }

  /// @return whether the path goes on
  bool step() {
    const MeshPoint at = path_.back();
    if (const auto corner = cornerOf(at)) {
      return leaveVertex(3 * at.triangle + *corner);
    }
    if (const auto edge = edgeOf(at)) {
      return leaveEdge(3 * at.triangle + *edge, at.weights[(*edge + 1) % 3]);
    }
    const auto descent = descentIn(mesh_, field_, at.triangle);
    return descent && cross(at, *descent);
  }

  /// Goes through the triangle of a point to its edge.
  bool cross(const MeshPoint& at, const Descent& descent) {
    double length = std::numeric_limits<double>::infinity();
    std::size_t out = 3;
    for (std::size_t c = 0; c < 3; ++c) {
      if (descent.rate[c] < 0.0) {
        const double reach = std::max(0.0, at.weights[c]) / -descent.rate[c];
        if (reach < length) {
          length = reach;
          out = c;
        }
      }
    }
    if (out == 3) {
      return false;
    }
    MeshPoint next = at;
    double sum = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      next.weights[c] = c == out ? 0.0 : std::max(0.0, at.weights[c] + length * descent.rate[c]);
      sum += next.weights[c];
    }
    for (double& w : next.weights) {
      w = w / sum <= kOnEdge ? 0.0 : w / sum;
    }
    path_.push_back(next);
    return true;
  }

  /// From a point on the edge: into the side that descends steeper, else along the edge.
  bool leaveEdge(std::uint32_t h, double fraction) {
    const std::uint32_t twin = halfEdges_.twin(h);
    std::optional<Descent> best;
    std::uint32_t side = kNone;
    for (const std::uint32_t k : {h, twin}) {
      if (k == kNone) {
        continue;
      }
      const auto descent = descentIn(mesh_, field_, k / 3);
      if (descent && descent->rate[(k % 3 + 2) % 3] > 0.0 &&
          (!best || descent->slope > best->slope)) {
        best = descent;
        side = k;
      }
    }
    if (best) {
      const double w = side == h ? fraction : 1.0 - fraction;
      MeshPoint at{side / 3, {0.0, 0.0, 0.0}};
      at.weights[side % 3] = 1.0 - w;
      at.weights[(side % 3 + 1) % 3] = w;
      return cross(at, *best);
    }
    const double start = field_[cornerVertex(h / 3, h % 3)];
    const double end = field_[cornerVertex(h / 3, h % 3 + 1)];
    const double here = (1.0 - fraction) * start + fraction * end;
    const std::uint32_t corner = start < end ? h % 3 : (h % 3 + 1) % 3;
    if (!(std::min(start, end) < here)) {
      return false;
    }
    MeshPoint next{h / 3, {0.0, 0.0, 0.0}};
    next.weights[corner] = 1.0;
    path_.push_back(next);
    return true;
  }

  /// From a vertex: the steepest way in the triangles and along the edges around it.
  /// @param start a half-edge that starts at the vertex
  bool leaveVertex(std::uint32_t start) {
    steepest_ = 0.0;
    const auto next = [](std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; };
    const auto previous = [](std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; };
    std::uint32_t h = start;
    do {
      look(h);
      h = halfEdges_.twin(previous(h));
    } while (h != kNone && h != start);
    if (h == kNone) {
      for (h = halfEdges_.twin(start); h != kNone; h = halfEdges_.twin(h)) {
        h = next(h);
        look(h);
      }
    }
    if (!(steepest_ > 0.0)) {
      return false;
    }
    if (bestDescent_) {
      MeshPoint at{bestHalfEdge_ / 3, {0.0, 0.0, 0.0}};
      at.weights[bestHalfEdge_ % 3] = 1.0;
      return cross(at, *bestDescent_);
    }
    MeshPoint at{bestHalfEdge_ / 3, {0.0, 0.0, 0.0}};
    at.weights[bestCorner_] = 1.0;
    path_.push_back(at);
    return true;
  }

  /// Looks at the triangle of a half-edge that starts at the vertex.
  void look(std::uint32_t h) {
    const std::uint32_t t = h / 3;
    const std::uint32_t c = h % 3;
    const Vec3& p = mesh_.vertices[cornerVertex(t, c)];
    const double value = field_[cornerVertex(t, c)];
    for (const std::uint32_t k : {(c + 1) % 3, (c + 2) % 3}) {
      const std::uint32_t v = cornerVertex(t, k);
      const double slope = (value - field_[v]) / (mesh_.vertices[v] - p).norm();
      if (field_[v] < value && slope > steepest_) {
        steepest_ = slope;
        bestDescent_.reset();
        bestHalfEdge_ = h;
        bestCorner_ = k;
      }
    }
    const auto descent = descentIn(mesh_, field_, t);
    if (descent && descent->rate[(c + 1) % 3] > 0.0 && descent->rate[(c + 2) % 3] > 0.0 &&
        descent->slope > steepest_) {
      steepest_ = descent->slope;
      bestDescent_ = descent;
      bestHalfEdge_ = h;
    }
  }

  const TriangleMesh& mesh_;
  const HalfEdges& halfEdges_;
  const std::vector<double>& field_;
  std::vector<MeshPoint> path_;
  double steepest_ = 0.0;
  std::optional<Descent> bestDescent_;
  std::uint32_t bestHalfEdge_ = 0;
  std::uint32_t bestCorner_ = 0;
};

}  // namespace

std::vector<MeshPoint> descend(const TriangleMesh& mesh,
                               const HalfEdges& halfEdges,
                               const std::vector<double>& field,
                               const MeshPoint& from) {
  WCAM_ASSERT(field.size() == mesh.vertices.size());
  WCAM_ASSERT(from.triangle < mesh.triangles.size());
  return Walker(mesh, halfEdges, field).run(from);
}

}  // namespace wcam::geometry
