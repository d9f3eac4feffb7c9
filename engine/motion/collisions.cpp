// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/collisions.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"
#include "wcam/cell/arm.hpp"
#include "wcam/cell/inverse.hpp"
#include "wcam/motion/explain.hpp"

#include "path_index.hpp"
#include "plan_detail.hpp"
#include "table_support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>

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

/// A plan with its checks, before its findings are explained.
struct Attempt {
  CheckedMotion checked;
  std::vector<Diagnostic> findings;

  [[nodiscard]] std::size_t violations() const {
    return static_cast<std::size_t>(std::count_if(
        findings.begin(), findings.end(),
        [](const Diagnostic& finding) { return finding.severity == Severity::Violation; }));
  }

  [[nodiscard]] std::size_t count(std::string_view code) const {
    return static_cast<std::size_t>(
        std::count_if(findings.begin(), findings.end(),
                      [code](const Diagnostic& finding) { return finding.code == code; }));
  }
};

/// What planCheckedMotion works on.
struct Job {
  const toolpath::Toolpath& path;
  const cell::Cell& cell;
  const collision::CellCollision* model;  ///< null: collisions are not looked at
  const std::string& operationId;
};

Attempt attempt(const Job& job, const MotionParams& params, const JobContext& context) {
  Attempt result;
  CheckedMotion& checked = result.checked;
  JobContext planning = context.portion(0.0, 0.8).withOwnDiagnostics();
  checked.planned = planMotion(job.path, job.cell, params, job.operationId, planning, job.model);
  if (job.model != nullptr) {
    ExitRotations exits;
    for (int pass = 0; params.exitRotations && pass < kExitPasses; ++pass) {
      exits = findExits(checked.planned.motion, job.path, *job.model, params, exits, context);
      if (!exits.changed) {
        break;
      }
      // The deposit stays where it is: only axes change.
      checked.path = applyExits(job.path, exits);
      checked.pathChanged = true;
      planning = context.portion(0.8, 0.9).withOwnDiagnostics();
      checked.planned =
          planMotion(checked.path, job.cell, params, job.operationId, planning, job.model);
    }
    const toolpath::Toolpath& final = checked.pathChanged ? checked.path : job.path;
    checked.collisions =
        checkCollisions(checked.planned.motion, final, *job.model, job.operationId, planning);
    for (const Tilt& tilt : exits.applied) {
      checked.collisions.turnedPoints += tilt.none() ? 0 : 1;
      checked.collisions.greatestExit =
          std::max({checked.collisions.greatestExit, std::abs(tilt.lateral), std::abs(tilt.lead)});
    }
  }
  result.findings = planning.diagnostics().items();
  return result;
}

/// A place at which the torch alone touches what is deposited, or the substrate, at whatever
/// rotation about its axis: no configuration of the arm helps there.
bool torchIsStuck(const Job& job, const Attempt& found) {
  constexpr int kRotations = 24;
  constexpr std::size_t kPlaces = 24;
  if (job.model == nullptr) {
    return false;
  }
  const detail::PathIndex index(job.path);
  std::vector<collision::ToolState> tools;
  for (const Diagnostic& finding : found.findings) {
    if (finding.code != "motion.collision" || tools.size() >= kPlaces * kRotations) {
      continue;
    }
    const auto& points = found.checked.planned.motion.waypoints;
    const auto at = std::find_if(points.begin(), points.end(), [&](const Waypoint& point) {
      return point.point >= 0 && point.layer == finding.place.layer &&
             point.bead == finding.place.bead && point.point == finding.place.point;
    });
    if (at == points.end()) {
      continue;
    }
    for (int k = 0; k < kRotations; ++k) {
      collision::ToolState tool{at->T_part_tcp, index.number(at->layer, at->bead, at->point)};
      tool.T_part_tcp.linear() =
          tool.T_part_tcp.linear() *
          Eigen::AngleAxisd(2.0 * kPi * k / kRotations, geometry::Vec3::UnitZ()).toRotationMatrix();
      tools.push_back(tool);
    }
  }
  std::vector<float> clearance(tools.size());
  job.model->evaluateTorch(tools, clearance);
  const auto deepest =
      -static_cast<float>(job.model->settings().safetyDistance) - static_cast<float>(kTouch);
  for (std::size_t begin = 0; begin < clearance.size(); begin += kRotations) {
    const auto first = clearance.begin() + static_cast<std::ptrdiff_t>(begin);
    if (std::all_of(first, first + kRotations, [&](float own) { return own < deepest; })) {
      return true;
    }
  }
  return false;
}

/// Other configurations are looked at where the automatic one breaks what they might keep. Points
/// out of reach are none of it: the choice among the configurations looks at these first.
bool mayBeBetter(const Job& job, const MotionParams& params, const Attempt& found) {
  return params.branch == BranchChoice::Auto && job.cell.arm &&
         found.count("motion.joint_limit") + found.count("motion.collision") +
                 found.count("motion.cable_twist") >
             0 &&
         found.count("motion.unreachable") == 0 && found.count("motion.tilt") == 0 &&
         !torchIsStuck(job, found);
}

/// The first configuration, in the order of their names' table, in which the operation has no
/// violation.
std::optional<Attempt> otherConfiguration(const Job& job,
                                          const MotionParams& params,
                                          const Attempt& first,
                                          const JobContext& context) {
  // Each is planned in full: as many as take some times the planning itself.
  constexpr std::size_t kMostPoints = 60000;
  const std::size_t points =
      std::max<std::size_t>(first.checked.planned.motion.waypoints.size(), 1);
  std::size_t left = params.mode == RedundancyMode::Optimized
                         ? std::max<std::size_t>(kMostPoints / points, 1)
                         : static_cast<std::size_t>(cell::Branch::kCount);
  const std::string& taken = first.checked.planned.statistics.branch;
  for (int k = 0; k < cell::Branch::kCount && left > 0; ++k) {
    if (job.cell.inverse->branchName(k) == taken) {
      continue;
    }
    --left;
    MotionParams own = params;
    own.branch = static_cast<BranchChoice>(k + 1);
    Attempt other = attempt(job, own, context.portion(0.0, 1.0));
    if (other.violations() > 0) {
      continue;
    }
    const std::size_t before = first.violations();
    other.findings.push_back(
        {Severity::Information,
         "motion.configuration_chosen",
         text(before == 1
                  ? "the configuration %1 is taken, which has no violation: %2, which comes "
                    "first, has 1"
                  : "the configuration %1 is taken, which has no violation: %2, which comes "
                    "first, has %3",
              {other.checked.planned.statistics.branch, taken, std::to_string(before)}),
         "set \"branch\" to keep one configuration",
         {job.operationId, -1, -1, -1},
         {{"branch", static_cast<double>(k)}, {"violations", static_cast<double>(before)}}});
    return other;
  }
  return std::nullopt;
}

/// "+Z" or "(0.71, 0.00, 0.71)".
std::string directionText(const geometry::Vec3& way) {
  constexpr double kAlong = 0.9999;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(way(axis)) > kAlong) {
      return std::string(way(axis) < 0.0 ? "-" : "+") + static_cast<char>('X' + axis);
    }
  }
  return "(" + formatFixed(way.x(), 2) + ", " + formatFixed(way.y(), 2) + ", " +
         formatFixed(way.z(), 2) + ")";
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

void checkStanding(const Motion& motion,
                   const toolpath::Toolpath& path,
                   const collision::CellCollision& collision,
                   const std::string& operationId,
                   CollisionStatistics& statistics,
                   const JobContext& context) {
  std::vector<CellState> states;
  for (const Waypoint& waypoint : motion.waypoints) {
    if (waypoint.reachable) {
      states.push_back({waypoint.joints, waypoint.deposited});
    }
  }
  const detail::PathIndex index(path);
  for (const collision::StandingContact& found :
       collision.standingContacts(path, states, context)) {
    statistics.leastDistance = std::min(statistics.leastDistance, -found.depth);
    Diagnostic finding;
    finding.severity = Severity::Violation;
    finding.code = "motion.standing_collision";
    finding.place.operation = operationId;
    finding.data = {{"depth_mm", found.depth},
                    {"x_mm", found.point.x()},
                    {"y_mm", found.point.y()},
                    {"z_mm", found.point.z()}};
    if (found.firstKind == collision::BodyKind::Part) {
      const detail::PathIndex::Place place = index.place(found.beadPoint);
      finding.place = {operationId, place.layer, place.bead, place.point};
      finding.data.emplace_back("points", static_cast<double>(found.points));
      finding.message = text("beads are laid up to %1 inside %2, at %3",
                             {mm(found.depth), found.second, points(found.points)});
      finding.remedy = text("move the part on its table, or %1 in the cell file", {found.second});
    } else {
      finding.message = text("the substrate stands %1 deep inside %2, at (%3, %4, %5) of the part",
                             {mm(found.depth), found.second, formatFixed(found.point.x(), 1),
                              formatFixed(found.point.y(), 1), formatFixed(found.point.z(), 1)});
      finding.remedy =
          found.way.isZero()
              ? text(
                    "move the substrate with the part, take another one, or correct %1 in the "
                    "cell file",
                    {found.second})
              : text(
                    "move the substrate with the part by %1 along %2 of the part frame, take "
                    "another one, or correct %3 in the cell file",
                    {mm(found.depth), directionText(found.way), found.second});
    }
    context.add(std::move(finding));
  }
}

CheckedMotion planCheckedMotion(const toolpath::Toolpath& path,
                                const cell::Cell& cell,
                                const toolpath::Substrate* substrate,
                                const MotionParams& params,
                                const std::string& operationId,
                                const JobContext& context) {
  if (substrate != nullptr && !path.layers.empty()) {
    detail::checkTable(cell, *substrate, context);
  }
  std::unique_ptr<collision::CellCollision> model;
  if (params.checkCollisions && !cell.shapes.empty()) {
    collision::CollisionSettings settings;
    settings.safetyDistance = params.safetyDistance.value();
    model = std::make_unique<collision::CellCollision>(cell, path, substrate, settings,
                                                       context.portion(0.0, 0.2));
  }
  const Job job{path, cell, model.get(), operationId};
  Attempt found = attempt(job, params, context.portion(0.2, 0.7));
  if (mayBeBetter(job, params, found)) {
    if (auto other = otherConfiguration(job, params, found, context.portion(0.7, 0.8))) {
      found = std::move(*other);
    }
  }
  CheckedMotion result = std::move(found.checked);
  const toolpath::Toolpath& final = result.pathChanged ? result.path : path;
  if (model != nullptr && !path.layers.empty()) {
    checkStanding(result.planned.motion, final, *model, operationId, result.collisions, context);
  }
  context.diagnostics().append(explainFindings(std::move(found.findings), result.planned.motion,
                                               final, cell, model.get(), params,
                                               context.portion(0.8, 1.0)));
  return result;
}

}  // namespace wcam::motion
