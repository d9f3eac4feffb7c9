// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"
#include "wcam/process/process.hpp"

#include <cmath>
#include <cstdint>
#include <string_view>

/// Parameters within their limits, or an error of the file's kind.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const auto& schema = wcam::process::ProcessParams::schema();
    const auto params = schema.read(wcam::parseJson(text, "fuzz.json"), "fuzz.json");
    WCAM_ASSERT(std::isfinite(params.beadWidth.value()) && params.beadWidth.value() > 0.0);
    WCAM_ASSERT(std::isfinite(params.wireSpeed.value()));
  } catch (const wcam::Error& error) {
    WCAM_ASSERT(error.code() == wcam::ErrorCode::InvalidArgument ||
                error.code() == wcam::ErrorCode::InputInvalid);
  }
  return 0;
}
