// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/cell/unwrap.hpp"

#include "gradient.hpp"
#include "modes.hpp"
#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::motion::detail {

namespace {

/// Starts of b0 over the turn, each with these starts of b1 (±π turn the tool once with a closed
/// bead), rad.
constexpr int kStarts = 12;
constexpr double kSlopes[] = {0.0, 1.0, -1.0, kPi, -kPi};
/// Different fits of a degree that go on to the next one, each with these starts of the new
/// coefficient, rad.
constexpr std::size_t kBeam = 4;
constexpr double kNewCoefficient[] = {0.0, 1.0, -1.0};
/// Starts that are improved: those with the least cost.
constexpr std::size_t kTried = 20;
/// Fits whose costs differ by less than this (relative) are taken for the same.
constexpr double kSameFit = 1e-4;
/// Points of a bead on which the starts are compared; the best ones go on with all points.
constexpr std::size_t kCoarsePoints = 24;
constexpr std::size_t kFinalists = 2;
constexpr int kCoarseIterations = 8;
constexpr int kFineIterations = 30;
constexpr int kMostCoefficients = 9;
/// Inside this part of a joint's range limits do not push.
constexpr double kLimitMargin = 0.01;
/// Weight of a squared degree beyond the margin against γ·Δq².
constexpr double kLimitWeight = 10.0;
/// Relative improvement below which an iteration ends.
constexpr double kConverged = 1e-10;
/// Objectives this near (absolute, degrees; relative) are equal: the margin to the limits decides
/// (b0 is degenerate on parts of revolution, A32).
constexpr double kSameCost = 1e-7;

using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostCoefficients, 1>;
using Normal =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostCoefficients, kMostCoefficients>;
/// Joints per coefficient.
using Rows = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMostCoefficients>;

/// The points of one bead on which a polynomial is fitted.
class BeadProblem {
public:
  BeadProblem(const Task& task,
              const CellModel& model,
              const Segment& segment,
              const std::vector<FreeChoice>& choices,
              int branch,
              std::size_t points)
      : task_(task), model_(model), branch_(branch), followed_(isFollowed(task.cell)) {
    const std::size_t count = segment.last - segment.first + 1;
    const std::size_t used = std::min(count, std::max<std::size_t>(points, 2));
    std::vector<double> way(count, 0.0);
    for (std::size_t i = 1; i < count; ++i) {
      way[i] = way[i - 1] +
               (task.targets[segment.first + i].p - task.targets[segment.first + i - 1].p).norm();
    }
    for (std::size_t k = 0; k < used; ++k) {
      const std::size_t i = used == 1 ? 0 : k * (count - 1) / (used - 1);
      index_.push_back(segment.first + i);
      s_.push_back(way.back() > 0.0 ? 2.0 * way[i] / way.back() - 1.0 : 0.0);
      choice_.push_back(choices[segment.first + i]);
      // Σ over the points between two used ones of equal steps: a part of the squared long step.
      share_.push_back(k == 0 ? 1.0 : 1.0 / static_cast<double>(index_[k] - index_[k - 1]));
    }
  }

  struct State {
    double cost = std::numeric_limits<double>::infinity();  ///< Φ and penalties
    double motion = 0.0;                                    ///< Φ
    double margin = 0.0;  ///< least relative distance to a limit (joints, sums, cable) or to the
                          ///< least dexterity
    Normal normal;
    Coefficients gradient;
  };

  [[nodiscard]] State evaluate(const Coefficients& b, bool derivatives) const {
    const Eigen::Index n = b.size();
    State state;
    state.cost = 0.0;
    state.margin = 1.0;
    state.normal = Normal::Zero(n, n);
    state.gradient = Coefficients::Zero(n);
    cell::JointVector before;
    Rows rowsBefore(6, n);
    Rows rows(6, n);
    for (std::size_t k = 0; k < index_.size(); ++k) {
      Coefficients powers(n);
      double power = 1.0;
      for (Eigen::Index a = 0; a < n; ++a, power *= s_[k]) {
        powers(a) = power;
      }
      cell::JointVector q;
      cell::Vector6 perAngle = cell::Vector6::Zero();
      if (!solve(k, powers.dot(b), before, derivatives, q, perAngle, state)) {
        state.cost = std::numeric_limits<double>::infinity();
        return state;
      }
      rows = perAngle * powers.transpose();
      addLimits(q, rows, derivatives, state);
      if (k > 0) {
        for (int j = 0; j < 6; ++j) {
          const double weight = model_.motionWeight(j) * share_[k];
          const double step = model_.inUnit(j, q(j) - before(j));
          state.motion += weight * step * step;
          if (derivatives && weight > 0.0) {
            const Coefficients row =
                (rows.row(j) - rowsBefore.row(j)).transpose() * model_.inUnit(j, 1.0);
            state.normal += weight * row * row.transpose();
            state.gradient += weight * step * row;
          }
        }
      }
      before = q;
      rowsBefore = rows;
    }
    state.cost += state.motion;
    return state;
  }

  [[nodiscard]] double position(std::size_t k) const { return s_[k]; }

private:
  bool solve(std::size_t k,
             double angle,
             const cell::JointVector& before,
             bool derivatives,
             cell::JointVector& q,
             cell::Vector6& perAngle,
             State& state) const {
    const Cell& cell = task_.cell;
    FreeChoice choice = choice_[k];
    choice.torchRotation = angle;
    Pose T_part_tcp;
    const Target& target = task_.targets[index_[k]];
    const Pose flange = flangePose(cell, target, choice, &T_part_tcp);
    const cell::InverseSolution solution =
        cell.inverse->solve(flange, branch_, followed_ && k > 0 ? before.data() : nullptr);
    if (!solution.reachable) {
      return false;
    }
    q.resize(cell.jointCount());
    q.head(solution.joints.size()) = solution.joints;
    for (int j = 0; j < cell.positionerJoints(); ++j) {
      q(cell.robotJoints() + j) = choice.positioner[static_cast<std::size_t>(j)];
    }
    for (int j = 0; j < 6; ++j) {
      if (cell::periodicJoint(cell, j)) {
        q(j) = k > 0 ? cell::nearestTurn(q(j), before(j))
                     : cell::turnInLimits(cell.joint(j), q(j), 0.0);
      }
    }
    const ArmState arm = model_.armState(q);
    state.margin = std::min(state.margin, arm.dexterity - task_.params.minDexterity);
    if (derivatives) {
      perAngle = freeGradient(model_, target, choice, T_part_tcp, arm, false)
                     .col(static_cast<int>(FreeScalar::Torch));
    }
    return true;
  }

  void addLimits(const cell::JointVector& q,
                 const Rows& rows,
                 bool derivatives,
                 State& state) const {
    const Cell& cell = task_.cell;
    for (int j = 0; j < 6; ++j) {
      const cell::Joint& joint = cell.joint(j);
      if (!joint.endless) {
        addLimit({joint.min, joint.max, q(j), model_.inUnit(j, 1.0)}, rows.row(j).transpose(),
                 derivatives, state);
      }
    }
    for (const cell::JointSum& sum : cell.sums) {
      Coefficients row = Coefficients::Zero(rows.cols());
      for (int j = 0; j < 6; ++j) {
        row += sum.factors[static_cast<std::size_t>(j)] * rows.row(j).transpose();
      }
      addLimit({sum.min, sum.max, sum.value(q), model_.inUnit(CellModel::firstOf(sum), 1.0)}, row,
               derivatives, state);
    }
    const double twist = task_.params.cableLimit.value();
    if (twist > 0.0 && cell.arm) {
      addLimit({-twist, twist, model_.cableTwist(q, task_.params.cableZero.value()),
                model_.inUnit(3, 1.0)},
               rows.row(3).transpose() + model_.cableSign() * rows.row(5).transpose(), derivatives,
               state);
    }
  }

  /// A value that must stay between two bounds, in a unit that counts as a degree.
  struct Limited {
    double min = 0.0, max = 0.0, value = 0.0, unit = 1.0;
  };

  static void addLimit(const Limited& own,
                       const Coefficients& slope,
                       bool derivatives,
                       State& state) {
    const double range = own.max - own.min;
    state.margin =
        std::min(state.margin, std::min(own.value - own.min, own.max - own.value) / range);
    const double inner = kLimitMargin * range;
    const double over =
        own.unit * std::max({own.min + inner - own.value, own.value - own.max + inner, 0.0});
    if (over <= 0.0) {
      return;
    }
    state.cost += kLimitWeight * over * over;
    if (derivatives) {
      const double sign = own.value > 0.5 * (own.min + own.max) ? 1.0 : -1.0;
      const Coefficients row = sign * own.unit * slope;
      state.normal += kLimitWeight * row * row.transpose();
      state.gradient += kLimitWeight * over * row;
    }
  }

  const Task& task_;
  const CellModel& model_;
  int branch_;
  bool followed_;
  std::vector<std::size_t> index_;
  std::vector<double> s_;
  std::vector<FreeChoice> choice_;
  std::vector<double> share_;
};

struct Fit {
  Coefficients b;
  double cost = std::numeric_limits<double>::infinity();
  double margin = -1.0;

  /// Inside the limits first, then less motion, then the larger margin.
  [[nodiscard]] bool betterThan(const Fit& other) const {
    if ((margin >= 0.0) != (other.margin >= 0.0)) {
      return margin >= 0.0;
    }
    const double tolerance = kSameCost * (1.0 + std::min(cost, other.cost));
    if (std::abs(cost - other.cost) > tolerance || !std::isfinite(other.cost)) {
      return cost < other.cost;
    }
    return margin > other.margin;
  }
};

/// Levenberg–Marquardt.
Fit minimise(const BeadProblem& problem, Coefficients b, int iterations) {
  BeadProblem::State state = problem.evaluate(b, true);
  double damping = 1e-3;
  for (int k = 0; k < iterations && std::isfinite(state.cost); ++k) {
    Normal normal = state.normal;
    normal.diagonal() *= 1.0 + damping;
    normal.diagonal().array() += 1e-12 * (1.0 + state.normal.diagonal().maxCoeff());
    const Coefficients next = b - normal.ldlt().solve(state.gradient);
    const BeadProblem::State trial = problem.evaluate(next, true);
    if (trial.cost < state.cost) {
      const bool converged = state.cost - trial.cost <= kConverged * (1.0 + state.cost);
      b = next;
      state = trial;
      damping = std::max(damping * 0.2, 1e-12);
      if (converged) {
        break;
      }
    } else if (damping > 1e6) {
      break;
    } else {
      damping *= 8.0;
    }
  }
  return {b, state.cost, state.margin};
}

/// A longer polynomial that begins as a shorter one does.
Coefficients longer(const Coefficients& b, double next) {
  Coefficients result(b.size() + 1);
  result << b, next;
  return result;
}

/// Inside the limits first, then the lower cost: a strict order for the comparison of starts.
bool comesBefore(const Fit& a, const Fit& b) {
  const bool outside = a.margin < 0.0;
  return outside != (b.margin < 0.0) ? !outside : a.cost < b.cost;
}

/// All starts of a degree.
std::vector<Coefficients> startsOf(int degree, double start, const std::vector<Fit>& shorter) {
  std::vector<Coefficients> starts;
  for (int k = 0; k < kStarts; ++k) {
    for (const double slope : kSlopes) {
      Coefficients b = Coefficients::Zero(degree + 1);
      b(0) = start + 2.0 * kPi * k / kStarts;
      if (degree > 0) {
        b(1) = slope;
      }
      starts.push_back(b);
      if (degree == 0) {
        break;
      }
    }
  }
  for (const Fit& fit : shorter) {
    for (const double next : kNewCoefficient) {
      starts.push_back(longer(fit.b, next));
    }
  }
  return starts;
}

/// Fits of the best starts on few points, the best first; no two alike.
std::vector<Fit> coarseFits(const BeadProblem& coarse,
                            const std::vector<Coefficients>& starts,
                            const JobContext& context) {
  std::vector<Fit> tried;
  for (const Coefficients& b : starts) {
    const BeadProblem::State state = coarse.evaluate(b, false);
    tried.push_back({b, state.cost, state.margin});
  }
  std::stable_sort(tried.begin(), tried.end(), comesBefore);
  tried.resize(std::min(kTried, tried.size()));
  for (Fit& fit : tried) {
    context.check();
    fit = minimise(coarse, fit.b, kCoarseIterations);
  }
  std::stable_sort(tried.begin(), tried.end(), comesBefore);
  std::vector<Fit> different;
  for (const Fit& fit : tried) {
    const bool seen = std::any_of(different.begin(), different.end(), [&fit](const Fit& other) {
      return std::abs(fit.cost - other.cost) <= kSameFit * other.cost;
    });
    if (!seen && different.size() < kBeam) {
      different.push_back(fit);
    }
  }
  return different;
}

Fit fitBead(const BeadProblem& coarse,
            const BeadProblem& fine,
            int degree,
            double start,
            const JobContext& context) {
  std::vector<Fit> fits;
  Fit best;
  best.b = Coefficients::Constant(1, start);
  for (int n = 0; n <= degree; ++n) {
    fits = coarseFits(coarse, startsOf(n, start, fits), context);
    std::vector<Coefficients> finalists;
    for (std::size_t k = 0; k < std::min(kFinalists, fits.size()); ++k) {
      finalists.push_back(fits[k].b);
    }
    // The best of the degree before always goes on: no degree is worse than a lower one.
    if (n > 0) {
      finalists.push_back(longer(best.b, 0.0));
    }
    for (const Coefficients& b : finalists) {
      context.check();
      const Fit polished = minimise(fine, b, kFineIterations);
      if (!std::isfinite(best.cost) || polished.betterThan(best)) {
        best = polished;
      }
    }
    if (best.b.size() <= n) {
      best.b = longer(best.b, 0.0);
    }
  }
  return best;
}

}  // namespace

Resolution resolvePolynomial(const Task& task, const JobContext& context) {
  Resolution resolution = resolveConstant(task, context);
  if (!task.cell.inverse->freeRotation()) {
    return resolution;
  }
  const CellModel model(task.cell);
  const std::vector<Segment>& segments = task.runs.segments;
  parallelFor(
      segments.size(), 1,
      [&](std::size_t k) {
        const Segment& segment = segments[k];
        const int branch = resolution.branches[segment.run];
        const std::size_t count = segment.last - segment.first + 1;
        const BeadProblem coarse(task, model, segment, resolution.choices, branch, kCoarsePoints);
        const BeadProblem fine(task, model, segment, resolution.choices, branch, count);
        const Fit fit = fitBead(coarse, fine, task.params.polynomialDegree,
                                task.params.torchRotation.value(), context);
        if (!std::isfinite(fit.cost)) {
          return;  // nothing is in reach: the constant rotation stays
        }
        for (std::size_t i = 0; i < count; ++i) {
          double angle = 0.0;
          for (Eigen::Index a = fit.b.size(); a-- > 0;) {
            angle = angle * fine.position(i) + fit.b(a);
          }
          resolution.choices[segment.first + i].torchRotation = angle;
        }
      },
      context);
  spreadToTravel(task.runs, resolution.choices);
  return resolution;
}

}  // namespace wcam::motion::detail
