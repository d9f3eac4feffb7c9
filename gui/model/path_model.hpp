// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/project/pipeline.hpp"

#include "viewport/prepared.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wcam::gui {

/// What a colour, a plot or a tooltip can show of a move. Units: mm, mm/s, m/min, degrees.
enum class Quantity {
  Layer,
  Feature,
  Height,
  Distance,
  Width,
  TravelSpeed,
  TcpSpeed,
  WireSpeed,
  Tilt,
  Overhang,
  ReachMargin,
  Singularity,
  LimitMargin,
  Clearance,
  Finding,
  Time
};

inline constexpr int kQuantityCount = 16;

/// Unit of a quantity, "" for counts.
const char* unitOf(Quantity quantity) noexcept;

/// The moves of one operation as flat arrays, the one index that slider, playback, 3D view, plots
/// and program text share. Moves are the waypoints of the motion; without a motion, the points of
/// the path. Immutable; made in the background.
class PathModel {
public:
  explicit PathModel(std::shared_ptr<const project::OperationResult> result);

  [[nodiscard]] const project::OperationResult& result() const { return *result_; }

  [[nodiscard]] std::size_t size() const { return layer_.size(); }

  [[nodiscard]] int layerCount() const { return static_cast<int>(layerBegin_.size()) - 1; }

  /// Moves [layerBegin(k), layerBegin(k + 1)) belong to layer k, with the way to it.
  [[nodiscard]] std::size_t layerBegin(int layer) const {
    return layerBegin_[static_cast<std::size_t>(layer)];
  }

  [[nodiscard]] int layer(std::size_t move) const { return layer_[move]; }

  /// −1 for moves between beads.
  [[nodiscard]] int bead(std::size_t move) const { return bead_[move]; }

  [[nodiscard]] int point(std::size_t move) const { return point_[move]; }

  /// s from the start of the operation, at the end of the move.
  [[nodiscard]] double time(std::size_t move) const { return time_[move]; }

  [[nodiscard]] double totalTime() const { return time_.empty() ? 0.0 : time_.back(); }

  /// The move that is being made at a time.
  [[nodiscard]] std::size_t moveAt(double time) const;
  /// The move that ends at a point; the nearest one when a place leaves out bead or point.
  [[nodiscard]] std::optional<std::size_t> find(int layer, int bead, int point) const;
  [[nodiscard]] const toolpath::PathPoint* pathPoint(std::size_t move) const;
  [[nodiscard]] const motion::Waypoint* waypoint(std::size_t move) const;
  [[nodiscard]] viewport::Point position(std::size_t move) const;

  /// One number per move; NaN where there is none.
  [[nodiscard]] std::vector<float> values(Quantity quantity) const;

  [[nodiscard]] const std::shared_ptr<const viewport::PathData>& data() const { return data_; }

  /// Ready for the 3D view; for one view at a time.
  [[nodiscard]] const std::shared_ptr<viewport::PreparedPath>& prepared() const {
    return prepared_;
  }

private:
  void addMove(int layer,
               int bead,
               int point,
               double time,
               const toolpath::PathPoint* like,
               const geometry::Vec3& p,
               bool deposits,
               viewport::PathData& data);
  void fromMotion(viewport::PathData& data);
  void fromPath(viewport::PathData& data);
  [[nodiscard]] std::vector<float> findings() const;

  std::shared_ptr<const project::OperationResult> result_;
  std::shared_ptr<const viewport::PathData> data_;
  std::shared_ptr<viewport::PreparedPath> prepared_;
  std::vector<std::int32_t> layer_;
  std::vector<std::int32_t> bead_;
  std::vector<std::int32_t> point_;
  std::vector<double> time_;
  std::vector<std::size_t> layerBegin_;
};

}  // namespace wcam::gui
