// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "taut_string.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace wcam::motion::detail {
namespace {

/// The ends are held a million lengths away: what that bends.
constexpr double kFarEnds = 1e-5;

std::vector<double> ratesOf(const std::vector<Gate>& gates, const std::vector<double>& x) {
  std::vector<double> rates;
  for (std::size_t i = 1; i < x.size(); ++i) {
    rates.push_back((x[i] - x[i - 1]) / (gates[i].time - gates[i - 1].time));
  }
  return rates;
}

/// Optimality of the convex problem min ∫ rate² by its stationarity: the rate rises only where the
/// high end of a gate holds the value down, and falls only over a low end.
void expectStationary(const std::vector<Gate>& gates, const std::vector<double>& x) {
  const std::vector<double> rates = ratesOf(gates, x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    ASSERT_GE(x[i], gates[i].low);
    ASSERT_LE(x[i], gates[i].high);
    const double before = i > 0 ? rates[i - 1] : 0.0;
    const double after = i < rates.size() ? rates[i] : 0.0;
    if (x[i] < gates[i].high - 1e-9) {
      EXPECT_LE(after - before, kFarEnds) << "gate " << i;
    }
    if (x[i] > gates[i].low + 1e-9) {
      EXPECT_GE(after - before, -kFarEnds) << "gate " << i;
    }
  }
}

/// Least greatest rate: what any two gates ask for (functions through gates that any two of them
/// allow exist on a line).
double leastGreatestRate(const std::vector<Gate>& gates) {
  double rate = 0.0;
  for (std::size_t i = 0; i < gates.size(); ++i) {
    for (std::size_t j = i + 1; j < gates.size(); ++j) {
      const double apart = std::max(gates[j].low - gates[i].high, gates[i].low - gates[j].high);
      rate = std::max(rate, apart / (gates[j].time - gates[i].time));
    }
  }
  return rate;
}

TEST(TautString, IsStraightWhereTheGatesLetIt) {
  const std::vector<Gate> gates = {{0, 0, 0}, {1, -5, 5}, {3, -5, 9}, {4, 8, 8}};
  const std::vector<double> x = tautString(gates);
  ASSERT_EQ(x.size(), 4U);
  EXPECT_NEAR(x[1], 2.0, 1e-12);
  EXPECT_NEAR(x[2], 6.0, 1e-12);
}

TEST(TautString, BendsAtTheEndsOfGates) {
  // Over the wall at 1, under the one at 3.
  const std::vector<Gate> gates = {{0, 0, 0}, {1, 4, 9}, {2, -9, 9}, {3, -9, -2}, {4, 0, 0}};
  const std::vector<double> x = tautString(gates);
  const double expected[] = {0.0, 4.0, 1.0, -2.0, 0.0};
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(x[i], expected[i], 1e-12) << i;
  }
}

TEST(TautString, HasFreeEnds) {
  const std::vector<double> x = tautString({{0, -3, 7}, {1, 4, 5}, {2, -9, 9}});
  EXPECT_NEAR(x[0], x[1], kFarEnds);
  EXPECT_NEAR(x[2], x[1], kFarEnds);
}

TEST(TautString, TakesFewGates) {
  EXPECT_TRUE(tautString({}).empty());
  EXPECT_EQ(tautString({{5, 2, 2}}), std::vector<double>{2.0});
  const std::vector<double> x = tautString({{5, 0, 1}, {7, 3, 9}});
  EXPECT_NEAR(x[0], 1.0, 1e-12);
  EXPECT_NEAR(x[1], 3.0, 1e-12);
}

TEST(TautString, HasTheLeastSquaresAndTheLeastGreatestRate) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double width = 3.0 * unit(random);
    std::vector<Gate> gates;
    double time = 100.0 * unit(random);
    double middle = 0.0;
    for (int i = 0; i < 80; ++i) {
      time += unit(random) < 0.1 ? 1e-6 : 0.05 + unit(random);
      middle += (gates.empty() || time - gates.back().time > 1e-3) ? unit(random) - 0.5 : 0.0;
      // Points among them.
      const double half = unit(random) < 0.2 ? 0.0 : width * unit(random);
      gates.push_back({time, middle - half, middle + half});
    }
    const std::vector<double> x = tautString(gates);
    ASSERT_EQ(x.size(), gates.size());
    expectStationary(gates, x);
    double greatest = 0.0;
    for (const double rate : ratesOf(gates, x)) {
      greatest = std::max(greatest, std::abs(rate));
    }
    EXPECT_NEAR(greatest, leastGreatestRate(gates), kFarEnds);
  }
}

}  // namespace
}  // namespace wcam::motion::detail
