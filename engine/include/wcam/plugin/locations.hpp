// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

/// Where an installed WCAM keeps its parts. The build tree has the same layout, and every folder is
/// found relative to the engine library, so that an installation can be moved as a whole.
namespace wcam::plugin {

/// Folder of the engine library.
std::filesystem::path engineFolder();
/// Plugins that came with this installation: <engine folder>/wcam/plugins/<ABI major>.
std::filesystem::path installedPluginFolder();
/// Plugins of this user: $XDG_DATA_HOME/wcam/plugins/<ABI major>, by default below
/// ~/.local/share. Empty when neither variable is set.
std::filesystem::path userPluginFolder();
/// Cells, processes, projects, documentation and schemas of this installation (share/wcam).
std::filesystem::path dataFolder();

}  // namespace wcam::plugin
