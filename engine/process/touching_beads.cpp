// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "touching_beads.hpp"

#include "wcam/base/parallel.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/geometry/segment_tree.hpp"
#include "wcam/process/process.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wcam::process {

namespace {

using geometry::Vec3;
using toolpath::Bead;
using toolpath::BeadFeature;
using toolpath::BeadZone;
using toolpath::Layer;
using toolpath::PathPoint;

/// A segment of a bead in the tree.
struct Place {
  std::uint32_t bead = 0;
  double along = 0.0;  ///< arc length at its middle
};

/// Half a turn to the other side of a bead, in widths: nearer along the bead is no neighbour.
constexpr double kTurn = 0.5 * kPi;
/// To which a bisector is found, in widths.
constexpr double kFoot = 1e-4;
/// Nearer than this, in widths, a bead runs over another one instead of beside it.
constexpr double kSame = 0.02;
/// Ding's parabola over a width, in parts of width times height.
constexpr double kParabola = 2.0 / 3.0;

class LayerSharer {
public:
  LayerSharer(const Layer& layer, double width) : layer_(layer), width_(width) {
    for (std::uint32_t b = 0; b < layer.beads.size(); ++b) {
      const Bead& bead = layer.beads[b];
      std::vector<double> along{0.0};
      for (std::size_t i = 1; i < bead.points.size(); ++i) {
        const Vec3& from = bead.points[i - 1].p;
        const Vec3& to = bead.points[i].p;
        along.push_back(along.back() + (to - from).norm());
        if (bead.points[i].arc && bead.points[i].zone == BeadZone::Body) {
          tree_.add(from, to);
          places_.push_back({b, 0.5 * (along[i - 1] + along[i])});
        }
      }
      along_.push_back(std::move(along));
    }
    tree_.build();
  }

  /// @return widths to fill, per point of a bead; 0 where it has no neighbour. Before and after its
  /// body a bead keeps the width of the body's ends.
  [[nodiscard]] std::vector<double> widthsOf(std::uint32_t b) const {
    const std::vector<PathPoint>& points = layer_.beads[b].points;
    const auto isBody = [](const PathPoint& point) { return point.zone == BeadZone::Body; };
    const auto begin = std::find_if(points.begin(), points.end(), isBody) - points.begin();
    const auto end = points.rend() - std::find_if(points.rbegin(), points.rend(), isBody);
    std::vector<double> widths(points.size(), 0.0);
    for (auto i = begin; i < end; ++i) {
      widths[static_cast<std::size_t>(i)] = widthAt(b, static_cast<std::size_t>(i));
    }
    if (begin < end) {
      std::fill(widths.begin(), widths.begin() + begin, widths[static_cast<std::size_t>(begin)]);
      std::fill(widths.begin() + end, widths.end(), widths[static_cast<std::size_t>(end - 1)]);
    }
    return widths;
  }

private:
  [[nodiscard]] double widthAt(std::uint32_t b, std::size_t i) const {
    const Bead& bead = layer_.beads[b];
    const PathPoint& point = bead.points[i];
    const double width = point.width > 0.0 ? point.width : width_;
    const double left = toBisector(point, point.n, width, b, i);
    const double right = toBisector(point, -point.n, width, b, i);
    const double half = 0.5 * width;
    if (left >= half && right >= half) {
      return 0.0;
    }
    const double free =
        bead.feature == BeadFeature::Cladding ? kParabola * half : freeWall(point.height, width);
    return (left < half ? left : free) + (right < half ? right : free);
  }

  [[nodiscard]] static double freeWall(double height, double width) {
    return height > 0.0 ? 0.5 * wallSection(height, width) / std::min(height, width) : 0.5 * width;
  }

  /// Distance along a direction to the middle between the bead and a neighbour, at most half a
  /// width. The ball that touches the point and a neighbour shrinks until it holds nothing else.
  [[nodiscard]] double toBisector(const PathPoint& point,
                                  const Vec3& side,
                                  double width,
                                  std::uint32_t b,
                                  std::size_t i) const {
    const double foot = kFoot * width;
    const double here = along_[b][i];
    const double whole = along_[b].back();
    const bool closed = layer_.beads[b].closed;
    const auto isNeighbour = [&](std::uint32_t segment) {
      const Place& place = places_[segment];
      if (place.bead != b) {
        return true;
      }
      const double apart = std::abs(place.along - here);
      return (closed ? std::min(apart, whole - apart) : apart) > kTurn * width;
    };
    double reach = 0.5 * width;
    constexpr int kShrinks = 32;
    for (int k = 0; k < kShrinks; ++k) {
      const auto nearest = tree_.nearestWithin(point.p + reach * side, reach - foot, isNeighbour);
      if (!nearest) {
        break;
      }
      const Vec3 away = *nearest - point.p;
      const double ahead = side.dot(away);
      if (away.norm() < kSame * width || !(ahead > 0.0)) {
        break;
      }
      reach = std::min(reach, 0.5 * away.squaredNorm() / ahead);
    }
    return reach;
  }

  const Layer& layer_;
  double width_;
  geometry::SegmentTree tree_;
  std::vector<Place> places_;
  std::vector<std::vector<double>> along_;
};

void share(Layer& layer, double width) {
  const auto isFilled = [](const Bead& bead) {
    return std::any_of(bead.points.begin(), bead.points.end(),
                       [](const PathPoint& point) { return point.fillWidth > 0.0; });
  };
  const LayerSharer sharer(layer, width);
  std::vector<std::vector<double>> widths(layer.beads.size());
  for (std::uint32_t b = 0; b < layer.beads.size(); ++b) {
    if (layer.beads[b].revolutions == 0 && !isFilled(layer.beads[b])) {
      widths[b] = sharer.widthsOf(b);
    }
  }
  for (std::size_t b = 0; b < widths.size(); ++b) {
    for (std::size_t i = 0; i < widths[b].size(); ++i) {
      layer.beads[b].points[i].fillWidth = widths[b][i];
    }
  }
}

}  // namespace

void shareTouchingBeads(toolpath::Toolpath& path, double width, const JobContext& context) {
  parallelFor(
      path.layers.size(), 1, [&](std::size_t l) { share(path.layers[l], width); }, context);
}

}  // namespace wcam::process
