// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "node_form.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/text.hpp"
#include "wcam/plugin/locations.hpp"
#include "wcam/toolpath/edits.hpp"

#include "model/generation.hpp"
#include "widgets/text.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <tuple>

namespace wcam::gui {

namespace {

// The choice of nothing: no id, since those begin with a letter or digit.
constexpr const char* kNoChoice = "-";
// In front of the keys of a part's placement.
constexpr const char* kPlacement = "placement_";

/// The place of the texts of this file for translators.
class NodeText {
  Q_DECLARE_TR_FUNCTIONS(NodeText)
};

const Value* nodeValue(const project::Document& document, const NodeRef& node) {
  const Value* list = document.tree().find(node.list);
  if (list == nullptr || !list->isArray()) {
    return nullptr;
  }
  for (const Value& item : list->asArray()) {
    if (item.find("id") != nullptr && item.at("id").asString() == node.id) {
      return &item;
    }
  }
  return nullptr;
}

/// The defs of the plain fields and the values that the node has.
class Fields {
public:
  Fields(const project::Document& document, const Value& node) : document_(document), node_(node) {}

  ParamDef& add(const std::string& key,
                const QString& label,
                ParamType type,
                Value initial,
                QuantityKind quantity = QuantityKind::None,
                const QString& help = {}) {
    ParamDef def;
    def.info.key = key;
    def.info.label = utf8(label);
    def.info.help = utf8(help);
    def.type = type;
    def.quantity = quantity;
    def.defaultValue = std::move(initial);
    defs_.push_back(std::move(def));
    return defs_.back();
  }

  void addChoice(const std::string& key,
                 const QString& label,
                 std::vector<ParamChoice> choices,
                 const QString& help = {}) {
    const std::string initial = choices.empty() ? std::string() : choices.front().key;
    const Value* own = node_.find(key);
    if (own != nullptr && own->isString() &&
        std::none_of(choices.begin(), choices.end(),
                     [&](const ParamChoice& c) { return c.key == own->asString(); })) {
      choices.push_back({own->asString(), own->asString()});
    }
    add(key, label, ParamType::Choice, Value(initial), QuantityKind::None, help).info.choices =
        std::move(choices);
    take(key);
  }

  /// The ids of a list, with or without the choice of none.
  void addReference(const std::string& key,
                    const QString& label,
                    const char* list,
                    bool optional,
                    const QString& help = {}) {
    std::vector<ParamChoice> choices;
    if (optional) {
      choices.push_back({kNoChoice, utf8(NodeText::tr("none"))});
    }
    if (const Value* nodes = document_.tree().find(list)) {
      for (const Value& node : nodes->asArray()) {
        choices.push_back({node.at("id").asString(), node.at("id").asString()});
      }
    }
    addChoice(key, label, std::move(choices), help);
  }

  void addField(const std::string& key,
                const QString& label,
                ParamType type,
                Value initial,
                QuantityKind quantity = QuantityKind::None,
                const QString& help = {}) {
    add(key, label, type, std::move(initial), quantity, help);
    take(key);
  }

  void addFile(const QString& label, const QString& help) {
    add("file", label, ParamType::File, Value(""), QuantityKind::None, help);
    if (const Value* file = node_.find("file")) {
      values_.set("file", file->at("path"));
    }
  }

  /// A list of ids or numbers as a text.
  void addList(const std::string& key, const QString& label, const QString& help) {
    add(key, label, ParamType::Text, Value(""), QuantityKind::None, help);
    if (const Value* list = node_.find(key); list != nullptr && list->isArray()) {
      std::vector<std::string> items;
      for (const Value& item : list->asArray()) {
        items.push_back(item.isString() ? item.asString() : std::to_string(item.asInteger()));
      }
      values_.set(key, Value(joinText(items, ", ")));
    }
  }

  void addPlacement(const Value* from, const std::string& prefix) {
    const Value zero(Value::Array{Value(0.0), Value(0.0), Value(0.0)});
    add(prefix + "position_mm", NodeText::tr("Position"), ParamType::Vector3, zero,
        QuantityKind::Length, NodeText::tr("x, y, z"));
    add(prefix + "rotation_deg", NodeText::tr("Rotation"), ParamType::Vector3, zero,
        QuantityKind::Angle, NodeText::tr("angles about the moving axes x, y, z, in this order"));
    for (const char* key : {"position_mm", "rotation_deg"}) {
      if (from != nullptr && from->find(key) != nullptr) {
        values_.set(prefix + key, from->at(key));
      }
    }
  }

  void take(const std::string& key) {
    if (const Value* value = node_.find(key)) {
      values_.set(key, *value);
    }
  }

  /// The same, chosen from the objects of a list of the project. The label tells more of an object
  /// than its id: the text of one of its keys.
  void addObjects(const std::string& key,
                  const QString& label,
                  const std::string& list,
                  const char* detail,
                  const QString& help) {
    addList(key, label, help);
    std::vector<ParamChoice>& choices = lists_[key];
    if (const Value* nodes = document_.tree().find(list); nodes != nullptr && nodes->isArray()) {
      for (const Value& node : nodes->asArray()) {
        const std::string id = node.at("id").asString();
        const Value* more = node.find(detail);
        more = more != nullptr && more->isObject() ? more->find("path") : more;
        const std::string text =
            more != nullptr && more->isString() ? more->asString() : std::string();
        choices.push_back({id, text.empty() ? id : id + " – " + text});
      }
    }
  }

  FormSection section(const QString& title) const {
    return {"node", title, ParamSchema(defs_), values_, document_.readOnly(), lists_, {}};
  }

private:
  const project::Document& document_;
  const Value& node_;
  std::vector<ParamDef> defs_;
  Value values_ = Value::object();
  std::map<std::string, std::vector<ParamChoice>> lists_;
};

QString sideName(const std::string& word) {
  return word == "whole"    ? NodeText::tr("The whole surface")
         : word == "outer"  ? NodeText::tr("Outer side")
         : word == "inner"  ? NodeText::tr("Inner side")
         : word == "middle" ? NodeText::tr("Middle")
                            : qt(word);
}

std::vector<ParamChoice> componentsOf(const plugin::PluginHost& plugins,
                                      plugin::ComponentKind kind) {
  std::vector<ParamChoice> choices;
  for (const plugin::ComponentEntry& entry : plugins.components()) {
    if (entry.kind == kind) {
      choices.push_back({entry.id, entry.name});
    }
  }
  return choices;
}

void addFields(Fields& fields,
               const NodeRef& node,
               const Value& value,
               const plugin::PluginHost& plugins) {
  const Value zero(Value::Array{Value(0.0), Value(0.0), Value(0.0)});
  if (node.list == "parts") {
    fields.addFile(NodeText::tr("File"), NodeText::tr("CAD or mesh file of the part"));
    fields.addPlacement(value.find("placement"), kPlacement);
    std::vector<ParamChoice> sides;
    for (const std::string& word : project::wallSideWords()) {
      sides.push_back({word, utf8(sideName(word))});
    }
    fields.addChoice("surface", NodeText::tr("Side of a wall"), std::move(sides),
                     NodeText::tr("working surface of a solid wall"));
    fields.addList(
        "faces", NodeText::tr("Faces"),
        NodeText::tr("numbers of the faces of the working surface; none: chosen automatically"));
  } else if (node.list == "substrates") {
    fields.addChoice(
        "type", NodeText::tr("Type"),
        {{"plate", utf8(NodeText::tr("Plate"))}, {"part", utf8(NodeText::tr("Imported part"))}});
    fields.addPlacement(&value, "");
    ParamDef& size =
        fields.add("size_mm", NodeText::tr("Size"), ParamType::Vector3,
                   Value(Value::Array{Value(300.0), Value(300.0), Value(10.0)}),
                   QuantityKind::Length, NodeText::tr("length, width and thickness of a plate"));
    size.info.enabledIf = "type=plate";
    fields.take("size_mm");
    fields.addReference("part", NodeText::tr("Part"), "parts", true,
                        NodeText::tr("part that is built on"));
  } else if (node.list == "guides") {
    fields.addChoice("type", NodeText::tr("Type"),
                     {{"edge", utf8(NodeText::tr("Edge of a part"))},
                      {"polyline", utf8(NodeText::tr("Polyline file"))},
                      {"formula", utf8(NodeText::tr("Formulas of t"))}});
    fields.addReference("part", NodeText::tr("Part"), "parts", true,
                        NodeText::tr("part whose edge is the guide"));
    fields.add("edge", NodeText::tr("Edge"), ParamType::Text, Value(""), QuantityKind::None,
               NodeText::tr("number or name of the edge"));
    if (const Value* edge = value.find("edge")) {
      // Numbers and names share the field.
      fields.take("edge");
      static_cast<void>(edge);
    }
    fields.addField("reversed", NodeText::tr("Reversed"), ParamType::Bool, Value(false));
    fields.addFile(NodeText::tr("File"), NodeText::tr("text file of points"));
    for (const char* axis : {"x", "y", "z"}) {
      fields.addField(axis, QString("%1(t)").arg(axis), ParamType::Text, Value(""));
    }
    fields.addField("begin", NodeText::tr("First t"), ParamType::Real, Value(0.0));
    fields.addField("end", NodeText::tr("Last t"), ParamType::Real, Value(1.0));
  } else if (node.list == "processes") {
    fields.addFile(NodeText::tr("File"),
                   NodeText::tr("process file; parameters below win over it"));
  } else if (node.list == "operations") {
    fields.addChoice("strategy", NodeText::tr("Strategy"),
                     componentsOf(plugins, plugin::ComponentKind::Slicing));
    fields.addField("enabled", NodeText::tr("Enabled"), ParamType::Bool, Value(true),
                    QuantityKind::None,
                    NodeText::tr("an operation that is not enabled is left out"));
    fields.addObjects("parts", NodeText::tr("Parts"), "parts", "file",
                      NodeText::tr("the parts to build"));
    fields.addReference("substrate", NodeText::tr("Substrate"), "substrates", false);
    fields.addReference("guide", NodeText::tr("Guide curve"), "guides", true);
    fields.addReference("process", NodeText::tr("Process"), "processes", false);
    fields.addFile(NodeText::tr("Path file"),
                   NodeText::tr("table of a path that was planned elsewhere"));
  } else if (node.list == "outputs") {
    fields.addChoice("post", NodeText::tr("Post-processor"),
                     componentsOf(plugins, plugin::ComponentKind::Post));
    fields.addObjects("operations", NodeText::tr("Operations"), "operations", "strategy",
                      NodeText::tr("the operations to write; none is checked: all"));
    fields.addField("folder", NodeText::tr("Folder"), ParamType::Text, Value(""),
                    QuantityKind::None, NodeText::tr("folder below the output folder"));
  }
  static_cast<void>(zero);
}

QString sectionTitle(const std::string& list, const std::string& section) {
  if (list == "operations") {
    return section == "params" ? NodeText::tr("Strategy")
           : section == "path" ? NodeText::tr("Path")
                               : NodeText::tr("Motion");
  }
  return list == "parts" ? NodeText::tr("Import") : NodeText::tr("Parameters");
}

std::vector<std::string> sectionsOf(const std::string& list) {
  if (list == "operations") {
    return {"params", "path", "motion"};
  }
  if (list == "parts") {
    return {"import"};
  }
  if (list == "processes" || list == "outputs") {
    return {"params"};
  }
  return {};
}

NodeForm cellForm(const project::Document& document) {
  const std::string path = document.project().cell.path;
  std::vector<ParamChoice> choices = {{kNoChoice, utf8(NodeText::tr("none"))}};
  for (const ShippedCell& cell : shippedCells()) {
    choices.push_back({cell.path, cell.name});
  }
  if (!path.empty() && std::none_of(choices.begin(), choices.end(),
                                    [&](const ParamChoice& c) { return c.key == path; })) {
    choices.push_back({path, path});
  }
  const Value value = path.empty() ? Value::object() : Value::object({{"file", path}});
  Fields fields(document, value);
  fields.addChoice(
      "file", NodeText::tr("Cell"), std::move(choices),
      NodeText::tr("robot, positioner and torch; Project > Choose cell takes another file"));
  return {NodeText::tr("Cell"), {fields.section(NodeText::tr("Cell"))}};
}

/// Text of a list field as a list of ids or numbers.
Value listOf(const std::string& text, bool numbers) {
  Value list = Value::array();
  const QStringList items = qt(text).split(QChar(','), Qt::SkipEmptyParts);
  for (const QString& item : items) {
    const QString trimmed = item.trimmed();
    bool isNumber = false;
    const int number = trimmed.toInt(&isNumber);
    list.push(numbers && isNumber ? Value(number) : Value(utf8(trimmed)));
  }
  return list;
}

const project::OperationEdit* editOf(const project::Document& document, const NodeRef& node) {
  const project::Operation* operation = document.project().operation(operationOf(node));
  if (operation == nullptr) {
    return nullptr;
  }
  const auto found = std::find_if(
      operation->edits.begin(), operation->edits.end(),
      [id = editIdOf(node)](const project::OperationEdit& edit) { return edit.id == id; });
  return found == operation->edits.end() ? nullptr : &*found;
}

NodeForm editForm(const project::Document& document, const NodeRef& node) {
  const project::OperationEdit* edit = editOf(document, node);
  if (edit == nullptr) {
    return {};
  }
  const toolpath::EditTypeInfo& info = toolpath::infoOf(edit->type);
  const Value value = edit->enabled ? Value::object() : Value::object({{"enabled", false}});
  Fields fields(document, value);
  fields.addField("enabled", NodeText::tr("Enabled"), ParamType::Bool, Value(true),
                  QuantityKind::None, NodeText::tr("an edit that is not enabled is left out"));
  // People count layers and beads from 1, as everywhere in the window.
  std::vector<ParamDef> defs = toolpath::editSchema(edit->type).params().defs();
  std::set<std::string> indices;
  for (ParamDef& def : defs) {
    if (toolpath::isEditIndex(def.info.key)) {
      indices.insert(def.info.key);
      def.info.help =
          utf8(def.info.key == "bead"
                   ? NodeText::tr("Counted from 1 in each layer; -1 is all beads.")
                   : NodeText::tr("Counted from 1, as in the view; -1 is the top layer, -2 the one "
                                  "below it. Belongs to the range."));
    }
  }
  return {qt(edit->id),
          {fields.section(NodeText::tr("Settings")),
           {"params",
            engineText(info.name),
            ParamSchema(std::move(defs)),
            edit->params,
            document.readOnly(),
            {},
            std::move(indices)}}};
}

project::Command editCommand(const NodeRef& node,
                             const std::string& section,
                             const std::string& key,
                             const Value& value) {
  Value args = Value::object({{"operation", operationOf(node)}, {"id", editIdOf(node)}});
  if (section == "node") {
    return {"edit.set", args.set(key, value)};
  }
  return {"edit.set_param", args.set("key", key).set("value", value)};
}

}  // namespace

std::string nounOf(const std::string& list) {
  return list == "processes" ? "process" : list.substr(0, list.size() - 1);
}

std::vector<ShippedCell> shippedCells() {
  std::vector<ShippedCell> cells;
  std::error_code ignored;
  for (const auto& entry :
       std::filesystem::directory_iterator(plugin::dataFolder() / "cells", ignored)) {
    if (entry.path().extension() != ".json") {
      continue;
    }
    ShippedCell cell;
    const std::string file = pathText(entry.path().filename());
    cell.path = std::string(project::kShippedPrefix) + "cells/" + file;
    cell.name = pathText(entry.path().stem());
    try {
      const Value tree = parseJson(readFile(entry.path()), file);
      const auto textOf = [&tree](const char* key, const std::string& otherwise) {
        const Value* value = tree.isObject() ? tree.find(key) : nullptr;
        return value != nullptr && value->isString() ? value->asString() : otherwise;
      };
      cell.name = textOf("name", cell.name);
      cell.description = textOf("description", {});
    } catch (const Error& error) {
      cell.description = error.what();
    }
    cells.push_back(std::move(cell));
  }
  std::sort(cells.begin(), cells.end(), [](const ShippedCell& a, const ShippedCell& b) {
    return std::tie(a.name, a.path) < std::tie(b.name, b.path);
  });
  return cells;
}

NodeForm formOf(const project::Document& document,
                const NodeRef& node,
                const plugin::PluginHost& plugins) {
  if (node.list == "cell") {
    return cellForm(document);
  }
  if (node.list == "edits") {
    return editForm(document, node);
  }
  const Value* value = nodeValue(document, node);
  if (value == nullptr) {
    return {};
  }
  NodeForm form;
  form.title = qt(node.id);
  Fields fields(document, *value);
  addFields(fields, node, *value, plugins);
  form.sections.push_back(fields.section(NodeText::tr("Settings")));
  for (const std::string& section : sectionsOf(node.list)) {
    std::string component;
    for (const char* key : {"strategy", "post"}) {
      if (const Value* id = value->find(key); id != nullptr && section == "params") {
        component = id->asString();
      }
    }
    const auto schema = schemaOf(plugins, {node.list, node.id, section, component});
    if (!schema) {
      continue;
    }
    const Value* values = value->find(section);
    form.sections.push_back({section, sectionTitle(node.list, section), *schema,
                             values != nullptr ? *values : Value::object(), document.readOnly()});
  }
  return form;
}

project::Command commandOf(const project::Document& document,
                           const NodeRef& node,
                           const std::string& section,
                           const std::string& key,
                           const Value& value) {
  const auto fileRef = [](const Value& path) {
    return Value::object({{"path", path}, {"sha256", ""}});
  };
  const bool isEmpty =
      value.isNull() ||
      (value.isString() && (value.asString().empty() || value.asString() == kNoChoice));
  if (node.list == "cell") {
    return isEmpty ? project::Command{"cell.remove", Value::object()}
                   : project::Command{"cell.set", Value::object({{"file", fileRef(value)}})};
  }
  if (node.list == "edits") {
    return editCommand(node, section, key, value);
  }
  const std::string noun = nounOf(node.list);
  if (section != "node") {
    return {noun + ".set_param",
            Value::object({{"id", node.id}, {"section", section}, {"key", key}, {"value", value}})};
  }
  Value set = Value::object({{"id", node.id}});
  if (key.rfind(kPlacement, 0) == 0) {
    const Value* own = nodeValue(document, node);
    const Value* before = own != nullptr ? own->find("placement") : nullptr;
    Value placement = before != nullptr ? *before : Value::object();
    const std::string inner = key.substr(std::char_traits<char>::length(kPlacement));
    if (value.isNull()) {
      placement.remove(inner);
    } else {
      placement.set(inner, value);
    }
    set.set("placement", placement);
  } else if (isEmpty) {
    set.set(key, Value());
  } else if (key == "file") {
    set.set(key, fileRef(value));
  } else if (key == "parts" || key == "operations" || key == "faces") {
    set.set(key, listOf(value.asString(), key == "faces"));
  } else if (key == "edge" && value.isString()) {
    bool isNumber = false;
    const int number = qt(value.asString()).toInt(&isNumber);
    set.set(key, isNumber ? Value(number) : value);
  } else {
    set.set(key, value);
  }
  return {noun + ".set", set};
}

}  // namespace wcam::gui
