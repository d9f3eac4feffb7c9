// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wcam {

/// A JSON-like value: what crosses the border to files, plugins and commands.
///
/// Objects keep the order of their keys. Copies share arrays and objects until one is changed (copy
/// on write), so a snapshot of a document costs a pointer. Integers and reals are distinct, so a
/// file that is read and written again keeps its bytes. Accessors throw Error(InvalidArgument) on a
/// wrong type.
class Value {
public:
  enum class Type { Null, Bool, Integer, Real, String, Array, Object };
  using Array = std::vector<Value>;
  using Member = std::pair<std::string, Value>;
  using Object = std::vector<Member>;

  Value() = default;

  Value(std::nullptr_t) {}

  Value(bool b) : type_(Type::Bool), integer_(b ? 1 : 0) {}

  Value(int i) : type_(Type::Integer), integer_(i) {}

  Value(std::int64_t i) : type_(Type::Integer), integer_(i) {}

  Value(std::size_t i) : type_(Type::Integer), integer_(static_cast<std::int64_t>(i)) {}

  Value(double d) : type_(Type::Real), real_(d) {}

  Value(const char* s) : Value(std::string(s)) {}

  Value(std::string_view s) : Value(std::string(s)) {}

  Value(std::string s);
  Value(Array items);
  Value(Object members);

  static Value array() { return Value(Array{}); }

  static Value object() { return Value(Object{}); }

  static Value object(std::initializer_list<Member> members) { return Value(Object(members)); }

  [[nodiscard]] Type type() const noexcept { return type_; }

  [[nodiscard]] bool isNull() const noexcept { return type_ == Type::Null; }

  [[nodiscard]] bool isBool() const noexcept { return type_ == Type::Bool; }

  [[nodiscard]] bool isInteger() const noexcept { return type_ == Type::Integer; }

  [[nodiscard]] bool isNumber() const noexcept {
    return type_ == Type::Integer || type_ == Type::Real;
  }

  [[nodiscard]] bool isString() const noexcept { return type_ == Type::String; }

  [[nodiscard]] bool isArray() const noexcept { return type_ == Type::Array; }

  [[nodiscard]] bool isObject() const noexcept { return type_ == Type::Object; }

  [[nodiscard]] bool asBool() const;
  [[nodiscard]] std::int64_t asInteger() const;
  [[nodiscard]] double asReal() const;  ///< integers convert
  [[nodiscard]] const std::string& asString() const;
  [[nodiscard]] const Array& asArray() const;
  [[nodiscard]] const Object& asObject() const;

  /// Member of an object, or null when this is no object or has no such key.
  [[nodiscard]] const Value* find(std::string_view key) const noexcept;
  /// Member of an object; throws Error(InvalidArgument) naming the key when it is missing.
  [[nodiscard]] const Value& at(std::string_view key) const;

  [[nodiscard]] bool contains(std::string_view key) const noexcept { return find(key) != nullptr; }

  /// Number of items or members; 0 for scalars.
  [[nodiscard]] std::size_t size() const noexcept;

  /// Sets or replaces a member (appended when new). A null value becomes an object first.
  Value& set(std::string key, Value value);
  /// Removes a member; false when there was none.
  bool remove(std::string_view key);
  /// Appends to an array. A null value becomes an array first.
  Value& push(Value value);
  /// Write access to items and members; detaches from shared copies.
  Array& mutableArray();
  Object& mutableObject();
  Value* findMutable(std::string_view key);

  /// Deep comparison; the order of keys counts, and 1 differs from 1.0.
  friend bool operator==(const Value& a, const Value& b);

  friend bool operator!=(const Value& a, const Value& b) { return !(a == b); }

private:
  Type type_ = Type::Null;
  std::int64_t integer_ = 0;
  double real_ = 0.0;
  std::shared_ptr<std::string> string_;
  std::shared_ptr<Array> array_;
  std::shared_ptr<Object> object_;
};

const char* toString(Value::Type type) noexcept;

}  // namespace wcam
