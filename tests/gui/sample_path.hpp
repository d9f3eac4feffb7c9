// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/path_model.hpp"

#include <memory>

namespace wcam::gui::test {

/// A path without a motion: `layers` straight beads of `points` points, one second and 2 mm from
/// point to point; the height of layer k is k + 1 mm.
inline std::shared_ptr<const PathModel> samplePath(int layers, int points) {
  auto path = std::make_shared<toolpath::Toolpath>();
  double time = 0.0;
  for (int l = 0; l < layers; ++l) {
    toolpath::Bead bead;
    for (int i = 0; i < points; ++i) {
      toolpath::PathPoint point;
      point.p = {2.0 * i, 0.0, static_cast<double>(l)};
      point.height = l + 1;
      point.width = 6.0;
      point.speed = 2.0;
      bead.points.push_back(point);
      time += 1.0;
    }
    toolpath::Layer layer;
    layer.beads.push_back(bead);
    path->layers.push_back(layer);
  }
  auto result = std::make_shared<project::OperationResult>();
  result->id = "sample";
  // A second passes from bead to bead as well: the first point of a bead is reached from the last
  // one.
  for (std::size_t l = 1; l < path->layers.size(); ++l) {
    path->layers[l].beads[0].points[0].speed = 2.0;
  }
  result->path = path;
  return std::make_shared<const PathModel>(result);
}

}  // namespace wcam::gui::test
