// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/commands.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/project/project_file.hpp"

#include "command_table.hpp"
#include "file_schema.hpp"

#include <algorithm>

namespace wcam::project {

namespace detail {

void refuse(const Text& message, const Text& hint) {
  throw Error(ErrorCode::InvalidArgument, message, {}, hint);
}

std::string textArg(const Value& args, const char* key) {
  const Value* value = args.find(key);
  return value != nullptr && value->isString() ? value->asString() : std::string();
}

std::vector<std::string> idsOf(const Value& tree, const char* list) {
  std::vector<std::string> ids;
  if (const Value* nodes = tree.find(list)) {
    for (const Value& node : nodes->asArray()) {
      ids.push_back(node.at("id").asString());
    }
  }
  return ids;
}

std::size_t indexOf(const Value& tree, const NodeType& type, const std::string& id) {
  const std::vector<std::string> ids = idsOf(tree, type.list);
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end()) {
    refuse(didYouMean(text("there is no %1 '%2'", {type.noun, id}), id, ids));
  }
  return static_cast<std::size_t>(found - ids.begin());
}

Value& mutableList(Value& tree, const NodeType& type) {
  if (!tree.contains(type.list)) {
    setOrdered(tree, type.list, Value::array(), topLevelKeys());
  }
  return *tree.findMutable(type.list);
}

}  // namespace detail

namespace {

using namespace detail;

Value& mutableNode(Value& tree, const NodeType& type, const Value& args) {
  const std::size_t index = indexOf(tree, type, args.at("id").asString());
  return mutableList(tree, type).mutableArray()[index];
}

/// Calls visit(node type, node, field) for every key that refers to nodes of `list`.
template <class Visit>
void forReferences(const Value& tree, std::string_view list, const Visit& visit) {
  for (const NodeType& type : nodeTypes()) {
    const Value* nodes = tree.find(type.list);
    for (const Field& field : type.fields) {
      if (nodes == nullptr || field.references == nullptr || list != field.references) {
        continue;
      }
      for (std::size_t i = 0; i < nodes->size(); ++i) {
        if (const Value* value = nodes->asArray()[i].find(field.key)) {
          visit(type, i, field, *value);
        }
      }
    }
  }
}

bool refersTo(const Value& reference, const std::string& id) {
  if (reference.isString()) {
    return reference.asString() == id;
  }
  const auto& items = reference.asArray();
  return std::any_of(items.begin(), items.end(), [&](const Value& v) { return v == Value(id); });
}

Value addNode(const NodeType& type, const Document& document, const Value& args) {
  Value tree = document.tree();
  const std::string& id = args.at("id").asString();
  const std::vector<std::string> ids = idsOf(tree, type.list);
  if (std::find(ids.begin(), ids.end(), id) != ids.end()) {
    refuse(text("there is a %1 '%2' already", {type.noun, id}), "choose another id");
  }
  Value node = Value::object();
  for (const std::string& key : keyOrder(type)) {
    if (const Value* value = args.find(key)) {
      node.set(key, *value);
    }
  }
  auto& nodes = mutableList(tree, type).mutableArray();
  std::size_t index = nodes.size();
  if (const Value* wanted = args.find("index")) {
    index = static_cast<std::size_t>(wanted->asInteger());
    if (index > nodes.size()) {
      refuse(nodes.size() == 1
                 ? text("index: the list has only 1 entry")
                 : text("index: the list has only %1 entries", {std::to_string(nodes.size())}));
    }
  }
  nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(index), std::move(node));
  return tree;
}

Value removeNode(const NodeType& type, const Document& document, const Value& args) {
  Value tree = document.tree();
  const std::string& id = args.at("id").asString();
  const std::size_t index = indexOf(tree, type, id);
  std::vector<Text> users;
  forReferences(
      tree, type.list,
      [&](const NodeType& user, std::size_t i, const Field&, const Value& reference) {
        if (refersTo(reference, id)) {
          users.push_back(
              text("%1 '%2'", {user.noun, tree.at(user.list).asArray()[i].at("id").asString()}));
        }
      });
  if (!users.empty()) {
    refuse(text("%1 '%2' is used by %3", {type.noun, id, joinTexts(users, ", ")}),
           "change or remove what uses it first");
  }
  auto& nodes = mutableList(tree, type).mutableArray();
  nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(index));
  return tree;
}

Value setNode(const NodeType& type, const Document& document, const Value& args) {
  Value tree = document.tree();
  Value& node = mutableNode(tree, type, args);
  const std::vector<std::string> order = keyOrder(type);
  for (const auto& [key, value] : args.asObject()) {
    if (key == "id") {
      continue;
    }
    if (value.isNull()) {
      node.remove(key);
    } else {
      setOrdered(node, key, value, order);
    }
  }
  return tree;
}

Value renameNode(const NodeType& type, const Document& document, const Value& args) {
  Value tree = document.tree();
  const std::string id = args.at("id").asString();
  const Value to = args.at("to");
  const std::vector<std::string> ids = idsOf(tree, type.list);
  mutableNode(tree, type, args).set("id", to);
  if (id != to.asString() && std::find(ids.begin(), ids.end(), to.asString()) != ids.end()) {
    refuse(text("there is a %1 '%2' already", {type.noun, to.asString()}), "choose another id");
  }
  forReferences(document.tree(), type.list,
                [&](const NodeType& user, std::size_t i, const Field& field, const Value& old) {
                  if (!refersTo(old, id)) {
                    return;
                  }
                  Value& node = mutableList(tree, user).mutableArray()[i];
                  Value& reference = *node.findMutable(field.key);
                  if (reference.isString()) {
                    reference = to;
                  } else {
                    auto& items = reference.mutableArray();
                    std::replace(items.begin(), items.end(), Value(id), to);
                  }
                });
  return tree;
}

Value moveNode(const NodeType& type, const Document& document, const Value& args) {
  Value tree = document.tree();
  const std::size_t from = indexOf(tree, type, args.at("id").asString());
  const auto to = static_cast<std::size_t>(args.at("index").asInteger());
  auto& nodes = mutableList(tree, type).mutableArray();
  if (to >= nodes.size()) {
    refuse(nodes.size() == 1
               ? text("index: the list has only 1 entry")
               : text("index: the list has only %1 entries", {std::to_string(nodes.size())}));
  }
  const Value node = nodes[from];
  nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(from));
  nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(to), node);
  return tree;
}

std::vector<std::string> sectionsOf(const NodeType& type) {
  std::vector<std::string> sections;
  for (const Field& field : type.fields) {
    if (field.type == FieldType::Object) {
      sections.emplace_back(field.key);
    }
  }
  return sections;
}

Value setParam(const NodeType& type, const Document& document, const Value& args) {
  Value tree = document.tree();
  const std::vector<std::string> sections = sectionsOf(type);
  const Value* given = args.find("section");
  const std::string section = given != nullptr ? given->asString() : sections.front();
  if (std::find(sections.begin(), sections.end(), section) == sections.end()) {
    refuse(text("section: '%1' is not one of: %2", {section, joinText(sections, ", ")}));
  }
  const std::string& key = args.at("key").asString();
  if (key.empty()) {
    refuse("key: must not be empty");
  }
  Value& node = mutableNode(tree, type, args);
  const Value& value = args.at("value");
  if (!value.isNull()) {
    if (!node.contains(section)) {
      setOrdered(node, section, Value::object(), keyOrder(type));
    }
    node.findMutable(section)->set(key, value);
  } else if (Value* params = node.findMutable(section)) {
    params->remove(key);
  }
  return tree;
}

/// The commands that every kind of node has.
void defineNodeCommands(const NodeType& type, std::vector<Definition>& all) {
  const std::string noun = type.noun;
  const Arg id{"id", FieldType::Id, true, "the " + noun};
  const auto bind = [&type](Value (*function)(const NodeType&, const Document&, const Value&)) {
    return [&type, function](const Document& d, const Value& a) { return function(type, d, a); };
  };
  std::vector<Arg> addArgs = {{"id", FieldType::Id, true, "a new id"}};
  std::vector<Arg> setArgs = {id};
  for (const Field& field : type.fields) {
    addArgs.push_back({field.key, field.type, field.required, field.help});
    setArgs.push_back({field.key, field.type, false, field.help, true});
  }
  addArgs.push_back({"index", FieldType::Index, false, "place in the list; none: at the end"});
  const auto named = [&type](const char* pattern) {
    return [&type, pattern](const Value& args) {
      return text(pattern, {type.noun, textArg(args, "id")});
    };
  };
  all.push_back(
      {noun + ".add", "Adds a " + noun + ".", addArgs, bind(addNode), named("Add %1 %2")});
  all.push_back({noun + ".remove",
                 "Removes a " + noun + " that nothing uses.",
                 {id},
                 bind(removeNode),
                 named("Remove %1 %2")});
  all.push_back(
      {noun + ".set", "Sets keys of a " + noun + "; null removes a key.", setArgs, bind(setNode),
       [&type](const Value& args) {
         std::vector<std::string> keys;
         for (const auto& [key, value] : args.asObject()) {
           if (key != "id") {
             keys.push_back(key);
           }
         }
         return text("Set %1 of %2 %3", {joinText(keys, ", "), type.noun, textArg(args, "id")});
       }});
  all.push_back(
      {noun + ".rename",
       "Gives a " + noun + " another id, also where it is used.",
       {id, {"to", FieldType::Id, true, "the new id"}},
       bind(renameNode),
       [&type](const Value& args) {
         return text("Rename %1 %2 to %3", {type.noun, textArg(args, "id"), textArg(args, "to")});
       }});
  all.push_back({noun + ".move",
                 "Moves a " + noun + " to another place in its list.",
                 {id, {"index", FieldType::Index, true, "the new place"}},
                 bind(moveNode),
                 named("Move %1 %2")});
  if (const auto sections = sectionsOf(type); !sections.empty()) {
    all.push_back({noun + ".set_param",
                   "Sets one parameter of a " + noun + "; null removes it.",
                   {id,
                    {"section", FieldType::Text, false,
                     "one of: " + joinText(sections, ", ") + "; none: " + sections.front()},
                    {"key", FieldType::Text, true, "the parameter"},
                    {"value", FieldType::Any, true, "in file units", true}},
                   bind(setParam),
                   [](const Value& args) {
                     return text("Set %1 of %2", {textArg(args, "key"), textArg(args, "id")});
                   }});
  }
}

Value pinFiles(const Document& document, const Value& args) {
  Value tree = document.tree();
  const Value& hashes = args.at("files");
  std::vector<std::string> known;
  const auto pin = [&](Value& file) {
    const std::string& path = file.at("path").asString();
    known.push_back(path);
    if (const Value* hash = hashes.find(path)) {
      file.set("sha256", *hash);
    }
  };
  if (Value* cell = tree.findMutable("cell")) {
    pin(*cell);
  }
  for (const char* list : {"parts", "guides", "processes", "operations"}) {
    const std::size_t count = tree.contains(list) ? tree.at(list).size() : 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (tree.at(list).asArray()[i].contains("file")) {
        pin(*tree.findMutable(list)->mutableArray()[i].findMutable("file"));
      }
    }
  }
  for (const auto& [path, hash] : hashes.asObject()) {
    if (std::find(known.begin(), known.end(), path) == known.end()) {
      refuse(didYouMean(text("files: the project uses no file '%1'", {path}), path, known));
    }
  }
  return tree;
}

std::vector<Definition> defineAll() {
  std::vector<Definition> all;
  for (const NodeType& type : nodeTypes()) {
    defineNodeCommands(type, all);
  }
  defineEditCommands(all);
  const auto fixed = [](const char* label) {
    return [label](const Value&) { return text(label); };
  };
  all.push_back({"cell.set",
                 "Chooses the cell file.",
                 {{"file", FieldType::File, true, "cell file"}},
                 [](const Document& document, const Value& args) {
                   Value tree = document.tree();
                   setOrdered(tree, "cell", args.at("file"), topLevelKeys());
                   return tree;
                 },
                 fixed("Set cell")});
  all.push_back({"cell.remove",
                 "Leaves the project without a cell.",
                 {},
                 [](const Document& document, const Value&) {
                   Value tree = document.tree();
                   tree.remove("cell");
                   return tree;
                 },
                 fixed("Remove cell")});
  all.push_back({"project.rename",
                 "Gives the project a name.",
                 {{"name", FieldType::Text, true, "the new name"}},
                 [](const Document& document, const Value& args) {
                   Value tree = document.tree();
                   setOrdered(tree, "name", args.at("name"), topLevelKeys());
                   return tree;
                 },
                 fixed("Rename project")});
  all.push_back({"file.pin",
                 "Stores the SHA-256 of files, so that a change is noticed.",
                 {{"files", FieldType::Hashes, true, "SHA-256 by path"}},
                 pinFiles,
                 fixed("Pin files")});
  std::sort(all.begin(), all.end(),
            [](const Definition& a, const Definition& b) { return a.id < b.id; });
  return all;
}

const std::vector<Definition>& definitions() {
  static const std::vector<Definition> kAll = defineAll();
  return kAll;
}

const Definition* definitionOf(std::string_view id) {
  for (const Definition& definition : definitions()) {
    if (definition.id == id) {
      return &definition;
    }
  }
  return nullptr;
}

/// All wrong, unknown and missing arguments at once.
void checkArgs(const Definition& definition, const Value& args) {
  if (!args.isObject()) {
    refuse(text("the arguments must be an object, got %1", {toString(args.type())}));
  }
  std::vector<ParamProblem> problems;
  checkWritable(args, {}, problems);
  std::vector<std::string> keys;
  for (const Arg& arg : definition.args) {
    keys.push_back(arg.key);
    const Value* value = args.find(arg.key);
    if (value == nullptr) {
      if (arg.required) {
        problems.push_back({arg.key, "is missing", false});
      }
    } else if (!(arg.nullable && value->isNull())) {
      checkField(*value, arg.type, arg.key, problems);
    }
  }
  for (const auto& [key, value] : args.asObject()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      problems.push_back({key, didYouMean("is no argument of this command", key, keys), true});
    }
  }
  throwProblems(problems, ErrorCode::InvalidArgument, {});
}

Value schemaOf(FieldType type) {
  const auto vector = [](Value item) {
    return Value::object(
        {{"type", "array"}, {"items", std::move(item)}, {"minItems", 3}, {"maxItems", 3}});
  };
  const Value number = Value::object({{"type", "number"}});
  const Value text = Value::object({{"type", "string"}});
  const Value id = Value::object({{"type", "string"}, {"pattern", "^[a-z0-9][a-z0-9_.-]{0,63}$"}});
  const Value hash = Value::object({{"type", "string"}, {"pattern", "^([0-9a-f]{64})?$"}});
  const Value index = Value::object({{"type", "integer"}, {"minimum", 0}});
  switch (type) {
    case FieldType::Id:
      return id;
    case FieldType::Text:
      return text;
    case FieldType::Bool:
      return Value::object({{"type", "boolean"}});
    case FieldType::Real:
      return number;
    case FieldType::Vector3:
    case FieldType::Angles3:
      return vector(number);
    case FieldType::Size3:
      return vector(Value::object({{"type", "number"}, {"exclusiveMinimum", 0}}));
    case FieldType::File:
      return Value::object({{"type", "object"},
                            {"properties", Value::object({{"path", text}, {"sha256", hash}})},
                            {"required", Value(Value::Array{Value("path")})}});
    case FieldType::Placement:
      return Value::object({{"type", "object"},
                            {"properties", Value::object({{"position_mm", vector(number)},
                                                          {"rotation_deg", vector(number)}})}});
    case FieldType::Object:
      return Value::object({{"type", "object"}});
    case FieldType::IdList:
      return Value::object({{"type", "array"}, {"items", id}, {"uniqueItems", true}});
    case FieldType::IndexList:
      return Value::object({{"type", "array"}, {"items", index}, {"uniqueItems", true}});
    case FieldType::Edge:
      return Value::object({{"anyOf", Value(Value::Array{index, text})}});
    case FieldType::Index:
      return index;
    case FieldType::Any:
      return Value::object();
    case FieldType::Edits:
      return Value::object(
          {{"type", "array"},
           {"items",
            Value::object(
                {{"type", "object"},
                 {"properties", Value::object({{"id", id},
                                               {"type", text},
                                               {"enabled", Value::object({{"type", "boolean"}})},
                                               {"params", Value::object({{"type", "object"}})}})},
                 {"required", Value(Value::Array{Value("id"), Value("type")})}})}});
    case FieldType::Hashes:
      return Value::object({{"type", "object"}, {"additionalProperties", hash}});
  }
  return Value::object();
}

}  // namespace

const std::vector<CommandInfo>& commandCatalog() {
  static const std::vector<CommandInfo> kCatalog = [] {
    std::vector<CommandInfo> catalog;
    for (const Definition& definition : definitions()) {
      CommandInfo info{definition.id, definition.summary, {}};
      for (const Arg& arg : definition.args) {
        info.args.push_back({arg.key, toString(arg.type), arg.required, arg.nullable, arg.help});
      }
      catalog.push_back(std::move(info));
    }
    return catalog;
  }();
  return kCatalog;
}

Value CommandInfo::jsonSchema() const {
  const Definition* definition = definitionOf(id);
  WCAM_ASSERT(definition != nullptr);
  Value properties = Value::object();
  Value required = Value::array();
  for (const Arg& arg : definition->args) {
    Value property = schemaOf(arg.type);
    if (arg.nullable && property.contains("type")) {
      property.set("type", Value(Value::Array{property.at("type"), Value("null")}));
    } else if (arg.nullable && property.contains("anyOf")) {
      property.findMutable("anyOf")->push(Value::object({{"type", "null"}}));
    }
    property.set("description", arg.help);
    properties.set(arg.key, property);
    if (arg.required) {
      required.push(arg.key);
    }
  }
  return Value::object({{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                        {"title", id},
                        {"description", summary},
                        {"type", "object"},
                        {"properties", properties},
                        {"required", required},
                        {"additionalProperties", false}});
}

Document apply(const Document& document, const Command& command) {
  if (document.readOnly()) {
    throw Error(ErrorCode::ProjectReadOnly,
                "the project was written by a newer version and cannot be changed by this one",
                command.id, "use the newer version of WCAM");
  }
  const Definition* definition = definitionOf(command.id);
  if (definition == nullptr) {
    std::vector<std::string> ids;
    for (const Definition& known : definitions()) {
      ids.push_back(known.id);
    }
    const auto near = nearestName(command.id, ids);
    throw Error(ErrorCode::InvalidArgument, text("'%1' is no command", {command.id}), {},
                near ? text("did you mean '%1'?", {*near}) : text("see the list of commands"));
  }
  try {
    checkArgs(*definition, command.args);
    Value tree = definition->apply(document, command.args);
    return tree == document.tree() ? document : Document::parse(std::move(tree));
  } catch (const Error& error) {
    throw Error(ErrorCode::InvalidArgument, error.messageText(), command.id, error.hintText());
  }
}

Text labelOf(const Command& command) {
  const Definition* definition = definitionOf(command.id);
  return definition != nullptr && command.args.isObject() ? definition->label(command.args)
                                                          : command.id;
}

Value toValue(const Command& command) {
  return Value::object({{"command", Value(command.id)}, {"args", command.args}});
}

Command commandFromValue(const Value& value) {
  const Value* id = value.find("command");
  if (id == nullptr || !id->isString()) {
    refuse("a command is an object with the keys 'command' and 'args'");
  }
  const Value* args = value.find("args");
  return {id->asString(), args != nullptr ? *args : Value::object()};
}

Command pinCommand(const Document& document, const std::filesystem::path& project) {
  Value files = Value::object();
  for (const auto& [path, hash] : hashFiles(document, project)) {
    files.set(path, Value(hash));
  }
  return {"file.pin", Value::object({{"files", files}})};
}

}  // namespace wcam::project
