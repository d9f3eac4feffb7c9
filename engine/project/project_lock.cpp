// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/project_lock.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/text.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

namespace wcam::project {

namespace {

constexpr const char* kOpen = "open";
constexpr const char* kChange = "change";

std::filesystem::path lockFile(const std::filesystem::path& project) {
  std::error_code error;
  std::filesystem::path file = std::filesystem::weakly_canonical(project, error);
  if (error) {
    file = project;
  }
  file.replace_filename("." + file.filename().native() + ".lock");
  return file;
}

std::string ownLines(ProjectLock::Use use) {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return std::to_string(::getpid()) + "\n" + host.data() + "\n" +
         (use == ProjectLock::Use::Open ? kOpen : kChange) + "\n";
}

/// The number behind a name in /proc/PID/status, hexadecimal; 0 where there is none.
unsigned long long pendingSignals(const std::string& status, std::string_view name) {
  const std::size_t at = status.find(name);
  return at == std::string::npos ? 0
                                 : std::strtoull(status.c_str() + at + name.size(), nullptr, 16);
}

/// A process that was killed keeps its files until the system has taken it apart, which can take a
/// second: it uses the project no more.
bool isEnding(const std::string& pid) {
  const std::filesystem::path folder = std::filesystem::path("/proc") / pid;
  std::ifstream stream(folder / "status");
  const std::string status((std::istreambuf_iterator<char>(stream)), {});
  if (status.empty()) {
    return true;
  }
  const std::size_t state = status.find("State:\t");
  const char letter = state == std::string::npos ? ' ' : status[state + 7];
  constexpr unsigned long long kKill = 1ULL << (SIGKILL - 1);
  std::error_code gone;
  (void)std::filesystem::read_symlink(folder / "exe", gone);
  return letter == 'Z' || letter == 'X' || gone == std::errc::no_such_file_or_directory ||
         ((pendingSignals(status, "\nSigPnd:\t") | pendingSignals(status, "\nShdPnd:\t")) &
          kKill) != 0;
}

/// Is a process of this machine that the lock's text names on its way out?
bool isHeldByEnding(int fd) {
  std::array<char, 512> buffer{};
  const ssize_t size = ::pread(fd, buffer.data(), buffer.size(), 0);
  const std::vector<std::string> lines =
      splitText(std::string(buffer.data(), static_cast<std::size_t>(size > 0 ? size : 0)), '\n');
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return lines.size() >= 3 && lines[1] == host.data() && !lines[0].empty() &&
         lines[0].find_first_not_of("0123456789") == std::string::npos && isEnding(lines[0]);
}

ProjectLock::Attempt heldBy(int fd) {
  std::array<char, 512> buffer{};
  const ssize_t size = ::pread(fd, buffer.data(), buffer.size(), 0);
  const std::vector<std::string> lines =
      splitText(std::string(buffer.data(), static_cast<std::size_t>(size > 0 ? size : 0)), '\n');
  ProjectLock::Attempt attempt;
  attempt.holder =
      lines.size() >= 3 ? text("process %1 on %2", {lines[0], lines[1]}) : text("another program");
  attempt.isOpen = lines.size() >= 3 && lines[2] == kOpen;
  return attempt;
}

/// Is the locked file still the one of this name? Its last holder removes it.
bool isCurrent(int fd, const std::filesystem::path& file) {
  struct stat own {};

  struct stat named {};

  return ::fstat(fd, &own) == 0 && ::lstat(file.c_str(), &named) == 0 &&
         own.st_ino == named.st_ino && own.st_dev == named.st_dev;
}

}  // namespace

ProjectLock::Attempt ProjectLock::attempt(const std::filesystem::path& project, Use use) {
  constexpr int kWaits = 500;
  constexpr std::chrono::milliseconds kPause(10);
  const std::filesystem::path file = lockFile(project);
  for (int waits = 0;;) {
    const int fd = ::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (fd < 0) {
      Attempt failed;
      failed.error = errno;
      return failed;
    }
    if (::flock(fd, LOCK_EX | LOCK_NB) != 0) {
      const int error = errno;
      Attempt failed;
      if (error == EWOULDBLOCK && waits < kWaits && isHeldByEnding(fd)) {
        ::close(fd);
        ++waits;
        std::this_thread::sleep_for(kPause);
        continue;
      }
      if (error == EWOULDBLOCK || error == EINTR) {
        failed = heldBy(fd);
      } else {
        failed.error = error;
      }
      ::close(fd);
      return failed;
    }
    if (!isCurrent(fd, file)) {
      ::close(fd);
      continue;
    }
    const std::string lines = ownLines(use);
    if (::ftruncate(fd, 0) != 0 ||
        ::pwrite(fd, lines.data(), lines.size(), 0) != static_cast<ssize_t>(lines.size())) {
      // The lock holds without its text, which only names the holder.
    }
    Attempt taken;
    taken.lock = std::unique_ptr<ProjectLock>(new ProjectLock(fd, file));
    return taken;
  }
}

std::unique_ptr<ProjectLock> ProjectLock::take(const std::filesystem::path& project, Use use) {
  constexpr std::chrono::seconds kLongest(30);
  constexpr std::chrono::milliseconds kPause(10);
  Attempt last;
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < kLongest) {
    last = attempt(project, use);
    if (last.lock != nullptr) {
      return std::move(last.lock);
    }
    if (last.error != 0) {
      throw Error(ErrorCode::OutputConflict,
                  text("cannot be changed, since its lock file cannot be made: %1",
                       {std::generic_category().message(last.error)}),
                  pathText(project), "choose a folder that you may write to");
    }
    if (last.isOpen) {
      break;
    }
    std::this_thread::sleep_for(kPause);
  }
  throw Error(ErrorCode::OutputConflict,
              last.isOpen ? text("another program has the project open (%1)", {last.holder})
                          : text("another program is changing the project (%1)", {last.holder}),
              pathText(project), "close it there and try again");
}

ProjectLock::~ProjectLock() {
  // Removed before it is released: who waits for it sees that it is no longer the current one.
  ::unlink(file_.c_str());
  ::close(fd_);
}

}  // namespace wcam::project
