// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/aabb_tree.hpp"
#include "wcam/geometry/level_set.hpp"

#include "generatrix_coverage.hpp"
#include "wall_decomposition.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wcam::toolpath {

namespace {

/// The part's axis as centroids of its plane sections: at every height the point towards which the
/// envelope is projected.
struct Axis {
  std::vector<double> height;
  std::vector<Vec3> centre;

  [[nodiscard]] Vec3 at(double z) const {
    const auto next = std::lower_bound(height.begin(), height.end(), z);
    if (next == height.begin()) {
      return centre.front();
    }
    if (next == height.end()) {
      return centre.back();
    }
    const auto i = static_cast<std::size_t>(next - height.begin());
    const double w = (z - height[i - 1]) / (height[i] - height[i - 1]);
    return centre[i - 1] + w * (centre[i] - centre[i - 1]);
  }
};

Vec3 centroid(const std::vector<Vec3>& loop) {
  Vec3 sum = Vec3::Zero();
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3& a = loop[i];
    const Vec3& b = loop[(i + 1) % loop.size()];
    const double size = (b - a).norm();
    sum += size * 0.5 * (a + b);
    length += size;
  }
  return length > 0.0 ? Vec3(sum / length) : loop.front();
}

Axis sectionAxis(const Wall& wall, const Vec3& up, double low, double high, double spacing) {
  const auto count = static_cast<std::size_t>(std::max(2.0, std::ceil((high - low) / spacing)));
  std::vector<double> levels;
  for (std::size_t k = 0; k < count; ++k) {
    levels.push_back(low +
                     (high - low) * (static_cast<double>(k) + 0.5) / static_cast<double>(count));
  }
  const auto sections = geometry::planeSections(wall.part->mesh, wall.part->halfEdges, up, levels);
  Axis axis;
  for (std::size_t k = 0; k < count; ++k) {
    const geometry::LevelContour* longest = nullptr;
    double most = 0.0;
    for (const geometry::LevelContour& contour : sections[k]) {
      const double length = contour.closed ? Loop(contour.points).length() : 0.0;
      if (length > most) {
        most = length;
        longest = &contour;
      }
    }
    if (longest != nullptr) {
      axis.height.push_back(levels[k]);
      axis.centre.push_back(centroid(longest->points));
    }
  }
  return axis;
}

class Envelope {
public:
  Envelope(const Wall& wall, const Vec3& up, const Axis& axis)
      : tree_(wall.part->mesh), up_(up), axis_(axis) {
    x_ = up.unitOrthogonal();
    y_ = up.cross(x_);
    for (const Vec3& p : wall.part->mesh.vertices) {
      const Vec3 radial = p - axis.at(up.dot(p));
      radius_ = std::max(radius_, (radial - radial.dot(up) * up).norm());
    }
    // Outside of everything.
    radius_ *= 1.1;
  }

  /// The first point of the part towards the axis, at an angle and a height.
  [[nodiscard]] std::optional<Vec3> hit(double angle, double z) const {
    const Vec3 s = axis_.at(z);
    const Vec3 at = s + (z - s.dot(up_)) * up_;
    const Vec3 outward = std::cos(angle) * x_ + std::sin(angle) * y_;
    const auto found = tree_.firstHit(at + radius_ * outward, -outward);
    if (!found || found->distance > radius_) {
      return std::nullopt;
    }
    return found->p;
  }

  /// The height between a hit and a miss where the border lies.
  [[nodiscard]] Vec3 border(double angle, double in, double out) const {
    Vec3 last = *hit(angle, in);
    constexpr int kHalvings = 48;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (in + out);
      if (const auto p = hit(angle, middle)) {
        in = middle;
        last = *p;
      } else {
        out = middle;
      }
    }
    return last;
  }

private:
  geometry::AabbTree tree_;
  Vec3 up_;
  const Axis& axis_;
  Vec3 x_, y_;
  double radius_ = 0.0;
};

std::vector<Vec3> projectedLine(
    const Envelope& envelope, double angle, double low, double high, double spacing) {
  const auto rows = static_cast<std::size_t>(std::max(2.0, std::ceil((high - low) / spacing)));
  std::vector<Vec3> points;
  double previous = low - spacing;
  for (std::size_t r = 0; r <= rows; ++r) {
    const double z = low + (high - low) * static_cast<double>(r) / static_cast<double>(rows);
    const auto p = envelope.hit(angle, z);
    if (p && points.empty() && r > 0) {
      points.push_back(envelope.border(angle, z, previous));
    }
    if (p) {
      points.push_back(*p);
    } else if (!points.empty()) {
      points.push_back(envelope.border(angle, previous, z));
      break;
    }
    previous = z;
  }
  return points;
}

}  // namespace

Generatrices decomposeByEnvelope(const Wall& wall,
                                 const GeneratrixOptions& options,
                                 const JobContext& context) {
  if (!wall.upper) {
    throw Error(ErrorCode::JobFailed,
                "a part that closes in a point cannot be projected onto a cylinder",
                "continuous spiral", "use the iso-value or the geodesic decomposition");
  }
  const Vec3 up = options.up.normalized();
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Vec3& p : wall.part->mesh.vertices) {
    low = std::min(low, up.dot(p));
    high = std::max(high, up.dot(p));
  }
  const double spacing = 0.5 * options.step;
  const Axis axis = sectionAxis(wall, up, low, high, spacing);
  if (axis.height.empty()) {
    throw Error(ErrorCode::JobFailed, "no plane section of the part is closed", "continuous spiral",
                "use the iso-value decomposition");
  }
  const Envelope envelope(wall, up, axis);
  const std::size_t count =
      options.count > 0 ? options.count : curveCount({wall.lower, *wall.upper}, options.sampling);
  Generatrices result;
  for (std::size_t i = 0; i < count; ++i) {
    context.check();
    // Seen from above the bead runs clockwise (t × n = up).
    const double angle = -2.0 * kPi * static_cast<double>(i) / static_cast<double>(count);
    std::vector<Vec3> line = projectedLine(envelope, angle, low, high, spacing);
    if (line.size() < 2) {
      throw Error(ErrorCode::JobFailed,
                  text("the envelope's line at %1° does not meet the part",
                       {formatFixed(-radToDeg(angle), 1)}),
                  "continuous spiral", "use the iso-value or the geodesic decomposition");
    }
    std::vector<Vec3> points;
    for (const geometry::ProjectedPoint& point : wall.projector->project(line, context)) {
      points.push_back(point.p);
    }
    result.curves.emplace_back(std::move(points));
  }
  // What the projection does not reach lies under an overhang.
  StripGap worst;
  for (const StripGap& gap : stripGaps(wall.part->mesh, result.curves, spacing)) {
    worst = gap.distance > worst.distance ? gap : worst;
  }
  if (worst.distance > options.step) {
    const Vec3& p = wall.part->mesh.vertices[worst.vertex];
    throw Error(ErrorCode::JobFailed,
                text("the envelope does not reach the surface at (%1, %2, %3), %4 mm beside it: "
                     "there is an overhang",
                     {formatFixed(p.x(), 1), formatFixed(p.y(), 1), formatFixed(p.z(), 1),
                      formatFixed(worst.distance, 1)}),
                "continuous spiral", "use the iso-value or the geodesic decomposition");
  }
  return result;
}

}  // namespace wcam::toolpath
