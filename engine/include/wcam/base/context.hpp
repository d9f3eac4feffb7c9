// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/diagnostic.hpp"

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

namespace wcam {

/// What every stage gets: nested progress 0..1, cancel, and a place for findings. A cheap handle:
/// copies share the same job. All members are thread-safe.
class JobContext {
public:
  /// Called with the overall fraction (monotone, 0..1) and the label of the innermost portion.
  using ProgressFunction = std::function<void(double fraction, const std::string& label)>;

  /// A job that nobody watches and nobody cancels.
  JobContext();
  explicit JobContext(std::stop_token stop, ProgressFunction progress = {});

  /// A part of this job from `begin` to `end` (fractions of this context's own range).
  [[nodiscard]] JobContext portion(double begin, double end, std::string label = {}) const;
  /// Reports the fraction done of this context's range. Never goes backwards.
  void report(double fraction) const;
  [[nodiscard]] bool cancelled() const noexcept;
  /// @throws CancelledError after a cancel request. Stages call it at least every 100 ms.
  void check() const;

  void add(Diagnostic diagnostic) const { diagnostics().add(std::move(diagnostic)); }

  [[nodiscard]] Diagnostics& diagnostics() const noexcept;
  /// A context with the same progress and cancel, and its own list of findings.
  [[nodiscard]] JobContext withOwnDiagnostics() const;

private:
  struct Job;
  std::shared_ptr<Job> job_;
  std::shared_ptr<Diagnostics> diagnostics_;
  double begin_ = 0.0;
  double end_ = 1.0;
  std::string label_;
};

}  // namespace wcam
