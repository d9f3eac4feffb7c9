// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "intrinsic_mesh.hpp"

#include "wcam/base/quantity.hpp"

#include <algorithm>
#include <limits>

namespace wcam::geometry {

namespace {

constexpr std::uint32_t kNone = HalfEdges::kNone;
/// Edges whose opposite angles exceed 180° by less than some 3° do no harm; good meshes are left
/// alone.
constexpr double kSliverSine = 0.05;
/// A flip gains at least this, so that rounding makes no cycle.
constexpr double kDelaunaySlack = 1e-9;
/// A vertex with a greater angle defect (rad) is a corner of a polyhedron, not a point of a smooth
/// surface.
constexpr double kCornerDefect = 0.2;

FlatTriangle flatten(const std::array<std::uint32_t, 3>& corner,
                     const std::array<double, 3>& square,
                     double twiceArea) {
  return {corner, square, std::max(0.0, twiceArea)};
}

/// Angle opposite to edge c as {cross, dot} of the edges there, not normalised.
std::array<double, 2> oppositeAngle(const FlatTriangle& t, std::uint32_t c) {
  return {t.twiceArea, t.dotAt((c + 2) % 3)};
}

/// Angle of the vector (x, y), y ≥ 0, rad: within 1e-10, several times as fast as std::atan2, and
/// the same with every mathematical library.
double angleOf(double y, double x) {
  constexpr double kTanEighth = 0.41421356237309503;  // of a half right angle's half
  const double flat = std::abs(x);
  const double least = std::min(flat, y);
  const double most = std::max(flat, y);
  const bool steep = least > kTanEighth * most;
  const double numerator = steep ? least - most : least;
  const double denominator = steep ? least + most : most;
  const double t = denominator > 0.0 ? numerator / denominator : 0.0;
  const double z = t * t;
  // The arc tangent's series up to t^21, which leaves 7e-11 at tan(π/8).
  double sum = 0.0;
  for (int k = 10; k >= 0; --k) {
    sum = (k % 2 == 0 ? 1.0 : -1.0) / (2 * k + 1) + z * sum;
  }
  const double first = t * sum + (steep ? 0.25 * kPi : 0.0);
  const double quarter = y > flat ? 0.5 * kPi - first : first;
  return x < 0.0 ? kPi - quarter : quarter;
}

/// Sine of the sum of two angles given by their products; the sum exceeds 180° where it is
/// negative.
double sineOfSum(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  const double scale = std::hypot(a[0], a[1]) * std::hypot(b[0], b[1]);
  return scale > 0.0 ? (a[0] * b[1] + a[1] * b[0]) / scale : 0.0;
}

/// Flips intrinsic edges until all are Delaunay.
class IntrinsicFlipper {
public:
  IntrinsicFlipper(std::vector<FlatTriangle>& triangles, const HalfEdges& halfEdges)
      : triangles_(triangles), twin_(3 * triangles.size()), queued_(3 * triangles.size(), 0) {
    for (std::uint32_t h = 0; h < twin_.size(); ++h) {
      twin_[h] = halfEdges.twin(h);
    }
  }

  std::size_t run() {
    std::vector<std::uint32_t> stack;
    for (auto h = static_cast<std::uint32_t>(twin_.size()); h-- > 0;) {
      push(stack, h);
    }
    // Each flip raises the least angles; the bound is for rounding only.
    const std::size_t most = 64 * triangles_.size();
    std::size_t flips = 0;
    while (!stack.empty() && flips < most) {
      const std::uint32_t h = stack.back();
      stack.pop_back();
      queued_[h] = 0;
      if (wantsFlip(h) && flip(h)) {
        ++flips;
        for (const std::uint32_t t : {lastA_, lastB_}) {
          for (std::uint32_t c = 0; c < 3; ++c) {
            push(stack, 3 * t + c);
          }
        }
      }
    }
    return flips;
  }

private:
  void push(std::vector<std::uint32_t>& stack, std::uint32_t h) {
    if (twin_[h] == kNone) {
      return;
    }
    const std::uint32_t key = std::min(h, twin_[h]);
    if (queued_[key] == 0) {
      queued_[key] = 1;
      stack.push_back(key);
    }
  }

  [[nodiscard]] bool wantsFlip(std::uint32_t h) const {
    const std::uint32_t other = twin_[h];
    return other != kNone && other / 3 != h / 3 &&
           sineOfSum(oppositeAngle(triangles_[h / 3], h % 3),
                     oppositeAngle(triangles_[other / 3], other % 3)) < -kDelaunaySlack;
  }

  bool flip(std::uint32_t h) {
    const std::uint32_t other = twin_[h];
    const std::uint32_t a = h / 3;
    const std::uint32_t b = other / 3;
    const std::uint32_t ca = h % 3;
    const std::uint32_t cb = other % 3;
    const FlatTriangle& ta = triangles_[a];
    const FlatTriangle& tb = triangles_[b];
    const double edge = std::sqrt(ta.square[ca]);
    const double vp = ta.square[(ca + 1) % 3];
    const double pu = ta.square[(ca + 2) % 3];
    const double uq = tb.square[(cb + 1) % 3];
    const double qv = tb.square[(cb + 2) % 3];
    if (!(edge > 0.0)) {
      return false;
    }
    // u at the origin, v on the x axis, p above, q below.
    const double px = ta.dotAt(ca) / edge;
    const double py = ta.twiceArea / edge;
    const double qx = tb.dotAt((cb + 1) % 3) / edge;
    const double qy = -tb.twiceArea / edge;
    // The new edge must run inside the two triangles.
    const double crossing = qx * py - px * qy;
    if (!(crossing > 0.0 && crossing < edge * (py - qy))) {
      return false;
    }
    const double pq = (px - qx) * (px - qx) + (py - qy) * (py - qy);
    const std::uint32_t u = triangles_[a].corner[ca];
    const std::uint32_t v = triangles_[a].corner[(ca + 1) % 3];
    const std::uint32_t p = triangles_[a].corner[(ca + 2) % 3];
    const std::uint32_t q = triangles_[b].corner[(cb + 2) % 3];
    const std::array<std::uint32_t, 4> outer = {
        twin_[3 * b + (cb + 1) % 3], twin_[3 * a + (ca + 2) % 3], twin_[3 * b + (cb + 2) % 3],
        twin_[3 * a + (ca + 1) % 3]};
    const std::array<std::uint32_t, 4> was = {3 * b + (cb + 1) % 3, 3 * a + (ca + 2) % 3,
                                              3 * b + (cb + 2) % 3, 3 * a + (ca + 1) % 3};
    const std::array<std::uint32_t, 4> now = {3 * a, 3 * a + 2, 3 * b, 3 * b + 1};
    triangles_[a] = flatten({u, q, p}, {uq, pq, pu}, crossing);
    triangles_[b] = flatten({q, v, p}, {qv, vp, pq}, edge * (py - qy) - crossing);
    for (std::size_t i = 0; i < 4; ++i) {
      // Two sides of the pair may be twins of each other.
      std::uint32_t twin = outer[i];
      for (std::size_t k = 0; k < 4; ++k) {
        if (outer[i] == was[k]) {
          twin = now[k];
        }
      }
      twin_[now[i]] = twin;
      if (twin != kNone) {
        twin_[twin] = now[i];
      }
    }
    twin_[3 * a + 1] = 3 * b + 2;
    twin_[3 * b + 2] = 3 * a + 1;
    lastA_ = a;
    lastB_ = b;
    return true;
  }

  std::vector<FlatTriangle>& triangles_;
  std::vector<std::uint32_t> twin_;
  std::vector<std::uint8_t> queued_;
  std::uint32_t lastA_ = 0;
  std::uint32_t lastB_ = 0;
};

}  // namespace

IntrinsicMesh::IntrinsicMesh(const TriangleMesh& mesh, const HalfEdges& halfEdges) {
  findCurvature(layFlat(mesh), halfEdges, mesh);
  flipSlivers(halfEdges);
  collectCorners(mesh.vertices.size());
}

std::vector<IntrinsicMesh::Cell> IntrinsicMesh::layFlat(const TriangleMesh& mesh) {
  std::vector<Cell> cells(mesh.vertices.size());
  triangles_.reserve(mesh.triangles.size());
  double sum = 0.0;
  for (const auto& corner : mesh.triangles) {
    const Vec3& p = mesh.vertices[corner[0]];
    const Vec3 a = mesh.vertices[corner[1]] - p;
    const Vec3 b = mesh.vertices[corner[2]] - p;
    const FlatTriangle t{
        corner, {a.squaredNorm(), (b - a).squaredNorm(), b.squaredNorm()}, a.cross(b).norm()};
    triangles_.push_back(t);
    sum += t.square[0] + t.square[1] + t.square[2];
    const double first = angleOf(t.twiceArea, t.dotAt(0));
    const double second = angleOf(t.twiceArea, t.dotAt(1));
    const std::array<double, 3> angle = {first, second, kPi - first - second};
    for (std::size_t c = 0; c < 3; ++c) {
      cells[corner[c]].angle += angle[c];
      cells[corner[c]].area += t.twiceArea / 6.0;
    }
  }
  typicalEdge_ =
      triangles_.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(3 * triangles_.size()));
  return cells;
}

void IntrinsicMesh::flipSlivers(const HalfEdges& halfEdges) {
  for (std::uint32_t h = 0; h < 3 * triangles_.size(); ++h) {
    const std::uint32_t other = halfEdges.twin(h);
    if (other == kNone || other < h) {
      continue;
    }
    const auto a = oppositeAngle(triangles_[h / 3], h % 3);
    const auto b = oppositeAngle(triangles_[other / 3], other % 3);
    const double sine = a[0] * b[1] + a[1] * b[0];
    // Nearly all edges end here.
    if (sine < 0.0 && sine * sine > kSliverSine * kSliverSine * (a[0] * a[0] + a[1] * a[1]) *
                                        (b[0] * b[0] + b[1] * b[1])) {
      flips_ = IntrinsicFlipper(triangles_, halfEdges).run();
      return;
    }
  }
}

void IntrinsicMesh::collectCorners(std::size_t vertices) {
  firstCorner_.assign(vertices + 1, 0);
  for (const FlatTriangle& t : triangles_) {
    for (const std::uint32_t v : t.corner) {
      ++firstCorner_[v + 1];
    }
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    firstCorner_[v + 1] += firstCorner_[v];
  }
  corners_.resize(3 * triangles_.size());
  std::vector<std::uint32_t> fill(firstCorner_.begin(), firstCorner_.end() - 1);
  double longest = 0.0;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const FlatTriangle& flat = triangles_[t];
    for (std::uint32_t c = 0; c < 3; ++c) {
      corners_[fill[flat.corner[c]]++] = 3 * t + c;
    }
    longest = std::max({longest, flat.square[0], flat.square[1], flat.square[2]});
  }
  longestEdge_ = std::sqrt(longest);
}

void IntrinsicMesh::findCurvature(const std::vector<Cell>& cells,
                                  const HalfEdges& halfEdges,
                                  const TriangleMesh& mesh) {
  curvature_.resize(cells.size());
  bends_.assign(cells.size(), 0);
  for (std::size_t v = 0; v < cells.size(); ++v) {
    const double defect = 2.0 * kPi - cells[v].angle;
    bends_[v] = defect < -kCornerDefect ? 1 : 0;
    curvature_[v] = std::abs(defect) < kCornerDefect && cells[v].area > 0.0
                        ? static_cast<float>(defect / cells[v].area)
                        : 0.0F;
  }
  if (halfEdges.borderEdgeCount() == 0) {
    return;
  }
  for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
    if (halfEdges.twin(h) == kNone) {
      for (const std::uint32_t v :
           {mesh.triangles[h / 3][h % 3], mesh.triangles[h / 3][(h % 3 + 1) % 3]}) {
        bends_[v] = 1;
        curvature_[v] = 0.0F;
      }
    }
  }
}

}  // namespace wcam::geometry
