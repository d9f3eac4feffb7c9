// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/output_set.hpp"
#include "wcam/base/text.hpp"
#include "wcam/project/commands.hpp"
#include "wcam/project/html_report.hpp"
#include "wcam/project/project_file.hpp"
#include "wcam/project/provenance.hpp"
#include "wcam/project/run.hpp"

#include "verbs.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace wcam::cli {

namespace {

/// Schemas of the sections of a project's nodes, for --set.
std::optional<ParamSchema> schemaOf(const plugin::PluginHost& plugins,
                                    const project::ParamSection& section) {
  if (section.list == "operations" && section.section == "path") {
    return toolpath::PathParams::schema().params();
  }
  if (section.list == "operations" && section.section == "motion") {
    return motion::MotionParams::schema().params();
  }
  if (section.list == "processes") {
    return process::ProcessParams::schema().params();
  }
  if (section.list == "parts") {
    return io::importOptionsSchema().params();
  }
  return plugins.info(section.component).params;
}

/// Applies all settings, or tells everything that is wrong with them.
project::Document withSettings(project::Document document, const Session& session) {
  std::vector<Error> problems;
  for (const std::string& setting : session.options.settings) {
    try {
      const auto commands =
          project::commandsOfSetting(document, setting, [&](const project::ParamSection& section) {
            return schemaOf(*session.plugins, section);
          });
      for (const project::Command& command : commands) {
        document = project::apply(document, command);
      }
    } catch (const Error& error) {
      problems.push_back(error);
    }
  }
  if (problems.size() == 1) {
    throw Error(problems.front());
  }
  if (!problems.empty()) {
    std::vector<std::string> lines;
    lines.reserve(problems.size());
    for (const Error& problem : problems) {
      lines.emplace_back(problem.what());
    }
    throw Error(problems.front().code(),
                std::to_string(lines.size()) + " problems:\n  " + joinText(lines, "\n  "), {},
                problems.front().hint());
  }
  return document;
}

/// With an output for every post-processor that --post names and the project does not store, so
/// that --set reaches it by its id.
project::Document withPosts(project::Document document, const Session& session) {
  for (const std::string& post : session.options.posts) {
    const auto& outputs = document.project().outputs;
    const bool stored = std::any_of(outputs.begin(), outputs.end(), [&](const auto& output) {
      return output.id == post || output.post == post;
    });
    const std::vector<plugin::ComponentEntry> known = session.plugins->components();
    const bool provided = std::any_of(known.begin(), known.end(), [&](const auto& entry) {
      return entry.kind == plugin::ComponentKind::Post && entry.id == post;
    });
    if (!stored && provided) {
      document =
          project::apply(document, {"output.add", Value::object({{"id", post}, {"post", post}})});
    }
  }
  return document;
}

std::filesystem::path outputFolder(const Session& session, const std::filesystem::path& file) {
  if (!session.options.output.empty()) {
    return pathFromText(session.options.output);
  }
  return file.parent_path() / (file.stem().native() + "-out");
}

std::string figure(const Value& report, std::initializer_list<const char*> path, int decimals) {
  const Value* value = &report;
  for (const char* key : path) {
    value = value != nullptr ? value->find(key) : nullptr;
  }
  return value != nullptr && value->isNumber() ? formatFixed(value->asReal(), decimals) : "-";
}

void tellFigures(const Console& console, const Value& report) {
  for (const Value& operation : report.at("operations").asArray()) {
    console.say("operation " + operation.at("id").asString() + " (" +
                operation.at("strategy").asString() + "): " + figure(operation, {"layers"}, 0) +
                " layers, " + figure(operation, {"beads"}, 0) + " beads, " +
                figure(operation, {"points"}, 0) + " points, " +
                figure(operation, {"length_mm"}, 0) + " mm of bead, " +
                figure(operation, {"deposited_volume_mm3"}, 0) + " mm3, " +
                figure(operation, {"time_s"}, 0) + " s");
    console.say("  layer distance " + figure(operation, {"layer_distance_mm", "min"}, 3) + " to " +
                figure(operation, {"layer_distance_mm", "max"}, 3) + " mm, travel speed " +
                figure(operation, {"speed_mm_s", "min"}, 2) + " to " +
                figure(operation, {"speed_mm_s", "max"}, 2) + " mm/s");
  }
}

void tellFiles(const Console& console,
               const project::RunResult& result,
               const std::filesystem::path& folder) {
  console.say("written to " + pathText(folder) + ":");
  for (const project::WrittenFile& file : result.files) {
    console.say("  " + file.path + " (" + std::to_string(file.bytes) + " bytes)");
  }
  console.say("  report.json");
  if (!result.leftFiles.empty()) {
    const std::string line = "camcli: warning: not written again and perhaps out of date: " +
                             joinText(result.leftFiles, ", ");
    // An old robot program beside findings that forbid a new one must not be overlooked.
    if (result.exitCode() != 0) {
      console.complain(line);
    } else {
      console.say(line);
    }
  }
}

/// The same failure of several operations, such as a part that cannot be read, is told once.
void tellFailures(const Console& console, const std::vector<project::RunFailure>& failures) {
  struct Told {
    std::string places;
    std::string rest;
    const Error* error = nullptr;
  };

  std::vector<Told> told;
  for (const project::RunFailure& failure : failures) {
    const std::string text = failure.error.what();
    const std::string prefix = failure.place.str() + ": ";
    const bool placed = text.starts_with(prefix);
    const std::string rest = placed ? text.substr(prefix.size()) : text;
    const auto same = std::find_if(told.begin(), told.end(), [&](const Told& other) {
      return other.rest == rest && placed && !other.places.empty();
    });
    if (same == told.end()) {
      told.push_back({placed ? failure.place.str() : std::string(), rest, &failure.error});
    } else {
      same->places += ", " + failure.place.str();
    }
  }
  for (const Told& one : told) {
    console.error(Error(one.error->code(), one.rest, one.places, one.error->hint()));
  }
}

void tell(const Session& session,
          const project::RunResult& result,
          const std::filesystem::path& folder) {
  const Console& console = session.console;
  tellFailures(console, result.failures);
  tellFigures(console, result.report);
  std::vector<Diagnostic> all = result.projectFindings;
  for (const project::OperationResult& operation : result.operations) {
    all.insert(all.end(), operation.findings.begin(), operation.findings.end());
  }
  console.findings(all);
  for (const project::KeptBack& kept : result.keptBack) {
    console.complain(kept.output.empty()
                         ? "camcli: error: operation '" + kept.operation +
                               "' violates checks and gets no robot program"
                         : "camcli: error: output '" + kept.output + "' of operation '" +
                               kept.operation + "' violates checks and is not written");
  }
  if (result.written) {
    tellFiles(console, result, folder);
  }
}

}  // namespace

int runProjectVerb(const Session& session) {
  const std::filesystem::path file = pathFromText(session.options.project);
  const project::LoadedProject loaded = project::loadProject(file);
  // What the document itself has found comes back with the result.
  for (const Diagnostic& finding : loaded.findings) {
    if (finding.code == "project.migrated") {
      session.console.say("camcli: " + toLine(finding));
    }
  }
  const project::Document document =
      loaded.document.readOnly() ? loaded.document
                                 : withSettings(withPosts(loaded.document, session), session);
  const project::Pipeline pipeline(document, file, session.plugins);
  const std::filesystem::path reportFile = pathFromText(session.options.report);
  project::RunRequest request;
  request.folder = outputFolder(session, file);
  request.operations = session.options.operations;
  request.posts = session.options.posts;
  request.tables = session.options.table;
  request.checkOnly = session.options.check;
  request.allowOutside = session.options.allowOutside;
  request.stored = loaded.document;
  request.settings = session.options.settings;
  if (session.options.json && reportFile == kStandardOutput) {
    throw Error(ErrorCode::InvalidArgument, "--json and --report - both print on standard output",
                {}, "leave one of them out");
  }
  request.plan.write(reportFile, "the report");
  for (const std::string& plugin : session.options.plugins) {
    request.plan.keep(pathFromText(plugin), "the plugin");
  }
  if (reportFile.has_parent_path()) {
    createFolder(reportFile.parent_path());
  }
  const project::RunResult result = project::runProject(pipeline, request, session.context);
  session.console.endProgress();
  if (!reportFile.empty()) {
    const std::string extension = reportFile.extension().string();
    writeResult(reportFile, extension == ".html" || extension == ".htm"
                                ? project::htmlReport(document, result)
                                : toCanonicalJson(result.report));
  }
  tell(session, result, request.folder);
  if (session.options.json) {
    std::fputs(toCanonicalJson(result.report).c_str(), stdout);
  }
  return result.exitCode();
}

namespace {

/// `check --output DIR [PROJECT]`: looks at what a run has written, computes nothing.
int checkOutputVerb(const Session& session) {
  const std::filesystem::path folder = pathFromText(session.options.output);
  const std::filesystem::path file = pathFromText(session.options.file);
  std::optional<project::Pipeline> pipeline;
  project::RunRequest request;
  request.settings = session.options.settings;
  if (!file.empty()) {
    const project::LoadedProject loaded = project::loadProject(file);
    request.stored = loaded.document;
    pipeline.emplace(withSettings(loaded.document, session), file, session.plugins);
  }
  const std::vector<Diagnostic> findings =
      project::checkOutputs(folder, pipeline ? &*pipeline : nullptr, request);
  const bool violated = std::any_of(findings.begin(), findings.end(), [](const Diagnostic& d) {
    return d.severity == Severity::Violation;
  });
  session.console.findings(findings);
  if (!violated) {
    session.console.say(pathText(folder) + ": whole" +
                        (file.empty() ? std::string() : ", made from " + pathText(file)));
  }
  if (session.options.json) {
    Value list = Value::array();
    for (const Diagnostic& finding : findings) {
      list.push(toValue(finding));
    }
    std::fputs(toCanonicalJson(Value::object({{"folder", pathText(folder)}, {"whole", !violated}})
                                   .set("diagnostics", list))
                   .c_str(),
               stdout);
  }
  return violated ? exitCodeOf(ErrorCode::CheckFailed) : 0;
}

}  // namespace

int checkVerb(const Session& session) {
  if (!session.options.output.empty()) {
    return checkOutputVerb(session);
  }
  const std::filesystem::path file = pathFromText(session.options.file);
  if (file.empty()) {
    throw Error(ErrorCode::InvalidArgument, "give a project, or a folder with --output", {},
                "see `camcli check --help`");
  }
  const std::string difference = project::checkCanonical(file);
  if (!difference.empty()) {
    session.console.say("  information project.not_canonical: " + difference);
  }
  Options options = session.options;
  options.project = options.file;
  options.check = true;
  return runProjectVerb({options, session.console, session.context, session.plugins});
}

}  // namespace wcam::cli
