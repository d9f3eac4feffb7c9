// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model/job_runner.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <stdexcept>

namespace wcam::gui {
namespace {

/// An owner's thread with a queue, without Qt.
class Queue {
public:
  JobRunner::Post post() {
    return [this](std::function<void()> call) {
      {
        const std::lock_guard lock(mutex_);
        calls_.push_back(std::move(call));
      }
      wake_.notify_all();
    };
  }

  /// Runs what is posted until something holds.
  void runUntil(const std::function<bool()>& holds) {
    while (!holds()) {
      std::function<void()> call;
      {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, [this] { return !calls_.empty(); });
        call = std::move(calls_.front());
        calls_.pop_front();
      }
      call();
    }
  }

private:
  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> calls_;
};

/// Works until it is cancelled.
void endless(const JobContext& context) {
  for (;;) {
    context.check();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(JobRunner, RunsAJobAndTellsItsEndOnTheOwnersThread) {
  Queue queue;
  JobRunner runner(queue.post());
  std::thread::id ranOn;
  std::thread::id doneOn;
  bool done = false;
  runner.start({"job", [&](const JobContext&) { ranOn = std::this_thread::get_id(); },
                [&](const std::optional<Error>& error) {
                  EXPECT_FALSE(error);
                  doneOn = std::this_thread::get_id();
                  done = true;
                }});
  queue.runUntil([&] { return done; });
  EXPECT_NE(ranOn, std::this_thread::get_id());
  EXPECT_EQ(doneOn, std::this_thread::get_id());
  EXPECT_FALSE(runner.busy());
}

TEST(JobRunner, ANewJobCancelsTheOldOne) {
  Queue queue;
  JobRunner runner(queue.post());
  int cancelled = 0;
  bool done = false;
  const auto count = [&](const std::optional<Error>& error) {
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code(), ErrorCode::Cancelled);
    ++cancelled;
  };
  runner.start({"first", endless, count});
  runner.start({"second", endless, count});
  runner.start({"third", [](const JobContext&) {},
                [&](const std::optional<Error>& error) {
                  EXPECT_FALSE(error);
                  done = true;
                }});
  queue.runUntil([&] { return done; });
  EXPECT_EQ(cancelled, 2);
}

TEST(JobRunner, WhateverAJobThrowsBecomesAnError) {
  Queue queue;
  JobRunner runner(queue.post());
  std::optional<Error> got;
  bool done = false;
  const auto run = [&](std::function<void(const JobContext&)> job) {
    done = false;
    runner.start({"job", std::move(job), [&](const std::optional<Error>& error) {
                    got.reset();
                    if (error) {
                      got.emplace(*error);
                    }
                    done = true;
                  }});
    queue.runUntil([&] { return done; });
  };
  run([](const JobContext&) { throw Error(ErrorCode::InputInvalid, "bad", "file"); });
  EXPECT_EQ(got->code(), ErrorCode::InputInvalid);
  run([](const JobContext&) { throw std::runtime_error("surprise"); });
  EXPECT_EQ(got->code(), ErrorCode::Internal);
  run([](const JobContext&) { throw std::bad_alloc(); });
  EXPECT_EQ(got->code(), ErrorCode::JobFailed);
  run([](const JobContext&) { throw 7; });
  EXPECT_EQ(got->code(), ErrorCode::Internal);
  run([](const JobContext&) {});
  EXPECT_FALSE(got);
}

TEST(JobRunner, EndsWhileAJobRunsWithoutCallingBack) {
  Queue queue;
  bool called = false;
  std::atomic<bool> began = false;
  {
    JobRunner runner(queue.post());
    runner.start({"endless",
                  [&](const JobContext& context) {
                    began = true;
                    endless(context);
                  },
                  [&](const std::optional<Error>&) { called = true; }});
    while (!began) {
      std::this_thread::yield();
    }
  }
  // What is still posted finds that nobody is there.
  bool last = false;
  queue.post()([&] { last = true; });
  queue.runUntil([&] { return last; });
  EXPECT_FALSE(called);
}

TEST(JobRunner, CancelReachesTheRunningJob) {
  Queue queue;
  JobRunner runner(queue.post());
  std::optional<ErrorCode> code;
  std::atomic<bool> began = false;
  runner.start({"endless",
                [&](const JobContext& context) {
                  began = true;
                  endless(context);
                },
                [&](const std::optional<Error>& error) { code = error->code(); }});
  while (!began) {
    std::this_thread::yield();
  }
  runner.cancel();
  queue.runUntil([&] { return code.has_value(); });
  EXPECT_EQ(*code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace wcam::gui
