// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/testing/sample_program.hpp"

#include "ls_reader.hpp"
#include "post_fixture.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>

using namespace wcam;
using namespace wcam::test;

namespace {

constexpr unsigned kSeed = 11;
/// Half of the last of 4 decimals, and the rounding of the conversion to degrees.
constexpr double kJointTolerance = 5e-5 + 1e-9;

std::string firstLineWith(const std::string& text, const std::string& part) {
  const std::size_t at = text.find(part);
  if (at == std::string::npos) {
    return {};
  }
  const std::size_t begin = text.rfind('\n', at) + 1;
  return text.substr(begin, text.find('\n', at) - begin);
}

}  // namespace

TEST(Fanuc, KeepsBackTurnsThatAPositionCannotHold) {
  auto program = wcam::testing::sampleProgram();
  const auto violations = [&](double degrees, const std::string& params) {
    for (auto& instruction : program.instructions) {
      if (auto* move = std::get_if<program::MoveLinear>(&instruction.action)) {
        move->target.joints[5] = degToRad(degrees);
      }
    }
    const JobContext context;
    runPost("wcam.post.fanuc", program, params, context);
    return context.diagnostics().count("post.turn_out_of_range");
  };
  EXPECT_EQ(violations(7 * 360.0, R"({"mode": "cartesian"})"), 0U);
  EXPECT_EQ(violations(-8 * 360.0, R"({"mode": "cartesian"})"), 0U);
  EXPECT_EQ(violations(8 * 360.0, R"({"mode": "cartesian"})"), 1U);
  EXPECT_EQ(violations(-9 * 360.0, R"({"mode": "cartesian"})"), 1U);
  EXPECT_EQ(violations(-9 * 360.0, R"({"mode": "joint"})"), 0U);
}

TEST(Fanuc, JointModeReturnsTheJoints) {
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  const auto program = randomProgram(kSeed, 20, 200);
  const auto planned = plannedMoves(program);
  const ReadJob job = readLs(runPost("wcam.post.fanuc", program));
  ASSERT_GT(planned.size(), 4000U);
  ASSERT_TRUE(sameStructure(job, planned, kJointTolerance));
  EXPECT_EQ(job.fewestJointDecimals, 4);
  EXPECT_EQ(job.programs, 1U);
  for (std::size_t i = 0; i < planned.size(); ++i) {
    ASSERT_EQ(job.moves[i].kind, planned[i].kind);
    ASSERT_EQ(job.moves[i].joints.size(), 6U);
    for (std::size_t k = 0; k < 6; ++k) {
      ASSERT_NEAR(job.moves[i].joints[k],
                  radToDeg(planned[i].target.joints[static_cast<Eigen::Index>(k)]),
                  kJointTolerance);
    }
    const bool joint = planned[i].kind == ReadKind::Joint;
    ASSERT_NEAR(job.moves[i].speed, planned[i].speed, joint ? 0.5 : 0.05 + 1e-9);
    ASSERT_EQ(job.moves[i].coordinated || planned[i].kind == ReadKind::CircularVia, !joint);
  }
}

TEST(Fanuc, CartesianModeReturnsThePoses) {
  const auto program = randomProgram(kSeed, 10, 300);
  const auto planned = plannedMoves(program);
  for (const bool table : {false, true}) {
    const std::string frame = table ? R"(, "position_frame": "table")" : "";
    const ReadJob job =
        readLs(runPost("wcam.post.fanuc", program, R"({"mode": "cartesian")" + frame + "}"));
    ASSERT_TRUE(sameStructure(job, planned, kJointTolerance));
    for (std::size_t i = 0; i < planned.size(); ++i) {
      const auto& pose = table ? planned[i].target.T_table_tcp : planned[i].target.T_base_tcp;
      ASSERT_TRUE(job.moves[i].cartesian);
      // Three decimals of mm and of degrees; the rotation adds up three roundings.
      ASSERT_LE((job.moves[i].pose.translation() - pose.translation()).cwiseAbs().maxCoeff(),
                5e-4 + 1e-9);
      ASSERT_LE(angleBetween(job.moves[i].pose.linear(), pose.linear()), 1.5e-3 + 1e-9);
      const auto turns = [&](int joint) {
        return static_cast<int>(std::lround(planned[i].target.joints[joint] / (2.0 * kPi)));
      };
      ASSERT_EQ(job.moves[i].turns, (std::vector<int>{turns(0), turns(3), turns(5)}));
      ASSERT_EQ(job.moves[i].configuration, "NUT");
    }
  }
}

TEST(Fanuc, ConfigurationFollowsTheTargets) {
  auto program = wcam::testing::sampleProgram({.layers = 1, .pointsPerBead = 4});
  program.cell.configuration = "FDB";
  std::get<program::MoveLinear>(program.instructions[4].action).target.configuration = "NUT";
  const ReadJob job = readLs(runPost("wcam.post.fanuc", program, R"({"mode": "cartesian"})"));
  EXPECT_EQ(job.moves.at(0).configuration, "FDB");
  EXPECT_EQ(job.moves.at(1).configuration, "NUT");
  EXPECT_EQ(job.moves.at(2).configuration, "NUT");
}

// AT-40: 36 cm/min are 6 mm/s on every deposition move, in both units.
TEST(Fanuc, DepositionSpeedIsExact) {
  const auto program =
      wcam::testing::sampleProgram({.layers = 5, .pointsPerBead = 100, .speed = 6.0});
  for (const char* params : {R"({"speed_unit": "mm_sec"})", R"({"speed_unit": "cm_min"})"}) {
    const Files files = runPost("wcam.post.fanuc", program, params);
    const ReadJob job = readLs(files);
    EXPECT_TRUE(job.problems.empty()) << job.problems.front();
    std::size_t deposited = 0;
    for (const ReadMove& move : job.moves) {
      if (move.arc) {
        ++deposited;
        ASSERT_DOUBLE_EQ(move.speed, 6.0);
      }
    }
    EXPECT_EQ(deposited, 5U * 99U);
  }
  const std::string text =
      runPost("wcam.post.fanuc", program, R"({"speed_unit": "cm_min"})").at(0).second;
  EXPECT_NE(text.find("36.0cm/min CNT100 COORD"), std::string::npos);
}

// AT-40: at most 15 000 points per program, else at least two chained ones.
TEST(Fanuc, SplitsAndChainsLongOperations) {
  auto program = wcam::testing::sampleProgram({.layers = 200, .pointsPerBead = 198});
  program.name = "a_very_long_operation_name_that_no_controller_takes";
  const auto planned = plannedMoves(program);
  ASSERT_GT(planned.size(), 40000U);
  const Files files = runPost("wcam.post.fanuc", program);
  const ReadJob job = readLs(files);
  ASSERT_TRUE(sameStructure(job, planned, kJointTolerance));
  EXPECT_EQ(files.size(), 6U);
  EXPECT_EQ(job.programs, 6U);
  for (const auto& [name, text] : files) {
    EXPECT_EQ(text.find("\n10000:"), std::string::npos) << name;
  }
  const ReadJob points = readLs(runPost("wcam.post.fanuc", program, R"({"max_lines": 0})"));
  EXPECT_EQ(points.programs, 4U);
  for (const auto& [name, count] : points.positions) {
    EXPECT_LE(count, 15000U) << name;
  }
  EXPECT_EQ(job.moves.front().program.size(), 36U);
  // No cut while the arc burns: each program begins with the arc off.
  std::string last;
  for (const ReadMove& move : job.moves) {
    if (move.program != last) {
      EXPECT_FALSE(move.arc);
      last = move.program;
    }
  }
}

TEST(Fanuc, FifteenThousandPointsAreOneProgram) {
  auto program = wcam::testing::sampleProgram({.layers = 1, .pointsPerBead = 15000 - 4});
  EXPECT_EQ(plannedMoves(program).size(), 15000U);
  EXPECT_EQ(runPost("wcam.post.fanuc", program, R"({"max_lines": 0})").size(), 1U);
  program = wcam::testing::sampleProgram({.layers = 1, .pointsPerBead = 15001 - 4});
  EXPECT_EQ(runPost("wcam.post.fanuc", program, R"({"max_lines": 0})").size(), 3U);
}

TEST(Fanuc, TellsOfACutWithTheArcOn) {
  const auto program = wcam::testing::sampleProgram({.layers = 2, .pointsPerBead = 100});
  const JobContext context;
  const ReadJob job = readLs(runPost("wcam.post.fanuc", program, R"({"max_points": 40})", context));
  EXPECT_FALSE(job.problems.empty());  // such parts cannot be started alone
  EXPECT_EQ(context.diagnostics().count("post.cut_with_arc_on"), 1U);
  EXPECT_EQ(context.diagnostics().count(Severity::Violation), 1U);
}

TEST(Fanuc, ShortNames) {
  auto program = wcam::testing::sampleProgram({.layers = 30, .pointsPerBead = 30});
  program.name = "elbow_planar_upper";
  const ReadJob job = readLs(
      runPost("wcam.post.fanuc", program, R"({"max_points": 300, "name_length": "short"})"), 8);
  EXPECT_TRUE(sameStructure(job, plannedMoves(program), kJointTolerance));
  EXPECT_GT(job.programs, 3U);
}

TEST(Fanuc, WritesArcsWaitsOutputsAndComments) {
  const auto program = wcam::testing::sampleProgram();
  const std::string params =
      R"({"arc_start": 4, "arc_end": 5, "wire_register": 32, "payload": 2, "comments": "beads", "group_fields": "7"})";
  const std::string text = runPost("wcam.post.fanuc", program, params).at(0).second;
  const ReadJob job = readLs({{"SAMPLE.LS", text}});
  EXPECT_TRUE(job.problems.empty()) << job.problems.front();
  EXPECT_EQ(job.arcSchedules, (std::vector<int>{4, 4}));
  EXPECT_EQ(job.waits, (std::vector<double>{0.5, 1.5, 0.5, 1.5}));
  EXPECT_EQ(job.outputs, (std::map<int, int>{{7, 2}}));
  const std::vector<std::string> own = {"sample program", "Layer 1", "Layer 1 bead 1", "Layer 2",
                                        "Layer 2 bead 1"};
  ASSERT_GE(job.comments.size(), own.size());
  EXPECT_TRUE(std::equal(own.rbegin(), own.rend(), job.comments.rbegin()));
  EXPECT_NE(text.find("R[32]=3.000"), std::string::npos);
  EXPECT_NE(text.find("Arc End[5]"), std::string::npos);
  EXPECT_NE(firstLineWith(text, "PAYLOAD").find(":  PAYLOAD[2]    ;"), std::string::npos);
  EXPECT_EQ(firstLineWith(text, "DEFAULT_GROUP"), "DEFAULT_GROUP\t= 1,1,*,*,*,*,*;");
  const ReadJob schedule = readLs(runPost("wcam.post.fanuc", program, R"({"crater": "schedule"})"));
  EXPECT_EQ(schedule.waits, (std::vector<double>{1.5, 1.5}));
  EXPECT_EQ(schedule.arcSchedules, (std::vector<int>{3, 3}));
}

TEST(Fanuc, WrapsCommentsThatWouldBreakTheText) {
  auto program = wcam::testing::sampleProgram();
  std::get<program::Comment>(program.instructions[0].action).text =
      "a comment; with a semicolon, a line feed\nand é, longer than thirty-two characters";
  program.projectName = "x\"y;";
  const ReadJob job = readLs(runPost("wcam.post.fanuc", program));
  EXPECT_TRUE(job.problems.empty()) << job.problems.front();
  EXPECT_EQ(std::count(job.comments.begin(), job.comments.end(), "a comment, with a semicolon, a"),
            1);
}

TEST(Fanuc, WritesOneGroupWithoutPositioner) {
  const auto program = wcam::testing::sampleProgram({.positionerJoints = 0});
  const Files files = runPost("wcam.post.fanuc", program);
  EXPECT_TRUE(sameStructure(readLs(files), plannedMoves(program), kJointTolerance));
  EXPECT_EQ(files.at(0).second.find("GP2"), std::string::npos);
  EXPECT_EQ(files.at(0).second.find("COORD"), std::string::npos);
  EXPECT_EQ(firstLineWith(files.at(0).second, "DEFAULT_GROUP"), "DEFAULT_GROUP\t= 1,*,*,*,*;");
}

TEST(Fanuc, WritesLinearAxesInMillimetres) {
  auto program = wcam::testing::sampleProgram({.layers = 1, .positionerJoints = 1});
  program.cell.linearJoint.back() = true;
  for (auto& instruction : program.instructions) {
    if (auto* move = std::get_if<program::MoveLinear>(&instruction.action)) {
      move->target.joints[6] = 1234.5678;
    }
  }
  const std::string text = runPost("wcam.post.fanuc", program).at(0).second;
  EXPECT_NE(text.find("J1=  1234.5678  mm"), std::string::npos);
}

TEST(Fanuc, PartCarriedUsesTheRemoteToolPoint) {
  auto program = wcam::testing::sampleProgram({.positionerJoints = 0});
  program.cell.partCarried = true;
  const std::string text = runPost("wcam.post.fanuc", program).at(0).second;
  EXPECT_NE(text.find("6.0mm/sec CNT100 RTCP"), std::string::npos);
  EXPECT_NE(text.find("UFRAME_NUM=1 "), std::string::npos);
  EXPECT_NE(runPost("wcam.post.fanuc", program, R"({"remote_frame": 7})")
                .at(0)
                .second.find("UF : 7, UT : 1"),
            std::string::npos);
  EXPECT_THROW(runPost("wcam.post.fanuc", program, R"({"remote_frame": 0})"), Error);
  const ReadJob job = readLs({{"SAMPLE.LS", text}});
  EXPECT_EQ(job.problems, std::vector<std::string>{});
  for (const ReadMove& move : job.moves) {
    EXPECT_EQ(move.remote, move.kind == ReadKind::Linear || move.kind == ReadKind::Circular);
  }
}

// A controller cannot set frame 0, and refuses both options together.
TEST(Fanuc, RemoteToolPointExcludesCoordinatedMotion) {
  auto program = wcam::testing::sampleProgram({.positionerJoints = 2});
  program.cell.partCarried = true;
  const std::string text = runPost("wcam.post.fanuc", program).at(0).second;
  EXPECT_NE(text.find(" RTCP"), std::string::npos);
  EXPECT_EQ(text.find(" COORD"), std::string::npos);
}

TEST(Fanuc, BesideATurnBorderAJointMoveTakesJoints) {
  auto program = wcam::testing::sampleProgram();
  auto& first = std::get<program::MoveJoint>(program.instructions[2].action);
  for (const double value : {kPi, -kPi, kPi - 1e-9, -kPi + 1e-9, 3.0 * kPi}) {
    first.target.joints[5] = value;
    const ReadJob job = readLs(runPost("wcam.post.fanuc", program, R"({"mode": "cartesian"})"));
    EXPECT_FALSE(job.moves[0].cartesian) << value;
  }
  first.target.joints[5] = 3.0;
  EXPECT_TRUE(
      readLs(runPost("wcam.post.fanuc", program, R"({"mode": "cartesian"})")).moves[0].cartesian);
}

TEST(Fanuc, AvoidsKeywords) {
  auto program = wcam::testing::sampleProgram();
  for (const char* word : {"end", "WAIT", "signal", "call", "con", "prn", "com1"}) {
    program.name = word;
    const JobContext context;
    const Files files = runPost("wcam.post.fanuc", program, "{}", context);
    EXPECT_TRUE(files.at(0).first.starts_with("P_")) << files.at(0).first;
    EXPECT_EQ(readLs(files).problems, std::vector<std::string>{});
    EXPECT_EQ(context.diagnostics().count("post.name_changed"), 1U) << word;
  }
}

TEST(Fanuc, KeepsBackAProgramThatLosesWireChanges) {
  auto program = wcam::testing::sampleProgram();
  const auto violations = [&](const std::string& params) {
    const JobContext context;
    runPost("wcam.post.fanuc", program, params, context);
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
  EXPECT_EQ(violations(R"({"wire_register": 32})"), 0U);
}

TEST(Fanuc, SaysWhatItWasPlannedWith) {
  auto program = wcam::testing::sampleProgram();
  program.cell.torchName = "Outil_CMT";
  program.cell.T_flange_tcp = Eigen::Translation3d(-86.0, 0.0, 406.0) *
                              Eigen::AngleAxisd(degToRad(-36.0), Eigen::Vector3d::UnitY()) *
                              Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitX());
  program.process = {1.2, 100.0, 5};
  const Files files = runPost("wcam.post.fanuc", program, R"({"max_points": 40})");
  EXPECT_GT(files.size(), 2U);
  for (const auto& [name, text] : files) {
    for (const char* what :
         {"!Cell sample cell", "!Torch Outil_CMT", "!UTOOL[1] X -86.000", "!UTOOL[1] P -36.0000",
          "!Positioner X 0.000", "!Wire 1.20 mm", "!Wire speed 6.000 m/min", "!Job 5"}) {
      EXPECT_NE(text.find(what), std::string::npos) << name << ": " << what;
    }
  }
}

TEST(Fanuc, RefusesASpeedThatWouldBeZero) {
  const auto program = wcam::testing::sampleProgram({.speed = 0.04});
  try {
    runPost("wcam.post.fanuc", program);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::JobFailed);
    EXPECT_NE(error.hint().find("cm/min"), std::string::npos);
  }
  const JobContext context;
  runPost("wcam.post.fanuc", program, R"({"speed_unit": "cm_min"})", context);
  EXPECT_EQ(context.diagnostics().count("post.speed_rounded"), 1U);
}

TEST(Fanuc, RefusesProgramsItCannotPrint) {
  auto program = wcam::testing::sampleProgram();
  program.instructions.clear();
  EXPECT_THROW(runPost("wcam.post.fanuc", program), Error);
  EXPECT_THROW(runPost("wcam.post.fanuc", wcam::testing::sampleProgram(),
                       R"({"cnt": 101, "tool_frame": 0})"),
               Error);
}

TEST(Fanuc, TextHasTheFormOfTheController) {
  const auto program = wcam::testing::sampleProgram({.layers = 1, .pointsPerBead = 2});
  const std::string text =
      runPost("wcam.post.fanuc", program, R"({"mode": "cartesian"})").at(0).second;
  EXPECT_TRUE(text.starts_with("/PROG  SAMPLE\n/ATTR\nOWNER\t\t= MNEDITOR;\n"));
  EXPECT_NE(firstLineWith(text, "L P[2]").find(":L P[2] 50.0mm/sec FINE COORD    ;"),
            std::string::npos);
  EXPECT_EQ(firstLineWith(text, "GP1"), "   GP1:");
  EXPECT_EQ(firstLineWith(text, "CONFIG"), "\tUF : 0, UT : 1,\t\tCONFIG : 'N U T, 0, 0, 1',");
  EXPECT_EQ(firstLineWith(text, "X = "),
            "\tX =   950.000  mm,\tY =     0.000  mm,\tZ =   332.000  mm,");
  EXPECT_TRUE(text.ends_with("};\n/END\n"));
}
