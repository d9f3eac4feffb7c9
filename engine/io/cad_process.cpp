// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cad_process.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/log.hpp"

#include "cad_transfer.hpp"
#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>

extern char** environ;

namespace wcam::io {

namespace {

constexpr int kPollMilliseconds = 50;
constexpr std::size_t kReadSize = 1 << 16;
constexpr std::size_t kFrameHead = 1 + sizeof(std::uint64_t);

/// Path of the worker beside the library (or program) that holds this function; empty when there is
/// none.
std::filesystem::path workerProgram() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&buildCadPartApart), &info) == 0 ||
      info.dli_fname == nullptr) {
    return {};
  }
  std::error_code error;
  const auto library = std::filesystem::canonical(info.dli_fname, error);
  const auto program = library.parent_path() / "wcam" / "wcam-cad-worker";
  return !error && ::access(program.c_str(), X_OK) == 0 ? program : std::filesystem::path();
}

class Descriptor {
public:
  explicit Descriptor(int fd) : fd_(fd) {}

  ~Descriptor() { close(); }

  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void close() {
    if (fd_ >= 0) {
      ::close(fd_);
      fd_ = -1;
    }
  }

  [[nodiscard]] int get() const { return fd_; }

private:
  int fd_;
};

/// A running worker; killed when it is no longer wanted.
class Worker {
public:
  Worker(const std::filesystem::path& program, const std::string& request, int answer) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, answer, kWorkerAnswer);
    std::string name = program.string();
    std::string argument = request;
    std::array<char*, 3> arguments{name.data(), argument.data(), nullptr};
    const int error =
        posix_spawn(&pid_, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
      throw Error(ErrorCode::JobFailed,
                  text("the CAD worker cannot be started: %1", {std::strerror(error)}),
                  pathText(program));
    }
  }

  ~Worker() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      wait();
    }
  }

  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Status as of waitpid().
  int wait() {
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    return status;
  }

private:
  pid_t pid_ = -1;
};

/// Takes the worker's answer apart while it comes.
class Answer {
public:
  explicit Answer(const JobContext& context) : context_(context) {}

  void add(const char* data, std::size_t size) {
    if (result_) {
      return;  // nothing follows the result, which lies in the bytes so far
    }
    bytes_.append(data, size);
    while (bytes_.size() - done_ >= kFrameHead) {
      std::uint64_t length = 0;
      std::memcpy(&length, bytes_.data() + done_ + 1, sizeof(length));
      if (bytes_.size() - done_ - kFrameHead < length) {
        break;
      }
      frame(static_cast<FrameKind>(bytes_[done_]),
            std::string_view(bytes_).substr(done_ + kFrameHead, length));
      done_ += kFrameHead + length;
    }
    if (done_ > 0 && !result_) {
      bytes_.erase(0, done_);
      done_ = 0;
    }
  }

  [[nodiscard]] const std::optional<std::string_view>& result() const { return result_; }

private:
  void frame(FrameKind kind, std::string_view content) {
    if (kind == FrameKind::Progress) {
      const auto [fraction, label] = decodeProgress(content);
      context_.portion(0.0, 1.0, label).report(fraction);
    } else if (kind == FrameKind::Failure) {
      throw decodeError(content);
    } else {
      result_ = content;
    }
  }

  const JobContext& context_;
  std::string bytes_;
  std::size_t done_ = 0;
  std::optional<std::string_view> result_;
};

void receive(int fd, Answer& answer, const JobContext& context) {
  std::vector<char> chunk(kReadSize);
  while (true) {
    context.check();
    pollfd waiting{fd, POLLIN, 0};
    if (::poll(&waiting, 1, kPollMilliseconds) == 0) {
      continue;
    }
    const ssize_t got = ::read(fd, chunk.data(), chunk.size());
    if (got == 0) {
      return;
    }
    if (got > 0) {
      answer.add(chunk.data(), static_cast<std::size_t>(got));
    } else if (errno != EINTR) {
      return;  // the missing result tells the rest
    }
  }
}

[[noreturn]] void workerDied(int status, const ImportJob& job, const JobContext& context) {
  context.check();
  const Text hint = text("the file is damaged; export the part again");
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGINT || signal == SIGTERM) {
    throw CancelledError();  // sent to all programs of the terminal
  }
  if (signal == SIGXCPU) {
    throw Error(ErrorCode::InputInvalid, "the CAD library does not come to an end with this file",
                job.fileText, hint);
  }
  throw Error(ErrorCode::InputInvalid,
              signal != 0 ? text("the CAD library broke down on this file (signal %1)",
                                 {std::to_string(signal)})
                          : text("the CAD library broke down on this file"),
              job.fileText, hint);
}

}  // namespace

geometry::PartSurface buildCadPartApart(std::string_view bytes,
                                        const ImportJob& job,
                                        ImportReport& report,
                                        const JobContext& context) {
  const std::filesystem::path program = workerProgram();
  if (program.empty()) {
    log::debug("io", "wcam-cad-worker is not installed; the CAD file is read in this process");
    return buildCadPart(bytes, job, report, context);
  }
  context.check();
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw Error(ErrorCode::JobFailed, text("no pipe: %1", {std::strerror(errno)}));
  }
  const Descriptor readEnd(ends[0]);
  Descriptor writeEnd(ends[1]);
  Worker worker(program, encodeRequest(job), writeEnd.get());
  writeEnd.close();
  Answer answer(context);
  receive(readEnd.get(), answer, context);
  const int status = worker.wait();
  if (!answer.result()) {
    workerDied(status, job, context);
  }
  std::vector<Diagnostic> findings;
  geometry::PartSurface surface = decodePart(*answer.result(), report, findings);
  context.diagnostics().append(findings);
  context.report(1.0);
  context.check();
  return surface;
}

}  // namespace wcam::io
