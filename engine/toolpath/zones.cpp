// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "zones.hpp"

#include "path_split.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {

namespace {

/// A closed bead runs on over its own start.
void addOverlap(std::vector<PathPoint>& points, double overlap) {
  std::vector<PathPoint> again = points;
  splitAt(again, overlap);
  double length = 0.0;
  for (std::size_t i = 1; i < again.size() && length + kSamePlace < overlap; ++i) {
    length += (again[i].p - again[i - 1].p).norm();
    again[i].zone = BeadZone::Overlap;
    points.push_back(again[i]);
  }
}

/// Linear from `factor` at the border to 1 after the ramp's length.
double rampFactor(double factor, double fromBorder, double length) {
  return length > 0.0 && fromBorder < length ? factor + (1.0 - factor) * fromBorder / length : 1.0;
}

void addRamps(std::vector<PathPoint>& points, const ZoneParams& zones) {
  const double whole = lengthOf(points);
  const double wanted = std::max(zones.rampIn + zones.rampOut, kSamePlace);
  const double scale = std::min(1.0, whole / wanted);
  const double in = zones.rampIn * scale;
  const double out = zones.rampOut * scale;
  // Moves have one speed each: so many steps show the slope.
  constexpr int kSteps = 5;
  for (int k = 1; k <= kSteps; ++k) {
    splitAt(points, in * k / kSteps);
    splitAt(points, whole - out * k / kSteps);
  }
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double piece = (points[i].p - points[i - 1].p).norm();
    const double middle = length + 0.5 * piece;
    points[i].speedFactor *= rampFactor(zones.rampInSpeed, middle, in) *
                             rampFactor(zones.rampOutSpeed, whole - middle, out);
    points[i].wireFactor *= rampFactor(zones.rampInWire, middle, in) *
                            rampFactor(zones.rampOutWire, whole - middle, out);
    length += piece;
  }
}

void addWipe(std::vector<PathPoint>& points, const ZoneParams& zones) {
  std::vector<PathPoint> back(points.rbegin(), points.rend());
  const double length = std::min(zones.wipe, lengthOf(back));
  splitAt(back, length);
  double way = 0.0;
  for (std::size_t i = 1; i < back.size() && way + kSamePlace < length; ++i) {
    way += (back[i].p - back[i - 1].p).norm();
    PathPoint point = back[i];
    point.p += zones.wipeLift * std::min(1.0, way / length) * point.up;
    point.arc = false;
    point.zone = BeadZone::Wipe;
    point.speedFactor = point.wireFactor = 1.0;
    points.push_back(point);
  }
}

}  // namespace

void addZones(Bead& bead, const ZoneParams& zones) {
  std::vector<PathPoint>& points = bead.points;
  if (points.size() < 2 || !(lengthOf(points) > 0.0)) {
    return;
  }
  if (bead.closed && zones.overlap > 0.0) {
    addOverlap(points, zones.overlap);
  }
  if (zones.rampIn > 0.0 || zones.rampOut > 0.0) {
    addRamps(points, zones);
  }
  if (zones.leadOut > 0.0) {
    PathPoint point = points.back();
    point.p += zones.leadOut * point.t;
    point.arc = zones.leadArc;
    point.zone = BeadZone::LeadOut;
    points.push_back(point);
  }
  if (zones.wipe > 0.0) {
    addWipe(points, zones);
  }
  if (zones.leadIn > 0.0) {
    points.front().arc = zones.leadArc;
    points.front().zone = BeadZone::LeadIn;
    PathPoint point = points.front();
    point.p -= zones.leadIn * point.t;
    points.insert(points.begin(), point);
  }
}

}  // namespace wcam::toolpath
