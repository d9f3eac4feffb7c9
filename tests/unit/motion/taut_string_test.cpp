// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "taut_string.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace wcam::motion::detail {
namespace {

double energy(const std::vector<Gate>& gates, const std::vector<double>& x) {
  double sum = 0.0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    sum += (x[i] - x[i - 1]) * (x[i] - x[i - 1]) / (gates[i].time - gates[i - 1].time);
  }
  return sum;
}

/// Optimality of the convex problem min ∫ rate² by its stationarity: a value strictly inside its
/// gate has equal rates on both sides, one at its high end may only want to rise, at its low end
/// only to fall.
void expectStationary(const std::vector<Gate>& gates, const std::vector<double>& x, double slack) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    ASSERT_GE(x[i], gates[i].low);
    ASSERT_LE(x[i], gates[i].high);
    const double before = i > 0 ? (x[i] - x[i - 1]) / (gates[i].time - gates[i - 1].time) : 0.0;
    const double after =
        i + 1 < x.size() ? (x[i + 1] - x[i]) / (gates[i + 1].time - gates[i].time) : 0.0;
    const double pull = after - before;  // upwards
    if (x[i] < gates[i].high - 1e-9) {
      EXPECT_LE(pull, slack) << "gate " << i;
    }
    if (x[i] > gates[i].low + 1e-9) {
      EXPECT_GE(pull, -slack) << "gate " << i;
    }
  }
}

TEST(TautString, isStraightWhereTheGatesLetIt) {
  const std::vector<Gate> gates = {{0, 0, 0}, {1, -5, 5}, {3, -5, 9}, {4, 8, 8}};
  const std::vector<double> x = tautString(gates);
  ASSERT_EQ(x.size(), 4U);
  EXPECT_NEAR(x[1], 2.0, 1e-12);
  EXPECT_NEAR(x[2], 6.0, 1e-12);
}

TEST(TautString, hasFreeEnds) {
  const std::vector<double> x = tautString({{0, -3, 7}, {1, 4, 5}, {2, -9, 9}});
  EXPECT_NEAR(x[0], x[1], 1e-5);
  EXPECT_NEAR(x[2], x[1], 1e-5);
  EXPECT_TRUE(tautString({}).empty());
  EXPECT_EQ(tautString({{0, 2, 2}}), std::vector<double>{2.0});
}

TEST(TautString, hasTheLeastSquaresOfRates) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Gate> gates;
    double time = 0.0;
    double middle = 0.0;
    for (int i = 0; i < 60; ++i) {
      time += 0.05 + unit(random);
      middle += unit(random) - 0.5;
      const double half = unit(random) < 0.2 ? 0.0 : 0.8 * unit(random);
      gates.push_back({time, middle - half, middle + half});
    }
    const std::vector<double> x = tautString(gates);
    expectStationary(gates, x, 1e-6);
    // No random other way through the gates is better.
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<double> other = x;
      for (std::size_t i = 0; i < other.size(); ++i) {
        other[i] = std::clamp(other[i] + 0.1 * (unit(random) - 0.5), gates[i].low, gates[i].high);
      }
      EXPECT_GE(energy(gates, other), energy(gates, x) - 1e-9);
    }
  }
}

}  // namespace
}  // namespace wcam::motion::detail
