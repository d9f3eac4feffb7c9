// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cladding_beads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::cladding {

SurfaceCurve toCurve(const toolpath::Contour& contour, std::size_t line) {
  SurfaceCurve curve;
  curve.closed = contour.closed;
  curve.line = line;
  for (const toolpath::ContourPoint& point : contour.points) {
    curve.points.push_back(point.p);
    curve.normals.push_back(point.n);
  }
  return curve;
}

double curveLength(const SurfaceCurve& curve) {
  double length = 0.0;
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    length += (curve.points[i] - curve.points[i - 1]).norm();
  }
  return curve.closed && !curve.points.empty()
             ? length + (curve.points.front() - curve.points.back()).norm()
             : length;
}

namespace {

void reverse(SurfaceCurve& curve) {
  std::reverse(curve.points.begin(), curve.points.end());
  std::reverse(curve.normals.begin(), curve.normals.end());
}

void trimEnd(SurfaceCurve& curve, double length) {
  while (curve.points.size() > 1) {
    const std::size_t n = curve.points.size();
    const Vec3 d = curve.points[n - 1] - curve.points[n - 2];
    const double last = d.norm();
    if (last > length) {
      const double s = 1.0 - length / last;
      curve.points[n - 1] = curve.points[n - 2] + s * d;
      curve.normals[n - 1] =
          (curve.normals[n - 2] + s * (curve.normals[n - 1] - curve.normals[n - 2])).normalized();
      return;
    }
    length -= last;
    curve.points.pop_back();
    curve.normals.pop_back();
  }
  curve.points.clear();
  curve.normals.clear();
}

/// Goes over from the end of a curve to the start of the next.
void bridge(SurfaceCurve& curve,
            const SurfaceCurve& next,
            const geometry::AabbTree& surface,
            double maxSpacing) {
  const Vec3 a = curve.points.back();
  const Vec3 na = curve.normals.back();
  const Vec3 d = next.points.front() - a;
  // A few points at least, so that the bead follows a curved surface.
  constexpr double kLeastPieces = 4.0;
  const auto pieces = static_cast<int>(std::max(kLeastPieces, std::ceil(d.norm() / maxSpacing)));
  for (int k = 1; k < pieces; ++k) {
    const double s = static_cast<double>(k) / pieces;
    const auto hit = surface.closestPoint(a + s * d);
    curve.points.push_back(hit ? hit->p : Vec3(a + s * d));
    curve.normals.push_back((na + s * (next.normals.front() - na)).normalized());
  }
  curve.points.insert(curve.points.end(), next.points.begin(), next.points.end());
  curve.normals.insert(curve.normals.end(), next.normals.begin(), next.normals.end());
}

struct Pair {
  std::size_t chain = 0;
  std::size_t curve = 0;
  double distance = 0.0;
};

}  // namespace

void trimEnds(SurfaceCurve& curve, double length) {
  if (curve.closed || !(length > 0.0)) {
    return;
  }
  trimEnd(curve, length);
  reverse(curve);
  trimEnd(curve, length);
  reverse(curve);
}

std::vector<SurfaceCurve> zigzag(const std::vector<SurfaceCurve>& curves,
                                 const geometry::AabbTree& surface,
                                 double reach,
                                 double maxSpacing) {
  std::vector<SurfaceCurve> chains;  // `line` is that of the last curve
  for (std::size_t from = 0; from < curves.size();) {
    std::size_t to = from;
    while (to < curves.size() && curves[to].line == curves[from].line) {
      ++to;
    }
    std::vector<SurfaceCurve> row(curves.begin() + static_cast<long>(from),
                                  curves.begin() + static_cast<long>(to));
    for (SurfaceCurve& curve : row) {
      if (!curve.closed && curve.line % 2 == 1) {
        reverse(curve);
      }
    }
    std::vector<Pair> pairs;
    for (std::size_t c = 0; c < chains.size(); ++c) {
      for (std::size_t r = 0; r < row.size(); ++r) {
        const bool follows = chains[c].line + 1 == row[r].line;
        if (follows && !chains[c].closed && !row[r].closed) {
          pairs.push_back({c, r, (row[r].points.front() - chains[c].points.back()).norm()});
        }
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
    std::vector<char> taken(row.size(), 0);
    for (const Pair& pair : pairs) {
      if (pair.distance > reach || taken[pair.curve] != 0 ||
          chains[pair.chain].line == row[pair.curve].line) {
        continue;
      }
      bridge(chains[pair.chain], row[pair.curve], surface, maxSpacing);
      chains[pair.chain].line = row[pair.curve].line;
      taken[pair.curve] = 1;
    }
    for (std::size_t r = 0; r < row.size(); ++r) {
      if (taken[r] == 0) {
        chains.push_back(std::move(row[r]));
      }
    }
    from = to;
  }
  return chains;
}

toolpath::Contour raised(const SurfaceCurve& curve,
                         double height,
                         double layerHeight,
                         double width,
                         std::size_t& folded) {
  toolpath::Contour contour;
  contour.closed = curve.closed;
  contour.feature = toolpath::BeadFeature::Cladding;
  const std::size_t n = curve.points.size();
  std::vector<Vec3> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    points[i] = curve.points[i] + height * curve.normals[i];
  }
  const auto before = [&](std::size_t i) { return i > 0 ? i - 1 : (curve.closed ? n - 1 : 0); };
  const auto after = [&](std::size_t i) { return i + 1 < n ? i + 1 : (curve.closed ? 0 : n - 1); };
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 on = curve.points[after(i)] - curve.points[before(i)];
    const Vec3 t = points[after(i)] - points[before(i)];
    folded += t.dot(on) < 0.0 ? 1U : 0U;
    const Vec3& normal = curve.normals[i];
    Vec3 across = normal.cross(on);
    // A curve that turns back on itself has no direction: any one across the normal will do.
    constexpr double kNoDirection = 1e-9;
    across = across.norm() > kNoDirection * on.norm() && across.norm() > 0.0
                 ? Vec3(across.normalized())
                 : normal.unitOrthogonal();
    contour.points.push_back({points[i], across, layerHeight, width});
  }
  return contour;
}

}  // namespace wcam::cladding
