// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "job_runner.hpp"

#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <new>

namespace wcam::gui {

struct JobRunner::Shared {
  explicit Shared(Post p) : post(std::move(p)) {}

  Post post;
  Progress progress;  // owner's thread
  bool alive = true;  // owner's thread
  std::atomic<int> open = 0;
  std::mutex mutex;
  std::condition_variable wake;
  std::optional<Job> waiting;
  std::stop_source stop{std::nostopstate};
  bool quit = false;
};

namespace {

/// On few processors the window comes before what is computed for it. Linux keeps a priority for
/// each thread, and threads and programs that a job starts inherit it.
void stepBack() {
  constexpr int kNice = 5;
  static_cast<void>(setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + kNice));
}

/// Runs a job; everything that it throws becomes an Error.
std::optional<Error> outcomeOf(const Job& job, const JobContext& context) {
  try {
    job.run(context);
    return std::nullopt;
  } catch (const Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return Error(ErrorCode::JobFailed, "there is not enough memory", job.title,
                 "use a coarser part or step");
  } catch (const std::exception& error) {
    return Error(ErrorCode::Internal, error.what(), job.title,
                 "please report this with the project file");
  } catch (...) {
    return Error(ErrorCode::Internal, "an unknown exception", job.title,
                 "please report this with the project file");
  }
}

}  // namespace

JobRunner::JobRunner(Post post) : shared_(std::make_shared<Shared>(std::move(post))) {
  thread_ = std::thread([this] { loop(); });
}

JobRunner::~JobRunner() {
  shared_->alive = false;
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->quit = true;
    shared_->waiting.reset();
    shared_->stop.request_stop();
  }
  shared_->wake.notify_all();
  thread_.join();
}

void JobRunner::setProgress(Progress progress) {
  shared_->progress = std::move(progress);
}

void JobRunner::start(Job job) {
  std::optional<Job> replaced;
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->stop.request_stop();
    replaced = std::move(shared_->waiting);
    shared_->waiting = std::move(job);
    ++shared_->open;
  }
  shared_->wake.notify_all();
  if (replaced) {
    --shared_->open;
    if (replaced->done) {
      replaced->done(CancelledError());
    }
  }
}

void JobRunner::cancel() {
  std::optional<Job> replaced;
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->stop.request_stop();
    replaced = std::move(shared_->waiting);
    shared_->waiting.reset();
  }
  if (replaced) {
    --shared_->open;
    if (replaced->done) {
      replaced->done(CancelledError());
    }
  }
}

bool JobRunner::busy() const {
  return shared_->open > 0;
}

void JobRunner::deliver(std::function<void()> function) {
  shared_->post([shared = shared_, call = std::move(function)] {
    if (shared->alive) {
      call();
    }
  });
}

void JobRunner::loop() {
  const std::shared_ptr<Shared> shared = shared_;
  stepBack();
  for (;;) {
    Job job;
    std::stop_source stop;
    {
      std::unique_lock lock(shared->mutex);
      shared->wake.wait(lock, [&] { return shared->quit || shared->waiting.has_value(); });
      if (shared->quit) {
        return;
      }
      job = std::move(*shared->waiting);
      shared->waiting.reset();
      shared->stop = stop;
    }
    using Clock = std::chrono::steady_clock;
    auto last = std::make_shared<std::atomic<Clock::rep>>(0);
    const JobContext context(
        stop.get_token(), [shared, last](double fraction, const std::string& label) {
          constexpr auto kPause = std::chrono::milliseconds(100);
          const Clock::rep now = Clock::now().time_since_epoch().count();
          Clock::rep before = last->load();
          if (now - before < std::chrono::duration_cast<Clock::duration>(kPause).count() ||
              !last->compare_exchange_strong(before, now)) {
            return;
          }
          shared->post([shared, fraction, label] {
            if (shared->alive && shared->progress) {
              shared->progress(fraction, label);
            }
          });
        });
    const std::optional<Error> outcome = outcomeOf(job, context);
    shared->post([shared, done = job.done, outcome] {
      --shared->open;
      if (shared->alive && done) {
        done(outcome);
      }
    });
  }
}

}  // namespace wcam::gui
