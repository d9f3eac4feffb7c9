// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/layer_distance.hpp"

#include "wcam/base/parallel.hpp"
#include "wcam/geometry/segment_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath {

namespace {

constexpr std::size_t kGrain = 1024;

}  // namespace

std::vector<double> layerDistance(const std::vector<Vec3>& points,
                                  const std::vector<const Contour*>& below) {
  geometry::SegmentTree tree;
  for (const Contour* contour : below) {
    std::vector<Vec3> polyline;
    polyline.reserve(contour->points.size());
    for (const ContourPoint& point : contour->points) {
      polyline.push_back(point.p);
    }
    tree.add(polyline, contour->closed);
  }
  tree.build();
  std::vector<double> distance(points.size());
  parallelFor(points.size(), kGrain,
              [&](std::size_t i) { distance[i] = tree.distance(points[i]); });
  return distance;
}

std::vector<double> layerDistance(const std::vector<Vec3>& points,
                                  const std::vector<Contour>& below) {
  std::vector<const Contour*> contours;
  contours.reserve(below.size());
  for (const Contour& contour : below) {
    contours.push_back(&contour);
  }
  return layerDistance(points, contours);
}

namespace {

/// Revolution, with its fraction by arc length, of every point. Points before turns[0] count as of
/// the first revolution; the last revolution is as long as the one before it, when there is one,
/// since a bead may end anywhere in it.
std::vector<double> revolutions(const std::vector<Vec3>& points,
                                const std::vector<std::size_t>& turns) {
  std::vector<double> length(points.size(), 0.0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    length[i] = length[i - 1] + (points[i] - points[i - 1]).norm();
  }
  std::vector<double> revolution(points.size(), 0.0);
  double before = 0.0;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    const std::size_t first = std::min(turns[k], points.size() - 1);
    const bool last = k + 1 == turns.size();
    const std::size_t end = last ? points.size() : std::min(turns[k + 1], points.size());
    const double own = length[std::min(end, points.size() - 1)] - length[first];
    const double whole = last ? std::max(own, before) : own;
    for (std::size_t i = first; i < end; ++i) {
      revolution[i] =
          static_cast<double>(k) + (whole > 0.0 ? (length[i] - length[first]) / whole : 0.0);
    }
    before = own;
  }
  return revolution;
}

}  // namespace

std::vector<double> revolutionDistance(const std::vector<Vec3>& points,
                                       const std::vector<std::size_t>& turns) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<double> distance(points.size(), kInfinity);
  if (points.empty() || turns.empty()) {
    return distance;
  }
  const std::vector<double> revolution = revolutions(points, turns);
  // Trees over pieces of the bead: a window takes the pieces it meets, exact to one piece.
  constexpr double kPiecesPerTurn = 8.0;
  constexpr double kWindowBegin = 1.5;
  constexpr double kWindowEnd = 0.5;
  const auto pieceOf = [](double rev) {
    return static_cast<std::size_t>(std::max(0.0, std::floor(rev * kPiecesPerTurn)));
  };
  std::vector<geometry::SegmentTree> trees(pieceOf(revolution.back()) + 1);
  std::size_t begin = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const std::size_t piece = pieceOf(revolution[i - 1]);
    if (i + 1 == points.size() || pieceOf(revolution[i]) != piece) {
      trees[piece].add({points.begin() + static_cast<std::ptrdiff_t>(begin),
                        points.begin() + static_cast<std::ptrdiff_t>(i) + 1},
                       false);
      begin = i;
    }
  }
  for (geometry::SegmentTree& tree : trees) {
    tree.build();
  }
  parallelFor(points.size(), kGrain, [&](std::size_t i) {
    if (revolution[i] < 1.0) {
      return;
    }
    // The piece one revolution back first: it bounds the search in the others.
    distance[i] = trees[pieceOf(revolution[i] - 1.0)].distance(points[i]);
    const std::size_t last = pieceOf(revolution[i] - kWindowEnd);
    for (std::size_t k = pieceOf(revolution[i] - kWindowBegin); k <= last && k < trees.size();
         ++k) {
      distance[i] = std::min(distance[i], trees[k].distance(points[i], distance[i]));
    }
  });
  return distance;
}

}  // namespace wcam::toolpath
