// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/error.hpp"
#include "wcam/base/output_set.hpp"
#include "wcam/project/pipeline.hpp"
#include "wcam/project/report.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wcam::project {

/// What to do with a project: the same request comes from camcli and from the front-end.
struct RunRequest {
  std::filesystem::path folder;         ///< output folder; made when missing
  std::vector<std::string> operations;  ///< ids; empty: all enabled ones
  std::vector<std::string>
      posts;               ///< ids of outputs or of post-processors; empty: all stored outputs
  bool tables = false;     ///< also write <operation>.csv
  bool checkOnly = false;  ///< compute and look, write nothing
  /// Outputs may have a folder that is absolute or leaves the output folder by "..".
  bool allowOutside = false;
  /// What else the caller reads and writes, such as a report. The run adds its own files.
  OutputPlan plan = {};
  /// The project as it is stored, where settings for this run have changed the pipeline's.
  std::optional<Document> stored = {};
  std::vector<std::string> settings = {};  ///< those settings, KEY=VALUE, for the report
};

/// A program that is not written, since checks are violated.
struct KeptBack {
  std::string operation;
  std::string output;  ///< empty: all outputs of the operation, by its own violations
};

struct RunResult {
  /// Those that could be computed. Their findings include those of their outputs.
  std::vector<OperationResult> operations;
  std::vector<WrittenFile> files;
  std::vector<RunFailure> failures;
  std::vector<Diagnostic> projectFindings;  ///< of the project and its files: changed hashes, ...
  /// Files that the report of an earlier run in the folder names and this run has not written: they
  /// may be out of date.
  std::vector<std::string> leftFiles;
  std::vector<KeptBack> keptBack;
  std::size_t violations = 0;  ///< operations with violations
  bool written = false;        ///< false for a check, and when no operation could be computed
  Value report;                ///< report.json

  /// 0, 5 for violations, else the code of the first failure.
  [[nodiscard]] int exitCode() const;
};

/// What the post-processor of an output makes of an operation.
struct PrintedOutput {
  std::vector<plugin::OutputFile> files;  ///< none with a violation
  std::vector<Diagnostic> findings;       ///< with operation and output named
  std::optional<Error> error;             ///< why there are no files
};

/// Runs the post-processor of an output. @throws CancelledError
PrintedOutput printOutput(const Pipeline& pipeline,
                          const Output& output,
                          const OperationResult& operation,
                          const JobContext& context);

/// Does an output print this operation?
bool prints(const Output& output, const std::string& operation);

/// Computes the operations and writes their programs, tables and report.json. Everything is
/// computed before the first file is written, and the files are replaced together (OutputSet), so
/// that a failure or a cancel leaves no half-written output, and no empty folder. An operation with
/// violations gets no robot program: its findings say why. So do those of an output, whose program
/// is then kept back alone. A failing operation does not stop the others; when all fail, nothing is
/// written.
/// @throws Error for problems of the request or the whole project: ProjectReadOnly for a project of
/// a newer format, since a robot program made from what is understood of it could be wrong;
/// PluginMissing for a post that is neither an output nor a component; OutputConflict for outputs
/// that would replace inputs or each other, or leave the folder; CancelledError
RunResult runProject(const Pipeline& pipeline,
                     const RunRequest& request,
                     const JobContext& context);

}  // namespace wcam::project
