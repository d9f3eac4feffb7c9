// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/html_report.hpp"

#include "wcam/base/json.hpp"

#include <gtest/gtest.h>

namespace wcam::project {
namespace {

Document sample() {
  return Document::parse(
      parseJson(R"({"format": "wcam-project", "format_version": 1, "name": "a <b> & c",
    "parts": [{"id": "p", "file": {"path": "p.stl"}}],
    "substrates": [{"id": "s", "type": "plate", "size_mm": [100.0, 100.0, 10.0]}],
    "processes": [{"id": "w"}],
    "operations": [{"id": "one", "strategy": "x.y", "parts": ["p"], "substrate": "s", "process": "w",
                    "params": {"step": 2.5}}]})"));
}

TEST(HtmlReport, IsOnePageWithFiguresFindingsAndSettings) {
  RunResult result;
  OperationResult operation;
  operation.id = "one";
  operation.strategy = "x.y";
  operation.findings.push_back(
      {Severity::Violation, "motion.joint_limit", "J5 <too far>", "turn it", {"one", 2, 0, 7}, {}});
  result.operations.push_back(operation);
  result.report = Value::object(
      {{"operations",
        Value(Value::Array{Value::object(
            {{"id", "one"},
             {"layers", 12},
             {"length_mm", 12.5},
             {"height_mm", Value::object({{"min", 1.0}, {"mean", 2.0}, {"max", 3.0}})},
             {"joints",
              Value(Value::Array{Value::object({{"name", "J1"}, {"min_deg", -5.0}})})}})})}});
  result.failures.push_back({"operation 'two'", Error(ErrorCode::JobFailed, "it broke")});
  const std::string html = htmlReport(sample(), result, {{"View", "data:image/png;base64,AAAA"}});
  for (const char* wanted :
       {"<h1>a &lt;b&gt; &amp; c</h1>", "length (mm)", "12.500", "1.000 / 2.000 / 3.000", "J1",
        "J5 &lt;too far&gt;", "layer 3, bead 1, point 8", "turn it", "&quot;step&quot;: 2.5",
        "it broke", "data:image/png;base64,AAAA"}) {
    EXPECT_NE(html.find(wanted), std::string::npos) << wanted;
  }
  // Self-contained: nothing is fetched from outside.
  EXPECT_EQ(html.find("http"), std::string::npos);
  EXPECT_EQ(html, htmlReport(sample(), result, {{"View", "data:image/png;base64,AAAA"}}));
}

TEST(HtmlReport, AnEmptyRunIsAPageToo) {
  const std::string html = htmlReport(Document::empty("nothing"), {});
  EXPECT_NE(html.find("<h1>nothing</h1>"), std::string::npos);
  EXPECT_NE(html.find("</html>"), std::string::npos);
}

}  // namespace
}  // namespace wcam::project
