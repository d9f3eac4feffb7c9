// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/tool_axis.hpp"

#include "edit_steps.hpp"
#include "frames.hpp"
#include "path_split.hpp"
#include "zones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath::detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The body of a bead as it was before zones came to it: edits make those anew.
std::vector<PathPoint> plainBody(const Bead& bead) {
  const auto [first, last] = bodyOf(bead.points);
  std::vector<PathPoint> body(bead.points.begin() + static_cast<std::ptrdiff_t>(first),
                              bead.points.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  for (PathPoint& point : body) {
    point.speedFactor = point.wireFactor = 1.0;
  }
  body.front().zone = BeadZone::Body;
  body.front().arc = true;
  return body;
}

/// What belongs to the move that ends at a point.
void takeMove(PathPoint& point, const PathPoint& from) {
  point.arc = from.arc;
  point.zone = from.zone;
  point.speedFactor = from.speedFactor;
  point.wireFactor = from.wireFactor;
  point.change = from.change;
}

/// A place on a bead: on the move that ends at a point.
struct BeadPlace {
  std::size_t move = 1;
  double fraction = 0.0;
};

BeadPlace placeAtLength(const std::vector<PathPoint>& points, double length) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double piece = (points[i].p - points[i - 1].p).norm();
    if (length <= piece || i + 1 == points.size()) {
      return {i, piece > 0.0 ? std::clamp(length / piece, 0.0, 1.0) : 0.0};
    }
    length -= piece;
  }
  return {};
}

BeadPlace placeNearest(const std::vector<PathPoint>& points, const Vec3& p) {
  BeadPlace best;
  double least = kInfinity;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec3 step = points[i].p - points[i - 1].p;
    const double length2 = step.squaredNorm();
    const double f =
        length2 > 0.0 ? std::clamp((p - points[i - 1].p).dot(step) / length2, 0.0, 1.0) : 0.0;
    const double distance = (points[i - 1].p + f * step - p).norm();
    if (distance < least) {
      least = distance;
      best = {i, f};
    }
  }
  return best;
}

/// Where the ray from the centre of the bead leaves it for good; where it meets nothing, the point
/// in the direction nearest to it.
BeadPlace placeInDirection(const std::vector<PathPoint>& points, const Vec3& up, double angle) {
  Vec3 centre = Vec3::Zero();
  double whole = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length = (points[i].p - points[i - 1].p).norm();
    centre += 0.5 * length * (points[i].p + points[i - 1].p);
    whole += length;
  }
  centre = whole > 0.0 ? Vec3(centre / whole) : points.front().p;
  Vec3 x = Vec3::UnitX() - up.x() * up;
  x = x.norm() > kNoDirection ? Vec3(x.normalized()) : up.unitOrthogonal();
  const Vec3 ray = std::cos(angle) * x + std::sin(angle) * up.cross(x);
  const Vec3 across = up.cross(ray);
  BeadPlace best;
  BeadPlace aligned;
  double farthest = 0.0;
  double greatest = -kInfinity;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec3 a = points[i - 1].p - centre;
    const Vec3 b = points[i].p - centre;
    const double sa = a.dot(across);
    const double sb = b.dot(across);
    if (sa != sb && (sa <= 0.0) != (sb <= 0.0)) {
      const double f = sa / (sa - sb);
      const double along = (a + f * (b - a)).dot(ray);
      if (along > farthest) {
        farthest = along;
        best = {i, f};
      }
    }
    const double cosine = a.dot(ray) / std::max(std::hypot(a.dot(ray), sa), 1e-300);
    if (cosine > greatest) {
      greatest = cosine;
      aligned = {i, 0.0};
    }
  }
  return farthest > 0.0 ? best : aligned;
}

BeadPlace wantedStart(const std::vector<PathPoint>& points, const Vec3& up, const Edit& edit) {
  switch (edit.params.seam) {
    case SeamTarget::Point:
      return placeNearest(points, Vec3(edit.params.seamPoint.data()));
    case SeamTarget::Angle:
      return placeInDirection(points, up, edit.params.seamAngle.value());
    case SeamTarget::Length:
      break;
  }
  const double whole = lengthOf(points);
  double length = whole > 0.0 ? std::fmod(edit.params.seamLength.value(), whole) : 0.0;
  length += length < 0.0 ? whole : 0.0;
  return placeAtLength(points, length);
}

/// Index of the point at a place; one is put there when the place lies between points.
std::size_t pointAt(std::vector<PathPoint>& points, const BeadPlace& place, bool exact) {
  const double length = (points[place.move].p - points[place.move - 1].p).norm();
  const bool atBegin = exact ? place.fraction * length <= kSamePlace : place.fraction < 0.5;
  const bool atEnd = !exact || (1.0 - place.fraction) * length <= kSamePlace;
  if (atBegin) {
    return place.move - 1;
  }
  if (!atEnd) {
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(place.move),
                  pointBetween(points[place.move - 1], points[place.move], place.fraction));
  }
  return place.move;
}

}  // namespace

std::size_t moveSeam(Bead& bead, const Vec3& up, const Edit& edit, const ZoneParams& zones) {
  if (!bead.closed || bead.points.size() < 3) {
    return 0;
  }
  std::vector<PathPoint> ring = plainBody(bead);
  const std::size_t start = pointAt(ring, wantedStart(ring, up, edit), edit.params.exact);
  const std::size_t last = ring.size() - 1;
  if (start > 0 && start < last) {
    std::vector<PathPoint> turned(ring.begin() + static_cast<std::ptrdiff_t>(start), ring.end());
    turned.insert(turned.end(), ring.begin() + 1,
                  ring.begin() + static_cast<std::ptrdiff_t>(start) + 1);
    ring = std::move(turned);
  }
  bead.points = std::move(ring);
  addZones(bead, zones);
  return 1;
}

std::size_t reverseBead(Bead& bead, const Edit&, const ZoneParams& zones) {
  // A bead of several revolutions climbs.
  if (bead.revolutions > 0 || bead.points.size() < 2) {
    return 0;
  }
  const std::vector<PathPoint> body = plainBody(bead);
  std::vector<PathPoint> back(body.rbegin(), body.rend());
  for (std::size_t i = 0; i < back.size(); ++i) {
    PathPoint& point = back[i];
    takeMove(point, body[i == 0 ? 0 : body.size() - i]);
    point.t = -point.t;
    point.n = -point.n;
    // The lead stays as the travel sees it, the lateral tilt on its side of the wall.
    const Vec3 along = tiltFrame(point.t, point.n, point.up).along;
    point.axis = (point.axis - 2.0 * point.axis.dot(along) * along).normalized();
  }
  bead.back = !bead.back;
  bead.points = std::move(back);
  addZones(bead, zones);
  return 1;
}

std::size_t pauseBead(std::vector<Bead>& beads,
                      std::size_t index,
                      const Edit& edit,
                      const ZoneParams& zones) {
  Bead& bead = beads[index];
  const double seconds = edit.params.seconds.value();
  if (edit.params.where == PausePlace::Before) {
    bead.pauseBefore += seconds;
    return 1;
  }
  if (edit.params.where == PausePlace::After) {
    bead.pauseAfter += seconds;
    return 1;
  }
  auto [first, last] = bodyOf(bead.points);
  double length = edit.params.at.value();
  const std::vector<PathPoint> body(bead.points.begin() + static_cast<std::ptrdiff_t>(first),
                                    bead.points.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  const double whole = lengthOf(body);
  if (length > whole + kSamePlace) {
    return 0;
  }
  if (length <= kSamePlace || length >= whole - kSamePlace) {
    (length <= kSamePlace ? bead.pauseBefore : bead.pauseAfter) += seconds;
    return 1;
  }
  for (std::size_t i = 1; i <= first; ++i) {
    length += (bead.points[i].p - bead.points[i - 1].p).norm();
  }
  const std::size_t cut = pointAt(bead.points, placeAtLength(bead.points, length), true);
  Bead rest = bead;
  const auto at = static_cast<std::ptrdiff_t>(cut);
  rest.points.erase(rest.points.begin(), rest.points.begin() + at);
  bead.points.erase(bead.points.begin() + at + 1, bead.points.end());
  bead.closed = rest.closed = false;
  rest.pauseBefore = seconds;
  bead.pauseAfter = 0.0;
  // The old ends keep what stands there; the new ones get theirs.
  ZoneParams out = zones;
  out.leadIn = out.rampIn = 0.0;
  ZoneParams in = zones;
  in.leadOut = in.rampOut = in.wipe = 0.0;
  addZones(bead, out);
  addZones(rest, in);
  beads.insert(beads.begin() + static_cast<std::ptrdiff_t>(index) + 1, std::move(rest));
  return 1;
}

std::size_t changeProcess(Bead& bead, const Edit& edit) {
  SplitBead split = splitAtRegion(bead.points, edit.params);
  const EditParams& params = edit.params;
  const bool speed = edit.type == EditType::SetSpeed;
  std::size_t moves = 0;
  for (std::size_t i = 0; i < split.points.size(); ++i) {
    PathPoint& point = split.points[i];
    if (!split.inside[i] || !point.arc || point.zone == BeadZone::Wipe) {
      continue;
    }
    ++moves;
    ProcessChange& change = point.change;
    double& amount = speed ? change.speed : change.wire;
    bool& isValue = speed ? change.speedIsValue : change.wireIsValue;
    if (params.mode == EditMode::Factor) {
      amount *= params.factor;
    } else {
      amount = speed ? params.speed.value() : params.wireSpeed.value();
      isValue = true;
    }
    if (speed) {
      change.section =
          params.speedFollower == SpeedFollower::Width ? SectionRule::Width : SectionRule::Wire;
    } else {
      change.section =
          params.wireFollower == WireFollower::Width ? SectionRule::Width : SectionRule::Speed;
    }
  }
  if (moves > 0) {
    bead.points = std::move(split.points);
  }
  return moves;
}

namespace {

/// Beyond this lean from the build direction no torch deposits on what lies below it, rad.
const double kMostLean = degToRad(80.0);

PathPoint leaned(
    PathPoint point, const Vec3& outward, const Edit& edit, double weight, std::size_t& limited) {
  const Vec3& up = point.up;
  const auto [t, side] = tiltFrame(point.t, outward, up);
  const double height = point.axis.dot(up);
  double lead = std::atan2(point.axis.dot(t), height);
  double lateral = std::atan2(point.axis.dot(side), height);
  double& angle = edit.type == EditType::SetLead ? lead : lateral;
  const double wanted = edit.params.angle.value();
  angle += weight * (edit.params.tiltMode == TiltMode::Add ? wanted : wanted - angle);
  if (std::abs(angle) > kMostLean) {
    angle = std::copysign(kMostLean, angle);
    ++limited;
  }
  point.axis = tiltedAxis(t, side, up, Angle(lead), Angle(lateral));
  return point;
}

/// Runs of moves inside, as lengths along the points.
std::vector<std::pair<double, double>> insideRuns(const SplitBead& split) {
  std::vector<std::pair<double, double>> runs;
  double way = 0.0;
  for (std::size_t i = 1; i < split.points.size(); ++i) {
    const double length = (split.points[i].p - split.points[i - 1].p).norm();
    if (split.inside[i]) {
      if (!split.inside[i - 1]) {
        runs.emplace_back(way, way);
      }
      runs.back().second = way + length;
    }
    way += length;
  }
  return runs;
}

/// Puts points at lengths along the path, which ascend.
std::vector<PathPoint> splitAtAll(const std::vector<PathPoint>& points,
                                  const std::vector<double>& lengths) {
  std::vector<PathPoint> split = {points.front()};
  double way = 0.0;
  std::size_t k = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length = (points[i].p - points[i - 1].p).norm();
    for (; k < lengths.size() && lengths[k] < way + length - kSamePlace; ++k) {
      if (lengths[k] > way + kSamePlace) {
        split.push_back(pointBetween(points[i - 1], points[i], (lengths[k] - way) / length));
      }
    }
    split.push_back(points[i]);
    way += length;
  }
  return split;
}

/// Where the change begins and ends to fade, in ascending order.
std::vector<double> fadeEnds(const std::vector<std::pair<double, double>>& runs, double blend) {
  std::vector<double> ends;
  for (const auto& [begin, end] : runs) {
    ends.push_back(begin - blend);
    ends.push_back(end + blend);
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

}  // namespace

std::size_t tiltAxes(Bead& bead, const Edit& edit, std::size_t& limited) {
  SplitBead split = splitAtRegion(bead.points, edit.params);
  const std::vector<std::pair<double, double>> runs = insideRuns(split);
  if (runs.empty()) {
    return 0;
  }
  const double blend = edit.params.blend.value();
  bead.points = splitAtAll(split.points, fadeEnds(runs, blend));
  double way = 0.0;
  std::size_t changed = 0;
  std::size_t k = 0;  // the first run that does not end before the point
  for (std::size_t i = 0; i < bead.points.size(); ++i) {
    way += i > 0 ? (bead.points[i].p - bead.points[i - 1].p).norm() : 0.0;
    while (k < runs.size() && runs[k].second < way) {
      ++k;
    }
    const double before = k > 0 ? way - runs[k - 1].second : kInfinity;
    const double after = k < runs.size() ? std::max(0.0, runs[k].first - way) : kInfinity;
    const double away = std::min(before, after);
    // A border may lie off its point by rounding.
    const double weight = away <= kSamePlace ? 1.0 : away < blend ? 1.0 - away / blend : 0.0;
    if (weight > 0.0) {
      bead.points[i] = leaned(bead.points[i], bead.outward(bead.points[i]), edit, weight, limited);
      ++changed;
    }
  }
  return changed;
}

}  // namespace wcam::toolpath::detail
