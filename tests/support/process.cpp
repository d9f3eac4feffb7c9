// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

extern char** environ;

namespace wcam::testing {

namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// Both ends of a pipe, or of a terminal.
struct Channel {
  int read = -1;
  int write = -1;

  Channel() = default;
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  ~Channel() {
    closeRead();
    closeWrite();
  }

  void open(bool terminal) {
    std::array<int, 2> ends{};
    if (terminal ? ::openpty(ends.data(), ends.data() + 1, nullptr, nullptr, nullptr) != 0
                 : ::pipe(ends.data()) != 0) {
      fail("channel");
    }
    read = ends[0];
    write = ends[1];
    ::fcntl(read, F_SETFD, FD_CLOEXEC);
    ::fcntl(write, F_SETFD, FD_CLOEXEC);
  }

  void closeRead() { closeEnd(read); }

  void closeWrite() { closeEnd(write); }

private:
  static void closeEnd(int& end) {
    if (end >= 0) {
      ::close(end);
      end = -1;
    }
  }
};

std::vector<std::string> environmentOf(const ProcessRequest& request) {
  std::vector<std::string> lines;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string line = *entry;
    if (!request.environment.contains(line.substr(0, line.find('=')))) {
      lines.push_back(line);
    }
  }
  for (const auto& [name, value] : request.environment) {
    lines.push_back(name + "=" + value);
  }
  return lines;
}

std::vector<char*> pointers(std::vector<std::string>& lines) {
  std::vector<char*> result;
  for (std::string& line : lines) {
    result.push_back(line.data());
  }
  result.push_back(nullptr);
  return result;
}

/// Runs in the child: only calls that are safe after fork.
[[noreturn]] void become(const ProcessRequest& request,
                         char* const* arguments,
                         char* const* environment,
                         int out,
                         int err) {
  // A process group of its own takes no signals that are meant for the test.
  ::setpgid(0, 0);
  const int in =
      ::open(request.standardInput.empty() ? "/dev/null" : request.standardInput.c_str(), O_RDONLY);
  ::dup2(in, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  if (request.closedStandardOutput) {
    ::close(STDOUT_FILENO);
  }
  if (!request.folder.empty() && ::chdir(request.folder.c_str()) != 0) {
    ::_exit(126);
  }
  if (request.fileSizeLimit) {
    const rlimit limit{*request.fileSizeLimit, *request.fileSizeLimit};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ::execve(arguments[0], arguments, environment);
  ::_exit(127);
}

/// Takes what there is. @return false at the end
bool take(int fd, std::string& text) {
  std::array<char, 65536> buffer{};
  const ssize_t got = ::read(fd, buffer.data(), buffer.size());
  if (got > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(got));
  }
  // A terminal without writers gives EIO.
  return got > 0 || (got < 0 && errno == EINTR);
}

}  // namespace

ProcessResult runProcess(const ProcessRequest& request) {
  std::vector<std::string> arguments = {request.program.native()};
  arguments.insert(arguments.end(), request.arguments.begin(), request.arguments.end());
  std::vector<std::string> environment = environmentOf(request);
  const std::vector<char*> argv = pointers(arguments);
  const std::vector<char*> envp = pointers(environment);
  Channel out;
  Channel err;
  err.open(request.terminal);
  if (request.standardOutput.empty()) {
    out.open(false);
  } else {
    out.write = ::open(request.standardOutput.c_str(), O_WRONLY | O_CLOEXEC);
  }
  const pid_t child = ::fork();
  if (child < 0) {
    fail("fork");
  }
  if (child == 0) {
    become(request, argv.data(), envp.data(), out.write, err.write);
  }
  out.closeWrite();
  err.closeWrite();

  ProcessResult result;
  const Clock::time_point deadline = Clock::now() + request.timeout;
  std::optional<Clock::time_point> signalled;
  while (out.read >= 0 || err.read >= 0) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    std::array<pollfd, 2> fds = {pollfd{out.read, POLLIN, 0}, pollfd{err.read, POLLIN, 0}};
    if (left <= 0 || ::poll(fds.data(), fds.size(), static_cast<int>(left)) == 0) {
      result.timedOut = true;
      ::kill(child, SIGKILL);
      break;
    }
    if (fds[0].revents != 0 && !take(out.read, result.out)) {
      out.closeRead();
    }
    if (fds[1].revents != 0 && !take(err.read, result.err)) {
      err.closeRead();
    }
    if (request.signal && !signalled && !result.err.empty()) {
      ::kill(child, *request.signal);
      signalled = Clock::now();
    }
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (signalled) {
    result.afterSignal = Clock::now() - *signalled;
  }
  result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  result.endSignal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  return result;
}

}  // namespace wcam::testing
