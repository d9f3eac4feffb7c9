// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/provenance.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/sha256.hpp"
#include "wcam/base/text.hpp"
#include "wcam/base/version.h"
#include "wcam/project/project_file.hpp"

#include <algorithm>
#include <set>
#include <system_error>

namespace wcam::project {

namespace fs = std::filesystem;

namespace {

constexpr const char* kReportFile = "report.json";
constexpr const char* kExportAgain = "export the project again";

/// The library that a plugin's report names by its manifest.
fs::path libraryOf(fs::path path) {
  return path.extension() == ".json" ? path.replace_extension(".so") : path;
}

Value pluginValue(const plugin::PluginReport& report) {
  const fs::path library = libraryOf(report.path);
  Value value = Value::object({{"id", report.id},
                               {"version", report.version},
                               {"origin", plugin::toString(report.origin)},
                               {"file", pathText(library.filename())}});
  std::error_code ignored;
  if (fs::is_regular_file(library, ignored)) {
    value.set("sha256", sha256OfFile(library));
  }
  return value;
}

/// The plugins that serve and are wanted, by their id.
template <class Wanted>
Value pluginsOf(const plugin::PluginHost& plugins, const Wanted& wanted) {
  std::vector<plugin::PluginReport> used;
  for (plugin::PluginReport& report : plugins.reports()) {
    const bool serves = report.verdict == plugin::PluginVerdict::Available ||
                        report.verdict == plugin::PluginVerdict::Loaded;
    if (serves && wanted(report)) {
      used.push_back(std::move(report));
    }
  }
  std::sort(
      used.begin(), used.end(),
      [](const plugin::PluginReport& a, const plugin::PluginReport& b) { return a.id < b.id; });
  Value list = Value::array();
  for (const plugin::PluginReport& report : used) {
    list.push(pluginValue(report));
  }
  return list;
}

Value inputsOf(const Pipeline& pipeline) {
  Value inputs = Value::array();
  for (const auto& [path, sha256] : hashFiles(pipeline.document(), pipeline.file())) {
    inputs.push(Value::object({{"path", path}, {"sha256", sha256}}));
  }
  return inputs;
}

class FolderCheck {
public:
  explicit FolderCheck(const fs::path& folder) : folder_(folder) {}

  std::vector<Diagnostic> findings;

  void violation(const char* code, const Text& message, const Text& remedy = kExportAgain) {
    findings.push_back({Severity::Violation, code, message, remedy, {}, {}});
  }

  void warning(const char* code, const Text& message, const Text& remedy) {
    findings.push_back({Severity::Warning, code, message, remedy, {}, {}});
  }

  void files(const Value& report) {
    if (OutputSet::unfinished(folder_)) {
      violation("output.unfinished",
                text("a run was interrupted while its files took their places in %1",
                     {pathText(folder_)}));
    }
    std::set<fs::path> named = {kReportFile};
    for (const Value& entry : report.at("files").asArray()) {
      const std::string& path = entry.at("path").asString();
      named.insert(pathFromText(path).lexically_normal());
      file(path, entry.at("sha256").asString());
    }
    strangers(named);
    if (report.at("kept_back").size() > 0 || report.at("errors").size() > 0) {
      violation("output.incomplete",
                "the run gave no program for some operations or outputs, as its report says",
                "put right what the report names and export the project again");
    }
  }

  void origin(const Value& made, const Value& now) {
    same("output.other_project", made.at("project"), now.at("project"), "sha256",
         "the project has changed since the programs were made");
    list("output.changed_input", made.at("inputs"), now.at("inputs"), "path",
         "the input '%1' is not the one that the programs were made from");
    list("output.changed_plugin", made.at("plugins"), now.at("plugins"), "id",
         "the plugin '%1' is not the one that made the programs");
    if (!(made.at("settings") == now.at("settings"))) {
      violation("output.other_settings",
                text("the programs were made with other settings: %1",
                     {made.at("settings").size() == 0 ? std::string("none")
                                                      : toCompactJson(made.at("settings"))}),
                "export the project again, or check with the same --set");
    }
    if (!(made.at("wcam") == now.at("wcam"))) {
      warning("output.other_version",
              text("the programs were made by WCAM %1, this is %2",
                   {made.at("wcam").asString(), now.at("wcam").asString()}),
              "export the project again when the programs are to be those of this version");
    }
  }

private:
  void file(const std::string& path, const std::string& sha256) {
    const fs::path file = folder_ / pathFromText(path);
    std::error_code error;
    if (!fs::is_regular_file(fs::symlink_status(file, error))) {
      violation("output.missing", text("the file %1 of the report is missing", {path}));
    } else if (sha256OfFile(file) != sha256) {
      violation("output.changed",
                text("the file %1 is not the one that the report was written with", {path}));
    }
  }

  /// Files that no report names; those of interrupted runs are the program's own.
  void strangers(const std::set<fs::path>& named) {
    std::vector<fs::path> found;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder_, error), end; !error && it != end;
         it.increment(error)) {
      const fs::path path = it->path().lexically_relative(folder_);
      if (pathText(*path.begin()).starts_with(".wcam-")) {
        continue;
      }
      if (!it->is_directory() && named.count(path) == 0) {
        found.push_back(path);
      }
    }
    std::sort(found.begin(), found.end());
    for (const fs::path& path : found) {
      warning("output.unknown_file",
              text("the file %1 is not of the run that the report describes", {pathText(path)}),
              "move it elsewhere when it is the program of an earlier run");
    }
  }

  void same(
      const char* code, const Value& made, const Value& now, const char* key, const Text& message) {
    if (!(made.at(key) == now.at(key))) {
      violation(code, message);
    }
  }

  void list(
      const char* code, const Value& made, const Value& now, const char* key, const char* message) {
    std::set<std::string> names;
    for (const Value* side : {&made, &now}) {
      for (const Value& entry : side->asArray()) {
        names.insert(entry.at(key).asString());
      }
    }
    for (const std::string& name : names) {
      const Value* before = entryOf(made, key, name);
      const Value* after = entryOf(now, key, name);
      if (before == nullptr || after == nullptr || !(*before == *after)) {
        violation(code, text(message, {name}));
      }
    }
  }

  static const Value* entryOf(const Value& list, const char* key, const std::string& name) {
    for (const Value& entry : list.asArray()) {
      if (entry.at(key).asString() == name) {
        return &entry;
      }
    }
    return nullptr;
  }

  fs::path folder_;
};

}  // namespace

Value provenance(const Pipeline& pipeline,
                 const RunRequest& request,
                 const std::vector<std::string>& operations,
                 const std::vector<Output>& outputs) {
  std::set<std::string> components;
  for (const std::string& id : operations) {
    if (const Operation* operation = pipeline.document().project().operation(id)) {
      components.insert(operation->strategy);
    }
  }
  for (const Output& output : outputs) {
    components.insert(output.post);
  }
  Value settings = Value::array();
  for (const std::string& setting : request.settings) {
    settings.push(Value(setting));
  }
  const Document& stored = request.stored ? *request.stored : pipeline.document();
  const Value project = Value::object(
      {{"file", pathText(pipeline.file().filename())}, {"sha256", sha256Hex(stored.text())}});
  Value origin = Value::object({{"wcam", WCAM_VERSION}});
  return origin.set("project", project)
      .set("inputs", inputsOf(pipeline))
      .set("plugins", pluginsOf(pipeline.plugins(),
                                [&components](const plugin::PluginReport& report) {
                                  return std::any_of(report.components.begin(),
                                                     report.components.end(),
                                                     [&](const plugin::ComponentEntry& entry) {
                                                       return components.count(entry.id) != 0;
                                                     });
                                }))
      .set("settings", settings);
}

std::vector<Diagnostic> checkOutputs(const fs::path& folder,
                                     const Pipeline* pipeline,
                                     const RunRequest& request) {
  const fs::path file = folder / kReportFile;
  const Value report = parseJson(readFile(file), pathText(file));
  FolderCheck check(folder);
  try {
    check.files(report);
    if (pipeline != nullptr) {
      const Value& made = report.at("provenance");
      // Of the plugins only those count that the run has used.
      std::set<std::string> used;
      for (const Value& entry : made.at("plugins").asArray()) {
        used.insert(entry.at("id").asString());
      }
      Value now = provenance(*pipeline, request, {}, {});
      now.set("plugins",
              pluginsOf(pipeline->plugins(), [&used](const plugin::PluginReport& report) {
                return used.count(report.id) != 0;
              }));
      check.origin(made, now);
    }
  } catch (const Error& error) {
    if (error.code() != ErrorCode::InvalidArgument && error.code() != ErrorCode::Internal) {
      throw;
    }
    throw Error(ErrorCode::InputInvalid,
                "is not a report of this version of WCAM, which names files with their hashes",
                pathText(file), kExportAgain);
  }
  return check.findings;
}

}  // namespace wcam::project
