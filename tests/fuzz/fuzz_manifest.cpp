// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/plugin/manifest.hpp"

#include <cstdint>
#include <string_view>

/// A manifest comes out that keeps its own rules, or the plugin is refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const wcam::plugin::Manifest manifest = wcam::plugin::parseManifest(
        std::string_view(reinterpret_cast<const char*>(data), size), "fuzz");
    WCAM_ASSERT(!manifest.id.empty() && !manifest.components.empty());
    WCAM_ASSERT(manifest.library.find('/') == std::string::npos &&
                manifest.library.ends_with(".so"));
    for (const wcam::plugin::ComponentEntry& entry : manifest.components) {
      WCAM_ASSERT(!entry.id.empty() && !entry.name.empty());
    }
  } catch (const wcam::Error& error) {
    WCAM_ASSERT(error.code() == wcam::ErrorCode::PluginRefused);
  }
  return 0;
}
