// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/project/commands.hpp"

#include "file_schema.hpp"

#include <algorithm>

namespace wcam::project {

namespace {

[[noreturn]] void refuse(const Text& message, const Text& hint = {}) {
  throw Error(ErrorCode::InvalidArgument, message, "--set", hint);
}

/// A node, and a parameter or a plain field of it.
struct Target {
  const NodeType* type = nullptr;
  const Value* node = nullptr;
  std::string section;  ///< empty: a plain field
  ParamDef def;

  [[nodiscard]] std::string id() const { return node->at("id").asString(); }

  [[nodiscard]] std::string fullKey() const {
    return std::string(type->list) + "." + id() + "." + (section.empty() ? "" : section + ".") +
           def.info.key;
  }
};

ParamDef fieldDef(std::string key, ParamType type, QuantityKind kind = QuantityKind::None) {
  ParamDef def;
  def.info.key = std::move(key);
  def.type = type;
  def.quantity = kind;
  return def;
}

QuantityKind quantityOf(const std::string& key) {
  if (key.ends_with("_mm")) {
    return QuantityKind::Length;
  }
  return key.ends_with("_deg") ? QuantityKind::Angle : QuantityKind::None;
}

/// The plain fields of a node that one text can set.
std::vector<ParamDef> plainFields(const NodeType& type) {
  std::vector<ParamDef> defs;
  for (const Field& field : type.fields) {
    switch (field.type) {
      case FieldType::Bool:
        defs.push_back(fieldDef(field.key, ParamType::Bool));
        break;
      case FieldType::Id:
      case FieldType::Text:
      case FieldType::IdList:
        defs.push_back(fieldDef(field.key, ParamType::Text));
        break;
      case FieldType::Real:
        defs.push_back(fieldDef(field.key, ParamType::Real));
        break;
      case FieldType::Vector3:
      case FieldType::Size3:
        defs.push_back(fieldDef(field.key, ParamType::Vector3, quantityOf(field.key)));
        break;
      case FieldType::Placement:
        for (const char* part : {"position_mm", "rotation_deg"}) {
          defs.push_back(
              fieldDef(std::string(field.key) + "." + part, ParamType::Vector3, quantityOf(part)));
        }
        break;
      default:
        break;
    }
  }
  return defs;
}

class SettingReader {
public:
  SettingReader(const Document& document, const SchemaLookup& schemas)
      : document_(document), schemas_(schemas) {}

  std::vector<Target> targets(const std::string& key) {
    std::vector<Target> found = addressed(key);
    if (found.empty() && !nodeMatched_) {
      found = everywhere(key);
    }
    if (found.empty()) {
      refuseUnknown(key);
    }
    return found;
  }

private:
  [[noreturn]] void refuseUnknown(const std::string& key) const {
    const std::string missing = joinText(missing_, ", ");
    if (nodeMatched_ && !missing_.empty()) {
      throw Error(ErrorCode::PluginMissing,
                  wcam::text("'%1' cannot be set: no plugin provides %2", {key, missing}), "--set",
                  "install the plugin; `camcli plugins list` shows what there is");
    }
    // All keys of a project fill pages: the nearest is named, or where the list is.
    const Text plain = wcam::text("'%1' is no parameter of this project", {key});
    const auto near = nearestName(key, known_);
    const Text unknown = near ? wcam::text("%1; did you mean '%2'?", {plain, *near}) : plain;
    refuse(
        missing_.empty() ? unknown : wcam::text("%1 (no plugin provides %2)", {unknown, missing}),
        "write KEY, ID.KEY or ID.SECTION.KEY; `camcli schema` lists the parameters");
  }

  /// Nodes of a list, none when the file has no such list.
  const Value::Array& nodesOf(const NodeType& type) const {
    static const Value::Array kNone;
    const Value* nodes = document_.tree().find(type.list);
    return nodes != nullptr ? nodes->asArray() : kNone;
  }

  /// `id.key` and `id.section.key`, with or without the list in front.
  std::vector<Target> addressed(const std::string& key) {
    std::vector<Target> found;
    for (const NodeType& type : nodeTypes()) {
      const std::string prefix = std::string(type.list) + ".";
      for (const Value& node : nodesOf(type)) {
        const std::string id = node.at("id").asString() + ".";
        if (key.starts_with(prefix + id)) {
          inNode(type, node, key.substr(prefix.size() + id.size()), true, found);
        } else if (key.starts_with(id)) {
          inNode(type, node, key.substr(id.size()), true, found);
        }
      }
    }
    if (found.size() > 1) {
      std::vector<std::string> keys;
      for (const Target& target : found) {
        keys.push_back(target.fullKey());
      }
      refuse(wcam::text("'%1' has more than one meaning", {key}),
             wcam::text("write one of: %1", {joinText(keys, ", ")}));
    }
    return found;
  }

  /// The bare key: all operations that know it, else all nodes of the next list that do.
  std::vector<Target> everywhere(const std::string& key) {
    for (const char* list : {"operations", "outputs", "processes", "parts"}) {
      const NodeType& type = *nodeTypeOfList(list);
      std::vector<Target> found;
      for (const Value& node : nodesOf(type)) {
        const std::size_t before = found.size();
        inNode(type, node, key, false, found);
        if (found.size() > before + 1) {
          refuse(wcam::text("'%1' has more than one meaning in %2 '%3'",
                            {key, type.noun, node.at("id").asString()}),
                 wcam::text("write one of: %1, %2",
                            {found[before].fullKey(), found[before + 1].fullKey()}));
        }
      }
      if (!found.empty()) {
        return found;
      }
    }
    return {};
  }

  void inNode(const NodeType& type,
              const Value& node,
              const std::string& tail,
              bool withFields,
              std::vector<Target>& found) {
    nodeMatched_ = nodeMatched_ || withFields;
    for (const Field& field : type.fields) {
      if (field.type != FieldType::Object) {
        continue;
      }
      const std::string section = field.key;
      const bool named = tail.starts_with(section + ".");
      const auto schema = schemaOf(type, node, section);
      if (!schema) {
        continue;
      }
      for (const ParamDef& def : schema->defs()) {
        known_.push_back(withFields ? node.at("id").asString() + "." + def.info.key : def.info.key);
      }
      const ParamDef* def =
          schema->find(named ? std::string_view(tail).substr(section.size() + 1) : tail);
      if (def != nullptr) {
        found.push_back({&type, &node, section, *def});
      }
    }
    if (withFields) {
      for (const ParamDef& def : plainFields(type)) {
        known_.push_back(node.at("id").asString() + "." + def.info.key);
        if (def.info.key == tail) {
          found.push_back({&type, &node, {}, def});
        }
      }
    }
  }

  std::optional<ParamSchema> schemaOf(const NodeType& type,
                                      const Value& node,
                                      const std::string& section) {
    std::string component;
    if (section == "params") {
      for (const char* key : {"strategy", "post"}) {
        if (const Value* value = node.find(key)) {
          component = value->asString();
        }
      }
    }
    auto schema = schemas_({type.list, node.at("id").asString(), section, component});
    if (!schema && !component.empty() &&
        std::find(missing_.begin(), missing_.end(), component) == missing_.end()) {
      missing_.push_back(component);
    }
    return schema;
  }

  const Document& document_;
  const SchemaLookup& schemas_;
  std::vector<std::string> known_;    ///< keys that would have been possible
  std::vector<std::string> missing_;  ///< components without a schema
  bool nodeMatched_ = false;
};

/// `elbow.edits.slow.factor`, with or without `operations.` in front: the command that sets the
/// parameter of an edit; nothing when the key has another form.
std::optional<Command> editCommand(const Document& document,
                                   const std::string& fullKey,
                                   const std::string& text) {
  const std::string list = "operations.";
  const std::string key = fullKey.starts_with(list) ? fullKey.substr(list.size()) : fullKey;
  for (const Operation& operation : document.project().operations) {
    const std::string prefix = operation.id + ".edits.";
    if (!key.starts_with(prefix)) {
      continue;
    }
    std::vector<std::string> ids;
    for (const OperationEdit& edit : operation.edits) {
      ids.push_back(edit.id);
      const std::string own = prefix + edit.id + ".";
      if (!key.starts_with(own)) {
        continue;
      }
      const std::string name = key.substr(own.size());
      Value args = Value::object({{"operation", operation.id}, {"id", edit.id}});
      if (name == "enabled") {
        const ParamSchema schema({fieldDef(name, ParamType::Bool)});
        return Command{"edit.set", args.set(name, schema.parse(name, text))};
      }
      const ParamSchema schema = toolpath::editSchema(edit.type).params();
      if (schema.find(name) == nullptr) {
        std::vector<std::string> keys;
        for (const ParamDef& def : schema.defs()) {
          keys.push_back(def.info.key);
        }
        refuse(didYouMean(wcam::text("the edit '%1' has no parameter '%2'", {edit.id, name}), name,
                          keys));
      }
      return Command{"edit.set_param",
                     args.set("key", name).set("value", schema.parse(name, text))};
    }
    refuse(didYouMean(wcam::text("'%1' names no edit of operation '%2'", {fullKey, operation.id}),
                      key.substr(prefix.size(), key.rfind('.') - prefix.size()), ids));
  }
  return std::nullopt;
}

Value parseFor(const Target& target, const std::string& text) {
  return ParamSchema({target.def}).parse(target.def.info.key, text);
}

/// The value of a plain field of the file.
Value fieldValue(const Target& target, const std::string& key, const std::string& text) {
  const Field* field = target.type->field(key);
  if (field == nullptr || field->type != FieldType::IdList) {
    return parseFor(target, text);
  }
  Value ids = Value::array();
  for (const std::string& id : splitText(text, ',')) {
    if (!trimText(id).empty()) {
      ids.push(trimText(id));
    }
  }
  return ids;
}

void addCommands(const Target& target, const std::string& text, std::vector<Command>& commands) {
  const std::string noun = target.type->noun;
  const std::string& key = target.def.info.key;
  const Value id(target.id());
  if (target.section.empty()) {
    const std::size_t dot = key.find('.');
    const std::string field = key.substr(0, dot);
    Value value = fieldValue(target, field, text);
    if (dot != std::string::npos) {
      const Value* old = target.node->find(field);
      Value object = old != nullptr ? *old : Value::object();
      setOrdered(object, key.substr(dot + 1), std::move(value), {"position_mm", "rotation_deg"});
      value = std::move(object);
    }
    commands.push_back({noun + ".set", Value::object({{"id", id}, {field, value}})});
    return;
  }
  const auto setParam = [&](const std::string& name, Value value) {
    commands.push_back({noun + ".set_param", Value::object({{"id", id},
                                                            {"section", Value(target.section)},
                                                            {"key", Value(name)},
                                                            {"value", std::move(value)}})});
  };
  setParam(key, parseFor(target, text));
  // A former name of the parameter would stand beside the new one.
  const Value* params = target.node->find(target.section);
  for (const std::string& alias : target.def.info.aliases) {
    if (params != nullptr && params->contains(alias)) {
      setParam(alias, Value());
    }
  }
}

}  // namespace

std::vector<Command> commandsOfSetting(const Document& document,
                                       std::string_view setting,
                                       const SchemaLookup& schemas) {
  const std::size_t equal = setting.find('=');
  const std::string key(trimText(setting.substr(0, equal)));
  if (equal == std::string_view::npos || key.empty()) {
    refuse(wcam::text("'%1' is no setting", {std::string(setting)}),
           "write KEY=VALUE, for example step=2.5mm");
  }
  const std::string text(trimText(setting.substr(equal + 1)));
  if (auto edit = editCommand(document, key, text)) {
    return {std::move(*edit)};
  }
  std::vector<Command> commands;
  for (const Target& target : SettingReader(document, schemas).targets(key)) {
    try {
      addCommands(target, text, commands);
    } catch (const Error& error) {
      throw Error(error.code(), error.messageText(), wcam::text("--set %1", {target.fullKey()}),
                  error.hintText());
    }
  }
  return commands;
}

}  // namespace wcam::project
