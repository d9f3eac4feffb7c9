// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/project/run.hpp"

#include <string>
#include <vector>

namespace wcam::project {

/// A picture for the report, as a data URI ("data:image/png;base64,...").
struct ReportPicture {
  std::string title;
  std::string uri;
};

/// The report of a run as one self-contained HTML page: figures, plots (SVG), joints, findings,
/// errors, files and the parameters that are set. Reads nothing from outside and depends on the run
/// alone.
std::string htmlReport(const Document& document,
                       const RunResult& result,
                       const std::vector<ReportPicture>& pictures = {});

}  // namespace wcam::project
