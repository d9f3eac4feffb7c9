// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/cell/unwrap.hpp"

#include "inverse_detail.hpp"
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace wcam::cell::detail {

namespace {

/// Start postures that count as branches, and more that are tried before giving up.
constexpr int kBranches = 8;
constexpr int kPostures = 32;
constexpr int kMaxSteps = 80;
/// A solution: the error left is rounding (mm relative to the size of the robot, rad).
constexpr double kSolved = 1e-11;
/// Steps below this change nothing any more.
constexpr double kNoStep = 1e-14;
/// Damping below which it is not lowered, and beyond which the search is stuck.
constexpr double kLeastDamping = 1e-12;
constexpr double kMostDamping = 1e8;
/// Half range of start postures of joints without limits: mm.
constexpr double kFreeLength = 500.0;

using Error6 = Eigen::Matrix<double, 6, 1>;

/// Radical inverse of index in a base: points that fill the joint ranges evenly.
double radicalInverse(int index, int base) {
  double result = 0.0;
  double digit = 1.0 / base;
  for (; index > 0; index /= base, digit /= base) {
    result += (index % base) * digit;
  }
  return result;
}

Vec3 rotationVector(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

/// Levenberg–Marquardt from several start postures.
class NumericInverse final : public InverseKinematics {
public:
  NumericInverse(const Chain& robot, const Tool& tool) : robot_(robot), tool_(tool) {
    for (const Joint& joint : robot.joints) {
      size_ += std::abs(joint.d) + std::abs(joint.r);
    }
    size_ += robot.T_last_tip.translation().norm();
    farthest_ = size_ + tool.point.norm();
    for (const Joint& joint : robot.joints) {
      farthest_ += joint.prismatic() ? std::max(std::abs(joint.min), std::abs(joint.max)) : 0.0;
    }
    for (int k = 0; k < kPostures; ++k) {
      postures_.push_back(posture(k));
    }
  }

  [[nodiscard]] InverseMethod method() const override { return InverseMethod::Numeric; }

  [[nodiscard]] int joints() const override { return robot_.size(); }

  [[nodiscard]] int branches() const override { return kBranches; }

  [[nodiscard]] std::string branchName(int branch) const override {
    return std::to_string(branch + 1);
  }

  [[nodiscard]] int branchOf(const double* q) const override {
    int best = 0;
    double bestDistance = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kBranches; ++k) {
      double distance = 0.0;
      for (int j = 0; j < robot_.size(); ++j) {
        const double step = q[j] - postures_[static_cast<std::size_t>(k)](j);
        distance += std::abs(isPrismatic(j) ? step / size_ : wrapAngle(step));
      }
      if (distance < bestDistance) {
        bestDistance = distance;
        best = k;
      }
    }
    return best;
  }

  /// About 20 µs from a seed nearby, up to some ms without any.
  [[nodiscard]] InverseSolution solve(const Pose& T_base_flange,
                                      int branch,
                                      const double* seed) const override {
    InverseSolution best;
    best.joints = postures_[static_cast<std::size_t>(branch)];
    best.missing = std::numeric_limits<double>::infinity();
    if (!T_base_flange.matrix().allFinite()) {
      return best;
    }
    double bestExcess = std::numeric_limits<double>::infinity();
    const bool hopeless =
        (T_base_flange * tool_.point - robot_.T_root_first.translation()).norm() > farthest_;
    for (int k = seed != nullptr ? -1 : 0; k < kPostures; ++k) {
      JointVector start = seed != nullptr
                              ? JointVector(Eigen::Map<const Eigen::VectorXd>(seed, robot_.size()))
                              : best.joints;
      if (k >= 0) {
        start = postures_[static_cast<std::size_t>((branch + k) % kPostures)];
      }
      const InverseSolution found = search(T_base_flange, start, seed);
      const double excess = found.reachable ? excessOf(found.joints) : 0.0;
      const bool better = found.reachable != best.reachable ? found.reachable
                          : found.reachable                 ? excess < bestExcess
                                                            : errorOf(found) < errorOf(best);
      if (better) {
        best = found;
        bestExcess = excess;
      }
      // What a seed leads to is kept: another solution would be a jump.
      if (hopeless || (best.reachable && (bestExcess == 0.0 || k < 0))) {
        break;
      }
    }
    return best;
  }

  [[nodiscard]] SingularityMeasures measures(const double* q) const override {
    const JointVector joints = Eigen::Map<const Eigen::VectorXd>(q, robot_.size());
    Error6 error;
    Derivative derivative;
    evaluate(chainPose(robot_, q), joints, error, derivative);
    SingularityMeasures own;
    own.wristSine = independence(derivative);
    return own;
  }

private:
  using Derivative = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6>;

  /// Least sine of the angle between what one joint does and what all others together can do: 0 in
  /// a singularity, the one figure that every kind of robot has. Lengths count over size_.
  static double independence(const Derivative& derivative) {
    Derivative unit = derivative;
    for (Eigen::Index j = 0; j < unit.cols(); ++j) {
      const double length = unit.col(j).norm();
      if (!(length > 0.0)) {
        return 0.0;
      }
      unit.col(j) /= length;
    }
    using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;
    const Eigen::SelfAdjointEigenSolver<Square> solver(Square(unit.transpose() * unit));
    double largest = 1.0;
    for (Eigen::Index j = 0; j < unit.cols(); ++j) {
      double sum = 0.0;
      for (Eigen::Index k = 0; k < unit.cols(); ++k) {
        const double part = solver.eigenvectors()(j, k);
        sum += part * part / std::max(solver.eigenvalues()(k), kLeastEigenvalue);
      }
      largest = std::max(largest, sum);
    }
    return 1.0 / std::sqrt(largest);
  }

  [[nodiscard]] bool isPrismatic(int joint) const {
    return robot_.joints[static_cast<std::size_t>(joint)].prismatic();
  }

  [[nodiscard]] double errorOf(const InverseSolution& solution) const {
    return solution.missing / size_ + solution.tilt;
  }

  [[nodiscard]] double excessOf(const JointVector& q) const {
    double sum = 0.0;
    for (int j = 0; j < robot_.size(); ++j) {
      const double excess = limitExcess(robot_.joints[static_cast<std::size_t>(j)], q(j));
      sum += isPrismatic(j) ? excess / size_ : excess;
    }
    return sum;
  }

  [[nodiscard]] JointVector posture(int index) const {
    static constexpr int kPrimes[] = {2, 3, 5, 7, 11, 13};
    JointVector q(robot_.size());
    for (int j = 0; j < robot_.size(); ++j) {
      const Joint& joint = robot_.joints[static_cast<std::size_t>(j)];
      const double free = joint.prismatic() ? kFreeLength : kPi;
      const double low = std::max(joint.min, -free);
      const double high = std::max(low, std::min(joint.max, free));
      q(j) = low + (high - low) * radicalInverse(index + 1, kPrimes[j % 6]);
    }
    return q;
  }

  /// Error of the flange and its derivative; lengths over size_.
  void evaluate(const Pose& wanted,
                const JointVector& q,
                Error6& error,
                Derivative& derivative) const {
    const Pose pose = chainPose(robot_, q.data());
    const Vec3 point = pose * tool_.point;
    const Jacobian jacobian = chainJacobian(robot_, q.data(), point);
    derivative = jacobian;
    derivative.topRows<3>() /= size_;
    error.head<3>() = (wanted * tool_.point - point) / size_;
    if (freeRotation()) {
      error.tail<3>() = rotationVector(wanted.linear() * pose.linear().transpose());
      return;
    }
    const Vec3 axis = pose.linear() * tool_.axis;
    const Vec3 target = wanted.linear() * tool_.axis;
    const Vec3 across = axis.cross(target);
    const double sine = across.norm();
    const double angle = std::atan2(sine, axis.dot(target));
    const Vec3 direction = sine > 0.0 ? Vec3(across / sine) : axis.unitOrthogonal();
    error.tail<3>() = angle * direction;
    for (Eigen::Index j = 0; j < derivative.cols(); ++j) {
      const Vec3 turn = derivative.col(j).tail<3>();
      derivative.col(j).tail<3>() = turn - axis * axis.dot(turn);
    }
  }

  [[nodiscard]] InverseSolution search(const Pose& wanted,
                                       JointVector q,
                                       const double* seed) const {
    Error6 error;
    Error6 nextError;
    Derivative derivative;
    Derivative nextDerivative;
    evaluate(wanted, q, error, derivative);
    double damping = 1e-3;
    for (int step = 0; step < kMaxSteps && error.norm() > kSolved; ++step) {
      const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1> scale =
          derivative.colwise().squaredNorm().transpose().cwiseMax(1e-12);
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6> normal =
          derivative.transpose() * derivative;
      normal.diagonal() += damping * scale;
      const JointVector change = normal.ldlt().solve(derivative.transpose() * error);
      const JointVector next = q + change;
      evaluate(wanted, next, nextError, nextDerivative);
      if (nextError.norm() < error.norm()) {
        q = next;
        error = nextError;
        derivative = nextDerivative;
        damping = std::max(damping * 0.1, kLeastDamping);
      } else {
        damping *= 10.0;
      }
      if (damping > kMostDamping || change.norm() < kNoStep * (1.0 + q.norm())) {
        break;
      }
    }
    return solutionAt(wanted, q, error, derivative, seed);
  }

  [[nodiscard]] InverseSolution solutionAt(const Pose& wanted,
                                           JointVector q,
                                           const Error6& error,
                                           const Derivative& derivative,
                                           const double* seed) const {
    InverseSolution solution;
    for (int j = 0; j < robot_.size(); ++j) {
      const Joint& joint = robot_.joints[static_cast<std::size_t>(j)];
      if (joint.prismatic() || !wholeTurns(j)) {
        continue;
      }
      q(j) = wrapAngle(q(j));
      q(j) = turnInLimits(joint, q(j), seed != nullptr ? seed[j] : q(j));
    }
    solution.joints = q;
    solution.missing = (wanted * tool_.point - chainPose(robot_, q.data()) * tool_.point).norm();
    solution.tilt = error.tail<3>().norm();
    solution.reachable = error.norm() <= kAccepted;
    solution.wristSine = independence(derivative);
    solution.wristSingular = solution.wristSine < kSingular;
    return solution;
  }

  [[nodiscard]] bool wholeTurns(int column) const {
    for (const Joint& joint : robot_.joints) {
      const auto k = static_cast<std::size_t>(column);
      if (k < joint.coupling.size() && joint.coupling[k] != 0.0 &&
          (joint.prismatic() || joint.coupling[k] != std::round(joint.coupling[k]))) {
        return false;
      }
    }
    return true;
  }

  /// Errors (relative, rad) that count as reached, and the measure of a singularity.
  static constexpr double kAccepted = 1e-9;
  static constexpr double kSingular = 1e-9;
  static constexpr double kLeastEigenvalue = 1e-20;

  Chain robot_;
  Tool tool_;
  double size_ = 1.0;      ///< length that counts as much as 1 rad, mm
  double farthest_ = 0.0;  ///< that the tool point can be from the first joint's frame, mm
  std::vector<JointVector> postures_;
};

}  // namespace

std::shared_ptr<const InverseKinematics> makeNumericInverse(const Chain& robot, const Tool& tool) {
  return std::make_shared<const NumericInverse>(robot, tool);
}

}  // namespace wcam::cell::detail
