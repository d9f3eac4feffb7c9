// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/error.hpp"
#include "wcam/base/value.hpp"
#include "wcam/project/pipeline.hpp"

#include <string>
#include <vector>

namespace wcam::project {

/// Rows of DESIGN 11, one per point of a bead: header line, comma separated, dot decimals, LF.
/// Positions are written so that they read back as the same double. `arc` is 1 when the arc burns
/// on the move that ends at the point. Joints that could not be found are empty fields.
std::string operationTable(const OperationResult& result);

/// Figures of an operation: layers, beads, arc starts, lengths, volume, wire, time, ranges, joints,
/// findings by code.
Value operationReport(const OperationResult& result);

/// A file that a run has written or would write, relative to the output folder.
struct WrittenFile {
  std::string output;  ///< id of the output, empty for tables and the report
  std::string operation;
  std::string path;
  std::size_t bytes = 0;
  std::string sha256 = {};
};

/// An operation or output that gave no result.
struct RunFailure {
  Text place;  ///< "operation 'elbow'", empty for the whole run
  Error error;
  std::vector<Command> remedy = {};  ///< commands that put it right, tried; none: a hint
};

/// Version of report.json and of the tables; raised when a key changes its meaning or goes.
inline constexpr int kReportVersion = 1;

/// report.json: {"format": "wcam-report", "format_version", "project", "operations", "files",
/// "diagnostics", "errors"}; runProject adds "kept_back" and "provenance".
Value projectReport(const Document& document,
                    const std::vector<OperationResult>& results,
                    const std::vector<WrittenFile>& files,
                    const std::vector<Diagnostic>& projectFindings,
                    const std::vector<RunFailure>& failures);

/// The report of a run that could not begin: format, version and errors only.
Value failedReport(const RunFailure& failure);

}  // namespace wcam::project
