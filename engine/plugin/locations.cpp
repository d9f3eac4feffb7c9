// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/locations.hpp"

#include "wcam/base/error.hpp"
#include "wcam/plugin/abi.h"

#include <dlfcn.h>

#include <cstdlib>
#include <string>

namespace wcam::plugin {

namespace fs = std::filesystem;

namespace {

fs::path pluginSubfolder() {
  return fs::path("wcam") / "plugins" / std::to_string(WCAM_PLUGIN_ABI_MAJOR);
}

/// Empty when unset or, as the XDG specification asks, when not absolute.
fs::path absoluteFromEnvironment(const char* variable) {
  const char* text = std::getenv(variable);
  const fs::path path = text == nullptr ? "" : text;
  return path.is_absolute() ? path : fs::path();
}

}  // namespace

fs::path engineFolder() {
  static const fs::path kFolder = [] {
    Dl_info info{};
    static const char kAnchor = 0;
    WCAM_ASSERT(dladdr(&kAnchor, &info) != 0 && info.dli_fname != nullptr);
    return fs::weakly_canonical(fs::absolute(info.dli_fname)).parent_path();
  }();
  return kFolder;
}

fs::path installedPluginFolder() {
  return engineFolder() / pluginSubfolder();
}

fs::path userPluginFolder() {
  fs::path data = absoluteFromEnvironment("XDG_DATA_HOME");
  if (data.empty()) {
    const fs::path home = absoluteFromEnvironment("HOME");
    data = home.empty() ? home : home / ".local" / "share";
  }
  return data.empty() ? data : data / pluginSubfolder();
}

fs::path dataFolder() {
  return (engineFolder() / WCAM_DATA_FROM_LIBRARY).lexically_normal();
}

}  // namespace wcam::plugin
