// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/text.hpp"
#include "wcam/project/commands.hpp"
#include "wcam/project/project_file.hpp"
#include "wcam/project/run.hpp"

#include "verbs.hpp"

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

project::Document withSettings(project::Document document, const Session& session) {
  for (const std::string& setting : session.options.settings) {
    const auto commands = project::commandsOfSetting(
        document, setting,
        [&](const project::ParamSection& section) { return schemaOf(*session.plugins, section); });
    for (const project::Command& command : commands) {
      document = project::apply(document, command);
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

void tell(const Session& session,
          const project::RunResult& result,
          const std::filesystem::path& folder) {
  const Console& console = session.console;
  for (const Value& operation : result.report.at("operations").asArray()) {
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
  std::vector<Diagnostic> all;
  for (const project::OperationResult& operation : result.operations) {
    all.insert(all.end(), operation.findings.begin(), operation.findings.end());
  }
  console.findings(all);
  for (const project::RunFailure& failure : result.failures) {
    console.error(failure.error);
  }
  for (const project::OperationResult& operation : result.operations) {
    for (const Diagnostic& finding : operation.findings) {
      if (finding.severity == Severity::Violation) {
        console.complain("operation " + operation.id +
                         " violates a check and gets no robot program: " + finding.message);
        break;
      }
    }
  }
  if (session.options.check) {
    return;
  }
  console.say("written to " + pathText(folder) + ":");
  for (const project::WrittenFile& file : result.files) {
    console.say("  " + file.path + " (" + std::to_string(file.bytes) + " bytes)");
  }
  console.say("  report.json");
}

}  // namespace

int runProjectVerb(const Session& session) {
  const std::filesystem::path file = pathFromText(session.options.project);
  project::LoadedProject loaded = project::loadProject(file);
  for (const Diagnostic& finding : loaded.findings) {
    session.console.complain("camcli: " + toLine(finding));
  }
  const project::Document document = withSettings(loaded.document, session);
  const project::Pipeline pipeline(document, file, session.plugins);
  project::RunRequest request;
  request.folder = outputFolder(session, file);
  request.operations = session.options.operations;
  request.posts = session.options.posts;
  request.tables = session.options.table;
  request.checkOnly = session.options.check;
  const project::RunResult result = project::runProject(pipeline, request, session.context);
  session.console.endProgress();
  tell(session, result, request.folder);
  if (!session.options.report.empty()) {
    writeFileAtomically(pathFromText(session.options.report), toCanonicalJson(result.report));
  }
  if (session.options.json) {
    std::fputs(toCanonicalJson(result.report).c_str(), stdout);
  }
  return result.exitCode();
}

int checkVerb(const Session& session) {
  const std::filesystem::path file = pathFromText(session.options.file);
  const std::string difference = project::checkCanonical(file);
  if (!difference.empty()) {
    session.console.say("not canonical: " + difference);
  }
  Options options = session.options;
  options.project = options.file;
  options.check = true;
  return runProjectVerb({options, session.console, session.context, session.plugins});
}

}  // namespace wcam::cli
