// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/unwrap.hpp"

#include "modes.hpp"
#include "refine_points.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

/// Points per span of a spline: the rule of n/5 poles (Debout, §9).
constexpr std::size_t kPointsPerSpan = 5;
/// Weight of the squared second differences of poles against that of the points: settles poles that
/// no point sees.
constexpr double kRidge = 1e-6;

std::array<double, 4> cubicWeights(double t) {
  const double u = 1.0 - t;
  return {u * u * u / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
          (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0, t * t * t / 6.0};
}

/// Parameter 0..1 of each point of a bead, half by number and half by length: no span without
/// points, and no kink on long steps. A step is at most 3 spans, so that the band is bounded.
std::vector<double> parameters(const Task& task, const Segment& segment, double spans) {
  const std::size_t count = segment.last - segment.first + 1;
  const auto stepTo = [&](std::size_t k) {
    const std::size_t i = segment.first + k;
    return (task.targets[i].p - task.targets[i - 1].p).norm();
  };
  double length = 0.0;
  for (std::size_t k = 1; k < count; ++k) {
    length += stepTo(k);
  }
  std::vector<double> u(count, 0.0);
  for (std::size_t k = 1; k < count; ++k) {
    const double even = 1.0 / static_cast<double>(count - 1);
    const double share = length > 0.0 ? 0.5 * (even + stepTo(k) / length) : even;
    // The even halves make at least 1/2 together: dividing by the sum at most doubles a step.
    u[k] = u[k - 1] + (count > 2 ? std::min(share, 1.5 / spans) : share);
  }
  const double whole = u.back() > 0.0 ? u.back() : 1.0;
  for (double& value : u) {
    value /= whole;
  }
  return u;
}

}  // namespace

SplineLayout::SplineLayout(const Task& task, const RefineFrame& frame)
    : task_(task), frame_(frame) {
  if (task.cell.inverse->freeRotation()) {
    active_.push_back(FreeScalar::Torch);
  }
  if (frame.moveTable) {
    active_.push_back(FreeScalar::Table);
  }
  if (task.params.tiltTolerance.value() > 0.0) {
    active_.push_back(FreeScalar::Lead);
    active_.push_back(FreeScalar::Lateral);
  }
  for (const Segment& segment : task.runs.segments) {
    const std::size_t count = segment.last - segment.first + 1;
    const auto spans = static_cast<double>(std::max<std::size_t>(1, count / kPointsPerSpan));
    const std::vector<double> u = parameters(task, segment, spans);
    for (std::size_t i = segment.first; i <= segment.last; ++i) {
      const double at = std::clamp(u[i - segment.first], 0.0, 1.0) * spans;
      const double span = std::min(std::floor(at), spans - 1.0);
      points_.push_back(i);
      supports_.push_back(
          {size_ + static_cast<Eigen::Index>(span) * scalars(), cubicWeights(at - span)});
    }
    size_ += (static_cast<Eigen::Index>(spans) + 3) * scalars();
  }
}

std::array<double, kFreeScalars> SplineLayout::valuesAt(std::size_t point,
                                                        const Eigen::VectorXd& x) const {
  std::array<double, kFreeScalars> values{};
  const Support& support = supports_[point];
  for (int v = 0; v < scalars(); ++v) {
    for (int a = 0; a < 4; ++a) {
      values[static_cast<std::size_t>(v)] +=
          support.weight[static_cast<std::size_t>(a)] * x(support.first + a * scalars() + v);
    }
  }
  return values;
}

double SplineLayout::offsetOf(std::size_t target, const FreeChoice& choice, FreeScalar s) const {
  switch (s) {
    case FreeScalar::Torch:
      return choice.torchRotation - frame_.gauge[target];
    case FreeScalar::Table: {
      const auto last = static_cast<std::size_t>(task_.cell.positionerJoints() - 1);
      return choice.positioner[last] - task_.references[frame_.family].joints[target][last];
    }
    case FreeScalar::Lead:
      return choice.lead;
    case FreeScalar::Lateral:
      return choice.lateral;
  }
  return 0.0;
}

Eigen::VectorXd SplineLayout::fit(const std::vector<FreeChoice>& choices) const {
  const int n = scalars();
  Eigen::VectorXd x(size_);
  for (int v = 0; v < n; ++v) {
    const FreeScalar scalar = active_[static_cast<std::size_t>(v)];
    const bool angle = scalar == FreeScalar::Torch || scalar == FreeScalar::Table;
    BandMatrix normal(size_ / n, 3);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size_ / n);
    double before = 0.0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const std::size_t target = points_[k];
      double value = offsetOf(target, choices[target], scalar);
      const bool continues = k > 0 && points_[k - 1] + 1 == target;
      if (angle && continues) {
        value = cell::nearestTurn(value, before);
      }
      before = value;
      const Eigen::Index first = supports_[k].first / n;
      for (int a = 0; a < 4; ++a) {
        const double weight = supports_[k].weight[static_cast<std::size_t>(a)];
        right(first + a) += weight * value;
        for (int b = 0; b <= a; ++b) {
          normal.at(first + a, first + b) +=
              weight * supports_[k].weight[static_cast<std::size_t>(b)];
        }
      }
    }
    constexpr double kSecond[3] = {1.0, -2.0, 1.0};
    for (Eigen::Index p = 0; p + 2 < size_ / n; ++p) {
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b <= a; ++b) {
          normal.at(p + a, p + b) += kRidge * kSecond[a] * kSecond[b];
        }
      }
    }
    Eigen::VectorXd own;
    const Eigen::VectorXd extra = Eigen::VectorXd::Constant(size_ / n, 1e-9);
    if (!normal.solve(extra, right, own)) {
      own = Eigen::VectorXd::Zero(size_ / n);
    }
    for (Eigen::Index p = 0; p < size_ / n; ++p) {
      x(p * n + v) = own(p);
    }
  }
  return x;
}

std::vector<FreeChoice> SplineLayout::choices(const Eigen::VectorXd& x) const {
  std::vector<FreeChoice> choices(task_.targets.size());
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const std::size_t target = points_[k];
    const auto values = valuesAt(k, x);
    FreeChoice& choice = choices[target];
    choice.torchRotation = frame_.gauge[target];
    choice.positioner = task_.references[frame_.family].joints[target];
    for (std::size_t v = 0; v < active_.size(); ++v) {
      switch (active_[v]) {
        case FreeScalar::Torch:
          choice.torchRotation += values[v];
          break;
        case FreeScalar::Table:
          choice.positioner[static_cast<std::size_t>(task_.cell.positionerJoints() - 1)] +=
              values[v];
          break;
        case FreeScalar::Lead:
          choice.lead = values[v];
          break;
        case FreeScalar::Lateral:
          choice.lateral = values[v];
          break;
      }
    }
  }
  spreadToTravel(task_.runs, choices);
  return choices;
}

}  // namespace wcam::motion::detail
