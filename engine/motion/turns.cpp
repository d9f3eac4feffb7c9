// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "turns.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/cell/unwrap.hpp"

#include "cell_model.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace wcam::motion::detail {

namespace {

constexpr double kTurn = 2.0 * kPi;
/// Rounding of a sum that lies on its limit, rad.
constexpr double kSumSlack = 1e-9;

/// A joint over one run: its first and last value, least and greatest.
struct Span {
  double first = 0.0, last = 0.0, low = 0.0, high = 0.0;
};

/// Follows full turns point by point.
Span follow(std::vector<Waypoint>& points, std::size_t begin, std::size_t end, int joint) {
  Span span;
  span.first = span.low = span.high = points[begin].joints(joint);
  for (std::size_t i = begin + 1; i < end; ++i) {
    double& value = points[i].joints(joint);
    value = cell::nearestTurn(value, points[i - 1].joints(joint));
    span.low = std::min(span.low, value);
    span.high = std::max(span.high, value);
  }
  span.last = points[end - 1].joints(joint);
  return span;
}

/// Shifts (whole turns, rad) that put a span inside the limits; at least one.
std::vector<double> allowedShifts(const cell::Joint& joint, const Span& span) {
  const double least = std::ceil((joint.min - span.low) / kTurn - 1e-12);
  const double most = std::floor((joint.max - span.high) / kTurn + 1e-12);
  std::vector<double> shifts;
  // No axis has room for more turns.
  constexpr int kMostShifts = 10000;
  for (int i = 0; i < kMostShifts && least + i <= most; ++i) {
    shifts.push_back((least + i) * kTurn);
  }
  if (shifts.empty()) {
    // It does not fit at all: share the excess between both sides.
    const double middle = 0.5 * (joint.min + joint.max);
    shifts.push_back(cell::nearestTurn(0.5 * (span.low + span.high), middle) -
                     0.5 * (span.low + span.high));
  }
  return shifts;
}

/// The chain of shifts with the least sum of squared moves, the first one counted from zero.
std::vector<double> bestShifts(const std::vector<std::vector<double>>& options,
                               const std::vector<Span>& spans) {
  std::vector<std::vector<std::size_t>> back(spans.size());
  std::vector<double> cost;
  for (std::size_t r = 0; r < spans.size(); ++r) {
    std::vector<double> next(options[r].size(), std::numeric_limits<double>::infinity());
    back[r].assign(options[r].size(), 0);
    for (std::size_t k = 0; k < options[r].size(); ++k) {
      const double start = spans[r].first + options[r][k];
      for (std::size_t p = 0; p < (r == 0 ? 1 : options[r - 1].size()); ++p) {
        const double from = r == 0 ? 0.0 : spans[r - 1].last + options[r - 1][p];
        const double sum = (r == 0 ? 0.0 : cost[p]) + (start - from) * (start - from);
        if (sum < next[k]) {
          next[k] = sum;
          back[r][k] = p;
        }
      }
    }
    cost = std::move(next);
  }
  std::vector<double> shifts(spans.size());
  std::size_t k =
      static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
  for (std::size_t r = spans.size(); r-- > 0;) {
    shifts[r] = options[r][k];
    k = back[r][k];
  }
  return shifts;
}

/// Endless: each run begins at the turn nearest to the end of the run before.
std::vector<double> nearestShifts(const std::vector<Span>& spans) {
  std::vector<double> shifts(spans.size());
  double from = 0.0;
  for (std::size_t r = 0; r < spans.size(); ++r) {
    shifts[r] = cell::nearestTurn(spans[r].first, from) - spans[r].first;
    from = spans[r].last + shifts[r];
  }
  return shifts;
}

/// The cable's twist of each run nearest to zero.
std::vector<double> cableShifts(const CellModel& model,
                                const std::vector<Waypoint>& points,
                                const Runs& runs,
                                double zero) {
  std::vector<double> shifts(runs.count());
  for (std::size_t r = 0; r < runs.count(); ++r) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t i = runs.begins[r]; i < runs.begins[r + 1]; ++i) {
      const double twist = model.cableTwist(points[i].joints, zero);
      low = std::min(low, twist);
      high = std::max(high, twist);
    }
    shifts[r] = model.cableSign() * cell::nearestTurn(0.0, -0.5 * (low + high));
  }
  return shifts;
}

/// Keeps of a run's shifts those with which the sums that end with this joint stay inside their
/// limits, where there are any: the joints before it have their turns already.
void keepSums(const Cell& cell,
              const std::vector<Waypoint>& points,
              std::size_t begin,
              std::size_t end,
              int joint,
              std::vector<double>& shifts) {
  for (const cell::JointSum& sum : cell.sums) {
    const auto last = std::find_if(sum.factors.rbegin(), sum.factors.rend(),
                                   [](double factor) { return factor != 0.0; });
    if (last == sum.factors.rend() || sum.factors.rend() - last - 1 != joint) {
      continue;
    }
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (std::size_t i = begin; i < end; ++i) {
      const double value = sum.value(points[i].joints);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    std::vector<double> kept;
    std::copy_if(shifts.begin(), shifts.end(), std::back_inserter(kept), [&](double shift) {
      const double moved = *last * shift;
      return low + moved >= sum.min - kSumSlack && high + moved <= sum.max + kSumSlack;
    });
    if (!kept.empty()) {
      shifts = std::move(kept);
    }
  }
}

}  // namespace

void chooseTurns(const Task& task, Motion& motion, const JobContext& context) {
  const Cell& cell = task.cell;
  std::vector<Waypoint>& points = motion.waypoints;
  for (int j = 0; j < cell.robotJoints(); ++j) {
    context.check();
    if (!cell::periodicJoint(cell, j) || points.empty()) {
      continue;
    }
    std::vector<Span> spans;
    for (std::size_t r = 0; r < task.runs.count(); ++r) {
      spans.push_back(follow(points, task.runs.begins[r], task.runs.begins[r + 1], j));
    }
    const cell::Joint& joint = cell.joint(j);
    std::vector<double> shifts;
    if (!joint.endless) {
      std::vector<std::vector<double>> options;
      for (std::size_t r = 0; r < spans.size(); ++r) {
        options.push_back(allowedShifts(joint, spans[r]));
        keepSums(cell, points, task.runs.begins[r], task.runs.begins[r + 1], j, options.back());
      }
      shifts = bestShifts(options, spans);
    } else if (cell.arm && j == 5 && task.params.cableLimit.value() > 0.0) {
      shifts = cableShifts(CellModel(cell), points, task.runs, task.params.cableZero.value());
    } else {
      shifts = nearestShifts(spans);
    }
    for (std::size_t r = 0; r < task.runs.count(); ++r) {
      for (std::size_t i = task.runs.begins[r]; i < task.runs.begins[r + 1] && shifts[r] != 0.0;
           ++i) {
        points[i].joints(j) += shifts[r];
      }
    }
  }
}

}  // namespace wcam::motion::detail
