// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"
#include "wcam/motion/collisions.hpp"

#include "exit_search.hpp"
#include "path_index.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wcam::motion {

namespace {

using collision::ToolState;
using geometry::Vec3;
using toolpath::Bead;
using toolpath::PathPoint;

/// Greatest of what the points need, falling with the distance along the bead; round a closed one.
std::vector<double> envelope(const std::vector<double>& needed,
                             const std::vector<double>& steps,
                             double rate,
                             bool closed) {
  std::vector<double> result = needed;
  const std::size_t n = result.size();
  // The second round carries over the start of a closed bead.
  for (int round = 0; round < (closed ? 2 : 1); ++round) {
    for (std::size_t i = 1; i < n; ++i) {
      result[i] = std::max(result[i], result[i - 1] - rate * steps[i]);
    }
    for (std::size_t i = n - 1; i > 0; --i) {
      result[i - 1] = std::max(result[i - 1], result[i] - rate * steps[i]);
    }
    if (closed) {
      // First and last point are the same place.
      result.front() = result.back() = std::max(result.front(), result.back());
    }
  }
  return result;
}

/// One component of the tilts of a bead, smooth.
std::vector<double> smooth(const std::vector<double>& needed,
                           const std::vector<double>& steps,
                           double rate,
                           bool closed) {
  std::vector<double> up(needed.size());
  std::vector<double> down(needed.size());
  for (std::size_t i = 0; i < needed.size(); ++i) {
    up[i] = std::max(needed[i], 0.0);
    down[i] = std::max(-needed[i], 0.0);
  }
  const bool both = *std::max_element(up.begin(), up.end()) > 0.0 &&
                    *std::max_element(down.begin(), down.end()) > 0.0;
  // Where both sides occur their courses may change against each other.
  const double each = both ? 0.5 * rate : rate;
  up = envelope(up, steps, each, closed);
  down = envelope(down, steps, each, closed);
  for (std::size_t i = 0; i < up.size(); ++i) {
    up[i] -= down[i];
  }
  return up;
}

void smoothBead(const Bead& bead, std::size_t begin, double rate, ExitRotations& exits) {
  const std::size_t n = bead.points.size();
  std::vector<double> lateral(n);
  std::vector<double> lead(n);
  std::vector<double> steps(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    lateral[i] = exits.needed[begin + i].lateral;
    lead[i] = exits.needed[begin + i].lead;
    steps[i] = i > 0 ? (bead.points[i].p - bead.points[i - 1].p).norm() : 0.0;
  }
  const bool closed = bead.closed && n > 2 && bead.points.front().p == bead.points.back().p;
  lateral = smooth(lateral, steps, rate, closed);
  lead = smooth(lead, steps, rate, closed);
  for (std::size_t i = 0; i < n; ++i) {
    exits.applied[begin + i] = {lateral[i], lead[i]};
  }
}

}  // namespace

ExitRotations findExits(const Motion& motion,
                        const toolpath::Toolpath& path,
                        const collision::CellCollision& collision,
                        const MotionParams& params,
                        const ExitRotations& before,
                        const JobContext& context) {
  const detail::PathIndex index(path);
  ExitRotations exits = before;
  exits.needed.resize(path.pointCount());
  exits.applied.resize(path.pointCount());
  exits.unsolved = 0;
  exits.changed = false;
  const detail::TiltRange range{params.exitLateral.value(), params.exitLead.value()};
  const double rate = degToRad(params.exitRate);
  std::size_t i = 0;
  while (i < motion.waypoints.size()) {
    // The points of one bead.
    const Waypoint& first = motion.waypoints[i];
    std::vector<ToolState> tools;
    std::vector<std::size_t> numbers;
    for (; i < motion.waypoints.size() && motion.waypoints[i].layer == first.layer &&
           motion.waypoints[i].bead == first.bead;
         ++i) {
      const Waypoint& waypoint = motion.waypoints[i];
      if (waypoint.point >= 0) {
        numbers.push_back(index.number(waypoint.layer, waypoint.bead, waypoint.point));
        tools.push_back({waypoint.T_part_tcp, numbers.back()});
      }
    }
    context.check();
    const Bead& bead = path.layers[static_cast<std::size_t>(first.layer)]
                           .beads[static_cast<std::size_t>(first.bead)];
    std::vector<float> clearance(tools.size());
    collision.evaluateTorch(tools, clearance);
    bool turned = false;
    double side = 1.0;
    for (std::size_t k = 0; k < tools.size(); ++k) {
      if (clearance[k] >= 0.0F) {
        continue;
      }
      context.check();
      const std::size_t number = numbers[k];
      const PathPoint& point = bead.points[number - index.number(first.layer, first.bead, 0)];
      const detail::ExitSearch search(collision, point, tools[k], exits.applied[number]);
      const std::optional<Tilt> tilt = search.smallest(range, side);
      if (!tilt) {
        ++exits.unsolved;
        continue;
      }
      if (tilt->lateral != 0.0) {
        side = tilt->lateral > 0.0 ? 1.0 : -1.0;
      }
      exits.needed[number] = *tilt;
      turned = true;
    }
    if (turned) {
      smoothBead(bead, index.number(first.layer, first.bead, 0), rate, exits);
      exits.changed = true;
    }
  }
  return exits;
}

toolpath::Toolpath applyExits(const toolpath::Toolpath& path, const ExitRotations& exits) {
  toolpath::Toolpath result = path;
  std::size_t number = 0;
  for (toolpath::Layer& layer : result.layers) {
    for (Bead& bead : layer.beads) {
      for (PathPoint& point : bead.points) {
        if (number < exits.applied.size() && !exits.applied[number].none()) {
          point.axis =
              (detail::tiltRotation(point, exits.applied[number]) * point.axis).normalized();
        }
        ++number;
      }
    }
  }
  return result;
}

}  // namespace wcam::motion
