// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/text.hpp"

#include "camcli.hpp"

namespace wcam::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class Verbs : public CamcliTest {
protected:
  /// Writes a file into the test's folder. @return its name
  std::string file(const std::string& name, const std::string& content) const {
    writeFileAtomically(folder_ / name, content);
    return name;
  }

  const fs::path part_ = exampleFolder("elbow") / "elbow.step";
};

TEST_F(Verbs, NewMakesAProjectThatRuns) {
  const ProcessResult made = camcli({"new", "a/part one.wcam", "--part", part_});
  EXPECT_EQ(made.exitCode, 0) << made.err;
  EXPECT_EQ(readFile(folder_ / "a/elbow.step"), readFile(part_));
  const ProcessResult run = camcli({"--project", "a/part one.wcam"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.err, Not(HasSubstr("hash_changed")));
  EXPECT_TRUE(fs::exists(folder_ / "a/part one-out/BUILD.LS"));
  EXPECT_EQ(camcli({"check", "a/part one.wcam"}).err.find("not_canonical"), std::string::npos);
  // A second project of the same part beside it.
  EXPECT_EQ(camcli({"new", "a/two.wcam", "--part", part_, "--name", "Zwei"}).exitCode, 0);
  EXPECT_EQ(parseJson(readFile(folder_ / "a/two.wcam")).at("name").asString(), "Zwei");
}

TEST_F(Verbs, NewWithEveryCellOfTheProgram) {
  for (const auto& entry : fs::directory_iterator(fs::path(WCAM_RESOURCES) / "cells")) {
    const std::string cell = entry.path().stem().native();
    const std::string project = cell + ".wcam";
    EXPECT_EQ(camcli({"new", project, "--part", part_, "--cell", cell}).exitCode, 0);
    EXPECT_EQ(camcli({"info", project}).exitCode, 0);
  }
  const fs::path own = fs::path(WCAM_RESOURCES) / "cells/fanuc_arcmate120ic.json";
  EXPECT_EQ(camcli({"new", "own/own.wcam", "--part", part_, "--cell", own}).exitCode, 0);
  EXPECT_TRUE(fs::exists(folder_ / "own/fanuc_arcmate120ic.json"));
  EXPECT_EQ(camcli({"check", "own/own.wcam"}).exitCode, 0);
}

TEST_F(Verbs, NewNeverOverwrites) {
  file("a.wcam", "precious");
  const ProcessResult project = camcli({"new", "a.wcam", "--part", part_});
  EXPECT_EQ(project.exitCode, 4);
  EXPECT_THAT(project.err, HasSubstr("a.wcam: the file exists"));
  file("elbow.step", "another part");
  const ProcessResult part = camcli({"new", "b.wcam", "--part", part_});
  EXPECT_EQ(part.exitCode, 4);
  EXPECT_THAT(part.err, HasSubstr("elbow.step"));
  EXPECT_EQ(filesBelow(folder_.path()),
            (Files{{"a.wcam", "precious"}, {"elbow.step", "another part"}}));
}

TEST_F(Verbs, NewRefusesWhatItCannotUse) {
  EXPECT_THAT(camcli({"new", "b.txt"}).err, HasSubstr("ends in .wcam"));
  EXPECT_EQ(camcli({"new", "b.txt"}).exitCode, 1);
  const ProcessResult part = camcli({"new", "b/b.wcam", "--part", "missing.step"});
  EXPECT_EQ(part.exitCode, 3);
  EXPECT_THAT(part.err, HasSubstr("missing.step"));
  const ProcessResult cell = camcli({"new", "b/b.wcam", "--cell", "foo"});
  EXPECT_EQ(cell.exitCode, 3);
  EXPECT_THAT(cell.err, HasSubstr("fanuc_arcmate120ic, "));
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(Verbs, InfoOfPartCellAndProject) {
  const ProcessResult part = camcli({"info", part_});
  EXPECT_EQ(part.exitCode, 0);
  const Value report = parseJson(part.out);
  EXPECT_EQ(report.at("format").asString(), "STEP");
  EXPECT_EQ(report.at("faces").asInteger(), 1);
  bool guide = false;
  for (const Value& edge : report.at("edge_list").asArray()) {
    guide = guide || edge.at("name").asString() == "guide";
  }
  EXPECT_TRUE(guide);
  const ProcessResult mesh =
      camcli({"info", exampleFolder("branches") / "branches_70_closed_low_res.stl"});
  EXPECT_EQ(mesh.exitCode, 0);
  EXPECT_EQ(parseJson(mesh.out).at("format").asString(), "STL");
  const ProcessResult cell =
      camcli({"info", fs::path(WCAM_RESOURCES) / "cells/fanuc_arcmate120ic.json"});
  EXPECT_EQ(cell.exitCode, 0);
  EXPECT_EQ(parseJson(cell.out).at("joints").asInteger(), 8);
  const fs::path project = exampleFolder("elbow") / "elbow.wcam";
  EXPECT_EQ(camcli({"info", project}).out, readFile(project));
}

TEST_F(Verbs, InfoOfOtherFiles) {
  for (const std::string& name :
       {file("notes.txt", "hello"), file("empty.stl", ""), file("a.json", "[1, 2]"),
        file("b.json", "{\"name\": 1"), file("c.wcam", "{}"), std::string("missing.step"),
        std::string(".")}) {
    const ProcessResult result = camcli({"info", name});
    EXPECT_EQ(result.exitCode, 3) << name << ": " << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, HasSubstr(name));
  }
}

constexpr const char* kRename = R"({"command": "project.rename", "args": {"name": "Krümmer"}})";
constexpr const char* kStep =
    R"({"command": "operation.set_param", "args": {"id": "planar", "section": "params", )"
    R"("key": "step", "value": 4}})";

TEST_F(Verbs, ApplyChangesWhatTheCommandsSayAndNoMore) {
  const fs::path project = example("elbow");
  const std::string before = replaced(readFile(project), "\"name\": \"elbow\",\n",
                                      "\"name\": \"elbow\",\n  \"x_note\": {\n    \"b\": 1.5,\n"
                                      "    \"a\": [true, null]\n  },\n");
  writeFileAtomically(project, before);
  const ProcessResult result = camcli(
      {"apply", project, file("log.jsonl", "# a comment\n\n" + std::string(kRename) + "\n")});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(readFile(project), replaced(before, "\"name\": \"elbow\"", "\"name\": \"Krümmer\""));
  EXPECT_EQ(camcli({"apply", project,
                    file("undo.jsonl", std::string(kStep) + "\n" + R"({"command": "undo"})")})
                .exitCode,
            0);
  EXPECT_EQ(readFile(project), replaced(before, "\"name\": \"elbow\"", "\"name\": \"Krümmer\""));
}

TEST_F(Verbs, ApplyToAnotherFileKeepsTheFirst) {
  const fs::path project = example("elbow");
  const std::string before = readFile(project);
  const ProcessResult result = camcli(
      {"apply", project, file("log.jsonl", kStep), "--output", "elbow/finer.wcam", "--json"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(parseJson(result.out).at("applied").asInteger(), 1);
  EXPECT_EQ(readFile(project), before);
  EXPECT_EQ(camcli({"check", "elbow/finer.wcam"}).exitCode, 0);
  // There it would not find its part.
  EXPECT_EQ(camcli({"apply", project, "log.jsonl", "--output", "finer.wcam"}).exitCode, 1);
  EXPECT_FALSE(fs::exists(folder_ / "finer.wcam"));
}

TEST_F(Verbs, ApplyToABareNameInTheFolderOfTheProject) {
  ASSERT_EQ(camcli({"new", "plain.wcam", "--part", part_}).exitCode, 0);
  const ProcessResult result =
      camcli({"apply", "plain.wcam",
              file("rename.jsonl", R"({"command": "project.rename", "args": {"name": "second"}})"
                                   "\n"),
              "--output", "copy.wcam"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(parseJson(readFile(folder_ / "copy.wcam")).at("name").asString(), "second");
}

TEST_F(Verbs, PartsThatTheRobotCarriesGetAPlateAsThickAsTheHolder) {
  for (const auto& [cell, thickness] :
       {std::pair("fanuc_arcmate120ic_part_carried", 5.0),
        std::pair("kuka_kr16_part_carried", 10.0), std::pair("kuka_kr16", 10.0)}) {
    const std::string project = std::string("plate_") + cell + ".wcam";
    ASSERT_EQ(camcli({"new", project, "--part", part_, "--cell", cell}).exitCode, 0);
    const Value plate = parseJson(readFile(folder_ / project)).at("substrates").asArray()[0];
    EXPECT_EQ(plate.at("size_mm").asArray()[2].asReal(), thickness) << cell;
  }
}

TEST_F(Verbs, WrongWordsGetHintsThatFit) {
  file("-dash.stl", "solid x\nendsolid x\n");
  const ProcessResult dash = camcli({"info", "-dash.stl"});
  EXPECT_EQ(dash.exitCode, 1);
  EXPECT_THAT(dash.err, AllOf(HasSubstr("no option '-dash.stl'"), HasSubstr("./-dash.stl")));
  const ProcessResult schema = camcli({"schema", "nix"});
  EXPECT_EQ(schema.exitCode, 7);
  EXPECT_THAT(schema.err, AllOf(HasSubstr("'nix'"), Not(HasSubstr("post-processor"))));
  for (const char* text : {R"({"format": "wcam-project", "step": 2,5})", R"({"a": NaN})",
                           R"({"a": 1e400})", R"({"a": 1, "a": 2})"}) {
    const ProcessResult json = camcli({"info", file("bad.wcam", text)});
    EXPECT_EQ(json.exitCode, 3) << text;
    EXPECT_THAT(json.err, Not(HasSubstr("must be UTF-8"))) << text;
  }
  EXPECT_THAT(camcli({"info", file("latin.wcam", "{\"a\": \"\xE9t\xE9\"}")}).err,
              HasSubstr("UTF-8"));
}

TEST_F(Verbs, ApplyNamesTheBadLineAndLeavesTheProject) {
  const fs::path project = example("elbow");
  const std::string before = readFile(project);

  for (const std::string line :
       {"{not json", "[1]", R"({"command": "no.such", "args": {}})",
        R"({"command": "operation.remove", "args": {"id": "nobody"}})",
        R"({"command": "part.remove", "args": {"id": "elbow"}})", R"({"command": "redo"})"}) {
    const ProcessResult result = camcli(
        {"apply", project, file("log.jsonl", std::string(kRename) + "\n" + line + "\n" + kStep)});
    EXPECT_EQ(result.exitCode, 3) << line << "\n" << result.err;
    EXPECT_THAT(result.err, HasSubstr("log.jsonl, line 2")) << line;
    EXPECT_EQ(readFile(project), before);
  }
  EXPECT_EQ(camcli({"apply", project, "missing.jsonl"}).exitCode, 3);
}

TEST_F(Verbs, CheckTellsTheFormAndTheFindings) {
  const fs::path project = example("elbow");
  const ProcessResult good = camcli({"check", project});
  EXPECT_EQ(good.exitCode, 0);
  EXPECT_THAT(good.err, Not(HasSubstr("not_canonical")));
  writeFileAtomically(project, toCompactJson(parseJson(readFile(project))));
  const ProcessResult compact = camcli({"check", project, "--operation", "guide", "--json"});
  EXPECT_EQ(compact.exitCode, 0);
  EXPECT_THAT(compact.err, HasSubstr("saving would change line 1"));
  EXPECT_EQ(parseJson(compact.out).at("operations").asArray().size(), 1U);
  EXPECT_FALSE(fs::exists(project.parent_path() / "elbow-out"));
}

TEST_F(Verbs, SchemaOfEveryComponentIsJson) {
  const ProcessResult list = camcli({"schema"});
  EXPECT_EQ(list.exitCode, 0);
  std::vector<std::string> names = splitText(list.out, '\n');
  names.pop_back();
  for (const char* name : {"commands", "import", "motion", "path", "process", "wcam.post.fanuc",
                           "wcam.post.kuka", "wcam.slicing.guide", "wcam.slicing.planar"}) {
    EXPECT_THAT(names, ::testing::Contains(name));
  }
  const Value json = parseJson(camcli({"schema", "--json"}).out);
  EXPECT_EQ(json.at("components").asArray().size(), names.size());
  for (const std::string& name : names) {
    const ProcessResult schema = camcli({"schema", name});
    EXPECT_EQ(schema.exitCode, 0) << name << schema.err;
    EXPECT_EQ(schema.err, "");
    const Value tree = parseJson(schema.out);
    if (name != "commands") {
      EXPECT_EQ(tree.at("type").asString(), "object") << name;
      EXPECT_TRUE(tree.at("properties").isObject()) << name;
    }
  }
  const ProcessResult wrong = camcli({"schema", "wcam.slicing.plana"});
  EXPECT_EQ(wrong.exitCode, 7);
  EXPECT_THAT(wrong.err, HasSubstr("wcam.slicing.planar"));
}

class Completion : public Verbs {
protected:
  ProcessResult bash(const std::string& script) const {
    ProcessRequest request;
    request.program = "/bin/bash";
    request.arguments = {"--norc", "-c", script};
    request.folder = folder_.path();
    request.environment["PATH"] =
        fs::path(WCAM_CAMCLI).parent_path().native() + ":" + std::getenv("PATH");
    return runProcess(request);
  }

  std::string completed(const std::string& words, int index) const {
    return bash("source ./script; COMP_WORDS=(" + words + "); COMP_CWORD=" + std::to_string(index) +
                "; _camcli; echo \"${COMPREPLY[*]}\"")
        .out;
  }
};

class CompletionOf : public Completion, public ::testing::WithParamInterface<const char*> {};

TEST_P(CompletionOf, IsAccepted) {
  const ProcessResult script = camcli({"completion", GetParam()});
  EXPECT_EQ(script.exitCode, 0);
  file("script", script.out);
  // zsh runs the same function through bashcompinit.
  const ProcessResult syntax = bash("bash -n ./script");
  EXPECT_EQ(syntax.exitCode, 0) << syntax.err;
  EXPECT_THAT(script.out, HasSubstr("complete -o filenames -F _camcli"));
}

INSTANTIATE_TEST_SUITE_P(Shells, CompletionOf, ::testing::Values("bash", "zsh"));

TEST_F(Completion, GivesVerbsOptionsAndComponents) {
  file("script", camcli({"completion", "bash"}).out);
  EXPECT_THAT(completed("camcli --pro", 1), HasSubstr("--project"));
  EXPECT_EQ(completed("camcli che", 1), "check\n");
  EXPECT_EQ(completed("camcli apply --out", 2), "--output\n");
  EXPECT_THAT(completed("camcli new --", 2), HasSubstr("--part"));
  EXPECT_THAT(completed("camcli new --", 2), Not(HasSubstr("--table")));
  // Each option once, those of the inner verbs with them.
  EXPECT_EQ(completed("camcli edit --ind", 2), "--index\n");
  EXPECT_EQ(completed("camcli edit --qui", 2), "--quiet\n");
  EXPECT_EQ(completed("camcli plugins l", 2), "list\n");
  EXPECT_EQ(completed("camcli completion z", 2), "zsh\n");
  EXPECT_THAT(completed("camcli schema wcam.slicing.", 2), HasSubstr("wcam.slicing.planar"));
  file("some.wcam", "");
  EXPECT_EQ(completed("camcli --project so", 2), "some.wcam\n");
}

TEST_F(Verbs, SpeedFromMotorSpeeds) {
  // Only the table turns: 4 degrees per second at 100 rpm.
  std::string recording = "time_s,S_rpm,L_rpm,U_rpm,R_rpm,B_rpm,T_rpm,E1_rpm,E2_rpm\n";
  for (int i = 0; i < 50; ++i) {
    recording += formatFixed(0.004 * i, 3) + ",0,0,0,0,0,0,0," + (i < 30 ? "100" : "150") + "\n";
  }
  file("rec.csv", recording);
  const std::vector<std::string> run = {
      "speed", "rec.csv", "--cell", "yaskawa_ma1440_mt250", "--joints", "0,0,0,0,-90,0,0,0"};
  const ProcessResult table = camcli(run);
  EXPECT_EQ(table.exitCode, 0) << table.err;
  EXPECT_THAT(table.out, HasSubstr("time_s,j1_deg,j2_deg,j3_deg,j4_deg,j5_deg,j6_deg,j7_deg,j8_deg,"
                                   "x_mm,y_mm,z_mm,vx_mm_s,vy_mm_s,vz_mm_s,speed_mm_s\n"));
  EXPECT_THAT(table.err, HasSubstr("peak at "));
  std::vector<std::string> more = run;
  more.insert(more.end(), {"--json", "--output", "speed.csv", "--tolerance", "0.2"});
  const ProcessResult json = camcli(more);
  EXPECT_EQ(json.exitCode, 0) << json.err;
  const Value summary = parseJson(json.out);
  EXPECT_EQ(summary.at("samples").asInteger(), 50);
  EXPECT_NEAR(summary.at("max_speed_mm_s").asReal() / summary.at("min_speed_mm_s").asReal(), 1.5,
              1e-9);
  ASSERT_EQ(summary.at("events").size(), 1U);
  EXPECT_EQ(summary.at("events").asArray()[0].at("kind").asString(), "peak");
  EXPECT_EQ(readFile(folder_ / "speed.csv"), table.out);
}

TEST_F(Verbs, SpeedTellsWhatIsWrong) {
  file("rec.csv", "time_s,A1_rpm\n0,1\n1,1\n");
  const auto run = [&](const std::string& cell, const std::string& joints) {
    return camcli({"speed", "rec.csv", "--cell", cell, "--joints", joints});
  };
  const ProcessResult columns = run("kuka_kr16", "0,0,0,0,0,0");
  EXPECT_EQ(columns.exitCode, 3);
  EXPECT_THAT(columns.err,
              HasSubstr("the columns A2_rpm, A3_rpm, A4_rpm, A5_rpm, A6_rpm are missing"));
  const ProcessResult count = run("kuka_kr16", "0,0");
  EXPECT_EQ(count.exitCode, 1);
  EXPECT_THAT(count.err, HasSubstr("expected 6 values, got 2"));
  EXPECT_THAT(run("kuka_kr16", "0,0,0,0,x,0").err, HasSubstr("'x' of joint A5 is not a number"));
  file("rec.csv",
       "time_s,A1_rpm,A2_rpm,A3_rpm,A4_rpm,A5_rpm,A6_rpm\n0,1,0,0,0,0,0\n1,1,0,0,0,0,0\n");
  const ProcessResult ratios = run("kuka_kr16", "0,-90,90,0,0,0");
  EXPECT_EQ(ratios.exitCode, 1);
  EXPECT_THAT(ratios.err, HasSubstr("the reduction ratio is unknown of A1, A2, A3, A4, A5, A6"));
  EXPECT_EQ(run("nobody.json", "0").exitCode, 3);
  EXPECT_EQ(camcli({"speed", "rec.csv"}).exitCode, 1);
  const ProcessResult zero = camcli({"speed", "rec.csv", "--cell", "kuka_kr360_platter", "--joints",
                                     "0,0,0,0,0,0,0", "--zero", "fanuc"});
  EXPECT_EQ(zero.exitCode, 1);
  EXPECT_THAT(zero.err, HasSubstr("kuka, script"));
  EXPECT_EQ(camcli({"speed", "rec.csv", "--cell", "kuka_kr16", "--joints", "0,0,0,0,0,0", "--speed",
                    "-3"})
                .exitCode,
            1);
}

}  // namespace
}  // namespace wcam::testing
