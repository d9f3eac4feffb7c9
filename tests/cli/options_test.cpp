// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The options of `camcli --project`, right and wrong.
#include "camcli.hpp"

namespace wcam::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class Options : public CamcliTest {
protected:
  /// Layers of each operation, from the JSON report of a check.
  std::map<std::string, int> layersWith(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"--project", elbow_, "--check", "--json", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = camcli(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    std::map<std::string, int> layers;
    const Value report = parseJson(result.out);
    for (const Value& operation : report.at("operations").asArray()) {
      layers[operation.at("id").asString()] = static_cast<int>(operation.at("layers").asInteger());
    }
    return layers;
  }

  std::string refused(const std::vector<std::string>& more, int exitCode = 1) const {
    return refusedRun(elbow_, exitCode, more);
  }

  const fs::path elbow_ = exampleFolder("elbow") / "elbow.wcam";
};

using Layers = std::map<std::string, int>;

TEST_F(Options, SetChangesAllOperationsOrOne) {
  EXPECT_EQ(layersWith({}), (Layers{{"planar", 12}, {"guide", 16}}));
  EXPECT_EQ(layersWith({"--set", "step=10mm"}), (Layers{{"planar", 6}, {"guide", 8}}));
  EXPECT_EQ(layersWith({"--set", "planar.step=1cm"}), (Layers{{"planar", 6}, {"guide", 16}}));
  EXPECT_EQ(layersWith({"--set", "planar.params.step=10"}), (Layers{{"planar", 6}, {"guide", 16}}));
  EXPECT_EQ(layersWith({"--set", "step=10mm", "--set", "guide.step=5mm"}),
            (Layers{{"planar", 6}, {"guide", 16}}));
  EXPECT_EQ(layersWith({"--set", "guide.enabled=false"}), (Layers{{"planar", 12}}));
}

TEST_F(Options, SetRefusesUnknownKeysWithANearName) {
  const std::string text = refused({"--set", "stepp=4mm"});
  EXPECT_THAT(text, HasSubstr("'stepp'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'step'"));
  EXPECT_THAT(refused({"--set", "planar.stpe=4mm"}), HasSubstr("planar.step"));
  EXPECT_THAT(refused({"--set", "nonsense"}), HasSubstr("KEY=VALUE"));
}

TEST_F(Options, SetTellsAllWrongValuesAtOnce) {
  EXPECT_THAT(refused({"--set", "step=-3mm"}), HasSubstr("below the minimum"));
  const std::string text =
      refused({"--set", "planar.step=0", "--set", "guide.step=many", "--set", "foo=1"});
  EXPECT_THAT(text, HasSubstr("3 problems"));
  EXPECT_THAT(text, HasSubstr("operations.planar.params.step"));
  EXPECT_THAT(text, HasSubstr("operations.guide.params.step"));
  EXPECT_THAT(text, HasSubstr("'foo'"));
}

TEST_F(Options, SetLeavesTheFileAlone) {
  const fs::path project = example("elbow");
  const std::string before = readFile(project);
  EXPECT_EQ(camcli({"--project", project, "--set", "step=10mm", "--quiet"}).exitCode, 0);
  EXPECT_EQ(readFile(project), before);
}

TEST_F(Options, PostAndOperationSelect) {
  EXPECT_EQ(
      camcli({"--project", elbow_, "--output", "a", "--operation", "guide", "--post", "fanuc"})
          .exitCode,
      0);
  EXPECT_EQ(filesBelow(folder_ / "a").size(), 2U);
  EXPECT_TRUE(fs::exists(folder_ / "a/fanuc/GUIDE.LS"));
  // By the id of the post-processor, and one that the project does not store; named twice is once.
  EXPECT_EQ(
      camcli({"--project", elbow_, "--output", "b", "--operation", "guide", "--operation", "guide",
              "--post", "wcam.post.fanuc", "--post", "fanuc", "--post", "example.post.csv"})
          .exitCode,
      0);
  EXPECT_TRUE(fs::exists(folder_ / "b/fanuc/GUIDE.LS"));
  EXPECT_TRUE(fs::exists(folder_ / "b/guide.csv"));
  EXPECT_EQ(filesBelow(folder_ / "b").size(), 3U);
}

// The cell's controller is FANUC's.
TEST_F(Options, PostOfAnotherMakeIsWarned) {
  const ProcessResult result = camcli(
      {"--project", elbow_, "--output", "a", "--operation", "guide", "--post", "wcam.post.kuka"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.err,
              HasSubstr("warning post.other_controller [guide]: output 'wcam.post.kuka': the "
                        "controller of the "
                        "cell is FANUC, the program is written for KUKA"));
  EXPECT_TRUE(fs::exists(folder_ / "a/GUIDE.src"));
}

TEST_F(Options, UnknownPostAndOperation) {
  EXPECT_THAT(refused({"--operation", "plana"}), HasSubstr("did you mean 'planar'?"));
  EXPECT_THAT(refused({"--operation", "other"}), HasSubstr("planar, guide"));
  EXPECT_THAT(refused({"--post", "fanuk"}, 7), HasSubstr("did you mean 'fanuc'?"));
  EXPECT_THAT(refused({"--post", "com.acme.unheard"}, 7), HasSubstr("wcam.post.fanuc"));
}

TEST_F(Options, TwoFilesOfOneNameAreAConflict) {
  // The example post writes planar.csv where the table goes.
  const std::string text = refused({"--post", "example.post.csv"}, 4);
  EXPECT_THAT(text, HasSubstr("both write planar.csv"));
}

TEST_F(Options, TableOnlyWhenAskedFor) {
  EXPECT_EQ(camcli({"--project", elbow_, "--output", "plain"}).exitCode, 0);
  EXPECT_FALSE(fs::exists(folder_ / "plain/planar.csv"));
}

TEST_F(Options, ReportForPeopleListsTheEdits) {
  const std::string project = example("elbow");
  const auto edit = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"edit", "add", project, "planar"});
    EXPECT_EQ(camcli(arguments).exitCode, 0);
  };
  edit({"pause", "--set", "time=30", "--set", "first_layer=3", "--set", "last_layer=-1"});
  edit({"set_speed", "--id", "slow", "--set", "region=sphere", "--set", "centre=1, 0, 2",
        "--disable"});
  ASSERT_EQ(camcli({"--project", project, "--output", "out", "--report", "edits.html"}).exitCode,
            0);
  const std::string page = readFile(folder_ / "edits.html");
  // Layers count from 1, as in the findings.
  EXPECT_THAT(page, HasSubstr("<tr><td>pause</td><td>Pause</td><td>First layer: 4<br>Last layer: "
                              "-1<br>Time: 30 s</td><td></td></tr>"));
  EXPECT_THAT(page, HasSubstr("<tr><td>slow</td><td>Change the travel speed</td><td>"
                              "Region: Inside a sphere<br>Centre: 1, 0, 2 mm</td>"
                              "<td>left out</td></tr>"));
  const std::size_t first = page.find("<h3>Edits of the toolpath</h3>");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(page.find("<h3>Edits of the toolpath</h3>", first + 1), std::string::npos)
      << "an operation without edits has no table";
}

TEST_F(Options, ReportForPeopleIsOnePage) {
  const ProcessResult result =
      camcli({"--project", elbow_, "--output", "out", "--report", "pages/elbow.html"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const std::string page = readFile(folder_ / "pages/elbow.html");
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0U);
  for (const char* part : {"<svg", "Layer height along the path", "Travel speed", "Joints",
                           "Findings", "Parameters", "GUIDE.LS"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  // Nothing is fetched from elsewhere, and nothing in it depends on the moment.
  for (const char* part : {"http-equiv", "<script", "<link", "src=", "url(", "nan", "inf\""}) {
    EXPECT_EQ(page.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(camcli({"check", elbow_, "--report", "again.html"}).exitCode, 0);
  EXPECT_EQ(
      camcli({"--project", elbow_, "--output", "out", "--report", "same.html", "--threads", "1"})
          .exitCode,
      0);
  EXPECT_EQ(readFile(folder_ / "same.html"), page);
}

TEST_F(Options, ReportFileEqualsTheReport) {
  const ProcessResult result =
      camcli({"--project", elbow_, "--output", "out", "--report", "new folder/r.json", "--json"});
  EXPECT_EQ(result.exitCode, 0);
  const std::string report = readFile(folder_ / "out/report.json");
  EXPECT_EQ(readFile(folder_ / "new folder/r.json"), report);
  EXPECT_EQ(result.out, report);
}

TEST_F(Options, JsonIsTheWholeOfStandardOutput) {
  const ProcessResult good = camcli({"--project", elbow_, "--output", "out", "--json"});
  EXPECT_EQ(good.exitCode, 0);
  EXPECT_EQ(parseJson(good.out).at("format").asString(), "wcam-report");
  EXPECT_THAT(good.err, HasSubstr("written to out"));
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"--project", "missing.wcam", "--json"},
        {"--json", "--bogus"},
        {"--json"},
        {"info", "missing.step", "--json"},
        {"--project", elbow_.native(), "--json", "--set", "foo=1"}}) {
    const ProcessResult result = camcli(wrong);
    const Value report = parseJson(result.out);
    const Value& error = report.at("errors").asArray().at(0);
    EXPECT_EQ(error.at("exit_code").asInteger(), result.exitCode);
    EXPECT_THAT(result.err, HasSubstr(error.at("message").asString()));
  }
}

TEST_F(Options, CheckWritesNothing) {
  const fs::path project = example("elbow");
  const Files before = filesBelow(folder_.path());
  const ProcessResult result =
      camcli({"--project", project, "--check", "--output", "out", "--table"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(filesBelow(folder_.path()), before);
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  EXPECT_THAT(result.err, Not(HasSubstr("written")));
}

TEST_F(Options, QuietIsSilentOnSuccessAndTellsErrors) {
  const ProcessResult good = camcli({"--project", elbow_, "--output", "out", "--quiet"});
  EXPECT_EQ(good.exitCode, 0);
  EXPECT_EQ(good.out + good.err, "");
  const ProcessResult bad = camcli({"--project", "missing.wcam", "--quiet"});
  EXPECT_EQ(bad.exitCode, 3);
  EXPECT_THAT(bad.err, HasSubstr("missing.wcam"));
}

TEST_F(Options, TextSaysEachThingOnce) {
  const ProcessResult result = camcli({"--project", elbow_, "--output", "out"});
  std::map<std::string, int> lines;
  std::size_t begin = 0;
  while (begin < result.err.size()) {
    const std::size_t end = result.err.find('\n', begin);
    ++lines[result.err.substr(begin, end - begin)];
    begin = end + 1;
  }
  for (const auto& [line, count] : lines) {
    EXPECT_EQ(count, 1) << line;
  }
  EXPECT_EQ(result.out, "");
}

TEST_F(Options, TellsFilesOfAnEarlierRun) {
  EXPECT_EQ(camcli({"--project", elbow_, "--output", "out", "--table"}).exitCode, 0);
  const ProcessResult result = camcli({"--project", elbow_, "--output", "out"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.err, HasSubstr("perhaps out of date: planar.csv, guide.csv"));
  EXPECT_TRUE(fs::exists(folder_ / "out/planar.csv"));
}

struct Usage {
  const char* name;
  std::vector<std::string> arguments;
  const char* says;
};

// Names of tests must not hold addresses.
void PrintTo(const Usage& usage, std::ostream* out) {
  *out << usage.says;
}

class WrongUsage : public CamcliTest, public ::testing::WithParamInterface<Usage> {};

TEST_P(WrongUsage, IsToldWithTheHelpToLookAt) {
  const ProcessResult result = camcli(GetParam().arguments);
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(result.err.starts_with("camcli: error: ")) << result.err;
  EXPECT_THAT(result.err, HasSubstr(GetParam().says));
  EXPECT_THAT(result.err, HasSubstr("--help"));
}

INSTANTIATE_TEST_SUITE_P(
    All,
    WrongUsage,
    ::testing::Values(Usage{"Nothing", {}, "--project"},
                      Usage{"UnknownOption", {"--projct", "a.wcam"}, "did you mean '--project'?"},
                      Usage{"UnknownVerb", {"chek", "a.wcam"}, "did you mean 'check'?"},
                      Usage{"MissingValue", {"--project"}, "--project"},
                      Usage{"ThreadsNoNumber", {"--project", "a", "--threads", "x"}, "--threads"},
                      Usage{"ThreadsNegative", {"--project", "a", "--threads", "-1"}, "--threads"},
                      Usage{"ThreadsTooMany", {"--project", "a", "--threads", "9999"}, "1024"},
                      Usage{"NewWithoutFile", {"new"}, "file is required"},
                      Usage{"ApplyWithoutLog", {"apply", "a.wcam"}, "commands is required"},
                      Usage{"CheckWithTwo", {"check", "a", "b"}, "'b'"},
                      Usage{"PluginsAlone", {"plugins"}, "list"},
                      Usage{"UnknownShell", {"completion", "fish"}, "fish"}),
    [](const auto& usage) { return std::string(usage.param.name); });

TEST_F(Options, ProjectAndVerbTogetherAreRefused) {
  const ProcessResult result = camcli({"--project", elbow_, "check", elbow_});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("after the verb"));
}

TEST_F(Options, HelpAndVersionGoToStandardOutput) {
  const ProcessResult help = camcli({"--help"});
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_EQ(help.err, "");
  for (const char* word : {"--project", "--output", "--post", "--operation", "--set", "--table",
                           "--report", "--json", "--check", "--threads", "--quiet", "new", "info",
                           "apply", "check", "plugins", "schema", "completion", "130 cancelled"}) {
    EXPECT_THAT(help.out, HasSubstr(word));
  }
  const ProcessResult verb = camcli({"apply", "--help"});
  EXPECT_EQ(verb.exitCode, 0);
  EXPECT_THAT(verb.out, HasSubstr("camcli apply"));
  EXPECT_THAT(verb.out, HasSubstr("COMMANDS.jsonl"));
  EXPECT_THAT(camcli({"plugins", "list", "--help"}).out, HasSubstr("camcli plugins list"));
  const ProcessResult version = camcli({"--version"});
  EXPECT_EQ(version.exitCode, 0);
  EXPECT_THAT(version.out, ::testing::MatchesRegex("camcli [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

/// Every option of the help stands in the user's page and in the man page.
TEST_F(Options, AreDocumented) {
  const std::string page = readFile(fs::path(WCAM_RESOURCES) / "doc/camcli.md");
  const std::string manual =
      replaced(readFile(fs::path(WCAM_RESOURCES).parent_path() / "packaging/camcli.1"), "\\-", "-");
  const std::string help = camcli({"--help"}).out;
  int options = 0;
  for (std::size_t at = help.find("--"); at != std::string::npos; at = help.find("--", at + 2)) {
    const std::size_t end = help.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", at);
    const std::string option = help.substr(at, end - at);
    EXPECT_THAT(manual, HasSubstr(option));
    if (option != "--version") {
      EXPECT_THAT(page, HasSubstr(option));
    }
    ++options;
  }
  EXPECT_GT(options, 12);
}

}  // namespace
}  // namespace wcam::testing
