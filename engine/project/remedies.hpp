// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/diagnostic.hpp"
#include "wcam/base/remedy.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/project/commands.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Remedies that stages propose, tried on the whole operation. Private to this module.
namespace wcam::project::detail {

/// A change of the project with the words for it.
struct Proposal {
  Text what;  ///< "turn the part on the table by +15 deg"
  std::vector<Command> commands;
};

/// Makes a proposal of the try_* figures of a finding (motion::explainFindings); nothing when it
/// has none, or the project cannot be changed that way.
using MakeProposal = std::function<std::optional<Proposal>(const Diagnostic&)>;

std::optional<Proposal> proposalOf(const Diagnostic& finding,
                                   const Document& document,
                                   const std::string& operation,
                                   const cell::Cell& cell,
                                   const std::filesystem::path& project);

/// What is found when commands are applied and the operation is computed again; nothing when it
/// cannot be.
using TryRemedy =
    std::function<std::optional<std::vector<Diagnostic>>(const std::vector<Command>&)>;

/// Findings with the commands that put each of them right; no commands: the remedy is a hint.
struct RemediedFindings {
  std::vector<Diagnostic> findings;
  std::vector<std::vector<Command>> commands;
};

/// The command of a setting.
Command setParam(const std::string& operation, const ParamSetting& setting);

/// The commands of settings that a stage has tried itself (wcam/base/remedy.hpp).
std::vector<std::vector<Command>> triedSettings(const std::vector<Diagnostic>& findings,
                                                const std::string& operation);

/// Tries the proposals of violations, those that most of them make first. The first one that leaves
/// no violation is offered with all of them; else the one that leaves fewest, without more of any
/// kind. What was tried and does not help stays a hint, and says so. The try_* figures go.
/// @param most number of tries
RemediedFindings triedRemedies(std::vector<Diagnostic> findings,
                               const MakeProposal& makeProposal,
                               const TryRemedy& tryRemedy,
                               std::size_t most);

}  // namespace wcam::project::detail
