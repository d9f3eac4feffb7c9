// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What post-processors find reaches terminal, report and JSON; what a report says of times and wire
// is what the program does.

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"

#include "camcli.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace wcam::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

namespace fs = std::filesystem;

class Posts : public CamcliTest {
protected:
  ProcessResult run(const std::vector<std::string>& settings,
                    const std::string& operation = "planar",
                    const std::string& folder = "out") {
    std::vector<std::string> arguments = {
        "--project",   (exampleFolder("elbow") / "elbow.wcam").string(),
        "--operation", operation,
        "--output",    folder,
        "--table",     "--json",
        "--set",       operation + ".motion.mode=constant"};
    for (const std::string& setting : settings) {
      arguments.insert(arguments.end(), {"--set", setting});
    }
    return camcli(arguments);
  }

  static const Value& operationOf(const Value& report) {
    return report.at("operations").asArray().at(0);
  }

  static std::vector<Value> findings(const Value& report, const std::string& code) {
    std::vector<Value> found;
    for (const Value& finding : report.at("diagnostics").asArray()) {
      if (finding.at("code").asString() == code) {
        found.push_back(finding);
      }
    }
    return found;
  }
};

TEST_F(Posts, RoundedSpeedsReachTerminalReportAndJson) {
  const ProcessResult result = run({"fanuc.speed_decimals=0"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, AllOf(HasSubstr("post.speed_rounded"), HasSubstr("output 'fanuc'")));
  const Value report = parseJson(result.out);
  const std::vector<Value> found = findings(report, "post.speed_rounded");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].at("severity").asString(), "warning");
  EXPECT_EQ(found[0].at("place").at("operation").asString(), "planar");
  EXPECT_GT(found[0].at("data").at("error_percent").asReal(), 1.0);
  EXPECT_EQ(operationOf(report).at("diagnostics_by_code").at("post.speed_rounded").asInteger(), 1);
  EXPECT_EQ(findings(parseJson(readFile(folder_ / "out/report.json")), "post.speed_rounded").size(),
            1U);
}

TEST_F(Posts, AViolationKeepsTheProgramBackAndNoOther) {
  const std::vector<std::string> ramp = {"planar.path.ramp_in=20mm",
                                         "planar.path.ramp_in_wire=0.5"};
  const ProcessResult result = run(ramp);
  EXPECT_EQ(result.exitCode, 5);
  EXPECT_THAT(result.err, AllOf(HasSubstr("post.wire_not_written"), HasSubstr("wire_register"),
                                HasSubstr("output 'fanuc' of operation 'planar'")));
  EXPECT_FALSE(fs::exists(folder_ / "out/fanuc/PLANAR.LS"));
  EXPECT_TRUE(fs::exists(folder_ / "out/planar.csv"));
  const Value report = parseJson(result.out);
  ASSERT_EQ(report.at("kept_back").asArray().size(), 1U);
  EXPECT_EQ(report.at("kept_back").asArray()[0].at("output").asString(), "fanuc");
  // Another output of the same operation is written.
  std::vector<std::string> arguments = {
      "--project",   (exampleFolder("elbow") / "elbow.wcam").string(),
      "--operation", "planar",
      "--output",    "both",
      "--post",      "fanuc",
      "--post",      "example.post.csv",
      "--set",       "planar.motion.mode=constant"};
  for (const std::string& setting : ramp) {
    arguments.insert(arguments.end(), {"--set", setting});
  }
  EXPECT_EQ(camcli(arguments).exitCode, 5);
  EXPECT_TRUE(fs::exists(folder_ / "both/planar.csv"));
  EXPECT_FALSE(fs::exists(folder_ / "both/fanuc/PLANAR.LS"));
  // The remedy works.
  std::vector<std::string> written = ramp;
  written.emplace_back("fanuc.wire_register=32");
  EXPECT_EQ(run(written, "planar", "written").exitCode, 0);
  EXPECT_THAT(readFile(folder_ / "written/fanuc/PLANAR.LS"), HasSubstr("R[32]=6.000"));
}

/// Times, wire and mass of the report are those of the program's moves, with the craters.
TEST_F(Posts, OneTruthOfTimesAndWire) {
  // A slow table makes the robot slower than what is commanded.
  const std::vector<std::string> slow = {"guide.motion.tcp_acceleration=5"};
  std::vector<std::string> without = slow;
  without.emplace_back("steel.crater_time=0s");
  std::vector<std::string> with = slow;
  with.emplace_back("steel.crater_time=5s");
  const Value before = parseJson(run(without, "guide", "a").out);
  const Table table = readTable(folder_ / "a/guide.csv");
  const Value after = parseJson(run(with, "guide", "b").out);
  double time = 0.0;
  double commanded = 0.0;
  double wire = 0.0;
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    if (table.number(i, "arc") == 0.0) {
      continue;
    }
    const double step = table.number(i, "time_s") - table.number(i - 1, "time_s");
    const double length = std::hypot(table.number(i, "x_mm") - table.number(i - 1, "x_mm"),
                                     table.number(i, "y_mm") - table.number(i - 1, "y_mm"),
                                     table.number(i, "z_mm") - table.number(i - 1, "z_mm"));
    time += step;
    commanded += length / table.number(i, "speed_mm_s");
    wire += step * table.number(i, "wire_m_min") / 60.0;
  }
  const Value& a = operationOf(before);
  const Value& b = operationOf(after);
  EXPECT_GT(time, 1.01 * commanded);  // the figures could differ
  EXPECT_NEAR(a.at("arc_time_s").asReal(), time, 1e-3);
  EXPECT_NEAR(a.at("wire_length_m").asReal(), wire, 1e-3);
  const double volume = 1000.0 * wire * std::numbers::pi * 0.36;
  EXPECT_NEAR(a.at("deposited_volume_mm3").asReal(), volume, 1e-3 * volume);
  EXPECT_NEAR(a.at("mass_g").asReal(), volume / 1000.0 * 7.85, 1e-3 * volume);
  const double craters = 5.0 * a.at("arc_starts").asReal();
  EXPECT_NEAR(b.at("arc_time_s").asReal() - a.at("arc_time_s").asReal(), craters, 1e-6);
  EXPECT_NEAR(b.at("time_s").asReal() - a.at("time_s").asReal(), craters, 1e-6);
  EXPECT_NEAR(b.at("wire_length_m").asReal(), a.at("wire_length_m").asReal(), 1e-9);
}

TEST_F(Posts, LateralTiltAndNormalsStayOutwards) {
  for (const std::string alternate : {"false", "true"}) {
    const ProcessResult result =
        run({"planar.path.lateral_tilt=10", "planar.path.alternate=" + alternate}, "planar",
            "tilt" + alternate);
    ASSERT_TRUE(fs::exists(folder_ / ("tilt" + alternate) / "planar.csv")) << result.err;
    const Table table = readTable(folder_ / ("tilt" + alternate) / "planar.csv");
    std::size_t checked = 0;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      // The tube's centre line: a circle of 50 mm about (-50, 0, 0) in the plane y = 0.
      const double x = table.number(i, "x_mm");
      const double z = table.number(i, "z_mm");
      const double radius = std::hypot(x + 50.0, z);
      const double outX = x - (-50.0 + 50.0 * (x + 50.0) / radius);
      const double outY = table.number(i, "y_mm");
      const double outZ = z - 50.0 * z / radius;
      EXPECT_GT(outX * table.number(i, "nx") + outY * table.number(i, "ny") +
                    outZ * table.number(i, "nz"),
                0.0)
          << alternate << " row " << i;
      // The layers are level: the axis leans by its level part.
      if (std::hypot(outX, outY) > 5.0) {
        ++checked;
        EXPECT_GT(outX * table.number(i, "ax") + outY * table.number(i, "ay"), 0.0)
            << alternate << " row " << i;
      }
    }
    EXPECT_GT(checked, 100U);
  }
}

TEST_F(Posts, ANewProjectWritesForTheControllerOfItsCell) {
  for (const auto& [cell, post] :
       {std::pair("kuka_kr16_positioner", "wcam.post.kuka"),
        std::pair("fanuc_arcmate120ic", "wcam.post.fanuc"), std::pair("debout_5axis", "")}) {
    const std::string file = std::string(cell) + ".wcam";
    ASSERT_EQ(camcli({"new", file, "--cell", cell}).exitCode, 0);
    const Value project = parseJson(readFile(folder_ / file));
    const auto& outputs = project.at("outputs").asArray();
    ASSERT_EQ(outputs.size(), std::string(post).empty() ? 0U : 1U) << cell;
    EXPECT_TRUE(outputs.empty() || outputs[0].at("post").asString() == post) << cell;
  }
}

TEST_F(Posts, RemediesDoNotRepeatWhatIsSetNorNamePostsThatDoNotExist) {
  const ProcessResult slow = run({"fanuc.speed_decimals=0", "fanuc.speed_unit=cm_min"});
  ASSERT_EQ(slow.exitCode, 0) << slow.err;
  const Value report = parseJson(slow.out);
  const std::vector<Value> rounded = findings(report, "post.speed_rounded");
  ASSERT_FALSE(rounded.empty());
  for (const Value& finding : rounded) {
    EXPECT_EQ(finding.at("remedy").asString().find("speed_unit"), std::string::npos);
  }
  fs::copy(exampleFolder("elbow"), folder_ / "other", fs::copy_options::recursive);
  for (const auto& [cell, advice] :
       {std::pair("yaskawa_ma1440_mt250", "no post-processor that is installed writes for Yaskawa"),
        std::pair("kuka_kr16_positioner", "use wcam.post.kuka")}) {
    const std::string file = "other/elbow.wcam";
    Value project = parseJson(readFile(folder_ / file));
    project.findMutable("cell")->set("path", std::string("wcam:cells/") + cell + ".json");
    project.findMutable("cell")->set("sha256", "");
    writeFileAtomically(folder_ / file, toCanonicalJson(project));
    const ProcessResult result = camcli({"--project", file, "--operation", "planar", "--check",
                                         "--json", "--set", "planar.motion.mode=optimized"});
    const Value own = parseJson(result.out);
    const std::vector<Value> other = findings(own, "post.other_controller");
    ASSERT_FALSE(other.empty()) << cell << result.err;
    EXPECT_THAT(other[0].at("remedy").asString(), HasSubstr(advice));
  }
}

TEST_F(Posts, TwoOperationsWithOneProgramNameGetAHintThatCanBeFollowed) {
  fs::copy(exampleFolder("hemisphere"), folder_ / "twins", fs::copy_options::recursive);
  const std::string file = "twins/hemisphere.wcam";
  Value project = parseJson(readFile(folder_ / file));
  Value first = project.at("operations").asArray()[0];
  first.set("id", "dome-1");
  Value second = first;
  second.set("id", "dome_1");
  project.set("operations", Value(Value::Array{first, second}));
  for (Value& output : project.findMutable("outputs")->mutableArray()) {
    output.remove("operations");
  }
  writeFileAtomically(folder_ / file, toCanonicalJson(project));
  const ProcessResult refused = camcli({"--project", file, "--check"});
  EXPECT_EQ(refused.exitCode, 4) << refused.err;
  EXPECT_THAT(refused.err, AllOf(HasSubstr("dome-1"), HasSubstr("dome_1"), HasSubstr("rename")));
  // The hint is followed.
  second.set("id", "dome_2");
  project.set("operations", Value(Value::Array{first, second}));
  writeFileAtomically(folder_ / file, toCanonicalJson(project));
  EXPECT_EQ(camcli({"--project", file, "--check"}).exitCode, 0);
}

TEST_F(Posts, TheReportTellsWhatIsKeptBackAndWhy) {
  const ProcessResult kept =
      camcli({"--project", (exampleFolder("elbow") / "elbow.wcam").string(), "--operation",
              "planar", "--output", "kept", "--report", "kept.html", "--set",
              "planar.motion.mode=constant", "--set", "planar.motion.cable_limit=1"});
  EXPECT_EQ(kept.exitCode, 5) << kept.err;
  const std::string page = readFile(folder_ / "kept.html");
  EXPECT_THAT(page, AllOf(HasSubstr("Kept back"), HasSubstr("motion.cable_twist"),
                          HasSubstr("all outputs")));
  const ProcessResult good = camcli({"--project", (exampleFolder("elbow") / "elbow.wcam").string(),
                                     "--operation", "planar", "--output", "good", "--report",
                                     "good.html", "--set", "planar.motion.mode=constant"});
  EXPECT_EQ(good.exitCode, 0) << good.err;
  const std::string fine = readFile(folder_ / "good.html");
  EXPECT_EQ(fine.find("Kept back"), std::string::npos);
  EXPECT_THAT(fine, HasSubstr(".LS"));
}

TEST_F(Posts, ExamplesWriteForTheRobotThatTheyUse) {
  for (const char* name : {"elbow", "hemisphere", "supportless", "branches"}) {
    const Value project = parseJson(readFile(exampleFolder(name) / (std::string(name) + ".wcam")));
    EXPECT_THAT(project.at("cell").at("path").asString(), HasSubstr("fanuc"));
    for (const Value& output : project.at("outputs").asArray()) {
      EXPECT_EQ(output.at("post").asString(), "wcam.post.fanuc") << name;
    }
  }
}

}  // namespace
}  // namespace wcam::testing
