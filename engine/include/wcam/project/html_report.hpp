// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/project/report.hpp"
#include "wcam/project/run.hpp"

#include <string>

namespace wcam::project {

/// A run as one HTML page for people, with nothing beside it: figures, pictures of the paths, plots
/// of heights, speeds and joints, findings with their remedies, and the parameters. Made without a
/// display; the same run gives the same bytes.
std::string htmlReport(const Document& document, const RunResult& result);

}  // namespace wcam::project
