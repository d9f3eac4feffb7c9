// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/value.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace wcam {

enum class ParamType { Bool, Integer, Real, Text, Choice, Vector3, File };
enum class ParamLevel { Basic, Advanced, Expert };
const char* toString(ParamType type) noexcept;
const char* toString(ParamLevel level) noexcept;

struct ParamChoice {
  std::string key;
  std::string label;
};

/// What the author of a component writes about one parameter. Limits are in file units (mm,
/// degrees, ...).
struct ParamInfo {
  std::string key = {};  ///< stable, snake_case
  std::string label = {};
  std::string help = {};
  std::string group = "General";
  ParamLevel level = ParamLevel::Basic;
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  std::string enabledIf =
      {};  ///< conditions on other keys: "mode=fixed", "seam!=nearest and closed=true"
  std::vector<ParamChoice> choices = {};
  std::vector<std::string> aliases = {};  ///< former keys, still read
};

/// A declared parameter: its info, its type and its default in file units.
struct ParamDef {
  ParamInfo info;
  ParamType type = ParamType::Real;
  QuantityKind quantity = QuantityKind::None;
  Value defaultValue;
};

/// One wrong parameter. `unknown` marks a key that the schema does not have.
struct ParamProblem {
  std::string path;
  Text message;
  bool unknown = false;
};

/// The declaration of all parameters of a component. Everything else derives from it (DESIGN 6):
/// validation, JSON schema, --set, reference page, form.
class ParamSchema {
public:
  ParamSchema() = default;

  explicit ParamSchema(std::vector<ParamDef> defs) : defs_(std::move(defs)) {}

  [[nodiscard]] const std::vector<ParamDef>& defs() const noexcept { return defs_; }

  [[nodiscard]] const ParamDef* find(std::string_view key) const noexcept;

  /// All problems of a (sparse) object of parameters, in the order of its keys.
  [[nodiscard]] std::vector<ParamProblem> validate(const Value& params,
                                                   const std::string& path = {}) const;
  /// Defaults filled in, aliases renamed, texts with units converted to numbers; keys in declared
  /// order.
  /// @throws Error(InvalidArgument) listing all problems (unknown keys are not one here)
  [[nodiscard]] Value complete(const Value& params, const std::string& context = {}) const;
  /// Converts the text of `--set key=text` to a value in file units. @throws Error(InvalidArgument)
  [[nodiscard]] Value parse(std::string_view key, std::string_view text) const;
  /// True when the parameter's condition holds for these (completed) parameters.
  /// @throws Error(Internal) for a condition that names no declared parameter
  [[nodiscard]] static bool enabled(const ParamDef& def, const Value& completed);
  /// JSON Schema 2020-12 of the object of parameters.
  [[nodiscard]] Value jsonSchema(const std::string& title) const;
  /// Markdown table rows of the reference page.
  [[nodiscard]] std::string markdown() const;

private:
  std::vector<ParamDef> defs_;
};

/// Throws Error(code) with every problem on its own line; does nothing when there is none.
void throwProblems(const std::vector<ParamProblem>& problems, ErrorCode code, const Text& context);

namespace detail {
template <class T>
struct IsQuantity : std::false_type {};

template <QuantityKind K>
struct IsQuantity<Quantity<K>> : std::true_type {};
}  // namespace detail

/// Binds the fields of a plain struct to parameters. The default of each is the field's own initial
/// value:
///
///     struct Params { Length step = 2.0_mm; bool alternate = true; };
///     const auto schema = Schema<Params>{}
///         .add(&Params::step, {.key = "step", .label = "Layer step", .min = 0.1, .max = 20})
///         .add(&Params::alternate, {.key = "alternate", .label = "Alternate direction"});
///     Params p = schema.read(values, "operation elbow");
///
/// Field types: bool, int, double, Quantity, std::string, std::array<double,3>, enum (with
/// choices).
template <class T>
class Schema {
public:
  template <class M>
  Schema& add(M T::*field,
              ParamInfo info,
              ParamType type = typeOf<M>(),
              QuantityKind kind = kindOf<M>()) {
    const T defaults{};
    if constexpr (std::is_integral_v<M> && !std::is_same_v<M, bool>) {
      // What the field cannot hold is out of range, whatever the declaration says.
      info.min = std::max(info.min, static_cast<double>(std::numeric_limits<M>::min()));
      info.max = std::min(info.max, static_cast<double>(std::numeric_limits<M>::max()));
    }
    ParamDef def{std::move(info), type, kind, {}};
    def.defaultValue = toValue(defaults.*field, def);
    fields_.push_back([field](T& target, const Value& value, const ParamDef& d) {
      fromValue(target.*field, value, d);
    });
    defs_.push_back(std::move(def));
    return *this;
  }

  [[nodiscard]] ParamSchema params() const { return ParamSchema(defs_); }

  /// Validated struct from a sparse object. @throws Error(InvalidArgument) listing all problems
  [[nodiscard]] T read(const Value& params, const std::string& context = {}) const {
    const Value completed = ParamSchema(defs_).complete(params, context);
    T result{};
    for (std::size_t i = 0; i < defs_.size(); ++i) {
      fields_[i](result, completed.at(defs_[i].info.key), defs_[i]);
    }
    return result;
  }

private:
  template <class M>
  static constexpr ParamType typeOf() {
    if constexpr (std::is_same_v<M, bool>) {
      return ParamType::Bool;
    } else if constexpr (std::is_enum_v<M>) {
      return ParamType::Choice;
    } else if constexpr (std::is_integral_v<M>) {
      return ParamType::Integer;
    } else if constexpr (std::is_same_v<M, std::string>) {
      return ParamType::Text;
    } else if constexpr (std::is_same_v<M, std::array<double, 3>>) {
      return ParamType::Vector3;
    } else {
      return ParamType::Real;
    }
  }

  template <class M>
  static constexpr QuantityKind kindOf() {
    if constexpr (detail::IsQuantity<M>::value) {
      return M::kKind;
    } else {
      return QuantityKind::None;
    }
  }

  template <class M>
  static Value toValue(const M& m, const ParamDef& def) {
    if constexpr (detail::IsQuantity<M>::value) {
      return Value(toFileNumber(M::kKind, m.value()));
    } else if constexpr (std::is_enum_v<M>) {
      return Value(def.info.choices.at(static_cast<std::size_t>(m)).key);
    } else if constexpr (std::is_same_v<M, std::array<double, 3>>) {
      return Value(Value::Array{toFileNumber(def.quantity, m[0]), toFileNumber(def.quantity, m[1]),
                                toFileNumber(def.quantity, m[2])});
    } else if constexpr (std::is_same_v<M, double>) {
      return Value(toFileNumber(def.quantity, m));
    } else if constexpr (std::is_integral_v<M> && !std::is_same_v<M, bool>) {
      return Value(static_cast<std::int64_t>(m));
    } else {
      return Value(m);
    }
  }

  template <class M>
  static void fromValue(M& m, const Value& value, const ParamDef& def) {
    if constexpr (detail::IsQuantity<M>::value) {
      m = M(fromFileUnit(M::kKind, value.asReal()));
    } else if constexpr (std::is_enum_v<M>) {
      for (std::size_t i = 0; i < def.info.choices.size(); ++i) {
        if (def.info.choices[i].key == value.asString()) {
          m = static_cast<M>(i);
        }
      }
    } else if constexpr (std::is_same_v<M, std::array<double, 3>>) {
      for (std::size_t i = 0; i < 3; ++i) {
        m[i] = fromFileUnit(def.quantity, value.asArray()[i].asReal());
      }
    } else if constexpr (std::is_same_v<M, double>) {
      m = fromFileUnit(def.quantity, value.asReal());
    } else if constexpr (std::is_same_v<M, bool>) {
      m = value.asBool();
    } else if constexpr (std::is_integral_v<M>) {
      m = static_cast<M>(value.asInteger());
    } else {
      m = value.asString();
    }
  }

  std::vector<ParamDef> defs_;
  std::vector<std::function<void(T&, const Value&, const ParamDef&)>> fields_;
};

}  // namespace wcam
