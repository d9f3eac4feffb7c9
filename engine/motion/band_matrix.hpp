// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace wcam::motion::detail {

/// Symmetric positive definite band matrix, lower half stored by rows, with its Cholesky solution:
/// n·w² operations for n rows and half bandwidth w. The normal equations of splines along a path
/// have this form; a general sparse solver would first have to find that out.
class BandMatrix {
public:
  BandMatrix(Eigen::Index size, Eigen::Index halfBand)
      : size_(size),
        width_(halfBand + 1),
        values_(static_cast<std::size_t>(size * (halfBand + 1)), 0.0) {}

  [[nodiscard]] Eigen::Index size() const { return size_; }

  /// Entry (i, k) with i − halfBand ≤ k ≤ i.
  double& at(Eigen::Index i, Eigen::Index k) {
    return values_[static_cast<std::size_t>(i * width_ + (k - i) + width_ - 1)];
  }

  [[nodiscard]] double at(Eigen::Index i, Eigen::Index k) const {
    return values_[static_cast<std::size_t>(i * width_ + (k - i) + width_ - 1)];
  }

  /// Solves (A + diag(extra))·x = b; false where that is not positive definite.
  bool solve(const Eigen::VectorXd& extra, const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

private:
  Eigen::Index size_;
  Eigen::Index width_;
  std::vector<double> values_;
};

}  // namespace wcam::motion::detail
