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

/// A piece of a bead with the area beside it; a corner or an end has no length.
struct Share {
  double s = 0.0;
  double length = 0.0;
  double area = 0.0;
};

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
    return smoothed(sharesOf(line, bead.closed, own), length,
                    geometry::polylineLength(bead.points, bead.closed), bead.closed);
  }

private:
  /// Rays across every piece, fans outside corners and around ends.
  [[nodiscard]] std::vector<Share> sharesOf(const Polyline2& line, bool closed, double own) const {
    std::vector<Share> shares;
    const std::size_t n = line.size();
    const std::size_t edges = closed ? n : n - 1;
    const auto direction = [&](std::size_t edge) {
      return Vec2((line[(edge + 1) % n] - line[edge]).normalized());
    };
    double s = 0.0;
    for (std::size_t i = 0; i < edges; ++i) {
      const Vec2 a = line[i];
      const Vec2 d = line[(i + 1) % n] - a;
      const double length = d.norm();
      const Vec2 u = d / length;
      if (closed || i > 0) {
        shares.push_back({s, 0.0, corner(a, direction((i + edges - 1) % edges), u, own)});
      } else {
        shares.push_back({s, 0.0, fan(a, leftOf(u), kPi, own)});
      }
      const auto pieces = static_cast<std::size_t>(
          std::max(1.0, std::ceil(length / (kPiece * options_.width) - kFoot)));
      const double piece = length / static_cast<double>(pieces);
      for (std::size_t k = 0; k < pieces; ++k) {
        const double along = (static_cast<double>(k) + 0.5) * piece;
        const Vec2 foot = a + along * u;
        const double across = ray(foot, leftOf(u), own) + ray(foot, -leftOf(u), own);
        shares.push_back({s + along, piece, piece * across});
      }
      s += length;
    }
    if (!closed) {
      const Vec2 u = direction(edges - 1);
      shares.push_back({s, 0.0, fan(line.back(), -leftOf(u), kPi, own)});
    }
    return shares;
  }

  /// The sector outside a corner between the normals of both sides.
  [[nodiscard]] double corner(const Vec2& p, const Vec2& u, const Vec2& v, double own) const {
    const double turn = std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
    return turn > 0.0 ? fan(p, -leftOf(u), turn, own) : fan(p, leftOf(u), turn, own);
  }

  [[nodiscard]] double fan(const Vec2& p, const Vec2& from, double angle, double own) const {
    const auto rays = static_cast<int>(std::ceil(std::abs(angle) / kFan));
    double area = 0.0;
    for (int k = 0; k < rays; ++k) {
      const double turned = angle * (k + 0.5) / rays;
      const double reach = ray(p, Eigen::Rotation2Dd(turned) * from, own);
      area += 0.5 * reach * reach * std::abs(angle) / rays;
    }
    return area;
  }

  /// How far the room of a bead reaches from a point on it: to the bisector of the nearest other
  /// place of a bead (the ball that touches here and there shrinks until it holds nothing else, Ma
  /// 2012), or to the border.
  [[nodiscard]] double ray(const Vec2& p, const Vec2& n, double own) const {
    const double foot = kFoot * options_.width;
    double reach = 0.5 * std::max(own, options_.maxWidth);
    constexpr int kShrinks = 32;
    for (int k = 0; k < kShrinks; ++k) {
      const auto nearest = tree_.nearestWithin(inSpace(p + reach * n), reach - foot);
      if (!nearest) {
        break;
      }
      const Vec2 away = nearest->head<2>() - p;
      const double ahead = n.dot(away);
      if (away.norm() < foot || !(ahead > 0.0)) {
        break;
      }
      reach = std::min(reach, 0.5 * away.squaredNorm() / ahead);
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

  /// Averages over a bead width with triangular weights, keeping the whole area.
  [[nodiscard]] FillRoom smoothed(const std::vector<Share>& shares,
                                  double length,
                                  double fullLength,
                                  bool closed) const {
    const auto count = static_cast<std::size_t>(
        std::max(1.0, std::ceil(length / (kPiece * options_.width) - kFoot)));
    const double piece = length / static_cast<double>(count);
    const double reach = std::max(options_.width, 2.0 * piece);
    std::vector<double> area(count, 0.0);
    std::vector<double> weight(count, 0.0);
    const auto pieces = static_cast<long>(count);
    const auto half = static_cast<long>(std::ceil(reach / piece)) + 1;
    double whole = 0.0;
    for (const Share& share : shares) {
      whole += share.area;
      const auto here = static_cast<long>(share.s / piece);
      // A short closed bead is its own neighbour only once.
      const long from = closed ? std::max(here - half, here - (pieces - 1) / 2) : here - half;
      const long to = closed ? std::min(here + half, here + pieces / 2) : here + half;
      for (long k = from; k <= to; ++k) {
        if (!closed && (k < 0 || k >= pieces)) {
          continue;
        }
        const double centre = (static_cast<double>(k) + 0.5) * piece;
        const double w = 1.0 - std::abs(share.s - centre) / reach;
        if (w > 0.0) {
          const auto at = static_cast<std::size_t>((k % pieces + pieces) % pieces);
          area[at] += w * share.area;
          weight[at] += w * share.length;
        }
      }
    }
    double sum = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      area[k] = weight[k] > 0.0 ? area[k] / weight[k] : 0.0;
      sum += area[k] * piece;
    }
    const double narrowest = options_.overlap * options_.minWidth;
    for (double& width : area) {
      width = std::clamp(sum > 0.0 ? width * whole / sum : 0.0, narrowest, options_.maxWidth);
    }
    return {std::move(area), fullLength, closed};
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
