// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/param.hpp"
#include "wcam/base/value.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace wcam::project {

/// What the value of a key looks like.
enum class FieldType {
  Id,         ///< id of a node, a component or a plugin
  Text,       ///< any text
  Bool,       ///< true, false
  Real,       ///< finite number
  Vector3,    ///< 3 lengths
  Angles3,    ///< 3 angles
  Size3,      ///< 3 positive numbers
  File,       ///< {"path", "sha256"}
  Placement,  ///< {"position_mm", "rotation_deg"}
  Object,     ///< parameters, checked by the schema of a component
  IdList,     ///< list of ids, each once
  IndexList,  ///< list of integers from 0, each once
  Edge,       ///< index from 0, or a name
  Index,      ///< integer from 0
  Any,        ///< any value
  Edits,      ///< list of {"id", "type", "enabled", "params"}
  Hashes      ///< {path: sha256, ...}
};
const char* toString(FieldType type) noexcept;

struct Field {
  const char* key;
  FieldType type;
  bool required;
  const char* help;
  const char* references = nullptr;  ///< list in which the id (or every id of the list) must stand
};

/// One kind of node: a list of the project file and the keys of its items, in canonical order.
/// "id" comes first and is not listed.
struct NodeType {
  const char* list;
  const char* noun;
  const char* plural;
  std::vector<Field> fields;

  [[nodiscard]] const Field* field(std::string_view key) const noexcept;
};

/// In the order of the file. From this one table come the checks, the canonical key order and the
/// arguments of the commands.
const std::vector<NodeType>& nodeTypes();
const NodeType* nodeTypeOfList(std::string_view list) noexcept;
/// Top-level keys in canonical order.
const std::vector<std::string>& topLevelKeys();

/// Keys of an edit of an operation, in canonical order; "id" comes first and is not listed.
const NodeType& editNode();

/// Adds what is wrong with one value of a known type.
void checkField(const Value& value,
                FieldType type,
                const std::string& path,
                std::vector<ParamProblem>& problems);
/// Adds what no file may hold: numbers that are not finite, text that is not UTF-8, a key twice,
/// too deep nesting. A tree with such problems cannot be written.
void checkWritable(const Value& value,
                   const std::string& path,
                   std::vector<ParamProblem>& problems);

/// Sets a member at its place in the canonical order of keys; unknown keys stay where they are.
void setOrdered(Value& object,
                const std::string& key,
                Value value,
                const std::vector<std::string>& order);
/// "id" and the keys of the type.
std::vector<std::string> keyOrder(const NodeType& type);

/// "; did you mean 'x'?" or nothing.
Text didYouMean(const Text& message,
                std::string_view name,
                const std::vector<std::string>& candidates);

}  // namespace wcam::project
