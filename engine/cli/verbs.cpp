// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "verbs.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/text.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/io/import.hpp"
#include "wcam/motion/plan.hpp"
#include "wcam/plugin/locations.hpp"
#include "wcam/process/process.hpp"
#include "wcam/project/commands.hpp"
#include "wcam/project/history.hpp"
#include "wcam/project/project_file.hpp"
#include "wcam/toolpath/build.hpp"

#include <algorithm>
#include <cstdio>

namespace wcam::cli {

namespace {

void print(const Value& value) {
  std::fputs(toCanonicalJson(value).c_str(), stdout);
}

/// Empty file names and names of files that exist are refused: `new` never overwrites.
void refuseExisting(const std::filesystem::path& file) {
  if (std::filesystem::exists(file)) {
    throw Error(ErrorCode::OutputConflict, "the file exists", pathText(file),
                "choose another name or remove it");
  }
}

/// A cell file by path, or by the name of one that comes with the program.
std::filesystem::path cellFile(const std::string& name) {
  const std::filesystem::path given = pathFromText(name);
  if (std::filesystem::exists(given)) {
    return given;
  }
  const std::filesystem::path folder = plugin::dataFolder() / "cells";
  const std::filesystem::path shipped = folder / (name + ".json");
  if (std::filesystem::exists(shipped)) {
    return shipped;
  }
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (entry.path().extension() == ".json") {
      names.push_back(entry.path().stem().native());
    }
  }
  std::sort(names.begin(), names.end());
  throw Error(ErrorCode::InputNotFound, "there is no cell '" + name + "'", {},
              "give a cell file or one of: " + joinText(names, ", "));
}

/// Copies a file beside the project, so that the project can be moved as a whole; a file that is
/// there already stays.
std::string copyBeside(const std::filesystem::path& source, const std::filesystem::path& project) {
  const std::filesystem::path target = project.parent_path() / source.filename();
  std::error_code ignored;
  if (!std::filesystem::equivalent(source, target, ignored)) {
    refuseExisting(target);
    writeFileAtomically(target, readFile(source));
  }
  return source.filename().native();
}

Value projectTemplate(const std::string& name, const std::string& part, const std::string& cell) {
  const auto fileRef = [](const std::string& path) {
    return Value::object({{"path", path}, {"sha256", ""}});
  };
  Value parts = Value::array();
  Value operations = Value::array();
  if (!part.empty()) {
    parts.push(Value::object({{"id", "part"}, {"file", fileRef(part)}}));
    operations.push(Value::object({{"id", "build"},
                                   {"strategy", "wcam.slicing.planar"},
                                   {"parts", Value(Value::Array{Value("part")})},
                                   {"substrate", "plate"},
                                   {"process", "wire"},
                                   {"params", Value::object({{"step", 2.0}})}}));
  }
  Value tree = Value::object({{"format", project::kFormatName},
                              {"format_version", project::kFormatVersion},
                              {"name", name}});
  if (!cell.empty()) {
    tree.set("cell", fileRef(cell));
  }
  const Value plate = Value::object(
      {{"id", "plate"}, {"type", "plate"}, {"size_mm", Value(Value::Array{300.0, 300.0, 10.0})}});
  const Value wire = Value::object({{"id", "wire"}, {"params", Value::object()}});
  const Value fanuc = Value::object({{"id", "fanuc"}, {"post", "wcam.post.fanuc"}});
  return tree.set("parts", parts)
      .set("substrates", Value(Value::Array{plate}))
      .set("processes", Value(Value::Array{wire}))
      .set("operations", operations)
      .set("outputs", Value(Value::Array{fanuc}));
}

/// Schemas of the engine's own sections, beside those of the plugins' components.
struct EngineSchema {
  const char* name;
  const char* title;
  ParamSchema schema;
};

std::vector<EngineSchema> engineSchemas() {
  return {{"import", "Import of a part", io::importOptionsSchema().params()},
          {"motion", "Motion of an operation", motion::MotionParams::schema().params()},
          {"path", "Path of an operation", toolpath::PathParams::schema().params()},
          {"process", "Deposition process", process::ProcessParams::schema().params()}};
}

}  // namespace

int newVerb(const Session& session) {
  const Options& options = session.options;
  const std::filesystem::path file = pathFromText(options.file);
  refuseExisting(file);
  if (file.extension() != ".wcam") {
    throw Error(ErrorCode::InvalidArgument, "a project file ends in .wcam", pathText(file));
  }
  const std::filesystem::path cellSource =
      cellFile(options.cell.empty() ? "fanuc_arcmate120ic" : options.cell);
  if (!options.part.empty() && !std::filesystem::exists(pathFromText(options.part))) {
    throw Error(ErrorCode::InputNotFound, "the part file does not exist", options.part);
  }
  if (file.has_parent_path()) {
    createFolder(file.parent_path());
  }
  const std::string cell = copyBeside(cellSource, file);
  const std::string part =
      options.part.empty() ? std::string() : copyBeside(pathFromText(options.part), file);
  const std::string name = options.name.empty() ? file.stem().native() : options.name;
  project::Document document =
      project::Document::parse(projectTemplate(name, part, cell), pathText(file));
  document = project::apply(document, project::pinCommand(document, file));
  project::saveProject(document, file);
  session.console.say("made " + pathText(file));
  return 0;
}

int infoVerb(const Session& session) {
  const std::filesystem::path file = pathFromText(session.options.file);
  Value info;
  std::vector<Diagnostic> findings;
  if (file.extension() == ".wcam") {
    const project::LoadedProject loaded = project::loadProject(file);
    findings = loaded.findings;
    info = loaded.document.tree();
  } else if (file.extension() == ".json") {
    const cell::Cell cell = cell::loadCell(file, session.context);
    info = Value::object(
        {{"name", cell.name}, {"robot", cell.robotName}, {"positioner", cell.positionerName}});
    info.set("configuration", cell.partCarried() ? "part_carried" : "torch_carried")
        .set("joints", cell.jointCount());
    info.set("closed_form", cell.arm.has_value());
  } else {
    const io::ImportedPart part =
        io::importPart(file, io::ImportOptions{}, geometry::Pose::Identity(), session.context);
    info = part.report.toValue();
    if (part.surface->brep != nullptr) {
      Value edges = Value::array();
      for (int i = 0; i < part.surface->brep->edgeCount(); ++i) {
        const geometry::BrepEdgeInfo& edge = part.surface->brep->edge(i);
        edges.push(Value::object({{"edge", i},
                                  {"name", edge.name},
                                  {"length_mm", edge.length},
                                  {"faces", edge.faceCount}}));
      }
      info.set("edge_list", edges);
    }
  }
  session.console.endProgress();
  const std::vector<Diagnostic> own = session.context.diagnostics().items();
  findings.insert(findings.end(), own.begin(), own.end());
  print(info);
  session.console.findings(findings);
  return 0;
}

int applyVerb(const Session& session) {
  const std::filesystem::path file = pathFromText(session.options.file);
  const std::filesystem::path log = pathFromText(session.options.commands);
  const std::filesystem::path target =
      session.options.output.empty() ? file : pathFromText(session.options.output);
  const project::LoadedProject loaded = project::loadProject(file);
  project::History history(loaded.document);
  const std::size_t lines = history.replay(readFile(log), pathText(log));
  project::saveProject(history.current(), target);
  session.console.say("applied " + std::to_string(lines) + " commands, saved " + pathText(target));
  return 0;
}

int pluginsListVerb(const Session& session) {
  session.plugins->loadAll();
  Value list = Value::array();
  std::string text;
  for (const plugin::PluginReport& report : session.plugins->reports()) {
    Value components = Value::array();
    std::string names;
    for (const plugin::ComponentEntry& component : report.components) {
      components.push(Value::object({{"kind", plugin::toString(component.kind)},
                                     {"id", component.id},
                                     {"name", component.name}}));
      names += " " + component.id;
    }
    list.push(Value::object({{"id", report.id},
                             {"version", report.version},
                             {"abi", report.abi},
                             {"path", pathText(report.path)},
                             {"origin", plugin::toString(report.origin)},
                             {"verdict", plugin::toString(report.verdict)},
                             {"reason", report.reason},
                             {"components", components}}));
    text += std::string(plugin::toString(report.verdict)) + "  " +
            (report.id.empty() ? "?" : report.id) + " " + report.version + names + "\n    " +
            pathText(report.path) +
            (report.reason.empty() ? "" : "\n    reason: " + report.reason) + "\n";
  }
  if (session.options.json) {
    print(Value::object({{"plugins", list}}));
  } else {
    std::fputs(text.c_str(), stdout);
  }
  return 0;
}

int schemaVerb(const Session& session) {
  const std::string& wanted = session.options.component;
  if (wanted == "commands") {
    Value commands = Value::object();
    for (const project::CommandInfo& command : project::commandCatalog()) {
      commands.set(command.id, command.jsonSchema());
    }
    print(commands);
    return 0;
  }
  std::vector<std::string> names = {"commands"};
  for (const EngineSchema& schema : engineSchemas()) {
    names.emplace_back(schema.name);
    if (wanted == schema.name) {
      print(schema.schema.jsonSchema(schema.title));
      return 0;
    }
  }
  for (const plugin::ComponentEntry& component : session.plugins->components()) {
    names.push_back(component.id);
  }
  if (wanted.empty()) {
    std::fputs((joinText(names, "\n") + "\n").c_str(), stdout);
    return 0;
  }
  const plugin::ComponentInfo info = session.plugins->info(wanted);
  print(info.params.jsonSchema(info.name));
  return 0;
}

}  // namespace wcam::cli
