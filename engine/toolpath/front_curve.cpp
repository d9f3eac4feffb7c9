// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "front_curve.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace wcam::toolpath {

using geometry::SurfacePoint;
using geometry::Vec2;

namespace {

/// Distances are met to this part of the part's size: a few roundings of a surface evaluation.
constexpr double kDistance = 1e-13;
/// Rounding can stop Newton a little above; a failure is far above.
constexpr double kAccepted = 1e4;
constexpr int kNewtonSteps = 16;
constexpr int kBisections = 60;
/// Facets of a mesh that meet at a smaller angle are one smooth surface.
const double kSmoothFacetCosine = std::cos(0.7);
/// Feet of one point that are farther apart than this, in steps, belong to two branches.
constexpr double kTwoFeet = 0.02;
/// A corner may lie this far outside the triangle whose sides the front crosses, in parts of it:
/// inside its own face the surface goes on smoothly.
constexpr double kCornerReach = 0.6;

Vec3 gradientOf(const Vec3& p, const FrontLine::Foot& foot) {
  return foot.distance > 0.0 ? Vec3((p - foot.point) / foot.distance) : Vec3(Vec3::Zero());
}

Vec2 onto(const SurfacePoint& s, const Vec3& g) {
  return {g.dot(s.du), g.dot(s.dv)};
}

}  // namespace

FrontCurve::FrontCurve(const SurfacePatch& patch, const FrontLine& below, double step, double size)
    : patch_(&patch), below_(&below), step_(step), tolerance_(kDistance * std::max(1.0, size)) {}

FrontCurve::Place FrontCurve::evaluate(const FrontPiece& piece, const Vec2& uv) const {
  Place place{uv, patch_->surface(piece.triangle, uv), {}};
  place.foot = below_->nearest(place.surface.p, piece.footA, piece.footB);
  return place;
}

FrontCurve::Place FrontCurve::toDistance(const FrontPiece& piece, const Vec2& start) const {
  Place at = evaluate(piece, start);
  Place best = at;
  Vec2 direction = Vec2::Zero();
  for (int i = 0; i < kNewtonSteps; ++i) {
    const double f = at.foot.distance - step_;
    if (std::abs(f) < std::abs(best.foot.distance - step_)) {
      best = at;
    }
    if (std::abs(f) <= tolerance_) {
      return best;
    }
    const Vec2 g = onto(at.surface, gradientOf(at.surface.p, at.foot));
    const auto way = solveMetric(at.surface, g);
    const double slope = way ? g.dot(*way) : 0.0;
    if (!(slope > 0.0)) {
      break;
    }
    direction = i == 0 ? Vec2(*way / slope) : direction;
    at = evaluate(piece, at.uv - (f / slope) * *way);
  }
  if (std::abs(best.foot.distance - step_) <= kAccepted * tolerance_ || direction.isZero()) {
    return best;
  }
  // Newton hops between two branches of the distance: bisect along the first direction instead.
  const double f0 = evaluate(piece, start).foot.distance - step_;
  double low = 0.0;
  double high = -f0;
  for (int i = 0; i < 4; ++i) {
    if ((evaluate(piece, start + high * direction).foot.distance > step_) != (f0 > 0.0)) {
      break;
    }
    high *= 2.0;
  }
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    at = evaluate(piece, start + middle * direction);
    ((at.foot.distance > step_) == (f0 > 0.0) ? low : high) = middle;
  }
  return std::abs(at.foot.distance - step_) < std::abs(best.foot.distance - step_) ? at : best;
}

ContourPoint FrontCurve::at(std::size_t index, double w) const {
  const FrontPiece& piece = list[index];
  if (w <= 0.0) {
    return piece.a;
  }
  if (w >= 1.0) {
    return piece.b;
  }
  const Vec2 start = piece.uvA + w * (piece.uvB - piece.uvA);
  Place place = toDistance(piece, start);
  if (patch_->exact()) {
    return {place.surface.p, patch_->normal(piece.triangle, place.uv, place.surface)};
  }
  // On a mesh the point stays in its triangle.
  const Vec3 from = patch_->weights(piece.triangle, start);
  const Vec3 to = patch_->weights(piece.triangle, place.uv);
  double share = 1.0;
  for (int c = 0; c < 3; ++c) {
    if (to[c] < 0.0) {
      share = std::min(share, std::max(0.0, from[c]) / (std::max(0.0, from[c]) - to[c]));
    }
  }
  const Vec3 n = (1.0 - w) * piece.a.n + w * piece.b.n;
  return {patch_->surface(piece.triangle, start + share * (place.uv - start)).p,
          n.norm() > 0.0 ? Vec3(n.normalized()) : piece.a.n};
}

Vec3 FrontCurve::tangent(std::size_t index, double w) const {
  const FrontPiece& piece = list[index];
  const ContourPoint& end = w < 0.5 ? piece.a : piece.b;
  const FrontLine::Foot foot = below_->nearest(end.p, w < 0.5 ? piece.footA : piece.footB);
  const Vec3 t = end.n.cross(gradientOf(end.p, foot));
  constexpr double kShort = 1e-9;
  if (patch_->exact() && t.norm() > kShort) {
    return t.normalized();
  }
  const Vec3 chord = piece.b.p - piece.a.p;
  return chord.norm() > 0.0 ? Vec3(chord.normalized()) : Vec3(Vec3::Zero());
}

std::optional<std::array<FrontPiece, 2>> FrontCurve::splitAtCorner(const FrontPiece& piece) const {
  if (piece.footA == piece.footB) {
    return std::nullopt;
  }
  // Two branches only when the walk from each end's foot does not come to the other's.
  const FrontLine::Foot other = below_->nearest(piece.a.p, piece.footB);
  if (other.distance <= step_ + kAccepted * tolerance_) {
    return std::nullopt;
  }
  Vec2 uv = 0.5 * (piece.uvA + piece.uvB);
  for (int i = 0; i < kNewtonSteps; ++i) {
    const SurfacePoint s = patch_->surface(piece.triangle, uv);
    const FrontLine::Foot a = below_->nearest(s.p, piece.footA);
    const FrontLine::Foot b = below_->nearest(s.p, piece.footB);
    const Vec2 residual(a.distance - step_, b.distance - step_);
    if (residual.norm() <= kAccepted * tolerance_) {
      const Vec3 weights = patch_->weights(piece.triangle, uv);
      if (weights.minCoeff() < (patch_->exact() ? -kCornerReach : 0.0)) {
        return std::nullopt;
      }
      const ContourPoint corner{s.p, patch_->normal(piece.triangle, uv, s)};
      return std::array<FrontPiece, 2>{
          FrontPiece{piece.triangle, piece.uvA, uv, piece.a, corner, piece.footA, a.segment},
          FrontPiece{piece.triangle, uv, piece.uvB, corner, piece.b, b.segment, piece.footB}};
    }
    Eigen::Matrix2d j;
    j.row(0) = onto(s, gradientOf(s.p, a)).transpose();
    j.row(1) = onto(s, gradientOf(s.p, b)).transpose();
    const Vec2 step = j.fullPivLu().solve(residual);
    if (!step.allFinite()) {
      break;
    }
    uv -= step;
  }
  return std::nullopt;
}

void FrontCurve::insertCorners() {
  std::vector<FrontPiece> pieces;
  pieces.reserve(list.size());
  for (const FrontPiece& piece : list) {
    if (const auto halves = splitAtCorner(piece)) {
      pieces.insert(pieces.end(), halves->begin(), halves->end());
    } else {
      pieces.push_back(piece);
    }
  }
  list = std::move(pieces);
  markCorners();
}

void FrontCurve::markCorners() {
  const std::size_t n = list.size();
  for (std::size_t i = 0; i + (ring ? 0 : 1) < n; ++i) {
    FrontPiece& before = list[i];
    FrontPiece& after = list[(i + 1) % n];
    const FrontLine::Foot a = below_->nearest(before.b.p, before.footA);
    const FrontLine::Foot b = below_->nearest(before.b.p, after.footB);
    const double accepted = step_ + kAccepted * tolerance_;
    if (a.distance <= accepted && b.distance <= accepted &&
        (a.point - b.point).norm() > kTwoFeet * step_) {
      before.footB = a.segment;
      after.footA = b.segment;
      corners.push_back(before.b.p);
    }
  }
}

void FrontCurve::smoothMeshNormals() {
  const std::size_t n = list.size();
  std::vector<Vec3> facet;
  for (const FrontPiece& piece : list) {
    facet.push_back(piece.a.n);
  }
  for (std::size_t i = 0; i + (ring ? 0 : 1) < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const Vec3 sum = facet[i] + facet[next];
    if (facet[i].dot(facet[next]) > kSmoothFacetCosine && sum.norm() > 0.0) {
      list[i].b.n = list[next].a.n = sum.normalized();
    }
  }
}

std::vector<FrontCurve> keepInside(const FrontCurve& curve,
                                   const std::function<double(const Vec3&)>& outside) {
  const std::size_t n = curve.list.size();
  std::vector<bool> out(n);
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    out[i] = outside(curve.list[i].a.p) > 0.0;
    count += out[i] ? 1U : 0U;
  }
  const bool lastOut = n > 0 && outside(curve.list.back().b.p) > 0.0;
  if (count == 0 && !lastOut) {
    return {curve};
  }
  std::vector<FrontCurve> kept;
  if (count == n && lastOut) {
    return kept;
  }
  // A closed curve starts where it enters, so that no kept piece wraps around.
  std::size_t first = 0;
  while (curve.ring && first + 1 < n && !(out[first] && !out[(first + 1) % n])) {
    ++first;
  }
  FrontCurve part(curve);
  part.ring = false;
  part.list.clear();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (first + k) % n;
    FrontPiece piece = curve.list[i];
    const bool startOut = out[i];
    const bool endOut = i + 1 < n ? out[i + 1] : (curve.ring ? out[0] : lastOut);
    if (startOut != endOut) {
      double low = 0.0;
      double high = 1.0;
      for (int b = 0; b < kBisections; ++b) {
        const double middle = 0.5 * (low + high);
        ((outside(curve.at(i, middle).p) > 0.0) == startOut ? low : high) = middle;
      }
      const double w = startOut ? high : low;
      (startOut ? piece.a : piece.b) = curve.at(i, w);
      (startOut ? piece.uvA : piece.uvB) = piece.uvA + w * (piece.uvB - piece.uvA);
    }
    if (!startOut || !endOut) {
      part.list.push_back(piece);
    }
    if (endOut && !part.list.empty()) {
      kept.push_back(part);
      part.list.clear();
    }
  }
  if (!part.list.empty()) {
    kept.push_back(part);
  }
  return kept;
}

}  // namespace wcam::toolpath
