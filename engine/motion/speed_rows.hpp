// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/vector_clones.hpp"

#include <cstdint>

/// Eight joints at once, for the cloned inner loops of the speed law. Private to this module.
namespace wcam::motion::detail {

/// One value per joint. The compiler splits it where the registers are narrower.
using Row = double __attribute__((vector_size(64)));
/// All bits of a lane or none.
using RowBits = std::int64_t __attribute__((vector_size(64)));
inline constexpr int kRowLanes = 8;

// Rows are never passed to a function that is not inlined.
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

static WCAM_CLONED Row loadRow(const double* from) {
  Row row;
  __builtin_memcpy(&row, from, sizeof row);
  return row;
}

static WCAM_CLONED void storeRow(const Row& row, double* to) {
  __builtin_memcpy(to, &row, sizeof row);
}

static WCAM_CLONED Row sizeOf(const Row& row) {
  return (Row)((RowBits)row & INT64_MAX);  // without its sign
}

static WCAM_CLONED Row greater(const Row& a, const Row& b) {
  return a > b ? a : b;
}

/// The greatest lane.
static WCAM_CLONED double greatestOf(const Row& lanes) {
  Row row = greater(lanes, __builtin_shufflevector(lanes, lanes, 4, 5, 6, 7, 0, 1, 2, 3));
  row = greater(row, __builtin_shufflevector(row, row, 2, 3, 0, 1, 6, 7, 4, 5));
  row = greater(row, __builtin_shufflevector(row, row, 1, 0, 3, 2, 5, 4, 7, 6));
  return row[0];
}

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

}  // namespace wcam::motion::detail
