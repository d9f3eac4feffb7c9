// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"

#include <cmath>
#include <cstdint>
#include <string_view>

/// The first byte chooses the kind, the rest is the text: a finite number comes out, or an error of
/// the caller's kind.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  constexpr int kKinds = static_cast<int>(wcam::QuantityKind::Ratio) + 1;
  const auto kind = static_cast<wcam::QuantityKind>(data[0] % kKinds);
  try {
    const double value = wcam::parseQuantity(
        std::string_view(reinterpret_cast<const char*>(data) + 1, size - 1), kind);
    WCAM_ASSERT(std::isfinite(value));
  } catch (const wcam::Error& error) {
    WCAM_ASSERT(error.code() == wcam::ErrorCode::InvalidArgument);
  }
  return 0;
}
