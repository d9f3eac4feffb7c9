// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/text.hpp"

#include <filesystem>

namespace wcam::plugin {

/// Why a library must not be loaded: somebody else could have written it. The file, its folder and
/// the folders above belong to the user, to root or to whoever installed the engine, nobody else
/// may write them, and the file is no link out of its folder. Empty when all is well or there is no
/// file.
Text trustProblem(const std::filesystem::path& library);

}  // namespace wcam::plugin
