// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/split.hpp"

#include "wcam/base/error.hpp"
#include "wcam/program/names.hpp"
#include "wcam/testing/sample_program.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

using namespace wcam::program;

namespace {

std::vector<Instruction> instructionsOf(const Program& program, const ProgramPart& part) {
  std::vector<Instruction> all = part.lead;
  all.insert(all.end(), program.instructions.begin() + static_cast<std::ptrdiff_t>(part.begin),
             program.instructions.begin() + static_cast<std::ptrdiff_t>(part.end));
  all.insert(all.end(), part.tail.begin(), part.tail.end());
  return all;
}

int targetsOf(const std::vector<Instruction>& instructions) {
  int count = 0;
  for (const Instruction& instruction : instructions) {
    count += targetCount(instruction.action);
  }
  return count;
}

/// The rules of a part that an operator starts alone: a joint move first, the arc only after an
/// approach, off at the end, and a wire speed before it.
void expectStartsAlone(const std::vector<Instruction>& part, const std::string& what) {
  int moves = 0;
  bool arc = false;
  bool wire = false;
  for (const Instruction& instruction : part) {
    const Action& action = instruction.action;
    if (targetCount(action) > 0) {
      EXPECT_TRUE(moves > 0 || std::holds_alternative<MoveJoint>(action)) << what;
      ++moves;
    }
    wire = wire || std::holds_alternative<SetProcess>(action);
    if (std::holds_alternative<ArcOn>(action)) {
      EXPECT_TRUE(moves >= 2 && !arc && wire) << what << " after " << moves << " moves";
      arc = true;
    }
    if (std::holds_alternative<ArcOff>(action)) {
      EXPECT_TRUE(arc) << what;
      arc = false;
    }
  }
  EXPECT_FALSE(arc) << what;
}

/// Parts follow each other and drop nothing but the one move that a cut in a bead writes itself.
void expectWhole(const Program& program, const ProgramParts& split) {
  std::size_t next = 0;
  for (const ProgramPart& part : split.parts) {
    EXPECT_EQ(part.begin, next);
    EXPECT_GE(part.end, part.begin);
    next = part.end + (part.tail.empty() ? 0 : 1);
  }
  EXPECT_EQ(next, program.instructions.size());
}

/// With a lift at every tenth linear move of each bead.
Program withLifts(Program program) {
  bool arc = false;
  int count = 0;
  for (std::size_t i = 0; i < program.instructions.size(); ++i) {
    const Action& action = program.instructions[i].action;
    arc = std::holds_alternative<ArcOn>(action) || (arc && !std::holds_alternative<ArcOff>(action));
    if (arc && std::holds_alternative<MoveLinear>(action) && ++count % 10 == 0) {
      Lift lift;
      lift.instruction = i;
      lift.above = std::get<MoveLinear>(action).target;
      lift.above.T_table_tcp.translation().z() += 50.0;
      lift.speed = 30.0;
      program.lifts.push_back(lift);
    }
  }
  return program;
}

}  // namespace

TEST(SplitProgram, KeepsAShortProgramWhole) {
  const Program program = wcam::testing::sampleProgram();
  EXPECT_EQ(splitProgram(program, {}).parts.size(), 1U);
  const ProgramParts split = splitProgram(program, {.positions = 15000, .lines = 9999});
  ASSERT_EQ(split.parts.size(), 1U);
  EXPECT_TRUE(split.parts[0].lead.empty());
  EXPECT_EQ(split.parts[0].end, program.instructions.size());
}

TEST(SplitProgram, CutsBetweenBeadsIntoPartsThatStartAlone) {
  const Program program = wcam::testing::sampleProgram({.layers = 20, .pointsPerBead = 50});
  for (const int limit : {57, 60, 100, 107, 333}) {
    const ProgramParts split = splitProgram(program, {.positions = limit});
    EXPECT_EQ(split.cutsWithArcOn, 0U) << limit;
    EXPECT_EQ(split.interruptedBeads, 0U) << limit;
    expectWhole(program, split);
    for (const ProgramPart& part : split.parts) {
      const auto all = instructionsOf(program, part);
      EXPECT_LE(targetsOf(all), limit);
      expectStartsAlone(all, std::to_string(limit));
    }
  }
}

TEST(SplitProgram, CountsLines) {
  const Program program = wcam::testing::sampleProgram({.layers = 20, .pointsPerBead = 50});
  SplitLimits limits;
  limits.lines = 200;
  limits.headLines = 30;
  limits.linesOf = [](const Action& action) { return targetCount(action) > 0 ? 2 : 1; };
  const ProgramParts split = splitProgram(program, limits);
  EXPECT_GT(split.parts.size(), 12U);
  for (const ProgramPart& part : split.parts) {
    int lines = limits.headLines;
    for (const Instruction& instruction : instructionsOf(program, part)) {
      lines += limits.linesOf(instruction.action);
    }
    EXPECT_LE(lines, 200);
  }
}

TEST(SplitProgram, ALinkWithoutAJointMoveGetsOne) {
  Program program = wcam::testing::sampleProgram({.layers = 10, .pointsPerBead = 20});
  bool first = true;
  for (Instruction& instruction : program.instructions) {
    if (const auto* joint = std::get_if<MoveJoint>(&instruction.action)) {
      if (!first) {
        instruction.action = MoveLinear{joint->target, 50.0, false};
      }
      first = false;
    }
  }
  const ProgramParts split = splitProgram(program, {.positions = 60});
  EXPECT_GT(split.parts.size(), 3U);
  EXPECT_EQ(split.cutsWithArcOn, 0U);
  expectWhole(program, split);
  for (const ProgramPart& part : split.parts) {
    expectStartsAlone(instructionsOf(program, part), "linked");
  }
}

TEST(SplitProgram, ALongBeadStopsAndStartsAgainAtALift) {
  const Program program =
      withLifts(wcam::testing::sampleProgram({.layers = 3, .pointsPerBead = 100}));
  const ProgramParts split = splitProgram(program, {.positions = 40});
  EXPECT_EQ(split.cutsWithArcOn, 0U);
  EXPECT_GE(split.interruptedBeads, 6U);
  expectWhole(program, split);
  for (const ProgramPart& part : split.parts) {
    const auto all = instructionsOf(program, part);
    EXPECT_LE(targetsOf(all), 40);
    expectStartsAlone(all, "lifted");
  }
}

TEST(SplitProgram, CutsWithTheArcOnWhereThereIsNoLift) {
  const Program program = wcam::testing::sampleProgram({.layers = 3, .pointsPerBead = 100});
  const ProgramParts split = splitProgram(program, {.positions = 30});
  EXPECT_GE(split.cutsWithArcOn, 9U);
  expectWhole(program, split);
}

TEST(SplitProgram, NeverExceedsTheLimit) {
  for (int limit = 4; limit < 120; ++limit) {
    const Program program =
        withLifts(wcam::testing::sampleProgram({.layers = 4, .pointsPerBead = 37}));
    const ProgramParts split = splitProgram(program, {.positions = limit});
    expectWhole(program, split);
    for (const ProgramPart& part : split.parts) {
      ASSERT_LE(targetsOf(instructionsOf(program, part)), limit);
      ASSERT_GT(targetsOf(instructionsOf(program, part)), 0) << limit;
    }
  }
  EXPECT_THROW((void)splitProgram(wcam::testing::sampleProgram(), {.positions = 1}), wcam::Error);
  EXPECT_THROW((void)splitProgram(wcam::testing::sampleProgram(), {.lines = 5, .headLines = 5}),
               wcam::Error);
}

TEST(SplitNamed, ShortProgramBearsTheMainName) {
  const Program program = wcam::testing::sampleProgram();
  const NamedParts split = splitNamed(program, {}, "  ", {24}, wcam::JobContext());
  EXPECT_FALSE(split.chained);
  EXPECT_EQ(split.main, controllerName(program.name, 24));
  ASSERT_EQ(split.parts.size(), 1U);
  EXPECT_EQ(split.calls(), std::vector<std::string>{split.main});
  EXPECT_EQ(split.parts[0].body.size(), program.instructions.size());
}

TEST(SplitNamed, TellsOfInterruptedBeadsAndBurningCuts) {
  const Program program = wcam::testing::sampleProgram({.layers = 3, .pointsPerBead = 100});
  const wcam::JobContext burning;
  const NamedParts split = splitNamed(program, {.positions = 30}, "wall", {24}, burning);
  EXPECT_TRUE(split.chained);
  EXPECT_EQ(split.main, "WALL");
  for (const NamedPart& part : split.parts) {
    EXPECT_TRUE(part.name.starts_with("WALL_")) << part.name;
  }
  ASSERT_EQ(burning.diagnostics().items().size(), 1U);
  EXPECT_EQ(burning.diagnostics().items()[0].code, "post.cut_with_arc_on");
  EXPECT_EQ(burning.diagnostics().items()[0].severity, wcam::Severity::Violation);
  const wcam::JobContext lifted;
  (void)splitNamed(withLifts(program), {.positions = 40}, "wall", {24}, lifted);
  ASSERT_EQ(lifted.diagnostics().items().size(), 1U);
  EXPECT_EQ(lifted.diagnostics().items()[0].code, "post.bead_interrupted");
  EXPECT_EQ(lifted.diagnostics().items()[0].severity, wcam::Severity::Warning);
}

TEST(SplitNamed, TellsOfANameThatMeansSomethingElse) {
  constexpr std::array<std::string_view, 1> kWords = {"WALL"};
  const wcam::JobContext context;
  EXPECT_EQ(splitNamed(wcam::testing::sampleProgram(), {}, "wall", {24, kWords}, context).main,
            "P_WALL");
  EXPECT_EQ(context.diagnostics().count("post.name_changed"), 1U);
}
