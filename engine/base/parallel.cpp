// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace wcam {

struct ThreadLimit::Impl {
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads)
    : impl_(new Impl{
          tbb::global_control(tbb::global_control::max_allowed_parallelism,
                              threads > 0 ? static_cast<std::size_t>(threads)
                                          : std::max(1U, std::thread::hardware_concurrency()))}) {}

ThreadLimit::~ThreadLimit() = default;

void parallelForChunks(std::size_t count,
                       std::size_t grain,
                       const std::function<void(std::size_t, std::size_t)>& body,
                       const JobContext& context) {
  grain = std::max<std::size_t>(grain, 1);
  const std::size_t chunks = (count + grain - 1) / grain;
  if (chunks <= 1) {
    context.check();
    if (count > 0) {
      body(0, count);
    }
    return;
  }
  std::vector<std::exception_ptr> failures(chunks);
  std::atomic<std::size_t> firstFailure{chunks};
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, chunks, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t chunk = range.begin(); chunk < range.end(); ++chunk) {
          // Chunks below a failed one still run, so that the lowest failure is always the same one.
          if (chunk > firstFailure.load(std::memory_order_relaxed)) {
            continue;
          }
          try {
            context.check();
            body(chunk * grain, std::min(count, (chunk + 1) * grain));
          } catch (...) {
            failures[chunk] = std::current_exception();
            std::size_t known = firstFailure.load();
            while (chunk < known && !firstFailure.compare_exchange_weak(known, chunk)) {
            }
          }
        }
      },
      tbb::simple_partitioner());
  if (const std::size_t failed = firstFailure.load(); failed < chunks) {
    std::rethrow_exception(failures[failed]);
  }
}

}  // namespace wcam
