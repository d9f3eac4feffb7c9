// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/stage_cache.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace wcam::project {
namespace {

Staged<int> get(StageCache& cache, int number, const JobContext& context = JobContext()) {
  return cache.get<int>("square", StageKey("square", 1).text(std::to_string(number)).hex(), context,
                        [number](const JobContext& own) {
                          own.add({Severity::Warning, "square.of", std::to_string(number), {}});
                          return number * number;
                        });
}

TEST(StageCache, GivesBackResultAndFindings) {
  StageCache cache;
  const JobContext context;
  for (int i = 0; i < 2; ++i) {
    const Staged<int> staged = get(cache, 7, context);
    EXPECT_EQ(*staged.value, 49);
    ASSERT_EQ(staged.findings.size(), 1U);
    EXPECT_EQ(staged.findings[0].message, "7");
  }
  EXPECT_EQ(cache.runs("square"), 1U);
  EXPECT_EQ(cache.runs("cube"), 0U);
  // What a stage finds is handed over by whoever asked, not twice.
  EXPECT_TRUE(context.diagnostics().items().empty());
}

TEST(StageCache, TheLeastRecentlyUsedGoesFirst) {
  StageCache cache(2);
  (void)get(cache, 1);
  (void)get(cache, 2);
  (void)get(cache, 1);
  (void)get(cache, 3);
  EXPECT_EQ(cache.runs("square"), 3U);
  (void)get(cache, 1);
  EXPECT_EQ(cache.runs("square"), 3U);
  (void)get(cache, 2);
  EXPECT_EQ(cache.runs("square"), 4U);
}

TEST(StageCache, AFailedStageIsNotStored) {
  StageCache cache;
  const auto fail = [&] {
    (void)cache.get<int>("s", "key", JobContext(),
                         [](const JobContext&) -> int { throw CancelledError(); });
  };
  EXPECT_THROW(fail(), CancelledError);
  EXPECT_EQ(cache.runs("s"), 0U);
  EXPECT_EQ(*cache.get<int>("s", "key", JobContext(), [](const JobContext&) { return 5; }).value,
            5);
}

TEST(StageCache, ThreadsShareIt) {
  // Fewer places than keys: results come and go while others are read.
  StageCache cache(5);
  const ThreadLimit limit(8);
  std::vector<int> results(2000);
  parallelFor(results.size(), 1,
              [&](std::size_t i) { results[i] = *get(cache, static_cast<int>(i % 11)).value; });
  for (std::size_t i = 0; i < results.size(); ++i) {
    const int number = static_cast<int>(i % 11);
    EXPECT_EQ(results[i], number * number);
  }
}

}  // namespace
}  // namespace wcam::project
