// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/context.hpp"

#include "wcam/base/error.hpp"

#include <algorithm>
#include <mutex>

namespace wcam {

struct JobContext::Job {
  std::stop_token stop;
  ProgressFunction progress;
  std::mutex mutex;
  double reported = -1.0;
};

JobContext::JobContext() : JobContext(std::stop_token{}) {}

JobContext::JobContext(std::stop_token stop, ProgressFunction progress)
    : job_(std::make_shared<Job>()), diagnostics_(std::make_shared<Diagnostics>()) {
  job_->stop = std::move(stop);
  job_->progress = std::move(progress);
}

JobContext JobContext::portion(double begin, double end, std::string label) const {
  JobContext part(*this);
  const double width = end_ - begin_;
  begin = std::clamp(begin, 0.0, 1.0);
  part.begin_ = begin_ + begin * width;
  part.end_ = begin_ + std::clamp(end, begin, 1.0) * width;
  if (!label.empty()) {
    part.label_ = std::move(label);
  }
  return part;
}

void JobContext::report(double fraction) const {
  if (!job_->progress) {
    return;
  }
  const double overall = begin_ + std::clamp(fraction, 0.0, 1.0) * (end_ - begin_);
  const std::lock_guard lock(job_->mutex);
  if (overall > job_->reported) {
    job_->reported = overall;
    job_->progress(overall, label_);
  }
}

bool JobContext::cancelled() const noexcept {
  return job_->stop.stop_requested();
}

void JobContext::check() const {
  if (cancelled()) {
    throw CancelledError();
  }
}

Diagnostics& JobContext::diagnostics() const noexcept {
  return *diagnostics_;
}

JobContext JobContext::withOwnDiagnostics() const {
  JobContext own(*this);
  own.diagnostics_ = std::make_shared<Diagnostics>();
  return own;
}

}  // namespace wcam
