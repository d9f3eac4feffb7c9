// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/testing/sample_program.hpp"

#include "krl_reader.hpp"
#include "post_fixture.hpp"
#include <gtest/gtest.h>

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
                                 R"(, "angle_range": ")" + range + R"("})";
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
  ASSERT_TRUE(sameStructure(job, planned, kAngleTolerance));
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

TEST(Kuka, FirstMoveHasStatusAndTurn) {
  auto program = wcam::testing::sampleProgram();
  auto& first = std::get<program::MoveJoint>(program.instructions[2].action);
  first.target.joints.head(6) << 0.1, -1.5, 1.6, -0.1, 0.5, -0.2;
  ReadJob job = readKrl(runPost("wcam.post.kuka", program));
  EXPECT_EQ(job.moves[0].configuration, "010");
  EXPECT_EQ(job.moves[0].turns, (std::vector<int>{0, 1, 0, 1, 0, 1}));
  first.target.joints[4] = -0.5;
  first.target.configuration = "FDB";
  job = readKrl(runPost("wcam.post.kuka", program));
  EXPECT_EQ(job.moves[0].configuration, "101");
  job = readKrl(runPost("wcam.post.kuka", program, R"({"status": "110"})"));
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
  EXPECT_EQ(runPost("wcam.post.kuka", program).size(), 1U);
  const ReadJob job = readKrl(runPost("wcam.post.kuka", program, R"({"max_points": 5000})"));
  ASSERT_TRUE(sameStructure(job, planned, kAngleTolerance));
  EXPECT_GE(job.programs, 10U);
  for (const auto& [name, count] : job.positions) {
    EXPECT_LE(name.size(), 24U);
    EXPECT_TRUE(count <= 5000U || count == planned.size()) << name;
  }
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
  EXPECT_THROW(runPost("wcam.post.kuka", program), Error);
  EXPECT_NO_THROW(runPost("wcam.post.kuka", program, R"({"mode": "joint"})"));
  program = wcam::testing::sampleProgram({.positionerJoints = 1});
  program.cell.robotJoints = 5;
  program.cell.positionerJoints = 2;
  EXPECT_THROW(runPost("wcam.post.kuka", program), Error);
}
