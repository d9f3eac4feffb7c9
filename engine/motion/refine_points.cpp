// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "refine_points.hpp"

#include "wcam/base/parallel.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/cell/unwrap.hpp"

#include "vertical_tolerance.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

constexpr std::size_t kGrain = 128;
/// Points whose first-order data are held at once.
constexpr std::size_t kBlock = 2048;
constexpr int kJoints = 8;
/// Bounds are tightened by this part, so that what the optimum leaves of a violation still holds
/// the bound itself.
constexpr double kTighter = 0.02;
/// Of joint limits: the same part of the range but not more than this, rad.
const double kLimitTighter = degToRad(1.0);
constexpr double kLengthTighter = 1.0;  ///< of linear joints, mm
/// Step of difference quotients of dexterity, uncertainty and shoulder distance, rad of the free
/// scalar.
constexpr double kStep = 1e-5;
/// Figures that are no angles enter as penalties times this: a missing hundredth counts as a
/// degree.
constexpr double kPercent = 100.0;
constexpr double kDegrees = 180.0 / kPi;
constexpr double kMicrometres = 1e3;

double towardsMultiple(double angle) {
  return cell::nearestPeriod(angle, 0.0, kPi);
}

}  // namespace

/// First-order data of a bead point.
struct ModelBuilder::Point {
  const SplineLayout::Support* support = nullptr;
  bool reachable = true;
  double time = 0.0;  ///< of the step from the point before, s
  cell::JointVector q;
  Eigen::Matrix<double, kJoints, kFreeScalars> slope;  ///< joints per active scalar
  double dexterity = 1.0, uncertainty = 0.0, axisDistance = 0.0, vertical = 0.0,
         leastVertical = 0.0, wristSine = 1.0;
  Eigen::Vector4d dexteritySlope, uncertaintySlope, axisSlope, verticalSlope, wristSlope;
  double lead = 0.0, lateral = 0.0;
};

/// Adds weighted squares of linear residuals over a few neighbouring points.
class ModelBuilder::Sum {
public:
  Sum(Model& model, int scalars) : model_(model), scalars_(scalars) {}

  void begin(double residual) {
    residual_ = residual;
    first_ = -1;
    last_ = -1;
    row_.setZero();
  }

  /// Adds c·(slope of an active scalar) of a point; points in order.
  void add(const Point& point, int scalar, double slope) {
    if (first_ < 0) {
      first_ = point.support->first;
    }
    for (int a = 0; a < 4; ++a) {
      const Eigen::Index at = point.support->first - first_ + a * scalars_ + scalar;
      row_(at) += slope * point.support->weight[static_cast<std::size_t>(a)];
      last_ = std::max(last_, at);
    }
  }

  void finish(double weight) {
    model_.merit += weight * residual_ * residual_;
    for (Eigen::Index i = 0; i <= last_; ++i) {
      const double scaled = weight * row_(i);
      if (scaled == 0.0) {
        continue;
      }
      model_.gradient(first_ + i) += scaled * residual_;
      for (Eigen::Index k = 0; k <= i; ++k) {
        model_.normal.at(first_ + i, first_ + k) += scaled * row_(k);
      }
    }
  }

  [[nodiscard]] int scalars() const { return scalars_; }

private:
  Model& model_;
  int scalars_;
  double residual_ = 0.0;
  Eigen::Index first_ = -1;
  Eigen::Index last_ = -1;
  Eigen::Matrix<double, SplineLayout::kBand * kFreeScalars, 1> row_;
};

ModelBuilder::ModelBuilder(const Task& task, const RefineFrame& frame, const SplineLayout& layout)
    : task_(task),
      frame_(frame),
      layout_(layout),
      model_(task.cell),
      weights_(task.params.weights()),
      perPoint_(1.0 / std::max<double>(1.0, static_cast<double>(layout.points().size()))) {}

void ModelBuilder::linearise(std::size_t k,
                             const std::vector<FreeChoice>& choices,
                             const Motion& motion,
                             Point& point) const {
  const Cell& cell = task_.cell;
  const std::size_t i = layout_.points()[k];
  const Waypoint& waypoint = motion.waypoints[i];
  const FreeChoice& choice = choices[i];
  point.support = &layout_.support(k);
  point.reachable = waypoint.reachable;
  point.q = waypoint.joints;
  point.lead = choice.lead;
  point.lateral = choice.lateral;
  point.vertical = waypoint.verticalError;
  point.leastVertical = waypoint.leastVerticalError;
  point.slope.setZero();
  point.dexteritySlope.setZero();
  point.uncertaintySlope.setZero();
  point.axisSlope.setZero();
  point.wristSlope.setZero();
  point.verticalSlope.setZero();
  if (i > 0 && waypoint.point > 0 && waypoint.speed > 0.0) {
    point.time = (task_.targets[i].p - task_.targets[i - 1].p).norm() / waypoint.speed;
  }
  const ArmState state = model_.armState(point.q);
  point.dexterity = state.dexterity;
  point.axisDistance = state.axisDistance;
  point.wristSine = state.wristSine;
  const double resolution = task_.params.jointResolution.value();
  const auto uncertaintyOf = [&](const ArmState& arm) {
    double sum = 0.0;
    for (int j = 0; j < cell.robotJoints(); ++j) {
      const double sigma = model_.resolution(j, resolution);
      sum += sigma * sigma * arm.jacobian.col(j).head<3>().squaredNorm();
    }
    return std::sqrt(sum) * kMicrometres;
  };
  point.uncertainty = uncertaintyOf(state);
  const bool tilts = layout_.active().back() == FreeScalar::Lateral;
  const FreeGradient gradient =
      freeGradient(model_, task_.targets[i], choice, waypoint.T_part_tcp, state, tilts);
  const bool nearSingular =
      !cell.arm && state.wristSine < 2.0 * std::sin(task_.params.wristMargin.value());
  const bool needsState = nearSingular ||
                          weights_[static_cast<std::size_t>(Objective::Dexterity)] > 0.0 ||
                          weights_[static_cast<std::size_t>(Objective::Uncertainty)] > 0.0 ||
                          state.dexterity < 2.0 * task_.params.minDexterity ||
                          state.axisDistance < 2.0 * task_.params.shoulderMargin.value();
  for (int v = 0; v < layout_.scalars(); ++v) {
    const FreeScalar scalar = layout_.active()[static_cast<std::size_t>(v)];
    const int joints = cell.robotJoints();
    point.slope.col(v).head(joints) = gradient.col(static_cast<int>(scalar)).head(joints);
    if (needsState) {
      cell::JointVector moved = point.q;
      moved.head(joints) += kStep * gradient.col(static_cast<int>(scalar)).head(joints);
      const ArmState next = model_.armState(moved);
      point.dexteritySlope(v) = (next.dexterity - state.dexterity) / kStep;
      point.axisSlope(v) = std::isfinite(state.axisDistance)
                               ? (next.axisDistance - state.axisDistance) / kStep
                               : 0.0;
      point.wristSlope(v) = (next.wristSine - state.wristSine) / kStep;
      point.uncertaintySlope(v) = (uncertaintyOf(next) - point.uncertainty) / kStep;
    }
    if (scalar == FreeScalar::Table) {
      point.slope(cell.jointCount() - 1, v) = 1.0;
      PositionerValues values = choice.positioner;
      values[static_cast<std::size_t>(cell.positionerJoints() - 1)] += kStep;
      point.verticalSlope(v) =
          (verticalError(cell, task_.targets[i].up, values) - point.vertical) / kStep;
    }
  }
}

/// Σ of joints' factors as one residual.
void ModelBuilder::addJoints(const Point& point,
                             double residual,
                             double weight,
                             std::initializer_list<int> joints,
                             std::initializer_list<double> factors,
                             Sum& sum) {
  sum.begin(residual);
  for (int v = 0; v < sum.scalars(); ++v) {
    double slope = 0.0;
    const auto* factor = factors.begin();
    for (const int j : joints) {
      slope += *factor++ * point.slope(j, v);
    }
    sum.add(point, v, slope);
  }
  sum.finish(weight);
}

/// Limits, singularities, cable, tilt and the objectives of a single point.
void ModelBuilder::addPoint(const Point& point, double penalty, Sum& sum) const {
  const Cell& cell = task_.cell;
  const MotionParams& params = task_.params;
  const int scalars = sum.scalars();
  const auto weight = [this](Objective o) {
    return weights_[static_cast<std::size_t>(o)] * perPoint_;
  };
  const auto addSlope = [&](double residual, double w, const Eigen::Vector4d& slope, double scale) {
    sum.begin(residual);
    for (int v = 0; v < scalars; ++v) {
      sum.add(point, v, scale * slope(v));
    }
    sum.finish(w);
  };
  for (int j = 0; j < cell.jointCount(); ++j) {
    const cell::Joint& joint = cell.joint(j);
    if (joint.endless) {
      continue;
    }
    const double half = 0.5 * (joint.max - joint.min);
    const double middle = 0.5 * (joint.max + joint.min);
    const double d = point.q(j) - middle;
    if (weight(Objective::Limits) > 0.0) {
      addJoints(point, d / half, weight(Objective::Limits), {j}, {1.0 / half}, sum);
    }
    const double unit = model_.inUnit(j, 1.0);
    const double tighter = joint.prismatic() ? kLengthTighter : kLimitTighter;
    const double inner = half - std::min(tighter, kTighter * half);
    if (std::abs(d) > inner) {
      addJoints(point, (std::abs(d) - inner) * unit, penalty, {j}, {d > 0 ? unit : -unit}, sum);
    }
  }
  for (const cell::JointSum& own : cell.sums) {
    addSum(point, own, penalty, sum);
  }
  if (cell.arm) {
    addArm(point, penalty, sum);
  } else {
    const double wanted = std::sin(params.wristMargin.value()) * (1.0 + kTighter);
    if (point.wristSine < wanted) {
      addSlope((wanted - point.wristSine) * kDegrees, penalty, point.wristSlope, -kDegrees);
    }
  }
  if (weight(Objective::Dexterity) > 0.0) {
    addSlope(1.0 - point.dexterity, weight(Objective::Dexterity), point.dexteritySlope, -1.0);
  }
  if (weight(Objective::Uncertainty) > 0.0) {
    addSlope(point.uncertainty, weight(Objective::Uncertainty), point.uncertaintySlope, 1.0);
  }
  const double dexterity = params.minDexterity * (1.0 + kTighter) - point.dexterity;
  if (dexterity > 0.0) {
    addSlope(kPercent * dexterity, penalty, point.dexteritySlope, -kPercent);
  }
  const double margin = params.shoulderMargin.value();
  const double shoulder = margin * (1.0 + kTighter) - point.axisDistance;
  if (shoulder > 0.0) {
    addSlope(kPercent * shoulder / margin, penalty, point.axisSlope, -kPercent / margin);
  }
  if (weight(Objective::Gravity) > 0.0) {
    addSlope(point.vertical * kDegrees, weight(Objective::Gravity), point.verticalSlope, kDegrees);
  }
  const double leaning = point.vertical - allowedVerticalError(params, point.leastVertical) +
                         params.verticalTolerance.value() * kTighter;
  if (leaning > 0.0) {
    addSlope(leaning * kDegrees, penalty, point.verticalSlope, kDegrees);
  }
  const double tilt = std::hypot(point.lead, point.lateral);
  const double most = params.tiltTolerance.value() * (1.0 - kTighter);
  if (tilt > most && tilt > 0.0 && scalars >= 2) {
    sum.begin((tilt - most) * kDegrees);
    sum.add(point, scalars - 2, kDegrees * point.lead / tilt);
    sum.add(point, scalars - 1, kDegrees * point.lateral / tilt);
    sum.finish(penalty);
  }
}

/// Wrist, elbow and cable of an arm.
void ModelBuilder::addArm(const Point& point, double penalty, Sum& sum) const {
  const cell::Arm& arm = *task_.cell.arm;
  const MotionParams& params = task_.params;
  const double bend5 = towardsMultiple(arm.gain(4, 4) * point.q(4) + arm.offset(4));
  const double wrist = params.wristMargin.value() * (1.0 + kTighter);
  if (std::abs(bend5) < wrist) {
    const double sign = bend5 < 0.0 ? 1.0 : -1.0;
    addJoints(point, (wrist - std::abs(bend5)) * kDegrees, penalty, {4},
              {sign * arm.gain(4, 4) * kDegrees}, sum);
  }
  const double bend3 = towardsMultiple(arm.gain(2, 1) * point.q(1) + arm.gain(2, 2) * point.q(2) +
                                       arm.offset(2) - std::atan2(arm.d4, arm.r4));
  const double elbow = params.elbowMargin.value() * (1.0 + kTighter);
  if (std::abs(bend3) < elbow) {
    const double sign = bend3 < 0.0 ? 1.0 : -1.0;
    addJoints(point, (elbow - std::abs(bend3)) * kDegrees, penalty, {1, 2},
              {sign * arm.gain(2, 1) * kDegrees, sign * arm.gain(2, 2) * kDegrees}, sum);
  }
  if (params.cableLimit.value() > 0.0) {
    const double twist = model_.cableTwist(point.q, params.cableZero.value());
    const double most = params.cableLimit.value() * (1.0 - kTighter);
    if (std::abs(twist) > most) {
      const double sign = twist > 0.0 ? kDegrees : -kDegrees;
      addJoints(point, (std::abs(twist) - most) * kDegrees, penalty, {3, 5},
                {sign, sign * model_.cableSign()}, sum);
    }
  }
}

/// A limited sum of joints.
void ModelBuilder::addSum(const Point& point,
                          const cell::JointSum& own,
                          double penalty,
                          Sum& sum) const {
  const double unit = model_.inUnit(CellModel::firstOf(own), 1.0);
  const double d = own.value(point.q) - 0.5 * (own.max + own.min);
  const double inner = 0.5 * (own.max - own.min) * (1.0 - kTighter);
  if (std::abs(d) <= inner) {
    return;
  }
  sum.begin((std::abs(d) - inner) * unit);
  for (int v = 0; v < sum.scalars(); ++v) {
    double slope = 0.0;
    for (std::size_t j = 0; j < own.factors.size(); ++j) {
      slope += own.factors[j] * point.slope(static_cast<Eigen::Index>(j), v);
    }
    sum.add(point, v, (d > 0.0 ? unit : -unit) * slope);
  }
  sum.finish(penalty);
}

/// Σ of squared joint steps, and speed.
void ModelBuilder::addStep(const Point& from, const Point& to, double penalty, Sum& sum) const {
  const Cell& cell = task_.cell;
  const auto weight = [this](Objective o) { return weights_[static_cast<std::size_t>(o)]; };
  for (int j = 0; j < cell.jointCount(); ++j) {
    const cell::Joint& joint = cell.joint(j);
    const bool robot = j < cell.robotJoints();
    double w = robot ? weight(Objective::Motion) * model_.motionWeight(j)
                     : weight(Objective::Positioner) / 360.0;
    if (robot && joint.endless && !cell.partCarried()) {
      w += weight(Objective::Winding) / 360.0;
    }
    const double unit = model_.inUnit(j, 1.0);
    w *= unit * unit;
    if (to.time > 0.0) {
      const double most = joint.maxSpeed * to.time;
      w += weight(Objective::Speed) * perPoint_ / (most * most);
    }
    const double step = to.q(j) - from.q(j);
    const auto addRow = [&](double residual, double scale, double own) {
      sum.begin(residual);
      for (int v = 0; v < sum.scalars(); ++v) {
        sum.add(from, v, -scale * from.slope(j, v));
        sum.add(to, v, scale * to.slope(j, v));
      }
      sum.finish(own);
    };
    if (w > 0.0) {
      addRow(step, 1.0, w);
    }
    const double most = joint.maxSpeed * to.time * (1.0 - kTighter);
    if (std::abs(step) > most) {
      const double scale = step > 0.0 ? unit : -unit;
      addRow((std::abs(step) - most) * unit, scale,
             penalty + weight(Objective::TcpSpeed) * perPoint_);
    }
  }
}

void ModelBuilder::addBend(const Point& before,
                           const Point& at,
                           const Point& after,
                           Sum& sum) const {
  const double h0 = at.time;
  const double h1 = after.time;
  if (!(h0 > 0.0 && h1 > 0.0)) {
    return;
  }
  const double w = weights_[static_cast<std::size_t>(Objective::Acceleration)] * perPoint_;
  const double c0 = 2.0 / (h0 * (h0 + h1));
  const double c2 = 2.0 / (h1 * (h0 + h1));
  for (int j = 0; j < task_.cell.jointCount(); ++j) {
    const double scale = 1.0 / accelerationScale(task_.cell.joint(j));
    sum.begin(scale * (c0 * before.q(j) - (c0 + c2) * at.q(j) + c2 * after.q(j)));
    for (int v = 0; v < sum.scalars(); ++v) {
      sum.add(before, v, scale * c0 * before.slope(j, v));
      sum.add(at, v, -scale * (c0 + c2) * at.slope(j, v));
      sum.add(after, v, scale * c2 * after.slope(j, v));
    }
    sum.finish(w);
  }
}

/// The move between beads as one step.
void ModelBuilder::addTransition(const Point& from, const Point& to, Sum& sum) const {
  for (int j = 0; j < task_.cell.jointCount(); ++j) {
    const double unit = model_.inUnit(j, 1.0);
    const double w = weights_[static_cast<std::size_t>(Objective::Transition)] * unit * unit /
                     model_.travelRange(j);
    sum.begin(to.q(j) - from.q(j));
    for (int v = 0; v < sum.scalars(); ++v) {
      sum.add(from, v, -from.slope(j, v));
      sum.add(to, v, to.slope(j, v));
    }
    sum.finish(w);
  }
}

Model ModelBuilder::build(const std::vector<FreeChoice>& choices,
                          const Motion& motion,
                          double penalty,
                          const JobContext& context) const {
  const std::vector<std::size_t>& indices = layout_.points();
  Model model{0.0, BandMatrix(layout_.size(), layout_.halfBand()),
              Eigen::VectorXd::Zero(layout_.size())};
  Sum sum(model, layout_.scalars());
  const bool bends = weights_[static_cast<std::size_t>(Objective::Acceleration)] > 0.0;
  const auto sameBead = [&indices](std::size_t a, std::size_t b) {
    return indices[b] - indices[a] == b - a;
  };
  // A block at a time, with the two points before it in front: what all points need would not stay
  // in the caches.
  constexpr std::size_t kBefore = 2;
  std::vector<Point> block(kBefore + std::min(kBlock, indices.size()));
  for (std::size_t begin = 0; begin < indices.size(); begin += kBlock) {
    const std::size_t count = std::min(kBlock, indices.size() - begin);
    if (begin > 0) {
      std::move(block.end() - kBefore, block.end(), block.begin());
    }
    Point* const points = block.data() + kBefore;
    parallelFor(
        count, kGrain, [&](std::size_t n) { linearise(begin + n, choices, motion, points[n]); },
        context);
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t k = begin + n;
      const Point* const at = points + n;
      if (!at->reachable) {
        continue;
      }
      addPoint(*at, penalty, sum);
      if (k == 0 || !at[-1].reachable) {
        continue;
      }
      if (sameBead(k - 1, k)) {
        addStep(at[-1], *at, penalty, sum);
      } else {
        addTransition(at[-1], *at, sum);
      }
      if (bends && k >= 2 && at[-2].reachable && sameBead(k - 2, k)) {
        addBend(at[-2], at[-1], *at, sum);
      }
    }
  }
  return model;
}

}  // namespace wcam::motion::detail
