// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "verbs.hpp"
#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace wcam::cli {

/// The option table: everything about the command line comes from it, the help and the completion
/// scripts as well.
class CommandLine {
public:
  CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// @return text to print for --help and --version, after which there is nothing to do
  /// @throws Error(InvalidArgument) with near names and the help to look at
  std::optional<std::string> parse(int argc, char** argv);

  [[nodiscard]] const Options& options() const noexcept { return options_; }

  [[nodiscard]] const CLI::App& app() const noexcept { return app_; }

  /// What to run; empty for `completion`.
  [[nodiscard]] int (*verb() const noexcept)(const Session&) { return verb_; }

private:
  void addSelection(CLI::App& target);
  void addCommon(CLI::App& target);
  CLI::App* addVerb(CLI::App& parent,
                    const char* name,
                    const char* help,
                    int (*function)(const Session&));
  void addFileVerbs();
  void addPlaceVerb();
  void addEditVerbs();
  void addOtherVerbs();
  void addSpeedVerb();
  [[nodiscard]] Error usageError(const CLI::ParseError& error) const;

  Options options_;
  CLI::App app_;
  int (*verb_)(const Session&) = nullptr;
  bool completion_ = false;
};

}  // namespace wcam::cli
