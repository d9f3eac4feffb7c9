// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Parts and cells that cannot be read: the message names the file and the operation, nothing is
// written.
#include "camcli.hpp"
#include "random_source.hpp"
#include <sys/stat.h>

namespace wcam::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

struct PartCase {
  const char* project;
  const char* file;
};

// Names of tests must not hold addresses.
void PrintTo(const PartCase& part, std::ostream* out) {
  *out << part.file;
}

class BadPart : public CamcliTest, public ::testing::WithParamInterface<PartCase> {
protected:
  std::string refusedWith(const std::string& bytes) const {
    const fs::path project = example(GetParam().project);
    writeFileAtomically(project.parent_path() / GetParam().file, bytes);
    const std::string text = refusedRun(project, 3);
    EXPECT_THAT(text,
                AllOf(HasSubstr(GetParam().file), HasSubstr("operation '"), HasSubstr("hint: ")));
    fs::remove_all(project.parent_path());
    return text;
  }

  std::string content() const {
    return readFile(exampleFolder(GetParam().project) / GetParam().file);
  }
};

TEST_P(BadPart, Empty) {
  EXPECT_THAT(refusedWith(""), HasSubstr("empty"));
}

TEST_P(BadPart, Truncated) {
  const std::string good = content();
  for (const std::size_t eighth : {1U, 4U, 7U}) {
    refusedWith(good.substr(0, good.size() * eighth / 8));
  }
}

TEST_P(BadPart, Random) {
  RandomSource random(20260802);
  for (const int size : {10, 84, 5000}) {
    std::string bytes;
    for (int k = 0; k < size; ++k) {
      bytes += static_cast<char>(random.below(256));
    }
    refusedWith(bytes);
  }
}

TEST_P(BadPart, OfAnotherFormat) {
  refusedWith("{\"format\": \"wcam-project\"}\n");
}

INSTANTIATE_TEST_SUITE_P(Formats,
                         BadPart,
                         ::testing::Values(PartCase{"elbow", "elbow.step"},
                                           PartCase{"branches", "branches_70_closed_low_res.stl"}),
                         [](const auto& part) { return std::string(part.param.project); });

class BadPartFile : public CamcliTest {};

TEST_F(BadPartFile, StepWithoutShape) {
  const fs::path project = example("elbow");
  const fs::path part = project.parent_path() / "elbow.step";
  const std::string text = readFile(part);
  writeFileAtomically(part,
                      text.substr(0, text.find("DATA;") + 6) + "ENDSEC;\nEND-ISO-10303-21;\n");
  EXPECT_THAT(refusedRun(project, 3), AllOf(HasSubstr("elbow.step"), HasSubstr("hint: ")));
}

TEST_F(BadPartFile, UnknownFormat) {
  const fs::path project = elbowWith("elbow.step", "elbow.docx");
  writeFileAtomically(project.parent_path() / "elbow.docx", "A letter.");
  EXPECT_THAT(refusedRun(project, 3), AllOf(HasSubstr("elbow.docx"), HasSubstr("STEP")));
}

TEST_F(BadPartFile, PipesAndDevicesAreRefusedAtOnce) {
  const fs::path pipe = folder_ / "pipe.stl";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  ProcessRequest request;
  request.timeout = std::chrono::seconds(20);
  for (const std::string& file :
       {pipe.string(), std::string("/dev/zero"), folder_.path().string()}) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"info", file}, {"check", file}, {"--project", file}}) {
      const ProcessResult result = camcli(arguments, request);
      EXPECT_FALSE(result.timedOut) << file;
      EXPECT_EQ(result.exitCode, 3) << arguments[0] << ": " << result.err;
      EXPECT_THAT(result.err, HasSubstr(file));
    }
  }
  // As the part of a project.
  const fs::path project = elbowWith("elbow.step", "pipe.step");
  ASSERT_EQ(::mkfifo((project.parent_path() / "pipe.step").c_str(), 0600), 0);
  EXPECT_THAT(refusedRun(project, 3), AllOf(HasSubstr("pipe.step"), HasSubstr("pipe")));
}

/// Files with numbers that overflow ended the program as if it had a fault of its own.
TEST_F(BadPartFile, OfTheTrials) {
  const fs::path trials = fs::path(WCAM_TEST_DATA) / "trials";
  for (const char* name : {"exit2_overflow.obj", "exit2.step", "exit2.3mf", "decimal_comma.wsurf",
                           "html_saved_as.stl", "ply_points_scan.ply"}) {
    const ProcessResult result = camcli({"info", trials / name});
    EXPECT_EQ(result.exitCode, 3) << name << ": " << result.err;
    EXPECT_THAT(result.err, AllOf(HasSubstr(name), HasSubstr("hint: ")));
  }
}

TEST_F(BadPartFile, UnknownEdgeNameGivesNearNames) {
  const fs::path project = elbowWith("\"edge\": \"guide\"", "\"edge\": \"gude\"");
  EXPECT_THAT(refusedRun(project, 3, {"--operation", "guide"}), HasSubstr("did you mean 'guide'?"));
}

TEST_F(BadPartFile, CellOfAnotherKind) {
  const fs::path project = elbowWith("wcam:cells/fanuc_arcmate120ic.json", "cell.json");
  const fs::path cell = project.parent_path() / "cell.json";
  for (const char* text :
       {"", "{}", "[1]", "{\"format\": \"wcam-project\", \"format_version\": 1}"}) {
    writeFileAtomically(cell, text);
    EXPECT_THAT(refusedRun(project, 3), HasSubstr("cell.json")) << text;
  }
}

TEST_F(BadPartFile, ProcessFileOfAnotherKind) {
  const fs::path project = elbowWith("\"id\": \"steel\",",
                                     "\"id\": \"steel\",\n      \"file\": {\"path\": \"w.json\"},");
  for (const char* text : {"", "[1]", "{\"params\": {\"wire_diameter\": -1}}", "{\"params\": 3}"}) {
    writeFileAtomically(project.parent_path() / "w.json", text);
    refusedRun(project, 3);
  }
}

}  // namespace
}  // namespace wcam::testing
