// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Cells that are no arms, from the shell: Debout's Cartesian machines.
#include "camcli.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::testing {
namespace {

using ::testing::HasSubstr;

class Machine : public CamcliTest {
protected:
  std::filesystem::path elbowOn(const std::string& cell) const {
    return elbowWith("fanuc_arcmate120ic.json", cell + ".json");
  }
};

TEST_F(Machine, whatLeansBeyondTheStrokeIsTold) {
  const ProcessResult leaning =
      camcli({"check", elbowOn("debout_5axis").native(), "--operation", "guide"});
  EXPECT_EQ(leaning.exitCode, 5);
  EXPECT_THAT(leaning.err, HasSubstr("joint A exceeds its limit"));
}

TEST_F(Machine, aPostForArmsRefusesThem) {
  const ProcessResult run = camcli({"--project", elbowOn("debout_5axis").native(), "--operation",
                                    "planar", "--post", "wcam.post.kuka", "--output", "out"});
  EXPECT_EQ(run.exitCode, 6);
  EXPECT_THAT(run.err, HasSubstr("the controller of the cell is Siemens"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/PLANAR.src"));
}

/// A generic post writes the program; the table has columns in mm for the linear axes.
TEST_F(Machine, aGenericPostWritesTheProgram) {
  const std::filesystem::path project = elbowOn("debout_5axis");
  writeFileAtomically(project, replaced(readFile(project), "wcam.post.fanuc", "example.post.csv"));
  const ProcessResult run = camcli({"--project", project.native(), "--operation", "planar",
                                    "--post", "fanuc", "--output", "out", "--table"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const Table table = readTable(folder_ / "out/planar.csv");
  EXPECT_THAT(table.header, HasSubstr(",j1_mm,j2_mm,j3_mm,j4_deg,j5_deg"));
  const Table program = readTable(folder_ / "out/fanuc/planar.csv");
  EXPECT_GE(program.rows.size(), table.rows.size());
  // The strokes of the machine, and the height of Z above the plate.
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    ASSERT_GE(table.number(i, "j1_mm"), 0.0);
    ASSERT_LE(table.number(i, "j1_mm"), 8500.0);
    ASSERT_NEAR(table.number(i, "j5_deg"), 0.0, 1e-6);
    ASSERT_NEAR(table.number(i, "j3_mm") - table.number(0, "j3_mm"),
                table.number(i, "z_mm") - table.number(0, "z_mm"), 1e-5);
  }
}

TEST_F(Machine, aPlaceIsSearched) {
  const std::filesystem::path project = elbowOn("debout_5axis");
  const ProcessResult search =
      camcli({"place", "--project", project.native(), "--operation", "planar", "--range", "50",
              "--step", "50", "--turn", "180", "--map", "map.csv", "--json"});
  EXPECT_EQ(search.exitCode, 0) << search.err;
  const Value map = parseJson(search.out);
  const Value& best =
      map.at("places").asArray().at(static_cast<std::size_t>(map.at("best").asInteger()));
  EXPECT_EQ(best.at("failing_points").asReal(), 0.0);
  EXPECT_TRUE(best.at("axis_distance_mm").isNull());
  EXPECT_EQ(best.at("branch").asString().substr(0, 1), "A");
}

}  // namespace
}  // namespace wcam::testing
