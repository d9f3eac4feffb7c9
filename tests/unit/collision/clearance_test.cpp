// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What evaluate() answers is that of the worst pair of the whole cell, whatever pair is looked at
// first: a near pair must never hide one that overlaps. Every shipped cell, all pairs, the arm
// anywhere between its limits; FCL and contacts(), which ends at no pair, are the oracles.

#include "fcl_oracle.hpp"
#include "random_source.hpp"
#include "scenes.hpp"
#include <gtest/gtest.h>

namespace wcam::collision::test {
namespace {

/// Where distances are smaller than this, mm, rounding decides and FCL's own answers vary.
constexpr double kUndecided = 1e-3;
/// GJK ends within this of the distance of separate shapes, mm.
constexpr double kFclDistance = 1e-2;

/// Joints anywhere between the limits, whole turns of endless axes, with a random part of the
/// deposit.
std::vector<CellState> anywhere(const cell::Cell& cell,
                                std::size_t points,
                                std::size_t count,
                                std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<CellState> states(count);
  for (CellState& state : states) {
    state.joints = cell::JointVector::Zero(cell.jointCount());
    for (int j = 0; j < cell.jointCount(); ++j) {
      const cell::Joint& joint = cell.joint(j);
      state.joints(j) =
          joint.endless ? uniform(random, -kPi, kPi) : uniform(random, joint.min, joint.max);
    }
    state.deposited = random() % (points + 1);
  }
  return states;
}

class WholeCell : public ::testing::TestWithParam<const char*> {};

TEST_P(WholeCell, ANearPairNeverHidesOneThatOverlaps) {
  constexpr std::size_t kNear = 400;
  constexpr std::size_t kAnywhere = 600;
  const std::uint64_t seed = wcam::testing::testSeeds(1).front();
  SCOPED_TRACE("seed " + std::to_string(seed));
  const cell::Cell cell = shippedCell(GetParam());
  const toolpath::Toolpath path = bentTube(30, 120, 1.2);
  const toolpath::Substrate plate(Pose::Identity(), Vec3(300, 300, 10));
  // Of several safety distances: the greater, the more pairs are near before the worst is met.
  for (const double safety : {5.0, 40.0}) {
    CollisionSettings settings;
    settings.safetyDistance = safety;
    const CellCollision collision(cell, path, &plate, settings);
    const FclOracle oracle(collision, cell);
    std::vector<CellState> states = anywhere(cell, path.pointCount(), kAnywhere, seed);
    const std::vector<CellState> near = randomStates(cell, path, kNear, seed + 1);
    states.insert(states.end(), near.begin(), near.end());
    std::vector<float> clearance(states.size());
    collision.evaluate(states, clearance);
    std::size_t overlapping = 0;
    std::size_t hidden = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
      const double distance = static_cast<double>(clearance[i]) + safety;
      std::string what;
      const bool hit = oracle.collides(states[i], &what);
      const std::vector<Contact> contacts = collision.contacts(states[i], safety);
      const double worst = contacts.empty() ? safety : contacts.front().distance;
      overlapping += hit ? 1U : 0U;
      hidden += worst < 0.0 && contacts.back().distance > 0.0 ? 1U : 0U;
      if (std::abs(worst) > kUndecided) {
        EXPECT_EQ(hit, worst < 0.0) << "state " << i << ": " << what;
        EXPECT_EQ(hit, distance < 0.0) << "state " << i << ": " << what << ", " << distance;
      }
      if (worst < safety) {
        // Contacts tell the least translation, evaluate() how deep the deepest points lie: the
        // same while solids only touch, both deep where they are nearly one within the other.
        if (worst < -kUndecided) {
          EXPECT_LT(distance, 0.1 * worst) << "state " << i;
        } else {
          EXPECT_NEAR(distance, worst, kUndecided) << "state " << i;
        }
      } else {
        EXPECT_GE(clearance[i], -1e-3F) << "state " << i;
      }
      EXPECT_LE(distance, oracle.shapeDistance(states[i]) + kFclDistance) << "state " << i;
    }
    // The states are worth something: some overlap while another pair is only near.
    EXPECT_GT(overlapping, states.size() / 50);
    EXPECT_GT(hidden, 10U) << "safety " << safety;
  }
}

INSTANTIATE_TEST_SUITE_P(Cells,
                         WholeCell,
                         ::testing::Values("fanuc_arcmate120ic",
                                           "fanuc_arcmate120ic_part_carried",
                                           "kuka_kr16",
                                           "kuka_kr16_part_carried",
                                           "kuka_kr16_positioner",
                                           "kuka_kr360_part_carried",
                                           "kuka_kr360_platter",
                                           "yaskawa_ma1440_mt250",
                                           "yaskawa_ma1440_part_carried"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace wcam::collision::test
