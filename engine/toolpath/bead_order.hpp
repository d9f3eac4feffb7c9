// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "seam.hpp"

#include <vector>

namespace wcam::toolpath {

/// A contour that starts at its seam, in the direction in which it is deposited.
struct OrderedContour {
  Contour contour;
  bool reversed = false;  ///< against the direction that the strategy gave
};

/// Orders the contours of each layer and turns closed ones so that they start at their seam. Keeps
/// where the last bead ended, and what was deposited when, from layer to layer.
class BeadOrder {
public:
  BeadOrder(const PathParams& params, const Substrate& substrate);

  /// @param asGiven keep order, starts and directions
  std::vector<OrderedContour> arrange(const SlicedLayer& layer,
                                      std::size_t layerIndex,
                                      bool asGiven);

  [[nodiscard]] SeamChooser& seams() noexcept { return seams_; }

private:
  /// A deposited bead, coarsely.
  struct Deposited {
    std::vector<Vec3> samples;
    double length = 0.0;
    double end = 0.0;  ///< length deposited when it was finished
    std::size_t sequence = 0;
  };

  struct Candidate {
    std::size_t index = 0;
    bool reversed = false;
  };

  [[nodiscard]] bool runsBack(const Contour& contour, std::size_t layerIndex, bool asGiven) const;
  [[nodiscard]] Candidate next(const SlicedLayer& layer,
                               const std::vector<std::size_t>& open,
                               std::size_t layerIndex,
                               const std::vector<double>& ranks) const;
  [[nodiscard]] double approach(const Contour& contour, bool& reversed) const;
  [[nodiscard]] double heatFrom(const Deposited& bead, const std::vector<Vec3>& samples) const;
  void startHeat(const SlicedLayer& layer);
  void addHeat(const Deposited& bead);
  [[nodiscard]] std::vector<double> ranksOf(const SlicedLayer& layer) const;
  void deposit(const Contour& contour);

  PathParams params_;
  SeamChooser seams_;
  std::optional<Vec3> lastEnd_;
  std::vector<Deposited> below_;            ///< beads of the last layer that had some
  std::vector<Deposited> current_;          ///< beads of the layer at work
  std::vector<Deposited> warm_;             ///< beads whose heat still counts
  std::vector<double> heat_;                ///< at each contour of the layer at work
  std::vector<std::vector<Vec3>> samples_;  ///< of each of them
  double length_ = 0.0;
  std::size_t count_ = 0;
};

}  // namespace wcam::toolpath
