// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/split.hpp"

#include "wcam/base/error.hpp"
#include "wcam/program/names.hpp"
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

TEST(SplitNamed, ShortProgramBearsTheMainName) {
  const Program program = wcam::testing::sampleProgram();
  const NamedParts split = splitNamed(program, 0, "  ", 24, wcam::JobContext());
  EXPECT_FALSE(split.chained);
  EXPECT_EQ(split.main, controllerName(program.name, 24));
  ASSERT_EQ(split.parts.size(), 1U);
  EXPECT_EQ(split.calls(), std::vector<std::string>{split.main});
  EXPECT_EQ(split.parts[0].instructions.size(), program.instructions.size());
}

TEST(SplitNamed, PartsFollowEachOtherAndTellOfBurningCuts) {
  const Program program = wcam::testing::sampleProgram({.layers = 3, .pointsPerBead = 100});
  const wcam::JobContext context;
  const NamedParts split = splitNamed(program, 30, "wall", 24, context);
  EXPECT_TRUE(split.chained);
  EXPECT_EQ(split.main, "WALL");
  const Instruction* next = program.instructions.data();
  for (const NamedPart& part : split.parts) {
    EXPECT_TRUE(part.name.starts_with("WALL_")) << part.name;
    EXPECT_EQ(part.instructions.data(), next);
    next += part.instructions.size();
  }
  EXPECT_EQ(next, program.instructions.data() + program.instructions.size());
  const std::vector<wcam::Diagnostic> findings = context.diagnostics().items();
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "post.cut_with_arc_on");
  EXPECT_EQ(findings[0].data.at(0).second,
            static_cast<double>(splitProgram(program, 30).cutsWithArcOn));
}
