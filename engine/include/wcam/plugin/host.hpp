// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/plugin/manifest.hpp"
#include "wcam/plugin/registrar.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace wcam::plugin {

/// How a plugin was found, in the order of the search.
enum class PluginOrigin { Requested, Environment, User, Installed };
/// "requested", "environment", "user", "installed"
const char* toString(PluginOrigin origin) noexcept;

/// Where the host looks: first the files, then the folders, each in order.
struct PluginSearch {
  struct Folder {
    std::filesystem::path path;
    PluginOrigin origin = PluginOrigin::Environment;
  };

  std::vector<std::filesystem::path> files;  ///< `--plugin FILE`: a library or its manifest
  std::vector<Folder> folders;
};

/// The search order of DESIGN 7: the given files, WCAM_PLUGIN_PATH (colon separated), the user's
/// folder, the installed folder.
/// @param userPlugins false leaves out WCAM_PLUGIN_PATH and the user's folder, so that a run does
///   not depend on who runs it
PluginSearch defaultPluginSearch(std::vector<std::filesystem::path> files = {},
                                 bool userPlugins = true);

enum class PluginVerdict {
  Available,  ///< the manifest fits; the library was not needed yet
  Loaded,     ///< in use
  Shadowed,   ///< another plugin of the same id comes first in the search order
  Refused     ///< broken or not compatible
};
/// "available", "loaded", "shadowed", "refused"
const char* toString(PluginVerdict verdict) noexcept;

/// What became of one candidate.
struct PluginReport {
  std::filesystem::path path;  ///< manifest, or the library when there is no manifest
  PluginOrigin origin = PluginOrigin::Installed;
  std::string id;  ///< empty when the manifest cannot be read
  std::string name;
  std::string version;
  std::string abi;  ///< "1.0"
  PluginVerdict verdict = PluginVerdict::Refused;
  Text reason;  ///< why it is shadowed or refused
  std::vector<ComponentEntry> components;
};

/// A strategy that is ready for use. slice() turns whatever the plugin throws into
/// Error(JobFailed) that names plugin and component (a cancel stays a cancel), and refuses numbers
/// that are not finite.
struct SlicingComponent {
  ComponentInfo info;
  std::string plugin;  ///< id of the plugin
  std::string pluginVersion;
  std::shared_ptr<const SlicingStrategy> strategy;
};

/// A post-processor that is ready for use; errors as above. post() also refuses file names with
/// folders, reserved names and duplicates.
struct PostComponent {
  ComponentInfo info;
  std::string plugin;
  std::string pluginVersion;
  std::shared_ptr<const PostProcessor> post;
};

/// Finds plugins, checks them and hands out their components.
///
/// The constructor reads manifests only. A library is loaded when one of its components is asked
/// for, and stays loaded until the process ends. Of several plugins with one id the first in search
/// order wins, save that only a requested one wins over an installed one; a refused one never wins.
/// No broken plugin stops the start: see reports(). All members are thread-safe.
class PluginHost {
public:
  explicit PluginHost(const PluginSearch& search = defaultPluginSearch());
  ~PluginHost();
  PluginHost(const PluginHost&) = delete;
  PluginHost& operator=(const PluginHost&) = delete;

  /// All candidates in search order, by file name within a folder.
  [[nodiscard]] std::vector<PluginReport> reports() const;
  /// Components of all plugins that are available or loaded, by id. Loads nothing.
  [[nodiscard]] std::vector<ComponentEntry> components() const;
  /// Loads every available library, so that reports() has the final verdicts. Each is tried in a
  /// process of its own first: one that ends the program is refused.
  void loadAll() const;
  /// Likewise those of `--plugin` alone.
  void loadRequested() const;

  /// @throws Error(PluginMissing) with the nearest name and the places searched,
  ///   Error(PluginRefused) with the reason when the plugins that announce it are refused
  [[nodiscard]] std::shared_ptr<const SlicingComponent> findSlicing(std::string_view id) const;
  [[nodiscard]] std::shared_ptr<const PostComponent> findPost(std::string_view id) const;
  /// Description of a component of either kind; errors as above.
  [[nodiscard]] ComponentInfo info(std::string_view id) const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Everything that is wrong with a parameter declaration: empty or repeated keys, defaults outside
/// the limits, choices without keys, conditions on unknown keys. Empty when it is sound.
std::vector<std::string> schemaProblems(const ParamSchema& schema);

}  // namespace wcam::plugin
