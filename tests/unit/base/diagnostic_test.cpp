// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/diagnostic.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/remedy.hpp"

#include <gtest/gtest.h>

namespace wcam {
namespace {

Diagnostic sample() {
  return {Severity::Violation, "motion.joint_limit", "axis 3 leaves its range",
          "turn the part",     {"elbow", 3, 0, 12},  {{"excess_deg", 1.5}}};
}

TEST(Diagnostic, AsValueAndLine) {
  EXPECT_EQ(
      toCompactJson(toValue(sample())),
      R"({"severity": "violation", "code": "motion.joint_limit", "message": "axis 3 leaves its range", "remedy": "turn the part", "place": {"operation": "elbow", "layer": 3, "bead": 0, "point": 12}, "data": {"excess_deg": 1.5}})");
  EXPECT_EQ(toLine(sample()),
            "violation motion.joint_limit [elbow layer 4 bead 1 point 13]: axis 3 leaves its range "
            "(turn the part)");
  const Diagnostic bare{Severity::Information, "a.b", "text", {}, {}, {}};
  EXPECT_EQ(toCompactJson(toValue(bare)),
            R"({"severity": "information", "code": "a.b", "message": "text"})");
  EXPECT_EQ(toLine(bare), "information a.b: text");
  const Diagnostic layer{Severity::Warning, "a.b", "text", {}, {{}, 2, -1, -1}, {}};
  EXPECT_EQ(toLine(layer), "warning a.b [layer 3]: text");
}

TEST(Diagnostic, PeopleCountFromOneAndFilesFromZero) {
  const Diagnostic first{Severity::Warning, "a.b", "text", {}, {"elbow", 0, 0, 0}, {}};
  EXPECT_EQ(toLine(first), "warning a.b [elbow layer 1 bead 1 point 1]: text");
  EXPECT_EQ(toValue(first).at("place").at("layer").asInteger(), 0);
}

TEST(Remedy, SettingsAreKeptAmongTheFiguresOfAFinding) {
  Diagnostic finding = sample();
  EXPECT_TRUE(settingsOf(finding).empty());
  const ParamSetting low{"params", "height_min", 1.58};
  const ParamSetting rate{"path", "axis_rate", 2.0};
  finding.data.push_back(figureOf(low));
  finding.data.push_back(figureOf(rate));
  EXPECT_EQ(settingsOf(finding), (std::vector<ParamSetting>{low, rate}));
  EXPECT_DOUBLE_EQ(toValue(finding).at("data").at("set.params.height_min").asReal(), 1.58);
}

TEST(Remedy, AnErrorCarriesItsSettings) {
  try {
    throw RemediedError(Error(ErrorCode::JobFailed, "too narrow", "spiral", "widen it"),
                        {{"params", "height_min", 1.58}});
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "spiral: too narrow");
    EXPECT_EQ(error.hint(), "widen it");
    const auto* remedied = dynamic_cast<const RemediedError*>(&error);
    ASSERT_NE(remedied, nullptr);
    EXPECT_EQ(remedied->settings(), (std::vector<ParamSetting>{{"params", "height_min", 1.58}}));
  }
}

TEST(Diagnostics, CollectAndCount) {
  Diagnostics all;
  all.add(sample());
  all.append({sample(), {Severity::Warning, "a.b", "text", {}, {}, {}}});
  EXPECT_EQ(all.count(Severity::Violation), 2U);
  EXPECT_EQ(all.count("a.b"), 1U);
  Diagnostics copy(all);
  copy.add(sample());
  EXPECT_EQ(all.items().size(), 3U);
  copy = all;
  EXPECT_EQ(copy.items().size(), 3U);
}

TEST(Error, ExitCodesOfTheCommandLine) {
  EXPECT_EQ(exitCodeOf(ErrorCode::InvalidArgument), 1);
  EXPECT_EQ(exitCodeOf(ErrorCode::Internal), 2);
  for (const ErrorCode code : {ErrorCode::InputNotFound, ErrorCode::InputInvalid,
                               ErrorCode::ProjectInvalid, ErrorCode::ProjectReadOnly}) {
    EXPECT_EQ(exitCodeOf(code), 3);
  }
  EXPECT_EQ(exitCodeOf(ErrorCode::OutputConflict), 4);
  EXPECT_EQ(exitCodeOf(ErrorCode::CheckFailed), 5);
  EXPECT_EQ(exitCodeOf(ErrorCode::JobFailed), 6);
  EXPECT_EQ(exitCodeOf(ErrorCode::PluginMissing), 7);
  EXPECT_EQ(exitCodeOf(ErrorCode::PluginRefused), 7);
  EXPECT_EQ(exitCodeOf(ErrorCode::Cancelled), 130);
}

TEST(Error, MessageWithContext) {
  const Error error(ErrorCode::InputInvalid, "no facets", "a.stl", "export it again");
  EXPECT_STREQ(error.what(), "a.stl: no facets");
  EXPECT_EQ(error.hint(), "export it again");
  EXPECT_STREQ(Error(ErrorCode::Internal, "x").what(), "x");
}

TEST(Error, KeepsItsTextsForOtherLanguages) {
  const Error error(ErrorCode::InputInvalid, text("line %1: %2", {"7", "not a number"}),
                    text("part '%1'", {"elbow"}), text("did you mean '%1'?", {"x"}));
  EXPECT_STREQ(error.what(), "part 'elbow': line 7: not a number");
  EXPECT_EQ(error.message(), "line 7: not a number");
  EXPECT_EQ(error.context(), "part 'elbow'");
  EXPECT_EQ(error.hint(), "did you mean 'x'?");
  EXPECT_EQ(error.messageText().pattern(), "line %1: %2");
  EXPECT_EQ(error.contextText().pattern(), "part '%1'");
  EXPECT_EQ(error.hintText().pattern(), "did you mean '%1'?");
  EXPECT_EQ(error.whatText(), error.what());
  // Plugins give strings.
  const std::string words = "100 %1";
  EXPECT_STREQ(Error(ErrorCode::JobFailed, words, words, words).what(), "100 %1: 100 %1");
  EXPECT_STREQ(Error(ErrorCode::JobFailed, words).what(), "100 %1");
}

TEST(Diagnostic, TakesTextsAndStrings) {
  const std::string words = "made by a plugin, 50 %1";
  const Diagnostic d{Severity::Warning, "x.y", words, text("use %1", {"less"}), {}, {}};
  EXPECT_EQ(toLine(d), "warning x.y: made by a plugin, 50 %1 (use less)");
  EXPECT_EQ(toValue(d).at("message").asString(), words);
  EXPECT_EQ(toValue(d).at("remedy").asString(), "use less");
}

TEST(Diagnostics, CountsWhatIsBeyondTheLimitOfOneKind) {
  Diagnostics all;
  for (int i = 0; i < 2500; ++i) {
    all.add({Severity::Warning, "a.b", "many", {}, {"build", i, -1, -1}, {}});
  }
  all.add({Severity::Violation, "a.b", "one", {}, {}, {}});
  all.add({Severity::Warning, "a.c", "one", {}, {}, {}});
  const std::vector<Diagnostic> items = all.items();
  ASSERT_EQ(items.size(), kMostOfOneKind + 3);
  const Diagnostic& more = items[kMostOfOneKind];
  EXPECT_EQ(toLine(more),
            "warning findings.more [build]: 1500 more findings of the kind a.b are not listed");
  EXPECT_EQ(more.data.front().second, 1500.0);
  // A copy goes on counting.
  Diagnostics copy(all);
  copy.add({Severity::Warning, "a.b", "many", {}, {}, {}});
  EXPECT_EQ(copy.items()[kMostOfOneKind].data.front().second, 1501.0);
  EXPECT_EQ(all.items()[kMostOfOneKind].data.front().second, 1500.0);
}

}  // namespace
}  // namespace wcam
