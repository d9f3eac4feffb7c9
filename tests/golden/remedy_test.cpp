// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Remedies are followed as they are told.

#include "wcam/base/json.hpp"
#include "wcam/project/report.hpp"
#include "wcam/project/run.hpp"

#include "example_project.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace wcam::project {
namespace {

Document with(Document document, const std::vector<Command>& commands) {
  for (const Command& command : commands) {
    document = apply(document, command);
  }
  return document;
}

OperationResult compute(const Document& document, const std::string& operation) {
  return Pipeline(document, test::exampleFile("elbow"), test::hostOfPlugins())
      .compute(operation, JobContext());
}

std::size_t violations(const OperationResult& result) {
  return static_cast<std::size_t>(
      std::count_if(result.findings.begin(), result.findings.end(),
                    [](const Diagnostic& d) { return d.severity == Severity::Violation; }));
}

Document elbowAt(double x, double y, double z) {
  Document document = test::exampleDocument("elbow");
  const Value position(Value::Array{Value(x), Value(y), Value(z)});
  return with(
      document,
      {{"part.set", Value::object({{"id", "elbow"},
                                   {"placement", Value::object({{"position_mm", position}})}})},
       {"substrate.set", Value::object({{"id", "plate"}, {"position_mm", position}})}});
}

TEST(Remedies, WhatIsOfferedDoesWhatItSays) {
  std::size_t offered = 0;
  std::size_t complete = 0;
  for (const Document& document : {elbowAt(0, 0, 0), elbowAt(700, 0, 0), elbowAt(1000, 0, 0)}) {
    const OperationResult result = compute(document, "planar");
    ASSERT_EQ(result.remedies.size(), result.findings.size());
    std::vector<Command> followed;
    for (std::size_t i = 0; i < result.findings.size(); ++i) {
      const Diagnostic& finding = result.findings[i];
      for (const auto& [name, value] : finding.data) {
        EXPECT_NE(name.rfind("try_", 0), 0U) << "a figure that nobody is to see: " << name;
      }
      if (result.remedies[i].empty()) {
        // Not tried, or tried in vain: a hint, and called so.
        const std::string remedy = finding.remedy.str();
        if (finding.code.rfind("motion.", 0) == 0 && remedy.find("serves") != std::string::npos) {
          EXPECT_EQ(remedy.rfind("a hint: ", 0), 0U) << remedy;
        }
        continue;
      }
      if (result.remedies[i] == followed) {
        continue;
      }
      followed = result.remedies[i];
      ++offered;
      const OperationResult after = compute(with(document, followed), "planar");
      const std::size_t left = violations(after);
      // A substrate beside its table stays there, whatever turns.
      const bool onlyBeside =
          std::all_of(after.findings.begin(), after.findings.end(), [](const Diagnostic& d) {
            return d.severity != Severity::Violation || d.code == "motion.beside_table";
          });
      complete += onlyBeside ? 1U : 0U;
      const std::string remedy = finding.remedy.str();
      if (remedy.find("no violation is left") != std::string::npos) {
        EXPECT_EQ(left, 0U) << remedy;
      } else {
        EXPECT_NE(remedy.find(std::to_string(left) + " of " + std::to_string(violations(result))),
                  std::string::npos)
            << remedy << ", but " << left << " are left";
        EXPECT_LT(left, violations(result));
      }
    }
  }
  // A parameter at the one place, a turn of the part at the other.
  EXPECT_GE(offered, 2U);
  EXPECT_GE(complete, 2U);
}

TEST(Remedies, ReportAndErrorsHoldTheCommandsForScripts) {
  Document document = with(
      test::exampleDocument("elbow"),
      {{"operation.remove", Value::object({{"id", "guide"}})},
       {"operation.set", Value::object({{"id", "planar"}, {"strategy", "wcam.slicing.spiral"}})}});
  const Pipeline pipeline(document, test::exampleFile("elbow"), test::hostOfPlugins());
  RunRequest request;
  request.checkOnly = true;
  const RunResult run = runProject(pipeline, request, JobContext());
  ASSERT_EQ(run.failures.size(), 1U);
  const Value& error = run.report.at("errors").asArray()[0];
  ASSERT_TRUE(error.contains("apply")) << toCompactJson(error);
  // The lines are commands, and do.
  for (const Value& line : error.at("apply").asArray()) {
    document = apply(document, commandFromValue(line));
  }
  const OperationResult spiral =
      Pipeline(document, test::exampleFile("elbow"), test::hostOfPlugins())
          .computePath("planar", JobContext());
  EXPECT_EQ(spiral.path->layers.size(), 1U);
}

}  // namespace
}  // namespace wcam::project
