// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/toolpath/import_table.hpp"

#include <cstdint>
#include <string_view>

/// Layers of beads of finite points, or an error of the file's kind.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto path =
        wcam::toolpath::readPathTable(std::string_view(reinterpret_cast<const char*>(data), size),
                                      "fuzz.csv", wcam::JobContext());
    WCAM_ASSERT(!path.layers.empty());
    for (const auto& layer : path.layers) {
      for (const auto& contour : layer) {
        WCAM_ASSERT(contour.points.size() >= 2);
        for (const auto& point : contour.points) {
          WCAM_ASSERT(point.p.allFinite() && point.n.allFinite() && point.axis.allFinite());
        }
      }
    }
  } catch (const wcam::Error& error) {
    WCAM_ASSERT(error.code() == wcam::ErrorCode::InputInvalid);
  }
  return 0;
}
