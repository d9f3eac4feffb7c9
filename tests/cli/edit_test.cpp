// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// `camcli edit`: edits of toolpaths from the command line.
#include "camcli.hpp"

namespace wcam::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class EditVerb : public CamcliTest {
protected:
  void SetUp() override { project_ = example("elbow"); }

  ProcessResult edit(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "edit");
    return camcli(std::move(arguments));
  }

  Value edits() const {
    const Value tree = parseJson(readFile(project_));
    for (const Value& operation : tree.at("operations").asArray()) {
      if (operation.at("id").asString() == "planar" && operation.contains("edits")) {
        return operation.at("edits");
      }
    }
    return Value::array();
  }

  fs::path project_;
};

TEST_F(EditVerb, AddsListsChangesMovesAndRemoves) {
  EXPECT_EQ(edit({"list", project_}).out, "");
  const ProcessResult added =
      edit({"add", project_, "planar", "pause", "--set", "time=0.5min", "--set", "first_layer=-1"});
  EXPECT_EQ(added.exitCode, 0) << added.err;
  EXPECT_THAT(added.err, HasSubstr("Added edit pause of planar, saved "));
  EXPECT_EQ(edit({"add", project_, "planar", "set_speed", "--id", "slow", "--index", "0", "--set",
                  "factor=50%", "--set", "region=sphere", "--set", "centre=1cm, 0, 0", "--disable"})
                .exitCode,
            0);
  EXPECT_EQ(toCompactJson(edits()),
            R"([{"id": "slow", "type": "set_speed", "enabled": false, "params": {"factor": 0.5, )"
            R"("region": "sphere", "centre": [10.0, 0.0, 0.0]}}, )"
            R"({"id": "pause", "type": "pause", "params": {"time": 30.0, "first_layer": -1}}])");
  const ProcessResult list = edit({"list", project_, "planar", "--json"});
  EXPECT_EQ(parseJson(list.out).at("edits").size(), 2U);
  EXPECT_THAT(edit({"list", project_}).out, HasSubstr("planar  slow  set_speed  (disabled)"));
  EXPECT_EQ(edit({"set", project_, "planar", "slow", "--enable", "--set", "factor=0.7", "--set",
                  "centre="})
                .exitCode,
            0);
  EXPECT_EQ(edit({"move", project_, "planar", "slow", "1"}).exitCode, 0);
  EXPECT_EQ(edit({"remove", project_, "planar", "pause"}).exitCode, 0);
  EXPECT_EQ(
      toCompactJson(edits()),
      R"([{"id": "slow", "type": "set_speed", "params": {"factor": 0.7, "region": "sphere"}}])");
  EXPECT_EQ(edit({"add", project_, "planar", "set_speed"}).exitCode, 0);
  EXPECT_EQ(edits().asArray()[1].at("id").asString(), "set_speed");
  EXPECT_EQ(edit({"add", project_, "planar", "set_speed"}).exitCode, 0);
  EXPECT_EQ(edits().asArray()[2].at("id").asString(), "set_speed_2");
}

TEST_F(EditVerb, TheProgramWaitsAndTheTableShowsIt) {
  EXPECT_EQ(edit({"add", project_, "planar", "pause", "--set", "first_layer=3", "--set",
                  "last_layer=3", "--set", "time=41s"})
                .exitCode,
            0);
  const std::vector<std::string> run = {"--project", project_, "--operation", "planar", "--table"};
  ProcessResult result = camcli(run);
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const fs::path out = project_.parent_path() / "elbow-out";
  EXPECT_THAT(readFile(out / "fanuc/PLANAR.LS"), HasSubstr("WAIT  41.00(sec)"));
  const Table with = readTable(out / "planar.csv");
  const double last = with.number(with.rows.size() - 1, "time_s");
  // For this run only: another time, or left out.
  std::vector<std::string> without = run;
  without.insert(without.end(), {"--set", "planar.edits.pause.enabled=false"});
  EXPECT_EQ(camcli(without).exitCode, 0);
  const Table plain = readTable(out / "planar.csv");
  EXPECT_NEAR(last - plain.number(plain.rows.size() - 1, "time_s"), 41.0, 1e-3);
  std::vector<std::string> longer = run;
  longer.insert(longer.end(), {"--set", "planar.edits.pause.time=1min"});
  EXPECT_EQ(camcli(longer).exitCode, 0);
  EXPECT_THAT(readFile(out / "fanuc/PLANAR.LS"), HasSubstr("WAIT  60.00(sec)"));
  EXPECT_EQ(edits().asArray()[0].at("params").at("time").asReal(), 41.0);
}

TEST_F(EditVerb, ApplyTakesTheSameCommands) {
  writeFileAtomically(
      folder_ / "log.jsonl",
      R"({"command": "edit.add", "args": {"operation": "planar", "id": "r", "type": "reverse"}})"
      "\n"
      R"({"command": "edit.set", "args": {"operation": "planar", "id": "r", "enabled": false}})"
      "\n");
  EXPECT_EQ(camcli({"apply", project_, "log.jsonl"}).exitCode, 0);
  EXPECT_EQ(toCompactJson(edits()), R"([{"id": "r", "type": "reverse", "enabled": false}])");
}

TEST_F(EditVerb, TypesAndSchemas) {
  const Value types = parseJson(edit({"types", "--json"}).out).at("types");
  EXPECT_EQ(types.size(), 9U);
  for (const Value& type : types.asArray()) {
    const std::string key = type.at("type").asString();
    EXPECT_THAT(edit({"types"}).out, HasSubstr(key + "  "));
    const ProcessResult schema = camcli({"schema", "edit." + key});
    EXPECT_EQ(schema.exitCode, 0);
    EXPECT_TRUE(parseJson(schema.out).at("properties").contains("first_layer")) << key;
  }
}

TEST_F(EditVerb, RefusesWhatMakesNoSense) {
  const std::string before = readFile(project_);
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& text) {
    const ProcessResult result = edit(arguments);
    EXPECT_EQ(result.exitCode, 1) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, HasSubstr(text));
    EXPECT_EQ(readFile(project_), before);
  };
  refused({}, "edit");
  refused({"add", project_, "plana", "pause"}, "did you mean 'planar'");
  refused({"add", project_, "planar", "pauze"}, "did you mean 'pause'");
  refused({"add", project_, "planar", "pause", "--set", "tim=3"}, "did you mean 'time'");
  refused({"add", project_, "planar", "pause", "--set", "time=3mm"}, "time");
  refused({"add", project_, "planar", "pause", "--set", "time"}, "KEY=VALUE");
  refused({"add", project_, "planar", "pause", "--id", "Not An Id"}, "is no id");
  refused({"add", project_, "planar", "pause", "--index", "3"}, "index");
  refused({"add", project_, "planar", "repeat_layers", "--set", "count=0"}, "count");
  refused({"add", project_, "planar", "reverse", "--set", "first_layer=3", "--set", "last_layer=1"},
          "the range ends before it begins");
  refused({"set", project_, "planar", "slow", "--enable"}, "there is none yet");
  refused({"remove", project_, "planar", "slow"}, "no edit 'slow'");
  refused({"list", project_, "foo"}, "no operation 'foo'");
  EXPECT_EQ(edit({"add", project_, "planar", "pause"}).exitCode, 0);
  const std::string after = readFile(project_);
  EXPECT_EQ(edit({"set", project_, "planar", "pause"}).exitCode, 1);
  EXPECT_EQ(edit({"set", project_, "planar", "pause", "--set", "time=-1"}).exitCode, 1);
  EXPECT_EQ(edit({"add", project_, "planar", "pause", "--id", "pause"}).exitCode, 1);
  EXPECT_EQ(readFile(project_), after);
  EXPECT_EQ(edit({"list", "missing.wcam"}).exitCode, 3);
  const ProcessResult run =
      camcli({"--project", project_, "--check", "--set", "planar.edits.pause.tmie=3"});
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_THAT(run.err, HasSubstr("did you mean 'time'"));
  EXPECT_THAT(camcli({"--project", project_, "--check", "--set", "planar.edits.paus.time=3"}).err,
              HasSubstr("did you mean 'pause'"));
}

}  // namespace
}  // namespace wcam::testing
