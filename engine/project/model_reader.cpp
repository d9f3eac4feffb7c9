// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_reader.hpp"

#include "wcam/base/text.hpp"
#include "wcam/project/document.hpp"

#include "file_schema.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>

namespace wcam::project {

namespace {

std::string textOr(const Value& node, const char* key) {
  const Value* value = node.find(key);
  return value != nullptr ? value->asString() : std::string();
}

bool boolOr(const Value& node, const char* key, bool otherwise) {
  const Value* value = node.find(key);
  return value != nullptr ? value->asBool() : otherwise;
}

Value objectOr(const Value& node, const char* key) {
  const Value* value = node.find(key);
  return value != nullptr ? *value : Value::object();
}

std::array<double, 3> vectorOr(const Value& node, const char* key) {
  const Value* value = node.find(key);
  if (value == nullptr) {
    return {};
  }
  const auto& items = value->asArray();
  return {items[0].asReal(), items[1].asReal(), items[2].asReal()};
}

FileRef fileOr(const Value& node, const char* key) {
  const Value* value = node.find(key);
  return value != nullptr ? FileRef{value->at("path").asString(), textOr(*value, "sha256")}
                          : FileRef{};
}

std::vector<std::string> idsOr(const Value& node, const char* key) {
  std::vector<std::string> ids;
  if (const Value* value = node.find(key)) {
    for (const Value& item : value->asArray()) {
      ids.push_back(item.asString());
    }
  }
  return ids;
}

Placement placementOf(const Value& node) {
  return {vectorOr(node, "position_mm"), vectorOr(node, "rotation_deg")};
}

Part partOf(const Value& node) {
  Part part;
  part.id = node.at("id").asString();
  part.file = fileOr(node, "file");
  part.import = objectOr(node, "import");
  part.placement = placementOf(objectOr(node, "placement"));
  if (const Value* faces = node.find("faces")) {
    for (const Value& face : faces->asArray()) {
      part.faces.push_back(static_cast<int>(face.asInteger()));
    }
  }
  part.wallSide = wallSideOf(textOr(node, "surface"));
  return part;
}

Substrate substrateOf(const Value& node) {
  Substrate substrate;
  substrate.id = node.at("id").asString();
  substrate.type =
      node.at("type").asString() == "part" ? Substrate::Type::Part : Substrate::Type::Plate;
  substrate.placement = placementOf(node);
  substrate.sizeMm = vectorOr(node, "size_mm");
  substrate.part = textOr(node, "part");
  return substrate;
}

Guide guideOf(const Value& node) {
  Guide guide;
  guide.id = node.at("id").asString();
  const std::string& type = node.at("type").asString();
  guide.type = type == "edge"       ? Guide::Type::Edge
               : type == "polyline" ? Guide::Type::Polyline
                                    : Guide::Type::Formula;
  guide.part = textOr(node, "part");
  if (const Value* edge = node.find("edge")) {
    if (edge->isString()) {
      guide.edgeName = edge->asString();
    } else {
      guide.edge = static_cast<int>(edge->asInteger());
    }
  }
  guide.reversed = boolOr(node, "reversed", false);
  guide.file = fileOr(node, "file");
  guide.formulas = {textOr(node, "x"), textOr(node, "y"), textOr(node, "z")};
  if (const Value* begin = node.find("begin")) {
    guide.begin = begin->asReal();
  }
  if (const Value* end = node.find("end")) {
    guide.end = end->asReal();
  }
  return guide;
}

std::vector<OperationEdit> editsOf(const Value& node) {
  std::vector<OperationEdit> edits;
  if (const Value* list = node.find("edits")) {
    for (const Value& edit : list->asArray()) {
      // The structure has been checked, the type with it.
      edits.push_back({edit.at("id").asString(),
                       toolpath::editTypeOf(edit.at("type").asString()).value(),
                       boolOr(edit, "enabled", true), objectOr(edit, "params")});
    }
  }
  return edits;
}

Operation operationOf(const Value& node) {
  Operation operation;
  operation.id = node.at("id").asString();
  operation.strategy = node.at("strategy").asString();
  operation.parts = idsOr(node, "parts");
  operation.substrate = node.at("substrate").asString();
  operation.guide = textOr(node, "guide");
  operation.file = fileOr(node, "file");
  operation.process = node.at("process").asString();
  operation.params = objectOr(node, "params");
  operation.path = objectOr(node, "path");
  operation.motion = objectOr(node, "motion");
  operation.edits = editsOf(node);
  operation.enabled = boolOr(node, "enabled", true);
  return operation;
}

Output outputOf(const Value& node) {
  return {node.at("id").asString(), node.at("post").asString(), idsOr(node, "operations"),
          objectOr(node, "params"), textOr(node, "folder")};
}

/// Puts a checked node into its list of the model.
void store(Project& project, const NodeType& type, const Value& node) {
  const std::string_view list = type.list;
  if (list == "parts") {
    project.parts.push_back(partOf(node));
  } else if (list == "substrates") {
    project.substrates.push_back(substrateOf(node));
  } else if (list == "guides") {
    project.guides.push_back(guideOf(node));
  } else if (list == "processes") {
    project.processes.push_back(
        {node.at("id").asString(), fileOr(node, "file"), objectOr(node, "params")});
  } else if (list == "operations") {
    project.operations.push_back(operationOf(node));
  } else if (list == "outputs") {
    project.outputs.push_back(outputOf(node));
  } else {
    project.plugins.push_back({node.at("id").asString(), textOr(node, "version")});
  }
}

/// One pass over the file: structure first, then references, then the model.
class Reader {
public:
  explicit Reader(const Value& tree) : tree_(tree) {}

  ReadModel read() {
    readTopLevel();
    for (const NodeType& type : nodeTypes()) {
      readIds(type);
    }
    for (const NodeType& type : nodeTypes()) {
      readList(type);
    }
    return std::move(result_);
  }

private:
  void problem(const std::string& path, Text message) {
    result_.problems.push_back({path, std::move(message), false});
  }

  void finding(const char* code, Text message, Text remedy) {
    result_.findings.push_back(
        {Severity::Warning, code, std::move(message), std::move(remedy), {}, {}});
  }

  /// Keys that mean nothing here, such as a placement where a position is wanted. Those of other
  /// programs begin with "x-" or "x_".
  void tellUnknown(const Value& object,
                   const std::vector<std::string>& known,
                   const std::string& path) {
    for (const auto& [key, value] : object.asObject()) {
      if (key.starts_with("x-") || key.starts_with("x_") ||
          std::find(known.begin(), known.end(), key) != known.end()) {
        continue;
      }
      const auto near = nearestName(key, known);
      finding(
          "project.unknown_key",
          text("%1: is no key here; it is kept in the file and has no effect",
               {path.empty() ? key : path + "." + key}),
          near ? text("did you mean '%1'?", {*near}) : text("keys: %1", {joinText(known, ", ")}));
    }
  }

  void readTopLevel() {
    tellUnknown(tree_, topLevelKeys(), {});
    if (const Value* version = tree_.find("format_version")) {
      result_.project.formatVersion = static_cast<int>(version->asInteger());
    }
    if (const Value* name = tree_.find("name")) {
      checkField(*name, FieldType::Text, "name", result_.problems);
      result_.project.name = name->isString() ? name->asString() : std::string();
    }
    if (const Value* cell = tree_.find("cell")) {
      const std::size_t before = result_.problems.size();
      checkField(*cell, FieldType::File, "cell", result_.problems);
      if (result_.problems.size() == before) {
        result_.project.cell = fileOr(tree_, "cell");
        checkPath(result_.project.cell.path, "cell");
      }
    }
  }

  /// Collects the ids of a list, so that references in any direction can be checked.
  void readIds(const NodeType& type) {
    const Value* list = tree_.find(type.list);
    if (list == nullptr || !list->isArray()) {
      return;
    }
    for (const Value& node : list->asArray()) {
      const Value* id = node.find("id");
      if (id != nullptr && id->isString()) {
        ids_[type.list].push_back(id->asString());
      }
    }
  }

  void readList(const NodeType& type) {
    const Value* list = tree_.find(type.list);
    if (list == nullptr) {
      return;
    }
    if (!list->isArray()) {
      problem(type.list, text("expected a list, got %1", {toString(list->type())}));
      return;
    }
    std::vector<std::string> seen;
    for (std::size_t i = 0; i < list->size(); ++i) {
      const Value& node = list->asArray()[i];
      const std::string path = std::string(type.list) + "[" + std::to_string(i) + "]";
      const std::size_t before = result_.problems.size();
      checkNode(type, node, path, seen);
      if (result_.problems.size() == before) {
        checkPaths(type, node);
        store(result_.project, type, node);
      }
    }
  }

  void checkNode(const NodeType& type,
                 const Value& node,
                 const std::string& path,
                 std::vector<std::string>& seen) {
    if (!node.isObject()) {
      problem(path, text("expected an object, got %1", {toString(node.type())}));
      return;
    }
    const std::size_t before = result_.problems.size();
    checkOwnId(type, node, path, seen);
    for (const Field& field : type.fields) {
      if (const Value* value = node.find(field.key)) {
        checkField(*value, field.type, path + "." + field.key, result_.problems);
      } else if (field.required) {
        problem(path, text("the key '%1' is missing", {field.key}));
      }
    }
    std::vector<std::string> known = {"id"};
    for (const Field& field : type.fields) {
      known.emplace_back(field.key);
    }
    tellUnknown(node, known, path);
    if (result_.problems.size() == before) {
      checkVariant(type, node, path);
      checkSurface(type, node, path);
      checkReferences(type, node, path);
    }
  }

  void checkOwnId(const NodeType& type,
                  const Value& node,
                  const std::string& path,
                  std::vector<std::string>& seen) {
    const Value* id = node.find("id");
    if (id == nullptr) {
      problem(path, "the key 'id' is missing");
      return;
    }
    checkField(*id, FieldType::Id, path + ".id", result_.problems);
    if (!id->isString()) {
      return;
    }
    if (std::find(seen.begin(), seen.end(), id->asString()) != seen.end()) {
      problem(path + ".id",
              text("another %1 has the id '%2' already", {type.noun, id->asString()}));
    }
    seen.push_back(id->asString());
  }

  void checkSurface(const NodeType& type, const Value& node, const std::string& path) {
    const Value* surface = node.find("surface");
    if (type.field("surface") == nullptr || surface == nullptr) {
      return;
    }
    const std::vector<std::string>& words = wallSideWords();
    if (std::find(words.begin(), words.end(), surface->asString()) == words.end()) {
      problem(path + ".surface",
              text("'%1' is not one of: %2", {surface->asString(), joinText(words, ", ")}));
    } else if (wallSideOf(surface->asString()) && node.contains("faces")) {
      problem(path + ".surface", "stands beside 'faces': name the faces or the side of the wall");
    }
  }

  /// Keys that one type of substrate or guide needs.
  void checkVariant(const NodeType& type, const Value& node, const std::string& path) {
    static const std::map<std::string, std::map<std::string, std::vector<std::string>>> kNeeds = {
        {"substrates", {{"plate", {"size_mm"}}, {"part", {"part"}}}},
        {"guides",
         {{"edge", {"part", "edge"}},
          {"polyline", {"file"}},
          {"formula", {"x", "y", "z", "begin", "end"}}}}};
    const auto variants = kNeeds.find(type.list);
    if (variants == kNeeds.end()) {
      return;
    }
    const std::string& name = node.at("type").asString();
    const auto variant = variants->second.find(name);
    if (variant == variants->second.end()) {
      std::vector<std::string> known;
      for (const auto& entry : variants->second) {
        known.push_back(entry.first);
      }
      problem(path + ".type", text("'%1' is not one of: %2", {name, joinText(known, ", ")}));
      return;
    }
    for (const std::string& key : variant->second) {
      if (!node.contains(key)) {
        problem(path, text("the key '%1' is missing; the type %2 needs it", {key, name}));
      }
    }
    if (name == "formula" && node.contains("begin") && node.contains("end") &&
        !(node.at("begin").asReal() < node.at("end").asReal())) {
      problem(path + ".end", "must be greater than begin");
    }
  }

  void checkReferences(const NodeType& type, const Value& node, const std::string& path) {
    for (const Field& field : type.fields) {
      const Value* value = node.find(field.key);
      if (field.references == nullptr || value == nullptr) {
        continue;
      }
      const std::string place = path + "." + field.key;
      if (value->isString()) {
        checkReference(type, node, field, value->asString(), place);
        continue;
      }
      for (std::size_t i = 0; i < value->size(); ++i) {
        checkReference(type, node, field, value->asArray()[i].asString(),
                       place + "[" + std::to_string(i) + "]");
      }
    }
    const Value* parts = node.find("parts");
    if (std::string_view(type.list) == "operations" && parts != nullptr && parts->size() == 0 &&
        !node.contains("file")) {
      problem(path + ".parts", "an operation needs at least one part, or a file with a path");
    }
  }

  void checkReference(const NodeType& type,
                      const Value& node,
                      const Field& field,
                      const std::string& id,
                      const std::string& place) {
    const std::vector<std::string>& known = ids_[field.references];
    if (std::find(known.begin(), known.end(), id) == known.end()) {
      problem(place, didYouMean(text("%1 '%2' names an unknown %3 '%4'",
                                     {type.noun, node.at("id").asString(),
                                      nodeTypeOfList(field.references)->noun, id}),
                                id, known));
    }
  }

  void checkPaths(const NodeType& type, const Value& node) {
    const Text owner = text("%1 '%2'", {type.noun, node.at("id").asString()});
    if (const Value* file = node.find("file")) {
      checkPath(file->at("path").asString(), owner);
    }
    if (const Value* folder = node.find("folder")) {
      checkPath(folder->asString(), owner);
    }
  }

  void checkPath(const std::string& given, const Text& owner) {
    if (given.find('\\') != std::string::npos) {
      finding("project.path_separator", text("%1: the path '%2' holds a backslash", {owner, given}),
              "write '/' between folders");
    }
    const std::filesystem::path path(given);
    if (path.is_absolute()) {
      finding("project.path_absolute",
              text("%1: the path '%2' is absolute and holds on this machine only", {owner, given}),
              "put the file below the project and write the path from there");
      return;
    }
    const std::filesystem::path plain = path.lexically_normal();
    if (!plain.empty() && *plain.begin() == "..") {
      finding("project.path_outside",
              text("%1: the path '%2' leaves the folder of the project", {owner, given}),
              "put the file below the project, so that the folder can be moved as a whole");
    }
  }

  const Value& tree_;
  ReadModel result_;
  std::map<std::string, std::vector<std::string>, std::less<>> ids_;
};

}  // namespace

ReadModel readModel(const Value& tree) {
  return Reader(tree).read();
}

}  // namespace wcam::project
