// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "file_schema.hpp"

#include "wcam/base/json.hpp"
#include "wcam/base/plausible.hpp"
#include "wcam/base/text.hpp"
#include "wcam/toolpath/edits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace wcam::project {

namespace {

/// As many levels as the reader of JSON accepts.
constexpr int kMaxDepth = 200;

void add(std::vector<ParamProblem>& problems, const std::string& path, Text message) {
  problems.push_back({path, std::move(message), false});
}

bool expectType(const Value& value,
                bool matches,
                const Text& wanted,
                const std::string& path,
                std::vector<ParamProblem>& problems) {
  if (!matches) {
    add(problems, path, text("expected %1, got %2", {wanted, toString(value.type())}));
  }
  return matches;
}

void checkId(const Value& value, const std::string& path, std::vector<ParamProblem>& problems) {
  if (expectType(value, value.isString(), "a text", path, problems) &&
      !isValidId(value.asString())) {
    add(problems, path,
        text("'%1' is no id: write 1 to 64 of a-z 0-9 _ - . and begin with a letter or digit",
             {value.asString()}));
  }
}

bool isIndex(const Value& value) {
  return value.isInteger() && value.asInteger() >= 0 &&
         value.asInteger() <= std::numeric_limits<int>::max();
}

void checkIndex(const Value& value, const std::string& path, std::vector<ParamProblem>& problems) {
  if (!isIndex(value)) {
    add(problems, path, "expected an integer from 0");
  }
}

void checkNumber(const Value& value,
                 QuantityKind kind,
                 const std::string& path,
                 std::vector<ParamProblem>& problems) {
  if (expectType(value, value.isNumber(), "a number", path, problems)) {
    if (Text wrong = implausible(value.asReal(), kind); !wrong.empty()) {
      add(problems, path, std::move(wrong));
    }
  }
}

void checkVector(const Value& value,
                 QuantityKind kind,
                 bool positive,
                 const std::string& path,
                 std::vector<ParamProblem>& problems) {
  const bool isVector = value.isArray() && value.size() == 3 &&
                        std::all_of(value.asArray().begin(), value.asArray().end(),
                                    [](const Value& v) { return v.isNumber(); });
  if (!isVector) {
    add(problems, path, "expected a list of 3 numbers");
    return;
  }
  for (const Value& item : value.asArray()) {
    if (positive && !(item.asReal() > 0.0)) {
      add(problems, path, "every size must be greater than 0");
      return;
    }
  }
  for (std::size_t i = 0; i < value.size(); ++i) {
    checkNumber(value.asArray()[i], kind, path + "[" + std::to_string(i) + "]", problems);
  }
}

/// An object whose known members are checked; other members are kept as they are.
void checkMembers(const Value& value,
                  const std::vector<Field>& fields,
                  const std::string& path,
                  std::vector<ParamProblem>& problems) {
  if (!expectType(value, value.isObject(), "an object", path, problems)) {
    return;
  }
  for (const Field& field : fields) {
    if (const Value* member = value.find(field.key)) {
      checkField(*member, field.type, path + "." + field.key, problems);
    } else if (field.required) {
      add(problems, path, text("the key '%1' is missing", {std::string(field.key)}));
    }
  }
}

void checkHash(const Value& value, const std::string& path, std::vector<ParamProblem>& problems) {
  const bool valid =
      value.isString() && (value.asString().empty() || value.asString().size() == 64) &&
      std::all_of(value.asString().begin(), value.asString().end(),
                  [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
  if (!valid) {
    add(problems, path, "must be empty or 64 lower-case hexadecimal digits");
  }
}

void checkFile(const Value& value, const std::string& path, std::vector<ParamProblem>& problems) {
  static const std::vector<Field> kFields = {{"path", FieldType::Text, true, ""},
                                             {"sha256", FieldType::Text, false, ""}};
  const std::size_t before = problems.size();
  checkMembers(value, kFields, path, problems);
  if (problems.size() > before) {
    return;
  }
  const std::string& name = value.at("path").asString();
  if (name.empty() || name.find('\0') != std::string::npos) {
    add(problems, path + ".path", "the path of a file must not be empty");
  }
  if (const Value* hash = value.find("sha256")) {
    checkHash(*hash, path + ".sha256", problems);
  }
}

void checkList(const Value& value,
               FieldType type,
               const std::string& path,
               std::vector<ParamProblem>& problems) {
  if (!expectType(value, value.isArray(), "a list", path, problems)) {
    return;
  }
  std::set<std::string> seen;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const Value& item = value.asArray()[i];
    const std::string place = path + "[" + std::to_string(i) + "]";
    if (type == FieldType::IdList) {
      checkId(item, place, problems);
    } else {
      checkIndex(item, place, problems);
    }
    if (!seen.insert(toCompactJson(item)).second) {
      add(problems, place, "stands twice in the list");
    }
  }
}

std::vector<std::string> editKeys() {
  std::vector<std::string> keys;
  for (const toolpath::EditTypeInfo& info : toolpath::editTypes()) {
    keys.emplace_back(info.key);
  }
  return keys;
}

void checkEdits(const Value& value, const std::string& path, std::vector<ParamProblem>& problems) {
  if (!expectType(value, value.isArray(), "a list", path, problems)) {
    return;
  }
  std::vector<std::string> seen;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const Value& edit = value.asArray()[i];
    const std::string place = path + "[" + std::to_string(i) + "]";
    const std::size_t before = problems.size();
    checkMembers(edit, editNode().fields, place, problems);
    const Value* id = edit.isObject() ? edit.find("id") : nullptr;
    if (edit.isObject() && id == nullptr) {
      add(problems, place, "the key 'id' is missing");
    } else if (id != nullptr) {
      checkId(*id, place + ".id", problems);
    }
    if (problems.size() > before) {
      continue;
    }
    if (std::find(seen.begin(), seen.end(), id->asString()) != seen.end()) {
      add(problems, place + ".id",
          text("another edit of the operation has the id '%1' already", {id->asString()}));
    }
    seen.push_back(id->asString());
    const std::string& type = edit.at("type").asString();
    if (!toolpath::editTypeOf(type)) {
      add(problems, place + ".type",
          didYouMean(text("'%1' is no type of edit", {type}), type, editKeys()));
    }
  }
}

bool isUtf8(std::string_view text) noexcept {
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80                    ? 1
                               : lead >= 0xC2 && lead <= 0xDF ? 2
                               : (lead >> 4) == 0xE           ? 3
                               : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                              : 0;
    if (length == 0 || i + length > text.size()) {
      return false;
    }
    char32_t code = length == 1 ? lead : lead & (0x7FU >> length);
    for (std::size_t k = 1; k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[i + k]);
      if ((next & 0xC0U) != 0x80U) {
        return false;
      }
      code = (code << 6U) | (next & 0x3FU);
    }
    const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    if (overlong || (code >= 0xD800 && code <= 0xDFFF) || code > 0x10FFFF) {
      return false;
    }
    i += length;
  }
  return true;
}

void checkWritableAt(const Value& value,
                     const std::string& path,
                     int depth,
                     std::vector<ParamProblem>& problems) {
  if (depth > kMaxDepth && (value.isArray() || value.isObject())) {
    add(problems, path, "nested deeper than 200 levels");
    return;
  }
  if (value.type() == Value::Type::Real && !std::isfinite(value.asReal())) {
    add(problems, path, "is not a finite number");
  } else if (value.isString() && !isUtf8(value.asString())) {
    add(problems, path, "is not UTF-8 text");
  } else if (value.isArray()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      const Value& item = value.asArray()[i];
      checkWritableAt(item, path + "[" + std::to_string(i) + "]", depth + 1, problems);
    }
  } else if (value.isObject()) {
    std::set<std::string_view> seen;
    for (const auto& [key, member] : value.asObject()) {
      const std::string place = path.empty() ? key : path + "." + key;
      if (!isUtf8(key)) {
        add(problems, path, "a key is not UTF-8 text");
      } else if (!seen.insert(key).second) {
        add(problems, place, "stands twice in one object");
      }
      checkWritableAt(member, place, depth + 1, problems);
    }
  }
}

}  // namespace

const char* toString(FieldType type) noexcept {
  switch (type) {
    case FieldType::Id:
      return "id";
    case FieldType::Text:
      return "text";
    case FieldType::Bool:
      return "bool";
    case FieldType::Real:
      return "real";
    case FieldType::Vector3:
      return "vector3";
    case FieldType::Angles3:
      return "vector3";
    case FieldType::Size3:
      return "size3";
    case FieldType::File:
      return "file";
    case FieldType::Placement:
      return "placement";
    case FieldType::Object:
      return "object";
    case FieldType::IdList:
      return "id_list";
    case FieldType::IndexList:
      return "index_list";
    case FieldType::Edge:
      return "edge";
    case FieldType::Index:
      return "index";
    case FieldType::Any:
      return "any";
    case FieldType::Edits:
      return "edits";
    case FieldType::Hashes:
      return "hashes";
  }
  return "text";
}

const Field* NodeType::field(std::string_view key) const noexcept {
  for (const Field& field : fields) {
    if (field.key == key) {
      return &field;
    }
  }
  return nullptr;
}

const std::vector<NodeType>& nodeTypes() {
  using enum FieldType;
  static const std::vector<NodeType> kTypes = {
      {"parts",
       "part",
       "parts",
       {{"file", File, true, "CAD or mesh file"},
        {"import", Object, false, "how the file is read, see the schema of the import"},
        {"placement", Placement, false, "where the part stands"},
        {"faces", IndexList, false, "faces of the working surface; none: all"},
        {"surface", Text, false,
         "working surface of a solid wall: whole, outer, inner or middle"}}},
      {"substrates",
       "substrate",
       "substrates",
       {{"type", Text, true, "plate or part"},
        {"position_mm", Vector3, false, "origin of the substrate's frame"},
        {"rotation_deg", Angles3, false, "Bryant angles of the substrate's frame"},
        {"size_mm", Size3, false, "length, width and thickness of a plate"},
        {"part", Id, false, "part that is built on", "parts"}}},
      {"guides",
       "guide",
       "guides",
       {{"type", Text, true, "edge, polyline or formula"},
        {"part", Id, false, "part whose edge is the guide", "parts"},
        {"edge", Edge, false, "index or name of the edge"},
        {"reversed", Bool, false, "run the edge backwards"},
        {"file", File, false, "text file of points"},
        {"x", Text, false, "x(t) in mm"},
        {"y", Text, false, "y(t) in mm"},
        {"z", Text, false, "z(t) in mm"},
        {"begin", Real, false, "first t"},
        {"end", Real, false, "last t"}}},
      {"processes",
       "process",
       "processes",
       {{"file", File, false, "process file"},
        {"params", Object, false, "parameters; they win over those of the file"}}},
      {"operations",
       "operation",
       "operations",
       {{"strategy", Id, true, "component id of the slicing strategy"},
        {"parts", IdList, true, "parts to build", "parts"},
        {"substrate", Id, true, "substrate to build on", "substrates"},
        {"guide", Id, false, "guide curve", "guides"},
        {"file", File, false, "table of a path that was planned elsewhere"},
        {"process", Id, true, "process to build with", "processes"},
        {"params", Object, false, "parameters of the strategy"},
        {"path", Object, false, "parameters of the path: sampling, seam, tool axis"},
        {"motion", Object, false, "parameters of the motion"},
        {"edits", Edits, false, "changes of the generated toolpath, applied in this order"},
        {"enabled", Bool, false, "false leaves the operation out"}}},
      {"outputs",
       "output",
       "outputs",
       {{"post", Id, true, "component id of the post-processor"},
        {"operations", IdList, false, "operations to write; none: all", "operations"},
        {"params", Object, false, "parameters of the post-processor"},
        {"folder", Text, false, "folder below the output folder"}}},
      {"plugins", "plugin", "plugins", {{"version", Text, false, "version of the plugin"}}},
  };
  return kTypes;
}

const NodeType& editNode() {
  using enum FieldType;
  static const NodeType kEdit = {"edits",
                                 "edit",
                                 "edits",
                                 {{"type", Text, true, "what it does, see the list of types"},
                                  {"enabled", Bool, false, "false leaves the edit out"},
                                  {"params", Object, false, "parameters of the type"}}};
  return kEdit;
}

const NodeType* nodeTypeOfList(std::string_view list) noexcept {
  for (const NodeType& type : nodeTypes()) {
    if (type.list == list) {
      return &type;
    }
  }
  return nullptr;
}

const std::vector<std::string>& topLevelKeys() {
  static const std::vector<std::string> kKeys = [] {
    std::vector<std::string> keys = {"format", "format_version", "name", "cell"};
    for (const NodeType& type : nodeTypes()) {
      keys.emplace_back(type.list);
    }
    return keys;
  }();
  return kKeys;
}

void checkField(const Value& value,
                FieldType type,
                const std::string& path,
                std::vector<ParamProblem>& problems) {
  static const std::vector<Field> kPlacement = {{"position_mm", FieldType::Vector3, false, ""},
                                                {"rotation_deg", FieldType::Angles3, false, ""}};
  switch (type) {
    case FieldType::Id:
      return checkId(value, path, problems);
    case FieldType::Text:
      expectType(value, value.isString(), "a text", path, problems);
      return;
    case FieldType::Bool:
      expectType(value, value.isBool(), "true or false", path, problems);
      return;
    case FieldType::Real:
      return checkNumber(value, QuantityKind::None, path, problems);
    case FieldType::Vector3:
      return checkVector(value, QuantityKind::Length, false, path, problems);
    case FieldType::Angles3:
      return checkVector(value, QuantityKind::Angle, false, path, problems);
    case FieldType::Size3:
      return checkVector(value, QuantityKind::Length, true, path, problems);
    case FieldType::File:
      return checkFile(value, path, problems);
    case FieldType::Placement:
      return checkMembers(value, kPlacement, path, problems);
    case FieldType::Object:
      expectType(value, value.isObject(), "an object", path, problems);
      return;
    case FieldType::IdList:
    case FieldType::IndexList:
      return checkList(value, type, path, problems);
    case FieldType::Edge:
      if (!(value.isString() && !value.asString().empty()) && !isIndex(value)) {
        add(problems, path, "expected the index of an edge from 0, or its name");
      }
      return;
    case FieldType::Index:
      return checkIndex(value, path, problems);
    case FieldType::Any:
      return;
    case FieldType::Edits:
      return checkEdits(value, path, problems);
    case FieldType::Hashes:
      if (expectType(value, value.isObject(), "an object", path, problems)) {
        for (const auto& [name, hash] : value.asObject()) {
          checkHash(hash, path + "." + name, problems);
        }
      }
      return;
  }
}

void checkWritable(const Value& value,
                   const std::string& path,
                   std::vector<ParamProblem>& problems) {
  checkWritableAt(value, path, 1, problems);
}

std::vector<std::string> keyOrder(const NodeType& type) {
  std::vector<std::string> keys = {"id"};
  for (const Field& field : type.fields) {
    keys.emplace_back(field.key);
  }
  return keys;
}

void setOrdered(Value& object,
                const std::string& key,
                Value value,
                const std::vector<std::string>& order) {
  if (object.contains(key) || object.isNull()) {
    object.set(key, std::move(value));
    return;
  }
  const auto rank = [&order](const std::string& name) {
    return std::find(order.begin(), order.end(), name) - order.begin();
  };
  const auto own = rank(key);
  auto& members = object.mutableObject();
  // Before the first known key that comes later; an unknown key goes to the end.
  const auto place = std::find_if(members.begin(), members.end(), [&](const Value::Member& m) {
    const auto other = rank(m.first);
    return other > own && other < static_cast<std::ptrdiff_t>(order.size());
  });
  members.emplace(place, key, std::move(value));
}

Text didYouMean(const Text& message,
                std::string_view name,
                const std::vector<std::string>& candidates) {
  if (const auto near = nearestName(name, candidates)) {
    return text("%1; did you mean '%2'?", {message, *near});
  }
  if (candidates.empty()) {
    return text("%1; there is none yet", {message});
  }
  return text("%1; there are: %2", {message, joinText(candidates, ", ")});
}

}  // namespace wcam::project
