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

void SegmentTree::add(const std::vector<Vec3>& polyline, bool closed) {
  if (polyline.size() == 1) {
    segments_.push_back({polyline[0], polyline[0]});
  }
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    segments_.push_back({polyline[i], polyline[i + 1]});
  }
  if (closed && polyline.size() > 2) {
    segments_.push_back({polyline.back(), polyline.front()});
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
    box.add(segments_[i][0]);
    box.add(segments_[i][1]);
    centres.add(0.5 * (segments_[i][0] + segments_[i][1]));
  }
  std::uint32_t right = 0;
  if (end - begin > kLeafSize) {
    int axis = 0;
    (centres.max - centres.min).maxCoeff(&axis);
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(segments_.begin() + begin, segments_.begin() + middle, segments_.begin() + end,
                     [axis](const auto& s, const auto& t) {
                       return s[0][axis] + s[1][axis] < t[0][axis] + t[1][axis];
                     });
    buildNode(begin, middle);
    right = buildNode(middle, end);
  }
  nodes_[index] = Node{box, begin, end, right};
  return index;
}

double SegmentTree::distance(const Vec3& p, double atMost) const {
  return find(p, atMost).distance;
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
  const auto& [a, b] = segments_[find(p, std::numeric_limits<double>::infinity()).segment];
  return {a, b, footOn(p, a, b)};
}

SegmentTree::Found SegmentTree::find(const Vec3& p, double atMost) const {
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
        const double distance = distanceToSegment(p, segments_[i][0], segments_[i][1]);
        if (distance < best.distance) {
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
