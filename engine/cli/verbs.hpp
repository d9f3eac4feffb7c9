// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/plugin/host.hpp"

#include "console.hpp"
#include "options.hpp"

#include <memory>
#include <string>

namespace CLI {
class App;
}

namespace wcam::cli {

/// What every verb works with. Each returns the exit code and throws Error for what cannot go on.
struct Session {
  const Options& options;
  const Console& console;
  JobContext context;
  std::shared_ptr<const plugin::PluginHost> plugins;
};

int runProjectVerb(const Session& session);
int newVerb(const Session& session);
int editAddVerb(const Session& session);
int editListVerb(const Session& session);
int editMoveVerb(const Session& session);
int editRemoveVerb(const Session& session);
int editSetVerb(const Session& session);
int editTypesVerb(const Session& session);
int infoVerb(const Session& session);
int applyVerb(const Session& session);
int checkVerb(const Session& session);
int placeVerb(const Session& session);
int pluginsListVerb(const Session& session);
int schemaVerb(const Session& session);
int speedVerb(const Session& session);
/// Completion script for "bash" or "zsh", from the option table itself.
std::string completionScript(const CLI::App& app, const std::string& shell);

}  // namespace wcam::cli
