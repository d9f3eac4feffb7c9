// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/run.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/text.hpp"

#include <algorithm>
#include <map>

namespace wcam::project {

namespace {

struct PendingFile {
  WrittenFile file;
  std::string content;
};

std::vector<std::string> operationIds(const Project& project, const RunRequest& request) {
  std::vector<std::string> ids = request.operations;
  if (ids.empty()) {
    for (const Operation& operation : project.operations) {
      if (operation.enabled) {
        ids.push_back(operation.id);
      }
    }
  }
  if (ids.empty()) {
    throw Error(ErrorCode::ProjectInvalid, "the project has no enabled operation", {},
                "add an operation or enable one");
  }
  for (const std::string& id : ids) {
    if (project.operation(id) == nullptr) {
      std::vector<std::string> known;
      for (const Operation& operation : project.operations) {
        known.push_back(operation.id);
      }
      throw Error(ErrorCode::InvalidArgument, "the project has no operation '" + id + "'", {},
                  "operations: " + joinText(known, ", "));
    }
  }
  return ids;
}

/// The stored outputs that the request names; a post-processor without a stored output gets one
/// with its defaults.
std::vector<Output> requestedOutputs(const Project& project, const RunRequest& request) {
  if (request.posts.empty()) {
    return project.outputs;
  }
  std::vector<Output> outputs;
  for (const std::string& name : request.posts) {
    const std::size_t before = outputs.size();
    for (const Output& output : project.outputs) {
      if (output.id == name || output.post == name) {
        outputs.push_back(output);
      }
    }
    if (outputs.size() == before) {
      Output fresh;
      fresh.id = name;
      fresh.post = name;
      fresh.params = Value::object();
      outputs.push_back(fresh);
    }
  }
  return outputs;
}

bool hasViolation(const OperationResult& result) {
  return std::any_of(result.findings.begin(), result.findings.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::Violation; });
}

std::string joinedPath(const std::string& folder, const std::string& name) {
  return folder.empty() ? name : folder + "/" + name;
}

/// Two files of one path would silently replace each other.
void refuseDuplicates(const std::vector<PendingFile>& pending) {
  std::map<std::string, const WrittenFile*> seen;
  for (const PendingFile& file : pending) {
    const auto [other, fresh] = seen.emplace(file.file.path, &file.file);
    if (!fresh) {
      throw Error(ErrorCode::OutputConflict,
                  "the outputs '" + other->second->output + "' and '" + file.file.output +
                      "' both write " + file.file.path,
                  "outputs", "give one of them another folder");
    }
  }
}

void printOutputs(const Pipeline& pipeline,
                  const std::vector<Output>& outputs,
                  const JobContext& context,
                  RunResult& result,
                  std::vector<PendingFile>& pending) {
  for (const Output& output : outputs) {
    for (const OperationResult& operation : result.operations) {
      const bool wanted =
          output.operations.empty() || std::find(output.operations.begin(), output.operations.end(),
                                                 operation.id) != output.operations.end();
      if (!wanted || hasViolation(operation)) {
        continue;
      }
      context.check();
      try {
        for (plugin::OutputFile& file : pipeline.post(output, operation, context)) {
          WrittenFile written{output.id, operation.id, joinedPath(output.folder, file.name),
                              file.content.size()};
          pending.push_back({std::move(written), std::move(file.content)});
        }
      } catch (const CancelledError&) {
        throw;
      } catch (const Error& error) {
        result.failures.push_back({"output '" + output.id + "'", error});
      }
    }
  }
}

}  // namespace

int RunResult::exitCode() const {
  if (!failures.empty()) {
    return exitCodeOf(failures.front().error.code());
  }
  return violations > 0 ? exitCodeOf(ErrorCode::CheckFailed) : 0;
}

RunResult runProject(const Pipeline& pipeline,
                     const RunRequest& request,
                     const JobContext& context) {
  const Project& project = pipeline.document().project();
  std::vector<Diagnostic> projectFindings = pipeline.document().findings();
  const std::vector<Diagnostic> warnings = pipeline.validate();
  projectFindings.insert(projectFindings.end(), warnings.begin(), warnings.end());
  const std::vector<std::string> ids = operationIds(project, request);
  const std::vector<Output> outputs = requestedOutputs(project, request);
  if (!request.checkOnly) {
    createFolder(request.folder);
  }

  RunResult result;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const double begin = 0.9 * static_cast<double>(i) / static_cast<double>(ids.size());
    const double end = 0.9 * static_cast<double>(i + 1) / static_cast<double>(ids.size());
    try {
      result.operations.push_back(pipeline.compute(ids[i], context.portion(begin, end, ids[i])));
      result.violations += hasViolation(result.operations.back()) ? 1U : 0U;
    } catch (const CancelledError&) {
      throw;
    } catch (const Error& error) {
      result.failures.push_back({"operation '" + ids[i] + "'", error});
    }
  }
  std::vector<PendingFile> pending;
  if (!request.checkOnly) {
    printOutputs(pipeline, outputs, context.portion(0.9, 0.95, "post-processing"), result, pending);
    if (request.tables) {
      for (const OperationResult& operation : result.operations) {
        std::string table = operationTable(operation);
        pending.push_back(
            {{"", operation.id, operation.id + ".csv", table.size()}, std::move(table)});
      }
    }
    refuseDuplicates(pending);
  }
  for (const PendingFile& file : pending) {
    result.files.push_back(file.file);
  }
  result.report =
      projectReport(pipeline.document(), result.operations, result.files, projectFindings);
  if (!request.checkOnly) {
    for (const PendingFile& file : pending) {
      context.check();
      const std::filesystem::path path = request.folder / pathFromText(file.file.path);
      createFolder(path.parent_path());
      writeFileAtomically(path, file.content);
    }
    writeFileAtomically(request.folder / "report.json", toCanonicalJson(result.report));
  }
  context.report(1.0);
  return result;
}

}  // namespace wcam::project
