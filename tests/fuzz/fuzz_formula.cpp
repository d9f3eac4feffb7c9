// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"

#include "formula.hpp"

#include <cstdint>
#include <string>

/// A formula that has a value wherever it is asked, or an error of the caller's kind.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const wcam::geometry::Formula formula(std::string(reinterpret_cast<const char*>(data), size),
                                          {"t"}, "fuzz");
    // Equal arguments, equal values: no formula changes its variable.
    const double first = formula(0.25);
    (void)formula(-3.0);
    const double again = formula(0.25);
    WCAM_ASSERT(first == again || (first != first && again != again));
  } catch (const wcam::Error& error) {
    WCAM_ASSERT(error.code() == wcam::ErrorCode::InvalidArgument);
  }
  return 0;
}
