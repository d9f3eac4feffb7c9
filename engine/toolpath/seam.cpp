// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "seam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath {

namespace {

/// 1/φ: successive starts never fall close together.
constexpr double kGoldenRatio = 0.6180339887498949;

std::size_t nearestIndex(const Contour& contour, const Vec3& p) {
  std::size_t best = 0;
  double bestDistance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    const double distance = (contour.points[i].p - p).squaredNorm();
    if (distance < bestDistance) {
      bestDistance = distance;
      best = i;
    }
  }
  return best;
}

double ringLength(const Contour& contour) {
  double length = 0.0;
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    length += (contour.points[(i + 1) % contour.points.size()].p - contour.points[i].p).norm();
  }
  return length;
}

/// First point at or after an arc length from a point on, around the ring.
std::size_t indexAfter(const Contour& contour, std::size_t from, double length) {
  const std::size_t n = contour.points.size();
  double rest = std::fmod(length, ringLength(contour));
  std::size_t i = from;
  // Half a spacing of tolerance: takes the point next to the wanted place.
  while (rest > 0.0) {
    const double piece = (contour.points[(i + 1) % n].p - contour.points[i].p).norm();
    if (rest < 0.5 * piece) {
      break;
    }
    rest -= piece;
    i = (i + 1) % n;
  }
  return i;
}

/// Reproducible on every platform (splitmix64).
std::uint64_t mix(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31U);
}

}  // namespace

SeamChooser::SeamChooser(const PathParams& params, const Substrate& substrate)
    : params_(params), T_part_substrate_(substrate.pose()) {}

std::size_t SeamChooser::seamIndex(const Contour& contour,
                                   std::size_t layerIndex,
                                   std::size_t contourIndex) const {
  if (params_.seam == SeamMode::Nearest && lastEnd_) {
    return nearestIndex(contour, *lastEnd_);
  }
  // The aligned start: the point farthest from the contour's centre in the seam direction.
  Vec3 centre = Vec3::Zero();
  for (const ContourPoint& point : contour.points) {
    centre += point.p / static_cast<double>(contour.points.size());
  }
  const Vec3 direction =
      T_part_substrate_.linear() *
      Vec3(std::cos(params_.seamDirection.value()), std::sin(params_.seamDirection.value()), 0.0);
  std::size_t aligned = 0;
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    const Vec3 radial = contour.points[i].p - centre;
    const double cosine = radial.norm() > 0.0 ? radial.normalized().dot(direction) : -1.0;
    if (cosine > best) {
      best = cosine;
      aligned = i;
    }
  }
  const auto layer = static_cast<double>(layerIndex);
  switch (params_.seam) {
    case SeamMode::Nearest:
    case SeamMode::Aligned:
      return aligned;
    case SeamMode::Shifted:
      return indexAfter(contour, aligned, layer * params_.seamShift.value());
    case SeamMode::GoldenRatio:
      return indexAfter(contour, aligned,
                        std::fmod(layer * kGoldenRatio, 1.0) * ringLength(contour));
    case SeamMode::Random: {
      const std::uint64_t bits =
          mix(mix(mix(static_cast<std::uint64_t>(params_.seed)) + layerIndex) + contourIndex);
      return static_cast<std::size_t>(bits % contour.points.size());
    }
  }
  return aligned;
}

namespace {

int lowestGroup(const SlicedLayer& layer, const std::vector<bool>& used) {
  int group = std::numeric_limits<int>::max();
  for (std::size_t c = 0; c < layer.contours.size(); ++c) {
    if (!used[c]) {
      group = std::min(group, layer.contours[c].group);
    }
  }
  return group;
}

}  // namespace

std::vector<OrderedContour> SeamChooser::arrange(const SlicedLayer& layer,
                                                 std::size_t layerIndex,
                                                 bool reversed) {
  std::vector<OrderedContour> ordered;
  std::vector<bool> used(layer.contours.size(), false);
  for (std::size_t k = 0; k < layer.contours.size(); ++k) {
    // The contour whose nearest point (its ends, when open) is closest to where the torch is.
    std::size_t next = 0;
    double best = std::numeric_limits<double>::infinity();
    const int group = lowestGroup(layer, used);
    for (std::size_t c = 0; c < layer.contours.size(); ++c) {
      const Contour& contour = layer.contours[c];
      if (used[c] || contour.group != group) {
        continue;
      }
      double distance = lastEnd_ ? 0.0 : static_cast<double>(c);
      if (lastEnd_ && contour.closed) {
        distance = (contour.points[nearestIndex(contour, *lastEnd_)].p - *lastEnd_).norm();
      } else if (lastEnd_) {
        const bool turned = reversed && contour.turns.empty();
        distance = (contour.points[turned ? contour.points.size() - 1 : 0].p - *lastEnd_).norm();
      }
      if (distance < best) {
        best = distance;
        next = c;
      }
    }
    used[next] = true;
    // A bead of several revolutions climbs: it has no other start and no other direction.
    const bool climbs = !layer.contours[next].turns.empty();
    OrderedContour item{layer.contours[next], reversed && !climbs};
    std::vector<ContourPoint>& points = item.contour.points;
    if (item.contour.closed && !climbs) {
      const std::size_t start = seamIndex(item.contour, layerIndex, next);
      std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(start),
                  points.end());
      if (reversed) {
        std::reverse(points.begin() + 1, points.end());
      }
    } else if (item.reversed) {
      std::reverse(points.begin(), points.end());
    }
    lastEnd_ = item.contour.closed ? points.front().p : points.back().p;
    ordered.push_back(std::move(item));
  }
  return ordered;
}

}  // namespace wcam::toolpath
