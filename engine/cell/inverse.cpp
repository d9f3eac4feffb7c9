// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/inverse.hpp"

#include "wcam/cell/angles.hpp"

#include "inverse_detail.hpp"

namespace wcam::cell {

namespace {

/// The closed form of wcam/cell/arm.hpp behind the general interface.
class ArmInverse final : public InverseKinematics {
public:
  explicit ArmInverse(const Arm& arm) : arm_(arm) {}

  [[nodiscard]] InverseMethod method() const override { return InverseMethod::Arm; }

  [[nodiscard]] int joints() const override { return 6; }

  [[nodiscard]] int branches() const override { return Branch::kCount; }

  [[nodiscard]] std::string branchName(int branch) const override {
    return Branch::fromIndex(branch).name();
  }

  [[nodiscard]] int branchOf(const double* q) const override {
    return cell::branchOf(arm_, q).index();
  }

  [[nodiscard]] InverseSolution solve(const Pose& T_base_flange,
                                      int branch,
                                      const double* seed) const override {
    return general(inverseArm(arm_, T_base_flange, Branch::fromIndex(branch), seed));
  }

  void solveAll(const Pose& T_base_flange,
                std::span<InverseSolution> solutions,
                const double* seed) const override {
    const IkResult found = inverseArm(arm_, T_base_flange, seed);
    for (std::size_t k = 0; k < found.size(); ++k) {
      solutions[k] = general(found[k]);
    }
  }

  [[nodiscard]] SingularityMeasures measures(const double* q) const override {
    const ArmMeasures own = armMeasures(arm_, q);
    return {own.wristSine, own.elbowSine, own.axisDistance};
  }

private:
  static InverseSolution general(const IkSolution& found) {
    InverseSolution solution;
    solution.reachable = found.reachable;
    solution.joints = found.joints;
    solution.missing = found.missing;
    solution.wristSine = found.wristSine;
    solution.elbowSine = found.elbowSine;
    solution.axisDistance = found.axisDistance;
    solution.wristSingular = found.wristSingular;
    solution.elbowSingular = found.elbowSingular;
    solution.shoulderSingular = found.shoulderSingular;
    return solution;
  }

  Arm arm_;
};

}  // namespace

void InverseKinematics::solveAll(const Pose& T_base_flange,
                                 std::span<InverseSolution> solutions,
                                 const double* seed) const {
  for (int branch = 0; branch < branches(); ++branch) {
    solutions[static_cast<std::size_t>(branch)] = solve(T_base_flange, branch, seed);
  }
}

Pose flangeForTool(const Cell& cell, const Vec3& point, const Vec3& axis, double rotation) {
  Pose T_base_tcp = Pose::Identity();
  T_base_tcp.linear() = frameWithZ(axis, rotation);
  T_base_tcp.translation() = point;
  return T_base_tcp * cell.T_flange_tcp.inverse();
}

InverseSolution solveTool(const Cell& cell,
                          const Vec3& point,
                          const Vec3& axis,
                          double rotation,
                          int branch,
                          const double* seed) {
  return cell.inverse->solve(flangeForTool(cell, point, axis, rotation), branch, seed);
}

namespace detail {

Tool toolOf(const Cell& cell) {
  return {cell.T_flange_tcp.translation(), cell.T_flange_tcp.linear().col(2)};
}

std::shared_ptr<const InverseKinematics> makeInverse(const Cell& cell) {
  if (cell.arm) {
    return std::make_shared<const ArmInverse>(*cell.arm);
  }
  const Tool tool = toolOf(cell);
  if (auto cartesian = makeCartesianInverse(cell.robot, tool)) {
    return cartesian;
  }
  return makeNumericInverse(cell.robot, tool);
}

}  // namespace detail

}  // namespace wcam::cell
