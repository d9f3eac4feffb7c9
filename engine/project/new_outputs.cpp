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

}  // namespace wcam::project
