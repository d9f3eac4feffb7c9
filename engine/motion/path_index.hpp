// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/toolpath/toolpath.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace wcam::motion::detail {

/// Numbers of the points of a toolpath in order, over all layers and beads (CellState::deposited
/// counts them), and back.
class PathIndex {
public:
  struct Place {
    int layer = -1;
    int bead = -1;
    int point = -1;
  };

  explicit PathIndex(const toolpath::Toolpath& path) {
    std::size_t begin = 0;
    for (std::size_t l = 0; l < path.layers.size(); ++l) {
      firstBead_.push_back(begins_.size());
      for (std::size_t b = 0; b < path.layers[l].beads.size(); ++b) {
        begins_.push_back(begin);
        places_.push_back({static_cast<int>(l), static_cast<int>(b), 0});
        begin += path.layers[l].beads[b].points.size();
      }
    }
  }

  [[nodiscard]] std::size_t number(int layer, int bead, int point) const {
    return begins_[firstBead_[static_cast<std::size_t>(layer)] + static_cast<std::size_t>(bead)] +
           static_cast<std::size_t>(point);
  }

  [[nodiscard]] Place place(std::size_t number) const {
    // The last bead that begins at or before the number; beads without points begin with the next.
    const auto after = std::upper_bound(begins_.begin(), begins_.end(), number);
    if (after == begins_.begin()) {
      return {};
    }
    const auto k = static_cast<std::size_t>(after - begins_.begin()) - 1;
    Place found = places_[k];
    found.point = static_cast<int>(number - begins_[k]);
    return found;
  }

private:
  std::vector<std::size_t> firstBead_;
  std::vector<std::size_t> begins_;
  std::vector<Place> places_;
};

}  // namespace wcam::motion::detail
