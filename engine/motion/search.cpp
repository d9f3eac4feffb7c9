// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search.hpp"

#include "wcam/base/large_pages.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/cell/unwrap.hpp"

#include "cell_model.hpp"
#include "modes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory_resource>
#include <numeric>

namespace wcam::motion::detail {

namespace {

/// Band of the torch (samples to either side) and of the table.
constexpr int kTorchBand = 2;
constexpr int kTableBand = 1;
/// Rungs whose states are made at once, by all threads.
constexpr std::size_t kBatch = 32;
/// A joint move looks at every state before it up to this many, else at the best ones.
constexpr std::size_t kAllStates = 512;
/// Above any cost of a path; finite for the kernel.
constexpr float kNone = std::numeric_limits<float>::max();

/// The 16-bit back pointers of a rung: table index·2·kLanes + lane (both halves) of the rung
/// before.
using BackPointers = std::uint16_t*;
static_assert(kTableSamples * 2 * kLanes <= 65536);
static_assert(kLanes % kLaneBlock == 0);

/// Of a joint that the robot does not have: at rest. The twist's row is left out instead.
const float* unusedRow(int row) {
  static constexpr std::array<float, 2 * kLanes> kRest{};
  return row + 1 == kSearchRows ? nullptr : kRest.data();
}

struct Column {
  RungStates states;
  std::vector<float> cost;  ///< 2·kLanes per table, the second half a copy
};

class Search {
public:
  Search(const Task& task, const SearchFrame& frame, const ExtraCosts& extra)
      : task_(task), frame_(frame), extra_(extra), builder_(task, frame), model_(task.cell) {}

  SearchPath run(const JobContext& context) {
    const std::size_t count = frame_.rungs.size();
    back_.resize(count);
    tables_.resize(count);
    std::vector<RungStates> batch(std::min(kBatch, count));
    Column before;
    Column now;
    for (std::size_t begin = 0; begin < count; begin += kBatch) {
      context.check();
      const std::size_t size = std::min(kBatch, count - begin);
      parallelFor(
          size, 1, [&](std::size_t k) { builder_.build(frame_.rungs[begin + k], batch[k]); },
          context);
      for (std::size_t k = 0; k < size; ++k) {
        const std::size_t r = begin + k;
        addExtra(r, batch[k]);
        // The batch gets the memory of the rung before last.
        std::swap(now.states, batch[k]);
        tables_[r] = now.states.tables;
        step(r, before, now);
        std::swap(before, now);
      }
    }
    return trace(before);
  }

private:
  void addExtra(std::size_t r, RungStates& states) const {
    const auto found = extra_.find(r);
    if (found != extra_.end()) {
      for (std::size_t n = 0; n < states.cost.size() && n < found->second.size(); ++n) {
        states.cost[n] += found->second[n];
      }
    }
  }

  /// Costs of the steps to rung r; per joint and for the table.
  struct Steps {
    StepCost robot{};
    double table = 0.0;       ///< per rad²
    double tableSpeed = 0.0;  ///< greatest step, rad; 0: no bound
    bool tableWraps = false;
  };

  Steps stepsTo(const Rung& rung, bool travel) const {
    const Cell& cell = task_.cell;
    const MotionParams& params = task_.params;
    Steps steps;
    steps.robot.tooFast = travel ? 0.0F : SearchPenalty::kTooFast;
    const double degrees2 = radToDeg(1.0) * radToDeg(1.0);
    const double n = static_cast<double>(rung.steps);
    for (int j = 0; j < cell.jointCount(); ++j) {
      const cell::Joint& joint = cell.joint(j);
      const bool robot = j < cell.robotJoints();
      // To squared degrees, or mm.
      const double unit2 = joint.prismatic() ? 1.0 : degrees2;
      double weight = 0.0;
      if (travel) {
        weight = params.weightTransition * unit2 / model_.travelRange(j);
      } else {
        // n equal steps make 1/n of the square of their sum.
        weight = (robot ? params.weightMotion * model_.motionWeight(j)
                        : params.weightPositioner / 360.0) *
                 unit2 / n;
        if (robot && joint.endless && !cell.partCarried()) {
          weight += params.weightWinding / 360.0 * unit2 / n;
        }
        if (rung.time > 0.0) {
          const double most = joint.maxSpeed * rung.time;
          weight += params.weightSpeed * n / (most * most) / static_cast<double>(frame_.points);
        }
      }
      const double most = joint.maxSpeed * rung.time;
      const bool bounded = !travel && rung.time > 0.0;
      const bool wraps = joint.endless || (robot && wrapsInside(j));
      if (robot) {
        steps.robot.weight[j] = static_cast<float>(weight);
        steps.robot.inverseSpeed2[j] = bounded ? static_cast<float>(1.0 / (most * most)) : 0.0F;
        steps.robot.wraps[j] = wraps;
      } else if (j == cell.jointCount() - 1) {
        steps.table = weight;
        steps.tableSpeed = bounded ? most : 0.0;
        steps.tableWraps = joint.endless;
      }
    }
    // The twist's difference must not jump over the forbidden side.
    steps.robot.weight[6] = 0.0F;
    steps.robot.inverseSpeed2[6] = travel ? 0.0F : static_cast<float>(1.0 / (kPi * kPi));
    steps.robot.wraps[6] = false;
    return steps;
  }

  /// A limited joint whose range holds more than a turn may pass ±π.
  bool wrapsInside(int j) const {
    const cell::Joint& joint = task_.cell.joint(j);
    return model_.periodic(j) && joint.max - joint.min > 2.0 * kPi && (j != 3 || frame_.fourWraps);
  }

  double tableCost(const Steps& steps, double from, double to) const {
    const double d = steps.tableWraps ? cell::wrapAngle(to - from) : to - from;
    double cost = steps.table * d * d;
    if (steps.tableSpeed > 0.0) {
      const double ratio = d * d / (steps.tableSpeed * steps.tableSpeed);
      cost += ratio > 1.0 ? SearchPenalty::kTooFast * std::min(ratio, 16.0) : 0.0;
    }
    return cost;
  }

  void rowsOf(const RungStates& states,
              std::size_t table,
              std::size_t offset,
              const float** rows) const {
    for (int r = 0; r < kSearchRows; ++r) {
      rows[r] = states.rows[r].empty() ? unusedRow(r) : states.row(r, table) + offset;
    }
  }

  /// Table samples of the rung before from which one of this rung may be reached.
  void tableBand(const RungStates& before,
                 int sample,
                 double value,
                 bool wraps,
                 bool wide,
                 std::vector<std::size_t>& band) const {
    band.clear();
    const double reach = (kTableBand + 0.5) * builder_.tableStep();
    for (std::size_t k = 0; k < before.tables.size(); ++k) {
      const double d = value - before.tableValues[k];
      if (wide || std::abs(wraps ? cell::wrapAngle(d) : d) <= reach || before.tables[k] == sample) {
        band.push_back(k);
      }
    }
    if (band.empty()) {
      // The reference jumps: any sample, at the price of its speed.
      tableBand(before, sample, value, wraps, true, band);
    }
  }

  void step(std::size_t r, const Column& before, Column& now) {
    const Rung& rung = frame_.rungs[r];
    const std::size_t states = now.states.cost.size();
    now.cost.resize(2 * states);
    back_[r] = static_cast<BackPointers>(
        backMemory_.allocate(states * sizeof(std::uint16_t), alignof(std::uint16_t)));
    std::vector<float>& best = best_;
    best.assign(states, r > 0 ? kNone : 0.0F);
    if (r > 0) {
      if (rung.firstOfRun) {
        relaxJointMove(rung, before, now, best, back_[r]);
      } else {
        relaxBand(rung, before, now, best, back_[r]);
      }
    }
    float least = kNone;
    for (std::size_t n = 0; n < states; ++n) {
      best[n] += now.states.cost[n];
      least = std::min(least, best[n]);
    }
    // Only differences matter: costs stay small and keep their digits.
    offset_ += static_cast<double>(least);
    for (std::size_t n = 0; n < states; ++n) {
      const float cost = best[n] - least;
      float* own = now.cost.data() + n / kLanes * 2 * kLanes;
      own[n % kLanes] = cost;
      own[n % kLanes + kLanes] = cost;
    }
  }

  void relaxBand(const Rung& rung,
                 const Column& before,
                 Column& now,
                 std::vector<float>& best,
                 std::uint16_t* back) {
    const bool link = rung.firstOfSegment;
    const Steps steps = stepsTo(rung, link);
    const int band = link ? kTorchSamples / 2 : kTorchBand;
    std::array<std::int32_t, kLanes> choice;
    std::vector<StepSource>& sources = sources_;
    for (std::size_t table = 0; table < now.states.tables.size(); ++table) {
      const float* to[kSearchRows];
      rowsOf(now.states, table, 0, to);
      sources.clear();
      const double value = now.states.tableValues[table];
      tableBand(before.states, now.states.tables[table], value, steps.tableWraps, link, band_);
      for (const std::size_t from : band_) {
        StepSource source;
        source.base = static_cast<float>(tableCost(steps, before.states.tableValues[from], value));
        for (int shift = -band; shift <= band; ++shift) {
          const auto offset = static_cast<std::size_t>((shift + kTorchSamples) % kTorchSamples) *
                              cell::Branch::kCount;
          rowsOf(before.states, from, offset, source.rows);
          source.cost = before.cost.data() + from * 2 * kLanes + offset;
          source.start = static_cast<std::int32_t>(from * 2 * kLanes + offset);
          sources.push_back(source);
        }
      }
      choice.fill(sources.front().start);
      relaxLanes(to, sources.data(), static_cast<int>(sources.size()), steps.robot, kLanes,
                 best.data() + table * kLanes, choice.data());
      for (int n = 0; n < kLanes; ++n) {
        back[table * kLanes + static_cast<std::size_t>(n)] =
            static_cast<std::uint16_t>(choice[static_cast<std::size_t>(n)] + n);
      }
    }
  }

  /// States of the rung before from which a joint move may start.
  std::vector<std::size_t> startsOf(const Column& before) const {
    const std::size_t tables = before.states.tables.size();
    std::vector<std::size_t> starts;
    if (tables * kLanes <= kAllStates) {
      for (std::size_t n = 0; n < tables * kLanes; ++n) {
        starts.push_back(n / kLanes * 2 * kLanes + n % kLanes);
      }
      return starts;
    }
    for (std::size_t table = 0; table < tables; ++table) {
      for (std::size_t b = 0; b < cell::Branch::kCount; ++b) {
        std::size_t least = table * 2 * kLanes + b;
        for (std::size_t t = 0; t < kTorchSamples; ++t) {
          const std::size_t at = table * 2 * kLanes + t * cell::Branch::kCount + b;
          least = before.cost[at] < before.cost[least] ? at : least;
        }
        starts.push_back(least);
      }
    }
    return starts;
  }

  void relaxJointMove(const Rung& rung,
                      const Column& before,
                      Column& now,
                      std::vector<float>& best,
                      std::uint16_t* back) const {
    const Steps steps = stepsTo(rung, true);
    const std::vector<std::size_t> starts = startsOf(before);
    std::vector<StepSource> sources(starts.size());
    for (std::size_t s = 0; s < starts.size(); ++s) {
      for (int r = 0; r < kSearchRows; ++r) {
        const std::vector<float>& row = before.states.rows[r];
        sources[s].rows[r] = row.empty() ? unusedRow(r) : row.data() + starts[s];
      }
      sources[s].cost = before.cost.data() + starts[s];
      sources[s].start = static_cast<std::int32_t>(starts[s]);
    }
    std::array<std::int32_t, kLanes> choice;
    for (std::size_t table = 0; table < now.states.tables.size(); ++table) {
      const float* to[kSearchRows];
      rowsOf(now.states, table, 0, to);
      for (std::size_t s = 0; s < starts.size(); ++s) {
        const double from = before.states.tableValues[starts[s] / (2 * kLanes)];
        sources[s].base = static_cast<float>(tableCost(steps, from, now.states.tableValues[table]));
      }
      choice.fill(sources.front().start);
      relaxFromStates(to, sources.data(), static_cast<int>(sources.size()), steps.robot, kLanes,
                      best.data() + table * kLanes, choice.data());
      for (std::size_t n = 0; n < kLanes; ++n) {
        back[table * kLanes + n] = static_cast<std::uint16_t>(choice[n]);
      }
    }
  }

  SearchPath trace(const Column& last) const {
    const std::size_t count = frame_.rungs.size();
    SearchPath path;
    path.tableOffset.resize(count);
    path.torchSample.resize(count);
    path.branch.resize(count);
    path.state.resize(count);
    std::size_t state = 0;
    for (std::size_t n = 0; n < last.states.cost.size(); ++n) {
      const auto at = [&last](std::size_t k) {
        return last.cost[k / kLanes * 2 * kLanes + k % kLanes];
      };
      state = at(n) < at(state) ? n : state;
    }
    path.cost = offset_;
    path.tableFree = std::any_of(tables_.begin(), tables_.end(),
                                 [](const std::vector<int>& t) { return t.size() > 1; });
    for (std::size_t r = count; r-- > 0;) {
      const std::size_t lane = state % kLanes;
      path.state[r] = state;
      path.tableOffset[r] = tables_[r][state / kLanes] * builder_.tableStep();
      path.torchSample[r] = static_cast<double>(lane / cell::Branch::kCount);
      path.branch[r] = static_cast<int>(lane % cell::Branch::kCount);
      if (r == 0) {
        break;
      }
      const std::size_t from = back_[r][state];
      state = from / (2 * kLanes) * kLanes + from % kLanes;
    }
    for (std::size_t r = 1; r < count; ++r) {
      path.torchSample[r] +=
          kTorchSamples *
          std::round((path.torchSample[r - 1] - path.torchSample[r]) / kTorchSamples);
    }
    return path;
  }

  const Task& task_;
  const SearchFrame& frame_;
  const ExtraCosts& extra_;
  StateBuilder builder_;
  CellModel model_;
  LargePages pages_;
  std::pmr::monotonic_buffer_resource backMemory_{&pages_};
  std::vector<BackPointers> back_;
  std::vector<std::vector<int>> tables_;
  double offset_ = 0.0;
  // Memory of a step, kept from rung to rung.
  std::vector<float> best_;
  std::vector<std::size_t> band_;
  std::vector<StepSource> sources_;
};

}  // namespace

SearchPath searchGraph(const Task& task,
                       const SearchFrame& frame,
                       const ExtraCosts& extra,
                       const JobContext& context) {
  return Search(task, frame, extra).run(context);
}

Resolution resolutionOf(const Task& task, const SearchFrame& frame, const SearchPath& path) {
  const StateBuilder builder(task, frame);
  const Cell& cell = task.cell;
  const bool table = !cell.partCarried() && cell.positionerJoints() > 0;
  const auto last = static_cast<std::size_t>(std::max(cell.positionerJoints() - 1, 0));
  const std::vector<PositionerValues>& reference = task.references[frame.family].joints;
  Resolution resolution;
  resolution.choices.resize(task.targets.size());
  resolution.branches.resize(task.runs.count());
  // The table's offset with full turns, so that its value is continuous from rung to rung.
  std::vector<double> offset = path.tableOffset;
  for (std::size_t r = 1; r < offset.size() && table; ++r) {
    const double value = reference[frame.rungs[r].target][last] + offset[r];
    const double before = reference[frame.rungs[r - 1].target][last] + offset[r - 1];
    if (cell.joint(cell.jointCount() - 1).endless) {
      offset[r] += cell::nearestTurn(value, before) - value;
    }
  }
  for (std::size_t r = 0; r < frame.rungs.size(); ++r) {
    const Rung& rung = frame.rungs[r];
    resolution.branches[task.runs.segments[rung.segment].run] = path.branch[r];
    resolution.choices[rung.target] =
        builder.choice(rung.target, table ? offset[r] : 0.0, path.torchSample[r]);
    if (rung.firstOfSegment) {
      continue;
    }
    const std::size_t begin = frame.rungs[r - 1].target;
    std::vector<double> way(rung.target - begin + 1, 0.0);
    for (std::size_t k = 1; k < way.size(); ++k) {
      way[k] = way[k - 1] + (task.targets[begin + k].p - task.targets[begin + k - 1].p).norm();
    }
    for (std::size_t k = 1; k + 1 < way.size(); ++k) {
      const double s = way.back() > 0.0 ? way[k] / way.back() : 0.0;
      resolution.choices[begin + k] = builder.choice(
          begin + k, table ? offset[r - 1] + s * (offset[r] - offset[r - 1]) : 0.0,
          path.torchSample[r - 1] + s * (path.torchSample[r] - path.torchSample[r - 1]));
    }
  }
  spreadToTravel(task.runs, resolution.choices);
  return resolution;
}

std::vector<double> constantGauge(const Task& task) {
  return std::vector<double>(task.targets.size(), task.params.torchRotation.value());
}

std::vector<double> followingGauge(const Task& task, std::size_t family) {
  const Cell& cell = task.cell;
  std::vector<double> gauge(task.targets.size(), 0.0);
  double before = task.params.torchRotation.value();
  for (std::size_t i = 0; i < gauge.size(); ++i) {
    const Target& target = task.targets[i];
    double angle = before;
    if (cell.partCarried()) {
      // The part turns against its azimuth: R_Z = −θ + b0 (A32).
      if (std::hypot(target.along.x(), target.along.y()) > 1e-9) {
        angle = -std::atan2(target.along.y(), target.along.x());
      }
    } else {
      const Eigen::Matrix3d R_base_part =
          cell::chainPose(cell.positioner, task.references[family].joints[i].data()).linear() *
          cell.T_table_part.linear();
      const Eigen::Matrix3d frame = cell::frameWithZ(R_base_part * target.axis, 0.0);
      const Vec3 along = frame.transpose() * (R_base_part * target.along);
      if (std::hypot(along.x(), along.y()) > 1e-9) {
        angle = std::atan2(along.y(), along.x());
      }
    }
    gauge[i] = cell::nearestTurn(angle, before);
    before = gauge[i];
  }
  return gauge;
}

}  // namespace wcam::motion::detail
