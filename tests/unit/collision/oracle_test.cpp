// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nothing that FCL finds may be missed: random states of whole cells, every pair of the scene asked
// of FCL alone. The bench of this module does the same with 100 000 states.

#include "fcl_oracle.hpp"
#include "scenes.hpp"
#include <gtest/gtest.h>

namespace wcam::collision::test {
namespace {

/// Where distances are smaller than this, mm, rounding decides and FCL's own answers vary.
constexpr double kUndecided = 1e-4;

class Oracle : public testing::TestWithParam<const char*> {};

TEST_P(Oracle, nothingIsMissedAndExactAnswersAgree) {
  constexpr std::size_t kStates = 1500;
  const cell::Cell cell = shippedCell(GetParam());
  const toolpath::Toolpath path = bentTube(30, 120, 1.2);
  const toolpath::Substrate plate(Pose::Identity(), Vec3(200, 200, 10));
  CollisionSettings settings;
  settings.safetyDistance = 0.0;
  const CellCollision exact(cell, path, &plate, settings);
  settings.refine = false;
  const CellCollision grids(cell, path, &plate, settings);
  const FclOracle oracle(exact, cell);
  const std::uint64_t seed = 20261127;
  const std::vector<CellState> states = randomStates(cell, path, kStates, seed);
  std::vector<float> bound(states.size());
  std::vector<float> distance(states.size());
  grids.evaluate(states, bound);
  exact.evaluate(states, distance);
  std::size_t colliding = 0;
  std::size_t falseAlarms = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    std::string what;
    const bool hit = oracle.collides(states[i], &what);
    const std::vector<Contact> contacts = exact.contacts(states[i], 1.0);
    const double found = contacts.empty() ? 1.0 : contacts.front().distance;
    colliding += hit ? 1 : 0;
    falseAlarms += !hit && bound[i] < 0.0F ? 1 : 0;
    if (hit && found < -kUndecided) {
      EXPECT_LT(distance[i], 0.0F) << "seed " << seed << " state " << i << ": " << what;
      EXPECT_LT(bound[i], 0.0F) << "seed " << seed << " state " << i << ": " << what;
    }
    if (std::abs(found) > kUndecided) {
      EXPECT_EQ(hit, found < 0.0) << "seed " << seed << " state " << i << ": " << what << ", "
                                  << found << " mm";
    }
    // The grids end at the first thing that is not free: what they call free has its distance.
    if (bound[i] >= 0.0F) {
      EXPECT_LE(bound[i], distance[i] + 1e-3F);
    }
  }
  EXPECT_GT(colliding, kStates / 20);
  EXPECT_LT(colliding, kStates - kStates / 20);
  EXPECT_LT(falseAlarms, kStates / 10);
}

INSTANTIATE_TEST_SUITE_P(Cells,
                         Oracle,
                         testing::Values("fanuc_arcmate120ic",
                                         "fanuc_arcmate120ic_part_carried",
                                         "yaskawa_ma1440_mt250",
                                         "kuka_kr16_positioner",
                                         "kuka_kr360_part_carried"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace wcam::collision::test
