// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/testing/sample_program.hpp"

#include "krl_reader.hpp"
#include "post_fixture.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace wcam;
using namespace wcam::test;

namespace {

constexpr unsigned kSeed = 12;
constexpr double kAngleTolerance = 5e-5 + 1e-9;

}  // namespace

TEST(Kuka, CartesianModeReturnsThePoses) {
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  const auto program = randomProgram(kSeed, 20, 200);
  const auto planned = plannedMoves(program);
  for (const bool coupled : {true, false}) {
    for (const char* range : {"wrapped", "continuous"}) {
      const std::string params = std::string(R"({"coupled": )") + (coupled ? "true" : "false") +
                                 R"(, "ptp_positions": "cartesian", "angle_range": ")" + range +
                                 R"("})";
      const ReadJob job = readKrl(runPost("wcam.post.kuka", program, params));
      ASSERT_TRUE(sameStructure(job, planned, kAngleTolerance));
      for (std::size_t i = 0; i < planned.size(); ++i) {
        const auto& pose = coupled ? planned[i].target.T_table_tcp : planned[i].target.T_base_tcp;
        ASSERT_EQ(job.moves[i].kind, planned[i].kind);
        ASSERT_LE((job.moves[i].pose.translation() - pose.translation()).cwiseAbs().maxCoeff(),
                  5e-4 + 1e-9);
        ASSERT_LE(angleBetween(job.moves[i].pose.linear(), pose.linear()), 3 * kAngleTolerance);
        // 5 decimals of m/s, and whole percents.
        ASSERT_NEAR(job.moves[i].speed, planned[i].speed,
                    planned[i].kind == ReadKind::Joint ? 0.5 : 5.001e-3);
      }
    }
  }
}

TEST(Kuka, JointModeReturnsTheJoints) {
  const auto program = randomProgram(kSeed, 10, 300);
  const auto planned = plannedMoves(program);
  const JobContext context;
  const ReadJob job = readKrl(runPost("wcam.post.kuka", program, R"({"mode": "joint"})", context));
  ASSERT_TRUE(sameStructure(job, planned, kAngleTolerance, false));
  EXPECT_EQ(job.fewestJointDecimals, 4);
  for (std::size_t i = 0; i < planned.size(); ++i) {
    ASSERT_EQ(job.moves[i].kind, ReadKind::Joint);
    for (std::size_t k = 0; k < 6; ++k) {
      ASSERT_NEAR(job.moves[i].joints[k],
                  radToDeg(planned[i].target.joints[static_cast<Eigen::Index>(k)]),
                  kAngleTolerance);
    }
  }
  EXPECT_EQ(context.diagnostics().count("post.speed_rounded"), 1U);
}

// PTP moves run at ten times the speed of a bead and more.
TEST(Kuka, JointModeNeverSwitchesTheArcOn) {
  auto program = wcam::testing::sampleProgram();
  for (const char* params : {R"({"mode": "joint"})",
                             R"({"mode": "joint", "arc": "template", "wire_variable": "WIRE"})"}) {
    const JobContext context;
    const std::string text = runPost("wcam.post.kuka", program, params, context).at(0).second;
    EXPECT_EQ(text.find("$OUT[1]"), std::string::npos);
    EXPECT_EQ(text.find("\nARC_ON"), std::string::npos);
    EXPECT_EQ(text.find("\nWIRE"), std::string::npos);
    EXPECT_EQ(context.diagnostics().count("post.dry_run"), 1U);
    for (const ReadMove& move : readKrl({{"SAMPLE.src", text}}).moves) {
      ASSERT_FALSE(move.arc);
    }
  }
}

TEST(Kuka, JointModeKeepsTheTimeOfAMove) {
  auto program = wcam::testing::sampleProgram({.layers = 1, .pointsPerBead = 3});
  program.cell.jointSpeeds.assign(8, 2.0);
  // 10 mm at 5 mm/s take 2 s; the fastest joint turns by 0.8 rad, which takes 0.4 s at full speed.
  auto& from = std::get<program::MoveLinear>(program.instructions[4].action);
  auto& to = std::get<program::MoveLinear>(program.instructions[7].action);
  to.target = from.target;
  to.target.T_table_tcp.translation().x() += 10.0;
  to.target.joints[3] += 0.8;
  to.target.joints[6] -= 0.4;
  to.speed = 5.0;
  const ReadJob job = readKrl(runPost("wcam.post.kuka", program, R"({"mode": "joint"})"));
  EXPECT_DOUBLE_EQ(job.moves.at(2).speed, 20.0);
  program.cell.jointSpeeds.clear();
  EXPECT_THROW(runPost("wcam.post.kuka", program, R"({"mode": "joint"})"), Error);
}

TEST(Kuka, PtpMovesTakeAxisValues) {
  const auto program = wcam::testing::sampleProgram();
  const auto planned = plannedMoves(program);
  const ReadJob job = readKrl(runPost("wcam.post.kuka", program));
  ASSERT_TRUE(sameStructure(job, planned, kAngleTolerance));
  int ptp = 0;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    const bool joint = planned[i].kind == ReadKind::Joint;
    ptp += joint ? 1 : 0;
    ASSERT_EQ(job.moves[i].cartesian, !joint);
    for (std::size_t k = 0; joint && k < 6; ++k) {
      ASSERT_NEAR(job.moves[i].joints[k],
                  radToDeg(planned[i].target.joints[static_cast<Eigen::Index>(k)]),
                  kAngleTolerance);
    }
  }
  EXPECT_EQ(ptp, 2);
}

TEST(Kuka, RoundingNeverDecidesATurnBit) {
  auto program = wcam::testing::sampleProgram();
  auto& first = std::get<program::MoveJoint>(program.instructions[2].action);
  for (const double nothing : {-1e-15, 0.0, 1e-15, -1e-6}) {
    first.target.joints.head(6) << 0.1, -1.5, 1.6, nothing, 0.5, -0.2;
    const ReadJob job =
        readKrl(runPost("wcam.post.kuka", program, R"({"ptp_positions": "cartesian"})"));
    EXPECT_FALSE(job.moves[0].cartesian) << nothing;
    EXPECT_TRUE(job.moves[0].turns.empty());
  }
}

TEST(Kuka, FirstMoveHasStatusAndTurn) {
  auto program = wcam::testing::sampleProgram();
  auto& first = std::get<program::MoveJoint>(program.instructions[2].action);
  first.target.joints.head(6) << 0.1, -1.5, 1.6, -0.1, 0.5, -0.2;
  const std::string ptp = R"({"ptp_positions": "cartesian"})";
  ReadJob job = readKrl(runPost("wcam.post.kuka", program, ptp));
  EXPECT_EQ(job.moves[0].configuration, "010");
  EXPECT_EQ(job.moves[0].turns, (std::vector<int>{0, 1, 0, 1, 0, 1}));
  first.target.joints[4] = -0.5;
  first.target.configuration = "FDB";
  job = readKrl(runPost("wcam.post.kuka", program, ptp));
  EXPECT_EQ(job.moves[0].configuration, "101");
  job = readKrl(
      runPost("wcam.post.kuka", program, R"({"status": "110", "ptp_positions": "cartesian"})"));
  EXPECT_EQ(job.moves[0].configuration, "110");
  EXPECT_THROW(runPost("wcam.post.kuka", program, R"({"status": "12"})"), Error);
}

TEST(Kuka, GimbalLockKeepsA) {
  auto program = wcam::testing::sampleProgram({.layers = 1, .pointsPerBead = 40});
  const auto lock = [](double a, double c, double b) {
    return (Eigen::AngleAxisd(a, Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd(b, Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(c, Eigen::Vector3d::UnitX()))
        .toRotationMatrix();
  };
  for (const double sign : {1.0, -1.0}) {
    double c = 0.0;
    for (auto& instruction : program.instructions) {
      if (auto* move = std::get_if<program::MoveLinear>(&instruction.action)) {
        move->target.T_table_tcp.linear() = lock(0.7, c, c == 0.0 ? 0.3 : sign * kPi / 2.0);
        c += 0.05;
      }
    }
    const Files files = runPost("wcam.post.kuka", program);
    const ReadJob job = readKrl(files);
    const auto planned = plannedMoves(program);
    ASSERT_TRUE(sameStructure(job, planned, kAngleTolerance));
    for (std::size_t i = 0; i < planned.size(); ++i) {
      if (planned[i].kind == ReadKind::Joint) {
        continue;
      }
      EXPECT_LE(angleBetween(job.moves[i].pose.linear(), planned[i].target.T_table_tcp.linear()),
                3 * kAngleTolerance);
    }
    // 0.7 rad = 40.107 deg stays on every linear move of the lock.
    std::size_t kept = 0;
    for (std::size_t at = files[0].second.find(",A 40.107"); at != std::string::npos;
         at = files[0].second.find(",A 40.107", at + 1)) {
      ++kept;
    }
    EXPECT_EQ(kept, 41U);
  }
}

TEST(Kuka, ContinuousAnglesDoNotJump) {
  auto program = wcam::testing::sampleProgram({.layers = 1, .pointsPerBead = 200});
  const ReadJob wrapped = readKrl(runPost("wcam.post.kuka", program));
  const ReadJob job =
      readKrl(runPost("wcam.post.kuka", program, R"({"angle_range": "continuous"})"));
  EXPECT_TRUE(job.problems.empty());
  EXPECT_EQ(job.moves.size(), wrapped.moves.size());
  const std::string text =
      runPost("wcam.post.kuka", program, R"({"angle_range": "continuous"})").at(0).second;
  double last = 0.0;
  bool first = true;
  for (std::size_t at = text.find(",A "); at != std::string::npos; at = text.find(",A ", at + 1)) {
    const double a = std::stod(text.substr(at + 3, 12));
    EXPECT_TRUE(first || std::abs(a - last) < 90.0) << a << " after " << last;
    first = false;
    last = a;
  }
}

TEST(Kuka, SpeedsAreModalAndExact) {
  const auto program =
      wcam::testing::sampleProgram({.layers = 3, .pointsPerBead = 50, .speed = 6.0});
  const std::string text = runPost("wcam.post.kuka", program).at(0).second;
  std::size_t changes = 0;
  for (std::size_t at = text.find("$VEL.CP"); at != std::string::npos;
       at = text.find("$VEL.CP", at + 1)) {
    ++changes;
  }
  EXPECT_EQ(changes, 1U + 2U * 3U);
  EXPECT_NE(text.find("$VEL.CP = 0.00600\n"), std::string::npos);
  for (const ReadMove& move : readKrl({{"SAMPLE.src", text}}).moves) {
    if (move.arc) {
      ASSERT_DOUBLE_EQ(move.speed, 6.0);
    }
  }
  EXPECT_THROW(runPost("wcam.post.kuka", wcam::testing::sampleProgram({.speed = 1e-3})), Error);
  EXPECT_THROW(runPost("wcam.post.kuka", wcam::testing::sampleProgram({.speed = 3001.0})), Error);
}

TEST(Kuka, SplitsAndChainsLongOperations) {
  auto program = wcam::testing::sampleProgram({.layers = 200, .pointsPerBead = 198});
  program.name = "a_very_long_operation_name_that_no_controller_takes";
  const auto planned = plannedMoves(program);
  ASSERT_GT(planned.size(), 40000U);
  EXPECT_EQ(runPost("wcam.post.kuka", program, R"({"max_lines": 0})").size(), 1U);
  for (const char* params : {"{}", R"({"max_points": 5000, "max_lines": 0})"}) {
    const Files files = runPost("wcam.post.kuka", program, params);
    const ReadJob job = readKrl(files);
    ASSERT_TRUE(sameStructure(job, planned, kAngleTolerance));
    EXPECT_GE(job.programs, 6U);
    for (const auto& [name, count] : job.positions) {
      EXPECT_LE(name.size(), 24U);
      EXPECT_TRUE(count <= 9999U || count == planned.size()) << name;
    }
    for (const auto& [name, text] : files) {
      EXPECT_TRUE(std::string(params) != "{}" || std::count(text.begin(), text.end(), '\n') <= 9999)
          << name;
      for (const char* own : {"BAS (#INITMOV,0 )", "$TOOL = ", "$BASE = ", "$IPO_MODE = "}) {
        EXPECT_NE(text.find(own), std::string::npos) << name;
      }
    }
  }
}

TEST(Kuka, PutsAsManyBeadsIntoAProgramAsFit) {
  const auto program = wcam::testing::sampleProgram({.layers = 12, .pointsPerBead = 21});
  const auto linesOf = [](const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  };
  // What the head and a bead take, from programs of few and of many beads.
  const auto whole = linesOf(runPost("wcam.post.kuka", program, R"({"max_lines": 0})")[0].second);
  const auto one = linesOf(runPost("wcam.post.kuka",
                                   wcam::testing::sampleProgram({.layers = 1, .pointsPerBead = 21}),
                                   R"({"max_lines": 0})")[0]
                               .second);
  const double bead = static_cast<double>(whole - one) / 11.0;
  for (const int beads : {1, 2, 3, 5}) {
    // Room for so many beads, with what a part repeats: two speeds.
    const int limit =
        static_cast<int>(std::ceil(static_cast<double>(one) + bead * (beads - 1))) + 4;
    const Files files =
        runPost("wcam.post.kuka", program, "{\"max_lines\": " + std::to_string(limit) + "}");
    EXPECT_LE(files.size(), 1U + static_cast<std::size_t>(12 / beads) + 1U) << beads;
    for (const auto& [name, text] : files) {
      EXPECT_LE(linesOf(text), limit) << name;
    }
    EXPECT_TRUE(sameStructure(readKrl(files), plannedMoves(program), kAngleTolerance));
  }
}

TEST(Kuka, ALongBeadIsWrittenAsPartsThatStartAlone) {
  auto program = wcam::testing::sampleProgram({.layers = 1, .pointsPerBead = 500});
  for (std::size_t i = 100; i < program.instructions.size(); i += 100) {
    if (const auto* move = std::get_if<program::MoveLinear>(&program.instructions[i].action)) {
      program::Lift lift{i, move->target, 30.0, 0.1};
      lift.above.T_table_tcp.translation().z() += 50.0;
      program.lifts.push_back(lift);
    }
  }
  const JobContext context;
  const ReadJob job =
      readKrl(runPost("wcam.post.kuka", program, R"({"max_points": 210})", context));
  EXPECT_EQ(job.problems, std::vector<std::string>{});
  EXPECT_GE(job.programs, 4U);
  EXPECT_EQ(context.diagnostics().count("post.bead_interrupted"), 1U);
}

TEST(Kuka, AvoidsKeywords) {
  auto program = wcam::testing::sampleProgram();
  for (const char* word : {"end", "LIN", "wait", "signal", "bas", "IR_STOPM", "con", "aux"}) {
    program.name = word;
    const JobContext context;
    const Files files = runPost("wcam.post.kuka", program, "{}", context);
    EXPECT_TRUE(files.at(0).first.starts_with("P_")) << files.at(0).first;
    EXPECT_EQ(readKrl(files).problems, std::vector<std::string>{});
    EXPECT_EQ(context.diagnostics().count("post.name_changed"), 1U) << word;
  }
}

TEST(Kuka, KeepsBackAProgramThatLosesWireChanges) {
  auto program = wcam::testing::sampleProgram();
  const auto violations = [&](const std::string& params) {
    const JobContext context;
    runPost("wcam.post.kuka", program, params, context);
    return context.diagnostics().count(Severity::Violation);
  };
  EXPECT_EQ(violations("{}"), 0U);  // one wire speed: that of the job
  for (auto& instruction : program.instructions) {
    if (auto* set = std::get_if<program::SetProcess>(&instruction.action);
        set != nullptr && instruction.origin.layer == 1) {
      set->wireSpeed = 40.0;
    }
  }
  EXPECT_EQ(violations("{}"), 1U);
  EXPECT_EQ(violations(R"({"arc": "none"})"), 0U);
  EXPECT_EQ(violations(R"({"wire_variable": "WIRE"})"), 0U);
}

TEST(Kuka, WireChangesWithTheArcOnWaitForTheirPlace) {
  auto program = wcam::testing::sampleProgram();
  bool arc = false;
  std::size_t changes = 0;
  for (std::size_t i = 0; i < program.instructions.size(); ++i) {
    const program::Action& action = program.instructions[i].action;
    arc = std::holds_alternative<program::ArcOn>(action) ||
          (arc && !std::holds_alternative<program::ArcOff>(action));
    if (arc && std::holds_alternative<program::MoveLinear>(action)) {
      program::SetProcess set;
      set.wireSpeed = 40.0 + static_cast<double>(++changes);
      program.instructions.insert(program.instructions.begin() + static_cast<std::ptrdiff_t>(i),
                                  {set, program.instructions[i].origin});
      ++i;
    }
  }
  ASSERT_GT(changes, 0U);
  const auto files =
      runPost("wcam.post.kuka", program, R"({"mode": "cartesian", "wire_variable": "WIRE"})");
  EXPECT_EQ(readKrl(files).problems, std::vector<std::string>{});
  const std::string& text = files.at(0).second;
  std::size_t triggers = 0;
  for (std::size_t at = text.find("TRIGGER WHEN DISTANCE=0 DELAY=0 DO WIRE = ");
       at != std::string::npos; at = text.find("TRIGGER", at + 1)) {
    ++triggers;
  }
  EXPECT_EQ(triggers, changes);
  EXPECT_NE(text.find("\nWIRE = 3.000\n"), std::string::npos);  // before the arc
}

TEST(Kuka, DialectOfBaseAndArc) {
  const auto program = wcam::testing::sampleProgram();
  const auto text = [&](const std::string& params) {
    return runPost("wcam.post.kuka", program, params).at(0).second;
  };
  const std::string defaults = text("{}");
  EXPECT_NE(
      defaults.find("$BASE = EK(MACHINE_DEF[2].ROOT, MACHINE_DEF[2].MECH_TYPE, BASE_DATA[1])\n"),
      std::string::npos);
  EXPECT_EQ(defaults.find("$ACT_EX_AX"), std::string::npos);
  EXPECT_NE(defaults.find("WAIT SEC 0.500\n$OUT[1] = FALSE\n"), std::string::npos);
  EXPECT_NE(text(R"({"coupled": false, "base": 3})").find("$BASE = BASE_DATA[3]\n"),
            std::string::npos);
  EXPECT_NE(text(R"({"coupled": false, "base": 0})").find("$BASE = $NULLFRAME\n"),
            std::string::npos);
  EXPECT_NE(text(R"({"act_ex_ax": 2})").find("$ACT_EX_AX = 2\n"), std::string::npos);
  EXPECT_NE(text(R"({"approximation": "velocity"})").find("} C_VEL\n"), std::string::npos);
  EXPECT_NE(text(R"({"wire_variable": "WIRE"})").find("WIRE = 3.000\n"), std::string::npos);
  const std::string own = text(R"json({"arc": "template", "arc_on": "A10(#ARC_STRT)|JOB={job}",
                   "arc_off": "OFF({crater})"})json");
  EXPECT_NE(own.find("A10(#ARC_STRT)\nJOB=3\n"), std::string::npos);
  EXPECT_NE(own.find("OFF(0.500)\n"), std::string::npos);
  EXPECT_EQ(own.find("$OUT[1]"), std::string::npos);
  EXPECT_THROW(text(R"({"arc": "template", "arc_on": "a\nb"})"), Error);
  EXPECT_EQ(readKrl({{"SAMPLE.src", defaults}}).arcSchedules.size(), 2U);
}

TEST(Kuka, RefusesCellsItCannotDrive) {
  auto program = wcam::testing::sampleProgram({.positionerJoints = 0});
  program.cell.partCarried = true;
  EXPECT_NE(runPost("wcam.post.kuka", program).at(0).second.find("$IPO_MODE = #TCP\n"),
            std::string::npos);
  EXPECT_THROW(runPost("wcam.post.kuka", program, R"({"base": 0})"), Error);
  program = wcam::testing::sampleProgram({.positionerJoints = 1});
  program.cell.robotJoints = 5;
  program.cell.positionerJoints = 2;
  EXPECT_THROW(runPost("wcam.post.kuka", program), Error);
}
