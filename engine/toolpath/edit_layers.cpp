// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/text.hpp"
#include "wcam/toolpath/layer_distance.hpp"

#include "edit_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath::detail {

namespace {

/// Distances that differ by less (mm) are the same: what is between is rounding of a translation.
constexpr double kSameDistance = 1e-6;
/// A layer belongs to the one before it in the list where its distance was measured to that one.
constexpr double kMeasured = 1e-3;
/// More than this many layer heights above what lies below it, a layer hangs in the air.
constexpr double kUnsupported = 2.0;
/// Copies of layers that turn by more than this (rad) do not lie on each other.
const double kSameUp = degToRad(1.0);

/// Mean height of the beads of a layer by their length; of a climbing bead all revolutions.
double thicknessOf(const Layer& layer) {
  double sum = 0.0;
  double whole = 0.0;
  for (const Bead& bead : layer.beads) {
    const double revolutions = std::max(1, bead.revolutions);
    for (std::size_t i = 1; i < bead.points.size(); ++i) {
      const double length = (bead.points[i].p - bead.points[i - 1].p).norm();
      sum += revolutions * length * 0.5 * (bead.points[i].height + bead.points[i - 1].height);
      whole += length;
    }
  }
  return whole > 0.0 ? sum / whole : 0.0;
}

void translate(Layer& layer, const Vec3& offset) {
  for (Bead& bead : layer.beads) {
    for (PathPoint& point : bead.points) {
      point.p += offset;
    }
  }
  layer.level += offset.dot(layer.up);
}

std::vector<double> distancesTo(const Layer& layer, const Layer& below) {
  std::vector<Contour> contours;
  for (const Bead& bead : below.beads) {
    Contour contour;
    for (const PathPoint& point : bead.points) {
      ContourPoint& own = contour.points.emplace_back();
      own.p = point.p;
    }
    contours.push_back(std::move(contour));
  }
  std::vector<Vec3> points;
  for (const Bead& bead : layer.beads) {
    for (const PathPoint& point : bead.points) {
      points.push_back(point.p);
    }
  }
  return layerDistance(points, contours);
}

/// Measures the distances of a layer anew that has got another layer below it. Where the old ones
/// were not measured to the layer before it (branches, a climbing bead) they stay.
/// @param before the layer with the one below it as they were; null: it lay on the substrate
/// @return the least distance, mm
double measureAgain(Layer& layer, const Layer& below, const Layer* before, const Layer* belowThen) {
  const std::vector<double> now = distancesTo(layer, below);
  std::vector<double> then;
  if (before != nullptr && belowThen != nullptr) {
    then = distancesTo(*before, *belowThen);
  }
  double least = std::numeric_limits<double>::infinity();
  std::size_t i = 0;
  for (Bead& bead : layer.beads) {
    for (PathPoint& point : bead.points) {
      const bool measured = then.empty() || std::abs(then[i] - point.distance) <= kMeasured;
      const double change = now[i] - point.distance;
      if (bead.revolutions == 0 && measured && std::isfinite(change) &&
          std::abs(change) > kSameDistance) {
        point.distance = now[i];
        point.height = std::max(point.height + change, 0.0);
      }
      least = std::min(least, now[i]);
      ++i;
    }
  }
  return least;
}

/// So many points of copies are taken for a slip of the pen: they would fill the memory.
constexpr std::size_t kMostCopies = 20000000;

void checkSize(const Toolpath& path,
               const std::pair<std::size_t, std::size_t>& range,
               std::size_t count,
               const Edit& edit) {
  std::size_t points = 0;
  for (std::size_t l = range.first; l <= range.second; ++l) {
    for (const Bead& bead : path.layers[l].beads) {
      points += bead.points.size();
    }
  }
  if (points * count > kMostCopies) {
    throw Error(ErrorCode::InvalidArgument,
                text("%1 would make %2 points", {nameOf(edit), std::to_string(points * count)}),
                text("edit '%1'", {edit.id}), "lower count or the range of layers");
  }
}

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

std::size_t deleteLayers(Toolpath& path, const Edit& edit, const JobContext& context) {
  const auto range = layersOf(path, edit, context);
  if (!range) {
    return 0;
  }
  const auto [first, last] = *range;
  const Toolpath old = path;
  double gone = 0.0;
  for (std::size_t l = first; l <= last; ++l) {
    gone += thicknessOf(path.layers[l]);
  }
  path.layers.erase(path.layers.begin() + static_cast<std::ptrdiff_t>(first),
                    path.layers.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  if (edit.params.closeGap) {
    const Vec3 down = -gone * old.layers[last].up;
    for (std::size_t l = first; l < path.layers.size(); ++l) {
      translate(path.layers[l], down);
    }
  }
  // Without a layer below, what was there stands already: a build that goes on.
  if (first > 0 && first < path.layers.size()) {
    context.check();
    const double height = thicknessOf(path.layers[first]);
    const double least = measureAgain(path.layers[first], path.layers[first - 1],
                                      &old.layers[last + 1], &old.layers[last]);
    if (least > kUnsupported * height && height > 0.0) {
      context.add({Severity::Warning,
                   "edit.layer_gap",
                   text("%1 leaves a gap of %2 mm below a layer that is %3 mm high",
                        {nameOf(edit), formatFixed(least, 2), formatFixed(height, 2)}),
                   "set close_gap, or delete the layers above as well",
                   {{}, static_cast<int>(first), -1, -1},
                   {{"gap_mm", least}, {"height_mm", height}}});
    }
  }
  return last - first + 1;
}

std::size_t repeatLayers(Toolpath& path, const Edit& edit, const JobContext& context) {
  const auto range = layersOf(path, edit, context);
  if (!range) {
    return 0;
  }
  const auto [first, last] = *range;
  double thickness = 0.0;
  double turn = 0.0;
  for (std::size_t l = first; l <= last; ++l) {
    thickness += thicknessOf(path.layers[l]);
    turn = std::max(turn, angleBetween(path.layers[l].up, path.layers[last].up));
  }
  if (turn > kSameUp) {
    context.add({Severity::Warning,
                 "edit.repeat_turns",
                 text("%1 repeats layers that turn by %2 degrees; the copies are not turned",
                      {nameOf(edit), formatFixed(radToDeg(turn), 1)}),
                 "repeat a range of parallel layers",
                 {{}, static_cast<int>(first), -1, -1},
                 {{"turn_deg", radToDeg(turn)}}});
  }
  const Vec3 offset = edit.params.offsetMode == RepeatOffset::Given
                          ? Vec3(edit.params.offset.data())
                          : Vec3(thickness * path.layers[last].up);
  const auto count = static_cast<std::size_t>(edit.params.count);
  checkSize(path, *range, count, edit);
  const Toolpath old = path;
  const auto at = static_cast<std::ptrdiff_t>(last) + 1;
  std::vector<Layer> copies;
  for (std::size_t k = 1; k <= count; ++k) {
    context.check();
    for (std::size_t l = first; l <= last; ++l) {
      Layer copy = old.layers[l];
      translate(copy, static_cast<double>(k) * offset);
      copies.push_back(std::move(copy));
    }
  }
  for (std::size_t l = last + 1; l < path.layers.size(); ++l) {
    translate(path.layers[l], static_cast<double>(count) * offset);
  }
  path.layers.insert(path.layers.begin() + at, copies.begin(), copies.end());
  const std::size_t size = last - first + 1;
  for (std::size_t k = 1; k <= count; ++k) {
    context.check();
    const std::size_t bottom = first + k * size;
    measureAgain(path.layers[bottom], path.layers[bottom - 1],
                 first > 0 ? &old.layers[first] : nullptr,
                 first > 0 ? &old.layers[first - 1] : nullptr);
  }
  // Above the last copy lies what lay above the range: the same neighbours, both moved.
  return size;
}

}  // namespace wcam::toolpath::detail
