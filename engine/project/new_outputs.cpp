// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/new_outputs.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/cell/controller.hpp"

#include <algorithm>

namespace wcam::project {

namespace {

/// Make of the controller that a cell file names; empty for a file that cannot be read, which the
/// first run tells.
std::string controllerOf(const std::filesystem::path& cell) {
  if (cell.empty()) {
    return {};
  }
  try {
    return cell::controllerOf(parseJson(readFile(cell), pathText(cell)));
  } catch (const Error&) {
    return {};
  }
}

/// How far the part frame of a cell whose robot carries the part lies above the flange, mm; 0 where
/// that is not so, or not known.
double aboveFlange(const std::filesystem::path& cell) {
  if (cell.empty()) {
    return 0.0;
  }
  try {
    const Value file = parseJson(readFile(cell), pathText(cell));
    const Value* holder = file.find("part_holder");
    double height = 0.0;
    for (const char* key : {"T_flange_table", "T_table_part"}) {
      const Value* pose = holder != nullptr ? holder->find(key) : nullptr;
      const Value* xyz = pose != nullptr ? pose->find("xyz") : nullptr;
      height += xyz != nullptr && xyz->size() == 3 ? xyz->asArray()[2].asReal() : 0.0;
    }
    return height;
  } catch (const Error&) {
    return 0.0;
  }
}

Value outputOf(const std::string& post) {
  const std::string id = post.substr(post.rfind('.') + 1);
  return Value::object({{"id", id}, {"post", post}});
}

}  // namespace

Value newOutputs(const plugin::PluginHost& plugins, const std::filesystem::path& cell) {
  const std::string controller = controllerOf(cell);
  if (controller.empty()) {
    return Value(Value::Array{outputOf("wcam.post.fanuc")});
  }
  for (const plugin::ComponentEntry& entry : plugins.components()) {
    if (entry.kind != plugin::ComponentKind::Post) {
      continue;
    }
    try {
      const std::vector<std::string> makes = plugins.info(entry.id).controllers;
      if (std::find(makes.begin(), makes.end(), controller) != makes.end()) {
        return Value(Value::Array{outputOf(entry.id)});
      }
    } catch (const Error&) {
      continue;  // a refused plugin writes nothing
    }
  }
  return Value::array();
}

Value newPlate(const std::filesystem::path& cell) {
  constexpr double kSide = 300.0;
  constexpr double kThickness = 10.0;
  const double above = aboveFlange(cell);
  return Value::object(
      {{"id", "plate"},
       {"type", "plate"},
       {"size_mm", Value(Value::Array{kSide, kSide, above > 0.0 ? above : kThickness})}});
}

}  // namespace wcam::project
