// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Outputs that cannot be written: exit code 4, and what was there stays.
#include "camcli.hpp"

namespace wcam::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class Output : public CamcliTest {
protected:
  const fs::path elbow_ = exampleFolder("elbow") / "elbow.wcam";
};

TEST_F(Output, FolderThatCannotBeMade) {
  writeFileAtomically(folder_ / "file", "precious");
  for (const char* folder : {"file", "file/below", "/proc/wcam", "/dev/null/x"}) {
    const ProcessResult result = camcli({"--project", elbow_, "--output", folder});
    EXPECT_EQ(result.exitCode, 4) << folder;
    EXPECT_THAT(result.err, AllOf(HasSubstr(folder), HasSubstr("hint: choose a folder")));
  }
  EXPECT_EQ(readFile(folder_ / "file"), "precious");
}

TEST_F(Output, FolderOfAnOutputThatCannotBeMade) {
  fs::create_directory(folder_ / "out");
  writeFileAtomically(folder_ / "out/fanuc", "precious");
  const ProcessResult result = camcli({"--project", elbow_, "--output", "out"});
  EXPECT_EQ(result.exitCode, 4);
  EXPECT_THAT(result.err, HasSubstr("out/fanuc"));
  EXPECT_EQ(filesBelow(folder_ / "out"), (Files{{"fanuc", "precious"}}));
}

TEST_F(Output, ReportThatCannotBeWritten) {
  const ProcessResult result =
      camcli({"--project", elbow_, "--output", "out", "--report", "/dev/null/r.json"});
  EXPECT_EQ(result.exitCode, 4);
  EXPECT_FALSE(fs::exists(folder_ / "out")) << "the programs were written before it was known";
}

TEST_F(Output, FullDiskWhileExporting) {
  ProcessRequest full;
  full.fileSizeLimit = 4096;
  const ProcessResult result = camcli({"--project", elbow_, "--output", "a/out"}, full);
  EXPECT_EQ(result.exitCode, 4) << result.err;
  EXPECT_THAT(result.err, AllOf(HasSubstr("a/out/fanuc/PLANAR.LS"), HasSubstr("hint: ")));
  EXPECT_FALSE(fs::exists(folder_ / "a")) << "something was left";
}

TEST_F(Output, FullDiskKeepsTheFilesOfTheLastRun) {
  EXPECT_EQ(camcli({"--project", elbow_, "--output", "out"}).exitCode, 0);
  const Files before = filesBelow(folder_ / "out");
  ProcessRequest full;
  full.fileSizeLimit = 4096;
  EXPECT_EQ(camcli({"--project", elbow_, "--output", "out", "--set", "step=4mm"}, full).exitCode,
            4);
  EXPECT_EQ(filesBelow(folder_ / "out"), before);
}

TEST_F(Output, FullDiskWhileSavingKeepsTheProject) {
  const fs::path project = example("elbow");
  const Files before = filesBelow(project.parent_path());
  writeFileAtomically(folder_ / "log.jsonl",
                      R"({"command": "project.rename", "args": {"name": "other"}})");
  ProcessRequest full;
  full.fileSizeLimit = 100;
  const ProcessResult result = camcli({"apply", project, "log.jsonl"}, full);
  EXPECT_EQ(result.exitCode, 4) << result.err;
  EXPECT_THAT(result.err, AllOf(HasSubstr("elbow.wcam: cannot be written"), HasSubstr("hint: ")));
  EXPECT_EQ(filesBelow(project.parent_path()), before);
}

TEST_F(Output, StandardOutputThatCannotBeWritten) {
  ProcessRequest full;
  full.standardOutput = "/dev/full";
  ProcessRequest closed;
  closed.closedStandardOutput = true;
  for (const ProcessRequest& request : {full, closed}) {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"info", elbow_},
                                                      {"--help"},
                                                      {"--version"},
                                                      {"plugins", "list"},
                                                      {"schema", "commands"},
                                                      {"completion", "bash"},
                                                      {"--project", elbow_, "--check", "--json"}}) {
      const ProcessResult result = camcli(arguments, request);
      EXPECT_EQ(result.exitCode, 4) << arguments[0] << result.err;
      EXPECT_THAT(result.err, HasSubstr("standard output cannot be written"));
    }
    // Nothing goes there, so nothing is lost.
    EXPECT_EQ(camcli({"--project", elbow_, "--output", "out"}, request).exitCode, 0);
  }
}

TEST_F(Output, ClosedStandardOutputIsNotReplacedByAFile) {
  ProcessRequest closed;
  closed.closedStandardOutput = true;
  const fs::path project = example("elbow");
  writeFileAtomically(folder_ / "log.jsonl", "");
  const std::string before = readFile(project);
  camcli({"apply", project, "log.jsonl", "--json"}, closed);
  EXPECT_EQ(readFile(project), before);
}

}  // namespace
}  // namespace wcam::testing
