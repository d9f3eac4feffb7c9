// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace wcam::bench {

/// Wall-clock times of one side of a comparison, seconds. The repetitions of both sides are to be
/// interleaved, so that a change of the machine's speed meets both.
class Times {
public:
  /// Runs and times `work`; what it returns is passed on, so that freeing it is not counted.
  template <class Work>
  auto measure(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    auto result = work();
    seconds_.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    return result;
  }

  /// The first call: fresh memory, cold caches.
  [[nodiscard]] double first() const { return seconds_.front(); }

  [[nodiscard]] double min() const { return *std::min_element(seconds_.begin(), seconds_.end()); }

  [[nodiscard]] double median() const {
    std::vector<double> sorted = seconds_;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
  }

private:
  std::vector<double> seconds_;
};

}  // namespace wcam::bench
