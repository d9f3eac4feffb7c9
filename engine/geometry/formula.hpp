// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace wcam::geometry {

/// A formula of named variables: numbers, pi, + - * / ^, comparisons and the usual functions. Not
/// for use by two threads at once. Internal to module geometry and the readers of module io.
class Formula {
public:
  /// @param context the place, for messages ("guide formula x(t)")
  /// @throws Error(InvalidArgument) naming the formula and the position
  Formula(const std::string& text,
          const std::vector<std::string>& variables,
          const std::string& context);
  ~Formula();
  Formula(Formula&&) noexcept;
  Formula& operator=(Formula&&) noexcept;

  /// Value at the variables in their order; missing ones are 0. May be infinite or NaN.
  [[nodiscard]] double operator()(double first = 0.0, double second = 0.0) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wcam::geometry
