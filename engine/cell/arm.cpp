// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/arm.hpp"

#include "wcam/cell/angles.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::cell {

namespace {

/// Slack on the reach: rounding of a pose at the very border of the envelope, mm.
constexpr double kReachSlack = 1e-9;
/// Below this distance of the wrist centre from axis 1 (mm) the first angle is undefined.
constexpr double kShoulderSingular = 1e-9;
/// Below this sine axes 4 and 6 cannot be told apart; the error of keeping axis 4 stays below it.
constexpr double kWristSingular = 1e-10;
/// Below this sine the elbow branches coincide.
constexpr double kElbowSingular = 1e-9;

/// The first three joints of one shoulder/elbow branch.
struct ArmPart {
  double c1 = 0.0;
  double c2 = 0.0;
  double c3 = 0.0;
  double missing = 0.0;
  double elbowSine = 1.0;
  double axisDistance = 0.0;
  bool shoulderSingular = false;
  bool elbowSingular = false;
};

/// Axis 1 and the wrist centre's abscissa in the plane of axis 1 (Chalvin C.11 with a lateral
/// offset).
double solveShoulder(
    const Arm& arm, const Vec3& centre, bool backwards, const double* seed, ArmPart& part) {
  part.axisDistance = std::hypot(centre.x(), centre.y());
  const double inPlane = part.axisDistance * part.axisDistance - arm.b * arm.b;
  if (inPlane < 0.0) {
    part.missing = std::abs(arm.b) - part.axisDistance;
  }
  const double abscissa = (backwards ? -1.0 : 1.0) * std::sqrt(std::max(inPlane, 0.0));
  part.shoulderSingular = part.axisDistance < kShoulderSingular;
  if (part.shoulderSingular) {
    part.c1 = seed != nullptr ? seed[0] : -arm.offset(0);
  } else {
    part.c1 = std::atan2(centre.y(), centre.x()) - std::atan2(arm.b, abscissa);
  }
  return abscissa;
}

/// Axes 2 and 3 (Chalvin C.14–C.16 corrected).
void solveElbow(
    const Arm& arm, double x, double z, bool elbowDown, const double* seed, ArmPart& part) {
  const double forearm = std::hypot(arm.d4, arm.r4);
  const double distance = std::hypot(x, z);
  const double beyond =
      std::max(distance - (arm.a2 + forearm), std::abs(arm.a2 - forearm) - distance);
  part.missing = std::max(part.missing, beyond);
  const double a = 2.0 * arm.a2 * z;
  const double b = 2.0 * arm.a2 * x;
  const double c = x * x + z * z + arm.a2 * arm.a2 - arm.d4 * arm.d4 - arm.r4 * arm.r4;
  const double root = std::sqrt(std::max(a * a + b * b - c * c, 0.0));
  part.elbowSine = root / (2.0 * arm.a2 * forearm);
  part.elbowSingular = part.elbowSine < kElbowSingular;
  const double epsilon = elbowDown ? 1.0 : -1.0;
  if (distance < kReachSlack && seed != nullptr) {
    part.c2 = seed[1];  // the wrist centre lies on axis 2: every direction will do
  } else if (beyond > 0.0) {
    // The nearest pose: stretched towards the wrist centre, or folded.
    const bool folded = distance < arm.a2 && arm.a2 < forearm;
    part.c2 = folded ? std::atan2(-x, -z) : std::atan2(x, z);
  } else {
    part.c2 = std::atan2(b * c + epsilon * a * root, a * c - epsilon * b * root);
  }
  const double m = std::cos(part.c2) * x - std::sin(part.c2) * z;
  const double k = std::sin(part.c2) * x + std::cos(part.c2) * z - arm.a2;
  part.c3 = std::atan2(arm.r4 * m + arm.d4 * k, arm.r4 * k - arm.d4 * m);
}

/// Canonical values of the seed, or null.
const double* canonicalSeed(const Arm& arm, const double* seed, Vector6& storage) {
  if (seed == nullptr) {
    return nullptr;
  }
  storage = arm.gain * Eigen::Map<const Vector6>(seed) + arm.offset;
  return storage.data();
}

/// Axes 4 to 6 from the wrist's rotation R03ᵀ·A (Chalvin C.19–C.23 corrected).
void solveWrist(const Eigen::Matrix3d& wrist,
                bool flipped,
                const double* seed,
                Vector6& c,
                IkSolution& solution) {
  solution.wristSine = std::hypot(wrist(0, 2), wrist(1, 2));
  solution.wristSingular = solution.wristSine < kWristSingular;
  const double sign = flipped ? -1.0 : 1.0;
  if (solution.wristSingular) {
    c(3) = seed != nullptr ? seed[3] : 0.0;
  } else {
    c(3) = std::atan2(sign * wrist(1, 2), sign * wrist(0, 2));
  }
  const double cos4 = std::cos(c(3));
  const double sin4 = std::sin(c(3));
  // Rz(−c4)·wrist = Ry(c5)·Rz(c6)
  c(4) = std::atan2(cos4 * wrist(0, 2) + sin4 * wrist(1, 2), wrist(2, 2));
  c(5) =
      std::atan2(cos4 * wrist(1, 0) - sin4 * wrist(0, 0), cos4 * wrist(1, 1) - sin4 * wrist(0, 1));
}

struct Problem {
  Eigen::Matrix3d rotation;
  Vec3 centre;
};

Problem wristProblem(const Arm& arm, const Pose& T_base_flange) {
  const Pose T_canonical_wrist =
      arm.T_base_canonical.inverse() * T_base_flange * arm.T_wrist_flange.inverse();
  return {T_canonical_wrist.linear(), T_canonical_wrist.translation()};
}

ArmPart solveArmPart(const Arm& arm, const Vec3& centre, Branch branch, const double* seed) {
  ArmPart part;
  const double abscissa = solveShoulder(arm, centre, branch.backwards, seed, part);
  solveElbow(arm, abscissa - arm.a1, centre.z(), branch.elbowDown, seed, part);
  return part;
}

IkSolution solveBranch(const Arm& arm,
                       const Problem& problem,
                       const ArmPart& part,
                       const Eigen::Matrix3d& wrist,
                       bool flipped,
                       const double* seed) {
  IkSolution solution;
  solution.missing = std::max(part.missing, 0.0);
  solution.reachable = part.missing <= kReachSlack && problem.centre.allFinite();
  solution.elbowSine = part.elbowSine;
  solution.elbowSingular = part.elbowSingular;
  solution.shoulderSingular = part.shoulderSingular;
  solution.axisDistance = part.axisDistance;
  Vector6 c;
  c.head<3>() << part.c1, part.c2, part.c3;
  solveWrist(wrist, flipped, seed, c, solution);
  solution.joints = arm.inverseGain * (c - arm.offset);
  for (int j = 0; j < 6; ++j) {
    if (arm.periodic[static_cast<std::size_t>(j)]) {
      solution.joints(j) = wrapAngle(solution.joints(j));
    }
  }
  return solution;
}

Eigen::Matrix3d wristRotation(const Problem& problem, const ArmPart& part) {
  return (rotationZ(part.c1) * rotationY(part.c2 + part.c3)).transpose() * problem.rotation;
}

}  // namespace

std::string Branch::name() const {
  return std::string(flipped ? "F" : "N") + (elbowDown ? "D" : "U") + (backwards ? "B" : "T");
}

double armReach(const Arm& arm) {
  return arm.a2 + std::hypot(arm.d4, arm.r4);
}

IkSolution inverseArm(const Arm& arm,
                      const Pose& T_base_flange,
                      Branch branch,
                      const double* seed) {
  Vector6 storage;
  const double* canonical = canonicalSeed(arm, seed, storage);
  const Problem problem = wristProblem(arm, T_base_flange);
  const ArmPart part = solveArmPart(arm, problem.centre, branch, canonical);
  return solveBranch(arm, problem, part, wristRotation(problem, part), branch.flipped, canonical);
}

IkResult inverseArm(const Arm& arm, const Pose& T_base_flange, const double* seed) {
  Vector6 storage;
  const double* canonical = canonicalSeed(arm, seed, storage);
  const Problem problem = wristProblem(arm, T_base_flange);
  IkResult result;
  for (int k = 0; k < Branch::kCount / 2; ++k) {
    Branch branch = Branch::fromIndex(k);
    const ArmPart part = solveArmPart(arm, problem.centre, branch, canonical);
    const Eigen::Matrix3d wrist = wristRotation(problem, part);
    for (const bool flipped : {false, true}) {
      branch.flipped = flipped;
      result[static_cast<std::size_t>(branch.index())] =
          solveBranch(arm, problem, part, wrist, flipped, canonical);
    }
  }
  return result;
}

ArmMeasures armMeasures(const Arm& arm, const double* q) {
  const Vector6 c = arm.gain * Eigen::Map<const Vector6>(q) + arm.offset;
  const double forearm = std::hypot(arm.d4, arm.r4);
  const double c23 = c(1) + c(2);
  ArmMeasures own;
  own.wristSine = std::abs(std::sin(c(4)));
  own.elbowSine = std::abs(-arm.d4 * std::cos(c(2)) + arm.r4 * std::sin(c(2))) / forearm;
  own.axisDistance = std::hypot(
      arm.a1 + arm.a2 * std::sin(c(1)) - arm.d4 * std::cos(c23) + arm.r4 * std::sin(c23), arm.b);
  return own;
}

Branch branchOf(const Arm& arm, const double* q) {
  const Vector6 c = arm.gain * Eigen::Map<const Vector6>(q) + arm.offset;
  const double t = c(1) + c(2);
  const double upperX = std::sin(c(1));
  const double upperZ = std::cos(c(1));
  const double forearmX = -arm.d4 * std::cos(t) + arm.r4 * std::sin(t);
  const double forearmZ = arm.d4 * std::sin(t) + arm.r4 * std::cos(t);
  Branch branch;
  branch.flipped = std::sin(c(4)) < 0.0;
  branch.elbowDown = upperZ * forearmX - upperX * forearmZ < 0.0;
  branch.backwards = arm.a1 + arm.a2 * upperX + forearmX < 0.0;
  return branch;
}

Pose forwardArm(const Arm& arm, const double* q) {
  const Vector6 c = arm.gain * Eigen::Map<const Vector6>(q) + arm.offset;
  Pose T_canonical_wrist = Pose::Identity();
  const Eigen::Matrix3d arm1 = rotationZ(c(0));
  const Eigen::Matrix3d arm2 = arm1 * rotationY(c(1));
  const Eigen::Matrix3d arm3 = arm2 * rotationY(c(2));
  T_canonical_wrist.translation() =
      arm1 * Vec3(arm.a1, arm.b, 0.0) + arm2.col(2) * arm.a2 + arm3 * Vec3(-arm.d4, 0.0, arm.r4);
  T_canonical_wrist.linear() = arm3 * rotationZ(c(3)) * rotationY(c(4)) * rotationZ(c(5));
  return arm.T_base_canonical * T_canonical_wrist * arm.T_wrist_flange;
}

}  // namespace wcam::cell
