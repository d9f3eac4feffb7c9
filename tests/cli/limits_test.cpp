// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What no file may hold, and how much a run may take: refused with place and figure, and soon.
#include "camcli.hpp"
#include "every_strategy.hpp"
#include <sys/stat.h>

namespace wcam::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class Limits : public CamcliTest {
protected:
  /// The project of all strategies with one operation and a change.
  template <class Change>
  fs::path with(const std::string& operation, const Change& change) const {
    const fs::path file = test::writeEveryStrategy(folder_ / "every", {"constant"});
    Value project = parseJson(readFile(file));
    Value::Array kept;
    for (const Value& each : project.at("operations").asArray()) {
      if (each.at("id").asString() == operation) {
        kept.push_back(each);
      }
    }
    project.set("operations", Value(std::move(kept)));
    change(project);
    writeFileAtomically(file, toCanonicalJson(project));
    return file;
  }

  static Value& first(Value& project, const char* list) {
    return project.findMutable(list)->mutableArray().front();
  }
};

TEST_F(Limits, PlatesAndPlacesBeyondAllMeasureAreRefused) {
  const fs::path plate = with("planar-constant", [](Value& project) {
    first(project, "substrates").set("size_mm", Value(Value::Array{1e300, 200.0, 10.0}));
  });
  EXPECT_THAT(refusedRun(plate, 3),
              AllOf(HasSubstr("substrates[0].size_mm[0]: 1e+300 mm"), HasSubstr("1000000 mm")));
  const fs::path place = with("planar-constant", [](Value& project) {
    first(project, "parts")
        .set("placement",
             parseJson(R"({"position_mm": [1e18, 0, 0], "rotation_deg": [0, 1e9, 0]})"));
  });
  EXPECT_THAT(refusedRun(place, 3), AllOf(HasSubstr("parts[0].placement.position_mm[0]"),
                                          HasSubstr("parts[0].placement.rotation_deg[1]")));
}

TEST_F(Limits, TwoEqualPartsInOnePlaceAreRefused) {
  const fs::path project = with("planar-constant", [](Value& tree) {
    Value twin = first(tree, "parts");
    twin.set("id", "twin");
    tree.findMutable("parts")->push(twin);
    first(tree, "operations").findMutable("parts")->push("twin");
  });
  EXPECT_THAT(refusedRun(project, 3), HasSubstr("the parts 'tube' and 'twin' are equal"));
}

TEST_F(Limits, GuidesWithPolesAreRefusedWithTheirPlace) {
  const fs::path project = with("guide-constant", [](Value& tree) {
    tree.set("guides", parseJson(R"json([{"id": "axis", "type": "formula", "x": "0", "y": "0",
                                      "z": "1/(t-5)", "begin": 0, "end": 12}])json"));
    Value& operation = first(tree, "operations");
    operation.set("guide", "axis").set("params", parseJson(R"({"step": 4})"));
  });
  EXPECT_THAT(refusedRun(project, 3),
              AllOf(HasSubstr("guide 'axis'"), HasSubstr("leaves its range at t = 5.0")));
}

TEST_F(Limits, PlotsOfARangeOfOneUnitInTheLastPlaceEnd) {
  const fs::path project = with("planar-constant", [](Value& tree) {
    first(tree, "operations")
        .set("params", parseJson(R"({"step": 1.9999999999999998, "last_layer": "leave"})"));
  });
  const ProcessResult run =
      camcli({"--project", project, "--output", "out", "--report", "page.html"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_LT(fs::file_size(folder_ / "page.html"), 2000000U);
}

TEST_F(Limits, PipesAreNoInputs) {
  const fs::path pipe = folder_ / "pipe.csv";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"--project", pipe},
           {"info", pipe},
           {"check", pipe},
           {"speed", pipe, "--cell", "fanuc_arcmate120ic", "--joints", "0,0,0,0,0,0,0,0"},
           {"check", "/dev/zero"},
           {"info", "/dev/zero"}}) {
    const ProcessResult run = camcli(arguments);
    EXPECT_EQ(run.exitCode, 3) << run.err;
    EXPECT_THAT(run.err, HasSubstr("device or a pipe"));
  }
}

TEST_F(Limits, TheBudgetIsSettableAndRefusesWithItsFigure) {
  const fs::path project = with("planar-constant", [](Value&) {});
  const ProcessResult points =
      camcli({"check", project, "--budget", "points=100", "--budget", "layers=1000"});
  EXPECT_EQ(points.exitCode, 6);
  EXPECT_THAT(points.err, AllOf(HasSubstr("points; the budget is 100"), HasSubstr("points=")));
  const ProcessResult layers = camcli({"check", project, "--budget", "layers=2"});
  EXPECT_EQ(layers.exitCode, 6);
  EXPECT_THAT(layers.err, HasSubstr("layers; the budget is 2"));
  const ProcessResult wrong = camcli({"check", project, "--budget", "pints=2"});
  EXPECT_EQ(wrong.exitCode, 1);
  EXPECT_THAT(wrong.err, HasSubstr("memory_mb"));
}

// Each of them took minutes, and heard no signal meanwhile.
TEST_F(Limits, HugeListsAndObjectsAreReadAtOnce) {
  constexpr int kMany = 200000;
  const fs::path faces = with("planar-constant", [](Value& tree) {
    Value::Array indices;
    for (int i = 0; i < kMany; ++i) {
      indices.emplace_back(i % (kMany - 1));
    }
    first(tree, "parts").set("faces", Value(std::move(indices)));
  });
  EXPECT_THAT(refusedRun(faces, 3), HasSubstr("faces[199999]: stands twice in the list"));
  const fs::path keys = with("planar-constant", [](Value& tree) {
    Value::Object members;
    for (int i = 0; i < kMany; ++i) {
      members.emplace_back("key" + std::to_string(i), Value(i));
    }
    first(tree, "operations").set("params", Value(std::move(members)));
  });
  EXPECT_THAT(refusedRun(keys, 3), HasSubstr("more than 10000 keys"));
}

}  // namespace
}  // namespace wcam::testing
