// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/run.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/sha256.hpp"
#include "wcam/base/text.hpp"
#include "wcam/project/project_file.hpp"
#include "wcam/project/provenance.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <optional>
#include <system_error>

namespace wcam::project {

namespace {

constexpr const char* kReportFile = "report.json";

struct PendingFile {
  WrittenFile file;
  std::string content;
};

/// The output folder, looked at before the long work; what was made for it goes again when the run
/// ends without a file.
class OutputFolder {
public:
  explicit OutputFolder(const std::filesystem::path& folder) {
    std::error_code ignored;
    for (std::filesystem::path path = std::filesystem::absolute(folder, ignored).lexically_normal();
         !std::filesystem::exists(path, ignored) && path.has_relative_path();
         path = path.parent_path()) {
      made_.push_back(path);
    }
    createFolder(folder);
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
      throw Error(
          ErrorCode::OutputConflict,
          text("the folder cannot be written to: %1", {std::generic_category().message(errno)}),
          pathText(folder), "choose a folder that you may write to");
    }
  }

  ~OutputFolder() {
    std::error_code ignored;
    for (const std::filesystem::path& path : made_) {
      // Removes empty folders only.
      std::filesystem::remove(path, ignored);
    }
  }

  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

private:
  std::vector<std::filesystem::path> made_;  ///< the innermost first
};

/// Each once, in the order of their first mention.
std::vector<std::string> withoutRepeats(const std::vector<std::string>& names) {
  std::vector<std::string> unique;
  for (const std::string& name : names) {
    if (std::find(unique.begin(), unique.end(), name) == unique.end()) {
      unique.push_back(name);
    }
  }
  return unique;
}

std::vector<std::string> operationIds(const Project& project, const RunRequest& request) {
  std::vector<std::string> known;
  std::vector<std::string> ids = withoutRepeats(request.operations);
  for (const Operation& operation : project.operations) {
    known.push_back(operation.id);
    if (request.operations.empty() && operation.enabled) {
      ids.push_back(operation.id);
    }
  }
  if (ids.empty()) {
    throw Error(ErrorCode::ProjectInvalid, "the project has no enabled operation", {},
                "add an operation or enable one");
  }
  for (const std::string& id : ids) {
    if (std::find(known.begin(), known.end(), id) == known.end()) {
      const auto near = nearestName(id, known);
      throw Error(ErrorCode::InvalidArgument, text("the project has no operation '%1'", {id}), {},
                  near ? text("did you mean '%1'?", {*near})
                       : text("operations: %1", {joinText(known, ", ")}));
    }
  }
  return ids;
}

/// An output with the defaults of a post-processor that the project does not store.
Output freshOutput(const Pipeline& pipeline, const std::string& name) {
  try {
    (void)pipeline.plugins().findPost(name);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::PluginMissing) {
      throw;
    }
    std::vector<std::string> known;
    for (const Output& output : pipeline.document().project().outputs) {
      known.push_back(output.id);
    }
    for (const plugin::ComponentEntry& component : pipeline.plugins().components()) {
      if (component.kind == plugin::ComponentKind::Post) {
        known.push_back(component.id);
      }
    }
    const auto near = nearestName(name, known);
    throw Error(ErrorCode::PluginMissing,
                text("'%1' is no output of the project, and no plugin provides it", {name}), {},
                near ? text("did you mean '%1'?", {*near})
                     : text("there are: %1", {joinText(known, ", ")}));
  }
  Output fresh;
  fresh.id = name;
  fresh.post = name;
  fresh.params = Value::object();
  return fresh;
}

/// The stored outputs that the request names, by their own id or by that of their post-processor.
std::vector<Output> requestedOutputs(const Pipeline& pipeline, const RunRequest& request) {
  const Project& project = pipeline.document().project();
  if (request.posts.empty()) {
    return project.outputs;
  }
  std::vector<Output> outputs;
  const auto addOnce = [&outputs](const Output& output) {
    if (std::none_of(outputs.begin(), outputs.end(),
                     [&](const Output& other) { return other.id == output.id; })) {
      outputs.push_back(output);
    }
  };
  for (const std::string& name : request.posts) {
    bool stored = false;
    for (const Output& output : project.outputs) {
      if (output.id == name || output.post == name) {
        addOnce(output);
        stored = true;
      }
    }
    if (!stored) {
      addOnce(freshOutput(pipeline, name));
    }
  }
  return outputs;
}

bool hasViolation(const std::vector<Diagnostic>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::Violation; });
}

std::string joinedPath(const std::string& folder, const std::string& name) {
  return folder.empty() ? name : folder + "/" + name;
}

Text writerName(const WrittenFile& file) {
  return file.output.empty() ? text("the table of '%1'", {file.operation})
                             : text("the output '%1' for '%2'", {file.output, file.operation});
}

/// Where an output of this folder lies: in the output folder, or outside of it.
struct Place {
  std::filesystem::path root;
  std::string path;  ///< below the root
};

bool leaves(const std::string& path) {
  const std::filesystem::path plain = pathFromText(path).lexically_normal();
  return plain.is_absolute() || (!plain.empty() && *plain.begin() == "..");
}

Place placeOf(const std::filesystem::path& folder, const WrittenFile& file) {
  const std::filesystem::path path = pathFromText(file.path);
  if (!leaves(file.path)) {
    return {folder, pathText(path.lexically_normal())};
  }
  return {(folder / path.parent_path()).lexically_normal(), pathText(path.filename())};
}

void refuseOutside(const std::vector<Output>& outputs) {
  for (const Output& output : outputs) {
    if (leaves(output.folder)) {
      throw Error(ErrorCode::OutputConflict,
                  text("the folder '%1' of output '%2' lies outside of the output folder",
                       {output.folder, output.id}),
                  "outputs", "name a folder below it, or allow it with --allow-outside");
    }
  }
}

/// The files that the run reads; outputs must not replace them.
void keepInputs(const Pipeline& pipeline, OutputPlan& plan) {
  plan.keep(pipeline.file(), "the project");
  for (const UsedFile& used : usedFiles(pipeline.document())) {
    plan.keep(resolvePath(pipeline.file(), used.ref), text("the file of the %1", {used.owner}));
  }
}

void planOutputs(const std::filesystem::path& folder,
                 const std::vector<PendingFile>& pending,
                 OutputPlan& plan) {
  for (std::size_t i = 0; i < pending.size(); ++i) {
    const WrittenFile& file = pending[i].file;
    // Of one output only the names of the operations, or its own setting, can tell them apart.
    for (std::size_t k = 0; k < i; ++k) {
      const WrittenFile& other = pending[k].file;
      if (!file.output.empty() && other.output == file.output &&
          other.operation != file.operation && other.path == file.path) {
        throw Error(
            ErrorCode::OutputConflict,
            text("the operations '%1' and '%2' both get the program %3 of output '%4'",
                 {other.operation, file.operation, file.path, file.output}),
            text("output '%1'", {file.output}),
            "rename one of the operations; if the output sets program_name, leave it empty, "
            "so that each program bears the name of its operation");
      }
    }
    plan.write(folder / pathFromText(file.path), writerName(file));
  }
}

void printOutputs(const Pipeline& pipeline,
                  const std::vector<Output>& outputs,
                  const JobContext& context,
                  RunResult& result,
                  std::vector<PendingFile>& pending) {
  // The findings of one output do not keep back the others.
  std::vector<std::vector<Diagnostic>> found(result.operations.size());
  for (const OperationResult& operation : result.operations) {
    if (hasViolation(operation.findings)) {
      result.keptBack.push_back({operation.id, {}});
    }
  }
  for (const Output& output : outputs) {
    for (std::size_t i = 0; i < result.operations.size(); ++i) {
      const OperationResult& operation = result.operations[i];
      if (!prints(output, operation.id) || hasViolation(operation.findings)) {
        continue;
      }
      PrintedOutput printed = printOutput(pipeline, output, operation, context);
      for (plugin::OutputFile& file : printed.files) {
        WrittenFile written{output.id, operation.id, joinedPath(output.folder, file.name),
                            file.content.size(), sha256Hex(file.content)};
        pending.push_back({std::move(written), std::move(file.content)});
      }
      if (printed.error) {
        result.failures.push_back({text("output '%1'", {output.id}), *printed.error});
      }
      if (hasViolation(printed.findings)) {
        result.keptBack.push_back({operation.id, output.id});
      }
      found[i].insert(found[i].end(), printed.findings.begin(), printed.findings.end());
    }
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::vector<Diagnostic>& findings = result.operations[i].findings;
    findings.insert(findings.end(), found[i].begin(), found[i].end());
    result.violations += hasViolation(findings) ? 1U : 0U;
  }
}

/// Files of the folder that its last report names and this run does not write.
std::vector<std::string> leftFiles(const std::filesystem::path& folder,
                                   const std::vector<WrittenFile>& written) {
  std::vector<std::string> left;
  try {
    const Value report = parseJson(readFile(folder / kReportFile));
    for (const Value& entry : report.at("files").asArray()) {
      const std::string& path = entry.at("path").asString();
      const bool again = std::any_of(written.begin(), written.end(),
                                     [&](const WrittenFile& file) { return file.path == path; });
      if (!again && std::filesystem::exists(folder / pathFromText(path))) {
        left.push_back(path);
      }
    }
  } catch (const std::exception&) {
    // No report, or a file that only has its name: nothing is known about the folder.
    left.clear();
  }
  return left;
}

/// Once begun, the files are swapped to the end: a cancel in between would leave programs of two
/// runs side by side.
void writeAll(const std::filesystem::path& folder,
              std::vector<PendingFile> pending,
              const Value& report) {
  std::map<std::filesystem::path, OutputSet> outside;
  OutputSet inside(folder);
  for (PendingFile& file : pending) {
    Place place = placeOf(folder, file.file);
    OutputSet& set =
        place.root == folder ? inside : outside.try_emplace(place.root, place.root).first->second;
    set.add(std::move(place.path), std::move(file.content));
  }
  inside.add(kReportFile, toCanonicalJson(report));
  inside.prepare();
  for (auto& [root, set] : outside) {
    set.prepare();
  }
  for (auto& [root, set] : outside) {
    set.swap();
  }
  inside.swap();
}

/// A newer format may mean something else by what this program seems to understand.
void refuseNewer(const Document& document) {
  if (document.readOnly()) {
    throw Error(ErrorCode::ProjectReadOnly,
                "the project was written by a newer version, and this one understands it only in "
                "part: no robot program is made from it",
                {}, "use the newer version of WCAM; `camcli info` shows what is in the project");
  }
}

void computeAll(const Pipeline& pipeline,
                const std::vector<std::string>& ids,
                const JobContext& context,
                RunResult& result) {
  const auto count = static_cast<double>(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto before = static_cast<double>(i);
    try {
      result.operations.push_back(pipeline.compute(
          ids[i], context.portion(before / count, (before + 1.0) / count, ids[i])));
    } catch (const CancelledError&) {
      throw;
    } catch (const OperationError& error) {
      result.failures.push_back({text("operation '%1'", {ids[i]}), error, error.remedy()});
    } catch (const Error& error) {
      result.failures.push_back({text("operation '%1'", {ids[i]}), error});
    }
  }
}

}  // namespace

bool prints(const Output& output, const std::string& operation) {
  return output.operations.empty() || std::find(output.operations.begin(), output.operations.end(),
                                                operation) != output.operations.end();
}

PrintedOutput printOutput(const Pipeline& pipeline,
                          const Output& output,
                          const OperationResult& operation,
                          const JobContext& context) {
  context.check();
  PrintedOutput printed;
  const JobContext own = context.withOwnDiagnostics();
  try {
    printed.files = pipeline.post(output, operation, own);
  } catch (const CancelledError&) {
    throw;
  } catch (const Error& error) {
    printed.error = error;
  }
  for (Diagnostic& finding : own.diagnostics().items()) {
    finding.place.operation = operation.id;
    finding.message = text("output '%1': %2", {output.id, finding.message});
    printed.findings.push_back(std::move(finding));
  }
  if (hasViolation(printed.findings)) {
    printed.files.clear();
  }
  return printed;
}

int RunResult::exitCode() const {
  if (!failures.empty()) {
    return exitCodeOf(failures.front().error.code());
  }
  return violations > 0 ? exitCodeOf(ErrorCode::CheckFailed) : 0;
}

RunResult runProject(const Pipeline& pipeline,
                     const RunRequest& request,
                     const JobContext& context) {
  refuseNewer(pipeline.document());
  RunResult result;
  result.projectFindings = pipeline.document().findings();
  const std::vector<Diagnostic> warnings = pipeline.validate();
  result.projectFindings.insert(result.projectFindings.end(), warnings.begin(), warnings.end());
  const std::vector<std::string> ids = operationIds(pipeline.document().project(), request);
  const std::vector<Output> outputs = requestedOutputs(pipeline, request);
  OutputPlan plan = request.plan;
  keepInputs(pipeline, plan);
  if (!request.allowOutside) {
    refuseOutside(outputs);
  }
  const Value origin = provenance(pipeline, request, ids, outputs);
  std::optional<OutputFolder> folder;
  if (!request.checkOnly) {
    folder.emplace(request.folder);
  }

  constexpr double kComputed = 0.9;
  computeAll(pipeline, ids, context.portion(0.0, kComputed), result);
  // Posts run for a check as well: what they refuse is a finding of the check.
  std::vector<PendingFile> pending;
  printOutputs(pipeline, outputs, context.portion(kComputed, 0.95, "post-processing"), result,
               pending);
  if (request.tables) {
    for (const OperationResult& operation : result.operations) {
      context.check();
      std::string table = operationTable(operation);
      pending.push_back({{"", operation.id, operation.id + ".csv", table.size(), sha256Hex(table)},
                         std::move(table)});
    }
  }
  if (!request.checkOnly) {
    plan.write(request.folder / kReportFile, "the report of the output folder");
  }
  planOutputs(request.folder, pending, plan);
  if (!request.checkOnly) {
    for (const PendingFile& file : pending) {
      result.files.push_back(file.file);
    }
    result.leftFiles = leftFiles(request.folder, result.files);
  }
  result.report = projectReport(pipeline.document(), result.operations, result.files,
                                result.projectFindings, result.failures);
  Value keptBack = Value::array();
  for (const KeptBack& kept : result.keptBack) {
    Value entry = Value::object({{"operation", kept.operation}});
    if (!kept.output.empty()) {
      entry.set("output", kept.output);
    }
    keptBack.push(entry);
  }
  Value left = Value::array();
  for (const std::string& path : result.leftFiles) {
    left.push(Value(path));
  }
  result.report.set("kept_back", keptBack).set("left_files", left).set("provenance", origin);
  context.check();
  result.written = !request.checkOnly && !result.operations.empty();
  if (result.written) {
    writeAll(request.folder, std::move(pending), result.report);
  }
  context.report(1.0);
  return result;
}

}  // namespace wcam::project
