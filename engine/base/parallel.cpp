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

#ifdef WCAM_SANITIZED_THREADS
#include <sanitizer/tsan_interface.h>
#endif

namespace wcam {

namespace {

#ifdef WCAM_SANITIZED_THREADS
void release(char& place) {
  __tsan_release(&place);
}

void acquire(char& place) {
  __tsan_acquire(&place);
}
#else
void release(char& /*place*/) {}

void acquire(char& /*place*/) {}
#endif

/// Tells the thread sanitizer what TBB's library, which it does not see into, guarantees: what came
/// before the loop is visible in every chunk, and every chunk after the loop. Chunks stay unordered
/// among each other. Does nothing in other builds.
class LoopOrder {
public:
  LoopOrder() { release(fork_); }

  void chunkBegins() { acquire(fork_); }

  void chunkEnds() { release(join_); }

  void loopEnds() { acquire(join_); }

private:
  char fork_ = 0;
  char join_ = 0;
};

}  // namespace

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
  LoopOrder order;
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, chunks, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        order.chunkBegins();
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
        order.chunkEnds();
      },
      tbb::simple_partitioner());
  order.loopEnds();
  if (const std::size_t failed = firstFailure.load(); failed < chunks) {
    std::rethrow_exception(failures[failed]);
  }
}

}  // namespace wcam
