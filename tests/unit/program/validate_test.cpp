// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/validate.hpp"

#include "wcam/base/error.hpp"
#include "wcam/testing/sample_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

using namespace wcam;
using namespace wcam::program;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

template <class Move>
Move& firstOf(Program& program) {
  for (Instruction& instruction : program.instructions) {
    if (auto* move = std::get_if<Move>(&instruction.action)) {
      return *move;
    }
  }
  throw std::logic_error("the sample has every instruction");
}

template <class Kind>
void removeFirst(Program& program) {
  for (auto it = program.instructions.begin(); it != program.instructions.end(); ++it) {
    if (std::holds_alternative<Kind>(it->action)) {
      program.instructions.erase(it);
      return;
    }
  }
}

struct Case {
  const char* code;
  std::function<void(Program&)> damage;
};

}  // namespace

TEST(Validate, AcceptsTheSample) {
  EXPECT_TRUE(validate(wcam::testing::sampleProgram()).empty());
  EXPECT_NO_THROW(requireValid(wcam::testing::sampleProgram()));
}

TEST(Validate, FindsEveryKindOfDamage) {
  const Case cases[] = {
      {"program.no_motion", [](Program& p) { p.instructions.clear(); }},
      {"program.first_move", [](Program& p) { removeFirst<MoveJoint>(p); }},
      {"program.number_not_finite",
       [](Program& p) { firstOf<MoveLinear>(p).target.joints[2] = kNan; }},
      {"program.number_not_finite",
       [](Program& p) { firstOf<MoveLinear>(p).target.T_base_tcp.translation().x() = 1.0 / 0.0; }},
      {"program.number_not_finite", [](Program& p) { firstOf<MoveLinear>(p).speed = kNan; }},
      {"program.number_not_finite", [](Program& p) { firstOf<Wait>(p).seconds = kNan; }},
      {"program.pose_not_rigid",
       [](Program& p) { firstOf<MoveCircular>(p).via->T_table_tcp.linear() *= 1.001; }},
      {"program.pose_not_rigid",
       [](Program& p) { firstOf<MoveLinear>(p).target.T_base_tcp.linear().col(0) *= -1.0; }},
      {"program.joint_count",
       [](Program& p) { firstOf<MoveLinear>(p).target.joints.conservativeResize(6); }},
      {"program.speed", [](Program& p) { firstOf<MoveLinear>(p).speed = 0.0; }},
      {"program.speed", [](Program& p) { firstOf<MoveCircular>(p).speed = -1.0; }},
      {"program.speed_ratio", [](Program& p) { firstOf<MoveJoint>(p).speedRatio = 1.5; }},
      {"program.speed_ratio", [](Program& p) { firstOf<MoveJoint>(p).speedRatio = 0.0; }},
      {"program.arc_left_on",
       [](Program& p) {
         p.instructions.push_back({ArcOn{}, {}});
       }},
      {"program.arc_off_twice", [](Program& p) { removeFirst<ArcOn>(p); }},
      {"program.arc_twice", [](Program& p) { removeFirst<ArcOff>(p); }},
      {"program.arc_before_motion",
       [](Program& p) {
         p.instructions.insert(p.instructions.begin(), {ArcOn{}, {}});
       }},
      {"program.job", [](Program& p) { firstOf<ArcOn>(p).job = -1; }},
      {"program.wire_speed", [](Program& p) { firstOf<SetProcess>(p).wireSpeed = -1.0; }},
      {"program.time", [](Program& p) { firstOf<ArcOff>(p).craterTime = -1.0; }},
      {"program.output", [](Program& p) { firstOf<SetIo>(p).output = 0; }},
      {"program.marks", [](Program& p) { removeFirst<LayerEnd>(p); }},
      {"program.marks", [](Program& p) { removeFirst<BeadBegin>(p); }},
      {"program.cell", [](Program& p) { p.cell.robotJoints = 0; }},
      {"program.cell", [](Program& p) { p.cell.jointSpeeds.pop_back(); }},
      {"program.configuration", [](Program& p) { p.cell.configuration = "XYZ"; }},
      {"program.configuration",
       [](Program& p) { firstOf<MoveLinear>(p).target.configuration = "N"; }},
  };
  for (const Case& test : cases) {
    Program program = wcam::testing::sampleProgram();
    test.damage(program);
    const auto findings = validate(program);
    const bool found = std::any_of(findings.begin(), findings.end(), [&](const Diagnostic& d) {
      return d.code == test.code && d.severity == Severity::Violation && !d.remedy.empty();
    });
    EXPECT_TRUE(found) << test.code;
    EXPECT_THROW(requireValid(program), Error) << test.code;
  }
}

TEST(Validate, CountsAndPlacesFindings) {
  Program program = wcam::testing::sampleProgram();
  for (Instruction& instruction : program.instructions) {
    if (auto* move = std::get_if<MoveLinear>(&instruction.action);
        move != nullptr && instruction.origin.point > 20) {
      move->speed = -1.0;
    }
  }
  const auto findings = validate(program);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].place, (Place{"sample", 0, 0, 21}));
  EXPECT_EQ(findings[0].data.at(0), (std::pair<std::string, double>{"count", 8.0}));
}

TEST(Validate, WarnsOfAJointMoveWithTheArcOn) {
  Program program = wcam::testing::sampleProgram();
  const MoveJoint move = firstOf<MoveJoint>(program);
  for (auto it = program.instructions.begin(); it != program.instructions.end(); ++it) {
    if (std::holds_alternative<ArcOn>(it->action)) {
      program.instructions.insert(it + 1, {move, {}});
      break;
    }
  }
  const auto findings = validate(program);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].code, "program.joint_move_with_arc");
  EXPECT_EQ(findings[0].severity, Severity::Warning);
  EXPECT_NO_THROW(requireValid(program));
}
