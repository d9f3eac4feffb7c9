// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/segment_tree.hpp"

#include "wcam/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wcam::geometry {

namespace {
constexpr std::uint32_t kLeafSize = 4;
/// A balanced tree of 2^32 leaves has depth 32; each level leaves one node on the stack.
constexpr std::size_t kStack = 64;

double squaredDistanceToBox(const Vec3& p, const Box& box) {
  return (box.min - p).cwiseMax(p - box.max).cwiseMax(0.0).squaredNorm();
}

/// Part of the way from a to b of the point nearest to p.
double footOn(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double length2 = ab.squaredNorm();
  return length2 > 0.0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
}
}  // namespace

double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  return (p - (a + footOn(p, a, b) * (b - a))).norm();
}

void SegmentTree::add(const Vec3& a, const Vec3& b) {
  segments_.push_back({a, b, static_cast<std::uint32_t>(segments_.size())});
}

void SegmentTree::add(const std::vector<Vec3>& polyline, bool closed) {
  if (polyline.size() == 1) {
    add(polyline[0], polyline[0]);
  }
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    add(polyline[i], polyline[i + 1]);
  }
  if (closed && polyline.size() > 2) {
    add(polyline.back(), polyline.front());
  }
}

void SegmentTree::build() {
  nodes_.clear();
  if (!segments_.empty()) {
    nodes_.reserve(2 * segments_.size() / kLeafSize + 2);
    buildNode(0, static_cast<std::uint32_t>(segments_.size()));
  }
}

std::uint32_t SegmentTree::buildNode(std::uint32_t begin, std::uint32_t end) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box box;
  Box centres;
  for (std::uint32_t i = begin; i < end; ++i) {
    box.add(segments_[i].a);
    box.add(segments_[i].b);
    centres.add(0.5 * (segments_[i].a + segments_[i].b));
  }
  std::uint32_t right = 0;
  if (end - begin > kLeafSize) {
    int axis = 0;
    (centres.max - centres.min).maxCoeff(&axis);
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(segments_.begin() + begin, segments_.begin() + middle, segments_.begin() + end,
                     [axis](const auto& s, const auto& t) {
                       return s.a[axis] + s.b[axis] < t.a[axis] + t.b[axis];
                     });
    buildNode(begin, middle);
    right = buildNode(middle, end);
  }
  nodes_[index] = Node{box, begin, end, right};
  return index;
}

namespace {
constexpr auto kEverySegment = [](std::uint32_t) { return true; };
}  // namespace

double SegmentTree::distance(const Vec3& p, double atMost) const {
  return find(p, atMost, kEverySegment).distance;
}

Vec3 SegmentTree::nearest(const Vec3& p) const {
  if (segments_.empty()) {
    return p;
  }
  const Nearest found = nearestSegment(p);
  return found.a + found.fraction * (found.b - found.a);
}

SegmentTree::Nearest SegmentTree::nearestSegment(const Vec3& p) const {
  WCAM_ASSERT(!segments_.empty());
  const Segment& s =
      segments_[find(p, std::numeric_limits<double>::infinity(), kEverySegment).segment];
  return {s.a, s.b, footOn(p, s.a, s.b), s.number};
}

std::optional<Vec3> SegmentTree::nearestWithin(const Vec3& p,
                                               double within,
                                               const Filter& counts) const {
  const Found found = counts ? find(p, within, counts) : find(p, within, kEverySegment);
  if (!(found.distance < within)) {
    return std::nullopt;
  }
  const Segment& s = segments_[found.segment];
  return s.a + footOn(p, s.a, s.b) * (s.b - s.a);
}

template <class Counts>
SegmentTree::Found SegmentTree::find(const Vec3& p, double atMost, const Counts& counts) const {
  Found best{atMost, 0};
  if (segments_.empty()) {
    return best;
  }
  WCAM_ASSERT(!nodes_.empty());
  std::array<std::uint32_t, kStack> stack{};
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Node& node = nodes_[stack[--depth]];
    if (squaredDistanceToBox(p, node.box) > best.distance * best.distance) {
      continue;
    }
    if (node.right == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        const Segment& segment = segments_[i];
        const double distance = distanceToSegment(p, segment.a, segment.b);
        if (distance < best.distance && counts(segment.number)) {
          best = {distance, i};
        }
      }
      continue;
    }
    const auto left = static_cast<std::uint32_t>(&node - nodes_.data()) + 1;
    const bool leftFirst = squaredDistanceToBox(p, nodes_[left].box) <=
                           squaredDistanceToBox(p, nodes_[node.right].box);
    stack[depth++] = leftFirst ? node.right : left;
    stack[depth++] = leftFirst ? left : node.right;
  }
  return best;
}

}  // namespace wcam::geometry
