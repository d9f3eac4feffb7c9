// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/report.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/cell/joint_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace wcam::project {

namespace {

/// Least, mean and greatest of what is added, weighted.
class Range {
public:
  void add(double value, double weight = 1.0) {
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
    sum_ += weight * value;
    weight_ += weight;
  }

  [[nodiscard]] Value toValue() const {
    if (!(low_ <= high_)) {
      return Value();
    }
    return Value::object(
        {{"min", low_}, {"mean", weight_ > 0.0 ? sum_ / weight_ : low_}, {"max", high_}});
  }

private:
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
  double sum_ = 0.0;
  double weight_ = 0.0;
};

double angleDeg(const geometry::Vec3& a, const geometry::Vec3& b) {
  return radToDeg(std::atan2(a.cross(b).norm(), a.dot(b)));
}

Value countsByCode(const std::vector<Diagnostic>& findings) {
  std::map<std::string, int> counts;
  for (const Diagnostic& finding : findings) {
    ++counts[finding.code];
  }
  Value result = Value::object();
  for (const auto& [code, count] : counts) {
    result.set(code, count);
  }
  return result;
}

/// The lines that `camcli apply` takes.
Value linesOf(const std::vector<Command>& commands) {
  Value lines = Value::array();
  for (const Command& command : commands) {
    lines.push(toValue(command));
  }
  return lines;
}

/// Adds a finding, with "apply" where its remedy is one that was tried.
void addFinding(Value& list, const Diagnostic& finding, const std::vector<Command>& remedy) {
  Value value = toValue(finding);
  if (!remedy.empty()) {
    value.set("apply", linesOf(remedy));
  }
  list.push(std::move(value));
}

Value errorValue(const RunFailure& failure) {
  Value value = Value::object();
  if (!failure.place.empty()) {
    value.set("place", failure.place.str());
  }
  value.set("code", toString(failure.error.code()))
      .set("exit_code", exitCodeOf(failure.error.code()))
      .set("message", failure.error.what());
  if (!failure.error.hint().empty()) {
    value.set("hint", failure.error.hint());
  }
  if (!failure.remedy.empty()) {
    value.set("apply", linesOf(failure.remedy));
  }
  return value;
}

Value reportHead() {
  return Value::object({{"format", "wcam-report"}, {"format_version", kReportVersion}});
}

/// Beads by what they are for.
Value featureCounts(const toolpath::Toolpath& path) {
  std::map<std::string, int> counts;
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::Bead& bead : layer.beads) {
      ++counts[toString(bead.feature)];
    }
  }
  Value result = Value::object();
  for (const auto& [feature, count] : counts) {
    result.set(feature, count);
  }
  return result;
}

void addPath(Value& report, const OperationResult& result) {
  Range height;
  Range distance;
  Range tilt;
  Range overhang;
  Range speed;
  for (std::size_t l = 0; l < result.path->layers.size(); ++l) {
    for (const toolpath::Bead& bead : result.path->layers[l].beads) {
      for (std::size_t i = 0; i < bead.points.size(); ++i) {
        const toolpath::PathPoint& point = bead.points[i];
        if (!point.arc) {
          continue;
        }
        const double before = i > 0 ? (point.p - bead.points[i - 1].p).norm() : 0.0;
        const double after =
            i + 1 < bead.points.size() ? (bead.points[i + 1].p - point.p).norm() : 0.0;
        const double weight = 0.5 * (before + after);
        height.add(point.height, weight);
        // The first layer lies on the substrate; of a climbing bead that is a part.
        if (l > 0 || bead.revolutions > 1) {
          distance.add(point.distance, weight);
        }
        tilt.add(angleDeg(point.axis, point.up), weight);
        overhang.add(angleDeg(point.b, point.up), weight);
        speed.add(point.speed, weight);
      }
    }
  }
  report.set("height_mm", height.toValue())
      .set("layer_distance_mm", distance.toValue())
      .set("speed_mm_s", speed.toValue())
      .set("tilt_deg", tilt.toValue())
      .set("overhang_deg", overhang.toValue());
}

/// Length of wire that the program feeds while the torch moves along beads, in the times that the
/// robot needs, mm. What a crater takes is the source's own: its time counts, its wire does not.
double wireFed(const motion::Motion& motion) {
  double length = 0.0;
  for (std::size_t i = 1; i < motion.waypoints.size(); ++i) {
    const motion::Waypoint& before = motion.waypoints[i - 1];
    const motion::Waypoint& point = motion.waypoints[i];
    if (point.arc) {
      length += point.wireSpeed * (point.time - before.time - before.pause);
    }
  }
  return length;
}

std::size_t arcStarts(const program::Program& program) {
  return static_cast<std::size_t>(
      std::count_if(program.instructions.begin(), program.instructions.end(),
                    [](const program::Instruction& instruction) {
                      return std::holds_alternative<program::ArcOn>(instruction.action);
                    }));
}

void addProcess(Value& report, const OperationResult& result) {
  const process::ProcessStatistics s = process::processStatistics(*result.path, result.process);
  constexpr double kMmPerM = 1000.0;
  constexpr double kMm3PerCm3 = 1000.0;
  const double wire = wireFed(result.motion->motion);
  const double radius = 0.5 * result.process.wireDiameter.value();
  const double volume = wire * kPi * radius * radius;
  report.set("length_mm", s.length)
      .set("deposited_volume_mm3", volume)
      .set("wanted_volume_mm3", s.wantedVolume)
      .set("wire_length_m", wire / kMmPerM)
      .set("mass_g", volume / kMm3PerCm3 * result.process.density)
      .set("clamped_points", s.clampedPoints)
      .set("arc_time_s", result.motion->statistics.arcTime);
}

/// Length of the moves between the beads, point to point.
double travelLength(const motion::Motion& motion) {
  double length = 0.0;
  for (std::size_t i = 1; i < motion.waypoints.size(); ++i) {
    if (!motion.waypoints[i].arc) {
      length += (motion.waypoints[i].T_part_tcp.translation() -
                 motion.waypoints[i - 1].T_part_tcp.translation())
                    .norm();
    }
  }
  return length;
}

Value jointValue(const cell::Joint& joint, const motion::JointStatistics& figures) {
  const std::string unit = std::string("_") + cell::jointUnit(joint);
  Value value = Value::object({{"name", joint.name}});
  value.set("min" + unit, cell::toJointUnit(joint, figures.min))
      .set("max" + unit, cell::toJointUnit(joint, figures.max));
  // An endless joint has no limit and hence no margin.
  value.set("margin" + unit, std::isfinite(figures.margin)
                                 ? Value(cell::toJointUnit(joint, figures.margin))
                                 : Value());
  return value.set("max_speed_ratio", figures.maxSpeedRatio);
}

/// Reversals while the arc burns: how many of each joint, and those whose backlash is known.
Value reversalsValue(const OperationResult& result) {
  const motion::MotionStatistics& s = result.motion->statistics;
  std::vector<std::size_t> counts(s.joints.size(), 0);
  Value list = Value::array();
  for (const motion::Reversal& reversal : s.reversals) {
    const motion::Waypoint& point = result.motion->motion.waypoints[reversal.waypoint];
    if (!point.arc) {
      continue;
    }
    ++counts[static_cast<std::size_t>(reversal.joint)];
    const cell::Joint& joint = result.cell->joint(reversal.joint);
    if (joint.backlash > 0.0) {
      const Eigen::Vector3d& e = reversal.effect;
      list.push(Value::object({{"time_s", reversal.time},
                               {"layer", point.layer},
                               {"bead", point.bead},
                               {"point", point.point},
                               {"joint", joint.name},
                               {"direction", reversal.direction},
                               {"effect_mm", Value(Value::Array{e.x(), e.y(), e.z()})}}));
    }
  }
  Value byJoint = Value::object();
  for (std::size_t j = 0; j < counts.size(); ++j) {
    byJoint.set(result.cell->joint(static_cast<int>(j)).name, counts[j]);
  }
  return Value::object({{"by_joint", byJoint}, {"known_effects", list}});
}

void addMotion(Value& report, const OperationResult& result) {
  const motion::MotionStatistics& s = result.motion->statistics;
  report.set("travel_length_mm", travelLength(result.motion->motion))
      .set("time_s", s.totalTime)
      .set("min_dexterity", s.minDexterity)
      .set("max_joint_speed_ratio", s.maxJointSpeedRatio)
      .set("max_vertical_error_deg", radToDeg(s.maxVerticalError))
      .set("unreachable_points", s.unreachableWaypoints)
      .set("branch", s.branch)
      .set("redundancy", s.mode)
      .set("max_cable_twist_deg", radToDeg(s.maxCableTwist))
      .set("max_tilt_deg", radToDeg(s.maxTilt))
      .set("objective", s.evaluation.cost);
  Value objectives = Value::object({});
  for (std::size_t k = 0; k < motion::kObjectiveCount; ++k) {
    objectives.set(motion::objectiveKey(static_cast<motion::Objective>(k)),
                   s.evaluation.objectives[k]);
  }
  report.set("objectives", objectives);
  Value joints = Value::array();
  for (std::size_t j = 0; j < s.joints.size(); ++j) {
    joints.push(jointValue(result.cell->joint(static_cast<int>(j)), s.joints[j]));
  }
  report.set("joints", joints).set("reversals", reversalsValue(result));
}

/// Null when nothing was looked at.
Value collisionValue(const motion::CollisionStatistics& s) {
  if (!s.checked) {
    return Value();
  }
  return Value::object({{"least_distance_mm", s.leastDistance},
                        {"states", s.states},
                        {"colliding_points", s.collidingPoints},
                        {"near_points", s.nearPoints},
                        {"turned_points", s.turnedPoints},
                        {"greatest_exit_rotation_deg", radToDeg(s.greatestExit)}});
}

}  // namespace

Value operationReport(const OperationResult& result) {
  Value report = Value::object({{"id", result.id}, {"strategy", result.strategy}});
  report.set("layers", result.path->layers.size())
      .set("beads", result.path->beadCount())
      .set("points", result.path->pointCount());
  report.set("arc_starts", arcStarts(*result.program)).set("features", featureCounts(*result.path));
  addProcess(report, result);
  addPath(report, result);
  addMotion(report, result);
  report.set("collision", collisionValue(result.collisions));
  report.set("diagnostics_by_code", countsByCode(result.findings));
  return report;
}

Value projectReport(const Document& document,
                    const std::vector<OperationResult>& results,
                    const std::vector<WrittenFile>& files,
                    const std::vector<Diagnostic>& projectFindings,
                    const std::vector<RunFailure>& failures) {
  Value operations = Value::array();
  Value findings = Value::array();
  for (const Diagnostic& finding : projectFindings) {
    addFinding(findings, finding, {});
  }
  for (const OperationResult& result : results) {
    operations.push(operationReport(result));
    for (std::size_t i = 0; i < result.findings.size(); ++i) {
      addFinding(findings, result.findings[i],
                 i < result.remedies.size() ? result.remedies[i] : std::vector<Command>());
    }
  }
  Value written = Value::array();
  for (const WrittenFile& file : files) {
    Value entry =
        Value::object({{"path", file.path}, {"bytes", file.bytes}, {"sha256", file.sha256}});
    if (!file.output.empty()) {
      entry.set("output", file.output);
    }
    if (!file.operation.empty()) {
      entry.set("operation", file.operation);
    }
    written.push(entry);
  }
  Value errors = Value::array();
  for (const RunFailure& failure : failures) {
    errors.push(errorValue(failure));
  }
  return reportHead()
      .set("project", document.project().name)
      .set("operations", operations)
      .set("files", written)
      .set("diagnostics", findings)
      .set("errors", errors);
}

Value failedReport(const RunFailure& failure) {
  return reportHead().set("errors", Value(Value::Array{errorValue(failure)}));
}

}  // namespace wcam::project
