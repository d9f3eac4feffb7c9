// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/error.hpp"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace wcam::gui {

/// A job for the background. `run` gets the job's context; `done` is called on the owner's thread
/// with what went wrong, or nothing. A job that was replaced or cancelled ends with an error of
/// code Cancelled.
struct Job {
  std::string title;
  std::function<void(const JobContext&)> run;
  std::function<void(const std::optional<Error>&)> done;
};

/// One thread that runs one job at a time; a new job cancels the running one and takes the place of
/// the waiting one. Nothing that a job throws ends the program. Belongs to the owner's thread.
class JobRunner {
public:
  /// Calls a function later on the owner's thread.
  using Post = std::function<void(std::function<void()>)>;
  /// On the owner's thread, at most about 30 times a second.
  using Progress = std::function<void(double fraction, const std::string& label)>;

  explicit JobRunner(Post post);
  /// Cancels and waits for the running job; its `done` is not called any more.
  ~JobRunner();
  JobRunner(const JobRunner&) = delete;
  JobRunner& operator=(const JobRunner&) = delete;

  void setProgress(Progress progress);
  void start(Job job);
  void cancel();
  /// A job runs, waits, or has its `done` still to come.
  [[nodiscard]] bool busy() const;
  /// Calls a function on the owner's thread, unless the runner is gone by then. From any thread.
  void deliver(std::function<void()> function);

private:
  struct Shared;
  void loop();

  std::shared_ptr<Shared> shared_;
  std::thread thread_;
};

}  // namespace wcam::gui
