// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/tool_axis.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {

Vec3 tiltedAxis(const Vec3& t, const Vec3& n, const Vec3& b, Angle lead, Angle lateral) {
  const double tn = std::tan(lead.value());
  const double tt = std::tan(lateral.value());
  return (tn * t + tt * n + b) / std::sqrt(1.0 + tn * tn + tt * tt);
}

namespace {

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// `from` turned towards `to` by an angle, at most onto it. Opposite directions turn about any axis
/// across them.
Vec3 turned(const Vec3& from, const Vec3& to, double angle) {
  if (angleBetween(from, to) <= angle) {
    return to;
  }
  Vec3 across = to - to.dot(from) * from;
  across = across.norm() > 0.0 ? Vec3(across.normalized()) : from.unitOrthogonal();
  return (std::cos(angle) * from + std::sin(angle) * across).normalized();
}

}  // namespace

Vec3 limitedAxis(const Vec3& direction, const Vec3& vertical, Angle limit) {
  return angleBetween(vertical, direction) <= limit.value()
             ? direction
             : turned(vertical, direction, limit.value());
}

std::optional<Vec3> projectedAxis(const Vec3& direction, const Vec3& normal) {
  // A direction this near to the normal has no projection that rounding leaves alone.
  constexpr double kParallel = 1e-9;
  const double length = normal.norm();
  if (!(length > 0.0)) {
    return std::nullopt;
  }
  const Vec3 n = normal / length;
  const Vec3 inPlane = direction - direction.dot(n) * n;
  if (!(inPlane.norm() > kParallel * direction.norm())) {
    return std::nullopt;
  }
  return inPlane.normalized();
}

namespace {

/// Smooths a field over points, or over a ring of them.
class Smoother {
public:
  Smoother(const std::vector<Vec3>& positions,
           const std::vector<Vec3>& wanted,
           bool closed,
           double rate)
      : wanted_(wanted), ring_(closed && wanted.size() > 2), n_(wanted.size() - (ring_ ? 1 : 0)) {
    bound_.resize(n_);  // of the turn from a point to the next one
    for (std::size_t i = 0; i < n_; ++i) {
      const std::size_t next = i + 1 < positions.size() ? i + 1 : i;
      bound_[i] = rate * (positions[next] - positions[i]).norm();
    }
  }

  std::vector<Vec3> run() {
    std::vector<Vec3> axes(wanted_.begin(), wanted_.begin() + static_cast<std::ptrdiff_t>(n_));
    if (!holds(axes)) {
      const std::vector<Vec3> ahead = follow(true);
      const std::vector<Vec3> back = follow(false);
      for (std::size_t i = 0; i < n_; ++i) {
        const Vec3 sum = ahead[i] + back[i];
        axes[i] = sum.norm() > kOpposite ? Vec3(sum.normalized()) : ahead[i];
      }
      // On the sphere a mean of two fields may turn faster than both.
      if (!holds(axes)) {
        axes = ahead;
      }
      drawBack(axes);
    }
    if (ring_) {
      axes.push_back(axes.front());
    }
    return axes;
  }

private:
  /// Two axes this near to opposite have no mean.
  static constexpr double kOpposite = 1e-6;
  /// Rounding of angles, rad.
  static constexpr double kRounding = 1e-12;

  [[nodiscard]] std::size_t pairs() const { return ring_ ? n_ : n_ - 1; }

  [[nodiscard]] bool holds(const std::vector<Vec3>& axes) const {
    for (std::size_t i = 0; i < pairs(); ++i) {
      if (angleBetween(axes[i], axes[(i + 1) % n_]) > bound_[i] + kRounding) {
        return false;
      }
    }
    return true;
  }

  /// Follows the wanted axes at the greatest rate, from the first point on or from the last one
  /// back; around a ring until nothing changes.
  [[nodiscard]] std::vector<Vec3> follow(bool forward) const {
    std::vector<Vec3> axes(n_);
    const auto at = [&](std::size_t k) { return forward ? k % n_ : n_ - 1 - k % n_; };
    axes[at(0)] = wanted_[at(0)];
    // Each lap carries the bound on; a field that needs more laps turns by more than a half circle
    // everywhere.
    constexpr std::size_t kLaps = 64;
    const std::size_t steps = ring_ ? kLaps * n_ : n_ - 1;
    for (std::size_t k = 1; k <= steps; ++k) {
      const std::size_t from = at(k - 1);
      const std::size_t to = at(k);
      const Vec3 next = turned(axes[from], wanted_[to], bound_[forward ? from : to]);
      if (k >= n_ && next == axes[to]) {
        break;
      }
      axes[to] = next;
    }
    return axes;
  }

  /// Moves each axis towards its wanted one as far as both neighbours allow.
  void drawBack(std::vector<Vec3>& axes) const {
    constexpr int kPasses = 60;
    constexpr int kBisections = 14;
    const double still = 1e-5;  // rad: what a pass must move at least to be worth another one
    for (int pass = 0; pass < kPasses; ++pass) {
      double moved = 0.0;
      for (std::size_t k = 0; k < n_; ++k) {
        const std::size_t i = pass % 2 == 0 ? k : n_ - 1 - k;
        const double away = angleBetween(axes[i], wanted_[i]);
        if (away <= still) {
          continue;
        }
        double low = 0.0;
        double high = away;
        if (fits(axes, i, wanted_[i])) {
          low = away;
        } else {
          for (int b = 0; b < kBisections; ++b) {
            const double middle = 0.5 * (low + high);
            (fits(axes, i, turned(axes[i], wanted_[i], middle)) ? low : high) = middle;
          }
        }
        if (low > 0.0) {
          axes[i] = turned(axes[i], wanted_[i], low);
          moved = std::max(moved, low);
        }
      }
      if (moved < still) {
        break;
      }
    }
  }

  [[nodiscard]] bool fits(const std::vector<Vec3>& axes, std::size_t i, const Vec3& axis) const {
    const bool hasBefore = ring_ || i > 0;
    const bool hasAfter = ring_ || i + 1 < n_;
    const std::size_t before = (i + n_ - 1) % n_;
    return (!hasBefore || angleBetween(axes[before], axis) <= bound_[before]) &&
           (!hasAfter || angleBetween(axes[(i + 1) % n_], axis) <= bound_[i]);
  }

  const std::vector<Vec3>& wanted_;
  bool ring_;
  std::size_t n_;
  std::vector<double> bound_;
};

}  // namespace

SmoothedAxes smoothedAxes(const std::vector<Vec3>& positions,
                          const std::vector<Vec3>& wanted,
                          bool closed,
                          double rate) {
  SmoothedAxes result{wanted, 0.0};
  if (wanted.size() < 2) {
    return result;
  }
  result.axes = Smoother(positions, wanted, closed, rate).run();
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    result.maxDeviation = std::max(result.maxDeviation, angleBetween(wanted[i], result.axes[i]));
  }
  return result;
}

}  // namespace wcam::toolpath
