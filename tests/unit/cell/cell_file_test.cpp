// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"
#include "wcam/cell/inverse.hpp"
#include "wcam/cell/kinematics.hpp"

#include "cells.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace wcam::cell {
namespace {

using ::testing::HasSubstr;

Value fanucFile() {
  return test::fanuc().source;
}

/// The message of the error that loading gives; empty when it loads.
std::string problemsOf(const Value& file) {
  try {
    cellFromValue(file, "cell test");
    return {};
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ProjectInvalid);
    return error.what();
  }
}

Value* jointOf(Value& file, std::size_t index) {
  return &file.findMutable("robot")->findMutable("joints")->mutableArray()[index];
}

TEST(CellFile, shippedCellsLoad) {
  JobContext context;
  const Cell torch = test::shippedCell("fanuc_arcmate120ic", context);
  EXPECT_EQ(torch.configuration, Configuration::TorchCarried);
  EXPECT_EQ(torch.jointCount(), 8);
  EXPECT_TRUE(torch.arm.has_value());
  EXPECT_TRUE(torch.joint(5).endless);
  EXPECT_TRUE(torch.joint(7).endless);
  EXPECT_NEAR(radToDeg(torch.joint(2).max), 273, 1e-12);
  EXPECT_NEAR(radToDeg(torch.joint(5).maxSpeed), 550, 1e-12);
  const Cell part = test::shippedCell("fanuc_arcmate120ic_part_carried", context);
  EXPECT_TRUE(part.partCarried());
  EXPECT_EQ(part.jointCount(), 6);
  EXPECT_EQ(context.diagnostics().items().size(), 0U);
}

TEST(CellFile, printedAxesAreMadeOrthonormalWithAWarning) {
  // As the article prints them: a sign of z is lost.
  Value file = test::yaskawa().source;
  file.findMutable("positioner")
      ->findMutable("T_table_part")
      ->set("axes", parseJson(R"({"x": [0.99999, -0.00013, 0.00015],
                                  "y": [0.00013, 0.99999, 0.00008],
                                  "z": [-0.00014, 0.00008, 0.99999]})"));
  JobContext context;
  const Cell cell = cellFromValue(file, "printed", context);
  ASSERT_EQ(context.diagnostics().count("cell.frame_not_orthonormal"), 1U);
  const Diagnostic diagnostic = context.diagnostics().items().front();
  EXPECT_EQ(diagnostic.severity, Severity::Warning);
  EXPECT_THAT(diagnostic.message, HasSubstr("positioner.T_table_part.axes"));
  ASSERT_EQ(diagnostic.data.size(), 1U);
  EXPECT_NEAR(diagnostic.data[0].second, 1.6e-4, 2e-6);
  const Eigen::Matrix3d r = cell.T_table_part.linear();
  EXPECT_LE((r.transpose() * r - Eigen::Matrix3d::Identity()).norm(), 1e-14);
}

TEST(CellFile, correctedSignOfTheArticleLeavesRoundingOnly) {
  Value file = test::yaskawa().source;
  file.findMutable("positioner")
      ->findMutable("T_table_part")
      ->set("axes", parseJson(R"({"x": [0.99999, -0.00013, 0.00015],
                                  "y": [0.00013, 0.99999, 0.00008],
                                  "z": [-0.00014, -0.00008, 0.99999]})"));
  JobContext context;
  const Cell fixed = cellFromValue(file, "fixed", context);
  ASSERT_EQ(context.diagnostics().count("cell.frame_not_orthonormal"), 1U);
  EXPECT_LE(context.diagnostics().items()[0].data[0].second, 2.1e-5);
  // Which is what the shipped file holds.
  const Eigen::Matrix3d shipped = test::yaskawa().T_table_part.linear();
  EXPECT_LE((fixed.T_table_part.linear() - shipped).norm(), 1e-12);
}

TEST(CellFile, shippedCellsLoadWithoutAWord) {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(WCAM_RESOURCES) + "/cells")) {
    if (entry.path().extension() == ".json") {
      JobContext context;
      loadCell(entry.path(), context);
      for (const Diagnostic& finding : context.diagnostics().items()) {
        ADD_FAILURE() << entry.path() << ": " << finding.message.str();
      }
    }
  }
}

TEST(CellFile, theCableOfTheTorch) {
  const Cell cell = test::shippedCell("fanuc_arcmate120ic");
  ASSERT_TRUE(cell.cable);
  EXPECT_NEAR(radToDeg(cell.cable->limit), 120.0, 1e-9);  // Chalvin A33
  EXPECT_EQ(cell.cable->zero, 0.0);
  Value file = fanucFile();
  file.findMutable("torch")->set("cable", Value::object({{"limit", -3}}));
  EXPECT_THAT(problemsOf(file), HasSubstr("torch.cable.limit: must be greater than 0"));
  file.findMutable("torch")->remove("cable");
  EXPECT_FALSE(cellFromValue(file, "cell test").cable);
  Value carried = test::shippedCell("fanuc_arcmate120ic_part_carried").source;
  carried.findMutable("torch")->set("cable", Value::object({{"limit", 120}}));
  EXPECT_THAT(problemsOf(carried), HasSubstr("torch.cable: belongs to a torch"));
}

TEST(CellFile, sourceKeepsEverything) {
  Value file = fanucFile();
  file.findMutable("torch")->set("x-neck", Value::object({{"radius", 22}}));
  const Cell cell = cellFromValue(file, "cell test");
  EXPECT_EQ(cell.source, file);
}

TEST(CellFile, allProblemsAtOnceWithTheirPaths) {
  Value file = fanucFile();
  file.set("name", 3);
  file.findMutable("torch")->remove("T_flange_tcp");
  jointOf(file, 0)->set("alpha", "steep");
  jointOf(file, 1)->set("limits", Value(Value::Array{160, -100}));
  jointOf(file, 2)->set("coupling", Value::object({{"J9", -1}}));
  jointOf(file, 3)->set("sign", 2);
  jointOf(file, 4)->remove("max_speed");
  jointOf(file, 5)->set("limits", Value(Value::Array{-1, 1}));
  const std::string text = problemsOf(file);
  for (const char* expected :
       {"name: expected a text, got", "torch.T_flange_tcp: is missing",
        "robot.joints[0].alpha: expected a number, got",
        "robot.joints[1].limits: the minimum must be below the maximum",
        "robot.joints[2].coupling.J9: is not the name of a joint before this one",
        "robot.joints[3].sign: must be 1 or -1", "robot.joints[4].max_speed: is missing",
        "robot.joints[5]: has limits and is endless", "8 problems", "cell test"}) {
    EXPECT_THAT(text, HasSubstr(expected));
  }
}

TEST(CellFile, lengthsAnglesAndRatesBeyondAnyMachineAreTold) {
  Value file = fanucFile();
  jointOf(file, 0)->set("r", 18446744073709551616.0);
  jointOf(file, 1)->set("alpha", 1e9);
  jointOf(file, 2)->set("max_speed", 1e12);
  jointOf(file, 3)->set("max_acceleration", 1e200);
  file.findMutable("torch")
      ->findMutable("T_flange_tcp")
      ->set("xyz", Value(Value::Array{1e12, 0.0, 0.0}));
  const std::string problems = problemsOf(file);
  EXPECT_THAT(problems, HasSubstr("robot.joints[0].r: 18446744073709551616.0 mm is not within"));
  EXPECT_THAT(problems, HasSubstr("robot.joints[1].alpha: 1000000000 deg is not within"));
  EXPECT_THAT(problems, HasSubstr("robot.joints[2].max_speed: 1000000000000 deg/s is not within"));
  EXPECT_THAT(problems, HasSubstr("robot.joints[3].max_acceleration: 1e+200 deg/s2"));
  EXPECT_THAT(problems, HasSubstr("torch.T_flange_tcp.xyz[0]: 1000000000000 mm"));
}

TEST(CellFile, allProblemsOfLinearJointsSumsAndConventions) {
  Value file = test::shippedCell("debout_7axis").source;
  jointOf(file, 0)->set("type", "sliding");
  jointOf(file, 1)->set("endless", true);
  jointOf(file, 1)->remove("limits");
  jointOf(file, 2)->set("limits", Value(Value::Array{2200, 200}));
  jointOf(file, 3)->set("limits", Value(Value::Array{-190}));
  jointOf(file, 4)->set("max_acceleration", -1);
  jointOf(file, 5)->set("backlash", "much");
  file.findMutable("robot")->set("zero_conventions",
                                 Value::object({{"other", Value(Value::Array{1, 2})}}));
  Value sum = Value::object({{"name", ""},
                             {"joints", Value::object({{"X", 1}, {"A", 1}, {"J9", 1}})},
                             {"limits", Value(Value::Array{1, 0})},
                             {"limit", 3}});
  file.set("sum_limits", Value(Value::Array{sum, Value(7)}));
  const std::string text = problemsOf(file);
  for (const char* expected :
       {"robot.joints[0].type: is neither revolute nor prismatic, but 'sliding'",
        "robot.joints[1].endless: a prismatic joint ends somewhere",
        "robot.joints[2].limits: the minimum must be below the maximum",
        "robot.joints[3].limits: expected [min, max] in deg",
        "robot.joints[4].max_acceleration: must be greater than 0",
        "robot.joints[5].backlash: expected a number",
        "robot.zero_conventions.other: expected a list of 6 offsets",
        "sum_limits[0].name: is empty", "sum_limits[0].joints.J9: is not the name of a joint",
        "sum_limits[0].limits: the minimum must be below the maximum",
        "sum_limits[0].limit: is not known here; did you mean 'limits'?",
        "sum_limits[1]: expected an object"}) {
    EXPECT_THAT(text, HasSubstr(expected));
  }
}

TEST(CellFile, everyShippedCellLoadsAndHasAnInverse) {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(WCAM_RESOURCES) + "/cells")) {
    const Cell cell = loadCell(entry.path());
    ASSERT_NE(cell.inverse, nullptr) << entry.path();
    EXPECT_EQ(cell.inverse->joints(), cell.robotJoints());
    EXPECT_NE(cell.inverse->method(), InverseMethod::Numeric) << entry.path();
  }
}

TEST(CellFile, mistypedKeysAreNotTakenForMissingOnes) {
  Value file = fanucFile();
  jointOf(file, 0)->remove("limits");
  jointOf(file, 0)->set("limit", Value(Value::Array{-170, 170}));
  const std::string text = problemsOf(file);
  EXPECT_THAT(text, HasSubstr("robot.joints[0].limit: is not known here; did you mean 'limits'?"));
  EXPECT_THAT(text, HasSubstr("needs \"limits\""));
}

TEST(CellFile, notesAreAllowed) {
  Value file = fanucFile();
  file.set("x-serial", "F-1234");
  file.set("comment", "as measured");
  EXPECT_EQ(problemsOf(file), "");
}

TEST(CellFile, numberOfJoints) {
  Value file = fanucFile();
  file.findMutable("robot")->findMutable("joints")->mutableArray().pop_back();
  EXPECT_EQ(problemsOf(file), "");
  file.findMutable("robot")->findMutable("joints")->mutableArray().pop_back();
  EXPECT_THAT(problemsOf(file), HasSubstr("robot.joints: expected 6 joints (or 5), got 4"));
  file = fanucFile();
  Value::Array& axes = file.findMutable("positioner")->findMutable("joints")->mutableArray();
  axes.push_back(axes[0]);
  const std::string text = problemsOf(file);
  EXPECT_THAT(text, HasSubstr("positioner.joints: expected 0, 1 or 2 joints, got 3"));
  EXPECT_THAT(text, HasSubstr("the joint name 'J7' is used twice"));
}

TEST(CellFile, poses) {
  Value file = fanucFile();
  Value* torch = file.findMutable("torch");
  torch->set("T_flange_tcp", Value::object({{"xyz", Value(Value::Array{1, 2})},
                                            {"wpr", Value(Value::Array{0, 0, 0})},
                                            {"abc", Value(Value::Array{0, 0, 0})}}));
  std::string text = problemsOf(file);
  EXPECT_THAT(text, HasSubstr("torch.T_flange_tcp.xyz: expected a list of 3 numbers"));
  EXPECT_THAT(text, HasSubstr("gives its rotation more than once"));

  const auto axes = [](Value::Array x, Value::Array y, Value::Array z) {
    return Value::object({{"xyz", Value(Value::Array{0, 0, 0})},
                          {"axes", Value::object({{"x", Value(std::move(x))},
                                                  {"y", Value(std::move(y))},
                                                  {"z", Value(std::move(z))}})}});
  };
  torch->set("T_flange_tcp", axes({1, 0, 0}, {0, 1, 0}, {0, 0, -1}));
  EXPECT_THAT(problemsOf(file), HasSubstr("the axes are left-handed"));
  torch->set("T_flange_tcp", axes({1, 0, 0}, {0.5, 1, 0}, {0, 0, 1}));
  EXPECT_THAT(problemsOf(file), HasSubstr("not perpendicular unit vectors"));
  torch->set("T_flange_tcp", axes({0, 0, 0}, {0, 0, 0}, {0, 0, 0}));
  EXPECT_THAT(problemsOf(file), HasSubstr("not perpendicular unit vectors"));
}

TEST(CellFile, matrixAndKukaAngles) {
  Value file = fanucFile();
  Value* torch = file.findMutable("torch");
  Value rows = Value::array();
  rows.push(Value(Value::Array{0, -1, 0, 10}));
  rows.push(Value(Value::Array{1, 0, 0, 20}));
  rows.push(Value(Value::Array{0, 0, 1, 30}));
  rows.push(Value(Value::Array{0, 0, 0, 1}));
  torch->set("T_flange_tcp", Value::object({{"matrix", rows}}));
  const Cell byMatrix = cellFromValue(file, "matrix");
  torch->set("T_flange_tcp", Value::object({{"xyz", Value(Value::Array{10, 20, 30})},
                                            {"abc", Value(Value::Array{90, 0, 0})}}));
  const Cell byAngles = cellFromValue(file, "abc");
  EXPECT_LE(test::poseDifference(byMatrix.T_flange_tcp, byAngles.T_flange_tcp), 1e-12);
  rows.mutableArray()[3] = Value(Value::Array{0, 0, 1, 1});
  torch->set("T_flange_tcp", Value::object({{"matrix", rows}}));
  EXPECT_THAT(problemsOf(file), HasSubstr("the last row 0 0 0 1"));
}

TEST(CellFile, configurationDecidesTheParts) {
  Value file = fanucFile();
  file.set("configuration", "part_carried");
  const std::string text = problemsOf(file);
  EXPECT_THAT(text, HasSubstr("part_holder: is missing"));
  EXPECT_THAT(text, HasSubstr("positioner: does not belong to this configuration"));
  EXPECT_THAT(text, HasSubstr("torch.T_base_tcp: is missing"));
  file.set("configuration", "nobody");
  EXPECT_THAT(problemsOf(file), HasSubstr("neither torch_carried nor part_carried"));
}

TEST(CellFile, versions) {
  Value file = fanucFile();
  file.set("format_version", 99);
  EXPECT_THAT(problemsOf(file), HasSubstr("format version 99"));
  file.set("format_version", "one");
  EXPECT_THAT(problemsOf(file), HasSubstr("format_version: expected the integer 1"));
  EXPECT_THAT(problemsOf(Value(3)), HasSubstr("expected an object"));
  EXPECT_THAT(problemsOf(Value::object()), HasSubstr("format_version"));
}

TEST(CellFile, emptyObjectsTellEverythingThatIsMissing) {
  const std::string text = problemsOf(Value::object({{"format_version", 1}}));
  for (const char* key : {"name", "configuration", "robot", "torch", "positioner"}) {
    EXPECT_THAT(text, HasSubstr(std::string(key) + ": is missing"));
  }
}

TEST(CellFile, everyMemberReplacedByJunkIsAnErrorNotACrash) {
  const Value file = fanucFile();
  for (const auto& [key, value] : file.asObject()) {
    for (const Value& junk : {Value(), Value(-1), Value("text"), Value::array(), Value(true)}) {
      // Any text is a description; a cell may have no obstacles.
      if ((key == "description" && junk.isString()) || (key == "obstacles" && junk.isArray())) {
        continue;
      }
      Value broken = file;
      broken.set(key, junk);
      // Without a folder no other file is looked for.
      if ((key == "name" || key == "other_configuration") && junk.isString()) {
        continue;
      }
      EXPECT_NE(problemsOf(broken), "") << key << " " << toCompactJson(junk);
    }
  }
}

TEST(CellFile, missingFile) {
  try {
    loadCell("/nowhere/cell.json");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InputNotFound);
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/cell.json"));
  }
}

TEST(CellFile, aRobotWithoutClosedFormStillLoads) {
  Value file = fanucFile();
  jointOf(file, 4)->set("d", 3);
  const Cell cell = cellFromValue(file, "offset wrist");
  EXPECT_FALSE(cell.arm.has_value());
  EXPECT_THAT(cell.armProblem.str(), HasSubstr("wrist is not spherical"));
  EXPECT_TRUE(T_part_tcp(cell, JointVector::Zero(8)).matrix().allFinite());
}

}  // namespace
}  // namespace wcam::cell
