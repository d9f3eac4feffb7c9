// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/types.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace wcam::geometry {

double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b);

/// Nearest-segment queries over polylines: distances to the layer below. Flat balanced box tree;
/// building costs O(n log n), a query about O(log n). const queries are thread-safe.
class SegmentTree {
public:
  /// Adds the segments of a polyline; a single point counts as a segment of length zero.
  void add(const std::vector<Vec3>& polyline, bool closed);
  void add(const Vec3& a, const Vec3& b);
  /// Must be called once after the last add().
  void build();

  [[nodiscard]] bool empty() const noexcept { return segments_.empty(); }

  /// Distance to the nearest segment (feet inside, or its ends), infinity when there is none. What
  /// is farther than `atMost` is not looked for: then this bound is the answer.
  [[nodiscard]] double distance(const Vec3& p,
                                double atMost = std::numeric_limits<double>::infinity()) const;

  /// Ends of the nearest segment, in the order of its polyline, and the part of the way between
  /// them at which the nearest point lies.
  struct Nearest {
    Vec3 a = Vec3::Zero();
    Vec3 b = Vec3::Zero();
    double fraction = 0.0;
    std::uint32_t number = 0;  ///< in the order of adding
  };

  /// There must be a segment.
  [[nodiscard]] Nearest nearestSegment(const Vec3& p) const;

  /// Nearest point on the segments; p itself when there is none.
  [[nodiscard]] Vec3 nearest(const Vec3& p) const;

  /// Which segments count, by their number in the order of adding.
  using Filter = std::function<bool(std::uint32_t)>;

  /// Nearest point on the segments that is nearer than `within`; nothing when there is none.
  [[nodiscard]] std::optional<Vec3> nearestWithin(const Vec3& p,
                                                  double within,
                                                  const Filter& counts = {}) const;

private:
  struct Node {
    Box box;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t right = 0;  ///< right child; the left one follows its parent. 0 for a leaf
  };

  struct Found {
    double distance;
    std::uint32_t segment;
  };

  struct Segment {
    Vec3 a;
    Vec3 b;
    std::uint32_t number;  ///< in the order of adding
  };

  template <class Counts>
  [[nodiscard]] Found find(const Vec3& p, double atMost, const Counts& counts) const;
  std::uint32_t buildNode(std::uint32_t begin, std::uint32_t end);

  std::vector<Segment> segments_;
  std::vector<Node> nodes_;
};

}  // namespace wcam::geometry
