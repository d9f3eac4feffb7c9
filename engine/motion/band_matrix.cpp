// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "band_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

bool BandMatrix::solve(const Eigen::VectorXd& extra,
                       const Eigen::VectorXd& b,
                       Eigen::VectorXd& x) const {
  BandMatrix factor = *this;
  x = b;
  for (Eigen::Index i = 0; i < size_; ++i) {
    const Eigen::Index begin = std::max<Eigen::Index>(0, i - width_ + 1);
    for (Eigen::Index k = begin; k <= i; ++k) {
      double sum = at(i, k) + (k == i ? extra(i) : 0.0);
      const Eigen::Index first = std::max(begin, std::max<Eigen::Index>(0, k - width_ + 1));
      for (Eigen::Index m = first; m < k; ++m) {
        sum -= factor.at(i, m) * factor.at(k, m);
      }
      if (k == i) {
        if (!(sum > 0.0)) {
          return false;
        }
        factor.at(i, i) = std::sqrt(sum);
      } else {
        factor.at(i, k) = sum / factor.at(k, k);
      }
    }
    double sum = x(i);
    for (Eigen::Index k = begin; k < i; ++k) {
      sum -= factor.at(i, k) * x(k);
    }
    x(i) = sum / factor.at(i, i);
  }
  for (Eigen::Index i = size_; i-- > 0;) {
    x(i) /= factor.at(i, i);
    const Eigen::Index begin = std::max<Eigen::Index>(0, i - width_ + 1);
    for (Eigen::Index k = begin; k < i; ++k) {
      x(k) -= factor.at(i, k) * x(i);
    }
  }
  return x.allFinite();
}

}  // namespace wcam::motion::detail
