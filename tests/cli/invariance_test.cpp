// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The same project gives the same bytes, whoever runs it, where, when and on how many threads.
#include "camcli.hpp"
#include "every_strategy.hpp"

namespace wcam::testing {
namespace {

namespace fs = std::filesystem;

class Invariance : public CamcliTest {
protected:
  Files exported(const fs::path& project,
                 std::vector<std::string> more = {},
                 ProcessRequest request = {}) const {
    const fs::path out = folder_ / "result";
    fs::remove_all(out);
    std::vector<std::string> arguments = {"--project", project,   "--output",
                                          out,         "--table", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = camcli(arguments, request);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return filesBelow(out);
  }

  const fs::path elbow_ = exampleFolder("elbow") / "elbow.wcam";
};

void expectSame(const Files& a, const Files& b) {
  ASSERT_FALSE(a.empty());
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [name, content] : a) {
    ASSERT_TRUE(b.contains(name)) << name;
    EXPECT_TRUE(b.at(name) == content) << name << " differs";
  }
}

TEST_F(Invariance, Threads) {
  for (const char* name : {"elbow", "branches", "hemisphere", "supportless"}) {
    const fs::path project = exampleFolder(name) / (std::string(name) + ".wcam");
    const Files one = exported(project, {"--threads", "1"});
    expectSame(one, exported(project, {"--threads", "2"}));
    expectSame(one, exported(project, {"--threads", "8"}));
    expectSame(one, exported(project));
  }
}

TEST_F(Invariance, ThreadsOfTheOptimisedMotion) {
  const fs::path project = shippedExample("elbow") / "elbow.wcam";
  expectSame(exported(project, {"--operation", "guide", "--threads", "1"}),
             exported(project, {"--operation", "guide", "--threads", "2"}));
}

/// The C library has other functions for processors without FMA and AVX2.
TEST_F(Invariance, ProcessorsWithoutFusedMultiplyAdd) {
  ProcessRequest older;
  older.environment["GLIBC_TUNABLES"] = "glibc.cpu.hwcaps=-FMA,-AVX2_Usable,-AVX2";
  const fs::path strategies = test::writeEveryStrategy(folder_ / "strategies", {"constant"});
  expectSame(exported(strategies), exported(strategies, {}, older));
  const fs::path modes = test::writeEveryStrategy(
      folder_ / "modes",
      {"optimized", "constant", "point_by_point", "polynomial", "fixed", "constant_tool_axis",
       "fixed_tool_tip", "homogeneous", "planar_vertical"});
  std::vector<std::string> guides = {"--set", "guide-planar_vertical.motion.tilt_tolerance=1deg"};
  for (const char* mode :
       {"optimized", "point_by_point", "polynomial", "fixed", "constant_tool_axis",
        "fixed_tool_tip", "homogeneous", "planar_vertical"}) {
    guides.insert(guides.end(), {"--operation", std::string("guide-") + mode});
  }
  expectSame(exported(modes, guides), exported(modes, guides, older));
}

/// Where two motions are as good, rounding of the part's place does not choose.
TEST_F(Invariance, NoiseOfThePlace) {
  const fs::path project = test::writeEveryStrategy(
      folder_ / "place", {"optimized", "point_by_point", "polynomial", "fixed",
                          "constant_tool_axis", "fixed_tool_tip", "homogeneous"});
  const std::string text = readFile(project);
  std::vector<std::string> operations = {"--set", "motion.min_speed_ratio=0.01"};
  for (const char* mode : {"optimized", "point_by_point", "polynomial", "fixed",
                           "constant_tool_axis", "fixed_tool_tip", "homogeneous"}) {
    operations.insert(operations.end(), {"--operation", std::string("bulk-") + mode});
  }
  const auto tables = [&](const std::string& place) {
    const std::string id = R"("id": "box",)";
    writeFileAtomically(project,
                        replaced(text, id, id + R"("placement": {"position_mm": )" + place + "},"));
    (void)exported(project, operations);
    std::vector<Table> read;
    for (std::size_t i = 3; i < operations.size(); i += 2) {
      read.push_back(readTable(folder_ / "result" / (operations[i] + ".csv")));
    }
    return read;
  };
  const std::vector<Table> still = tables("[0, 0, 0]");
  for (const char* place : {"[1e-9, 0, 0]", "[-1e-9, 1e-9, 0]", "[1e-10, -1e-10, 0]"}) {
    const std::vector<Table> moved = tables(place);
    for (std::size_t t = 0; t < still.size(); ++t) {
      ASSERT_EQ(still[t].rows.size(), moved[t].rows.size()) << operations[2 * t + 3];
      for (std::size_t row = 0; row < still[t].rows.size(); ++row) {
        for (const char* joint :
             {"j1_deg", "j2_deg", "j3_deg", "j4_deg", "j5_deg", "j6_deg", "j7_deg", "j8_deg"}) {
          ASSERT_NEAR(still[t].number(row, joint), moved[t].number(row, joint), 1e-3)
              << operations[2 * t + 3] << " row " << row << " " << joint << " " << place;
        }
      }
    }
  }
}

TEST_F(Invariance, SecondRunIntoTheSameFolder) {
  const Files first = exported(elbow_);
  const ProcessResult again =
      camcli({"--project", elbow_, "--output", "result", "--table", "--quiet"});
  EXPECT_EQ(again.exitCode, 0);
  EXPECT_EQ(again.err, "");
  expectSame(first, filesBelow(folder_ / "result"));
}

TEST_F(Invariance, LocaleAndTimeZone) {
  const Files plain = exported(elbow_);
  ProcessRequest german;
  // Where the locale is missing, the program must not fail either.
  german.environment = {{"LC_ALL", "de_DE.UTF-8"},
                        {"LANG", "de_DE.UTF-8"},
                        {"TZ", "Pacific/Kiritimati"},
                        {"LANGUAGE", "de"}};
  expectSame(plain, exported(elbow_, {}, german));
  ProcessRequest posix;
  posix.environment = {{"LC_ALL", "C"}, {"TZ", "America/New_York"}};
  expectSame(plain, exported(elbow_, {}, posix));
}

TEST_F(Invariance, WorkingDirectory) {
  const Files plain = exported(elbow_);
  ProcessRequest inFolder;
  inFolder.folder = exampleFolder("elbow");
  expectSame(plain, exported("elbow.wcam", {}, inFolder));
  inFolder.folder = "/";
  expectSame(plain, exported(fs::relative(elbow_, "/"), {}, inFolder));
}

TEST_F(Invariance, FolderWithSpacesAndAccents) {
  const Files plain = exported(elbow_);
  const fs::path project = example("elbow", "pièce n° 1 – Übung 日本");
  expectSame(plain, exported(project));
  const ProcessResult result = camcli({"--project", project});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_NE(result.err.find("pièce n° 1 – Übung 日本"), std::string::npos)
      << "the name is not readable: " << result.err;
  EXPECT_TRUE(fs::exists(project.parent_path() / "elbow-out/report.json"));
}

TEST_F(Invariance, UserPluginsAndTheirFolder) {
  const Files plain = exported(elbow_);
  ProcessRequest request;
  request.environment = {{"WCAM_PLUGIN_PATH", WCAM_PROBES}};
  expectSame(plain, exported(elbow_, {"--no-user-plugins"}, request));
  expectSame(plain, exported(elbow_, {}, request));
}

}  // namespace
}  // namespace wcam::testing
