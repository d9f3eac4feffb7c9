// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/geometry/polygon2d.hpp"

#include "polygon_clip.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::geometry {

namespace {

constexpr double kMostLines = 1e7;

struct HatchNode {
  double x = 0.0;
  std::uint32_t loop = 0;
  std::uint32_t edge = 0;
};

/// The region in the frame of the lines: u along them, v in spacings.
struct Turned {
  Vec2 along, across;
  double phase = 0.0;
  double spacing = 1.0;

  [[nodiscard]] double u(const Vec2& p) const { return p.dot(along); }

  [[nodiscard]] double v(const Vec2& p) const { return (p.dot(across) - phase) / spacing; }

  /// First line at or above: a point on a line counts as above it.
  [[nodiscard]] std::int64_t lineAbove(const Vec2& p) const {
    return static_cast<std::int64_t>(std::floor(v(p))) + 1;
  }
};

template <class Visit>
void forEachNode(const Region2& region, const Turned& frame, const Visit& visit) {
  for (std::uint32_t l = 0; l < region.loops.size(); ++l) {
    const Polyline2& loop = region.loops[l];
    for (std::uint32_t i = 0; i < loop.size(); ++i) {
      const Vec2& a = loop[i];
      const Vec2& b = loop[(i + 1) % loop.size()];
      const std::int64_t ka = frame.lineAbove(a);
      const std::int64_t kb = frame.lineAbove(b);
      for (std::int64_t k = std::min(ka, kb); k < std::max(ka, kb); ++k) {
        visit(k, a, b, HatchNode{0.0, l, i});
      }
    }
  }
}

}  // namespace

std::vector<HatchSegment> hatchRegion(const Region2& region,
                                      double angle,
                                      double spacing,
                                      double phase) {
  detail::checkFinite(region.loops, "loop %1, point %2");
  if (!(spacing > 0.0) || !std::isfinite(spacing) || !std::isfinite(angle) ||
      !std::isfinite(phase)) {
    throw Error(ErrorCode::InvalidArgument, "spacing, angle or phase is no usable number",
                "hatching", "give a spacing above 0 mm");
  }
  std::vector<HatchSegment> segments;
  if (region.empty()) {
    return segments;
  }
  const Turned frame{Vec2(std::cos(angle), std::sin(angle)),
                     Vec2(-std::sin(angle), std::cos(angle)), phase, spacing};
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Polyline2& loop : region.loops) {
    for (const Vec2& p : loop) {
      low = std::min(low, frame.v(p));
      high = std::max(high, frame.v(p));
    }
  }
  if (high - low > kMostLines) {
    throw Error(ErrorCode::InvalidArgument, "the spacing gives more than 10 million lines",
                "hatching", "choose a larger spacing");
  }
  const auto firstLine = static_cast<std::int64_t>(std::floor(low)) + 1;
  const auto lastLine = static_cast<std::int64_t>(std::floor(high)) + 1;
  std::vector<std::uint32_t> begin(static_cast<std::size_t>(lastLine - firstLine) + 2, 0);
  forEachNode(region, frame, [&](std::int64_t k, const Vec2&, const Vec2&, HatchNode) {
    ++begin[static_cast<std::size_t>(k - firstLine) + 1];
  });
  for (std::size_t k = 1; k < begin.size(); ++k) {
    begin[k] += begin[k - 1];
  }
  std::vector<HatchNode> nodes(begin.back());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  forEachNode(region, frame, [&](std::int64_t k, const Vec2& a, const Vec2& b, HatchNode node) {
    const double va = frame.v(a);
    const double s = std::clamp((static_cast<double>(k) - va) / (frame.v(b) - va), 0.0, 1.0);
    node.x = frame.u(a) + s * (frame.u(b) - frame.u(a));
    nodes[next[static_cast<std::size_t>(k - firstLine)]++] = node;
  });
  for (std::size_t row = 0; row + 1 < begin.size(); ++row) {
    const auto from = nodes.begin() + begin[row];
    const auto to = nodes.begin() + begin[row + 1];
    std::sort(from, to, [](const HatchNode& a, const HatchNode& b) {
      return a.x != b.x ? a.x < b.x : (a.loop != b.loop ? a.loop < b.loop : a.edge < b.edge);
    });
    const std::int64_t line = firstLine + static_cast<std::int64_t>(row);
    const Vec2 base = frame.across * (phase + static_cast<double>(line) * spacing);
    for (auto node = from; node + 1 < to; node += 2) {
      if (node[0].x < node[1].x) {
        segments.push_back({base + node[0].x * frame.along, base + node[1].x * frame.along, line,
                            node[0].loop, node[0].edge, node[1].loop, node[1].edge});
      }
    }
  }
  return segments;
}

}  // namespace wcam::geometry
