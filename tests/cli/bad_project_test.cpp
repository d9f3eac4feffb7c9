// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Project files that cannot be used: a clear message, the right exit code, nothing written.
#include "camcli.hpp"
#include "random_source.hpp"

namespace wcam::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class BadProject : public CamcliTest {
protected:
  fs::path projectOf(const std::string& text) const {
    const fs::path project = example("elbow");
    writeFileAtomically(project, text);
    return project;
  }

  const std::string elbow_ = readFile(exampleFolder("elbow") / "elbow.wcam");
};

TEST_F(BadProject, Missing) {
  EXPECT_THAT(refusedRun("missing.wcam", 3),
              AllOf(HasSubstr("missing.wcam: the file does not exist"), HasSubstr("hint: ")));
}

TEST_F(BadProject, Folder) {
  fs::create_directory(folder_ / "folder.wcam");
  EXPECT_THAT(refusedRun("folder.wcam", 3), HasSubstr("folder.wcam: is a folder"));
}

TEST_F(BadProject, Empty) {
  EXPECT_THAT(refusedRun(projectOf(""), 3), HasSubstr("elbow.wcam"));
}

TEST_F(BadProject, TruncatedAnywhere) {
  for (std::size_t part = 1; part < 8; ++part) {
    const fs::path project = projectOf(elbow_.substr(0, elbow_.size() * part / 8));
    EXPECT_THAT(refusedRun(project, 3), HasSubstr("elbow.wcam"));
    fs::remove_all(project.parent_path());
  }
}

TEST_F(BadProject, RandomBytes) {
  RandomSource random(20260801);
  for (int i = 0; i < 10; ++i) {
    std::string bytes;
    for (int k = 0; k < 500; ++k) {
      bytes += static_cast<char>(random.below(256));
    }
    const fs::path project = projectOf(bytes);
    EXPECT_THAT(refusedRun(project, 3), HasSubstr("elbow.wcam"));
    fs::remove_all(project.parent_path());
  }
}

TEST_F(BadProject, JsonOfAnotherKind) {
  for (const char* text : {"{}", "[]", "3", "null", "\"wcam-project\"",
                           R"({"format": "wcam-cell", "format_version": 1})"}) {
    const fs::path project = projectOf(text);
    EXPECT_THAT(refusedRun(project, 3), HasSubstr("no WCAM project")) << text;
    fs::remove_all(project.parent_path());
  }
}

TEST_F(BadProject, DeepNestingDoesNotCrash) {
  EXPECT_THAT(refusedRun(projectOf(std::string(100000, '[')), 3), HasSubstr("elbow.wcam"));
}

TEST_F(BadProject, WrongTypesAndDanglingNamesAreAllTold) {
  std::string text = replaced(elbow_, "\"parts\": [\"elbow\"]", "\"parts\": [\"elbwo\"]");
  text = replaced(text, "\"size_mm\": [250.0, 250.0, 10.0]", "\"size_mm\": \"large\"");
  text = replaced(text, "\"post\": \"wcam.post.fanuc\"", "\"post\": 7");
  EXPECT_THAT(refusedRun(projectOf(text), 3),
              AllOf(HasSubstr("operations[0].parts"), HasSubstr("substrates[0].size_mm"),
                    HasSubstr("outputs[0].post"), HasSubstr("elbow.wcam")));
}

TEST_F(BadProject, ParametersOutOfRangeAreAllTold) {
  std::string text = replaced(elbow_, "\"step\": 5.0", "\"step\": -5.0");
  text = replaced(text, "\"wire_speed\": 6.0", "\"wire_speed\": \"fast\"");
  text = replaced(text, "\"bead_width\": 8.0", "\"bead_width\": 1e9");
  EXPECT_THAT(
      refusedRun(projectOf(text), 3),
      AllOf(HasSubstr("4 problems"), HasSubstr("operations[0].params.step"),
            HasSubstr("operations[1].params.step"), HasSubstr("processes[0].params.wire_speed"),
            HasSubstr("processes[0].params.bead_width")));
}

TEST_F(BadProject, UnknownKeysAreToldAndKept) {
  const fs::path project = projectOf(
      replaced(elbow_, "\"wire_speed\": 6.0", "\"wire_speed\": 6.0,\n        \"wire_sped\": 9.0"));
  const std::string before = readFile(project);
  const ProcessResult result = camcli({"--project", project, "--output", "out"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, AllOf(HasSubstr("project.unknown_parameter"), HasSubstr("wire_sped")));
  writeFileAtomically(folder_ / "log.jsonl",
                      R"({"command": "project.rename", "args": {"name": "other"}})");
  EXPECT_EQ(camcli({"apply", project, "log.jsonl"}).exitCode, 0);
  EXPECT_EQ(readFile(project), replaced(before, "\"name\": \"elbow\"", "\"name\": \"other\""));
}

TEST_F(BadProject, NewerFormatIsLookedAtAndNotUsed) {
  const fs::path project = elbowWith("\"format_version\": 1", "\"format_version\": 7");
  const std::string before = readFile(project);
  const std::string text = refusedRun(project, 3);
  EXPECT_THAT(text, AllOf(HasSubstr("newer version"), HasSubstr("hint: ")));
  EXPECT_EQ(camcli({"check", project}).exitCode, 3);
  writeFileAtomically(folder_ / "log.jsonl",
                      R"({"command": "project.rename", "args": {"name": "other"}})");
  const ProcessResult apply = camcli({"apply", project, "log.jsonl"});
  EXPECT_EQ(apply.exitCode, 3);
  EXPECT_THAT(apply.err, HasSubstr("newer version"));
  writeFileAtomically(folder_ / "empty.jsonl", "");
  EXPECT_EQ(camcli({"apply", project, "empty.jsonl"}).exitCode, 3);
  EXPECT_EQ(readFile(project), before);
  const ProcessResult info = camcli({"info", project});
  EXPECT_EQ(info.exitCode, 0);
  EXPECT_EQ(info.out, before);
}

TEST_F(BadProject, MissingFilesAreAllNamed) {
  const fs::path project = elbowWith("wcam:cells/fanuc_arcmate120ic.json", "cell.json");
  fs::remove(project.parent_path() / "elbow.step");
  EXPECT_THAT(refusedRun(project, 3),
              AllOf(HasSubstr("part 'elbow'"), HasSubstr("elbow.step"), HasSubstr("cell.json"),
                    HasSubstr("put the file there")));
}

TEST_F(BadProject, ChangedHashIsAWarning) {
  const fs::path project = example("elbow");
  const fs::path part = project.parent_path() / "elbow.step";
  writeFileAtomically(part, replaced(readFile(part), "HEADER;", "HEADER; "));
  const ProcessResult result = camcli({"--project", project, "--output", "out"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, AllOf(HasSubstr("warning project.hash_changed"),
                                HasSubstr("part 'elbow'"), HasSubstr("elbow.step")));
  const Value report = parseJson(readFile(folder_ / "out/report.json"));
  EXPECT_EQ(report.at("diagnostics").asArray().at(0).at("code").asString(), "project.hash_changed");
}

TEST_F(BadProject, NothingToDo) {
  const fs::path project = elbowWith("\"strategy\":", "\"enabled\": false,\n      \"strategy\":");
  EXPECT_THAT(refusedRun(project, 3), HasSubstr("no enabled operation"));
}

TEST_F(BadProject, UnreachablePartGetsNoRobotProgram) {
  const fs::path project =
      elbowWith("\"id\": \"elbow\",\n      \"file\"",
                "\"id\": \"elbow\",\n      \"placement\": {\n        \"position_mm\": [3000, 0, 0]"
                "\n      },\n      \"file\"");
  const ProcessResult result = camcli({"--project", project, "--output", "out"});
  EXPECT_EQ(result.exitCode, 5) << result.err;
  EXPECT_THAT(result.err,
              AllOf(HasSubstr("violation motion.unreachable"),
                    ::testing::ContainsRegex("misses up to [0-9]+\\.[0-9] mm"),
                    HasSubstr("move the part"), HasSubstr("operation 'planar' violates checks"),
                    HasSubstr("operation 'guide' violates checks")));
  const Files files = filesBelow(folder_ / "out");
  ASSERT_EQ(files.size(), 1U) << "a robot program was written";
  const Value report = parseJson(files.at("report.json"));
  EXPECT_GT(report.at("operations").asArray()[0].at("unreachable_points").asInteger(), 0);
  const ProcessResult quiet = camcli({"--project", project, "--check", "--quiet"});
  EXPECT_EQ(quiet.exitCode, 5);
  EXPECT_THAT(quiet.err, HasSubstr("misses up to"));
}

TEST_F(BadProject, OneUnreachableOperationDoesNotStopTheOther) {
  const ProcessResult result = camcli({"--project", example("elbow"), "--output", "out", "--set",
                                       "operations.planar.motion.safe_height=3000"});
  EXPECT_EQ(result.exitCode, 5) << result.err;
  const Files files = filesBelow(folder_ / "out");
  EXPECT_TRUE(files.contains("fanuc/GUIDE.LS"));
  EXPECT_FALSE(files.contains("fanuc/PLANAR.LS"));
}

}  // namespace
}  // namespace wcam::testing
