// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "polyline.hpp"

#include "wcam/geometry/segment_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath {

Loop::Loop(std::vector<Vec3> points) : points_(std::move(points)) {
  arc_.push_back(0.0);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    arc_.push_back(arc_.back() + (points_[(i + 1) % points_.size()] - points_[i]).norm());
  }
}

std::size_t Loop::segmentAt(double& arc) const {
  const double whole = length();
  arc = std::fmod(arc, whole);
  arc = arc < 0.0 ? arc + whole : arc;
  const auto next = std::upper_bound(arc_.begin(), arc_.end(), arc);
  const auto index = static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - arc_.begin(), 1) - 1);
  return std::min(index, points_.size() - 1);
}

Vec3 Loop::at(double arc) const {
  if (!(length() > 0.0)) {
    return points_.front();
  }
  const std::size_t i = segmentAt(arc);
  const double size = arc_[i + 1] - arc_[i];
  const double w = size > 0.0 ? (arc - arc_[i]) / size : 0.0;
  return points_[i] + w * (points_[(i + 1) % points_.size()] - points_[i]);
}

Vec3 Loop::direction(double arc) const {
  std::size_t i = segmentAt(arc);
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const Vec3 chord = points_[(i + 1) % points_.size()] - points_[i];
    if (chord.norm() > 0.0) {
      return chord.normalized();
    }
    i = (i + 1) % points_.size();
  }
  return Vec3::Zero();
}

double Loop::nearest(const Vec3& place) const {
  double best = std::numeric_limits<double>::infinity();
  double arc = 0.0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vec3 chord = points_[(i + 1) % points_.size()] - points_[i];
    const double square = chord.squaredNorm();
    const double w =
        square > 0.0 ? std::clamp((place - points_[i]).dot(chord) / square, 0.0, 1.0) : 0.0;
    const double distance = (points_[i] + w * chord - place).squaredNorm();
    if (distance < best) {
      best = distance;
      arc = arc_[i] + w * std::sqrt(square);
    }
  }
  return arc;
}

std::vector<Vec3> Loop::resampled(std::size_t count, double start) const {
  std::vector<Vec3> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(at(start + length() * static_cast<double>(i) / static_cast<double>(count)));
  }
  return points;
}

double Loop::deviation(std::size_t count) const {
  const double pitch = length() / static_cast<double>(count);
  double worst = 0.0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double k = pitch > 0.0 ? std::floor(arc_[i] / pitch) : 0.0;
    worst = std::max(worst,
                     geometry::distanceToSegment(points_[i], at(k * pitch), at((k + 1.0) * pitch)));
  }
  return worst;
}

Loop Loop::reversed() const {
  std::vector<Vec3> points(points_.rbegin(), points_.rend());
  return Loop(std::move(points));
}

}  // namespace wcam::toolpath
