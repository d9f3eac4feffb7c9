// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Terminal and signals: a progress bar only where somebody looks, a clean end on Ctrl-C.
#include "camcli.hpp"

#include <csignal>

namespace wcam::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class Interrupt : public CamcliTest {
protected:
  const fs::path elbow_ = exampleFolder("elbow") / "elbow.wcam";
};

TEST_F(Interrupt, ProgressOnATerminalOnly) {
  ProcessRequest terminal;
  terminal.terminal = true;
  const ProcessResult shown = camcli({"--project", elbow_, "--output", "out"}, terminal);
  EXPECT_EQ(shown.exitCode, 0);
  EXPECT_THAT(shown.err, HasSubstr("\r[#"));
  EXPECT_THAT(shown.err, HasSubstr("\033[K"));
  EXPECT_EQ(shown.out, "");
  const ProcessResult quiet = camcli({"--project", elbow_, "--output", "out", "--quiet"}, terminal);
  EXPECT_EQ(quiet.err, "");
  const ProcessResult piped = camcli({"--project", elbow_, "--output", "out"});
  EXPECT_THAT(piped.err, Not(HasSubstr("\r")));
  EXPECT_THAT(piped.err, Not(HasSubstr("\033")));
}

class StopSignal : public Interrupt, public ::testing::WithParamInterface<int> {};

TEST_P(StopSignal, EndsALongJobCleanly) {
  ProcessRequest request;
  request.terminal = true;
  request.signal = GetParam();
  // Thousands of layers: much longer than the time that a cancel may take.
  const ProcessResult result =
      camcli({"--project", elbow_, "--output", "a/out", "--set", "step=0.02mm"}, request);
  EXPECT_EQ(result.exitCode, 130) << result.err;
  EXPECT_THAT(result.err, HasSubstr("camcli: cancelled"));
  EXPECT_THAT(result.err, Not(HasSubstr("error")));
  // DESIGN allows 200 ms; the rest is for a busy machine.
  EXPECT_LT(result.afterSignal.count(), 2.0);
  EXPECT_TRUE(fs::is_empty(folder_.path())) << "something was left";
}

TEST_P(StopSignal, KeepsTheFilesOfTheLastRun) {
  EXPECT_EQ(camcli({"--project", elbow_, "--output", "out"}).exitCode, 0);
  const Files before = filesBelow(folder_ / "out");
  ProcessRequest request;
  request.terminal = true;
  request.signal = GetParam();
  const ProcessResult result =
      camcli({"--project", elbow_, "--output", "out", "--set", "step=0.02mm", "--json"}, request);
  EXPECT_EQ(result.exitCode, 130);
  EXPECT_EQ(parseJson(result.out).at("errors").asArray().at(0).at("code").asString(), "cancelled");
  EXPECT_EQ(filesBelow(folder_ / "out"), before);
}

INSTANTIATE_TEST_SUITE_P(Signals,
                         StopSignal,
                         ::testing::Values(SIGINT, SIGTERM),
                         [](const auto& signal) {
                           return std::string(signal.param == SIGINT ? "Interrupt" : "Terminate");
                         });

}  // namespace
}  // namespace wcam::testing
