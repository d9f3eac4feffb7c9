// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/param.hpp"

#include "wcam/base/json.hpp"
#include "wcam/base/param_condition.hpp"
#include "wcam/base/plausible.hpp"
#include "wcam/base/text.hpp"

#include <algorithm>
#include <cmath>

namespace wcam {

namespace {

std::vector<std::string> keysOf(const std::vector<ParamDef>& defs) {
  std::vector<std::string> keys;
  keys.reserve(defs.size());
  for (const ParamDef& def : defs) {
    keys.push_back(def.info.key);
  }
  return keys;
}

std::string limitText(double limit, const ParamDef& def) {
  std::string text =
      def.type == ParamType::Integer ? std::to_string(std::llround(limit)) : formatReal(limit);
  if (text.ends_with(".0")) {
    text.resize(text.size() - 2);
  }
  const std::string unit = fileUnit(def.quantity);
  return unit.empty() ? text : text + " " + unit;
}

/// The declared limits, and where there are none those of the quantity.
PlausibleRange limitsOf(const ParamDef& def) {
  if (def.quantity == QuantityKind::None) {
    return {def.info.min, def.info.max};
  }
  const PlausibleRange range = plausibleRange(def.quantity);
  return {std::max(def.info.min, range.min), std::min(def.info.max, range.max)};
}

/// Empty when the number keeps the limits.
Text limitProblem(double number, const ParamDef& def) {
  if (!std::isfinite(number)) {
    return "is not a finite number";
  }
  if (number < def.info.min) {
    return text("%1 is below the minimum of %2",
                {limitText(number, def), limitText(def.info.min, def)});
  }
  if (number > def.info.max) {
    return text("%1 is above the maximum of %2",
                {limitText(number, def), limitText(def.info.max, def)});
  }
  return implausible(number, def.quantity);
}

std::string choiceList(const ParamDef& def) {
  std::vector<std::string> keys;
  for (const ParamChoice& choice : def.info.choices) {
    keys.push_back(choice.key);
  }
  return joinText(keys, ", ");
}

/// A number, or a text with a unit, in file units.
double readNumber(const Value& value, const ParamDef& def) {
  return value.isString()
             ? toFileNumber(def.quantity, parseQuantity(value.asString(), def.quantity))
             : value.asReal();
}

/// Normalised value (numbers instead of texts with units). @throws Error(InvalidArgument) with the
/// problem
Value normalise(const Value& value, const ParamDef& def) {
  const auto fail = [](const Text& message) -> Value {
    throw Error(ErrorCode::InvalidArgument, message);
  };
  switch (def.type) {
    case ParamType::Bool:
      return Value(value.asBool());
    case ParamType::Integer: {
      if (!value.isInteger()) {
        return fail(text("expected an integer, got %1", {toString(value.type())}));
      }
      const Text problem = limitProblem(static_cast<double>(value.asInteger()), def);
      return problem.empty() ? value : fail(problem);
    }
    case ParamType::Real: {
      const double number = readNumber(value, def);
      const Text problem = limitProblem(number, def);
      return problem.empty() ? Value(number) : fail(problem);
    }
    case ParamType::Text:
    case ParamType::File:
      return Value(value.asString());
    case ParamType::Choice: {
      for (const ParamChoice& choice : def.info.choices) {
        if (value.isString() && choice.key == value.asString()) {
          return value;
        }
      }
      const Text got =
          value.isString() ? Text("'" + value.asString() + "'") : Text(toString(value.type()));
      return fail(text("%1 is not one of: %2", {got, choiceList(def)}));
    }
    case ParamType::Vector3: {
      if (!value.isArray() || value.size() != 3) {
        return fail("expected a list of 3 numbers");
      }
      Value::Array items;
      for (const Value& item : value.asArray()) {
        const double number = readNumber(item, def);
        const Text problem = limitProblem(number, def);
        if (!problem.empty()) {
          return fail(problem);
        }
        items.emplace_back(number);
      }
      return Value(std::move(items));
    }
  }
  return value;
}

bool sameText(const Value& value, std::string_view text) {
  switch (value.type()) {
    case Value::Type::Bool:
      return text == (value.asBool() ? "true" : "false");
    case Value::Type::String:
      return value.asString() == text;
    case Value::Type::Integer:
    case Value::Type::Real: {
      const auto number = parseReal(text);
      return number && *number == value.asReal();
    }
    default:
      return false;
  }
}

}  // namespace

const char* toString(ParamType type) noexcept {
  switch (type) {
    case ParamType::Bool:
      return "bool";
    case ParamType::Integer:
      return "integer";
    case ParamType::Real:
      return "real";
    case ParamType::Text:
      return "text";
    case ParamType::Choice:
      return "choice";
    case ParamType::Vector3:
      return "vector3";
    case ParamType::File:
      return "file";
  }
  return "text";
}

const char* toString(ParamLevel level) noexcept {
  switch (level) {
    case ParamLevel::Basic:
      return "basic";
    case ParamLevel::Advanced:
      return "advanced";
    case ParamLevel::Expert:
      return "expert";
  }
  return "basic";
}

const ParamDef* ParamSchema::find(std::string_view key) const noexcept {
  for (const ParamDef& def : defs_) {
    if (def.info.key == key || std::find(def.info.aliases.begin(), def.info.aliases.end(), key) !=
                                   def.info.aliases.end()) {
      return &def;
    }
  }
  return nullptr;
}

std::vector<ParamProblem> ParamSchema::validate(const Value& params,
                                                const std::string& path) const {
  if (params.isNull()) {
    return {};
  }
  if (!params.isObject()) {
    return {{path, std::string("expected an object, got ") + toString(params.type()), false}};
  }
  std::vector<ParamProblem> problems;
  for (const auto& [key, value] : params.asObject()) {
    const std::string place = path.empty() ? key : path + "." + key;
    const ParamDef* def = find(key);
    if (def == nullptr) {
      const auto near = nearestName(key, keysOf(defs_));
      problems.push_back({place,
                          near ? text("is not a parameter here; did you mean '%1'?", {*near})
                               : text("is not a parameter here"),
                          true});
      continue;
    }
    try {
      normalise(value, *def);
    } catch (const Error& error) {
      problems.push_back({place, error.messageText(), false});
    }
  }
  return problems;
}

Value ParamSchema::complete(const Value& params, const std::string& context) const {
  std::vector<ParamProblem> problems = validate(params, context);
  std::erase_if(problems, [](const ParamProblem& p) { return p.unknown; });
  throwProblems(problems, ErrorCode::InvalidArgument, {});
  Value result = Value::object();
  for (const ParamDef& def : defs_) {
    const Value* given = params.find(def.info.key);
    for (const std::string& alias : def.info.aliases) {
      given = given != nullptr ? given : params.find(alias);
    }
    result.set(def.info.key, given != nullptr ? normalise(*given, def) : def.defaultValue);
  }
  return result;
}

Value ParamSchema::parse(std::string_view key, std::string_view text) const {
  const ParamDef* def = find(key);
  if (def == nullptr) {
    const auto near = nearestName(key, keysOf(defs_));
    throw Error(ErrorCode::InvalidArgument,
                wcam::text("'%1' is not a parameter here", {std::string(key)}), {},
                near ? wcam::text("did you mean '%1'?", {*near})
                     : wcam::text("parameters: %1", {joinText(keysOf(defs_), ", ")}));
  }
  const std::string name(key);
  try {
    switch (def->type) {
      case ParamType::Bool:
        if (text == "true" || text == "false") {
          return Value(text == "true");
        }
        throw Error(ErrorCode::InvalidArgument,
                    wcam::text("'%1' is neither true nor false", {std::string(text)}));
      case ParamType::Integer: {
        const auto number = parseReal(text);
        if (!number || *number != std::floor(*number) || std::abs(*number) > 9e15) {
          throw Error(ErrorCode::InvalidArgument,
                      wcam::text("'%1' is not an integer", {std::string(text)}));
        }
        return normalise(Value(static_cast<std::int64_t>(*number)), *def);
      }
      case ParamType::Vector3: {
        Value::Array items;
        for (const std::string& part : splitText(text, ',')) {
          items.emplace_back(part);
        }
        return normalise(Value(std::move(items)), *def);
      }
      default:
        return normalise(Value(text), *def);
    }
  } catch (const Error& error) {
    throw Error(ErrorCode::InvalidArgument, error.messageText(), name, error.hintText());
  }
}

std::vector<ParamCondition> parseConditions(std::string_view enabledIf) {
  constexpr std::string_view kJoint = " and ";
  std::vector<ParamCondition> conditions;
  std::string_view rest = enabledIf;
  while (!rest.empty()) {
    const std::size_t end = rest.find(kJoint);
    ParamCondition condition{.text = rest.substr(0, end), .key = {}, .value = {}};
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + kJoint.size());
    const std::size_t equal = condition.text.find('=');
    if (equal != std::string_view::npos) {
      condition.negated = equal > 0 && condition.text[equal - 1] == '!';
      condition.key = trimText(condition.text.substr(0, condition.negated ? equal - 1 : equal));
      condition.value = trimText(condition.text.substr(equal + 1));
    }
    conditions.push_back(condition);
  }
  return conditions;
}

bool ParamSchema::enabled(const ParamDef& def, const Value& completed) {
  for (const ParamCondition& condition : parseConditions(def.info.enabledIf)) {
    const Value* value = completed.find(condition.key);
    if (value == nullptr) {
      throw Error(ErrorCode::Internal,
                  text("the condition '%1' names no declared parameter", {def.info.enabledIf}),
                  text("parameter %1", {def.info.key}), "correct the declaration of the component");
    }
    if (sameText(*value, condition.value) == condition.negated) {
      return false;
    }
  }
  return true;
}

Value ParamSchema::jsonSchema(const std::string& title) const {
  Value properties = Value::object();
  for (const ParamDef& def : defs_) {
    Value property = Value::object({{"title", def.info.label}});
    if (!def.info.help.empty()) {
      property.set("description", def.info.help);
    }
    const auto limits = [&def](Value& target) {
      const PlausibleRange range = limitsOf(def);
      if (std::isfinite(range.min)) {
        target.set("minimum", range.min);
      }
      if (std::isfinite(range.max)) {
        target.set("maximum", range.max);
      }
    };
    switch (def.type) {
      case ParamType::Bool:
        property.set("type", "boolean");
        break;
      case ParamType::Integer:
        property.set("type", "integer");
        limits(property);
        break;
      case ParamType::Real:
        property.set("type", "number");
        limits(property);
        break;
      case ParamType::Text:
      case ParamType::File:
        property.set("type", "string");
        break;
      case ParamType::Choice: {
        Value keys = Value::array();
        for (const ParamChoice& choice : def.info.choices) {
          keys.push(choice.key);
        }
        property.set("enum", keys);
        break;
      }
      case ParamType::Vector3: {
        Value items = Value::object({{"type", "number"}});
        limits(items);
        property.set("type", "array").set("items", items).set("minItems", 3).set("maxItems", 3);
        break;
      }
    }
    property.set("default", def.defaultValue);
    if (def.quantity != QuantityKind::None) {
      property.set("x-quantity", toString(def.quantity)).set("x-unit", fileUnit(def.quantity));
    }
    property.set("x-group", def.info.group).set("x-level", toString(def.info.level));
    if (!def.info.enabledIf.empty()) {
      property.set("x-enabled-if", def.info.enabledIf);
    }
    properties.set(def.info.key, property);
  }
  return Value::object({{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                        {"title", title},
                        {"type", "object"},
                        {"properties", properties}});
}

std::string ParamSchema::markdown() const {
  std::string text =
      "| Parameter | Type | Default | Limits | Level | Meaning |\n|---|---|---|---|---|---|\n";
  for (const ParamDef& def : defs_) {
    const std::string unit = fileUnit(def.quantity);
    std::string type = toString(def.type);
    if (def.type == ParamType::Choice) {
      type = choiceList(def);
    } else if (!unit.empty()) {
      type += ", " + unit;
    }
    std::string limits;
    const PlausibleRange range = limitsOf(def);
    if (std::isfinite(range.min)) {
      limits += "≥ " + limitText(range.min, def);
    }
    if (std::isfinite(range.max)) {
      limits += (limits.empty() ? "≤ " : ", ≤ ") + limitText(range.max, def);
    }
    text += "| `" + def.info.key + "` | " + type + " | `" + toCompactJson(def.defaultValue) +
            "` | " + limits + " | " + toString(def.info.level) + " | " + def.info.label +
            (def.info.help.empty() ? "" : ". " + def.info.help) + " |\n";
  }
  return text;
}

void throwProblems(const std::vector<ParamProblem>& problems, ErrorCode code, const Text& context) {
  if (problems.empty()) {
    return;
  }
  std::vector<Text> lines;
  lines.reserve(problems.size());
  for (const ParamProblem& problem : problems) {
    lines.push_back(text("%1: %2", {problem.path, problem.message}));
  }
  const Text all = joinTexts(lines, "\n  ");
  throw Error(
      code,
      lines.size() == 1 ? all : text("%1 problems:\n  %2", {std::to_string(lines.size()), all}),
      context, "correct the values and try again");
}

}  // namespace wcam
