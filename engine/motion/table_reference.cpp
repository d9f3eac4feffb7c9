// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "table_reference.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/cell/angles.hpp"

#include "table_axis.hpp"
#include "taut_string.hpp"
#include "vertical_tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace wcam::motion::detail {

namespace {

constexpr double kTurn = 2.0 * kPi;
/// Samples of a turn of the table, besides the exact solutions. They only choose between ways.
constexpr int kSamples = 144;
constexpr double kSampleStep = kTurn / kSamples;
/// Axes that are parallel to within this sine have no arcs.
constexpr double kParallel = 1e-3;
/// Radius (of sines) below which a direction has no azimuth about the table's axis.
constexpr double kNoAzimuth = 1e-12;
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
constexpr std::size_t kCheckEvery = 1024;

/// How much freedom: a part of what the build direction may lean above the least, within a time of
/// the fast steps (in units of the time of half a turn).
struct Freedom {
  double part;
  double halfTurns;
};

constexpr Freedom kFreedoms[] = {{0.3, 1.0}, {0.6, 1.0}, {0.9, 1.0}, {0.9, 4.0}, {0.97, 4.0}};

/// Turns of the table, [low, high].
struct Arc {
  double low = 0.0;
  double high = 0.0;
};

struct Node {
  double turn = 0.0;
  Arc arc;
  double tilt = 0.0;
};

/// The best tilt for a turn: the angle of the vector with these components, both a constant and
/// the factors of the turn's cosine and sine.
struct TiltLaw {
  Vec3 across, along;

  [[nodiscard]] double at(double turn) const {
    const Vec3 factors(1.0, std::cos(turn), std::sin(turn));
    return std::atan2(across.dot(factors), along.dot(factors));
  }
};

/// Where the table may stand at a target.
class Arcs {
public:
  Arcs(const Cell& cell, const MotionParams& params)
      : params_(params), vertical_(cell.verticalInBase()) {
    const PositionerValues zero{};
    const cell::ChainAxes axes = cell::chainAxes(cell.positioner, zero.data());
    R_base_part_ = axes.T_root_tip.linear() * cell.T_table_part.linear();
    k1_ = axes.directions[0];
    k2_ = axes.directions[1];
    cosine_ = k1_.dot(k2_);
    level_ = std::asin(std::clamp(k1_.dot(vertical_), -1.0, 1.0));
    const cell::Joint& last = cell.joint(cell.jointCount() - 1);
    if (!last.endless) {
      limits_ = Arc{std::min(last.sign * last.min, last.sign * last.max),
                    std::max(last.sign * last.min, last.sign * last.max)};
    }
  }

  [[nodiscard]] bool parallel() const { return k1_.cross(k2_).norm() < kParallel; }

  /// The component of `up` along the first axis is offset + radius·cos(ψ − zero).
  struct Swing {
    double offset, radius, zero;
  };

  [[nodiscard]] Swing swing(const Vec3& up) const {
    const Vec3 p = R_base_part_ * up;
    const Vec3 from = p - k2_ * k2_.dot(p);
    const Vec3 to = k1_ - k2_ * cosine_;
    return {cosine_ * k2_.dot(p), from.norm() * to.norm(),
            std::atan2(k2_.dot(from.cross(to)), from.dot(to))};
  }

  /// Both exact solutions.
  [[nodiscard]] std::array<double, 2> exact(const Vec3& up) const {
    const Swing s = swing(up);
    const double x =
        s.radius > kNoAzimuth
            ? std::acos(std::clamp((std::sin(level_) - s.offset) / s.radius, -1.0, 1.0))
            : 0.5 * kPi;
    return {s.zero + x, s.zero - x};
  }

  [[nodiscard]] TiltLaw tiltLaw(const Vec3& up) const {
    const Vec3 p = R_base_part_ * up;
    const Vec3 axial = k2_ * k2_.dot(p);
    const Vec3 parts[] = {axial, p - axial, k2_.cross(p)};
    const Vec3 along = vertical_ - k1_ * k1_.dot(vertical_);
    const Vec3 across = along.cross(k1_);
    TiltLaw law;
    for (int k = 0; k < 3; ++k) {
      law.across(k) = across.dot(parts[k]);
      law.along(k) = along.dot(parts[k]);
    }
    return law;
  }

  /// Nodes of a target that use a part of what it may lean.
  void nodes(const Vec3& up, double freedom, std::vector<Node>& nodes) const {
    addNodes(up, freedom, nodes);
    const TiltLaw law = tiltLaw(up);
    for (Node& node : nodes) {
      node.tilt = law.at(node.turn);
    }
  }

private:
  void addNodes(const Vec3& up, double freedom, std::vector<Node>& nodes) const {
    nodes.clear();
    const std::array<double, 2> centres = exact(up);
    if (!(freedom > 0.0)) {
      addLifted({centres[0], centres[0]}, {centres[0]}, nodes);
      addLifted({centres[1], centres[1]}, {centres[1]}, nodes);
      return;
    }
    const Swing s = swing(up);
    const auto angle = [](double sine) { return std::asin(std::clamp(sine, -1.0, 1.0)); };
    const double least =
        std::max({0.0, angle(s.offset - s.radius) - level_, level_ - angle(s.offset + s.radius)});
    const double most = least + freedom * (allowedVerticalError(params_, least) - least);
    const double low = std::sin(std::max(level_ - most, -0.5 * kPi)) - s.offset;
    const double high = std::sin(std::min(level_ + most, 0.5 * kPi)) - s.offset;
    const double inner = high >= s.radius ? 0.0 : std::acos(std::clamp(high / s.radius, -1.0, 1.0));
    const double outer = low <= -s.radius ? kPi : std::acos(std::clamp(low / s.radius, -1.0, 1.0));
    const std::vector<double> both(centres.begin(), centres.end());
    if (inner == 0.0 && outer == kPi) {
      constexpr double kEndless = 1e3;
      const Arc all = limits_ ? *limits_ : Arc{-kEndless, kEndless};
      addSampled(all, limits_ ? all : Arc{0.0, kTurn * (1.0 - 0.5 / kSamples)}, {}, nodes);
    } else if (inner == 0.0) {
      addLifted({s.zero - outer, s.zero + outer}, both, nodes);
    } else if (outer == kPi) {
      // Around the far side.
      addLifted({s.zero + inner, s.zero + kTurn - inner}, {centres[0], centres[1] + kTurn}, nodes);
    } else {
      addLifted({s.zero + inner, s.zero + outer}, {centres[0]}, nodes);
      addLifted({s.zero - outer, s.zero - inner}, {centres[1]}, nodes);
    }
  }

  /// An arc with all its full turns inside the limits.
  void addLifted(const Arc& arc,
                 const std::vector<double>& centres,
                 std::vector<Node>& nodes) const {
    if (!limits_) {
      addSampled(arc, arc, centres, nodes);
      return;
    }
    const auto first = static_cast<int>(std::ceil((limits_->low - arc.high) / kTurn));
    const auto last = static_cast<int>(std::floor((limits_->high - arc.low) / kTurn));
    for (int k = first; k <= last; ++k) {
      const Arc own{std::max(arc.low + k * kTurn, limits_->low),
                    std::min(arc.high + k * kTurn, limits_->high)};
      std::vector<double> lifted = centres;
      for (double& centre : lifted) {
        centre += k * kTurn;
      }
      addSampled(own, own, lifted, nodes);
    }
  }

  static void addSampled(const Arc& arc,
                         const Arc& sampled,
                         const std::vector<double>& centres,
                         std::vector<Node>& nodes) {
    for (auto k = static_cast<int>(std::ceil(sampled.low / kSampleStep));
         k * kSampleStep <= sampled.high; ++k) {
      nodes.push_back({k * kSampleStep, arc});
    }
    for (const double centre : centres) {
      nodes.push_back({std::clamp(centre, arc.low, arc.high), arc});
    }
  }

  const MotionParams& params_;
  Eigen::Matrix3d R_base_part_;
  Vec3 vertical_, k1_, k2_;
  double cosine_ = 0.0;
  double level_ = 0.0;  ///< of the vertical above the plane square to the first axis
  std::optional<Arc> limits_;
};

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
        wraps_(joint.endless || joint.max - joint.min >= kTurn),
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
          const JobContext& context)
      : targets_(targets),
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
  /// Steps of the line at which an exact solution is too fast.
  bool findFast() {
    fast_.assign(line_.targets.size(), 0);
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
    return any;
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

  /// Price of a step: ∫ω² dt of the table, and of what is too fast. Within a sample turns are free:
  /// the string is pulled taut later.
  [[nodiscard]] double stepCost(const Node& from, const Node& to, std::size_t k) const {
    const double time = line_.step[k];
    const double d = difference(from.turn, to.turn);
    double cost = d * d / time;
    if (line_.linked[k] != 0) {
      const double aim = kSpeedRatio * speed_ * time;
      const double turning = std::max(0.0, (std::abs(d) - 0.5 * kSampleStep) / aim - 1.0);
      const double tilting =
          std::max(0.0, tilt_.ratio(from.tilt, to.tilt, time) / kSpeedRatio - 1.0);
      cost += kTooFast * speed_ * speed_ * time * (turning * turning + tilting * tilting);
    }
    return cost;
  }

  /// The way through the nodes with the least price, as gates, pulled taut.
  std::optional<std::vector<double>> wayWith(const std::vector<double>& freedoms,
                                             const std::optional<double>& awayFrom) const {
    const std::size_t count = line_.targets.size();
    std::vector<std::vector<Node>> nodes(count);
    std::vector<std::vector<std::uint16_t>> back(count);
    std::vector<double> cost;
    std::vector<double> next;
    for (std::size_t k = 0; k < count; ++k) {
      if (k % kCheckEvery == 0) {
        context_.check();
      }
      arcs_.nodes(targets_[line_.targets[k]].up, freedoms[k], nodes[k]);
      if (nodes[k].empty()) {
        return std::nullopt;
      }
      next.assign(nodes[k].size(), 0.0);
      back[k].assign(nodes[k].size(), 0);
      for (std::size_t n = 0; n < nodes[k].size(); ++n) {
        const double turn = nodes[k][n].turn;
        const double outside = tilt_.outside(nodes[k][n].tilt);
        const double own = kOutside * speed_ * speed_ * line_.step[k] * outside * outside;
        if (k == 0) {
          const bool far = !awayFrom || std::abs(cell::wrapAngle(turn - *awayFrom)) > 0.5 * kPi;
          next[n] = far ? own : kForbidden;
          continue;
        }
        next[n] = std::numeric_limits<double>::infinity();
        for (std::size_t m = 0; m < cost.size(); ++m) {
          const double whole = cost[m] + own + stepCost(nodes[k - 1][m], nodes[k][n], k);
          if (whole < next[n]) {
            next[n] = whole;
            back[k][n] = static_cast<std::uint16_t>(m);
          }
        }
      }
      cost.swap(next);
    }
    auto n = static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
    if (cost[n] >= kForbidden) {
      return std::nullopt;
    }
    std::vector<const Node*> chosen(count);
    for (std::size_t k = count; k-- > 0;) {
      chosen[k] = &nodes[k][n];
      n = back[k][n];
    }
    return taut(chosen);
  }

  [[nodiscard]] std::vector<double> taut(const std::vector<const Node*>& chosen) const {
    std::vector<Gate> gates(chosen.size());
    double time = 0.0;
    double turn = chosen.front()->turn;
    for (std::size_t k = 0; k < gates.size(); ++k) {
      const Node& node = *chosen[k];
      time += line_.step[k];
      turn += k == 0 ? 0.0 : difference(turn, node.turn);
      gates[k] = {time, node.arc.low + (turn - node.turn), node.arc.high + (turn - node.turn)};
    }
    return tautString(gates);
  }

  /// Rounding of turns, rad.
  static constexpr double kStill = 1e-9;
  static constexpr double kForbidden = 1e30;

  const std::vector<Target>& targets_;
  const JobContext& context_;
  Arcs arcs_;
  Tilt tilt_;
  Line line_;
  double speed_;
  bool endless_;
  std::vector<char> fast_;
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
  Planner planner(cell, params, targets, runs, context);
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
