// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/json.hpp"
#include "wcam/base/param_condition.hpp"
#include "wcam/base/text.hpp"
#include "wcam/plugin/host.hpp"

#include <set>

namespace wcam::plugin {

namespace {

bool isSnakeCase(std::string_view key) {
  return isValidId(key) && key.find_first_of(".-") == std::string_view::npos;
}

void checkChoices(const ParamDef& def, std::vector<std::string>& problems) {
  if (def.type != ParamType::Choice) {
    return;
  }
  std::set<std::string> keys;
  for (const ParamChoice& choice : def.info.choices) {
    if (choice.key.empty() || !keys.insert(choice.key).second) {
      problems.push_back(def.info.key + ": choice '" + choice.key + "' is empty or repeated");
    }
  }
  if (keys.empty()) {
    problems.push_back(def.info.key + ": a choice without choices");
  }
}

void checkCondition(const ParamDef& def,
                    const ParamSchema& schema,
                    std::vector<std::string>& problems) {
  for (const ParamCondition& condition : parseConditions(def.info.enabledIf)) {
    if (schema.find(condition.key) == nullptr) {
      problems.push_back(def.info.key + ": condition '" + std::string(condition.text) +
                         "' does not compare another parameter");
    }
  }
}

}  // namespace

std::vector<std::string> schemaProblems(const ParamSchema& schema) {
  std::vector<std::string> problems;
  std::set<std::string> keys;
  for (const ParamDef& def : schema.defs()) {
    const std::string& key = def.info.key;
    std::vector<std::string> names = def.info.aliases;
    names.push_back(key);
    for (const std::string& name : names) {
      if (!isSnakeCase(name)) {
        problems.push_back("'" + name + "' is not a snake_case key");
      }
      if (!keys.insert(name).second) {
        problems.push_back("'" + name + "' is declared twice");
      }
    }
    if (trimText(def.info.label).empty()) {
      problems.push_back(key + ": has no label");
    }
    if (!(def.info.min <= def.info.max)) {
      problems.push_back(key + ": the minimum is above the maximum");
    }
    checkChoices(def, problems);
    checkCondition(def, schema, problems);
    for (const ParamProblem& problem : schema.validate(Value::object({{key, def.defaultValue}}))) {
      problems.push_back(problem.path + ": its default " + toCompactJson(def.defaultValue) + " " +
                         problem.message.str());
    }
  }
  return problems;
}

}  // namespace wcam::plugin
