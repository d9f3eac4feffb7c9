// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/toolpath/onto_parts.hpp"

#include "wcam/base/error.hpp"
#include "wcam/geometry/surface_projector.hpp"

#include <algorithm>
#include <cstddef>

namespace wcam::toolpath {

using geometry::PartSurface;
using geometry::SurfaceProjector;

namespace {

/// Points nearer than this part of the part's size coincide: rounding of a projection.
constexpr double kSamePoint = 1e-12;
/// Slack of the spacing against rounding.
constexpr double kSlack = 1.0 + 1e-9;
/// Halvings of an interval that is too long; each nearly halves it.
constexpr int kMostRounds = 16;

bool onWall(const Contour& contour) {
  return contour.feature == BeadFeature::Wall || contour.feature == BeadFeature::Junction;
}

std::vector<Contour*> wallsOf(SlicedLayers& sliced, std::size_t part) {
  std::vector<Contour*> walls;
  for (SlicedLayer& layer : sliced.layers) {
    for (Contour& contour : layer.contours) {
      if (contour.part == static_cast<int>(part) && onWall(contour)) {
        walls.push_back(&contour);
      }
    }
  }
  return walls;
}

void project(const std::vector<ContourPoint*>& points,
             const SurfaceProjector& projector,
             const JobContext& context) {
  std::vector<Vec3> places;
  places.reserve(points.size());
  for (const ContourPoint* point : points) {
    places.push_back(point->p);
  }
  const auto moved = projector.project(places, context);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i]->p = moved[i].p;
  }
}

/// Drops points that coincide with the one before, along the ring too.
void dropRepeats(Contour& contour, double same) {
  std::vector<ContourPoint> kept;
  std::vector<std::size_t> indexOf(contour.points.size());
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    if (kept.empty() || (contour.points[i].p - kept.back().p).norm() > same) {
      kept.push_back(contour.points[i]);
    } else if (!contour.closed && i + 1 == contour.points.size() && kept.size() > 1) {
      kept.back() = contour.points[i];  // the end of an open contour stays
    }
    indexOf[i] = kept.size() - 1;
  }
  while (contour.closed && kept.size() > 1 && (kept.front().p - kept.back().p).norm() <= same) {
    kept.pop_back();
  }
  for (std::size_t& turn : contour.turns) {
    turn = std::min(indexOf[turn], kept.size() - 1);
  }
  contour.points = std::move(kept);
}

ContourPoint between(const ContourPoint& a, const ContourPoint& b) {
  ContourPoint middle = a;
  const auto mean = [](const Vec3& x, const Vec3& y) {
    const Vec3 sum = x + y;
    return sum.norm() > 0.0 ? Vec3(sum.normalized()) : x;
  };
  middle.p = 0.5 * (a.p + b.p);
  middle.n = mean(a.n, b.n);
  // Zero stands for a value that is not known.
  middle.height = a.height > 0.0 && b.height > 0.0 ? 0.5 * (a.height + b.height) : 0.0;
  middle.width = a.width > 0.0 && b.width > 0.0 ? 0.5 * (a.width + b.width) : 0.0;
  middle.fillWidth =
      a.fillWidth > 0.0 && b.fillWidth > 0.0 ? 0.5 * (a.fillWidth + b.fillWidth) : 0.0;
  middle.axis = a.axis.isZero() || b.axis.isZero() ? Vec3(Vec3::Zero()) : mean(a.axis, b.axis);
  return middle;
}

/// Puts middles into intervals that are longer than allowed. @return the indices of the middles
std::vector<std::size_t> splitLong(Contour& contour, double longest) {
  std::vector<std::size_t> middles;
  std::vector<ContourPoint> points;
  std::vector<std::size_t> indexOf(contour.points.size());
  const std::size_t n = contour.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    indexOf[i] = points.size();
    points.push_back(contour.points[i]);
    if (i + 1 == n && !contour.closed) {
      continue;
    }
    const ContourPoint& next = contour.points[(i + 1) % n];
    if ((next.p - contour.points[i].p).norm() > longest) {
      middles.push_back(points.size());
      points.push_back(between(contour.points[i], next));
    }
  }
  if (!middles.empty()) {
    for (std::size_t& turn : contour.turns) {
      turn = indexOf[turn];
    }
    contour.points = std::move(points);
  }
  return middles;
}

void keepSpacing(const std::vector<Contour*>& walls,
                 const SurfaceProjector& projector,
                 double longest,
                 const JobContext& context) {
  for (int round = 0; round < kMostRounds; ++round) {
    std::vector<ContourPoint*> added;
    for (Contour* contour : walls) {
      for (const std::size_t i : splitLong(*contour, longest)) {
        added.push_back(&contour->points[i]);
      }
    }
    if (added.empty()) {
      return;
    }
    project(added, projector, context);
  }
}

bool withoutLength(const Contour& contour) {
  return onWall(contour) && contour.points.size() < (contour.closed ? 3U : 2U);
}

/// Drops contours without length, and layers that are left without any; what lay on such a layer
/// lies on what is below it.
void dropWithoutLength(SlicedLayers& sliced) {
  const std::size_t n = sliced.layers.size();
  std::vector<std::vector<std::size_t>> standsOn(n);  ///< indices of layers that stay
  std::vector<std::size_t> newIndex(n, n);
  std::vector<SlicedLayer> kept;
  for (std::size_t l = 0; l < n; ++l) {
    SlicedLayer& layer = sliced.layers[l];
    const bool had = !layer.contours.empty();
    layer.contours.erase(
        std::remove_if(layer.contours.begin(), layer.contours.end(), withoutLength),
        layer.contours.end());
    if (layer.below) {
      std::vector<std::size_t> below;
      for (const std::size_t k : *layer.below) {
        if (newIndex[k] < n) {
          below.push_back(newIndex[k]);
        } else {
          below.insert(below.end(), standsOn[k].begin(), standsOn[k].end());
        }
      }
      std::sort(below.begin(), below.end());
      below.erase(std::unique(below.begin(), below.end()), below.end());
      layer.below = std::move(below);
    }
    if (had && layer.contours.empty()) {
      if (layer.below) {
        standsOn[l] = *layer.below;
      } else if (!kept.empty()) {
        standsOn[l] = {kept.size() - 1};
      }
      continue;
    }
    newIndex[l] = kept.size();
    kept.push_back(std::move(layer));
  }
  if (kept.empty() && n > 0) {
    throw Error(ErrorCode::JobFailed, "the layers meet the part in points only", "slicing",
                "choose a smaller step, or check the part");
  }
  sliced.layers = std::move(kept);
}

}  // namespace

void moveOntoParts(SlicedLayers& sliced,
                   const std::vector<std::shared_ptr<const PartSurface>>& parts,
                   const Sampling& sampling,
                   const JobContext& context) {
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k]->exact()) {
      continue;
    }
    const std::vector<Contour*> walls = wallsOf(sliced, k);
    std::vector<ContourPoint*> points;
    for (Contour* contour : walls) {
      for (ContourPoint& point : contour->points) {
        points.push_back(&point);
      }
    }
    if (points.empty()) {
      continue;
    }
    const SurfaceProjector projector(*parts[k]);
    project(points, projector, context);
    const double same = kSamePoint * parts[k]->mesh.bounds().diagonal();
    for (Contour* contour : walls) {
      dropRepeats(*contour, same);
    }
    keepSpacing(walls, projector, kSlack * sampling.maxSpacing, context);
  }
  dropWithoutLength(sliced);
}

}  // namespace wcam::toolpath
