// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wcam::testing {

/// How to run a program.
struct ProcessRequest {
  std::filesystem::path program;
  std::vector<std::string> arguments;
  std::filesystem::path folder;                    ///< working directory; empty: that of the test
  std::map<std::string, std::string> environment;  ///< on top of the test's own
  std::optional<std::size_t> fileSizeLimit;        ///< bytes; what a full disk looks like
  std::filesystem::path standardOutput;            ///< file to write to instead of reading it
  std::filesystem::path standardInput;             ///< file to read; empty: nothing
  bool closedStandardOutput = false;
  bool terminal = false;      ///< standard error is a terminal
  std::optional<int> signal;  ///< sent as soon as standard error has text
  std::chrono::seconds timeout{120};
};

struct ProcessResult {
  int exitCode = -1;  ///< −1 when ended by a signal
  int endSignal = 0;
  bool timedOut = false;
  std::string out;
  std::string err;
  /// From sending the signal to the end.
  std::chrono::duration<double> afterSignal{0.0};
};

/// Runs a program to its end and reads what it prints; kills it after the timeout.
/// @throws std::system_error when it cannot be started
ProcessResult runProcess(const ProcessRequest& request);

}  // namespace wcam::testing
