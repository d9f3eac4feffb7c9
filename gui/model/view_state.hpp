// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "path_model.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace wcam::gui {

/// What is looked at: layers, the present move, playback, colours, the selection. One object, of
/// which sliders, 3D view, plots and program text are views. Not part of the document, so never
/// undone. Belongs to one thread.
class ViewState {
public:
  enum Change : unsigned {
    PathChanged = 1U,
    LayersChanged = 2U,
    MoveChanged = 4U,
    ColourChanged = 8U,
    PlayingChanged = 16U,
    SelectionChanged = 32U
  };

  using Listener = std::function<void(unsigned changes)>;
  int listen(Listener listener);
  void forget(int id);

  /// Shows another path. Layers and move stay when the path has as many layers as the one before.
  void setPath(std::shared_ptr<const PathModel> path);

  [[nodiscard]] const std::shared_ptr<const PathModel>& path() const { return path_; }

  [[nodiscard]] int layerCount() const { return path_ ? path_->layerCount() : 0; }

  [[nodiscard]] int lower() const { return lower_; }

  [[nodiscard]] int upper() const { return upper_; }

  [[nodiscard]] bool single() const { return single_; }

  /// Clamped and ordered; in single mode the upper one counts. The present move becomes the last
  /// one.
  void setLayers(int lower, int upper);
  void setSingle(bool single);

  /// Moves [begin, end) of the layers that are shown.
  [[nodiscard]] std::size_t begin() const;
  [[nodiscard]] std::size_t end() const;

  /// The last move that is shown, inside [begin, end).
  [[nodiscard]] std::size_t move() const { return move_; }

  void setMove(std::size_t move);
  /// Like setMove, and widens the layers when the move lies outside of them.
  void jumpTo(std::size_t move);

  [[nodiscard]] double time() const { return time_; }

  void setTime(double time);

  [[nodiscard]] bool playing() const { return playing_; }

  [[nodiscard]] double speed() const { return speed_; }

  /// Starts again from the beginning when the end was reached.
  void setPlaying(bool playing);
  void setSpeed(double factor);
  /// Plays on for a time of the clock; stops at the end.
  void advance(double seconds);

  [[nodiscard]] Quantity colour() const { return colour_; }

  void setColour(Quantity quantity);

  /// Limits of the colours; none: those of the values.
  [[nodiscard]] const std::optional<std::pair<float, float>>& range() const { return range_; }

  void setRange(std::optional<std::pair<float, float>> range);

  /// The move that the user picked.
  [[nodiscard]] const std::optional<std::size_t>& selected() const { return selected_; }

  void select(std::optional<std::size_t> move);

private:
  void tell(unsigned changes);
  void place(std::size_t move);

  std::map<int, Listener> listeners_;
  int nextListener_ = 1;
  std::shared_ptr<const PathModel> path_;
  int lower_ = 0;
  int upper_ = 0;
  bool single_ = false;
  std::size_t move_ = 0;
  double time_ = 0.0;
  bool playing_ = false;
  double speed_ = 1.0;
  Quantity colour_ = Quantity::Layer;
  std::optional<std::pair<float, float>> range_;
  std::optional<std::size_t> selected_;
};

}  // namespace wcam::gui
