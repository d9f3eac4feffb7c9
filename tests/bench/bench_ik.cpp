// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed-form inverse kinematics with all 8 branches against one branch of Orocos KDL
// (ChainIkSolverPos_NR_JL from a seed within 0.01 rad): the same arm, the same poses, one run. Each
// result is checked by forward kinematics; a run that does not agree fails.

#include "wcam/base/quantity.hpp"
#include "wcam/cell/arm.hpp"
#include "wcam/cell/cell.hpp"

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <vector>

namespace {

using wcam::cell::Branch;
using wcam::cell::Cell;
using wcam::cell::JointBlock;
using wcam::cell::Pose;
using wcam::cell::PoseBlock;
using wcam::cell::Vector6;

constexpr int kBlocks = 400;
constexpr int kPoses = kBlocks * PoseBlock::kSize;
constexpr int kKdlPoses = 4000;
constexpr int kRepetitions = 7;
constexpr double kSeedDistance = 0.01;
constexpr double kAgreement = 1e-6;  // mm and sines, for both solvers
constexpr double kGoal = 100.0;

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double difference(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

/// The cell's arm as a KDL chain; Khalil's convention is KDL's DH_Craig1989.
KDL::Chain kdlChain(const Cell& cell) {
  KDL::Chain chain;
  for (const wcam::cell::Joint& joint : cell.robot.joints) {
    const KDL::Frame fixed =
        KDL::Frame(KDL::Rotation::RotX(joint.alpha)) * KDL::Frame(KDL::Vector(joint.d, 0, 0)) *
        KDL::Frame(KDL::Rotation::RotZ(joint.theta)) * KDL::Frame(KDL::Vector(0, 0, joint.r));
    // A fixed segment, then the rotation about z at its tip.
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::Fixed), fixed));
    chain.addSegment(
        KDL::Segment(KDL::Joint(KDL::Joint::RotZ, joint.sign), KDL::Frame::Identity()));
  }
  return chain;
}

/// KDL has no couplings: its values are signed joint angles.
Vector6 withoutCoupling(const Cell& cell, const Vector6& q) {
  const Vector6 angles = couplingMatrix(cell.robot) * q;
  Vector6 result;
  for (int j = 0; j < 6; ++j) {
    result(j) = angles(j) / cell.robot.joints[static_cast<std::size_t>(j)].sign;
  }
  return result;
}

struct PoseSet {
  std::vector<Vector6> joints;
  std::vector<Pose> poses;
};

PoseSet randomPoses(const Cell& cell) {
  std::mt19937_64 random(42);
  PoseSet set;
  for (int i = 0; i < kPoses; ++i) {
    Vector6 q;
    for (int j = 0; j < 6; ++j) {
      q(j) = uniform(random, -wcam::kPi, wcam::kPi);
    }
    set.joints.push_back(q);
    set.poses.push_back(chainPose(cell.robot, q.data()));
  }
  return set;
}

/// All branches of all poses by the block kernel; seconds of the best repetition.
double timeBlocks(const Cell& cell, std::vector<PoseBlock>& blocks, JointBlock& result) {
  double best = 1e300;
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    const double start = seconds();
    for (PoseBlock& block : blocks) {
      inverseBlock(*cell.arm, block, PoseBlock::kSize, result);
    }
    best = std::min(best, seconds() - start);
  }
  return best;
}

struct Check {
  long branches = 0;
  double worst = 0.0;
};

/// Forward kinematics of every reachable branch; near singularities too.
Check checkBlocks(const Cell& cell, const PoseSet& set, std::vector<PoseBlock>& blocks) {
  Check check;
  auto result = std::make_unique<JointBlock>();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    inverseBlock(*cell.arm, blocks[b], PoseBlock::kSize, *result);
    for (int n = 0; n < PoseBlock::kSize; ++n) {
      for (int k = 0; k < Branch::kCount; ++k) {
        if (result->reachable[k % 2][n] == 0.0) {
          continue;
        }
        Vector6 q;
        for (int j = 0; j < 6; ++j) {
          q(j) = result->joints[k][j][n];
        }
        ++check.branches;
        check.worst = std::max(
            check.worst, difference(chainPose(cell.robot, q.data()),
                                    set.poses[b * PoseBlock::kSize + static_cast<std::size_t>(n)]));
      }
    }
  }
  return check;
}

double timeSingle(const Cell& cell, const PoseSet& set, double& sum) {
  double best = 1e300;
  for (int repetition = 0; repetition < 3; ++repetition) {
    const double start = seconds();
    for (const Pose& pose : set.poses) {
      sum += wcam::cell::inverseArm(*cell.arm, pose)[0].joints(0);
    }
    best = std::min(best, seconds() - start);
  }
  return best;
}

struct KdlRun {
  double perPose = 1e300;
  int solved = 0;
  double worst = 0.0;
};

KdlRun runKdl(const Cell& cell, const PoseSet& set) {
  const KDL::Chain chain = kdlChain(cell);
  KDL::ChainFkSolverPos_recursive forward(chain);
  KDL::ChainIkSolverVel_pinv velocity(chain);
  KDL::JntArray low(6);
  KDL::JntArray high(6);
  for (unsigned j = 0; j < 6; ++j) {
    low(j) = -1e3;  // no limits: the values of the coupled axis leave one turn
    high(j) = 1e3;
  }
  KDL::ChainIkSolverPos_NR_JL solver(chain, low, high, forward, velocity, 100, 1e-9);
  std::mt19937_64 random(7);
  std::vector<KDL::JntArray> seeds;
  std::vector<KDL::Frame> targets;
  for (int i = 0; i < kKdlPoses; ++i) {
    const Vector6 q = withoutCoupling(cell, set.joints[static_cast<std::size_t>(i)]);
    KDL::JntArray seed(6);
    for (unsigned j = 0; j < 6; ++j) {
      seed(j) = q(j) + uniform(random, -kSeedDistance, kSeedDistance);
    }
    seeds.push_back(seed);
    const Pose& pose = set.poses[static_cast<std::size_t>(i)];
    const auto& r = pose.linear();
    const auto& p = pose.translation();
    targets.emplace_back(KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2),
                                       r(2, 0), r(2, 1), r(2, 2)),
                         KDL::Vector(p.x(), p.y(), p.z()));
  }
  KdlRun run;
  KDL::JntArray out(6);
  for (int repetition = 0; repetition < 3; ++repetition) {
    run.solved = 0;
    run.worst = 0.0;
    double spent = 0.0;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const double start = seconds();
      const int status = solver.CartToJnt(seeds[i], targets[i], out);
      spent += seconds() - start;
      if (status < 0) {
        continue;
      }
      KDL::Frame reached;
      forward.JntToCart(out, reached);
      const double error = (reached.p - targets[i].p).Norm();
      run.worst = std::max(run.worst, error);
      ++run.solved;
    }
    run.perPose = std::min(run.perPose, spent / static_cast<double>(targets.size()));
  }
  return run;
}

}  // namespace

int main() {
  const Cell cell =
      wcam::cell::loadCell(std::string(WCAM_RESOURCES) + "/cells/fanuc_arcmate120ic.json");
  const PoseSet set = randomPoses(cell);
  std::vector<PoseBlock> blocks(kBlocks);
  for (int i = 0; i < kPoses; ++i) {
    blocks[static_cast<std::size_t>(i / PoseBlock::kSize)].set(
        i % PoseBlock::kSize, set.poses[static_cast<std::size_t>(i)]);
  }
  auto result = std::make_unique<JointBlock>();
  const double own = timeBlocks(cell, blocks, *result) / kPoses;
  const Check check = checkBlocks(cell, set, blocks);
  double sum = 0.0;
  const double single = timeSingle(cell, set, sum) / kPoses;
  const KdlRun kdl = runKdl(cell, set);

  const double ratio = kdl.perPose / own;
  std::printf("poses %d, branches per pose %.3f, worst FK(IK) of the blocks %.2e\n", kPoses,
              static_cast<double>(check.branches) / kPoses, check.worst);
  std::printf("own, 8 branches, blocks     %9.1f ns/pose\n", own * 1e9);
  std::printf("own, 8 branches, one by one %9.1f ns/pose (checksum %.6f)\n", single * 1e9, sum);
  std::printf("KDL NR_JL, 1 branch, near   %9.1f ns/pose, solved %d of %d, worst %.2e mm\n",
              kdl.perPose * 1e9, kdl.solved, kKdlPoses, kdl.worst);
  std::printf("ratio %.1f (goal %.0f)\n", ratio, kGoal);
  const bool agree =
      check.worst <= kAgreement && kdl.worst <= kAgreement && kdl.solved >= kKdlPoses * 9 / 10;
  if (!agree) {
    std::printf("the results do not agree: the run is invalid\n");
  }
  return agree ? 0 : 1;
}
