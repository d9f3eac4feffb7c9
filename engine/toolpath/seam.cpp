// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "seam.hpp"

#include "contour_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// 1/φ: successive starts never fall close together.
constexpr double kGoldenRatio = 0.6180339887498949;

const Vec3& ringPoint(const Contour& contour, std::size_t i) {
  return contour.points[i % contour.points.size()].p;
}

double pieceLength(const Contour& contour, std::size_t i) {
  return (ringPoint(contour, i + 1) - ringPoint(contour, i)).norm();
}

double ringLength(const Contour& contour) {
  double length = 0.0;
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    length += pieceLength(contour, i);
  }
  return length;
}

/// Place at an arc length from another one on, around the ring.
RingPlace placeAfter(const Contour& contour, const RingPlace& from, double length) {
  const std::size_t n = contour.points.size();
  const double whole = ringLength(contour);
  if (!(whole > 0.0)) {
    return from;
  }
  RingPlace place{from.index, 0.0};
  double rest = std::fmod(length + from.fraction * pieceLength(contour, from.index), whole);
  for (std::size_t steps = 0; steps <= n; ++steps) {
    const double piece = pieceLength(contour, place.index);
    if (rest < piece) {
      place.fraction = rest / piece;
      break;
    }
    rest -= piece;
    place.index = (place.index + 1) % n;
  }
  return place;
}

/// The point of the contour next to a place along the ring.
RingPlace snapped(const Contour& contour, const RingPlace& place) {
  const std::size_t next = (place.index + 1) % contour.points.size();
  return {place.fraction < 0.5 ? place.index : next, 0.0};
}

/// Nearest place to p on the segments.
RingPlace nearestPlace(const Contour& contour, const Vec3& p) {
  RingPlace best;
  double bestDistance = kInfinity;
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    const Vec3& a = ringPoint(contour, i);
    const Vec3 ab = ringPoint(contour, i + 1) - a;
    const double length2 = ab.squaredNorm();
    const double s = length2 > 0.0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
    const double distance = (p - (a + s * ab)).squaredNorm();
    if (distance < bestDistance) {
      bestDistance = distance;
      best = s < 1.0 ? RingPlace{i, s} : RingPlace{(i + 1) % contour.points.size(), 0.0};
    }
  }
  return best;
}

/// Reproducible on every platform (splitmix64).
std::uint64_t mix(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31U);
}

/// Cosine between a direction and the way from a centre to a point.
double alignment(const Vec3& p, const Vec3& centre, const Vec3& direction) {
  const Vec3 radial = p - centre;
  return radial.norm() > 0.0 ? radial.normalized().dot(direction) : -1.0;
}

Vec3 centreOf(const Contour& contour) {
  Vec3 centre = Vec3::Zero();
  for (const ContourPoint& point : contour.points) {
    centre += point.p / static_cast<double>(contour.points.size());
  }
  return centre;
}

/// Place of greatest alignment on the segments beside a point, by golden section.
RingPlace refinedAlignment(const Contour& contour,
                           std::size_t index,
                           const Vec3& centre,
                           const Vec3& direction) {
  const std::size_t n = contour.points.size();
  const std::size_t before = (index + n - 1) % n;
  const auto value = [&](double x) {  // -1 … 1 around the point
    const std::size_t from = x < 0.0 ? before : index;
    const double s = x < 0.0 ? x + 1.0 : x;
    const Vec3& a = ringPoint(contour, from);
    return alignment(a + s * (ringPoint(contour, from + 1) - a), centre, direction);
  };
  double low = -1.0;
  double high = 1.0;
  constexpr int kSteps = 80;  // 0.618^80: below rounding
  for (int i = 0; i < kSteps; ++i) {
    const double left = high - kGoldenRatio * (high - low);
    const double right = low + kGoldenRatio * (high - low);
    (value(left) < value(right) ? low : high) = value(left) < value(right) ? left : right;
  }
  const double x = 0.5 * (low + high);
  // A point that is as good keeps the contour's points as they are.
  constexpr double kAsGood = 1e-15;
  if (value(x) <= value(0.0) + kAsGood) {
    return {index, 0.0};
  }
  return x < 0.0 ? RingPlace{before, x + 1.0} : RingPlace{index, x};
}

}  // namespace

std::size_t nearestIndex(const Contour& contour, const Vec3& p) {
  std::size_t best = 0;
  double bestDistance = kInfinity;
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    const double distance = (contour.points[i].p - p).squaredNorm();
    if (distance < bestDistance) {
      bestDistance = distance;
      best = i;
    }
  }
  return best;
}

Contour startingAt(const Contour& contour, const RingPlace& place) {
  // Nearer to a point than this part of the segment is at the point.
  constexpr double kAtPoint = 1e-9;
  Contour result = contour;
  std::size_t start = place.index;
  if (place.fraction > 1.0 - kAtPoint) {
    start = (start + 1) % contour.points.size();
  } else if (place.fraction > kAtPoint) {
    const ContourPoint& a = contour.points[start];
    const ContourPoint& b = contour.points[(start + 1) % contour.points.size()];
    result.points.insert(result.points.begin() + static_cast<std::ptrdiff_t>(start) + 1,
                         between(a, b, place.fraction));
    ++start;
  }
  std::rotate(result.points.begin(), result.points.begin() + static_cast<std::ptrdiff_t>(start),
              result.points.end());
  return result;
}

SeamChooser::SeamChooser(const PathParams& params, const Substrate& substrate)
    : params_(params), T_part_substrate_(substrate.pose()) {}

RingPlace SeamChooser::aligned(const Contour& contour) const {
  const Vec3 centre = centreOf(contour);
  const Vec3 direction =
      T_part_substrate_.linear() *
      Vec3(std::cos(params_.seamDirection.value()), std::sin(params_.seamDirection.value()), 0.0);
  std::size_t index = 0;
  double best = -kInfinity;
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    const double cosine = alignment(contour.points[i].p, centre, direction);
    if (cosine > best) {
      best = cosine;
      index = i;
    }
  }
  return params_.seamExact ? refinedAlignment(contour, index, centre, direction)
                           : RingPlace{index, 0.0};
}

RingPlace SeamChooser::keptAway(const Contour& contour, const std::optional<Vec3>& lastEnd) {
  const Vec3 wanted = lastEnd ? *lastEnd : contour.points[aligned(contour).index].p;
  std::size_t nearest = contour.points.size();
  std::size_t farthest = 0;
  double nearestDistance = kInfinity;
  double farthestDistance = -1.0;
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    double away = kInfinity;
    for (const std::vector<Vec3>& starts : remembered_) {
      for (const Vec3& start : starts) {
        away = std::min(away, (contour.points[i].p - start).norm());
      }
    }
    const double distance = (contour.points[i].p - wanted).norm();
    if (away >= params_.seamKeepAway.value() && distance < nearestDistance) {
      nearestDistance = distance;
      nearest = i;
    }
    if (away > farthestDistance) {
      farthestDistance = away;
      farthest = i;
    }
  }
  if (nearest < contour.points.size()) {
    return {nearest, 0.0};
  }
  ++tooClose_;
  return {farthest, 0.0};
}

RingPlace SeamChooser::corner(const Contour& contour) const {
  // Directions are taken over this length: a rounding that a bead does not show is still a corner.
  constexpr double kWindow = 2.0;
  // A smaller turn is a bend, not a corner that hides a seam.
  const double least = degToRad(20.0);
  // Corners that differ by less are equally good; the seam direction decides between them.
  const double same = degToRad(2.0);
  const double whole = ringLength(contour);
  const double window = std::min(kWindow, 0.1 * whole);
  const std::size_t n = contour.points.size();
  // Point at the window's length from a point on, forwards or backwards.
  const auto ahead = [&](std::size_t from, bool forward) {
    double rest = window;
    std::size_t i = from;
    for (std::size_t steps = 0; steps < n; ++steps) {
      const std::size_t next = forward ? (i + 1) % n : (i + n - 1) % n;
      const Vec3 way = contour.points[next].p - contour.points[i].p;
      const double piece = way.norm();
      if (rest < piece) {
        return Vec3(contour.points[i].p + rest / piece * way);
      }
      rest -= piece;
      i = next;
    }
    return contour.points[i].p;
  };
  std::vector<double> score(contour.points.size(), 0.0);
  double best = 0.0;
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    const Vec3& p = contour.points[i].p;
    const Vec3 in = (p - ahead(i, false)).normalized();
    const Vec3 out = (ahead(i, true) - p).normalized();
    const double turn = std::atan2(in.cross(out).norm(), in.dot(out));
    if (turn >= least) {
      const bool concave = (out - in).dot(contour.points[i].n) > 0.0;
      score[i] = turn + (concave ? kPi : 0.0);
    }
    best = std::max(best, score[i]);
  }
  const RingPlace fallback = aligned(contour);
  if (best <= 0.0) {
    return fallback;
  }
  const Vec3 wanted = contour.points[fallback.index].p;
  std::size_t index = 0;
  double nearest = kInfinity;
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    const double distance = (contour.points[i].p - wanted).norm();
    if (score[i] >= best - same && distance < nearest) {
      nearest = distance;
      index = i;
    }
  }
  return {index, 0.0};
}

RingPlace SeamChooser::choose(const Contour& contour,
                              std::size_t layerIndex,
                              std::size_t contourIndex,
                              const std::optional<Vec3>& lastEnd) {
  const auto layer = static_cast<double>(layerIndex);
  const auto along = [&](double length) {
    const RingPlace place = placeAfter(contour, aligned(contour), length);
    return params_.seamExact ? place : snapped(contour, place);
  };
  RingPlace place;
  switch (params_.seam) {
    case SeamMode::Nearest:
      place = !lastEnd            ? aligned(contour)
              : params_.seamExact ? nearestPlace(contour, *lastEnd)
                                  : RingPlace{nearestIndex(contour, *lastEnd), 0.0};
      break;
    case SeamMode::Aligned:
      place = aligned(contour);
      break;
    case SeamMode::Shifted:
      place = along(layer * params_.seamShift.value());
      break;
    case SeamMode::GoldenRatio:
      place = along(std::fmod(layer * kGoldenRatio, 1.0) * ringLength(contour));
      break;
    case SeamMode::Random: {
      const std::uint64_t bits =
          mix(mix(mix(static_cast<std::uint64_t>(params_.seed)) + layerIndex) + contourIndex);
      constexpr double kUnit = 0x1p-53;
      place = params_.seamExact
                  ? placeAfter(contour, {0, 0.0},
                               static_cast<double>(bits >> 11U) * kUnit * ringLength(contour))
                  : RingPlace{static_cast<std::size_t>(bits % contour.points.size()), 0.0};
      break;
    }
    case SeamMode::KeepAway:
      place = keptAway(contour, lastEnd);
      break;
    case SeamMode::Corner:
      place = corner(contour);
      break;
  }
  const Vec3& a = ringPoint(contour, place.index);
  current_.push_back(a + place.fraction * (ringPoint(contour, place.index + 1) - a));
  return place;
}

void SeamChooser::endLayer() {
  remembered_.push_back(std::move(current_));
  current_.clear();
  while (remembered_.size() > static_cast<std::size_t>(params_.seamMemory)) {
    remembered_.pop_front();
  }
}

}  // namespace wcam::toolpath
