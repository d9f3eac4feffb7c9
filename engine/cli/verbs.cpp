// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "verbs.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/output_set.hpp"
#include "wcam/base/text.hpp"
#include "wcam/cell/inverse.hpp"
#include "wcam/io/import.hpp"
#include "wcam/motion/plan.hpp"
#include "wcam/plugin/locations.hpp"
#include "wcam/process/process.hpp"
#include "wcam/project/commands.hpp"
#include "wcam/project/history.hpp"
#include "wcam/project/new_outputs.hpp"
#include "wcam/project/pipeline.hpp"
#include "wcam/project/project_file.hpp"
#include "wcam/toolpath/build.hpp"
#include "wcam/toolpath/edits.hpp"

#include "changed_project.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>

namespace wcam::cli {

namespace {

void print(const Value& value) {
  std::fputs(toCanonicalJson(value).c_str(), stdout);
}

/// `new` never overwrites.
void refuseExisting(const std::filesystem::path& file) {
  if (std::filesystem::exists(file)) {
    throw Error(ErrorCode::OutputConflict, "the file exists", pathText(file),
                "choose another name or remove it");
  }
}

/// Refuses all but the name of a cell that comes with the program.
void checkShippedCell(const std::string& name) {
  const std::filesystem::path folder = plugin::dataFolder() / "cells";
  if (isValidId(name) && std::filesystem::exists(folder / (name + ".json"))) {
    return;
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

/// A file to put beside the project, so that the project can be moved as a whole.
struct CopiedFile {
  std::filesystem::path target;
  std::string content;
};

/// Reads a file that is to be copied beside the project; nothing to copy when it or an equal one is
/// there already. @return its name, as the project says it
std::string planCopy(const std::filesystem::path& source,
                     const std::filesystem::path& project,
                     std::vector<CopiedFile>& copies) {
  std::string content = readFile(source);
  const std::filesystem::path target = project.parent_path() / source.filename();
  if (!std::filesystem::exists(target)) {
    copies.push_back({target, std::move(content)});
  } else if (readFile(target) != content) {
    throw Error(ErrorCode::OutputConflict, "another file of this name lies beside the project",
                pathText(target), "rename one of them");
  }
  return source.filename().native();
}

/// What `new` makes on its way, which goes again when it fails.
class NewFiles {
public:
  NewFiles() = default;

  ~NewFiles() {
    // The innermost last made; folders go when they are empty.
    for (auto path = made_.rbegin(); path != made_.rend(); ++path) {
      std::error_code ignored;
      std::filesystem::remove(*path, ignored);
    }
  }

  NewFiles(const NewFiles&) = delete;
  NewFiles& operator=(const NewFiles&) = delete;

  void folder(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> missing;
    std::error_code ignored;
    for (std::filesystem::path path = folder;
         !path.empty() && !std::filesystem::exists(path, ignored); path = path.parent_path()) {
      missing.push_back(path);
    }
    made_.insert(made_.end(), missing.rbegin(), missing.rend());
    if (!folder.empty()) {
      createFolder(folder);
    }
  }

  void write(const CopiedFile& copy) {
    made_.push_back(copy.target);
    writeFileAtomically(copy.target, copy.content);
  }

  void keep() { made_.clear(); }

private:
  std::vector<std::filesystem::path> made_;
};

Value projectTemplate(const std::string& name,
                      const std::string& part,
                      const std::string& cell,
                      const Value& plate,
                      const Value& outputs) {
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
  const Value wire = Value::object({{"id", "wire"}, {"params", Value::object()}});
  return tree.set("parts", parts)
      .set("substrates", Value(Value::Array{plate}))
      .set("processes", Value(Value::Array{wire}))
      .set("operations", operations)
      .set("outputs", outputs);
}

/// Commands that are piped in.
std::string standardInput() {
  std::string text;
  std::array<char, 65536> buffer{};
  while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), stdin)) {
    text.append(buffer.data(), got);
  }
  return text;
}

/// Without the index of its node, which other commands may have changed.
std::string keyOf(const ParamProblem& problem) {
  const std::size_t index = problem.path.find(']');
  return (index == std::string::npos ? problem.path : problem.path.substr(index)) + ": " +
         problem.message.str();
}

/// A project must not get what a run would refuse. What was wrong before may stay.
void refuseNewProblems(const project::Pipeline& before, const project::Pipeline& after) {
  std::multiset<std::string> old;
  for (const ParamProblem& problem : before.problems()) {
    old.insert(keyOf(problem));
  }
  std::vector<std::string> fresh;
  for (const ParamProblem& problem : after.problems()) {
    const auto known = old.find(keyOf(problem));
    if (known == old.end()) {
      fresh.push_back((problem.path.empty() ? "" : problem.path + ": ") + problem.message.str());
    } else {
      old.erase(known);
    }
  }
  if (!fresh.empty()) {
    throw Error(ErrorCode::ProjectInvalid,
                "the commands would leave what a run refuses: " + joinText(fresh, "; "),
                pathText(after.file()), "correct the commands; the project stays as it was");
  }
}

/// Schemas of the engine's own sections, beside those of the plugins' components.
struct EngineSchema {
  std::string name;
  std::string title;
  ParamSchema schema;
};

std::vector<EngineSchema> engineSchemas() {
  std::vector<EngineSchema> schemas = {
      {"import", "Import of a part", io::importOptionsSchema().params()},
      {"motion", "Motion of an operation", motion::MotionParams::schema().params()},
      {"path", "Path of an operation", toolpath::PathParams::schema().params()},
      {"process", "Deposition process", process::ProcessParams::schema().params()}};
  for (const toolpath::EditTypeInfo& info : toolpath::editTypes()) {
    schemas.push_back({std::string("edit.") + info.key, std::string("Edit: ") + info.name,
                       toolpath::editSchema(info.type).params()});
  }
  return schemas;
}

}  // namespace

int newVerb(const Session& session) {
  const Options& options = session.options;
  const std::filesystem::path file = pathFromText(options.file);
  if (file.extension() != ".wcam") {
    throw Error(ErrorCode::InvalidArgument, "a project file ends in .wcam", pathText(file),
                "name it " + pathText(file.filename()) + ".wcam");
  }
  refuseExisting(file);
  std::vector<CopiedFile> copies;
  const std::string cellName = options.cell.empty() ? project::kDefaultCell : options.cell;
  std::string cell = std::string(project::kShippedPrefix) + "cells/" + cellName + ".json";
  if (std::filesystem::is_regular_file(pathFromText(cellName))) {
    cell = planCopy(pathFromText(cellName), file, copies);
  } else {
    checkShippedCell(cellName);
  }
  const std::string part =
      options.part.empty() ? std::string() : planCopy(pathFromText(options.part), file, copies);
  NewFiles made;
  made.folder(file.parent_path());
  const auto lock = project::ProjectLock::take(file);
  refuseExisting(file);
  for (const CopiedFile& copy : copies) {
    made.write(copy);
  }
  const std::string name = options.name.empty() ? file.stem().native() : options.name;
  project::Document document = project::Document::parse(
      projectTemplate(
          name, part, cell, project::newPlate(project::resolvePath(file, {cell, ""})),
          project::newOutputs(*session.plugins, project::resolvePath(file, {cell, ""}))),
      pathText(file));
  document = project::apply(document, project::pinCommand(document, file));
  project::saveProject(document, file);
  made.keep();
  session.console.say("made " + pathText(file));
  if (options.json) {
    print(Value::object({{"project", pathText(file)}}));
  }
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
    info.set("closed_form", cell.inverse->method() != cell::InverseMethod::Numeric);
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
  // A bare name of a file that is not there yet has no folder until it is made absolute.
  const auto folderOf = [](const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored)
        .parent_path();
  };
  if (folderOf(target) != folderOf(file)) {
    throw Error(ErrorCode::InvalidArgument, "lies in another folder than the project",
                pathText(target), "the project names its files relative to its own folder");
  }
  OutputPlan plan;
  if (fileIdentity(target) != fileIdentity(file)) {
    plan.keep(log, "the command file");
    if (target.extension() != ".wcam") {
      throw Error(ErrorCode::OutputConflict, "a project file ends in .wcam", pathText(target),
                  "name it " + pathText(target.filename()) + ".wcam");
    }
  }
  const ChangedProject changed(file);
  const project::Document& before = changed.loaded.document;
  for (const project::UsedFile& used : project::usedFiles(before)) {
    plan.keep(project::resolvePath(file, used.ref), text("the file of the %1", {used.owner}));
  }
  plan.write(target, "the changed project");
  project::History history(before);
  const bool piped = session.options.commands == kStandardOutput;
  const std::size_t lines = history.replay(piped ? standardInput() : readFile(log),
                                           piped ? "standard input" : pathText(log));
  refuseNewProblems({before, file, session.plugins}, {history.current(), file, session.plugins});
  if (fileIdentity(target) == fileIdentity(file)) {
    changed.save(session, history.current());
  } else {
    const auto lock = project::ProjectLock::take(target);
    project::saveProject(history.current(), target);
  }
  session.console.say("applied " + std::to_string(lines) + (lines == 1 ? " command" : " commands") +
                      ", saved " + pathText(target));
  if (session.options.json) {
    print(Value::object({{"applied", lines}, {"project", pathText(target)}}));
  }
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
                             {"reason", report.reason.str()},
                             {"components", components}}));
    text += std::string(plugin::toString(report.verdict)) + "  " +
            (report.id.empty() ? "?" : report.id) + " " + report.version + names + "\n    " +
            pathText(report.path) +
            (report.reason.empty() ? "" : "\n    reason: " + report.reason.str()) + "\n";
  }
  if (session.options.json) {
    print(Value::object({{"plugins", list}}));
  } else {
    std::fputs(printable(text).c_str(), stdout);
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
  if (wanted.empty() && session.options.json) {
    Value list = Value::array();
    for (const std::string& name : names) {
      list.push(Value(name));
    }
    print(Value::object({{"components", list}}));
    return 0;
  }
  if (wanted.empty()) {
    std::fputs((joinText(names, "\n") + "\n").c_str(), stdout);
    return 0;
  }
  if (std::find(names.begin(), names.end(), wanted) == names.end()) {
    if (const auto near = nearestName(wanted, names)) {
      throw Error(ErrorCode::PluginMissing, "there is no component '" + wanted + "'", {},
                  "did you mean '" + *near + "'?");
    }
  }
  const plugin::ComponentInfo info = session.plugins->info(wanted);
  print(info.params.jsonSchema(info.name));
  return 0;
}

}  // namespace wcam::cli
