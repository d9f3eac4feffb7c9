// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "view_state.hpp"

#include <algorithm>

namespace wcam::gui {

int ViewState::listen(Listener listener) {
  listeners_.emplace(nextListener_, std::move(listener));
  return nextListener_++;
}

void ViewState::forget(int id) {
  listeners_.erase(id);
}

void ViewState::tell(unsigned changes) {
  // A listener may stop listening, or change the state again.
  const auto listeners = listeners_;
  for (const auto& [id, listener] : listeners) {
    listener(changes);
  }
}

void ViewState::setPath(std::shared_ptr<const PathModel> path) {
  const bool same = path_ && path && path->size() > 0 && path->layerCount() == path_->layerCount();
  const bool atEnd = !path_ || path_->size() == 0 || move_ + 1 >= end();
  path_ = std::move(path);
  selected_.reset();
  range_.reset();
  if (!same) {
    lower_ = 0;
    upper_ = std::max(layerCount() - 1, 0);
    playing_ = false;
  }
  if (!same || atEnd || move_ < begin() || move_ >= end()) {
    move_ = end() > 0 ? end() - 1 : 0;
  }
  time_ = path_ && path_->size() > 0 ? path_->time(move_) : 0.0;
  tell(PathChanged | LayersChanged | MoveChanged | ColourChanged | PlayingChanged |
       SelectionChanged);
}

std::size_t ViewState::begin() const {
  return layerCount() > 0 ? path_->layerBegin(lower_) : 0;
}

std::size_t ViewState::end() const {
  return layerCount() > 0 ? path_->layerBegin(upper_ + 1) : 0;
}

void ViewState::setLayers(int lower, int upper) {
  const int last = std::max(layerCount() - 1, 0);
  lower = std::clamp(lower, 0, last);
  upper = std::clamp(upper, 0, last);
  if (lower > upper) {
    std::swap(lower, upper);
  }
  if (single_) {
    lower = upper;
  }
  if (lower == lower_ && upper == upper_) {
    return;
  }
  lower_ = lower;
  upper_ = upper;
  place(end() > 0 ? end() - 1 : 0);
  tell(LayersChanged | MoveChanged);
}

void ViewState::setSingle(bool single) {
  if (single == single_) {
    return;
  }
  single_ = single;
  lower_ = single ? upper_ : 0;
  place(end() > 0 ? end() - 1 : 0);
  tell(LayersChanged | MoveChanged);
}

void ViewState::place(std::size_t move) {
  move_ = end() > begin() ? std::clamp(move, begin(), end() - 1) : begin();
  time_ = path_ && move_ < path_->size() ? path_->time(move_) : 0.0;
}

void ViewState::setMove(std::size_t move) {
  const std::size_t before = move_;
  place(move);
  if (move_ != before) {
    tell(MoveChanged);
  }
}

void ViewState::jumpTo(std::size_t move) {
  if (!path_ || move >= path_->size()) {
    return;
  }
  if (move < begin() || move >= end()) {
    const int layer = path_->layer(move);
    setLayers(single_ ? layer : std::min(lower_, layer), std::max(layer, single_ ? 0 : upper_));
    if (single_ && upper_ != layer) {
      setLayers(layer, layer);
    }
  }
  setMove(move);
  select(move);
}

void ViewState::setTime(double time) {
  if (!path_ || path_->size() == 0) {
    return;
  }
  const std::size_t before = move_;
  place(path_->moveAt(time));
  time_ = std::clamp(time, path_->time(begin()), path_->time(end() - 1));
  if (move_ != before) {
    tell(MoveChanged);
  }
}

void ViewState::setPlaying(bool playing) {
  if (playing == playing_ || (playing && (!path_ || path_->size() == 0))) {
    return;
  }
  playing_ = playing;
  if (playing && move_ + 1 >= end()) {
    setMove(begin());
  }
  tell(PlayingChanged);
}

void ViewState::setSpeed(double factor) {
  if (factor != speed_) {
    speed_ = factor;
    tell(PlayingChanged);
  }
}

void ViewState::advance(double seconds) {
  if (!playing_ || !path_ || path_->size() == 0) {
    return;
  }
  setTime(time_ + seconds * speed_);
  if (move_ + 1 >= end() && time_ >= path_->time(end() - 1)) {
    setPlaying(false);
  }
}

void ViewState::setColour(Quantity quantity) {
  if (quantity != colour_) {
    colour_ = quantity;
    range_.reset();
    tell(ColourChanged);
  }
}

void ViewState::setRange(std::optional<std::pair<float, float>> range) {
  if (range != range_) {
    range_ = range;
    tell(ColourChanged);
  }
}

void ViewState::select(std::optional<std::size_t> move) {
  if (move != selected_) {
    selected_ = move;
    tell(SelectionChanged);
  }
}

}  // namespace wcam::gui
