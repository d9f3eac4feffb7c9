// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/controller.hpp"

namespace wcam::cell {

std::string controllerOf(const Value& file) {
  const Value* robot = file.isObject() ? file.find("robot") : nullptr;
  const Value* name = robot != nullptr && robot->isObject() ? robot->find("controller") : nullptr;
  return name != nullptr && name->isString() ? name->asString() : std::string();
}

}  // namespace wcam::cell
