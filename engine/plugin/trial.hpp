// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/text.hpp"

#include <filesystem>

namespace wcam::plugin {

/// Exit codes of wcam-plugin-trial; any other one is the library's doing.
inline constexpr int kTrialLoaded = 42;
inline constexpr int kTrialRefused = 43;

/// Loads a plugin in a process of its own (wcam-plugin-trial beside the engine library), since code
/// of a library runs as soon as it is loaded. Why it must not be loaded here: it crashes, ends the
/// program or does not come back within 30 s. Empty when it comes back, be it with a refusal, and
/// when the trial cannot be made.
Text trialProblem(const std::filesystem::path& manifest);

}  // namespace wcam::plugin
