// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/context.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <thread>
#include <vector>

namespace wcam {
namespace {

using ::testing::ElementsAre;

class Progress : public ::testing::Test {
protected:
  JobContext context() {
    return JobContext(source_.get_token(), [this](double fraction, const std::string& label) {
      fractions_.push_back(fraction);
      labels_.push_back(label);
    });
  }

  std::stop_source source_;
  std::vector<double> fractions_;
  std::vector<std::string> labels_;
};

TEST_F(Progress, NestsByPortion) {
  const JobContext job = context();
  const JobContext second = job.portion(0.5, 1.0, "second");
  const JobContext half = second.portion(0.0, 0.5);
  half.report(0.5);
  second.portion(0.5, 1.0, "last").report(1.0);
  EXPECT_THAT(fractions_, ElementsAre(0.625, 1.0));
  EXPECT_THAT(labels_, ElementsAre("second", "last"));
}

TEST_F(Progress, NeverGoesBackwardsNorBeyondItsRange) {
  const JobContext job = context();
  job.report(0.5);
  job.report(0.25);
  job.portion(0.0, 0.4).report(1.0);
  job.report(0.5);
  job.report(7.0);
  job.report(std::numeric_limits<double>::quiet_NaN());
  job.portion(2.0, -1.0).report(0.5);
  job.portion(-3.0, 9.0).report(-2.0);
  EXPECT_THAT(fractions_, ElementsAre(0.5, 1.0));
}

TEST_F(Progress, IsMonotoneFromSeveralThreads) {
  const JobContext job = context();
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([part = job.portion(t / 4.0, (t + 1) / 4.0)] {
      for (int i = 0; i <= 1000; ++i) {
        part.report(i / 1000.0);
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_TRUE(std::is_sorted(fractions_.begin(), fractions_.end()));
  EXPECT_EQ(fractions_.back(), 1.0);
}

TEST_F(Progress, CancelReachesEveryPortion) {
  const JobContext job = context();
  const JobContext part = job.portion(0.2, 0.4).withOwnDiagnostics();
  EXPECT_NO_THROW(part.check());
  source_.request_stop();
  EXPECT_TRUE(part.cancelled());
  EXPECT_THROW(part.check(), CancelledError);
  try {
    job.check();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::Cancelled);
    EXPECT_EQ(exitCodeOf(error.code()), 130);
  }
}

TEST(JobContext, FindingsAreSharedUnlessOwn) {
  const JobContext job;
  job.portion(0.0, 0.5).add({Severity::Warning, "a.b", "text", {}, {}, {}});
  job.withOwnDiagnostics().add({Severity::Warning, "a.c", "text", {}, {}, {}});
  EXPECT_EQ(job.diagnostics().count("a.b"), 1U);
  EXPECT_EQ(job.diagnostics().count("a.c"), 0U);
  EXPECT_FALSE(job.cancelled());
  job.report(1.0);
}

class Log : public ::testing::Test {
protected:
  ~Log() override { log::setSink({}); }

  log::Sink collect() {
    return [this](const log::Record& record) {
      lines_.push_back(record.domain + " " + record.message);
    };
  }

  std::vector<std::string> lines_;
};

TEST_F(Log, KeepsRecordsUntilThereIsASink) {
  log::setSink([](const log::Record&) {});
  log::setSink({});
  log::info("io", "before");
  log::setSink(collect());
  log::warning("io", "after");
  EXPECT_THAT(lines_, ElementsAre("io before", "io after"));
}

TEST_F(Log, KeepsTheLastThousand) {
  log::setSink([](const log::Record&) {});
  log::setSink({});
  for (int i = 0; i < 1500; ++i) {
    log::debug("a", std::to_string(i));
  }
  log::setSink(collect());
  ASSERT_EQ(lines_.size(), 1000U);
  EXPECT_EQ(lines_.front(), "a 500");
}

TEST_F(Log, CallsAreSerialised) {
  log::setSink(collect());
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([] {
      for (int i = 0; i < 500; ++i) {
        log::write(log::Level::Error, "t", "m");
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(lines_.size(), 2000U);
}

}  // namespace
}  // namespace wcam
