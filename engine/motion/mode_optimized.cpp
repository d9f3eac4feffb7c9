// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "modes.hpp"
#include "refine.hpp"
#include "search.hpp"

#include <algorithm>

namespace wcam::motion::detail {

namespace {

/// Rungs of the search at most: some seconds at 6912 states each.
constexpr std::size_t kMostRungs = 8000;
/// Point by point and polynomial are candidates up to this many targets: on longer paths they
/// would take longer than everything else together.
constexpr std::size_t kAllModesTargets = 2000;

class Optimizer {
public:
  Optimizer(const Task& task, const JobContext& context, const collision::Clearance* clearance)
      : task_(task), context_(context), clearance_(clearance) {}

  Candidate run() {
    best_ = candidate(RedundancyMode::Constant, resolveConstant(task_, context_));
    for (int m = static_cast<int>(RedundancyMode::PointByPoint); m < kRedundancyModes; ++m) {
      tryNamed(static_cast<RedundancyMode>(m));
    }
    for (std::size_t family = 0; family < task_.aligned.size(); ++family) {
      SearchFrame frame;
      frame.family = family;
      frame.rungs = chooseRungs(task_, family, kMostRungs);
      frame.points = 0;
      for (const Segment& segment : task_.runs.segments) {
        frame.points += segment.last - segment.first + 1;
      }
      bool tableFree = false;
      for (const bool following : {false, true}) {
        frame.gauge = following ? followingGauge(task_, family) : constantGauge(task_);
        Candidate own = searched(frame, &tableFree);
        own = refine(task_, {frame.gauge, family, tableFree}, own, context_, clearance_);
        keep(std::move(own));
        if (tableFree) {
          break;  // the table follows the path instead
        }
      }
    }
    return best_;
  }

private:
  Candidate candidate(RedundancyMode mode, Resolution resolution) const {
    return makeCandidate(task_, mode, std::move(resolution), context_, clearance_);
  }

  void keep(Candidate&& candidate) {
    if (candidate.evaluation.betterThan(best_.evaluation)) {
      best_ = std::move(candidate);
    }
  }

  void tryNamed(RedundancyMode mode) {
    const bool slow = mode == RedundancyMode::PointByPoint || mode == RedundancyMode::Polynomial;
    if (!lacksPositioner(mode, task_.cell) && !(slow && task_.targets.size() > kAllModesTargets)) {
      keep(candidate(mode, resolveNamed(mode, task_, context_)));
    }
  }

  Candidate searched(const SearchFrame& frame, bool* tableFree) const {
    const SearchPath path = searchGraph(task_, frame, {}, context_);
    *tableFree = path.tableFree;
    return candidate(RedundancyMode::Optimized, resolutionOf(task_, frame, path));
  }

  const Task& task_;
  const JobContext& context_;
  const collision::Clearance* clearance_;
  Candidate best_;
};

}  // namespace

Candidate resolveOptimized(const Task& task,
                           const JobContext& context,
                           const collision::Clearance* clearance) {
  return Optimizer(task, context, clearance).run();
}

}  // namespace wcam::motion::detail
