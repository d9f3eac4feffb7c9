// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"
#include "wcam/base/quantity.hpp"

#include "modes.hpp"
#include "refine.hpp"
#include "search.hpp"

#include <algorithm>
#include <atomic>

namespace wcam::motion::detail {

namespace {

/// Rungs of the search at most: some seconds at 6912 states each.
constexpr std::size_t kMostRungs = 8000;
/// Point by point and polynomial are candidates up to this many targets: on longer paths they
/// would take longer than everything else together. Their own objective apart.
constexpr std::size_t kAllModesTargets = 2000;

/// Both gauges are refined up to this many targets, else the better one.
constexpr std::size_t kBothGaugesTargets = 4000;
/// The table's samples are searched up to this many rungs (half a second each thousand), else only
/// where the gravity-aligned reference alone does not keep all constraints.
constexpr std::size_t kTableRungs = 1500;
/// The same of robots whose inverse kinematics are a search, some 20 µs each.
constexpr std::size_t kAllModesFollowed = 200;
/// Constant rotations that stand for the graph search of such robots.
constexpr int kRotations = 12;
/// Part of the tilt's tolerance with which the search leans: the refinement takes back what is not
/// needed and keeps a little less than the tolerance.
constexpr double kTiltUsed = 0.95;
/// Searches with newly found collisions at most; each finds those of the path before.
constexpr int kCollisionRounds = 12;
/// States that a search compares with the cell at most, some 30 µs each: where nearly everything
/// collides, more of them find no way either.
constexpr std::size_t kMostCollisionStates = 100000;
/// Searches and refinements of a family: two gauges.
constexpr std::size_t kStepsOfFamily = 4;
/// Cost of a colliding state: below a state outside limits, above a singular one; and per
/// kDepthUnit (mm) of depth.
constexpr float kCollisionCost = 5e3F;
constexpr float kDepthUnit = 10.0F;

/// Clearance of the states of a rung that come into question as costs; `lookedAt` counts them.
std::vector<float> collisionCosts(const Task& task,
                                  const SearchFrame& frame,
                                  const Rung& rung,
                                  const collision::Clearance& clearance,
                                  std::size_t& lookedAt) {
  const Cell& cell = task.cell;
  const StateBuilder builder(task, frame);
  RungStates states;
  builder.build(rung, states);
  std::vector<collision::CellState> cellStates;
  std::vector<std::size_t> indices;
  for (std::size_t n = 0; n < states.cost.size(); ++n) {
    if (states.cost[n] >= SearchPenalty::kOutside) {
      continue;  // out of reach or limits: worse than any collision
    }
    const std::size_t table = n / kLanes;
    cell::JointVector q(cell.jointCount());
    for (int j = 0; j < cell.robotJoints(); ++j) {
      q(j) = static_cast<double>(states.row(j, table)[n % kLanes]);
    }
    for (int j = 0; j < cell.positionerJoints(); ++j) {
      q(cell.robotJoints() + j) =
          task.references[frame.family].joints[rung.target][static_cast<std::size_t>(j)];
    }
    if (cell.positionerJoints() > 0) {
      q(cell.jointCount() - 1) = states.tableValues[table];
    }
    cellStates.push_back({q, task.targets[rung.target].waypoint.deposited});
    indices.push_back(n);
  }
  lookedAt += cellStates.size();
  std::vector<float> distances(cellStates.size());
  clearance.evaluate(cellStates, distances);
  std::vector<float> costs(states.cost.size(), 0.0F);
  for (std::size_t k = 0; k < distances.size(); ++k) {
    costs[indices[k]] =
        distances[k] < 0.0F ? kCollisionCost * (1.0F - distances[k] / kDepthUnit) : 0.0F;
  }
  return costs;
}

class Optimizer {
public:
  Optimizer(const Task& task,
            bool searches,
            const JobContext& context,
            const collision::Clearance* clearance)
      : task_(task), searches_(searches), context_(context), clearance_(clearance) {}

  /// The candidates side by side, compared in a fixed order.
  Candidate run() {
    std::vector<RedundancyMode> named;
    for (int m = static_cast<int>(RedundancyMode::PointByPoint); m < kRedundancyModes; ++m) {
      if (isCandidate(static_cast<RedundancyMode>(m))) {
        named.push_back(static_cast<RedundancyMode>(m));
      }
    }
    const std::size_t families = searches_ ? task_.references.size() : 0;
    // The searches first: they take longest.
    std::vector<std::vector<Candidate>> found(families + 1 + named.size());
    expected_ = kStepsOfFamily * families + 1 + named.size();
    parallelFor(
        found.size(), 1,
        [&](std::size_t k) {
          if (k < families) {
            found[k] = tryFamily(k);
          } else if (k == families) {
            found[k].push_back(
                candidate(RedundancyMode::Constant, resolveConstant(task_, context_)));
            advance();
          } else {
            const RedundancyMode mode = named[k - families - 1];
            found[k].push_back(candidate(mode, resolveNamed(mode, task_, context_)));
            advance();
          }
        },
        context_);
    Candidate best = std::move(found[families].front());
    found[families].clear();
    std::rotate(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(families), found.end());
    for (std::vector<Candidate>& group : found) {
      for (Candidate& candidate : group) {
        if (candidate.evaluation.betterThan(best.evaluation)) {
          best = std::move(candidate);
        }
      }
    }
    return best;
  }

private:
  /// Tells that one more step is done: a candidate, a search or a refinement. There may be more of
  /// them than expected, then the progress waits for the end.
  void advance() const {
    const double done = static_cast<double>(++done_);
    context_.report(std::min(done / static_cast<double>(expected_ + 1), 1.0));
  }

  Candidate candidate(RedundancyMode mode, Resolution resolution) const {
    return makeCandidate(task_, mode, std::move(resolution), context_, clearance_);
  }

  [[nodiscard]] bool isCandidate(RedundancyMode mode) const {
    const bool slow = mode == RedundancyMode::PointByPoint || mode == RedundancyMode::Polynomial;
    // Without a positioner there is nothing to keep at rest.
    const bool same = mode == RedundancyMode::Fixed &&
                      (task_.cell.partCarried() || task_.cell.positionerJoints() == 0);
    const std::size_t most = isFollowed(task_.cell) ? kAllModesFollowed : kAllModesTargets;
    // Who asks for a mode's own objective gets nothing worse than the mode, however long it takes.
    const bool tooLong =
        slow && task_.targets.size() > most && task_.params.weights() != ownObjective(mode);
    return !same && !lacksPositioner(mode, task_.cell) && !tooLong;
  }

  /// Search and refinement from one gravity-aligned reference.
  [[nodiscard]] std::vector<Candidate> tryFamily(std::size_t family) const {
    if (isFollowed(task_.cell)) {
      return tryRotations(family);
    }
    SearchFrame frame;
    frame.family = family;
    frame.rungs = chooseRungs(task_, family, kMostRungs);
    frame.points = 0;
    for (const Segment& segment : task_.runs.segments) {
      frame.points += segment.last - segment.first + 1;
    }
    frame.moveTable = frame.rungs.size() <= kTableRungs;
    std::vector<Candidate> found = tryGauges(frame);
    const auto addGauges = [&] {
      for (Candidate& own : tryGauges(frame)) {
        found.push_back(std::move(own));
      }
    };
    if (!frame.moveTable && !anyFeasible(found)) {
      frame.moveTable = true;
      addGauges();
    }
    // Search with the torch leaning over the whole operation: the refinement alone does not find
    // out of what is out of reach, nor from one branch to another.
    const double most = kTiltUsed * task_.params.tiltTolerance.value();
    for (const auto& [lead, lateral] : {std::pair(most, 0.0), std::pair(-most, 0.0),
                                        std::pair(0.0, most), std::pair(0.0, -most)}) {
      if (most > 0.0 && !anyFeasible(found)) {
        frame.lead = lead;
        frame.lateral = lateral;
        addGauges();
      }
    }
    return found;
  }

  static bool anyFeasible(const std::vector<Candidate>& found) {
    return std::any_of(found.begin(), found.end(),
                       [](const Candidate& own) { return own.evaluation.feasible(); });
  }

  /// Constant rotations, and the refinement of the best one: where the branches of the inverse
  /// kinematics are start postures, states cannot be told apart for a graph search.
  [[nodiscard]] std::vector<Candidate> tryRotations(std::size_t family) const {
    const bool turns = task_.cell.inverse->freeRotation();
    const bool table = !task_.cell.partCarried() && task_.cell.positionerJoints() > 0;
    Candidate best;
    for (int k = 0; k < (turns ? kRotations : 1); ++k) {
      Resolution resolution;
      resolution.choices = constantRotation(task_, task_.references[family].joints);
      for (FreeChoice& choice : resolution.choices) {
        choice.torchRotation += k * 2.0 * kPi / kRotations;
      }
      resolution.branches = oneBranch(task_, resolution.choices, context_);
      Candidate own = candidate(RedundancyMode::Optimized, std::move(resolution));
      if (k == 0 || own.evaluation.betterThan(best.evaluation)) {
        best = std::move(own);
      }
    }
    std::vector<Candidate> found;
    found.push_back(refined({constantGauge(task_), family, table}, std::move(best)));
    return found;
  }

  /// Refinement of a candidate where anything is free.
  [[nodiscard]] Candidate refined(const RefineFrame& frame, Candidate start) const {
    const bool free = task_.cell.inverse->freeRotation() || frame.moveTable ||
                      task_.params.tiltTolerance.value() > 0.0;
    return free ? refine(task_, frame, start, context_, clearance_) : start;
  }

  /// Search and refinement with both gauges of the torch rotation.
  [[nodiscard]] std::vector<Candidate> tryGauges(SearchFrame& frame) const {
    std::vector<std::pair<RefineFrame, Candidate>> searches;
    for (const bool following : {false, true}) {
      frame.gauge = following ? followingGauge(task_, frame.family) : constantGauge(task_);
      bool tableFree = false;
      Candidate own = searched(frame, &tableFree);
      advance();
      searches.emplace_back(RefineFrame{frame.gauge, frame.family, tableFree}, std::move(own));
      if (tableFree || !task_.cell.inverse->freeRotation()) {
        break;  // the table can follow the path instead, or nothing turns about the torch
      }
    }
    const std::size_t better = searches.size() > 1 && searches[1].second.evaluation.betterThan(
                                                          searches[0].second.evaluation)
                                   ? 1
                                   : 0;
    std::vector<Candidate> found;
    for (std::size_t k = 0; k < searches.size(); ++k) {
      if (k == better || task_.targets.size() <= kBothGaugesTargets) {
        found.push_back(refined(searches[k].first, std::move(searches[k].second)));
        advance();
      }
    }
    return found;
  }

  /// The graph search; with a clearance again until its path is free: only the states of rungs that
  /// a path collides at are looked at.
  Candidate searched(const SearchFrame& frame, bool* tableFree) const {
    ExtraCosts extra;
    std::size_t lookedAt = 0;
    Candidate best;
    for (int round = 0; round < kCollisionRounds; ++round) {
      const SearchPath path = searchGraph(task_, frame, extra, context_);
      *tableFree = path.tableFree;
      Candidate own = candidate(RedundancyMode::Optimized, resolutionOf(task_, frame, path));
      const bool collides = own.evaluation.count(Constraint::Collision) > 0;
      const bool more = collides && addCollisions(frame, own.motion, extra, lookedAt);
      if (round == 0 || own.evaluation.betterThan(best.evaluation)) {
        best = std::move(own);
      }
      if (!more) {
        break;
      }
    }
    return best;
  }

  /// Costs of the rungs beside colliding targets; false when all of them are known.
  bool addCollisions(const SearchFrame& frame,
                     const Motion& motion,
                     ExtraCosts& extra,
                     std::size_t& lookedAt) const {
    const std::vector<float> distances = clearanceOf(motion, *clearance_, context_);
    bool added = false;
    for (std::size_t r = 0; r < frame.rungs.size(); ++r) {
      const Segment& segment = task_.runs.segments[frame.rungs[r].segment];
      const std::size_t begin =
          frame.rungs[r].firstOfSegment ? segment.begin : frame.rungs[r - 1].target + 1;
      const bool last = frame.rungs[r].target == segment.last;
      const std::size_t end = last ? segment.end : frame.rungs[r + 1].target;
      bool collides = false;
      for (std::size_t i = begin; i < end; ++i) {
        collides = collides || distances[i] < 0.0F;
      }
      if (collides && extra.find(r) == extra.end() && lookedAt < kMostCollisionStates) {
        context_.check();
        extra[r] = collisionCosts(task_, frame, frame.rungs[r], *clearance_, lookedAt);
        added = true;
      }
    }
    return added;
  }

  const Task& task_;
  bool searches_;
  const JobContext& context_;
  const collision::Clearance* clearance_;
  mutable std::atomic<std::size_t> done_ = 0;
  std::size_t expected_ = 1;
};

}  // namespace

Candidate resolveOptimized(const Task& task,
                           const JobContext& context,
                           const collision::Clearance* clearance) {
  return Optimizer(task, true, context, clearance).run();
}

Candidate bestNamed(const Task& task,
                    const JobContext& context,
                    const collision::Clearance* clearance) {
  return Optimizer(task, false, context, clearance).run();
}

}  // namespace wcam::motion::detail
