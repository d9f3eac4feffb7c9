// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"

#include "wcam/base/error.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

namespace wcam {
namespace {

constexpr int kThreads[] = {1, 2, 8};

TEST(ParallelFor, ResultsDoNotDependOnTheThreads) {
  std::vector<std::vector<double>> results;
  for (const int threads : kThreads) {
    const ThreadLimit limit(threads);
    // A sum per chunk: its rounding depends on the borders of the chunks only.
    std::vector<double> sums(100003 / 97 + 1, 0.0);
    parallelForChunks(100003, 97, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        sums[begin / 97] += std::sin(static_cast<double>(i)) * 1e-3;
      }
    });
    results.push_back(sums);
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

TEST(ParallelFor, EveryIndexOnce) {
  for (const std::size_t count : {0U, 1U, 6U, 7U, 8U, 1000U}) {
    for (const std::size_t grain : {std::size_t{0}, std::size_t{1}, std::size_t{7},
                                    std::size_t{5000}, std::numeric_limits<std::size_t>::max()}) {
      std::vector<std::atomic<int>> hits(count);
      parallelFor(count, grain, [&](std::size_t i) { ++hits[i]; });
      for (const auto& hit : hits) {
        ASSERT_EQ(hit.load(), 1) << count << " " << grain;
      }
    }
  }
}

TEST(ParallelFor, TheLowestExceptionWins) {
  for (const int threads : kThreads) {
    const ThreadLimit limit(threads);
    for (int repeat = 0; repeat < 50; ++repeat) {
      try {
        parallelFor(500, 1, [](std::size_t i) {
          if (i % 100 == 37) {
            throw Error(ErrorCode::JobFailed, std::to_string(i));
          }
        });
        FAIL();
      } catch (const Error& error) {
        ASSERT_STREQ(error.what(), "37");
      }
    }
  }
}

TEST(ParallelFor, CancelIsSeenBetweenChunks) {
  std::stop_source source;
  const JobContext context(source.get_token());
  std::atomic<int> calls = 0;
  EXPECT_THROW(parallelFor(
                   100000, 10,
                   [&](std::size_t) {
                     if (++calls == 100) {
                       source.request_stop();
                     }
                   },
                   context),
               CancelledError);
  EXPECT_LT(calls.load(), 100000 / 2);
  EXPECT_THROW(parallelFor(
                   1, 10, [](std::size_t) {}, context),
               CancelledError);
  EXPECT_THROW(parallelFor(
                   0, 10, [](std::size_t) {}, context),
               CancelledError);
}

TEST(ParallelFor, Nests) {
  std::vector<std::vector<std::size_t>> table(20);
  parallelFor(20, 1, [&](std::size_t i) {
    table[i].resize(50);
    parallelFor(50, 3, [&](std::size_t j) { table[i][j] = i * j; });
  });
  EXPECT_EQ(table[19][49], 19U * 49U);
}

}  // namespace
}  // namespace wcam
