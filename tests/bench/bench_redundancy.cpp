// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Redundancy resolution. Hemisphere of 71 layers: optimised motion against one polynomial per layer
// from many starts (Chalvin A32), both of which must keep all constraints and find Φ = 0. Graph
// search against a textbook Dijkstra on the same states and costs, which must find the same cost.
// A toolpath of 100 000 points with the 2-axis positioner.

#include "wcam/base/parallel.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/motion/collisions.hpp"

#include "../unit/motion/paths.hpp"
#include "cell_model.hpp"
#include "modes.hpp"
#include "search.hpp"
#include "timing.hpp"

#include <queue>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace wcam::motion {

namespace {

using detail::Rung;
using detail::RungStates;
using detail::SearchFrame;
using detail::Task;
using geometry::Vec3;

constexpr int kTorchBand = 2;  // as in search.cpp
constexpr int kTableBand = 1;
constexpr double kSameCost = 1e-3;
constexpr double kZeroMotion = 1e-5;

int failures = 0;

void check(bool good, const char* what) {
  if (!good) {
    std::printf("FAILED: %s\n", what);
    ++failures;
  }
}

Task taskOf(const toolpath::Toolpath& path, const cell::Cell& cell, const MotionParams& params) {
  std::vector<detail::Target> targets = detail::makeTargets(path, params, JobContext());
  detail::Runs runs = detail::findRuns(targets);
  const std::vector<detail::Positioning> aligned = {
      detail::positionPart(cell, targets, 0, JobContext())};
  return {cell, params, std::move(targets), std::move(runs), aligned, aligned};
}

/// Every bead point a rung.
SearchFrame frameOf(const Task& task) {
  SearchFrame frame;
  frame.gauge = detail::constantGauge(task);
  const detail::Segment& segment = task.runs.segments[0];
  for (std::size_t i = segment.first; i <= segment.last; ++i) {
    Rung rung;
    rung.target = i;
    rung.firstOfSegment = rung.firstOfRun = i == segment.first;
    if (!rung.firstOfSegment) {
      rung.time =
          (task.targets[i].p - task.targets[i - 1].p).norm() / task.targets[i].waypoint.speed;
    }
    frame.rungs.push_back(rung);
  }
  frame.points = frame.rungs.size();
  return frame;
}

/// Cost of a step, plainly: the objectives Motion, Positioner and Winding, and the speed penalty.
class PlainCost {
public:
  explicit PlainCost(const Task& task) : task_(task), model_(task.cell) {}

  double step(const Rung& rung,
              const RungStates& from,
              std::size_t fromTable,
              std::size_t fromLane,
              const RungStates& to,
              std::size_t toTable,
              std::size_t toLane) const {
    const cell::Cell& cell = task_.cell;
    double cost = 0.0;
    double fastest = 0.0;
    for (int j = 0; j < 6; ++j) {
      const cell::Joint& joint = cell.joint(j);
      double d = static_cast<double>(to.row(j, toTable)[toLane]) -
                 static_cast<double>(from.row(j, fromTable)[fromLane]);
      if (joint.endless ||
          (cell.arm->periodic[static_cast<std::size_t>(j)] && joint.max - joint.min > 2.0 * kPi)) {
        d = cell::wrapAngle(d);
      }
      const double degrees = radToDeg(d);
      cost += task_.params.weightMotion * model_.motionWeight(j) * degrees * degrees;
      if (joint.endless) {
        cost += task_.params.weightWinding / 360.0 * degrees * degrees;
      }
      fastest = std::max(fastest, d * d / std::pow(joint.maxSpeed * rung.time, 2));
    }
    cost += penalty(fastest);
    const cell::Joint& table = cell.joint(7);
    const double turn = cell::wrapAngle(to.tableValues[toTable] - from.tableValues[fromTable]);
    return cost + task_.params.weightPositioner / 360.0 * std::pow(radToDeg(turn), 2) +
           penalty(turn * turn / std::pow(table.maxSpeed * rung.time, 2));
  }

private:
  static double penalty(double ratio) {
    return ratio > 1.0 ? detail::SearchPenalty::kTooFast * std::min(ratio, 16.0) : 0.0;
  }

  const Task& task_;
  detail::CellModel model_;
};

std::vector<RungStates> statesOf(const Task& task, const SearchFrame& frame) {
  const detail::StateBuilder builder(task, frame);
  std::vector<RungStates> rungs(frame.rungs.size());
  for (std::size_t r = 0; r < rungs.size(); ++r) {
    builder.build(frame.rungs[r], rungs[r]);
  }
  return rungs;
}

/// Textbook Dijkstra with a priority queue over (rung, state).
double dijkstra(const Task& task, const SearchFrame& frame) {
  const detail::StateBuilder builder(task, frame);
  const PlainCost plain(task);
  const std::vector<RungStates> rungs = statesOf(task, frame);
  constexpr std::size_t kLanes = detail::kLanes;
  std::vector<std::vector<double>> distance(rungs.size());
  using Entry = std::pair<double, std::pair<std::size_t, std::size_t>>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::size_t r = 0; r < rungs.size(); ++r) {
    distance[r].assign(rungs[r].cost.size(), std::numeric_limits<double>::infinity());
  }
  for (std::size_t n = 0; n < rungs[0].cost.size(); ++n) {
    distance[0][n] = static_cast<double>(rungs[0].cost[n]);
    queue.push({distance[0][n], {0, n}});
  }
  while (!queue.empty()) {
    const auto [cost, node] = queue.top();
    queue.pop();
    const auto [r, n] = node;
    if (cost > distance[r][n]) {
      continue;
    }
    if (r + 1 == rungs.size()) {
      return cost;
    }
    const std::size_t table = n / kLanes;
    const std::size_t lane = n % kLanes;
    const RungStates& to = rungs[r + 1];
    for (std::size_t next = 0; next < to.tables.size(); ++next) {
      const double turn = cell::wrapAngle(to.tableValues[next] - rungs[r].tableValues[table]);
      if (std::abs(turn) > (kTableBand + 0.5) * builder.tableStep() &&
          to.tables[next] != rungs[r].tables[table]) {
        continue;
      }
      for (int shift = -kTorchBand; shift <= kTorchBand; ++shift) {
        const std::size_t nextLane =
            (lane + kLanes + static_cast<std::size_t>(shift + 36) * 8) % kLanes;
        const double total =
            cost + plain.step(frame.rungs[r + 1], rungs[r], table, lane, to, next, nextLane) +
            static_cast<double>(to.cost[next * kLanes + nextLane]);
        double& known = distance[r + 1][next * kLanes + nextLane];
        if (total < known) {
          known = total;
          queue.push({total, {r + 1, next * kLanes + nextLane}});
        }
      }
    }
  }
  return std::numeric_limits<double>::infinity();
}

void benchHemisphere() {
  const ThreadLimit one(1);
  const cell::Cell cell = test::shippedCell("fanuc_arcmate120ic_part_carried");
  const toolpath::Toolpath path = test::hemisphere(45.0, 1.0, 149);
  bench::Times own;
  bench::Times polynomial;
  PlannedMotion optimized;
  PlannedMotion reference;
  MotionParams params;
  MotionParams byLayer;
  byLayer.mode = RedundancyMode::Polynomial;
  byLayer.polynomialDegree = 1;
  for (int k = 0; k < 3; ++k) {
    optimized = own.measure([&] { return planMotion(path, cell, params, "op", JobContext()); });
    reference =
        polynomial.measure([&] { return planMotion(path, cell, byLayer, "op", JobContext()); });
  }
  check(optimized.statistics.evaluation.feasible(),
        "the optimised hemisphere keeps all constraints");
  check(optimized.statistics.evaluation.value(Objective::Motion) < kZeroMotion, "motion is zero");
  check(reference.statistics.evaluation.value(Objective::Motion) < kZeroMotion,
        "motion of the polynomials is zero");
  std::printf(
      "hemisphere, %zu layers, %zu points, 1 thread: optimised %.3f s (first %.3f s), cost %.5f; "
      "polynomials of degree 1 by multi-start %.3f s, cost %.5f; ratio %.1f\n",
      path.layers.size(), path.pointCount(), own.min(), own.first(),
      optimized.statistics.evaluation.cost, polynomial.min(), reference.statistics.evaluation.cost,
      polynomial.min() / own.min());
}

void benchSearch() {
  const ThreadLimit one(1);
  const cell::Cell cell = test::shippedCell("fanuc_arcmate120ic");
  MotionParams params;
  params.weightPositioner = 0.01;  // so that the table takes part
  const auto task = [&](int points, double radius) {
    return taskOf(test::circleFrom(radius, points, Vec3::Zero(), 0.3), cell, params);
  };
  const Task small = task(24, 100.0);
  const SearchFrame smallFrame = frameOf(small);
  bench::Times own;
  bench::Times plain;
  bench::Times states;
  RungStates memory;
  double cost = 0.0;
  double reference = 0.0;
  for (int k = 0; k < 5; ++k) {
    // In memory that is there, as the search makes them.
    states.measure([&] {
      const detail::StateBuilder builder(small, smallFrame);
      for (const Rung& rung : smallFrame.rungs) {
        builder.build(rung, memory);
      }
      return memory.cost.size();
    });
    cost =
        own.measure([&] { return detail::searchGraph(small, smallFrame, {}, JobContext()).cost; });
    reference = plain.measure([&] { return dijkstra(small, smallFrame); });
  }
  check(std::abs(cost - reference) <= kSameCost * reference, "both searches find the same cost");
  std::printf(
      "graph, %zu rungs of 6912 states, 1 thread: %.4f s (%.3f ms per rung with IK), cost %.5f; "
      "Dijkstra on the same states %.3f s, cost %.5f; ratio %.1f, without the states, %.4f s, that "
      "both "
      "make: ratio %.1f\n",
      smallFrame.rungs.size(), own.min(),
      1e3 * own.min() / static_cast<double>(smallFrame.rungs.size()), cost, plain.min(), reference,
      plain.min() / own.min(), states.min(),
      (plain.min() - states.min()) / (own.min() - states.min()));
  const Task large = task(10000, 300.0);
  const SearchFrame largeFrame = frameOf(large);
  bench::Times whole;
  const double total =
      whole.measure([&] { return detail::searchGraph(large, largeFrame, {}, JobContext()).cost; });
  std::printf("graph, 10000 rungs of 6912 states, 1 thread with IK: %.2f s, cost %.5f\n",
              whole.min(), total);
}

void benchLong() {
  const ThreadLimit two(2);
  const cell::Cell cell = test::shippedCell("fanuc_arcmate120ic");
  const toolpath::Toolpath path = test::leaningCircles(100, 25, 999, 0.8);
  bench::Times times;
  const PlannedMotion planned =
      times.measure([&] { return planMotion(path, cell, MotionParams(), "op", JobContext()); });
  check(planned.statistics.evaluation.violations() == 0, "the long path is reached inside limits");
  std::printf("%zu points with the 2-axis positioner, 2 threads: %.2f s, cost %.5f, %zu broken\n",
              path.pointCount(), times.min(), planned.statistics.evaluation.cost,
              planned.statistics.evaluation.allBroken());
  bench::Times checked;
  const CheckedMotion whole = checked.measure(
      [&] { return planCheckedMotion(path, cell, nullptr, MotionParams(), "op", JobContext()); });
  std::printf(
      "the same with collisions and findings: %.2f s, %zu points collide (%zu states looked at)\n",
      checked.min(), whole.collisions.collidingPoints, whole.collisions.states);
}

}  // namespace

/// All parts, or the one that is named.
void bench(const std::string& part) {
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  if (part.empty() || part == "hemisphere") {
    benchHemisphere();
  }
  if (part.empty() || part == "graph") {
    benchSearch();
  }
  if (part.empty() || part == "long") {
    benchLong();
  }
}

int failed() {
  return failures;
}

}  // namespace wcam::motion

int main(int argc, char** argv) {
  wcam::motion::bench(argc > 1 ? argv[1] : "");
  return wcam::motion::failed() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
