// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "exit_search.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

/// Steps of the search: tilts are set to whole degrees, combined ones on a coarser grid.
const double kStep = degToRad(1.0);
const double kCoarseStep = degToRad(5.0);
/// Candidates asked at once: most points are freed by one of the first.
constexpr std::size_t kBatch = 8;

}  // namespace

Eigen::Matrix3d tiltRotation(const toolpath::PathPoint& point, const Tilt& tilt) {
  const geometry::Vec3 along = point.t.normalized();
  const geometry::Vec3 across = point.b.cross(point.t).normalized();
  return (Eigen::AngleAxisd(tilt.lateral, along) * Eigen::AngleAxisd(tilt.lead, across))
      .toRotationMatrix();
}

ExitSearch::ExitSearch(const collision::CellCollision& collision,
                       const toolpath::PathPoint& point,
                       const collision::ToolState& tool,
                       const Tilt& applied)
    : collision_(collision), point_(point), upright_(tool) {
  upright_.T_part_tcp.linear() =
      tiltRotation(point, applied).transpose() * tool.T_part_tcp.linear();
}

collision::ToolState ExitSearch::turned(const Tilt& tilt) const {
  collision::ToolState tool = upright_;
  tool.T_part_tcp.linear() = tiltRotation(point_, tilt) * upright_.T_part_tcp.linear();
  return tool;
}

std::optional<Tilt> ExitSearch::firstFree(const std::vector<Tilt>& candidates) const {
  std::vector<collision::ToolState> tools;
  std::vector<float> clearance;
  for (std::size_t begin = 0; begin < candidates.size(); begin += kBatch) {
    const std::size_t count = std::min(kBatch, candidates.size() - begin);
    tools.clear();
    for (std::size_t i = begin; i < begin + count; ++i) {
      tools.push_back(turned(candidates[i]));
    }
    clearance.resize(count);
    collision_.evaluateTorch(tools, clearance);
    for (std::size_t i = 0; i < count; ++i) {
      if (clearance[i] >= 0.0F) {
        return candidates[begin + i];
      }
    }
  }
  return std::nullopt;
}

std::optional<Tilt> ExitSearch::smallest(const TiltRange& range, double side) const {
  std::vector<Tilt> candidates;
  for (const double sign : {side, -side}) {
    for (int k = 1; k * kStep <= range.lateral + 1e-12; ++k) {
      candidates.push_back({sign * k * kStep, 0.0});
    }
  }
  // The side that the neighbours lean to, but not at any price.
  std::stable_sort(candidates.begin(), candidates.end(), [&](const Tilt& a, const Tilt& b) {
    const auto price = [&](const Tilt& t) {
      return std::abs(t.lateral) * (t.lateral * side > 0.0 ? 1.0 : 2.0);
    };
    return price(a) < price(b);
  });
  for (int k = 1; k * kStep <= range.lead + 1e-12; ++k) {
    candidates.push_back({0.0, k * kStep});
    candidates.push_back({0.0, -k * kStep});
  }
  std::vector<Tilt> combined;
  const int lateral = static_cast<int>(range.lateral / kCoarseStep + 1e-9);
  const int lead = static_cast<int>(range.lead / kCoarseStep + 1e-9);
  for (int i = -lateral; i <= lateral; ++i) {
    for (int k = -lead; k <= lead; ++k) {
      if (i != 0 && k != 0) {
        combined.push_back({i * kCoarseStep, k * kCoarseStep});
      }
    }
  }
  std::stable_sort(combined.begin(), combined.end(), [](const Tilt& a, const Tilt& b) {
    return std::hypot(a.lateral, a.lead) < std::hypot(b.lateral, b.lead);
  });
  candidates.insert(candidates.end(), combined.begin(), combined.end());
  return firstFree(candidates);
}

}  // namespace wcam::motion::detail
