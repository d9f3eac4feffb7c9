// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/value.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace wcam::plugin {

enum class ComponentKind { Slicing, Post };
/// "slicing", "post"
const char* toString(ComponentKind kind) noexcept;

/// A component as its manifest announces it.
struct ComponentEntry {
  std::string id;
  ComponentKind kind = ComponentKind::Slicing;
  std::string name;
};

/// The JSON file beside a plugin library: what can be known without loading it (DESIGN 7).
struct Manifest {
  std::string id;  ///< reverse DNS: at least one dot
  std::string name;
  std::string version;  ///< MAJOR.MINOR.PATCH
  std::string vendor;
  std::string licence;  ///< SPDX expression
  int abiMajor = 0;
  int abiMinor = 0;
  std::string library;  ///< file name beside the manifest, no folders
  std::vector<ComponentEntry> components;
};

/// Longest manifest that is read, bytes.
inline constexpr std::size_t kMaxManifestSize = 1U << 20U;

/// Reads the text of a manifest. Keys id, name, version, vendor, licence, abi, library, kinds and
/// components are required; unknown keys are problems, except those that start with "x-".
/// @param context names the text in messages
/// @throws Error(PluginRefused) that lists every problem with its path
Manifest parseManifest(std::string_view text, const std::string& context);
/// @throws Error(PluginRefused), also for a file that cannot be read or is longer than
/// kMaxManifestSize
Manifest readManifest(const std::filesystem::path& file);

}  // namespace wcam::plugin
