// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "console.hpp"

#include "wcam/base/text.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
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

void prepareProcess() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(fd, F_GETFD) == -1) {
      // Opened the wrong way round, so that its use is still an error.
      ::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
  }
  ::signal(SIGXFSZ, SIG_IGN);
}

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

std::string printable(std::string_view text) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : '\0');
    // C1 controls are two bytes in UTF-8.
    const bool c1 = byte == 0xc2 && next >= 0x80 && next < 0xa0;
    if ((byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7f || c1) {
      const unsigned char code = c1 ? next : byte;
      shown += std::string("\\x") + kDigits[code >> 4U] + kDigits[code & 15U];
      i += c1 ? 1 : 0;
    } else {
      shown += text[i];
    }
  }
  return shown;
}

void Console::say(const std::string& line) const {
  if (!quiet_) {
    std::fprintf(stderr, "%s\n", printable(line).c_str());
  }
}

void Console::complain(const std::string& line) const {
  std::fprintf(stderr, "%s\n", printable(line).c_str());
}

void Console::error(const Error& error) const {
  complain(std::string("camcli: ") + (error.code() == ErrorCode::Cancelled ? "" : "error: ") +
           error.what());
  if (!error.hint().empty()) {
    complain("  hint: " + error.hint());
  }
}

namespace {

/// Findings of one kind, told in one line.
struct FindingGroup {
  Diagnostic first;
  int count = 0;
};

/// Of one code: those of one operation, with their number.
std::vector<FindingGroup> groupsByOperation(const std::vector<Diagnostic>& findings) {
  std::vector<FindingGroup> groups;
  for (const Diagnostic& finding : findings) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const FindingGroup& group) {
      return group.first.severity == finding.severity && group.first.code == finding.code &&
             group.first.place.operation == finding.place.operation;
    });
    if (same == groups.end()) {
      groups.push_back({finding, 1});
    } else {
      ++same->count;
    }
  }
  return groups;
}

/// What several operations have in common, such as the findings of their part, is told once.
std::vector<FindingGroup> mergedOperations(const std::vector<FindingGroup>& groups) {
  std::vector<FindingGroup> merged;
  for (const FindingGroup& group : groups) {
    const auto same = std::find_if(merged.begin(), merged.end(), [&](const FindingGroup& other) {
      return other.first.severity == group.first.severity && other.first.code == group.first.code &&
             other.first.message == group.first.message && other.count == group.count &&
             other.first.place.layer == group.first.place.layer;
    });
    if (same == merged.end()) {
      merged.push_back(group);
    } else {
      same->first.place.operation += ", " + group.first.place.operation;
    }
  }
  return merged;
}

}  // namespace

void Console::findings(const std::vector<Diagnostic>& findings) const {
  std::vector<FindingGroup> groups = mergedOperations(groupsByOperation(findings));
  std::stable_sort(groups.begin(), groups.end(), [](const FindingGroup& a, const FindingGroup& b) {
    return a.first.severity > b.first.severity;
  });
  for (const FindingGroup& group : groups) {
    const std::string more = group.count > 1 ? " [" + std::to_string(group.count) + " times]" : "";
    const std::string line = "  " + toLine(group.first) + more;
    if (group.first.severity == Severity::Violation) {
      complain(line);
    } else {
      say(line);
    }
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
    const std::string shownLabel = printable(label);
    std::fprintf(stderr, "\r[%s%s] %3d %% %-24.24s",
                 std::string(static_cast<std::size_t>(filled), '#').c_str(),
                 std::string(static_cast<std::size_t>(kWidth - filled), '.').c_str(), percent,
                 shownLabel.c_str());
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
