// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/split.hpp"

#include "wcam/base/error.hpp"
#include "wcam/testing/sample_program.hpp"

#include <gtest/gtest.h>

using namespace wcam::program;

namespace {

/// Positions of each part; fails when parts are not in order.
std::vector<int> targetsPerPart(const Program& program, const ProgramParts& parts) {
  std::vector<int> counts;
  std::size_t begin = 0;
  for (const std::size_t end : parts.ends) {
    EXPECT_GE(end, begin);
    int count = 0;
    for (std::size_t i = begin; i < end; ++i) {
      count += targetCount(program.instructions[i].action);
    }
    counts.push_back(count);
    begin = end;
  }
  EXPECT_EQ(begin, program.instructions.size());
  return counts;
}

bool arcAt(const Program& program, std::size_t end) {
  bool arc = false;
  for (std::size_t i = 0; i < end; ++i) {
    arc = std::holds_alternative<ArcOn>(program.instructions[i].action) ||
          (arc && !std::holds_alternative<ArcOff>(program.instructions[i].action));
  }
  return arc;
}

}  // namespace

TEST(SplitProgram, KeepsAShortProgramWhole) {
  const Program program = wcam::testing::sampleProgram();
  EXPECT_EQ(splitProgram(program, 0).ends.size(), 1U);
  EXPECT_EQ(splitProgram(program, 15000).ends.size(), 1U);
}

TEST(SplitProgram, CutsBetweenBeadsWherePossible) {
  const Program program = wcam::testing::sampleProgram({.layers = 20, .pointsPerBead = 50});
  for (const int limit : {53, 60, 100, 107, 333}) {
    const ProgramParts parts = splitProgram(program, limit);
    EXPECT_EQ(parts.cutsWithArcOn, 0U) << limit;
    for (const int count : targetsPerPart(program, parts)) {
      EXPECT_LE(count, limit);
      EXPECT_GT(count, 0);
    }
    for (const std::size_t end : parts.ends) {
      EXPECT_FALSE(arcAt(program, end)) << limit;
    }
  }
}

TEST(SplitProgram, CutsABeadThatIsLongerThanAProgram) {
  const Program program = wcam::testing::sampleProgram({.layers = 3, .pointsPerBead = 100});
  const ProgramParts parts = splitProgram(program, 30);
  std::size_t withArc = 0;
  for (const std::size_t end : parts.ends) {
    withArc += arcAt(program, end) ? 1 : 0;
  }
  EXPECT_GT(withArc, 0U);
  EXPECT_EQ(parts.cutsWithArcOn, withArc);
  for (const int count : targetsPerPart(program, parts)) {
    EXPECT_LE(count, 30);
  }
}

TEST(SplitProgram, NeverExceedsTheLimit) {
  for (int limit = 2; limit < 120; ++limit) {
    const Program program = wcam::testing::sampleProgram({.layers = 4, .pointsPerBead = 37});
    for (const int count : targetsPerPart(program, splitProgram(program, limit))) {
      ASSERT_LE(count, limit);
      ASSERT_GT(count, 0);
    }
  }
  EXPECT_THROW((void)splitProgram(wcam::testing::sampleProgram(), 1), wcam::Error);
}
