// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/value.hpp"
#include "wcam/project/document.hpp"

#include "file_schema.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace wcam::project::detail {

struct Arg {
  std::string key;
  FieldType type;
  bool required;
  std::string help;
  bool nullable = false;
};

/// What one command is. The catalogue, the checks of arguments and the schemas follow from it.
struct Definition {
  std::string id;
  std::string summary;
  std::vector<Arg> args;
  /// The new tree. Arguments have their types; what the tree must keep is checked afterwards.
  std::function<Value(const Document&, const Value& args)> apply;
  std::function<Text(const Value& args)> label;
};

[[noreturn]] void refuse(const Text& message, const Text& hint = {});

std::string textArg(const Value& args, const char* key);
std::vector<std::string> idsOf(const Value& tree, const char* list);
/// Position of a node in its list. @throws Error(InvalidArgument) with the nearest id
std::size_t indexOf(const Value& tree, const NodeType& type, const std::string& id);
/// The list of a type for writing; made when the file has none.
Value& mutableList(Value& tree, const NodeType& type);

/// The commands of the edits of operations.
void defineEditCommands(std::vector<Definition>& all);

}  // namespace wcam::project::detail
