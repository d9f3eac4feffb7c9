// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/error.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace wcam::io {

/// Joins points that are equal bit by bit (−0 counts as 0): open addressing with linear probing.
/// The points must be finite. Indices follow the order of first appearance.
template <class Real>
class PointWelder {
public:
  using Point = std::array<Real, 3>;

  /// @param expectedPoints a guess of the number of different points
  explicit PointWelder(std::size_t expectedPoints) {
    points_.reserve(expectedPoints);
    resizeTable(std::bit_ceil(2 * expectedPoints + kMinSlots));
  }

  /// Tag of a point: decides its slot. Normalises −0 in place.
  static std::uint32_t tagOf(Point& point) {
    std::uint64_t hash = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      point[k] += Real(0);  // −0 + 0 = +0
      hash = (hash ^ std::bit_cast<Bits>(point[k])) * kMultiplier;
      hash ^= hash >> 29U;
    }
    hash *= kMultiplier;
    return static_cast<std::uint32_t>(hash >> 32U);
  }

  /// Asks the memory for the slot of a point that is added soon.
  void prefetch(std::uint32_t tag) const { __builtin_prefetch(&slots_[tag >> shift_]); }

  /// @param point normalised by tagOf
  std::uint32_t add(const Point& point, std::uint32_t tag) {
    for (std::size_t slot = tag >> shift_;; slot = (slot + 1) & mask_) {
      const Slot entry = slots_[slot];
      if (entry.index == kFree) {
        const auto index = static_cast<std::uint32_t>(points_.size());
        slots_[slot] = {tag, index};
        points_.push_back(point);
        if (10 * points_.size() > 7 * slots_.size()) {
          grow();
        }
        return index;
      }
      if (entry.tag == tag &&
          std::memcmp(points_[entry.index].data(), point.data(), sizeof(Point)) == 0) {
        return entry.index;
      }
    }
  }

  std::uint32_t add(Point point) {
    const std::uint32_t tag = tagOf(point);
    return add(point, tag);
  }

  [[nodiscard]] const std::vector<Point>& points() const noexcept { return points_; }

private:
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

  struct Slot {
    std::uint32_t tag;
    std::uint32_t index;
  };

  static constexpr std::uint32_t kFree = 0xFFFFFFFFU;
  static constexpr std::size_t kMinSlots = 64;
  static constexpr std::uint64_t kMultiplier = 0x9E3779B97F4A7C15U;

  void resizeTable(std::size_t slots) {
    WCAM_ASSERT(slots <= (std::size_t{1} << 32U));
    slots_.assign(slots, Slot{0, kFree});
    mask_ = slots - 1;
    shift_ = 32U - static_cast<unsigned>(std::countr_zero(slots));
  }

  void grow() {
    std::vector<Slot> old;
    old.swap(slots_);
    resizeTable(2 * old.size());
    for (const Slot& entry : old) {
      if (entry.index != kFree) {
        std::size_t slot = entry.tag >> shift_;
        while (slots_[slot].index != kFree) {
          slot = (slot + 1) & mask_;
        }
        slots_[slot] = entry;
      }
    }
  }

  std::vector<Point> points_;
  std::vector<Slot> slots_;
  std::size_t mask_ = 0;
  unsigned shift_ = 0;
};

}  // namespace wcam::io
