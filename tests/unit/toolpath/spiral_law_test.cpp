// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/spiral_law.hpp"

#include "wcam/base/quantity.hpp"

#include "error_matchers.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {
namespace {

SpiralWish range(double height, double part) {
  SpiralWish wish;
  wish.height = height;
  wish.heightMin = height * (1.0 - part);
  wish.heightMax = height * (1.0 + part);
  return wish;
}

/// Generatrices of an elbow: r/R_b gives the spread.
std::vector<double> elbowLengths(std::size_t n, double shortest, double longest) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(n);
    lengths.push_back(0.5 * (shortest + longest) - 0.5 * (longest - shortest) * std::cos(angle));
  }
  return lengths;
}

TEST(Initiation, GapAfterEachRampIsThatOfTable31) {
  // Diourté Table 3.1 (A18): Δh_j = 0.2·j·h at ±10 %.
  const Initiation ramps = initiation(0.9, 1.1, 1.0, SpiralStart::Exact);
  ASSERT_EQ(ramps.begin.size(), 5U);
  for (std::size_t j = 0; j < 5; ++j) {
    EXPECT_NEAR(ramps.after(j, 1.0) - ramps.after(j, 0.0), 0.2 * static_cast<double>(j + 1), 1e-12);
  }
}

TEST(Initiation, NumberOfRampsAndLastRampFollowTheRange) {
  // A19.
  struct Case {
    double part;
    std::size_t ramps;
    double begin, end;
  };

  for (const Case& c : {Case{0.05, 10, 0.95, 1.05}, Case{0.10, 5, 0.9, 1.1},
                        Case{0.15, 4, 0.9, 1.0}, Case{0.20, 3, 0.8, 1.0}}) {
    SCOPED_TRACE(c.part);
    const Initiation ramps = initiation(1.0 - c.part, 1.0 + c.part, 1.0, SpiralStart::Exact);
    ASSERT_EQ(ramps.begin.size(), c.ramps);
    EXPECT_NEAR(ramps.begin.back(), c.begin, 1e-12);
    EXPECT_NEAR(ramps.end.back(), c.end, 1e-12);
    EXPECT_NEAR(ramps.total(1.0) - ramps.total(0.0), 1.0, 1e-12);
    for (std::size_t j = 0; j < c.ramps; ++j) {
      EXPECT_GE(ramps.begin[j], 1.0 - c.part - 1e-12);
      EXPECT_LE(ramps.end[j], 1.0 + c.part + 1e-12);
    }
  }
  // Seam steps at ±10 %: 0.7, 0.5, 0.3, 0.1 of h, then none.
  const Initiation ramps = initiation(0.9, 1.1, 1.0, SpiralStart::Exact);
  const double expected[] = {0.7, 0.5, 0.3, 0.1};
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_NEAR(ramps.after(j + 1, 0.0) - ramps.after(j, 1.0), expected[j], 1e-12);
  }
  EXPECT_NEAR(ramps.total(0.0) + 1.0 - ramps.total(1.0), 0.0, 1e-12);
  // A20: what the ramps take is 4.5 h at the seam's start and 5.5 h at its end.
  EXPECT_NEAR(ramps.total(0.0), 4.5, 1e-12);
  EXPECT_NEAR(ramps.total(1.0), 5.5, 1e-12);
}

TEST(Initiation, ThesisVariantEndsItsFifthRampAtTheMean) {
  const Initiation ramps = initiation(0.9, 1.1, 1.0, SpiralStart::Thesis);
  ASSERT_EQ(ramps.begin.size(), 5U);
  EXPECT_NEAR(ramps.end.back(), 1.0, 1e-12);
  EXPECT_NEAR(ramps.total(1.0) - ramps.total(0.0), 0.9, 1e-12);
}

TEST(TurnRange, IntegerTestIsSharperThanTheRatio) {
  // A12.
  EXPECT_EQ(turnRange(152.0, 178.0, 1.8, 2.2).first, 81);
  EXPECT_EQ(turnRange(152.0, 178.0, 1.8, 2.2).last, 84);
  const TurnRange none = turnRange(81.8, 100.0, 1.8, 2.2);
  EXPECT_EQ(none.first, 46);
  EXPECT_EQ(none.last, 45);
  EXPECT_FALSE(none.feasible());
  EXPECT_TRUE(turnRange(1800.0, 2200.0, 1.8, 2.2).feasible());
  EXPECT_FALSE(turnRange(1800.0, 2200.0 * 1.001, 1.8, 2.2).feasible());
}

TEST(SpiralLaw, LiteralReproducesTable33) {
  // A21: 152 … 178 mm at 2 mm ± 10 %: 84 revolutions, 1.81 … 2.12 mm.
  SpiralWish wish = range(2.0, 0.1);
  wish.start = SpiralStart::None;
  wish.end = SpiralEnd::Literal;
  wish.centred = false;
  const SpiralPlan plan = planSpiral(elbowLengths(100, 152.0, 178.0), wish);
  EXPECT_EQ(plan.turns.size(), 84U);
  EXPECT_NEAR(plan.regularMin, 1.8095, 5e-4);
  EXPECT_NEAR(plan.regularMax, 2.119, 5e-4);
  EXPECT_FALSE(plan.excess);
}

TEST(SpiralLaw, LiteralSeamStepDriftsAsDerived) {
  // A24: σ_k = D_1 − p + k·p/n on generatrices of one length.
  SpiralWish wish = range(1.0, 0.1);
  wish.end = SpiralEnd::Literal;
  const std::vector<double> lengths(50, 100.0);
  const SpiralPlan plan = planSpiral(lengths, wish);
  const std::size_t n = plan.turns.size() - plan.startTurns;
  const double p = 1.0;
  const double d1 = plan.turns.back().step.front();
  for (std::size_t k = 1; k < n; ++k) {
    const SpiralTurn& turn = plan.turns[plan.startTurns + k - 1];
    const SpiralTurn& next = plan.turns[plan.startTurns + k];
    EXPECT_NEAR(next.position.front() - turn.position.back(),
                d1 - p + static_cast<double>(k) * p / static_cast<double>(n), 1e-9);
  }
}

TEST(SpiralLaw, ContinuousSeamStepIsZeroAndHeightsKeepTheRange) {
  for (const double part : {0.05, 0.1, 0.15, 0.2, 0.3}) {
    for (const double mean : {60.0, 97.3, 165.0, 400.0}) {
      SCOPED_TRACE(std::to_string(part) + " " + std::to_string(mean));
      const SpiralWish wish = range(2.0, part);
      const std::vector<double> lengths = elbowLengths(90, mean * 0.99, mean * 1.01);
      const SpiralPlan plan = planSpiral(lengths, wish);
      EXPECT_LT(plan.largestSeamStep, 1e-12 * mean);
      ASSERT_FALSE(plan.excess);
      for (const SpiralTurn& turn : plan.turns) {
        for (const double step : turn.step) {
          EXPECT_GE(step, wish.heightMin * (1.0 - 1e-9));
          EXPECT_LE(step, wish.heightMax * (1.0 + 1e-9));
        }
      }
      // Positions are the sums of the steps and end on the border.
      std::vector<double> sum(lengths.size(), 0.0);
      for (const SpiralTurn& turn : plan.turns) {
        for (std::size_t i = 0; i < sum.size(); ++i) {
          sum[i] += turn.step[i];
          ASSERT_NEAR(turn.position[i], sum[i], 1e-9);
        }
      }
      for (std::size_t i = 0; i < sum.size(); ++i) {
        EXPECT_NEAR(sum[i], lengths[i], 1e-9);
      }
      // The path is continuous along a regular revolution and over its seam.
      for (std::size_t k = plan.startTurns; k + 1 + plan.endTurns < plan.turns.size(); ++k) {
        const double last = plan.turns[k].position.back();
        const double next = plan.turns[k + 1].position.front();
        EXPECT_LT(std::abs(next - last), 0.2 * wish.height);
      }
    }
  }
}

TEST(SpiralLaw, CentringBringsTheMeanToTheWish) {
  // A23: on a cylinder D = h within h/n.
  const SpiralPlan plan = planSpiral(std::vector<double>(40, 100.0), range(1.0, 0.1));
  EXPECT_NEAR(plan.regularMean, 1.0, 1.0 / 80.0);
  SpiralWish literal = range(1.0, 0.1);
  literal.end = SpiralEnd::Literal;
  EXPECT_NEAR(planSpiral(std::vector<double>(40, 100.0), literal).regularMean, 1.0, 1.0 / 80.0);
}

TEST(SpiralLaw, DepositChangesOnTheFlyWithoutAStep) {
  // A53, M48: from 2 mm to 1 mm, seam step 0 and the deposit continuous along the bead.
  SpiralWish wish = range(2.0, 0.1);
  wish.secondHeight = 1.0;
  wish.secondFrom = 80.0;
  const SpiralPlan plan = planSpiral(elbowLengths(60, 158.0, 162.0), wish);
  EXPECT_LT(plan.largestSeamStep, 1e-9);
  ASSERT_FALSE(plan.excess);
  std::vector<double> along;
  for (std::size_t k = plan.startTurns; k + plan.endTurns < plan.turns.size(); ++k) {
    along.insert(along.end(), plan.turns[k].step.begin(), plan.turns[k].step.end());
  }
  EXPECT_NEAR(along.front(), 2.0, 0.1);
  EXPECT_NEAR(along.back(), 1.0, 0.05);
  for (std::size_t i = 1; i < along.size(); ++i) {
    EXPECT_LT(std::abs(along[i] - along[i - 1]), 0.06) << i;
  }
}

TEST(SpiralLaw, InfeasibleModulationNamesTheGeneratrixAndARange) {
  const std::vector<double> lengths = elbowLengths(100, 100.0, 150.0);
  const SpiralWish wish = range(2.0, 0.1);
  const SpiralPlan plan = planSpiral(lengths, wish);
  ASSERT_TRUE(plan.excess);
  EXPECT_TRUE(plan.excess->height > wish.heightMax || plan.excess->height < wish.heightMin);
  EXPECT_TRUE(plan.excess->generatrix == 0 || plan.excess->generatrix == 50);
  EXPECT_TRUE(rangeThatWouldDo(lengths, wish));
  EXPECT_FALSE(planSpiral(elbowLengths(100, 100.0, 140.0), range(2.0, 0.25)).excess);
}

TEST(SpiralLaw, TheRangeThatIsNamedDoesWithTheFiguresThatAreShown) {
  int named = 0;
  for (const double longest : {104.0, 118.0, 133.0, 146.0, 150.0, 171.0, 190.0}) {
    for (const double height : {1.3, 2.0, 2.7}) {
      const std::vector<double> lengths = elbowLengths(100, 100.0, longest);
      const SpiralWish wish = range(height, 0.02);
      const auto found = rangeThatWouldDo(lengths, wish);
      if (!found) {
        continue;
      }
      ++named;
      // As a person types what is shown.
      const std::string shown = rangeText(*found).str();
      SpiralWish followed = wish;
      followed.heightMin = std::stod(shown);
      followed.heightMax = std::stod(shown.substr(shown.find("to") + 2));
      EXPECT_DOUBLE_EQ(followed.heightMin, found->low) << shown;
      EXPECT_DOUBLE_EQ(followed.heightMax, found->high) << shown;
      const SpiralPlan plan = planSpiral(lengths, followed);
      EXPECT_FALSE(plan.excess) << shown << " about " << height << " asks for "
                                << plan.excess->height;
    }
  }
  EXPECT_GT(named, 15);
}

TEST(SpiralLaw, ARangeIsRoundedOutwards) {
  EXPECT_EQ(roundedOutwards(1.596, 2.404), (SpiralRange{1.59, 2.41}));
  EXPECT_EQ(roundedOutwards(1.6, 2.4), (SpiralRange{1.6, 2.4})) << "what is shown exactly stays";
  EXPECT_EQ(roundedOutwards(1.5999, 2.4001), (SpiralRange{1.59, 2.41}));
}

TEST(SpiralLaw, BadWishesAreRefused) {
  const std::vector<double> lengths(10, 100.0);
  SpiralWish wish = range(2.0, 0.1);
  std::swap(wish.heightMin, wish.heightMax);
  EXPECT_THROW((void)planSpiral(lengths, wish), Error);
  wish = range(2.0, 0.0);
  EXPECT_THROW((void)planSpiral(lengths, wish), Error);
  wish = range(2.0, 0.1);
  wish.height = 3.0;
  EXPECT_THROW((void)planSpiral(lengths, wish), Error);
  EXPECT_THROW((void)planSpiral({}, range(2.0, 0.1)), Error);
  EXPECT_THROW((void)planSpiral({5.0, 5.0}, range(2.0, 0.1)), Error);
  EXPECT_THROW((void)planSpiral({100.0, 0.0}, range(2.0, 0.1)), Error);
}

}  // namespace
}  // namespace wcam::toolpath
