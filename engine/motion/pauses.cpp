// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/pauses.hpp"

#include <algorithm>

namespace wcam::motion {

namespace {

const toolpath::Bead* beadOf(const toolpath::Toolpath& path, const Waypoint& point) noexcept {
  if (point.layer < 0 || point.bead < 0 ||
      static_cast<std::size_t>(point.layer) >= path.layers.size()) {
    return nullptr;
  }
  const auto& beads = path.layers[static_cast<std::size_t>(point.layer)].beads;
  return static_cast<std::size_t>(point.bead) < beads.size()
             ? &beads[static_cast<std::size_t>(point.bead)]
             : nullptr;
}

bool sameBead(const Waypoint& a, const Waypoint& b) noexcept {
  return a.layer == b.layer && a.bead == b.bead;
}

}  // namespace

bool hasPauses(const toolpath::Toolpath& path) noexcept {
  const auto waits = [](const toolpath::Bead& bead) {
    return bead.pauseBefore > 0.0 || bead.pauseAfter > 0.0;
  };
  return std::any_of(path.layers.begin(), path.layers.end(), [&](const toolpath::Layer& layer) {
    return std::any_of(layer.beads.begin(), layer.beads.end(), waits);
  });
}

namespace {

/// Makes everything behind a waypoint later by the seconds that the torch stands there.
/// @param stands seconds at a waypoint, by its index
template <class Stands>
double delay(PlannedMotion& planned, const Stands& stands) {
  std::vector<Waypoint>& points = planned.motion.waypoints;
  double waited = 0.0;
  std::size_t reversal = 0;
  std::vector<Reversal>& reversals = planned.statistics.reversals;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].time += waited;
    for (; reversal < reversals.size() && reversals[reversal].waypoint <= i; ++reversal) {
      reversals[reversal].time += waited;
    }
    waited += stands(i);
  }
  planned.statistics.totalTime += waited;
  return waited;
}

}  // namespace

PlannedMotion withPauses(PlannedMotion planned, const toolpath::Toolpath& path) {
  std::vector<Waypoint>& points = planned.motion.waypoints;
  delay(planned, [&](std::size_t i) {
    const toolpath::Bead* bead = beadOf(path, points[i]);
    if (bead == nullptr) {
      return 0.0;
    }
    points[i].pause = 0.0;
    if (i == 0 || !sameBead(points[i - 1], points[i])) {
      points[i].pause += bead->pauseBefore;
    }
    if (i + 1 == points.size() || !sameBead(points[i], points[i + 1])) {
      points[i].pause += bead->pauseAfter;
    }
    return points[i].pause;
  });
  return planned;
}

PlannedMotion withCraters(PlannedMotion planned, double seconds) {
  const std::vector<Waypoint>& points = planned.motion.waypoints;
  planned.statistics.arcTime += delay(planned, [&](std::size_t i) {
    const bool ends = points[i].arc && (i + 1 == points.size() || !points[i + 1].arc);
    return ends ? seconds : 0.0;
  });
  return planned;
}

}  // namespace wcam::motion
