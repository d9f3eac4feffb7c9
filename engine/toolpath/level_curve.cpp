// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "level_curve.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {

using geometry::LevelContour;
using geometry::SurfacePoint;
using geometry::Vec2;

namespace {

/// Newton is quadratic from a start within a mesh chord; more steps mean that it does not converge.
constexpr int kNewtonSteps = 16;
/// A refined node may move by a few mesh edges at most; beyond, it went to another part of the
/// level set.
constexpr double kReachInEdges = 3.0;
/// Residual in parts of the part's size: rounding of a surface evaluation is some 1e-15 of it.
constexpr double kResidual = 1e-14;
/// Facets of a mesh that meet at a smaller angle are taken as one smooth surface.
const double kSmoothFacetCosine = std::cos(0.7);

struct Metric {
  double uu, uv, vv;

  explicit Metric(const SurfacePoint& s)
      : uu(s.du.squaredNorm()), uv(s.du.dot(s.dv)), vv(s.dv.squaredNorm()) {}

  /// Solves M x = g; nothing when the derivatives are parallel (a pole).
  [[nodiscard]] std::optional<Vec2> solve(const Vec2& g) const {
    const double det = uu * vv - uv * uv;
    constexpr double kParallel = 1e-14;
    if (det <= kParallel * uu * vv || det <= 0.0) {
      if (uu <= 0.0 && vv <= 0.0) {
        return std::nullopt;
      }
      return uu >= vv ? Vec2(g[0] / uu, 0.0) : Vec2(0.0, g[1] / vv);
    }
    return Vec2((vv * g[0] - uv * g[1]) / det, (uu * g[1] - uv * g[0]) / det);
  }
};

}  // namespace

LevelCurve::LevelCurve(const geometry::PartSurface& part,
                       geometry::BrepEvaluator* evaluator,
                       const LayerField* field,
                       std::size_t level,
                       double size,
                       double flat)
    : part_(&part),
      evaluator_(evaluator),
      field_(field),
      level_(level),
      residualTolerance_(kResidual * std::max(1.0, size)),
      flat_(flat) {}

Vec3 LevelCurve::meshNormal(std::uint32_t triangle) const {
  return part_->mesh.normal(triangle);
}

LevelCurve::FacePoint LevelCurve::faceAt(std::int32_t face, const Vec2& uv) const {
  return {uv, evaluator_->surface(face, uv)};
}

ContourPoint LevelCurve::contourPoint(std::int32_t face, const FacePoint& at) const {
  return {at.surface.p, evaluator_->normal(face, at.uv, at.surface)};
}

std::optional<LevelCurve::FacePoint> LevelCurve::newtonToLevel(std::int32_t face,
                                                               Vec2 uv,
                                                               double reach) const {
  if (field_ == nullptr) {
    return faceAt(face, uv);
  }
  Vec3 start = Vec3::Zero();
  double previous = std::numeric_limits<double>::infinity();
  FacePoint best;
  for (int i = 0; i < kNewtonSteps; ++i) {
    const FacePoint at = faceAt(face, uv);
    const SurfacePoint& s = at.surface;
    start = i == 0 ? s.p : start;
    const double f = field_->residual(s.p, level_);
    if (!std::isfinite(f) || (s.p - start).norm() > reach) {
      return std::nullopt;
    }
    if (std::abs(f) < previous) {
      previous = std::abs(f);
      best = at;
    }
    if (std::abs(f) <= residualTolerance_) {
      return at;
    }
    const Vec3 gradient = field_->gradient(s.p, level_);
    const Vec2 g(gradient.dot(s.du), gradient.dot(s.dv));
    const auto direction = Metric(s).solve(g);
    // Shortest step in space that cancels the residual.
    const double slope = direction ? g.dot(*direction) : 0.0;
    if (!(slope > 0.0)) {
      break;
    }
    uv -= (f / slope) * *direction;
  }
  // Rounding can keep the residual a little above the tolerance; a true failure is far above.
  constexpr double kAccepted = 1e3;
  return previous <= kAccepted * residualTolerance_ ? std::optional<FacePoint>(best) : std::nullopt;
}

LevelCurve::FacePoint LevelCurve::projectToSurface(std::int32_t face,
                                                   const Vec2& uv,
                                                   const Vec3& p) const {
  FacePoint at = faceAt(face, uv);
  for (int i = 0; i < kNewtonSteps; ++i) {
    const Vec3 error = p - at.surface.p;
    if (error.norm() <= residualTolerance_) {
      break;
    }
    const auto step =
        Metric(at.surface).solve(Vec2(error.dot(at.surface.du), error.dot(at.surface.dv)));
    if (!step || !step->allFinite()) {
      break;
    }
    const FacePoint next = faceAt(face, at.uv + *step);
    if ((next.surface.p - p).norm() >= error.norm()) {
      break;
    }
    at = next;
  }
  return at;
}

std::optional<Vec3> LevelCurve::solveOnEdge(std::int32_t edge,
                                            double t0,
                                            double t1,
                                            double t) const {
  if (field_ == nullptr) {
    return evaluator_->curve(edge, t).p;
  }
  double f0 = field_->residual(evaluator_->curve(edge, t0).p, level_);
  const double f1 = field_->residual(evaluator_->curve(edge, t1).p, level_);
  if (!std::isfinite(f0) || !std::isfinite(f1)) {
    return std::nullopt;
  }
  const bool bracketed = (f0 < 0.0) != (f1 < 0.0);
  double low = t0;
  double high = t1;
  for (int i = 0; i < 60; ++i) {
    const geometry::CurvePoint c = evaluator_->curve(edge, t);
    const double f = field_->residual(c.p, level_);
    if (std::abs(f) <= residualTolerance_) {
      return c.p;
    }
    if (bracketed) {
      // Keep the root between low and high; halve when Newton would leave.
      if ((f < 0.0) == (f0 < 0.0)) {
        low = t;
      } else {
        high = t;
      }
    }
    const double slope = field_->gradient(c.p, level_).dot(c.d1);
    double next = slope != 0.0 ? t - f / slope : 0.5 * (low + high);
    if (bracketed && !(std::min(low, high) < next && next < std::max(low, high))) {
      next = 0.5 * (low + high);
    }
    if (!bracketed && !(std::min(t0, t1) <= next && next <= std::max(t0, t1))) {
      next = std::clamp(next, std::min(t0, t1), std::max(t0, t1));
    }
    if (next == t) {
      constexpr double kAccepted = 1e3;
      return std::abs(f) <= kAccepted * residualTolerance_ ? std::optional<Vec3>(c.p)
                                                           : std::nullopt;
    }
    t = next;
  }
  return evaluator_->curve(edge, t).p;
}

std::optional<LevelCurve::Node> LevelCurve::refinedNode(std::uint32_t halfEdge,
                                                        double fraction) const {
  const geometry::BrepBinding& binding = part_->binding;
  const std::uint32_t triangle = halfEdge / 3;
  const std::uint32_t corner = halfEdge % 3;
  Node node;
  if (binding.edge[halfEdge] >= 0) {
    const auto& t = binding.edgeParam[halfEdge];
    const auto p = solveOnEdge(binding.edge[halfEdge], t[0], t[1], t[0] + fraction * (t[1] - t[0]));
    if (!p) {
      return std::nullopt;
    }
    node.point.p = *p;
    return node;
  }
  const auto& vertices = part_->mesh.triangles[triangle];
  const double edgeLength =
      (part_->mesh.vertices[vertices[(corner + 1) % 3]] - part_->mesh.vertices[vertices[corner]])
          .norm();
  const Vec2& a = binding.uv[triangle][corner];
  const Vec2& b = binding.uv[triangle][(corner + 1) % 3];
  const std::int32_t face = binding.face[triangle];
  const auto at = newtonToLevel(face, a + fraction * (b - a), kReachInEdges * edgeLength);
  if (!at) {
    return std::nullopt;
  }
  node.point = contourPoint(face, *at);
  node.face = face;
  node.uv = at->uv;
  return node;
}

Vec2 LevelCurve::cornerUv(std::uint32_t triangle, std::uint32_t halfEdge, double fraction) const {
  const auto& tri = part_->mesh.triangles[triangle];
  const auto& other = part_->mesh.triangles[halfEdge / 3];
  const std::uint32_t from = other[halfEdge % 3];
  const std::uint32_t to = other[(halfEdge % 3 + 1) % 3];
  const auto cornerOf = [&tri](std::uint32_t vertex) {
    return std::find(tri.begin(), tri.end(), vertex) - tri.begin();
  };
  const auto i = static_cast<std::size_t>(cornerOf(from));
  const auto j = static_cast<std::size_t>(cornerOf(to));
  const auto& uv = part_->binding.uv[triangle];
  if (i < 3 && j < 3) {
    return uv[i] + fraction * (uv[j] - uv[i]);
  }
  // The node is a vertex that the triangle shares, reached over another edge.
  if (i < 3 || j < 3) {
    return uv[i < 3 ? i : j];
  }
  return (uv[0] + uv[1] + uv[2]) / 3.0;
}

bool LevelCurve::hasEdge(std::uint32_t triangle, std::uint32_t halfEdge) const {
  const std::uint32_t twin = part_->halfEdges.twin(halfEdge);
  return halfEdge / 3 == triangle || (twin != geometry::HalfEdges::kNone && twin / 3 == triangle);
}

void LevelCurve::addSegment(const LevelContour& contour,
                            const std::vector<Node>& nodes,
                            std::size_t from,
                            std::size_t to) {
  CurveSegment segment;
  segment.triangle = contour.halfEdges[from] / 3;
  segment.a.p = nodes[from].point.p;
  segment.b.p = nodes[to].point.p;
  if (evaluator_ != nullptr) {
    const std::int32_t face = part_->binding.face[segment.triangle];
    const auto place = [&](std::size_t index, Vec2& uv, Vec3& n) {
      const Node& node = nodes[index];
      // A vertex of a seam has other parameters in the triangles beyond the seam.
      if (node.face == face && hasEdge(segment.triangle, contour.halfEdges[index])) {
        uv = node.uv;
        n = node.point.n;
        return;
      }
      const FacePoint at = projectToSurface(
          face, cornerUv(segment.triangle, contour.halfEdges[index], contour.fractions[index]),
          node.point.p);
      uv = at.uv;
      n = evaluator_->normal(face, at.uv, at.surface);
    };
    place(from, segment.uvA, segment.a.n);
    place(to, segment.uvB, segment.b.n);
  } else {
    segment.a.n = segment.b.n = meshNormal(segment.triangle);
  }
  segments_.push_back(segment);
}

Vec3 LevelCurve::onMeshEdge(std::uint32_t halfEdge, const Vec3& start) const {
  const auto f = [&](const Vec3& p) { return field_->residual(p, level_); };
  if (std::abs(f(start)) <= residualTolerance_) {
    return start;
  }
  const auto& triangle = part_->mesh.triangles[halfEdge / 3];
  Vec3 low = part_->mesh.vertices[triangle[halfEdge % 3]];
  Vec3 high = part_->mesh.vertices[triangle[(halfEdge % 3 + 1) % 3]];
  double fLow = f(low);
  double fHigh = f(high);
  if (!std::isfinite(fLow) || !std::isfinite(fHigh) || (fLow < 0.0) == (fHigh < 0.0)) {
    return start;
  }
  // False position; halving an end's value when it stays (Illinois) keeps both ends moving.
  Vec3 at = start;
  int side = 0;
  for (int i = 0; i < 60; ++i) {
    at = low + fLow / (fLow - fHigh) * (high - low);
    const double value = f(at);
    if (std::abs(value) <= residualTolerance_) {
      break;
    }
    if ((value < 0.0) == (fLow < 0.0)) {
      low = at;
      fLow = value;
      fHigh *= side == -1 ? 0.5 : 1.0;
      side = -1;
    } else {
      high = at;
      fHigh = value;
      fLow *= side == 1 ? 0.5 : 1.0;
      side = 1;
    }
  }
  return at;
}

bool LevelCurve::settled(const Vec3& vertex, double fraction) const {
  // The tracing takes vertices that far from the level (level_flats.cpp).
  constexpr double kReach = 4.0;
  return field_ != nullptr && (fraction == 0.0 || fraction == 1.0) &&
         std::abs(field_->residual(vertex, level_)) <= kReach * flat_;
}

std::size_t LevelCurve::assign(const LevelContour& contour) {
  closed_ = contour.closed;
  segments_.clear();
  std::size_t failures = 0;
  std::vector<Node> nodes(contour.points.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes[i].point.p = contour.points[i];
    if (evaluator_ != nullptr) {
      if (const auto exact = refinedNode(contour.halfEdges[i], contour.fractions[i])) {
        nodes[i] = *exact;
      } else if (!settled(contour.points[i], contour.fractions[i])) {
        ++failures;
      }
    } else if (field_ != nullptr && !settled(contour.points[i], contour.fractions[i])) {
      nodes[i].point.p = onMeshEdge(contour.halfEdges[i], contour.points[i]);
    }
  }
  const std::size_t count = nodes.size();
  const std::size_t pieces = contour.closed ? count : (count > 0 ? count - 1 : 0);
  segments_.reserve(pieces);
  for (std::size_t i = 0; i < pieces; ++i) {
    addSegment(contour, nodes, i, (i + 1) % count);
  }
  if (evaluator_ == nullptr) {
    smoothMeshNormals();
  }
  return failures;
}

void LevelCurve::smoothMeshNormals() {
  const std::size_t n = segments_.size();
  std::vector<Vec3> facet;
  facet.reserve(n);
  for (const CurveSegment& segment : segments_) {
    facet.push_back(segment.a.n);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = i + 1 < n ? i + 1 : 0;
    if (next == 0 && !closed_) {
      break;
    }
    const Vec3 sum = facet[i] + facet[next];
    if (facet[i].dot(facet[next]) > kSmoothFacetCosine && sum.norm() > 0.0) {
      segments_[i].b.n = segments_[next].a.n = sum.normalized();
    }
  }
}

double LevelCurve::length() const {
  double length = 0.0;
  for (const CurveSegment& segment : segments_) {
    length += (segment.b.p - segment.a.p).norm();
  }
  return length;
}

ContourPoint LevelCurve::at(std::size_t index, double w) const {
  const CurveSegment& segment = segments_[index];
  if (w <= 0.0) {
    return segment.a;
  }
  if (w >= 1.0) {
    return segment.b;
  }
  if (evaluator_ != nullptr) {
    const std::int32_t face = part_->binding.face[segment.triangle];
    const double chord = (segment.b.p - segment.a.p).norm();
    if (const auto at = newtonToLevel(face, segment.uvA + w * (segment.uvB - segment.uvA),
                                      kReachInEdges * chord)) {
      return contourPoint(face, *at);
    }
  }
  const Vec3 n = (1.0 - w) * segment.a.n + w * segment.b.n;
  return {segment.a.p + w * (segment.b.p - segment.a.p),
          n.norm() > 0.0 ? Vec3(n.normalized()) : segment.a.n};
}

Vec3 LevelCurve::tangent(std::size_t index, double w) const {
  const CurveSegment& segment = segments_[index];
  const Vec3 chord = segment.b.p - segment.a.p;
  if (evaluator_ != nullptr && field_ != nullptr) {
    const ContourPoint& end = w < 0.5 ? segment.a : segment.b;
    const Vec3 t = end.n.cross(field_->gradient(end.p, level_));
    if (t.norm() > 1e-9) {
      return t.normalized();
    }
  }
  return chord.norm() > 0.0 ? Vec3(chord.normalized()) : Vec3::Zero();
}

std::vector<LevelCurve> LevelCurve::keepAbove(const Substrate& substrate, double tolerance) const {
  const std::size_t n = segments_.size();
  const auto below = [&](const Vec3& p) { return substrate.heightAbove(p) < -tolerance; };
  std::vector<bool> nodeBelow(n);
  bool any = false;
  bool all = true;
  for (std::size_t i = 0; i < n; ++i) {
    nodeBelow[i] = below(segments_[i].a.p);
    any = any || nodeBelow[i];
    all = all && nodeBelow[i];
  }
  const bool lastBelow = n > 0 && below(segments_.back().b.p);
  if (!any && !lastBelow) {
    return {*this};
  }
  std::vector<LevelCurve> kept;
  if (all && lastBelow) {
    return kept;
  }
  // A closed curve starts at a segment that enters from below, so that no kept piece wraps around.
  std::size_t first = 0;
  if (closed_) {
    while (!(nodeBelow[first] && !nodeBelow[(first + 1) % n]) && first + 1 < n) {
      ++first;
    }
  }
  LevelCurve piece(*this);
  piece.closed_ = false;
  piece.segments_.clear();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (first + k) % n;
    CurveSegment segment = segments_[i];
    const bool startBelow = nodeBelow[i];
    const bool endBelow = i + 1 < n ? nodeBelow[i + 1] : (closed_ ? nodeBelow[0] : lastBelow);
    if (startBelow != endBelow) {
      // The cut lies on the substrate, or on the end that counts as on it.
      const double kept = substrate.heightAbove(startBelow ? segment.b.p : segment.a.p);
      const double floor = std::min(0.0, kept);
      double low = 0.0;
      double high = 1.0;
      for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        ((substrate.heightAbove(at(i, middle).p) < floor) == startBelow ? low : high) = middle;
      }
      const double w = startBelow ? high : low;
      const ContourPoint cut = at(i, w);
      Vec2 uv = segment.uvA + w * (segment.uvB - segment.uvA);
      if (evaluator_ != nullptr) {
        uv = projectToSurface(part_->binding.face[segment.triangle], uv, cut.p).uv;
      }
      (startBelow ? segment.a : segment.b) = cut;
      (startBelow ? segment.uvA : segment.uvB) = uv;
    }
    if (!startBelow || !endBelow) {
      piece.segments_.push_back(segment);
    }
    if (endBelow && !piece.segments_.empty()) {
      kept.push_back(piece);
      piece.segments_.clear();
    }
  }
  if (!piece.segments_.empty()) {
    kept.push_back(piece);
  }
  return kept;
}

}  // namespace wcam::toolpath
