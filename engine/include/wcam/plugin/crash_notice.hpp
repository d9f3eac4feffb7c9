// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace wcam::plugin {

/// Says on standard error which plugin and component ran when the program is ended by a crash, by
/// abort() or by exit() inside a plugin, and lets the program end as it would have (with exit code
/// 6 after exit()). Called once, at the start of a program.
/// @param program name that begins the line, a string literal
void nameCrashes(const char* program);

/// While it lives, the calling thread runs code of a plugin.
class PluginCall {
public:
  /// @param component empty while a library is loaded
  PluginCall(const std::string& plugin, const std::string& component);
  ~PluginCall();
  PluginCall(const PluginCall&) = delete;
  PluginCall& operator=(const PluginCall&) = delete;

private:
  int slot_;    ///< of the names that a signal handler can write; -1 when all are taken
  int before_;  ///< of the call around this one, of the same thread
};

}  // namespace wcam::plugin
