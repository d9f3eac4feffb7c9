// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "front_line.hpp"

#include "wcam/geometry/segment_tree.hpp"

#include <algorithm>

namespace wcam::toolpath {

namespace {

/// Segments without improvement after which a walk gives up: a fine polyline is nearly straight
/// over this many of them.
constexpr int kLookAhead = 4;
/// Halvings of a piece; 2^-8 of a mesh edge is fine enough for any chord that is asked for.
constexpr int kDepth = 8;

/// Points of a piece in (from, to), ends left out.
void subdivide(const SampledCurve& curve,
               std::size_t piece,
               double from,
               const Vec3& a,
               double to,
               const Vec3& b,
               double chord,
               int depth,
               std::vector<Vec3>& out) {
  const double middle = 0.5 * (from + to);
  const Vec3 m = curve.at(piece, middle).p;
  if (depth == 0 || geometry::distanceToSegment(m, a, b) <= chord) {
    return;
  }
  subdivide(curve, piece, from, a, middle, m, chord, depth - 1, out);
  out.push_back(m);
  subdivide(curve, piece, middle, m, to, b, chord, depth - 1, out);
}

}  // namespace

FrontLine::Foot FrontLine::footOn(const Vec3& p, std::int32_t segment) const {
  const auto s = static_cast<std::size_t>(segment);
  const Vec3 d = end_[s] - start_[s];
  const double length2 = d.squaredNorm();
  const double w = length2 > 0.0 ? std::clamp((p - start_[s]).dot(d) / length2, 0.0, 1.0) : 0.0;
  const Vec3 foot = start_[s] + w * d;
  return {segment, (p - foot).squaredNorm(), foot};
}

FrontLine::Foot FrontLine::nearest(const Vec3& p, std::int32_t hint) const {
  Foot best = footOn(p, hint);
  for (const std::vector<std::int32_t>* step : {&next_, &previous_}) {
    std::int32_t at = best.segment;
    int worse = 0;
    while (worse < kLookAhead) {
      at = (*step)[static_cast<std::size_t>(at)];
      if (at < 0 || at == best.segment) {
        break;
      }
      const Foot foot = footOn(p, at);
      if (foot.distance < best.distance) {
        best = foot;
        worse = 0;
      } else {
        ++worse;
      }
    }
  }
  best.distance = std::sqrt(best.distance);
  return best;
}

FrontLine::Foot FrontLine::nearest(const Vec3& p, std::int32_t hint, std::int32_t otherHint) const {
  const Foot a = nearest(p, hint);
  if (otherHint == hint || otherHint == a.segment) {
    return a;
  }
  const Foot b = nearest(p, otherHint);
  return b.distance < a.distance ? b : a;
}

std::vector<std::int32_t> FrontLine::add(const SampledCurve& curve, double chord) {
  std::vector<std::int32_t> middles;
  const auto first = static_cast<std::int32_t>(start_.size());
  std::vector<Vec3> inner;
  for (std::size_t piece = 0; piece < curve.pieces(); ++piece) {
    const Vec3 a = curve.at(piece, 0.0).p;
    const Vec3 b = curve.at(piece, 1.0).p;
    inner.assign(1, a);
    subdivide(curve, piece, 0.0, a, 1.0, b, chord, kDepth, inner);
    inner.push_back(b);
    middles.push_back(static_cast<std::int32_t>(start_.size() + (inner.size() - 1) / 2));
    for (std::size_t k = 0; k + 1 < inner.size(); ++k) {
      const auto index = static_cast<std::int32_t>(start_.size());
      start_.push_back(inner[k]);
      end_.push_back(inner[k + 1]);
      previous_.push_back(index > first ? index - 1 : -1);
      next_.push_back(index + 1);
    }
  }
  if (static_cast<std::int32_t>(start_.size()) > first) {
    next_.back() = curve.closed() ? first : -1;
    previous_[static_cast<std::size_t>(first)] =
        curve.closed() ? static_cast<std::int32_t>(start_.size()) - 1 : -1;
  }
  return middles;
}

}  // namespace wcam::toolpath
