// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/plugin/host.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace wcam::plugin {

/// What a loaded library registered, by component id.
struct LoadedComponents {
  struct Slicing {
    ComponentInfo info;
    SlicingFactory factory;
  };

  struct Post {
    ComponentInfo info;
    PostFactory factory;
  };

  std::map<std::string, Slicing, std::less<>> slicing;
  std::map<std::string, Post, std::less<>> post;
};

/// Loads a library, does the handshake and lets it register. The library is never unloaded: its
/// code may be referenced by objects and by unique symbols until the process ends.
/// @throws Error(PluginRefused) with the reason
LoadedComponents loadLibrary(const Manifest& manifest, const std::filesystem::path& library);

/// Why a plugin of this ABI does not fit, or empty.
Text abiProblem(unsigned major, unsigned minor);

/// Wrappers that let no foreign exception and no bad result pass.
std::shared_ptr<const SlicingStrategy> guardSlicing(std::shared_ptr<const SlicingStrategy> strategy,
                                                    const std::string& plugin,
                                                    const std::string& component);
std::shared_ptr<const PostProcessor> guardPost(std::shared_ptr<const PostProcessor> post,
                                               const std::string& plugin,
                                               const std::string& component);

/// Text of the exception that is being handled, for any type.
Text currentExceptionText();

}  // namespace wcam::plugin
