// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"
#include "wcam/cell/cell.hpp"

#include <cstdint>
#include <string_view>

/// A cell whose joints are finite and whose robot can be solved, or an error of the file's kind.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const wcam::cell::Cell cell =
        wcam::cell::cellFromValue(wcam::parseJson(text, "fuzz.json"), "fuzz.json");
    WCAM_ASSERT(cell.inverse != nullptr && cell.jointCount() > 0);
  } catch (const wcam::Error& error) {
    WCAM_ASSERT(error.code() == wcam::ErrorCode::ProjectInvalid ||
                error.code() == wcam::ErrorCode::InputInvalid);
  }
  return 0;
}
