// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/motion/trace.hpp"

#include <cstdint>
#include <string_view>

/// Rows of ascending times and finite speeds, or an error of the file's kind.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const wcam::cell::Cell cell = wcam::cell::loadCell(WCAM_FUZZ_CELL);
  try {
    const auto trace =
        wcam::motion::parseMotorTrace(std::string_view(reinterpret_cast<const char*>(data), size),
                                      cell, "fuzz.csv", wcam::JobContext());
    WCAM_ASSERT(trace.time.size() >= 2 && trace.rpm.size() == trace.time.size());
    for (std::size_t i = 0; i < trace.time.size(); ++i) {
      WCAM_ASSERT(trace.rpm[i].allFinite() && (i == 0 || trace.time[i] > trace.time[i - 1]));
    }
  } catch (const wcam::Error& error) {
    WCAM_ASSERT(error.code() == wcam::ErrorCode::InputInvalid);
  }
  return 0;
}
