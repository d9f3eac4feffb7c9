// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/error.hpp"

#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace wcam::cli {

/// Text for a terminal: names may hold control characters, which must not steer it. They are
/// shown as \xNN; line ends and tabs stay.
std::string printable(std::string_view text);

/// Turns SIGINT and SIGTERM into a stop request: the first asks the job to end, the second ends the
/// process at once. Must be made before any other thread, since the signals are blocked in all of
/// them.
class InterruptGuard {
public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

private:
  std::stop_source source_;
  std::jthread thread_;
};

/// Makes the process fit for writing files: the standard descriptors are open (else a file that is
/// opened later would get the number of standard output and receive what is printed), and a file
/// beyond the size limit is an error like a full disk, not a signal.
void prepareProcess();

/// Human text on stderr; quiet keeps errors and violations only.
class Console {
public:
  explicit Console(bool quiet) : quiet_(quiet) {}

  void say(const std::string& line) const;
  void complain(const std::string& line) const;
  void error(const Error& error) const;
  /// The worst first, each kind once: findings of one code in one operation are counted behind the
  /// first of them, equal messages of several operations are told together.
  void findings(const std::vector<Diagnostic>& findings) const;
  /// A progress bar on a terminal, nothing elsewhere.
  [[nodiscard]] JobContext::ProgressFunction progressBar() const;
  void endProgress() const;

private:
  bool quiet_;
};

}  // namespace wcam::cli
