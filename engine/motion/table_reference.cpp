// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "table_reference.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/cell/angles.hpp"

#include "table_arcs.hpp"
#include "table_axis.hpp"
#include "taut_string.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace wcam::motion::detail {

namespace {

/// Repeated points pass in this time, s.
constexpr double kNoTime = 1e-9;
/// Part of the greatest speeds of both axes that is aimed at: the rest is left to what the search
/// and the refinement add.
constexpr double kSpeedRatio = 0.8;
/// Price of the squared excess of a speed over that part, in squares of speeds: a tenth too fast
/// for one step outweighs a hundred steps at full speed.
constexpr double kTooFast = 1e4;
/// Price of the squared excess of a limited tilt (rad), the same way: a degree outweighs the
/// fastest turn that a direction may ask for.
constexpr double kOutside = 1e10;
constexpr std::size_t kCheckEvery = 256;

/// How much freedom: a part of what the build direction may lean above the least, within a time of
/// the fast steps (in units of the time of half a turn).
struct Freedom {
  double part;
  double halfTurns;
};

constexpr std::array<Freedom, 5> kFreedoms = {
    {{0.3, 1.0}, {0.6, 1.0}, {0.9, 1.0}, {0.9, 4.0}, {0.97, 4.0}}};

/// Targets on beads in order, with the times at the wanted speeds.
struct Line {
  std::vector<std::size_t> targets;
  std::vector<double> step;  ///< time since the one before, s
  std::vector<char> linked;  ///< on the same bead as the one before
};

Line lineOf(const std::vector<Target>& targets, const Runs& runs) {
  Line line;
  for (std::size_t s = 0; s < runs.segments.size(); ++s) {
    const Segment& segment = runs.segments[s];
    for (std::size_t i = segment.first; i <= segment.last; ++i) {
      // From bead to bead with all moves between them.
      const bool linked = i > segment.first;
      const std::size_t before = linked ? i - 1 : s == 0 ? i : runs.segments[s - 1].last;
      double time = 0.0;
      for (std::size_t k = before + 1; k <= i; ++k) {
        const double speed = targets[k].waypoint.speed;
        time += speed > 0.0 ? (targets[k].p - targets[k - 1].p).norm() / speed : 0.0;
      }
      line.targets.push_back(i);
      line.step.push_back(std::max(time, kNoTime));
      line.linked.push_back(linked ? 1 : 0);
    }
  }
  return line;
}

/// The tilting axis as far as its speed and its limits matter.
class Tilt {
public:
  explicit Tilt(const cell::Joint& joint)
      : speed_(joint.maxSpeed),
        wraps_(joint.endless || joint.max - joint.min >= 2.0 * kPi),
        low_(std::min(joint.sign * joint.min, joint.sign * joint.max)),
        high_(std::max(joint.sign * joint.min, joint.sign * joint.max)) {}

  /// Greatest speed of a step over the axis's.
  [[nodiscard]] double ratio(double from, double to, double time) const {
    const double d = wraps_ ? cell::wrapAngle(to - from) : to - from;
    return std::abs(d) / (speed_ * time);
  }

  [[nodiscard]] double outside(double tilt) const {
    return wraps_ ? 0.0 : std::max({0.0, low_ - tilt, tilt - high_});
  }

private:
  double speed_;
  bool wraps_;
  double low_, high_;
};

class Planner {
public:
  Planner(const Cell& cell,
          const MotionParams& params,
          const std::vector<Target>& targets,
          const Runs& runs,
          const Positioning& aligned,
          const JobContext& context)
      : targets_(targets),
        aligned_(aligned),
        context_(context),
        arcs_(cell, params),
        tilt_(cell.joint(cell.robotJoints())),
        line_(lineOf(targets, runs)),
        speed_(cell.joint(cell.jointCount() - 1).maxSpeed),
        endless_(cell.joint(cell.jointCount() - 1).endless) {}

  std::vector<std::vector<double>> plan() {
    std::vector<std::vector<double>> ways;
    if (arcs_.parallel() || !findFast()) {
      return ways;
    }
    std::optional<double> start;
    for (int side = 0; side < 2; ++side) {
      const std::optional<std::vector<double>> way = slowest(start);
      if (!way) {
        break;
      }
      ways.push_back(*way);
      start = way->front();
    }
    return ways;
  }

  [[nodiscard]] const Line& line() const { return line_; }

private:
  /// Steps of the line at which an exact solution is too fast, or turns the table over although the
  /// build direction keeps so near to its axis that it need not turn at all.
  bool findFast() {
    fast_.assign(line_.targets.size(), 0);
    anyTurn_.assign(line_.targets.size(), 0);
    bool any = false;
    std::array<double, 2> before{};
    std::array<double, 2> tiltBefore{};
    for (std::size_t k = 0; k < fast_.size(); ++k) {
      const Vec3& up = targets_[line_.targets[k]].up;
      const std::array<double, 2> now = arcs_.exact(up);
      const TiltLaw law = arcs_.tiltLaw(up);
      const std::array<double, 2> tilt = {law.at(now[0]), law.at(now[1])};
      const double time = line_.step[k];
      const double most = kSpeedRatio * speed_ * time + kStill;
      for (std::size_t s = 0; s < 2 && line_.linked[k] != 0; ++s) {
        if (std::abs(cell::wrapAngle(now[s] - before[s])) > most ||
            tilt_.ratio(tiltBefore[s], tilt[s], time) > kSpeedRatio) {
          fast_[k] = 1;
          any = true;
        }
      }
      before = now;
      tiltBefore = tilt;
    }
    for (std::size_t k = 0; k < fast_.size(); ++k) {
      const std::size_t target = line_.targets[k];
      anyTurn_[k] = arcs_.anyTurn(targets_[target].up, kFreedoms.back().part) ? 1 : 0;
      if (k > 0 && anyTurn_[k] != 0 && anyTurn_[k - 1] != 0 && fast_[k] == 0) {
        const double turn = aligned_.joints[target][1] - aligned_.joints[line_.targets[k - 1]][1];
        fast_[k] = std::abs(turn) > kTurnSample ? 1 : 0;
        turnsOver_ = turnsOver_ || fast_[k] != 0;
      }
    }
    return any || turnsOver_;
  }

  /// Freedom of each target of the line.
  [[nodiscard]] std::vector<double> freedoms(const Freedom& freedom) const {
    const double window = freedom.halfTurns * kPi / (kSpeedRatio * speed_);
    std::vector<double> result(fast_.size(), 0.0);
    double since = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < fast_.size(); ++k) {
      since = fast_[k] != 0 ? 0.0 : since + line_.step[k];
      result[k] = since <= window ? freedom.part : 0.0;
    }
    double until = std::numeric_limits<double>::infinity();
    for (std::size_t k = fast_.size(); k-- > 0;) {
      result[k] = until <= window || fast_[k] != 0 ? freedom.part : result[k];
      until = fast_[k] != 0 ? line_.step[k] : until + line_.step[k];
      // Where the table may stand anyhow it rests.
      const bool rests = anyTurn_[k] != 0 && (turnsOver_ || result[k] == 0.0);
      result[k] = rests ? kFreedoms.back().part : result[k];
    }
    return result;
  }

  /// The way with the least freedom that is slow enough, else the slowest.
  std::optional<std::vector<double>> slowest(const std::optional<double>& awayFrom) const {
    std::optional<std::vector<double>> best;
    double bestRatio = 0.0;
    for (const Freedom& freedom : kFreedoms) {
      const std::optional<std::vector<double>> way = wayWith(freedoms(freedom), awayFrom);
      if (!way) {
        continue;
      }
      const double ratio = fastest(*way);
      if (!best || ratio < bestRatio) {
        best = way;
        bestRatio = ratio;
      }
      if (ratio <= kSpeedRatio) {
        break;
      }
    }
    return best;
  }

  /// Greatest speed on a bead over what the axis can do, of both axes.
  [[nodiscard]] double fastest(const std::vector<double>& way) const {
    double ratio = 0.0;
    double tiltBefore = 0.0;
    for (std::size_t k = 0; k < way.size(); ++k) {
      const double tilt = arcs_.tiltLaw(targets_[line_.targets[k]].up).at(way[k]);
      const double time = line_.step[k];
      if (line_.linked[k] != 0) {
        ratio = std::max({ratio, (std::abs(way[k] - way[k - 1]) - kStill) / (speed_ * time),
                          tilt_.ratio(tiltBefore, tilt, time)});
      }
      tiltBefore = tilt;
    }
    return ratio;
  }

  [[nodiscard]] double difference(double from, double to) const {
    return endless_ ? cell::wrapAngle(to - from) : to - from;
  }

  /// A step of the line between stops of the way.
  struct Step {
    double time = 0.0;
    bool linked = false;
  };

  /// Price of a step: ∫ω² dt of the table, and of what is too fast. Within a sample turns are free:
  /// the string is pulled taut later.
  [[nodiscard]] double stepCost(const TableNode& from,
                                const TableNode& to,
                                const Step& step) const {
    const double d = difference(from.turn, to.turn);
    double cost = d * d / step.time;
    if (step.linked) {
      const double aim = kSpeedRatio * speed_ * step.time;
      const double turning = std::max(0.0, (std::abs(d) - 0.5 * kTurnSample) / aim - 1.0);
      const double tilting =
          std::max(0.0, tilt_.ratio(from.tilt, to.tilt, step.time) / kSpeedRatio - 1.0);
      cost += kTooFast * speed_ * speed_ * step.time * (turning * turning + tilting * tilting);
    }
    return cost;
  }

  /// Places of the line at which the way is chosen. Of those of a bead that leave the table free
  /// only the first and the last matter: what is best between these is straight.
  [[nodiscard]] std::vector<std::size_t> stopsOf(const std::vector<double>& freedoms) const {
    const std::size_t count = line_.targets.size();
    std::vector<char> any(count);
    for (std::size_t k = 0; k < count; ++k) {
      any[k] = arcs_.anyTurn(targets_[line_.targets[k]].up, freedoms[k]) ? 1 : 0;
    }
    std::vector<std::size_t> stops;
    for (std::size_t k = 0; k < count; ++k) {
      const bool inside = k > 0 && k + 1 < count && line_.linked[k] != 0 &&
                          line_.linked[k + 1] != 0 && any[k - 1] != 0 && any[k] != 0 &&
                          any[k + 1] != 0;
      if (!inside) {
        stops.push_back(k);
      }
    }
    return stops;
  }

  /// The nodes of a stop and which node before the best way to each of them comes from.
  struct Stop {
    std::vector<TableNode> nodes;
    std::vector<std::uint16_t> back;
  };

  /// The way through the nodes with the least price, as gates, pulled taut.
  std::optional<std::vector<double>> wayWith(const std::vector<double>& freedoms,
                                             const std::optional<double>& awayFrom) const {
    const std::vector<std::size_t> places = stopsOf(freedoms);
    std::vector<Stop> stops(places.size());
    std::vector<double> cost;
    std::vector<double> next;
    Step step;
    for (std::size_t p = 0; p < places.size(); ++p) {
      if (p % kCheckEvery == 0) {
        context_.check();
      }
      const std::size_t place = places[p];
      Stop& stop = stops[p];
      arcs_.nodes(targets_[line_.targets[place]].up, freedoms[place], stop.nodes);
      if (stop.nodes.empty()) {
        return std::nullopt;
      }
      step.time = 0.0;
      for (std::size_t k = p == 0 ? 0 : places[p - 1] + 1; k <= place; ++k) {
        step.time += line_.step[k];
      }
      step.linked = line_.linked[place] != 0;
      next.assign(stop.nodes.size(), 0.0);
      stop.back.assign(stop.nodes.size(), 0);
      for (std::size_t n = 0; n < stop.nodes.size(); ++n) {
        const TableNode& node = stop.nodes[n];
        const double outside = tilt_.outside(node.tilt);
        const double own = kOutside * speed_ * speed_ * step.time * outside * outside;
        if (p == 0) {
          const bool far =
              !awayFrom || std::abs(cell::wrapAngle(node.turn - *awayFrom)) > 0.5 * kPi;
          next[n] = far ? own : kForbidden;
          continue;
        }
        next[n] = std::numeric_limits<double>::infinity();
        for (std::size_t m = 0; m < cost.size(); ++m) {
          const double whole = cost[m] + own + stepCost(stops[p - 1].nodes[m], node, step);
          if (whole < next[n]) {
            next[n] = whole;
            stop.back[n] = static_cast<std::uint16_t>(m);
          }
        }
      }
      cost.swap(next);
    }
    auto n = static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
    if (cost[n] >= kForbidden) {
      return std::nullopt;
    }
    std::vector<const TableNode*> chosen(line_.targets.size(), nullptr);
    for (std::size_t p = places.size(); p-- > 0;) {
      chosen[places[p]] = &stops[p].nodes[n];
      n = stops[p].back[n];
    }
    return taut(chosen);
  }

  /// @param chosen the nodes at the stops; null between them, where any turn will do
  [[nodiscard]] std::vector<double> taut(const std::vector<const TableNode*>& chosen) const {
    std::vector<Gate> gates(chosen.size());
    double time = 0.0;
    double turn = chosen.front()->turn;
    for (std::size_t k = 0; k < gates.size(); ++k) {
      time += line_.step[k];
      const TableNode* node = chosen[k];
      TableArc arc = arcs_.everything(turn);
      if (node != nullptr) {
        turn += k == 0 ? 0.0 : difference(turn, node->turn);
        arc = {node->arc.low + (turn - node->turn), node->arc.high + (turn - node->turn)};
      }
      gates[k] = {time, arc.low, arc.high};
    }
    return tautString(gates);
  }

  /// Rounding of turns, rad.
  static constexpr double kStill = 1e-9;
  static constexpr double kForbidden = 1e30;

  const std::vector<Target>& targets_;
  const Positioning& aligned_;
  const JobContext& context_;
  TableArcs arcs_;
  Tilt tilt_;
  Line line_;
  double speed_;
  bool endless_;
  std::vector<char> fast_;
  std::vector<char> anyTurn_;  ///< the table may stand at any turn
  bool turnsOver_ = false;     ///< where it may, although slowly enough
};

}  // namespace

std::vector<Positioning> slowerReferences(const Cell& cell,
                                          const MotionParams& params,
                                          const std::vector<Target>& targets,
                                          const Runs& runs,
                                          const Positioning& aligned,
                                          const JobContext& context) {
  std::vector<Positioning> references;
  if (cell.partCarried() || cell.positionerJoints() != 2 || targets.empty()) {
    return references;
  }
  for (const cell::Joint& joint : cell.positioner.joints) {
    if (joint.prismatic() || std::any_of(joint.coupling.begin(), joint.coupling.end(),
                                         [](double c) { return c != 0.0; })) {
      return references;
    }
  }
  Planner planner(cell, params, targets, runs, aligned, context);
  const TableAxis table(cell);
  for (const std::vector<double>& way : planner.plan()) {
    Positioning reference;
    reference.joints.resize(targets.size());
    reference.residual = aligned.residual;
    PositionerValues before{};
    for (std::size_t k = 0; k < way.size(); ++k) {
      const std::size_t i = planner.line().targets[k];
      before = table.values(way[k], targets[i].up, before);
      reference.joints[i] = before;
    }
    for (const Segment& segment : runs.segments) {
      for (std::size_t i = segment.begin; i < segment.first; ++i) {
        reference.joints[i] = reference.joints[segment.first];
      }
      for (std::size_t i = segment.last + 1; i < segment.end; ++i) {
        reference.joints[i] = reference.joints[segment.last];
      }
    }
    references.push_back(std::move(reference));
  }
  return references;
}

}  // namespace wcam::motion::detail
