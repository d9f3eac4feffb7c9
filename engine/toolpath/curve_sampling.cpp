// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/geometry/segment_tree.hpp"
#include "wcam/toolpath/slice_field.hpp"

#include "sampled_curve.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {

namespace {

/// A change of direction beyond this is a corner of the part and stays a point. Exact curves turn
/// only at CAD edges, tangent ones by rounding; a mesh turns at every facet of a round surface.
const double kExactCornerCosine = std::cos(degToRad(2.0));
const double kMeshCornerCosine = std::cos(degToRad(35.0));
/// Halvings that repair an interval whose chord error is still too large; 2^-16 of it is below any
/// tolerance.
constexpr int kRepairDepth = 16;
/// Slack of the bounds against rounding.
constexpr double kSlack = 1.0 + 1e-9;

/// Radius of the circle through three points; infinity for a straight line.
double circumradius(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double area2 = (b - a).cross(c - a).norm();
  const double product = (b - a).norm() * (c - b).norm() * (a - c).norm();
  return area2 > 1e-15 * product / std::max((c - a).norm(), 1e-300)
             ? product / (2.0 * area2)
             : std::numeric_limits<double>::infinity();
}

/// Greatest arc between samples on a circle of this radius.
double allowedArc(double radius, const Sampling& sampling) {
  if (!std::isfinite(radius)) {
    return sampling.maxSpacing;
  }
  // 1 - cos a = 2 sin²(a/2), so that flat arcs keep their digits; at most half a circle per chord.
  const double ratio = std::min(1.0, sampling.chordError / radius);
  const double arc = 4.0 * radius * std::asin(std::sqrt(0.5 * ratio));
  const double spacingRatio = sampling.maxSpacing / (2.0 * radius);
  const double spacingArc = spacingRatio < 1.0 ? 2.0 * radius * std::asin(spacingRatio) : arc;
  return std::min(arc, spacingArc);
}

/// A run of segments between corners, with the number of samples that its curvature asks for.
class SmoothRun {
public:
  SmoothRun(const SampledCurve& curve,
            std::size_t first,
            std::size_t count,
            const Sampling& sampling)
      : curve_(curve), first_(first), sampling_(sampling) {
    cumulative_.push_back(0.0);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = (first + k) % curve.pieces();
      const Vec3 a = curve.at(i, 0.0).p;
      const Vec3 b = curve.at(i, 1.0).p;
      const double chord = (b - a).norm();
      const double radius = circumradius(a, curve.at(i, 0.5).p, b);
      const double arc =
          chord < 2.0 * radius ? 2.0 * radius * std::asin(chord / (2.0 * radius)) : chord;
      cumulative_.push_back(cumulative_.back() +
                            (std::isfinite(radius) ? arc : chord) / allowedArc(radius, sampling));
    }
  }

  [[nodiscard]] double total() const { return cumulative_.back(); }

  [[nodiscard]] ContourPoint at(double density) const {
    const auto upper = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, density);
    const auto k = static_cast<std::size_t>(upper - cumulative_.begin()) - 1;
    const double width = cumulative_[k + 1] - cumulative_[k];
    const double w = width > 0.0 ? std::clamp((density - cumulative_[k]) / width, 0.0, 1.0) : 0.0;
    return curve_.at((first_ + k) % curve_.pieces(), w);
  }

  /// Appends the samples in (from, to), repaired until both bounds hold; `a` and `b` are the ends.
  void fill(double from,
            const ContourPoint& a,
            double to,
            const ContourPoint& b,
            int depth,
            std::vector<ContourPoint>& out) const {
    if (depth == 0 || fits(from, a, to, b)) {
      return;
    }
    const double middle = 0.5 * (from + to);
    const ContourPoint m = at(middle);
    fill(from, a, middle, m, depth - 1, out);
    out.push_back(m);
    fill(middle, m, to, b, depth - 1, out);
  }

private:
  [[nodiscard]] bool fits(double from,
                          const ContourPoint& a,
                          double to,
                          const ContourPoint& b) const {
    if ((b.p - a.p).norm() > sampling_.maxSpacing * kSlack) {
      return false;
    }
    const double limit = sampling_.chordError * kSlack;
    const auto deviates = [&](const Vec3& p) {
      return geometry::distanceToSegment(p, a.p, b.p) > limit;
    };
    if (deviates(at(0.5 * (from + to)).p)) {
      return false;
    }
    const auto begin = std::upper_bound(cumulative_.begin(), cumulative_.end(), from);
    for (auto it = begin; it != cumulative_.end() && *it < to; ++it) {
      if (deviates(at(*it).p)) {
        return false;
      }
    }
    return true;
  }

  const SampledCurve& curve_;
  std::size_t first_;
  Sampling sampling_;
  std::vector<double> cumulative_;  ///< per node, in samples
};

/// Segments that begin with a corner.
std::vector<std::size_t> cornersOf(const SampledCurve& curve, double cosine) {
  std::vector<std::size_t> corners;
  const std::size_t n = curve.pieces();
  for (std::size_t i = 0; i < n; ++i) {
    if (i == 0 && !curve.closed()) {
      continue;
    }
    if (curve.tangent((i + n - 1) % n, 1.0).dot(curve.tangent(i, 0.0)) < cosine) {
      corners.push_back(i);
    }
  }
  return corners;
}

void appendRun(const SampledCurve& curve,
               std::size_t first,
               std::size_t count,
               bool ring,
               const Sampling& sampling,
               std::vector<ContourPoint>& out) {
  const SmoothRun run(curve, first, count, sampling);
  // Rounding must not add a sample to an exact count; a ring needs three points to be a ring.
  const double wanted = std::ceil(run.total() - 1e-9);
  const auto pieces = static_cast<std::size_t>(std::max(wanted, ring ? 3.0 : 1.0));
  double from = 0.0;
  ContourPoint a = run.at(0.0);
  const ContourPoint start = a;
  out.push_back(a);
  for (std::size_t k = 1; k <= pieces; ++k) {
    const double to = run.total() * static_cast<double>(k) / static_cast<double>(pieces);
    const ContourPoint b = ring && k == pieces ? start : run.at(to);
    run.fill(from, a, to, b, kRepairDepth, out);
    if (k < pieces) {
      out.push_back(b);
    }
    from = to;
    a = b;
  }
}

}  // namespace

SampledCurve::~SampledCurve() = default;

std::vector<ContourPoint> sampleCurve(const SampledCurve& curve, const Sampling& sampling) {
  WCAM_ASSERT(sampling.chordError > 0.0 && sampling.maxSpacing > 0.0);
  std::vector<ContourPoint> points;
  const std::size_t n = curve.pieces();
  if (n == 0) {
    return points;
  }
  const std::vector<std::size_t> corners =
      cornersOf(curve, curve.exact() ? kExactCornerCosine : kMeshCornerCosine);
  if (curve.closed() && corners.empty()) {
    appendRun(curve, 0, n, true, sampling, points);
    return points;
  }
  std::vector<std::size_t> starts = corners;
  if (!curve.closed()) {
    starts.insert(starts.begin(), 0);
  }
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const std::size_t end =
        k + 1 < starts.size() ? starts[k + 1] : (curve.closed() ? starts[0] + n : n);
    const std::size_t before = points.size();
    appendRun(curve, starts[k], end - starts[k], false, sampling, points);
    // At a corner the normal is the mean of both sides.
    const std::size_t previous = (starts[k] + n - 1) % n;
    const Vec3 sum = points[before].n + curve.at(previous, 1.0).n;
    if ((k > 0 || curve.closed()) && sum.norm() > 1e-6) {
      points[before].n = sum.normalized();
    }
  }
  if (!curve.closed()) {
    points.push_back(curve.at(n - 1, 1.0));
  }
  return points;
}

int chordCount(double radius, double chordError, bool rounded) {
  if (!(radius > 0.0) || !(chordError > 0.0)) {
    throw Error(ErrorCode::InvalidArgument, "radius and chord error must be positive");
  }
  const double exact = kPi / std::acos(1.0 - std::min(1.0, chordError / radius));
  return static_cast<int>(std::max(3.0, rounded ? std::round(exact) : std::ceil(exact - 1e-9)));
}

}  // namespace wcam::toolpath
