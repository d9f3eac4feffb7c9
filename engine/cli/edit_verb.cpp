// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/text.hpp"
#include "wcam/project/history.hpp"
#include "wcam/project/project_file.hpp"
#include "wcam/toolpath/edits.hpp"

#include "changed_project.hpp"
#include "verbs.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <utility>

namespace wcam::cli {

namespace {

const project::Operation& operationOf(const project::Document& document, const std::string& id) {
  const project::Operation* operation = document.project().operation(id);
  if (operation != nullptr) {
    return *operation;
  }
  std::vector<std::string> ids;
  for (const project::Operation& known : document.project().operations) {
    ids.push_back(known.id);
  }
  const auto near = nearestName(id, ids);
  throw Error(ErrorCode::InvalidArgument, "the project has no operation '" + id + "'", {},
              near ? "did you mean '" + *near + "'?" : "operations: " + joinText(ids, ", "));
}

const project::OperationEdit& editOf(const project::Operation& operation, const std::string& id) {
  std::vector<std::string> ids;
  for (const project::OperationEdit& edit : operation.edits) {
    if (edit.id == id) {
      return edit;
    }
    ids.push_back(edit.id);
  }
  const auto near = nearestName(id, ids);
  throw Error(ErrorCode::InvalidArgument,
              "operation '" + operation.id + "' has no edit '" + id + "'", {},
              near          ? "did you mean '" + *near + "'?"
              : ids.empty() ? "there is none yet; `camcli edit add` adds one"
                            : "edits: " + joinText(ids, ", "));
}

toolpath::EditType typeOf(const std::string& word) {
  if (const auto type = toolpath::editTypeOf(word)) {
    return *type;
  }
  std::vector<std::string> keys;
  for (const toolpath::EditTypeInfo& info : toolpath::editTypes()) {
    keys.emplace_back(info.key);
  }
  const auto near = nearestName(word, keys);
  throw Error(ErrorCode::InvalidArgument, "'" + word + "' is no type of edit", {},
              near ? "did you mean '" + *near + "'?" : "types: " + joinText(keys, ", "));
}

/// The parameters after all --set KEY=VALUE; KEY= alone takes the default again.
Value changedParams(toolpath::EditType type,
                    Value params,
                    const std::vector<std::string>& settings) {
  const ParamSchema schema = toolpath::editSchema(type).params();
  std::vector<ParamProblem> problems;
  for (const std::string& setting : settings) {
    const std::size_t equal = setting.find('=');
    const std::string key(trimText(setting.substr(0, equal)));
    if (equal == std::string::npos || key.empty()) {
      problems.push_back({setting, "write KEY=VALUE, for example first_layer=3", false});
      continue;
    }
    const std::string text(trimText(setting.substr(equal + 1)));
    try {
      if (text.empty()) {
        params.remove(key);
      } else {
        params.set(key, schema.parse(key, text));
      }
    } catch (const Error& error) {
      problems.push_back(
          {key, error.message() + (error.hint().empty() ? "" : "; " + error.hint()), false});
    }
  }
  throwProblems(problems, ErrorCode::InvalidArgument, "--set");
  return params;
}

std::string freeId(const project::Operation& operation, const std::string& base) {
  const auto taken = [&operation](const std::string& id) {
    return std::any_of(operation.edits.begin(), operation.edits.end(),
                       [&id](const project::OperationEdit& edit) { return edit.id == id; });
  };
  std::string id = base;
  for (int i = 2; taken(id); ++i) {
    id = base + "_" + std::to_string(i);
  }
  return id;
}

/// What a command has done, by its label: "Add edit …" has "Added edit …".
std::string doneText(const std::string& label) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kForms = {
      {{"Add ", "Added "},
       {"Remove ", "Removed "},
       {"Move ", "Moved "},
       {"Rename ", "Renamed "},
       {"Pin ", "Pinned "},
       {"Set ", "Set "}}};
  for (const auto& [now, done] : kForms) {
    if (label.starts_with(now)) {
      return std::string(done) + label.substr(now.size());
    }
  }
  return label;
}

/// Applies a command to the project file, whose lock is held since it was read, and saves it.
int changeProject(const Session& session,
                  const ChangedProject& changed,
                  const project::Command& command) {
  const std::filesystem::path file = pathFromText(session.options.file);
  changed.save(session, project::apply(changed.loaded.document, command));
  session.console.say(doneText(project::labelOf(command).str()) + ", saved " + pathText(file));
  if (session.options.json) {
    std::fputs(toCanonicalJson(project::toValue(command)).c_str(), stdout);
  }
  return 0;
}

project::Document load(const Session& session) {
  return project::loadProject(pathFromText(session.options.file)).document;
}

Value argsOf(const Options& options) {
  return Value::object({{"operation", options.editedOperation}, {"id", options.edit}});
}

std::string valueText(const Value& value) {
  std::string text = toCompactJson(value);
  return value.isString() ? value.asString() : text;
}

}  // namespace

int editListVerb(const Session& session) {
  const project::Document document = load(session);
  const std::string& wanted = session.options.editedOperation;
  if (!wanted.empty()) {
    static_cast<void>(operationOf(document, wanted));
  }
  Value list = Value::array();
  std::string text;
  for (const project::Operation& operation : document.project().operations) {
    for (const project::OperationEdit& edit : operation.edits) {
      if (!wanted.empty() && operation.id != wanted) {
        continue;
      }
      const char* type = toolpath::infoOf(edit.type).key;
      list.push(Value::object({{"operation", operation.id},
                               {"id", edit.id},
                               {"type", type},
                               {"enabled", edit.enabled},
                               {"params", edit.params}}));
      text += operation.id + "  " + edit.id + "  " + type + (edit.enabled ? "" : "  (disabled)");
      for (const auto& [key, value] : edit.params.asObject()) {
        text += "  " + key + "=" + valueText(value);
      }
      text += "\n";
    }
  }
  std::fputs(
      (session.options.json ? toCanonicalJson(Value::object({{"edits", list}})) : printable(text))
          .c_str(),
      stdout);
  return 0;
}

int editTypesVerb(const Session& session) {
  Value list = Value::array();
  std::string text;
  for (const toolpath::EditTypeInfo& info : toolpath::editTypes()) {
    list.push(Value::object({{"type", info.key}, {"name", info.name}, {"summary", info.summary}}));
    text += std::string(info.key) + "  " + info.summary + "\n";
  }
  std::fputs(
      (session.options.json ? toCanonicalJson(Value::object({{"types", list}})) : text).c_str(),
      stdout);
  return 0;
}

int editAddVerb(const Session& session) {
  const Options& options = session.options;
  const ChangedProject changed(pathFromText(session.options.file));
  const project::Document& document = changed.loaded.document;
  const project::Operation& operation = operationOf(document, options.editedOperation);
  const toolpath::EditType type = typeOf(options.editType);
  Value args = Value::object(
      {{"operation", operation.id},
       {"id", options.edit.empty() ? freeId(operation, options.editType) : options.edit},
       {"type", options.editType}});
  if (options.disable) {
    args.set("enabled", false);
  }
  args.set("params", changedParams(type, Value::object(), options.settings));
  if (options.index >= 0) {
    args.set("index", options.index);
  }
  return changeProject(session, changed, {"edit.add", args});
}

int editSetVerb(const Session& session) {
  const Options& options = session.options;
  const ChangedProject changed(pathFromText(session.options.file));
  const project::Document& document = changed.loaded.document;
  const project::OperationEdit& edit =
      editOf(operationOf(document, options.editedOperation), options.edit);
  Value args = argsOf(options);
  if (!options.settings.empty()) {
    args.set("params", changedParams(edit.type, edit.params, options.settings));
  }
  if (options.disable) {
    args.set("enabled", false);
  } else if (options.enable) {
    args.set("enabled", Value());
  }
  if (args.size() == 2) {
    throw Error(ErrorCode::InvalidArgument, "nothing was given to change", {},
                "give --set KEY=VALUE, --enable or --disable");
  }
  return changeProject(session, changed, {"edit.set", args});
}

int editRemoveVerb(const Session& session) {
  const ChangedProject changed(pathFromText(session.options.file));
  const project::Document& document = changed.loaded.document;
  editOf(operationOf(document, session.options.editedOperation), session.options.edit);
  return changeProject(session, changed, {"edit.remove", argsOf(session.options)});
}

int editMoveVerb(const Session& session) {
  const ChangedProject changed(pathFromText(session.options.file));
  const project::Document& document = changed.loaded.document;
  editOf(operationOf(document, session.options.editedOperation), session.options.edit);
  Value args = argsOf(session.options);
  args.set("index", session.options.index);
  return changeProject(session, changed, {"edit.move", args});
}

}  // namespace wcam::cli
