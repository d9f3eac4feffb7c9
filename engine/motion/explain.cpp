// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/explain.hpp"

#include "wcam/base/text.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/cell/inverse.hpp"

#include "path_index.hpp"
#include "plan_detail.hpp"
#include "trial.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>

namespace wcam::motion {

namespace {

using detail::Change;
using detail::Trial;
using detail::TrialPoint;
using geometry::Vec3;

constexpr std::size_t kSamples = 12;  ///< points of a bead that a cure is tried at
const double kRotationStep = degToRad(5.0);
const double kTiltStep = degToRad(1.0);
const double kTurnStep = degToRad(15.0);
constexpr double kMoveStep = 20.0;     // mm
constexpr double kGreatestMove = 600;  // mm: more than that is another cell

/// One thing to try, with the words for it.
struct Cure {
  Change change;
  Text text;
  std::string key;  ///< of the figure in data
  double figure = 0.0;
  /// Figures that the project can be given, as try_* (see explain.hpp); none: a hint in words.
  std::vector<std::pair<std::string, double>> tries = {};
};

/// Modes whose rotation about the torch is that of the parameter.
bool rotationIsGiven(const MotionParams& params) {
  return params.mode != RedundancyMode::Optimized && params.mode != RedundancyMode::PlanarVertical;
}

std::pair<std::string, double> tryRotation(const MotionParams& params, double change) {
  const double angle = cell::wrapAngle(params.torchRotation.value() + change);
  constexpr double kTenths = 10.0;
  return {"try_rotation_deg", std::round(radToDeg(angle) * kTenths) / kTenths};
}

std::string deg(double rad) {
  return formatFixed(radToDeg(rad), 0) + " deg";
}

std::string sign(double value) {
  return value > 0 ? "+" : "-";
}

std::vector<Cure> rotations(const MotionParams& params) {
  std::vector<Cure> cures;
  for (int k = 1; k * kRotationStep <= kPi + 1e-9; ++k) {
    for (const double s : {1.0, -1.0}) {
      Cure cure;
      cure.change.rotation = s * k * kRotationStep;
      cure.text = text("rotate the torch about its axis by %1", {sign(s) + deg(k * kRotationStep)});
      cure.key = "cure_rotation_deg";
      cure.figure = radToDeg(cure.change.rotation);
      if (rotationIsGiven(params)) {
        cure.tries = {tryRotation(params, cure.change.rotation)};
      }
      cures.push_back(cure);
    }
  }
  return cures;
}

std::vector<Cure> branches(bool turned, const cell::Cell& cell, const MotionParams& params) {
  std::vector<Cure> cures;
  for (int k = 0; k < cell.inverse->branches(); ++k) {
    const std::string name = cell.inverse->branchName(k);
    for (int r = 0; r < (turned ? 12 : 1); ++r) {
      Cure cure;
      cure.change.branch = k;
      cure.change.rotation = turned ? r * kPi / 6.0 - kPi : 0.0;
      cure.text =
          turned && cure.change.rotation != 0.0
              ? text("use the configuration %1 and rotate the torch about its axis by %2",
                     {name, sign(cure.change.rotation) + deg(std::abs(cure.change.rotation))})
              : text("use the configuration %1", {name});
      cure.key = "cure_branch";
      cure.figure = k;
      // Only the configurations of an arm have a parameter.
      if (cell.arm) {
        cure.tries = {{"try_branch", k}};
      }
      if (cell.arm && cure.change.rotation != 0.0 && rotationIsGiven(params)) {
        cure.tries.push_back(tryRotation(params, cure.change.rotation));
      }
      cures.push_back(cure);
    }
  }
  return cures;
}

std::vector<Cure> tilts(const MotionParams& params) {
  std::vector<std::pair<std::string, double>> tries;
  if (params.checkCollisions && !params.exitRotations) {
    tries = {{"try_exit_rotations", 1.0}};
  }
  std::vector<Cure> cures;
  for (int k = 1; k * kTiltStep <= params.exitLateral.value() + 1e-9; ++k) {
    for (const double s : {1.0, -1.0}) {
      Cure cure;
      cure.change.lateral = s * k * kTiltStep;
      cure.text =
          text("tilt the torch by %1 about the direction of travel (exit_rotations does it)",
               {sign(s) + deg(k * kTiltStep)});
      cure.key = "cure_lateral_deg";
      cure.figure = radToDeg(cure.change.lateral);
      cure.tries = tries;
      cures.push_back(cure);
    }
  }
  for (int k = 1; k * kTiltStep <= params.exitLead.value() + 1e-9; ++k) {
    for (const double s : {1.0, -1.0}) {
      Cure cure;
      cure.change.lead = s * k * kTiltStep;
      cure.text = text("tilt the torch by %1 along the travel", {sign(s) + deg(k * kTiltStep)});
      cure.key = "cure_lead_deg";
      cure.figure = radToDeg(cure.change.lead);
      cure.tries = tries;
      cures.push_back(cure);
    }
  }
  return cures;
}

std::vector<Cure> moves(bool inBase, const cell::Cell& cell) {
  std::vector<Cure> cures;
  const char* const axes[] = {"X", "Y", "Z"};
  for (int k = 1; k * kMoveStep <= kGreatestMove; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double s : {1.0, -1.0}) {
        Cure cure;
        const double step = s * k * kMoveStep;
        (inBase ? cure.change.inBase : cure.change.onTable)(axis) = step;
        cure.text = text(!inBase              ? "move the part by %1 mm in %2 of the table"
                         : cell.partCarried() ? "move the torch by %1 mm in %2 of the base"
                                              : "move the positioner by %1 mm in %2 of the base",
                         {formatFixed(std::abs(step), 0), sign(s) + axes[axis]});
        cure.key = std::string(inBase ? "cure_base_" : "cure_table_") +
                   static_cast<char>('x' + axis) + "_mm";
        cure.figure = step;
        if (!inBase) {
          cure.tries = {{std::string("try_table_") + static_cast<char>('x' + axis) + "_mm", step}};
        }
        cures.push_back(cure);
      }
    }
  }
  return cures;
}

std::vector<Cure> partTurns() {
  std::vector<Cure> cures;
  for (int k = 1; k * kTurnStep <= kPi + 1e-9; ++k) {
    for (const double s : {1.0, -1.0}) {
      Cure cure;
      cure.change.turn = s * k * kTurnStep;
      cure.text = text("turn the part on the table by %1", {sign(s) + deg(k * kTurnStep)});
      cure.key = "cure_turn_deg";
      cure.figure = radToDeg(cure.change.turn);
      cure.tries = {{"try_turn_deg", std::round(radToDeg(cure.change.turn))}};
      cures.push_back(cure);
    }
  }
  return cures;
}

Cure otherPositioner() {
  Cure cure;
  cure.change.positioner = 1;
  cure.text = "use the positioner's other solution";
  cure.key = "cure_positioner";
  cure.figure = 1.0;
  return cure;
}

/// The robot carries the part instead of the torch, or the other way round.
std::vector<Cure> otherConfiguration(const cell::Cell& cell) {
  constexpr int kRotations = 12;
  const cell::Cell& other = *cell.other;
  const bool twoWays = !other.partCarried() && other.positionerJoints() == 2;
  std::vector<Cure> cures;
  for (int positioner = 0; positioner < (twoWays ? 2 : 1); ++positioner) {
    for (int branch = 0; branch < other.inverse->branches(); ++branch) {
      for (int r = 0; r < (other.inverse->freeRotation() ? kRotations : 1); ++r) {
        Cure cure;
        cure.change.other = true;
        cure.change.positioner = positioner;
        cure.change.branch = branch;
        cure.change.rotation = cell::wrapAngle(r * 2.0 * kPi / kRotations);
        cure.text = text(other.partCarried()
                             ? "let the robot carry the part (cell \"%1\"), configuration %2"
                             : "let the robot carry the torch (cell \"%1\"), configuration %2",
                         {other.name, other.inverse->branchName(branch)});
        cure.key = "cure_other_branch";
        cure.figure = branch;
        cure.tries = {{"try_other_branch", branch}};
        cures.push_back(cure);
      }
    }
  }
  return cures;
}

/// All that is tried, in the order of what it asks of the user.
std::vector<std::vector<Cure>> allCures(const cell::Cell& cell, const MotionParams& params) {
  std::vector<std::vector<Cure>> groups;
  const bool turns = cell.inverse->freeRotation();
  if (turns) {
    groups.push_back(rotations(params));
  }
  groups.push_back(branches(false, cell, params));
  if (!cell.partCarried() && cell.positionerJoints() == 2) {
    groups.push_back({otherPositioner()});
  }
  groups.push_back(tilts(params));
  if (turns) {
    groups.push_back(branches(true, cell, params));
  }
  groups.push_back(partTurns());
  groups.push_back(moves(false, cell));
  groups.push_back(moves(true, cell));
  if (cell.other != nullptr) {
    groups.push_back(otherConfiguration(cell));
  }
  return groups;
}

bool isExplained(const Diagnostic& finding) {
  static const std::set<std::string> codes = {"motion.unreachable",    "motion.joint_limit",
                                              "motion.singularity",    "motion.collision",
                                              "motion.near_collision", "motion.cable_twist"};
  return codes.contains(finding.code) && finding.place.layer >= 0 && finding.place.bead >= 0;
}

/// Points of a bead with the worst one first.
class Explanation {
public:
  Explanation(const Motion& motion,
              const toolpath::Toolpath& path,
              const detail::PathIndex& index,
              const Diagnostic& finding) {
    std::vector<std::size_t> own;
    std::size_t worst = std::string::npos;
    for (std::size_t i = 0; i < motion.waypoints.size(); ++i) {
      const Waypoint& w = motion.waypoints[i];
      if (w.layer != finding.place.layer || w.bead != finding.place.bead) {
        continue;
      }
      if (w.point == finding.place.point && worst == std::string::npos) {
        worst = i;
      }
      own.push_back(i);
    }
    if (worst == std::string::npos) {
      return;
    }
    const toolpath::Bead& bead = path.layers[static_cast<std::size_t>(finding.place.layer)]
                                     .beads[static_cast<std::size_t>(finding.place.bead)];
    const auto add = [&](std::size_t i) {
      const Waypoint& w = motion.waypoints[i];
      TrialPoint point;
      point.point = w.point >= 0 ? &bead.points[static_cast<std::size_t>(w.point)] : nullptr;
      point.T_part_tcp = w.T_part_tcp;
      point.joints = w.joints;
      point.deposited = index.number(w.layer, w.bead, std::max(w.point, 0));
      if (w.point < 0 && i > own.front() + 1) {
        point.deposited += bead.points.size();  // a travel move after the bead
      }
      points_.push_back(point);
    };
    add(worst);
    for (std::size_t k = 0; k < kSamples && own.size() > 1; ++k) {
      add(own[k * (own.size() - 1) / (kSamples - 1)]);
    }
  }

  [[nodiscard]] bool empty() const { return points_.empty(); }

  [[nodiscard]] std::size_t count() const { return points_.size(); }

  /// How many points a cure serves; 0 when it does not serve the worst one.
  [[nodiscard]] std::size_t served(const Trial& trial,
                                   const Change& change,
                                   const MotionParams& params) const {
    std::size_t count = 0;
    for (const TrialPoint& point : points_) {
      if (trial.at(point, change, true).right(params)) {
        ++count;
      } else if (count == 0) {
        return 0;
      }
    }
    return count;
  }

private:
  std::vector<TrialPoint> points_;
};

bool movesSomething(const Cure& cure) {
  return cure.change.other || cure.change.turn != 0.0 || cure.change.onTable != Vec3::Zero() ||
         cure.change.inBase != Vec3::Zero();
}

/// The cure that serves most points, the first of equal ones.
struct Best {
  const Cure* cure = nullptr;
  std::size_t served = 0;

  void take(const Cure& other, std::size_t count) {
    if (count > served) {
      served = count;
      cure = &other;
    }
  }
};

void explain(Diagnostic& finding,
             const Explanation& explanation,
             const Trial& trial,
             const std::vector<std::vector<Cure>>& groups,
             const MotionParams& params,
             const JobContext& context) {
  Best best;
  Best applicable;  ///< of those that a project can be changed by
  // Where part or positioner are moved, collisions are not looked at: no cure for one.
  const bool collides =
      finding.code == "motion.collision" || finding.code == "motion.near_collision";
  for (const std::vector<Cure>& group : groups) {
    context.check();
    if (group.empty() || (collides && movesSomething(group.front()))) {
      continue;
    }
    for (const Cure& cure : group) {
      const bool wanted = best.served < explanation.count() || !cure.tries.empty();
      const std::size_t count = wanted ? explanation.served(trial, cure.change, params) : 0;
      best.take(cure, count);
      if (!cure.tries.empty()) {
        applicable.take(cure, count);
      }
      if (applicable.served == explanation.count()) {
        break;
      }
    }
    if (applicable.served == explanation.count()) {
      break;
    }
  }
  if (applicable.cure != nullptr) {
    finding.data.insert(finding.data.end(), applicable.cure->tries.begin(),
                        applicable.cure->tries.end());
  }
  if (best.cure == nullptr) {
    if (collides) {
      finding.remedy =
          "none of these alone puts it right: rotations about the torch, the other configurations, "
          "tilts within the tolerances; change the axes of the path, the shape of the torch or the "
          "order of the beads";
      return;
    }
    finding.remedy = text(
        trial.hasOther()
            ? "none of these alone puts it right: rotations about the torch, the other "
              "configurations, tilts within the tolerances, turning the part, moving part or "
              "positioner by up to %1 mm, the cell's other configuration; search a placement with "
              "`camcli place`"
            : "none of these alone puts it right: rotations about the torch, the other "
              "configurations, tilts within the tolerances, turning the part, moving part or "
              "positioner by up to %1 mm; search a placement with `camcli place`",
        {formatFixed(kGreatestMove, 0)});
    return;
  }
  const Cure& cure = *best.cure;
  const bool moved = movesSomething(cure);
  const bool all = best.served == explanation.count();
  const char* pattern =
      moved ? (all ? "a hint: %1, which serves all points tried of this bead (reach, limits and "
                     "singularities; collisions not looked at)"
                   : "a hint: %1, which serves %2 of %3 points tried of this bead (reach, limits "
                     "and singularities; collisions not looked at)")
            : (all ? "a hint: %1, which serves all points tried of this bead"
                   : "a hint: %1, which serves %2 of %3 points tried of this bead");
  finding.remedy =
      text(pattern, {cure.text, std::to_string(best.served), std::to_string(explanation.count())});
  finding.data.emplace_back(cure.key, cure.figure);
  if (cure.key == "cure_branch" && cure.change.rotation != 0.0) {
    finding.data.emplace_back("cure_rotation_deg", radToDeg(cure.change.rotation));
  }
}

}  // namespace

std::vector<Diagnostic> explainFindings(std::vector<Diagnostic> findings,
                                        const Motion& motion,
                                        const toolpath::Toolpath& path,
                                        const cell::Cell& cell,
                                        const collision::CellCollision* collision,
                                        const MotionParams& given,
                                        const JobContext& context) {
  const MotionParams params = detail::withCable(given, cell);
  if (std::none_of(findings.begin(), findings.end(), isExplained)) {
    return findings;
  }
  const detail::PathIndex index(path);
  const Trial trial(cell, collision, params);
  const std::vector<std::vector<Cure>> groups = allCures(cell, params);
  // A numeric search takes some ms to find that nothing is in reach.
  const int most = detail::isFollowed(cell) ? kExplained / 6 : kExplained;
  // Violations first: they stop the program.
  int explained = 0;
  for (const Severity severity : {Severity::Violation, Severity::Warning}) {
    for (Diagnostic& finding : findings) {
      if (finding.severity != severity || !isExplained(finding) || explained >= most) {
        continue;
      }
      const Explanation explanation(motion, path, index, finding);
      if (!explanation.empty()) {
        explain(finding, explanation, trial, groups, params, context);
        ++explained;
      }
    }
  }
  return findings;
}

}  // namespace wcam::motion
