// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/param.hpp"
#include "wcam/base/value.hpp"
#include "wcam/project/document.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wcam::project {

/// A change of a document as data: what the log stores and what every editor sends.
struct Command {
  std::string id;  ///< "operation.add"
  Value args;      ///< an object, see CommandInfo::args
  friend bool operator==(const Command&, const Command&) = default;
};

/// One argument of a command.
struct ArgInfo {
  std::string key;
  std::string type;  ///< "id", "text", "file", "vector3", ...; see CommandInfo::jsonSchema
  bool required = false;
  bool nullable = false;  ///< null removes the key
  std::string help;
};

struct CommandInfo {
  std::string id;
  std::string summary;
  std::vector<ArgInfo> args;

  /// JSON Schema 2020-12 of the arguments.
  [[nodiscard]] Value jsonSchema() const;
};

/// Every command, sorted by id.
const std::vector<CommandInfo>& commandCatalog();

/// The document after a command. Pure: the old document is never touched.
/// @throws Error(InvalidArgument) listing all wrong arguments, or what would make the document
/// invalid; Error(ProjectReadOnly)
[[nodiscard]] Document apply(const Document& document, const Command& command);

/// Short text for the undo menu: "Set step of elbow".
[[nodiscard]] Text labelOf(const Command& command);

/// {"command": id, "args": {...}} and back. @throws Error(InvalidArgument)
Value toValue(const Command& command);
Command commandFromValue(const Value& value);

/// The command that pins every file of the document to its present content.
/// @throws Error(InputNotFound)
Command pinCommand(const Document& document, const std::filesystem::path& project);

/// The component whose schema knows the parameters of a node: strategy and post ids are components;
/// the other sections belong to the engine.
struct ParamSection {
  std::string list;       ///< "operations", "outputs", "processes", "parts"
  std::string id;         ///< id of the node
  std::string section;    ///< "params", "path", "motion", "import"
  std::string component;  ///< strategy or post of the node; empty for the engine's own
};

/// Gives the schema of a section, or nothing when its plugin is missing.
using SchemaLookup = std::function<std::optional<ParamSchema>(const ParamSection&)>;

/// The commands of `--set KEY=VALUE`. KEY is one of
/// - `step`: all operations that have such a parameter, else all outputs, processes and parts;
/// - `elbow.step`, `elbow.params.step`: that node (ids may contain dots);
/// - `operations.elbow.params.step`: the same in full;
/// - `elbow.edits.slow.factor`, `elbow.edits.slow.enabled`: a parameter of an edit of an operation;
/// - `elbow.enabled`, `plate.position_mm`, ...: plain fields of nodes.
/// VALUE is converted by the schema of the parameter ("2.5mm", "30deg", "1, 2, 3").
/// @throws Error(InvalidArgument) for an unknown or ambiguous key or a wrong value, with near names
std::vector<Command> commandsOfSetting(const Document& document,
                                       std::string_view setting,
                                       const SchemaLookup& schemas);

}  // namespace wcam::project
