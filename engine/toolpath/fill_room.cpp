// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/fill_room.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/geometry/segment_tree.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {

using geometry::Polyline2;
using geometry::Region2;
using geometry::SegmentTree;

namespace {

// Parts of the bead width.
constexpr double kPiece = 0.25;       ///< longest piece of a bead with one ray to each side
constexpr double kSimplified = 0.01;  ///< what centre lines and borders may lose
constexpr double kFoot = 1e-4;        ///< to which a ray's end is found
/// What lies around the end of a bead is laid on its last width: there it may hold so many maximum
/// widths.
constexpr double kMostAtEnds = 3.0;
/// How far the room of a bead's end may reach, in half widths: into the corners of a square end.
const double kEndReach = std::sqrt(2.0);
/// Widest angle between the rays that share what lies outside a corner or around an end, rad.
constexpr double kFan = kPi / 12.0;

Vec3 inSpace(const Vec2& p) {
  return {p.x(), p.y(), 0.0};
}

std::vector<Vec3> inSpace(const Polyline2& line) {
  std::vector<Vec3> points;
  points.reserve(line.size());
  for (const Vec2& p : line) {
    points.push_back(inSpace(p));
  }
  return points;
}

Vec2 leftOf(const Vec2& u) {
  return {-u.y(), u.x()};
}

using Share = RoomShare;

/// A ray from a bead to where its room ends.
struct Ray {
  double s = 0.0;
  Vec2 foot = Vec2::Zero();
  Vec2 tip = Vec2::Zero();
};

/// Area between two neighbouring rays; positive when the second one stands ahead of the first on
/// the left of the bead.
double areaBetween(const Ray& a, const Ray& b) {
  const Vec2 p = b.tip - a.foot;
  const Vec2 q = a.tip - b.foot;
  return 0.5 * (p.x() * q.y() - p.y() * q.x());
}

class RoomSharer {
public:
  RoomSharer(const Region2& region,
             const std::vector<FillBead>& beads,
             const FillOptions& options,
             double height)
      : region_(geometry::simplified(region, kSimplified * options.width)),
        options_(options),
        height_(height) {
    for (const Polyline2& loop : region_.loops) {
      border_.add(inSpace(loop), true);
    }
    border_.build();
    for (const FillBead& bead : beads) {
      lines_.push_back(geometry::simplified(bead.points, bead.closed, kSimplified * options.width));
      tree_.add(inSpace(lines_.back()), bead.closed);
    }
    tree_.build();
  }

  [[nodiscard]] FillRoom roomOf(const FillBead& bead, std::size_t index) const {
    const Polyline2& line = lines_[index];
    const double length = geometry::polylineLength(line, bead.closed);
    if (!(length > 0.0)) {
      return {};
    }
    const double own = bead.widths.empty()
                           ? options_.width
                           : *std::max_element(bead.widths.begin(), bead.widths.end());
    return averagedRoom(
        sharesOf(line, bead.closed, own),
        {length, geometry::polylineLength(bead.points, bead.closed), kPiece * options_.width,
         options_.width, bead.closed},
        {options_.overlap * options_.minWidth, options_.maxWidth, kMostAtEnds * options_.maxWidth});
  }

private:
  /// Rays across every piece on both sides, fans outside corners and around ends.
  [[nodiscard]] std::vector<Share> sharesOf(const Polyline2& line, bool closed, double own) const {
    std::vector<Share> shares;
    addSide(line, closed, own, 1.0, shares);
    addSide(line, closed, own, -1.0, shares);
    if (!closed) {
      const std::size_t n = line.size();
      const Vec2 first = (line[1] - line[0]).normalized();
      const Vec2 last = (line[n - 1] - line[n - 2]).normalized();
      shares.push_back({0.0, fan(line.front(), leftOf(first), kPi, kEndReach * own, kEndReach)});
      shares.push_back({geometry::polylineLength(line, false),
                        fan(line.back(), -leftOf(last), kPi, kEndReach * own, kEndReach)});
    }
    return shares;
  }

  /// @param side 1: on the left, -1: on the right
  void addSide(const Polyline2& line,
               bool closed,
               double own,
               double side,
               std::vector<Share>& shares) const {
    const std::size_t n = line.size();
    const std::size_t edges = closed ? n : n - 1;
    const auto normal = [&](std::size_t edge) {
      return Vec2(side * leftOf((line[(edge + 1) % n] - line[edge]).normalized()));
    };
    std::vector<Ray> rays;
    const auto cast = [&](double s, const Vec2& foot, const Vec2& direction, double half = 0.0) {
      rays.push_back({s, foot, foot + ray(foot, direction, own, half) * direction});
    };
    // Rays at a corner: one along the bisector inside it, one along each normal outside.
    const auto corner = [&](double s, std::size_t before, std::size_t after) {
      const Vec2 in = normal(before);
      const Vec2 out = normal(after);
      const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
      const Vec2 middle = in + out;
      if (side * turn > 0.0 && middle.norm() > 0.0) {
        cast(s, line[after], middle.normalized(), 0.5 * std::abs(turn));
        return;
      }
      cast(s, line[after], in);
      shares.push_back({s, fan(line[after], in, turn, own)});
      cast(s, line[after], out);
    };
    double s = 0.0;
    for (std::size_t i = 0; i < edges; ++i) {
      if (closed || i > 0) {
        corner(s, (i + edges - 1) % edges, i);
      } else {
        cast(s, line[0], normal(0));
      }
      const Vec2 d = line[(i + 1) % n] - line[i];
      const double length = d.norm();
      const auto pieces = static_cast<std::size_t>(
          std::max(1.0, std::ceil(length / (kPiece * options_.width) - kFoot)));
      for (std::size_t k = 0; k < pieces; ++k) {
        const double along = (static_cast<double>(k) + 0.5) / static_cast<double>(pieces);
        cast(s + along * length, line[i] + along * d, normal(i));
      }
      s += length;
    }
    if (closed) {
      rays.push_back(rays.front());
      rays.back().s = s;
    } else {
      cast(s, line[n - 1], normal(edges - 1));
    }
    for (std::size_t i = 1; i < rays.size(); ++i) {
      if (rays[i].s > rays[i - 1].s) {
        shares.push_back({0.5 * (rays[i - 1].s + rays[i].s),
                          std::max(0.0, side * areaBetween(rays[i - 1], rays[i]))});
      }
    }
  }

  /// @param farther how much farther than to its sides a bead may reach
  [[nodiscard]] double fan(
      const Vec2& p, const Vec2& from, double angle, double own, double farther = 1.0) const {
    const auto rays = static_cast<int>(std::ceil(std::abs(angle) / kFan));
    double area = 0.0;
    for (int k = 0; k < rays; ++k) {
      const double turned = angle * (k + 0.5) / rays;
      const double reach = ray(p, Eigen::Rotation2Dd(turned) * from, own, 0.0, farther);
      area += 0.5 * reach * reach * std::abs(angle) / rays;
    }
    return area;
  }

  /// How far the room of a bead reaches from a point on it: to where another place of a bead is as
  /// near (the ball that touches here and there shrinks until it holds nothing else, Ma 2012), or
  /// to the border.
  /// @param half inside a corner, along its bisector: half the angle by which the bead turns there;
  /// the ball then touches both of its sides
  /// @param farther as in fan()
  [[nodiscard]] double ray(
      const Vec2& p, const Vec2& n, double own, double half = 0.0, double farther = 1.0) const {
    const double foot = kFoot * options_.width;
    const double near = std::cos(half);
    const double sine2 = 1.0 - near * near;
    double reach = 0.5 * std::max(own, farther * options_.maxWidth) / std::max(near, kFoot);
    constexpr int kShrinks = 32;
    for (int k = 0; k < kShrinks; ++k) {
      const auto nearest = tree_.nearestWithin(inSpace(p + reach * n), near * reach - foot);
      if (!nearest) {
        break;
      }
      const Vec2 away = nearest->head<2>() - p;
      const double ahead = n.dot(away);
      if (away.norm() < foot || !(ahead > 0.0)) {
        break;
      }
      // |reach·n − away| = near·reach, the smaller root.
      const double root = ahead * ahead - sine2 * away.squaredNorm();
      reach = std::min(reach, away.squaredNorm() / (ahead + std::sqrt(std::max(0.0, root))));
    }
    return std::min(reach, toBorder(p, n, reach, 0.5 * (own + height_)));
  }

  /// @param atMost how far to look @param free how far beads reach where the border is farther
  [[nodiscard]] double toBorder(const Vec2& p, const Vec2& n, double atMost, double free) const {
    if (border_.distance(inSpace(p), atMost) >= atMost) {
      return atMost;
    }
    if (!region_.contains(p)) {
      return 0.0;
    }
    const double foot = kFoot * options_.width;
    double way = 0.0;
    constexpr int kSteps = 64;
    for (int k = 0; k < kSteps && way < atMost; ++k) {
      const double step = border_.distance(inSpace(p + way * n), atMost - way);
      if (step < foot) {
        return std::min(way, free);
      }
      way += step;
    }
    return std::min(way, atMost);
  }

  Region2 region_;
  const FillOptions& options_;
  double height_;
  SegmentTree border_;
  SegmentTree tree_;
  std::vector<Polyline2> lines_;
};

}  // namespace

FillRoom::FillRoom(std::vector<double> widths, double length, bool closed)
    : widths_(std::move(widths)), length_(length), closed_(closed) {}

double FillRoom::at(double s) const {
  if (widths_.empty()) {
    return 0.0;
  }
  const auto n = static_cast<long>(widths_.size());
  const double x = length_ > 0.0 ? s / length_ * static_cast<double>(n) - 0.5 : 0.0;
  const double floor = std::floor(x);
  const auto width = [&](long k) {
    const long inside = closed_ ? (k % n + n) % n : std::clamp(k, 0L, n - 1);
    return widths_[static_cast<std::size_t>(inside)];
  };
  const auto k = static_cast<long>(floor);
  return width(k) + (x - floor) * (width(k + 1) - width(k));
}

double FillRoom::area() const {
  double sum = 0.0;
  for (const double width : widths_) {
    sum += width;
  }
  return widths_.empty() ? 0.0 : sum * length_ / static_cast<double>(widths_.size());
}

FillRoom averagedRoom(const std::vector<RoomShare>& shares,
                      const RoomAverage& average,
                      const RoomBounds& bounds) {
  const double length = average.length;
  const auto pieces = static_cast<long>(std::max(1.0, std::ceil(length / average.piece - kFoot)));
  const double piece = length / static_cast<double>(pieces);
  const double reach = std::max(average.reach, piece);
  const auto half = static_cast<long>(std::ceil(reach / piece));
  const auto inside = [&](long k) {
    if (average.closed) {
      return (k % pieces + pieces) % pieces;
    }
    const long folded = (k % (2 * pieces) + 2 * pieces) % (2 * pieces);
    return folded < pieces ? folded : 2 * pieces - 1 - folded;
  };
  std::vector<double> area(static_cast<std::size_t>(pieces), 0.0);
  for (const RoomShare& share : shares) {
    const auto here = static_cast<long>(share.s / piece);
    const auto weight = [&](long k) {
      return std::max(0.0,
                      1.0 - std::abs(share.s - (static_cast<double>(k) + 0.5) * piece) / reach);
    };
    double sum = 0.0;
    for (long k = here - half; k <= here + half; ++k) {
      sum += weight(k);
    }
    for (long k = here - half; k <= here + half; ++k) {
      area[static_cast<std::size_t>(inside(k))] += share.area * weight(k) / sum;
    }
  }
  for (long k = 0; k < pieces; ++k) {
    const double toEnd = piece * static_cast<double>(std::min(k, pieces - 1 - k));
    const bool end = !average.closed && toEnd <= reach;
    double& width = area[static_cast<std::size_t>(k)];
    width = std::clamp(width / piece, bounds.least, end ? bounds.mostAtEnds : bounds.most);
  }
  return {std::move(area), average.fullLength, average.closed};
}

std::vector<FillRoom> shareRoom(const Region2& region,
                                const std::vector<FillBead>& beads,
                                const FillOptions& options,
                                double height) {
  const RoomSharer sharer(region, beads, options, height);
  std::vector<FillRoom> rooms;
  rooms.reserve(beads.size());
  for (std::size_t i = 0; i < beads.size(); ++i) {
    rooms.push_back(sharer.roomOf(beads[i], i));
  }
  return rooms;
}

double fillRatio(const Region2& region, const std::vector<FillRoom>& rooms) {
  double filled = 0.0;
  for (const FillRoom& room : rooms) {
    filled += room.area();
  }
  const double area = region.area();
  return area > 0.0 ? filled / area : 1.0;
}

}  // namespace wcam::toolpath
