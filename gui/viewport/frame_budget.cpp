// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "frame_budget.hpp"

#include <algorithm>

namespace wcam::viewport {

void FrameBudget::drawn(double triangles, double seconds) {
  // More than any machine draws; keeps the number finite.
  constexpr double kMost = 1e9;
  constexpr double kSteadiest = 0.25;
  constexpr double kQuickest = 1.5;
  if (seconds > kFrame) {
    // One slow frame may have had to wait for a processor.
    capacity_ *= std::max(kFrame / seconds, kSteadiest);
  } else if (triangles > 0.5 * capacity_) {
    // Nothing is learnt about many triangles from a few.
    capacity_ *= seconds > 0.0 ? std::min(kFrame / seconds, kQuickest) : kQuickest;
  }
  capacity_ = std::clamp(capacity_, kLeast, kMost);
}

}  // namespace wcam::viewport
