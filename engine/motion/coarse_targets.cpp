// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "coarse_targets.hpp"

#include "wcam/base/parallel.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/cell/kinematics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wcam::motion::detail {

namespace {

using cell::Rotation;

/// Tool axis and build direction of a kept target stand for those that lean by no more, rad: the
/// tilts and the positioner's values between are interpolated.
const double kSameAxis = degToRad(2.0);
/// The same of the direction of travel, which the rotation about the torch may follow.
const double kSameTravel = degToRad(6.0);
/// Fewer targets than this part of all are worth the interpolation.
constexpr double kWorthIt = 0.7;
/// The free angle is interpolated itself where it turns by no more between two kept targets, rad.
const double kSmallTurn = degToRad(15.0);
/// A rotation is met when no entry of its matrix is off by more.
constexpr double kSameRotation = 1e-9;
constexpr std::size_t kGrain = 64;

bool turnsBeyond(const Vec3& a, const Vec3& b, double angle) {
  return a.dot(b) < std::cos(angle) * a.norm() * b.norm();
}

bool followsBead(const Target& from, const Target& to) {
  return from.waypoint.point >= 0 && to.waypoint.point >= 0 &&
         from.waypoint.layer == to.waypoint.layer && from.waypoint.bead == to.waypoint.bead;
}

double stepLength(const std::vector<Target>& targets, std::size_t i) {
  return (targets[i].p - targets[i - 1].p).norm();
}

double beadLength(const std::vector<Target>& targets) {
  double length = 0.0;
  for (std::size_t i = 1; i < targets.size(); ++i) {
    length += followsBead(targets[i - 1], targets[i]) ? stepLength(targets, i) : 0.0;
  }
  return length;
}

/// The rotation that flangePose() makes of an axis and the free angle: of the tool frame in the
/// base, or of the part in the torch's frame.
Rotation freeRotation(const Task& task, const Vec3& axis, double angle) {
  return task.cell.partCarried() ? cell::axisToVertical(axis, angle)
                                 : cell::frameWithZ(axis, angle);
}

/// The tool axis in the frame in which the free angle counts.
Vec3 freeAxis(const Task& task, std::size_t target, const FreeChoice& choice) {
  const Vec3 axis = tiltedAxis(task.targets[target], choice.lead, choice.lateral);
  return task.cell.partCarried()
             ? axis
             : Vec3(cell::chainPose(task.cell.positioner, choice.positioner.data()).linear() *
                    (task.cell.T_table_part.linear() * axis));
}

/// What is free at a target, side by side.
constexpr std::size_t kScalars = 5;
using Scalars = std::array<double, kScalars>;

Scalars scalarsOf(const FreeChoice& choice) {
  return {choice.torchRotation, choice.positioner[0], choice.positioner[1], choice.lead,
          choice.lateral};
}

FreeChoice choiceOf(const Scalars& scalars) {
  return {scalars[0], {scalars[1], scalars[2]}, scalars[3], scalars[4]};
}

/// Slope at the middle of three values (Fritsch and Butland, as in PCHIP): smooth, and without
/// overshoot, so that what is between two values that keep a tolerance keeps it too.
double slopeBetween(double h0, double d0, double h1, double d1) {
  if (!(d0 * d1 > 0.0)) {
    return 0.0;
  }
  const double w0 = 2.0 * h1 + h0;
  const double w1 = h1 + 2.0 * h0;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

/// The kept targets as knots of cubics along the path.
class Knots {
public:
  Knots(const Task& task, const std::vector<std::size_t>& kept, const Resolution& coarse)
      : coarse_(coarse), length_(kept.size(), 0.0) {
    for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
      if (followsBead(task.targets[kept[k]], task.targets[kept[k + 1]])) {
        for (std::size_t i = kept[k] + 1; i <= kept[k + 1]; ++i) {
          length_[k] += stepLength(task.targets, i);
        }
      }
    }
  }

  /// Of the path from knot k to the next one on its bead, mm; 0 where there is none.
  [[nodiscard]] double length(std::size_t k) const { return length_[k]; }

  /// The choice on the way from knot k to the next one, `s` from 0 to 1.
  [[nodiscard]] FreeChoice at(std::size_t k, double s) const {
    const Scalars from = scalarsOf(coarse_.choices[k]);
    const Scalars to = scalarsOf(coarse_.choices[k + 1]);
    Scalars value{};
    for (std::size_t n = 0; n < kScalars; ++n) {
      const double m0 = length_[k] * slope(k, n);
      const double m1 = length_[k] * slope(k + 1, n);
      const double rise = to[n] - from[n];
      // Hermite's cubic in Horner form.
      value[n] = from[n] + s * (m0 + s * (3.0 * rise - 2.0 * m0 - m1 + s * (m0 + m1 - 2.0 * rise)));
    }
    return choiceOf(value);
  }

private:
  [[nodiscard]] double secant(std::size_t k, std::size_t n) const {
    return (scalarsOf(coarse_.choices[k + 1])[n] - scalarsOf(coarse_.choices[k])[n]) / length_[k];
  }

  [[nodiscard]] double slope(std::size_t k, std::size_t n) const {
    const bool before = k > 0 && length_[k - 1] > 0.0;
    const bool after = length_[k] > 0.0;
    if (before && after) {
      return slopeBetween(length_[k - 1], secant(k - 1, n), length_[k], secant(k, n));
    }
    return before ? secant(k - 1, n) : after ? secant(k, n) : 0.0;
  }

  const Resolution& coarse_;
  std::vector<double> length_;
};

/// The free angle whose frame lies between two frames and has its own axis.
double rotationBetween(const Task& task,
                       std::size_t target,
                       const FreeChoice& choice,
                       const Rotation& from,
                       const Rotation& to,
                       double s) {
  const bool partCarried = task.cell.partCarried();
  const Vec3 axis = freeAxis(task, target, choice);
  const Eigen::Quaterniond turned =
      Eigen::Quaterniond(from).slerp(s, Eigen::Quaterniond(to)).normalized();
  const Rotation even = turned.toRotationMatrix();
  const Vec3 guide = partCarried ? Vec3(even.row(0)) : Vec3(even.col(0));
  const Vec3 x = guide - axis * axis.dot(guide);
  if (!(x.norm() > 0.0)) {
    return choice.torchRotation;
  }
  Rotation wanted;
  wanted.col(0) = x.normalized();
  wanted.col(2) = axis;
  wanted.col(1) = axis.cross(wanted.col(0));
  if (partCarried) {
    wanted.transposeInPlace();
  }
  const double angle = cell::toBryant(wanted).z();
  const bool met =
      (freeRotation(task, axis, angle) - wanted).cwiseAbs().maxCoeff() <= kSameRotation;
  return met ? angle : choice.torchRotation;
}

}  // namespace

std::vector<std::size_t> coarseTargets(const std::vector<Target>& targets, std::size_t wanted) {
  if (targets.size() <= wanted) {
    return {};
  }
  const double spacing = beadLength(targets) / static_cast<double>(wanted);
  std::vector<std::size_t> kept;
  double way = 0.0;  // since the last kept one
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Target& target = targets[i];
    const bool inside = i > 0 && i + 1 < targets.size() && followsBead(targets[i - 1], target) &&
                        followsBead(target, targets[i + 1]) &&
                        target.waypoint.arc == targets[i + 1].waypoint.arc;
    if (inside) {
      const Target& before = targets[kept.back()];
      const Target& next = targets[i + 1];
      way += stepLength(targets, i);
      if (way + stepLength(targets, i + 1) <= spacing &&
          !turnsBeyond(before.axis, next.axis, kSameAxis) &&
          !turnsBeyond(before.up, next.up, kSameAxis) &&
          !turnsBeyond(before.along, next.along, kSameTravel)) {
        continue;
      }
    }
    kept.push_back(i);
    way = 0.0;
  }
  if (static_cast<double>(kept.size()) > kWorthIt * static_cast<double>(targets.size())) {
    return {};
  }
  return kept;
}

std::vector<std::size_t> sampledBeads(const Runs& runs, std::size_t wanted) {
  const std::size_t stride =
      std::max<std::size_t>(1, runs.segments.size() / std::max<std::size_t>(wanted, 1));
  std::vector<std::size_t> sampled;
  for (std::size_t s = 0; s < runs.segments.size(); s += stride) {
    for (std::size_t i = runs.segments[s].begin; i < runs.segments[s].end; ++i) {
      sampled.push_back(i);
    }
  }
  return sampled;
}

Resolution spreadOverTargets(const Task& task,
                             const std::vector<std::size_t>& kept,
                             const Resolution& coarse,
                             const JobContext& context) {
  Resolution all;
  all.branches = coarse.branches;
  all.choices.resize(task.targets.size());
  const Knots knots(task, kept, coarse);
  parallelFor(
      kept.size(), kGrain,
      [&](std::size_t k) {
        const std::size_t first = kept[k];
        const FreeChoice& from = coarse.choices[k];
        all.choices[first] = from;
        const std::size_t last = k + 1 < kept.size() ? kept[k + 1] : first;
        if (last <= first + 1) {
          return;
        }
        const FreeChoice& to = coarse.choices[k + 1];
        // Where the axis comes near the X axis of the base, near frames have far angles.
        const bool byFrames = std::abs(to.torchRotation - from.torchRotation) > kSmallTurn;
        const Rotation start = freeRotation(task, freeAxis(task, first, from), from.torchRotation);
        const Rotation end = freeRotation(task, freeAxis(task, last, to), to.torchRotation);
        double way = 0.0;
        for (std::size_t i = first + 1; i < last; ++i) {
          way += stepLength(task.targets, i);
          const double s = knots.length(k) > 0.0 ? way / knots.length(k) : 0.0;
          FreeChoice choice = knots.at(k, s);
          if (byFrames) {
            choice.torchRotation = rotationBetween(task, i, choice, start, end, s);
          }
          all.choices[i] = choice;
        }
      },
      context);
  return all;
}

}  // namespace wcam::motion::detail
