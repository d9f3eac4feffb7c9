// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "path_checks.hpp"

#include "wcam/geometry/surface_projector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace wcam::test {

namespace {

using geometry::Vec3;
using toolpath::BeadFeature;
using toolpath::Contour;

std::string at(std::size_t layer, std::size_t contour, std::size_t point, const std::string& what) {
  std::ostringstream text;
  text << "layer " << layer << " contour " << contour << " point " << point << ": " << what;
  return text.str();
}

/// Distance between two segments (Ericson, Real-Time Collision Detection, 5.1.9).
double segmentDistance(const Vec3& p1, const Vec3& q1, const Vec3& p2, const Vec3& q2) {
  const Vec3 d1 = q1 - p1;
  const Vec3 d2 = q2 - p2;
  const Vec3 r = p1 - p2;
  const double a = d1.dot(d1);
  const double e = d2.dot(d2);
  const double f = d2.dot(r);
  const double c = d1.dot(r);
  const double b = d1.dot(d2);
  const double denominator = a * e - b * b;
  double s =
      denominator > 1e-12 * a * e ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
  double t = e > 0.0 ? (b * s + f) / e : 0.0;
  if (t < 0.0 || t > 1.0) {
    t = std::clamp(t, 0.0, 1.0);
    s = a > 0.0 ? std::clamp((b * t - c) / a, 0.0, 1.0) : 0.0;
  }
  return (p1 + s * d1 - p2 - t * d2).norm();
}

}  // namespace

std::vector<std::string> brokenContours(const toolpath::SlicedLayers& sliced,
                                        const toolpath::Sampling& sampling) {
  std::vector<std::string> broken;
  if (sliced.layers.empty()) {
    broken.emplace_back("no layer");
  }
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    if (sliced.layers[l].contours.empty()) {
      broken.push_back("layer " + std::to_string(l) + " is empty");
    }
    if (!(std::abs(sliced.layers[l].up.norm() - 1.0) < 1e-9)) {
      broken.push_back("layer " + std::to_string(l) + " has no build direction");
    }
    for (std::size_t c = 0; c < sliced.layers[l].contours.size(); ++c) {
      const Contour& contour = sliced.layers[l].contours[c];
      const std::size_t n = contour.points.size();
      if (n < (contour.closed ? 3U : 2U)) {
        broken.push_back(at(l, c, n, "too few points"));
      }
      for (std::size_t i = 0; i < n; ++i) {
        const toolpath::ContourPoint& point = contour.points[i];
        if (!point.p.allFinite() || !(std::abs(point.n.norm() - 1.0) < 1e-6)) {
          broken.push_back(at(l, c, i, "no point or no normal"));
        }
        if (i + 1 == n && !contour.closed) {
          continue;
        }
        const double apart = (contour.points[(i + 1) % n].p - point.p).norm();
        if (!(apart > 0.0)) {
          broken.push_back(at(l, c, i, "the next point is the same"));
        }
        // A spiral's stations are spread evenly; a revolution of varying section stretches them.
        const double slack = contour.turns.empty() ? 1.0 + 1e-6 : 1.5;
        if (apart > slack * sampling.maxSpacing) {
          broken.push_back(at(l, c, i, "the next point is " + std::to_string(apart) + " mm away"));
        }
      }
    }
  }
  return broken;
}

std::vector<std::string> pointsOffSurface(
    const toolpath::SlicedLayers& sliced,
    const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
    double tolerance) {
  std::vector<std::string> off;
  std::vector<double> nearest;
  std::vector<Vec3> points;
  std::vector<std::string> names;
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    for (std::size_t c = 0; c < sliced.layers[l].contours.size(); ++c) {
      const Contour& contour = sliced.layers[l].contours[c];
      if (contour.feature != BeadFeature::Wall) {
        continue;
      }
      for (std::size_t i = 0; i < contour.points.size(); ++i) {
        points.push_back(contour.points[i].p);
        names.push_back(at(l, c, i, "off the surface by "));
      }
    }
  }
  nearest.assign(points.size(), std::numeric_limits<double>::infinity());
  for (const auto& part : parts) {
    const auto projected = geometry::SurfaceProjector(*part).project(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      nearest[i] = std::min(nearest[i], (projected[i].p - points[i]).norm());
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(nearest[i] <= tolerance)) {
      off.push_back(names[i] + std::to_string(nearest[i]));
    }
  }
  return off;
}

std::vector<std::string> pointsInSubstrate(const toolpath::SlicedLayers& sliced,
                                           const toolpath::Substrate& substrate,
                                           double tolerance) {
  std::vector<std::string> inside;
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    for (std::size_t c = 0; c < sliced.layers[l].contours.size(); ++c) {
      const Contour& contour = sliced.layers[l].contours[c];
      for (std::size_t i = 0; i < contour.points.size(); ++i) {
        const double height = substrate.heightAbove(contour.points[i].p);
        if (height < -tolerance) {
          inside.push_back(at(l, c, i, std::to_string(height) + " mm in the substrate"));
        }
      }
    }
  }
  return inside;
}

std::vector<std::string> crossingBeads(const toolpath::SlicedLayers& sliced) {
  std::vector<std::string> crossing;
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    for (std::size_t c = 0; c < sliced.layers[l].contours.size(); ++c) {
      const Contour& contour = sliced.layers[l].contours[c];
      const std::size_t n = contour.points.size();
      const std::size_t pieces = contour.closed ? n : n - 1;
      // Sweep along x: only segments whose boxes overlap are compared.
      std::vector<std::size_t> order(pieces);
      const auto a = [&](std::size_t i) -> const Vec3& { return contour.points[i].p; };
      const auto b = [&](std::size_t i) -> const Vec3& { return contour.points[(i + 1) % n].p; };
      const auto low = [&](std::size_t i) { return a(i).cwiseMin(b(i)); };
      const auto high = [&](std::size_t i) { return a(i).cwiseMax(b(i)); };
      for (std::size_t i = 0; i < pieces; ++i) {
        order[i] = i;
      }
      std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return low(i).x() < low(j).x() || (low(i).x() == low(j).x() && i < j);
      });
      constexpr double kTouch = 1e-7;
      for (std::size_t k = 0; k < pieces; ++k) {
        const std::size_t i = order[k];
        for (std::size_t m = k + 1; m < pieces && low(order[m]).x() <= high(i).x() + kTouch; ++m) {
          const std::size_t j = order[m];
          const std::size_t between = i > j ? i - j : j - i;
          const bool neighbours = between == 1 || (contour.closed && between == n - 1);
          if (neighbours || (low(j).array() > high(i).array() + kTouch).any() ||
              (low(i).array() > high(j).array() + kTouch).any()) {
            continue;
          }
          // A spiral may end on itself, where it closes its last revolution.
          const Vec3& end = contour.points.back().p;
          const bool endsThere = !contour.closed && (i + 1 == pieces || j + 1 == pieces) &&
                                 segmentDistance(end, end, a(i), b(i)) < kTouch &&
                                 segmentDistance(end, end, a(j), b(j)) < kTouch;
          if (!endsThere && segmentDistance(a(i), b(i), a(j), b(j)) < kTouch) {
            crossing.push_back(at(l, c, i, "crosses the piece from point " + std::to_string(j)));
          }
        }
      }
    }
  }
  return crossing;
}

}  // namespace wcam::test
