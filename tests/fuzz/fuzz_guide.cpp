// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/geometry/guide_curve.hpp"

#include <cstdint>
#include <string_view>

/// A guide of finite points whose chords end, or an error of the file's kind.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wcam::geometry;
  try {
    const auto guide =
        guideFromText(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.csv");
    const double length = guide->end() - guide->begin();
    WCAM_ASSERT(guide->evaluate(guide->begin() + 0.3 * length).p.allFinite());
    (void)chordSteps(*guide, 0.2 * length, guide->begin());
  } catch (const wcam::Error& error) {
    WCAM_ASSERT(error.code() == wcam::ErrorCode::InputInvalid ||
                error.code() == wcam::ErrorCode::JobFailed);
  }
  return 0;
}
