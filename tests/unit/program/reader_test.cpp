// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The readers themselves: what they must catch, on texts that are damaged by hand.
#include "wcam/testing/sample_program.hpp"

#include "krl_reader.hpp"
#include "ls_reader.hpp"
#include "post_fixture.hpp"
#include <gtest/gtest.h>

#include <clocale>

using namespace wcam;
using namespace wcam::test;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

const std::string& lsText() {
  static const std::string kText =
      runPost("wcam.post.fanuc", wcam::testing::sampleProgram(), R"({"mode": "cartesian"})")
          .at(0)
          .second;
  return kText;
}

const std::string& krlText() {
  static const std::string kText = [] {
    program::Program sample = wcam::testing::sampleProgram();
    for (program::Instruction& instruction : sample.instructions) {
      if (auto* move = std::get_if<program::MoveJoint>(&instruction.action)) {
        move->target.joints[0] = 0.1;  // at 0 it would be written as axis values
      }
    }
    return runPost("wcam.post.kuka", sample, R"({"ptp_positions": "cartesian"})").at(0).second;
  }();
  return kText;
}

}  // namespace

TEST(LsReader, CatchesDamage) {
  EXPECT_TRUE(readLs({{"SAMPLE.LS", lsText()}}).problems.empty());
  const std::pair<const char*, const char*> cases[] = {
      {"   4:", "   5:"},
      {"P[2]{", "P[3]{"},
      {"J P[1] 20%", "J P[1] 0%"},
      {"50.0mm/sec", "0.0mm/sec"},
      {"50.0mm/sec", "mm/sec"},
      {"FINE COORD", "CNT101 COORD"},
      {"L P[2]", "L P[999]"},
      {"'N U T, ", "'N U, "},
      {"deg\n", "dg\n"},
      {"DEFAULT_GROUP\t= 1,1", "DEFAULT_GROUP\t= 1,*"},
      {"/END\n", ""},
      {"Arc Start[3]", "Arc End[3]"},
      {"UT : 1", "UT : 2"},
      {"LINE_COUNT\t= ", "LINE_COUNT\t= 1"},
      {"    ;\n", "    \n"},
      {"/PROG  SAMPLE", "/PROG  sample"}};
  for (const auto& [from, to] : cases) {
    EXPECT_FALSE(readLs({{"SAMPLE.LS", replaced(lsText(), from, to)}}).problems.empty())
        << from << " -> " << to;
  }
}

TEST(KrlReader, CatchesDamage) {
  EXPECT_TRUE(readKrl({{"SAMPLE.src", krlText()}}).problems.empty());
  const std::pair<const char*, const char*> cases[] = {
      {"$VEL.CP = 0.05000", "$VEL.CP"},
      {"$VEL.CP = 0.05000", "$VEL.CP ="},
      {"$VEL.CP = 0.05000", "$VEL.CP = 50"},
      {"WAIT SEC 0.500", "WAIT SEC"},
      {",S 'B", ",Q 'B"},
      {",Y ", " Y "},
      {"X 50.000", "X 50,000"},
      {",E1 ", ",E3 "},
      {"$OUT[1] = TRUE", "$OUT[1] = FALSE"},
      {"END\n", "\n"},
      {"BAS (#INITMOV,0 )\n", ""},
      {"$TOOL = TOOL_DATA[1]", "$TOOL ="},
      {"$TOOL = TOOL_DATA[1]", "$TOOL = TOOL_DATA[2]"},
      {"$IPO_MODE = #BASE\n", ""},
      {"DEF SAMPLE", "DEF A_NAME_OF_MORE_THAN_24_CHARACTERS"},
      {"} C_DIS", "} C_DISS"}};
  for (const auto& [from, to] : cases) {
    EXPECT_FALSE(readKrl({{"SAMPLE.src", replaced(krlText(), from, to)}}).problems.empty())
        << from << " -> " << to;
  }
}

TEST(LsReader, ReadsTheFormOfAController) {
  // As a controller exports it: own attributes, two groups, coordinated motion.
  const std::string text =
      "/PROG  TEST_1\n/ATTR\nOWNER\t\t= MNEDITOR;\nCOMMENT\t\t= \"\";\nPROG_SIZE\t= 586;\n"
      "LINE_COUNT\t= 3;\nDEFAULT_GROUP\t= 1,1,*,*,*;\nCONTROL_CODE\t= 00000000 00000000;\n/MN\n"
      "   1:  UFRAME_NUM=1 ;\n   2:  UTOOL_NUM=2 ;\n   3:L P[1] 100mm/sec FINE COORD    "
      ";\n/POS\nP[1]{\n   GP1:\n"
      "\tUF : 1, UT : 2,\t\tCONFIG : 'N U T, 0, 0, 0',\n"
      "\tX =   990.695  mm,\tY =   433.558  mm,\tZ =   948.275  mm,\n"
      "\tW =   176.242 deg,\tP =     3.021 deg,\tR =   -35.755 deg\n   GP2:\n\tUF : 0, UT : 1,\t\n"
      "\tJ1=     0.000 deg,\tJ2=    12.500 deg\n};\n/END\n";
  const ReadJob job = readLs({{"TEST_1.LS", text}}, 36, false);
  EXPECT_TRUE(job.problems.empty()) << job.problems.front();
  ASSERT_EQ(job.moves.size(), 1U);
  EXPECT_DOUBLE_EQ(job.moves[0].pose.translation().y(), 433.558);
  EXPECT_EQ(job.moves[0].external, (std::vector<double>{0.0, 12.5}));
  EXPECT_TRUE(job.moves[0].coordinated);
}

TEST(Posts, DoNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const auto program = wcam::testing::sampleProgram();
  const Files fanuc = runPost("wcam.post.fanuc", program);
  const Files kuka = runPost("wcam.post.kuka", program);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
    std::setlocale(LC_ALL, name);
    EXPECT_EQ(runPost("wcam.post.fanuc", program), fanuc);
    EXPECT_EQ(runPost("wcam.post.kuka", program), kuka);
  }
  std::setlocale(LC_ALL, before.c_str());
}
