// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"

#include <cstddef>
#include <functional>
#include <memory>

namespace wcam {

/// Upper bound on the threads of all parallel loops while the object lives (camcli --threads).
class ThreadLimit {
public:
  /// @param threads 0 means one per processor
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Calls body(begin, end) for the fixed chunks [0,grain), [grain,2·grain), … of [0,count).
///
/// Chunk borders depend on `grain` only, never on the number of threads: a body that writes results
/// by index (or per chunk) gives the same result on any machine. Cancel is looked at before each
/// chunk; of several exceptions the one of the lowest chunk is thrown.
void parallelForChunks(std::size_t count,
                       std::size_t grain,
                       const std::function<void(std::size_t, std::size_t)>& body,
                       const JobContext& context = JobContext());

/// body(i) for i in [0,count); see parallelForChunks.
template <class Body>
void parallelFor(std::size_t count,
                 std::size_t grain,
                 const Body& body,
                 const JobContext& context = JobContext()) {
  parallelForChunks(
      count, grain,
      [&body](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          body(i);
        }
      },
      context);
}

}  // namespace wcam
