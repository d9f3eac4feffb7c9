// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trial.hpp"

#include "wcam/base/log.hpp"
#include "wcam/plugin/locations.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>

extern char** environ;

namespace wcam::plugin {

namespace {

constexpr std::chrono::seconds kPatience{30};
constexpr std::chrono::milliseconds kLook{2};

pid_t start(const std::filesystem::path& program, const std::filesystem::path& manifest) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::string name = program.string();
  std::string argument = std::filesystem::absolute(manifest).string();
  std::array<char*, 3> arguments{name.data(), argument.data(), nullptr};
  pid_t pid = -1;
  const int error =
      posix_spawn(&pid, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? pid : -1;
}

}  // namespace

Text trialProblem(const std::filesystem::path& manifest) {
  const std::filesystem::path program = engineFolder() / "wcam" / "wcam-plugin-trial";
  const pid_t pid = ::access(program.c_str(), X_OK) == 0 ? start(program, manifest) : -1;
  if (pid < 0) {
    log::debug("plugin", "wcam-plugin-trial cannot be started; plugins are loaded without a trial");
    return {};
  }
  const auto end = std::chrono::steady_clock::now() + kPatience;
  int status = 0;
  while (true) {
    const pid_t done = ::waitpid(pid, &status, WNOHANG);
    if (done == pid) {
      break;
    }
    if ((done < 0 && errno != EINTR) || std::chrono::steady_clock::now() > end) {
      ::kill(pid, SIGKILL);
      (void)::waitpid(pid, &status, 0);
      return text("loading it does not come to an end within %1 s",
                  {std::to_string(kPatience.count())});
    }
    std::this_thread::sleep_for(kLook);
  }
  if (WIFSIGNALED(status)) {
    return text("loading it crashes (signal %1)", {std::to_string(WTERMSIG(status))});
  }
  const int code = WEXITSTATUS(status);
  return code == kTrialLoaded || code == kTrialRefused
             ? Text()
             : text("loading it ends the program (exit code %1)", {std::to_string(code)});
}

}  // namespace wcam::plugin
