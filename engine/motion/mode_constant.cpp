// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "modes.hpp"

namespace wcam::motion::detail {

Resolution resolveConstant(const Task& task, const JobContext& context) {
  Resolution best;
  BranchScore bestScore;
  for (std::size_t family = 0; family < task.aligned.size(); ++family) {
    Resolution own;
    BranchScore score;
    own.choices = constantRotation(task, task.aligned[family].joints);
    own.branches = oneBranch(task, own.choices, context, &score);
    if (family == 0 || score.betterThan(bestScore)) {
      best = std::move(own);
      bestScore = score;
    }
  }
  return best;
}

}  // namespace wcam::motion::detail
