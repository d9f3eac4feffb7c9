// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Nothing that is read is overwritten, nothing that was written is lost, no two runs are mixed.
#include "wcam/base/sha256.hpp"
#include "wcam/base/version.h"
#include "wcam/project/project_lock.hpp"

#include "camcli.hpp"
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <ctime>
#include <future>
#include <set>

namespace wcam::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Store : public CamcliTest {
protected:
  void SetUp() override { project_ = example("elbow"); }

  std::vector<std::string> run(std::vector<std::string> more = {},
                               const std::string& folder = "out") const {
    std::vector<std::string> arguments = {"--project", project_,   "--operation",
                                          "planar",    "--output", folder};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  /// Expects exit code 4 and that no file of the test's folder changes.
  void refused(const std::vector<std::string>& arguments, const std::string& text) const {
    const Files before = filesBelow(folder_.path());
    const ProcessResult result = camcli(arguments);
    EXPECT_EQ(result.exitCode, 4) << arguments.back() << result.err;
    EXPECT_THAT(result.err, AllOf(HasSubstr(text), HasSubstr("hint: "))) << arguments.back();
    EXPECT_EQ(filesBelow(folder_.path()), before) << arguments.back();
  }

  int checkOutput(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"check", project_, "--output", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return camcli(arguments).exitCode;
  }

  std::size_t editCount() const {
    const Value tree = parseJson(readFile(project_));
    const Value& operation = tree.at("operations").asArray().front();
    return operation.contains("edits") ? operation.at("edits").size() : 0;
  }

  fs::path project_;
};

TEST_F(Store, AReportReplacesNoInputUnderAnyName) {
  const fs::path part = project_.parent_path() / "elbow.step";
  fs::create_symlink(project_, folder_ / "link.json");
  fs::create_hard_link(project_, folder_ / "hard.json");
  fs::create_directory_symlink(project_.parent_path(), folder_ / "other");
  for (const fs::path& name :
       {project_, folder_ / "link.json", folder_ / "hard.json", folder_ / "other/elbow.wcam",
        project_.parent_path() / "../elbow/./elbow.wcam"}) {
    refused(run({"--report", name}), "the report would replace the project");
    refused({"check", project_, "--report", name}, "the report would replace the project");
    refused({"place", "--project", project_, "--operation", "planar", "--map", name},
            "the map would replace the project");
  }
  refused(run({"--report", part}), "the report would replace the file of the part 'elbow'");
}

TEST_F(Store, AReportReplacesNoProgramOfTheSameRun) {
  refused(run({"--report", "out/fanuc/PLANAR.LS"}), "both write PLANAR.LS");
  refused(run({"--report", "out/../out/report.json"}), "both write report.json");
  refused(run({"--table", "--report", "out/planar.csv"}), "both write planar.csv");
}

TEST_F(Store, TwoOutputsWithOneFolderUnderTwoNames) {
  Value tree = parseJson(readFile(project_));
  const Value outputs =
      parseJson(R"([{"id": "a", "post": "wcam.post.fanuc", "folder": "x/y"},)"
                R"( {"id": "b", "post": "wcam.post.fanuc", "folder": "x/./z/../y"}])");
  writeFileAtomically(project_, toCanonicalJson(tree.set("outputs", outputs)));
  refused(run(), "both write PLANAR.LS");
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Store, OutputsLeaveTheFolderOnlyWithASwitch) {
  for (const std::string& outside : {std::string("../beside"), (folder_ / "beside").native()}) {
    Value tree = parseJson(readFile(project_));
    const Value outputs = Value(Value::Array{
        Value::object({{"id", "a"}, {"post", "wcam.post.fanuc"}, {"folder", outside}})});
    writeFileAtomically(project_, toCanonicalJson(tree.set("outputs", outputs)));
    refused(run(), "lies outside of the output folder");
    EXPECT_EQ(camcli(run({"--allow-outside"})).exitCode, 0);
    EXPECT_TRUE(fs::exists(folder_ / "beside/PLANAR.LS"));
    EXPECT_EQ(checkOutput(), 0);
    fs::remove_all(folder_ / "beside");
    fs::remove_all(folder_ / "out");
  }
}

TEST_F(Store, LinksAndReadOnlyFilesInTheOutputFolder) {
  fs::create_directory(folder_ / "out");
  fs::create_directory(folder_ / "elsewhere");
  fs::create_directory_symlink(folder_ / "elsewhere", folder_ / "out/fanuc");
  refused(run(), "links within an output folder are not followed");
  EXPECT_TRUE(fs::is_empty(folder_ / "elsewhere"));
  fs::remove(folder_ / "out/fanuc");
  fs::create_directory(folder_ / "out/fanuc");
  fs::create_symlink(project_, folder_ / "out/fanuc/PLANAR.LS");
  refused(run(), "the output 'fanuc' for 'planar' would replace the project");
  fs::remove(folder_ / "out/fanuc/PLANAR.LS");
  EXPECT_EQ(camcli(run()).exitCode, 0);
  fs::permissions(folder_ / "out/fanuc/PLANAR.LS", fs::perms::owner_read);
  refused(run({"--set", "step=4mm"}), "is read-only and is not replaced");
  fs::permissions(project_, fs::perms::owner_read);
  refused({"edit", "add", project_, "planar", "pause"}, "is read-only and is not replaced");
}

TEST_F(Store, ResultsGoToPipesDevicesAndStandardOutputInPlace) {
  const ProcessResult printed = camcli(run({"--report", "-", "--quiet"}));
  EXPECT_EQ(printed.exitCode, 0);
  EXPECT_EQ(printed.out, readFile(folder_ / "out/report.json"));
  EXPECT_FALSE(fs::exists(folder_ / "-"));
  EXPECT_EQ(camcli(run({"--report", "-", "--json"})).exitCode, 1);
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ::fcntl(reader, F_SETPIPE_SZ, 1 << 20);
  EXPECT_EQ(camcli(run({"--report", pipe})).exitCode, 0);
  std::string got(1 << 20, '\0');
  const ssize_t size = ::read(reader, got.data(), got.size());
  ::close(reader);
  ASSERT_GT(size, 0);
  got.resize(static_cast<std::size_t>(size));
  EXPECT_EQ(got, readFile(folder_ / "out/report.json"));
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(camcli(run({"--report", "/dev/null"})).exitCode, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Store, TheReportSaysWhatTheProgramsAreMadeFrom) {
  ASSERT_EQ(camcli(run({"--table", "--set", "step=4mm"})).exitCode, 0);
  const Value report = parseJson(readFile(folder_ / "out/report.json"));
  ASSERT_EQ(report.at("files").size(), 2U);
  for (const Value& file : report.at("files").asArray()) {
    EXPECT_EQ(file.at("sha256").asString(),
              sha256OfFile(folder_ / ("out/" + file.at("path").asString())));
  }
  const Value& made = report.at("provenance");
  EXPECT_EQ(made.at("wcam").asString(), WCAM_VERSION);
  EXPECT_EQ(toCompactJson(made.at("settings")), R"(["step=4mm"])");
  EXPECT_EQ(made.at("project").at("file").asString(), "elbow.wcam");
  std::map<std::string, std::string> inputs;
  for (const Value& input : made.at("inputs").asArray()) {
    inputs[input.at("path").asString()] = input.at("sha256").asString();
  }
  EXPECT_EQ(inputs.at("elbow.step"), sha256OfFile(project_.parent_path() / "elbow.step"));
  std::set<std::string> plugins;
  for (const Value& plugin : made.at("plugins").asArray()) {
    plugins.insert(plugin.at("id").asString() + " " + plugin.at("version").asString() + " " +
                   plugin.at("file").asString());
  }
  const std::string version = std::string(" ") + WCAM_VERSION + " ";
  EXPECT_EQ(plugins, (std::set<std::string>{
                         "org.wcam.post.fanuc" + version + "org.wcam.post.fanuc.so",
                         "org.wcam.slicing.planar" + version + "org.wcam.slicing.planar.so"}));
}

TEST_F(Store, CheckTellsWhetherAFolderIsWholeAndOfTheProject) {
  EXPECT_EQ(checkOutput(), 3) << "there is none yet";
  ASSERT_EQ(camcli(run()).exitCode, 0);
  EXPECT_EQ(checkOutput(), 0);
  EXPECT_EQ(camcli({"check", "--output", "out"}).exitCode, 0);
  EXPECT_EQ(checkOutput({"--set", "step=4mm"}), 5);
  writeFileAtomically(folder_ / "out/fanuc/OLD.LS", "an old program");
  EXPECT_THAT(camcli({"check", "--output", "out"}).err, HasSubstr("output.unknown_file"));
  fs::remove(folder_ / "out/fanuc/OLD.LS");
  const std::string program = readFile(folder_ / "out/fanuc/PLANAR.LS");
  writeFileAtomically(folder_ / "out/fanuc/PLANAR.LS", program + "\n");
  EXPECT_THAT(camcli({"check", "--output", "out"}).err, HasSubstr("output.changed"));
  fs::remove(folder_ / "out/fanuc/PLANAR.LS");
  EXPECT_THAT(camcli({"check", "--output", "out"}).err, HasSubstr("output.missing"));
  writeFileAtomically(folder_ / "out/fanuc/PLANAR.LS", program);
  EXPECT_EQ(checkOutput(), 0);
  ASSERT_EQ(camcli({"edit", "add", project_, "planar", "pause"}).exitCode, 0);
  EXPECT_EQ(checkOutput(), 5) << "the project has changed";
  EXPECT_EQ(camcli({"check", "--output", "out"}).exitCode, 0);
}

TEST_F(Store, PairsOfParallelEditsLoseNone) {
  constexpr std::size_t kPairs = 40;
  std::size_t done = 0;
  for (std::size_t i = 0; i < kPairs; ++i) {
    const auto edit = [&] { return camcli({"edit", "add", project_, "planar", "pause"}).exitCode; };
    auto other = std::async(std::launch::async, edit);
    done += edit() == 0 ? 1U : 0U;
    done += other.get() == 0 ? 1U : 0U;
    ASSERT_EQ(editCount(), done) << "pair " << i;
  }
  EXPECT_EQ(done, 2 * kPairs);
  EXPECT_FALSE(fs::exists(project_.parent_path() / ".elbow.wcam.lock"));
}

TEST_F(Store, ParallelLogsLoseNone) {
  std::vector<std::future<int>> runs;
  for (int i = 0; i < 8; ++i) {
    const std::string log = "log" + std::to_string(i) + ".jsonl";
    writeFileAtomically(folder_ / log,
                        R"({"command": "edit.add", "args": {"operation": "planar", "id": "e)" +
                            std::to_string(i) + R"(", "type": "reverse"}})");
    runs.push_back(std::async(std::launch::async, [this, log] {
      return camcli({"apply", project_, log}).exitCode;
    }));
  }
  std::size_t done = 0;
  for (auto& one : runs) {
    done += one.get() == 0 ? 1U : 0U;
  }
  EXPECT_EQ(done, 8U);
  EXPECT_EQ(editCount(), done);
}

TEST_F(Store, WhatAWindowHasOpenIsNotChanged) {
  const fs::path autosave = project_.parent_path() / ".elbow.wcam.autosave";
  writeFileAtomically(autosave, readFile(project_));
  fs::create_symlink(project_, folder_ / "link.wcam");
  writeFileAtomically(folder_ / "log.jsonl", "");
  {
    const auto open = project::ProjectLock::attempt(project_, project::ProjectLock::Use::Open).lock;
    ASSERT_NE(open, nullptr);
    refused({"edit", "add", project_, "planar", "pause"}, "has the project open");
    refused({"edit", "add", "link.wcam", "planar", "pause"}, "has the project open");
    refused({"apply", project_, "log.jsonl"}, "has the project open");
  }
  const ProcessResult result = camcli({"edit", "add", project_, "planar", "pause"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr(".elbow.wcam.autosave holds changes of a window"));
  EXPECT_TRUE(fs::exists(autosave)) << "the autosave is the window's own";
}

TEST_F(Store, ApplyRefusesWhatARunWouldRefuse) {
  const auto command = [](const std::string& key, const std::string& value) {
    return R"({"command": "operation.set_param", "args": {"id": "planar", "section": "params", )"
           R"("key": ")" +
           key + R"(", "value": )" + value + "}}\n";
  };
  const std::string before = readFile(project_);
  for (const std::string& line :
       {command("stpe", "3"), command("step", "-3"),
        std::string(R"({"command": "operation.set", "args": {"id": "planar", )"
                    R"("strategy": "wcam.slicing.plnar"}})")}) {
    writeFileAtomically(folder_ / "log.jsonl", line);
    const ProcessResult result = camcli({"apply", project_, "log.jsonl"});
    EXPECT_EQ(result.exitCode, 3) << line << result.err;
    EXPECT_EQ(readFile(project_), before);
  }
  writeFileAtomically(folder_ / "log.jsonl", command("step", "3"));
  ProcessRequest piped;
  piped.standardInput = folder_ / "log.jsonl";
  EXPECT_EQ(camcli({"apply", project_, "-"}, piped).exitCode, 0);
  EXPECT_NE(readFile(project_), before);
  const fs::path part = project_.parent_path() / "elbow.step";
  const std::string content = readFile(part);
  EXPECT_EQ(camcli({"apply", project_, "log.jsonl", "--output", part}).exitCode, 4);
  EXPECT_EQ(readFile(part), content);
}

TEST_F(Store, NewLeavesNothingBehindWhenItFails) {
  ProcessRequest full;
  full.fileSizeLimit = 600;
  writeFileAtomically(folder_ / "part.stl", std::string(100, ' '));
  const Files before = filesBelow(folder_.path());
  const ProcessResult result = camcli({"new", "deep/down/p.wcam", "--part", "part.stl"}, full);
  EXPECT_EQ(result.exitCode, 4) << result.err;
  EXPECT_EQ(filesBelow(folder_.path()), before);
  EXPECT_FALSE(fs::exists(folder_ / "deep"));
}

TEST_F(Store, NamesDoNotSteerTheTerminal) {
  const ProcessResult result = camcli({"info", "\x1b[31mred\x07\xc2\x9b.step"});
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(result.err, AllOf(HasSubstr("\\x1b[31mred\\x07\\x9b.step"), Not(HasSubstr("\x1b"))));
}

/// Starts camcli, ends it by SIGKILL after a while.
void kill(const std::vector<std::string>& arguments,
          const fs::path& folder,
          const fs::path& watched,
          long delayNs) {
  const pid_t pid = ::fork();
  if (pid == 0) {
    std::vector<char*> argv = {const_cast<char*>(WCAM_CAMCLI)};
    for (const std::string& argument : arguments) {
      argv.push_back(const_cast<char*>(argument.c_str()));
    }
    argv.push_back(nullptr);
    const int quiet = ::open("/dev/null", O_WRONLY);
    ::dup2(quiet, 1);
    ::dup2(quiet, 2);
    if (::chdir(folder.c_str()) == 0) {
      ::execv(argv[0], argv.data());
    }
    ::_exit(99);
  }
  // From when the writing begins.
  int status = 0;
  while (!fs::exists(watched) && ::waitpid(pid, &status, WNOHANG) == 0) {
  }
  const timespec delay{0, delayNs};
  ::nanosleep(&delay, nullptr);
  ::kill(pid, SIGKILL);
  ::waitpid(pid, &status, 0);
}

TEST_F(Store, KillsWhileProgramsAreWrittenLeaveOneSetOrATraceOfIt) {
  const std::vector<std::string> odd = run({"--table", "--set", "step=6mm"});
  const std::vector<std::string> even = run({"--table", "--set", "step=7mm"});
  ASSERT_EQ(camcli(odd).exitCode, 0);
  const Files first = filesBelow(folder_ / "out");
  ASSERT_EQ(camcli(even).exitCode, 0);
  const Files second = filesBelow(folder_ / "out");
  for (int i = 0; i < 40; ++i) {
    kill(i % 2 == 0 ? odd : even, folder_.path(), folder_ / "out/.wcam-new", i * 100000L);
    Files now;
    for (const auto& [path, content] : filesBelow(folder_ / "out")) {
      if (!path.starts_with(".wcam-")) {
        now[path] = content;
      }
    }
    const bool whole = now == first || now == second;
    EXPECT_EQ(camcli({"check", "--output", "out"}).exitCode == 0,
              whole && !fs::exists(folder_ / "out/.wcam-ready"))
        << "kill " << i;
  }
  ASSERT_EQ(camcli(odd).exitCode, 0);
  EXPECT_EQ(filesBelow(folder_ / "out"), first) << "the next run leaves nothing of the killed ones";
}

TEST_F(Store, AnInterruptedSwapIsToldAndFinished) {
  ASSERT_EQ(camcli(run()).exitCode, 0);
  const Files whole = filesBelow(folder_ / "out");
  fs::create_directories(folder_ / "out/.wcam-ready/fanuc");
  fs::rename(folder_ / "out/fanuc/PLANAR.LS", folder_ / "out/.wcam-ready/fanuc/PLANAR.LS");
  EXPECT_THAT(camcli({"check", "--output", "out"}).err, HasSubstr("output.unfinished"));
  ASSERT_EQ(camcli(run()).exitCode, 0);
  EXPECT_EQ(filesBelow(folder_ / "out"), whole);
}

TEST_F(Store, KillsWhileAProjectIsSavedLeaveTheOldOrTheNewOne) {
  const fs::path lock = project_.parent_path() / ".elbow.wcam.lock";
  for (int i = 0; i < 40; ++i) {
    const std::size_t before = editCount();
    fs::remove(lock);
    kill({"edit", "add", project_, "planar", "pause"}, folder_.path(), lock, i * 100000L);
    const std::size_t after = editCount();
    EXPECT_TRUE(after == before || after == before + 1) << "kill " << i;
  }
  EXPECT_EQ(camcli({"edit", "add", project_, "planar", "pause"}).exitCode, 0)
      << "the lock of a program that is gone holds nobody up";
}

}  // namespace
}  // namespace wcam::testing
