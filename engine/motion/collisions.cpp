// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/collisions.hpp"

#include "wcam/base/text.hpp"
#include "wcam/motion/explain.hpp"

#include "path_index.hpp"
#include "plan_detail.hpp"
#include "table_support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::motion {

namespace {

using collision::CellState;
using collision::Contact;

/// Steps in which moves between beads are followed: a joint turns by no more (rad), the TCP moves
/// by no more in the part (mm).
const double kJointStep = degToRad(2.0);
constexpr double kTcpStep = 5.0;
/// A contact of less than this is one of rounding: the top of a bead in the plane of a nozzle's
/// end, mm.
constexpr double kTouch = 1e-4;
/// Passes of exit rotations, each on the motion that the one before made.
constexpr int kExitPasses = 4;

std::size_t stepsOf(const Waypoint& from, const Waypoint& to) {
  double steps = (to.T_part_tcp.translation() - from.T_part_tcp.translation()).norm() / kTcpStep;
  steps = std::max(steps, (to.joints - from.joints).cwiseAbs().maxCoeff() / kJointStep);
  return static_cast<std::size_t>(std::clamp(std::ceil(steps), 1.0, 1e4));
}

std::string mm(double value) {
  return formatFixed(value, 2) + " mm";
}

Text points(std::size_t count) {
  return count == 1 ? text("1 point") : text("%1 points", {std::to_string(count)});
}

/// The worst state of a bead below a limit.
struct Worst {
  std::size_t count = 0;
  std::size_t state = 0;
  float clearance = std::numeric_limits<float>::infinity();
  std::size_t lastWaypoint = std::numeric_limits<std::size_t>::max();

  void add(std::size_t at, std::size_t waypoint, float value) {
    if (waypoint != lastWaypoint) {
      ++count;
      lastWaypoint = waypoint;
    }
    if (value < clearance) {
      clearance = value;
      state = at;
    }
  }
};

/// Tells of one bead.
class BeadReport {
public:
  BeadReport(const collision::CellCollision& collision,
             const detail::PathIndex& index,
             const std::string& operationId)
      : collision_(collision), index_(index), operationId_(operationId) {}

  void tell(const Worst& worst,
            const CellState& state,
            const Waypoint& waypoint,
            const JobContext& context) const {
    const double safety = collision_.settings().safetyDistance;
    const std::vector<Contact> contacts = collision_.contacts(state, safety + kTouch);
    if (contacts.empty()) {
      return;
    }
    const Contact& contact = contacts.front();
    // Whatever led here: what overlaps collides.
    const bool colliding = contact.distance < -kTouch;
    Diagnostic finding;
    finding.severity = colliding ? Severity::Violation : Severity::Warning;
    finding.code = colliding ? "motion.collision" : "motion.near_collision";
    finding.place = {operationId_, waypoint.layer, waypoint.bead, waypoint.point};
    const double gap = colliding ? -contact.distance : std::max(0.0, contact.distance);
    finding.data = {{colliding ? "depth_mm" : "distance_mm", gap},
                    {"points", static_cast<double>(worst.count)}};
    const bool travel = waypoint.point < 0;
    const char* pattern =
        colliding
            ? (travel ? "%1 runs up to %2 into %3 in a travel move, at %4"
                      : "%1 runs up to %2 into %3 at %4")
            : (travel
                   ? "%1 comes within %2 of %3 in a travel move, at %4; the safety distance is %5"
                   : "%1 comes within %2 of %3 at %4; the safety distance is %5");
    finding.message = text(pattern, {contact.first, mm(gap), withWhat(contact, finding),
                                     points(worst.count), mm(safety)});
    finding.remedy = "tilt the torch, change the rotation about it or the place of the part";
    context.add(std::move(finding));
  }

private:
  Text withWhat(const Contact& contact, Diagnostic& finding) const {
    if (contact.rod < 0) {
      return contact.second;
    }
    const std::uint32_t order = collision_.deposit()[static_cast<std::size_t>(contact.rod)].order;
    const detail::PathIndex::Place place = index_.place(order - 1);
    finding.data.emplace_back("with_layer", place.layer);
    finding.data.emplace_back("with_bead", place.bead);
    finding.data.emplace_back("with_point", place.point);
    // People count from 1.
    return text("the part (layer %1, bead %2, point %3)",
                {std::to_string(place.layer + 1), std::to_string(place.bead + 1),
                 std::to_string(place.point + 1)});
  }

  const collision::CellCollision& collision_;
  const detail::PathIndex& index_;
  const std::string& operationId_;
};

std::vector<float> evaluateAll(const std::vector<CellState>& states,
                               const collision::CellCollision& collision,
                               const JobContext& context) {
  std::vector<float> clearance(states.size());
  for (std::size_t begin = 0; begin < states.size(); begin += detail::kStatesBetweenChecks) {
    context.check();
    const std::size_t count = std::min(detail::kStatesBetweenChecks, states.size() - begin);
    collision.evaluate(std::span(states).subspan(begin, count),
                       std::span(clearance).subspan(begin, count));
    context.report(static_cast<double>(begin + count) / static_cast<double>(states.size()));
  }
  return clearance;
}

}  // namespace

MotionStates motionStates(const Motion& motion, const toolpath::Toolpath& path) {
  const detail::PathIndex index(path);
  MotionStates result;
  std::size_t deposited = 0;
  for (std::size_t i = 0; i < motion.waypoints.size(); ++i) {
    const Waypoint& to = motion.waypoints[i];
    if (to.point >= 0) {
      deposited = index.number(to.layer, to.bead, to.point);
    }
    if (to.reachable) {
      const bool travels = i > 0 && to.point < 0 && motion.waypoints[i - 1].reachable;
      const std::size_t steps = travels ? stepsOf(motion.waypoints[i - 1], to) : 1;
      for (std::size_t k = 1; k <= steps; ++k) {
        const double s = static_cast<double>(k) / static_cast<double>(steps);
        CellState state;
        state.joints = k == steps
                           ? to.joints
                           : cell::JointVector(motion.waypoints[i - 1].joints +
                                               s * (to.joints - motion.waypoints[i - 1].joints));
        state.deposited = deposited;
        result.states.push_back(state);
        result.waypoint.push_back(i);
      }
    }
    if (to.point >= 0) {
      deposited = index.number(to.layer, to.bead, to.point) + 1;
    }
  }
  return result;
}

CollisionStatistics checkCollisions(const Motion& motion,
                                    const toolpath::Toolpath& path,
                                    const collision::CellCollision& collision,
                                    const std::string& operationId,
                                    const JobContext& context) {
  CollisionStatistics statistics;
  if (!collision.anything()) {
    return statistics;
  }
  const MotionStates all = motionStates(motion, path);
  const std::vector<float> clearance = evaluateAll(all.states, collision, context);
  const auto safety = static_cast<float>(collision.settings().safetyDistance);
  statistics.checked = true;
  statistics.states = all.states.size();
  statistics.distance.assign(motion.waypoints.size(), std::numeric_limits<float>::quiet_NaN());
  float least = static_cast<float>(collision.settings().reach);
  const detail::PathIndex index(path);
  const BeadReport report(collision, index, operationId);
  std::size_t i = 0;
  while (i < all.states.size()) {
    const Waypoint& first = motion.waypoints[all.waypoint[i]];
    Worst colliding;
    Worst near;
    for (; i < all.states.size(); ++i) {
      const Waypoint& waypoint = motion.waypoints[all.waypoint[i]];
      if (waypoint.layer != first.layer || waypoint.bead != first.bead) {
        break;
      }
      least = std::min(least, clearance[i]);
      float& own = statistics.distance[all.waypoint[i]];
      own = std::fmin(own, clearance[i] + safety);
      if (clearance[i] < -safety - static_cast<float>(kTouch)) {
        colliding.add(i, all.waypoint[i], clearance[i]);
      } else if (clearance[i] < -static_cast<float>(kTouch)) {
        near.add(i, all.waypoint[i], clearance[i]);
      }
    }
    statistics.collidingPoints += colliding.count;
    statistics.nearPoints += near.count;
    for (const Worst* worst : {&colliding, &near}) {
      if (worst->count > 0) {
        context.check();
        report.tell(*worst, all.states[worst->state], motion.waypoints[all.waypoint[worst->state]],
                    context);
      }
    }
  }
  statistics.leastDistance = static_cast<double>(least) + static_cast<double>(safety);
  return statistics;
}

CheckedMotion planCheckedMotion(const toolpath::Toolpath& path,
                                const cell::Cell& cell,
                                const toolpath::Substrate* substrate,
                                const MotionParams& params,
                                const std::string& operationId,
                                const JobContext& context) {
  CheckedMotion result;
  if (substrate != nullptr && !path.layers.empty()) {
    detail::checkTable(cell, *substrate, context);
  }
  if (!params.checkCollisions || cell.shapes.empty()) {
    const JobContext planning = context.withOwnDiagnostics();
    result.planned = planMotion(path, cell, params, operationId, planning);
    context.diagnostics().append(explainFindings(planning.diagnostics().items(),
                                                 result.planned.motion, path, cell, nullptr, params,
                                                 context));
    return result;
  }
  collision::CollisionSettings settings;
  settings.safetyDistance = params.safetyDistance.value();
  auto model = std::make_unique<collision::CellCollision>(cell, path, substrate, settings,
                                                          context.portion(0.0, 0.2));
  JobContext planning = context.portion(0.2, 0.7).withOwnDiagnostics();
  result.planned = planMotion(path, cell, params, operationId, planning, model.get());
  ExitRotations exits;
  for (int pass = 0; params.exitRotations && pass < kExitPasses; ++pass) {
    exits = findExits(result.planned.motion, path, *model, params, exits, context);
    if (!exits.changed) {
      break;
    }
    // The deposit stays where it is: only axes change.
    result.path = applyExits(path, exits);
    result.pathChanged = true;
    planning = context.portion(0.7, 0.8).withOwnDiagnostics();
    result.planned = planMotion(result.path, cell, params, operationId, planning, model.get());
  }
  const toolpath::Toolpath& final = result.pathChanged ? result.path : path;
  result.collisions = checkCollisions(result.planned.motion, final, *model, operationId, planning);
  for (const Tilt& tilt : exits.applied) {
    result.collisions.turnedPoints += tilt.none() ? 0 : 1;
    result.collisions.greatestExit =
        std::max({result.collisions.greatestExit, std::abs(tilt.lateral), std::abs(tilt.lead)});
  }
  context.diagnostics().append(explainFindings(planning.diagnostics().items(),
                                               result.planned.motion, final, cell, model.get(),
                                               params, context.portion(0.8, 1.0)));
  return result;
}

}  // namespace wcam::motion
