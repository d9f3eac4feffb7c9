// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/toolpath/edits.hpp"

#include "command_table.hpp"

namespace wcam::project::detail {

namespace {

/// The list of edits of the operation that the arguments name; made when it has none.
Value& mutableEdits(Value& tree, const Value& args) {
  const NodeType& operations = *nodeTypeOfList("operations");
  const std::size_t index = indexOf(tree, operations, args.at("operation").asString());
  Value& operation = mutableList(tree, operations).mutableArray()[index];
  if (!operation.contains("edits")) {
    setOrdered(operation, "edits", Value::array(), keyOrder(operations));
  }
  return *operation.findMutable("edits");
}

/// Position of the edit in its operation. @throws Error(InvalidArgument) with the nearest id
std::size_t editIndex(const Value& edits, const Value& args) {
  const std::string& id = args.at("id").asString();
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    ids.push_back(edits.asArray()[i].at("id").asString());
    if (ids.back() == id) {
      return i;
    }
  }
  refuse(didYouMean(text("operation '%1' has no edit '%2'", {args.at("operation").asString(), id}),
                    id, ids));
}

/// Edits are checked with their parameters at once: their schemas are the engine's own.
void checkEdit(const Value& edit) {
  std::vector<ParamProblem> problems;
  const Value* params = edit.find("params");
  const auto type = toolpath::editTypeOf(edit.at("type").asString());
  if (type && params != nullptr) {
    problems = toolpath::validateEdit(*type, *params, "params");
    std::erase_if(problems, [](const ParamProblem& p) { return p.unknown; });
  }
  throwProblems(problems, ErrorCode::InvalidArgument, {});
}

Value addEdit(const Document& document, const Value& args) {
  Value tree = document.tree();
  Value& edits = mutableEdits(tree, args);
  const Value& id = args.at("id");
  for (const Value& known : edits.asArray()) {
    if (known.at("id") == id) {
      refuse(text("there is an edit '%1' already", {id.asString()}), "choose another id");
    }
  }
  Value edit = Value::object();
  for (const std::string& key : keyOrder(editNode())) {
    if (const Value* value = args.find(key)) {
      edit.set(key, *value);
    }
  }
  checkEdit(edit);
  const Value* wanted = args.find("index");
  const std::size_t index =
      wanted != nullptr ? static_cast<std::size_t>(wanted->asInteger()) : edits.size();
  if (index > edits.size()) {
    refuse(edits.size() == 1
               ? text("index: the list has only 1 entry")
               : text("index: the list has only %1 entries", {std::to_string(edits.size())}));
  }
  auto& list = edits.mutableArray();
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(index), std::move(edit));
  return tree;
}

Value setEdit(const Document& document, const Value& args) {
  Value tree = document.tree();
  Value& edits = mutableEdits(tree, args);
  Value& edit = edits.mutableArray()[editIndex(edits, args)];
  for (const Field& field : editNode().fields) {
    const Value* value = args.find(field.key);
    if (value != nullptr && value->isNull()) {
      edit.remove(field.key);
    } else if (value != nullptr) {
      setOrdered(edit, field.key, *value, keyOrder(editNode()));
    }
  }
  // An edit that is wrong already may be left out or given another place.
  if (edit.contains("type") && (args.contains("type") || args.contains("params"))) {
    checkEdit(edit);
  }
  return tree;
}

Value setEditParam(const Document& document, const Value& args) {
  Value tree = document.tree();
  Value& edits = mutableEdits(tree, args);
  Value& edit = edits.mutableArray()[editIndex(edits, args)];
  const std::string& key = args.at("key").asString();
  if (key.empty()) {
    refuse("key: must not be empty");
  }
  const Value& value = args.at("value");
  if (!value.isNull()) {
    if (!edit.contains("params")) {
      setOrdered(edit, "params", Value::object(), keyOrder(editNode()));
    }
    edit.findMutable("params")->set(key, value);
  } else if (Value* params = edit.findMutable("params")) {
    params->remove(key);
  }
  return tree;
}

Value removeEdit(const Document& document, const Value& args) {
  Value tree = document.tree();
  Value& edits = mutableEdits(tree, args);
  const auto index = static_cast<std::ptrdiff_t>(editIndex(edits, args));
  auto& list = edits.mutableArray();
  list.erase(list.begin() + index);
  return tree;
}

Value renameEdit(const Document& document, const Value& args) {
  Value tree = document.tree();
  Value& edits = mutableEdits(tree, args);
  // A second edit of the same id is found when the document is read.
  edits.mutableArray()[editIndex(edits, args)].set("id", args.at("to"));
  return tree;
}

Value moveEdit(const Document& document, const Value& args) {
  Value tree = document.tree();
  Value& edits = mutableEdits(tree, args);
  const std::size_t from = editIndex(edits, args);
  const auto to = static_cast<std::size_t>(args.at("index").asInteger());
  if (to >= edits.size()) {
    refuse(edits.size() == 1
               ? text("index: the list has only 1 entry")
               : text("index: the list has only %1 entries", {std::to_string(edits.size())}));
  }
  auto& list = edits.mutableArray();
  const Value edit = list[from];
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(from));
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(to), edit);
  return tree;
}

}  // namespace

void defineEditCommands(std::vector<Definition>& all) {
  const Arg operation{"operation", FieldType::Id, true, "the operation"};
  const Arg id{"id", FieldType::Id, true, "the edit"};
  std::vector<Arg> addArgs = {operation, {"id", FieldType::Id, true, "a new id"}};
  std::vector<Arg> setArgs = {operation, id};
  for (const Field& field : editNode().fields) {
    addArgs.push_back({field.key, field.type, field.required, field.help});
    setArgs.push_back({field.key, field.type, false, field.help, !field.required});
  }
  addArgs.push_back({"index", FieldType::Index, false, "place in the list; none: at the end"});
  const auto named = [](const char* pattern) {
    return [pattern](const Value& args) {
      return text(pattern, {textArg(args, "id"), textArg(args, "operation")});
    };
  };
  all.push_back({"edit.add", "Adds an edit of the toolpath to an operation.", addArgs, addEdit,
                 named("Add edit %1 of %2")});
  all.push_back({"edit.set", "Sets keys of an edit; null removes a key.", setArgs, setEdit,
                 named("Set edit %1 of %2")});
  all.push_back({"edit.set_param",
                 "Sets one parameter of an edit; null removes it.",
                 {operation,
                  id,
                  {"key", FieldType::Text, true, "the parameter"},
                  {"value", FieldType::Any, true, "in file units", true}},
                 setEditParam,
                 [](const Value& args) {
                   return text("Set %1 of edit %2", {textArg(args, "key"), textArg(args, "id")});
                 }});
  all.push_back({"edit.remove",
                 "Removes an edit.",
                 {operation, id},
                 removeEdit,
                 named("Remove edit %1 of %2")});
  all.push_back({"edit.rename",
                 "Gives an edit another id.",
                 {operation, id, {"to", FieldType::Id, true, "the new id"}},
                 renameEdit,
                 named("Rename edit %1 of %2")});
  all.push_back({"edit.move",
                 "Moves an edit to another place in the order.",
                 {operation, id, {"index", FieldType::Index, true, "the new place"}},
                 moveEdit,
                 named("Move edit %1 of %2")});
}

}  // namespace wcam::project::detail
