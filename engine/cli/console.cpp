// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "console.hpp"

#include "wcam/base/text.hpp"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

namespace wcam::cli {

namespace {

sigset_t stopSignals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  // Wakes the waiting thread at the end.
  sigaddset(&set, SIGUSR2);
  return set;
}

bool terminal() {
  return ::isatty(STDERR_FILENO) != 0;
}

}  // namespace

InterruptGuard::InterruptGuard() {
  const sigset_t set = stopSignals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  thread_ = std::jthread([this](const std::stop_token& ended) {
    const sigset_t waited = stopSignals();
    while (true) {
      int signal = 0;
      if (sigwait(&waited, &signal) != 0 || ended.stop_requested()) {
        return;
      }
      if (signal == SIGUSR2) {
        continue;
      }
      if (source_.stop_requested()) {
        ::_exit(exitCodeOf(ErrorCode::Cancelled));
      }
      source_.request_stop();
    }
  });
}

InterruptGuard::~InterruptGuard() {
  thread_.request_stop();
  pthread_kill(thread_.native_handle(), SIGUSR2);
}

void Console::say(const std::string& line) const {
  if (!quiet_) {
    std::fprintf(stderr, "%s\n", line.c_str());
  }
}

void Console::complain(const std::string& line) const {
  std::fprintf(stderr, "%s\n", line.c_str());
}

void Console::error(const Error& error) const {
  complain(std::string("camcli: ") + (error.code() == ErrorCode::Cancelled ? "" : "error: ") +
           error.what());
  if (!error.hint().empty()) {
    complain("  hint: " + error.hint());
  }
}

void Console::findings(const std::vector<Diagnostic>& findings) const {
  struct Group {
    const Diagnostic* first = nullptr;
    int count = 0;
  };

  std::map<std::pair<int, std::string>, Group> groups;
  for (const Diagnostic& finding : findings) {
    Group& group = groups[{-static_cast<int>(finding.severity),
                           finding.place.operation + "\n" + finding.code}];
    group.first = group.first == nullptr ? &finding : group.first;
    ++group.count;
  }
  for (const auto& [key, group] : groups) {
    const std::string more = group.count > 1 ? " [" + std::to_string(group.count) + " times]" : "";
    say("  " + toLine(*group.first) + more);
  }
}

JobContext::ProgressFunction Console::progressBar() const {
  if (quiet_ || !terminal()) {
    return {};
  }
  auto shown = std::make_shared<int>(-1);
  return [shown](double fraction, const std::string& label) {
    constexpr int kWidth = 30;
    const int percent = static_cast<int>(100.0 * fraction);
    if (percent == *shown) {
      return;
    }
    *shown = percent;
    const int filled = kWidth * percent / 100;
    std::fprintf(stderr, "\r[%s%s] %3d %% %-24.24s",
                 std::string(static_cast<std::size_t>(filled), '#').c_str(),
                 std::string(static_cast<std::size_t>(kWidth - filled), '.').c_str(), percent,
                 label.c_str());
    std::fflush(stderr);
  };
}

void Console::endProgress() const {
  if (!quiet_ && terminal()) {
    std::fprintf(stderr, "\r\033[K");
    std::fflush(stderr);
  }
}

}  // namespace wcam::cli
