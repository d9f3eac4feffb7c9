// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/value.hpp"

#include "wcam/base/error.hpp"

namespace wcam {

namespace {
[[noreturn]] void wrongType(const char* wanted, Value::Type got) {
  throw Error(ErrorCode::InvalidArgument, text("expected %1, got %2", {wanted, toString(got)}));
}
}  // namespace

const char* toString(Value::Type type) noexcept {
  switch (type) {
    case Value::Type::Null:
      return "null";
    case Value::Type::Bool:
      return "a boolean";
    case Value::Type::Integer:
      return "an integer";
    case Value::Type::Real:
      return "a number";
    case Value::Type::String:
      return "a text";
    case Value::Type::Array:
      return "a list";
    case Value::Type::Object:
      return "an object";
  }
  return "null";
}

Value::Value(std::string s)
    : type_(Type::String), string_(std::make_shared<std::string>(std::move(s))) {}

Value::Value(Array items) : type_(Type::Array), array_(std::make_shared<Array>(std::move(items))) {}

Value::Value(Object members)
    : type_(Type::Object), object_(std::make_shared<Object>(std::move(members))) {}

bool Value::asBool() const {
  if (type_ != Type::Bool) {
    wrongType("a boolean", type_);
  }
  return integer_ != 0;
}

std::int64_t Value::asInteger() const {
  if (type_ != Type::Integer) {
    wrongType("an integer", type_);
  }
  return integer_;
}

double Value::asReal() const {
  if (type_ == Type::Integer) {
    return static_cast<double>(integer_);
  }
  if (type_ != Type::Real) {
    wrongType("a number", type_);
  }
  return real_;
}

const std::string& Value::asString() const {
  if (type_ != Type::String) {
    wrongType("a text", type_);
  }
  return *string_;
}

const Value::Array& Value::asArray() const {
  if (type_ != Type::Array) {
    wrongType("a list", type_);
  }
  return *array_;
}

const Value::Object& Value::asObject() const {
  if (type_ != Type::Object) {
    wrongType("an object", type_);
  }
  return *object_;
}

const Value* Value::find(std::string_view key) const noexcept {
  if (type_ != Type::Object) {
    return nullptr;
  }
  for (const Member& member : *object_) {
    if (member.first == key) {
      return &member.second;
    }
  }
  return nullptr;
}

const Value& Value::at(std::string_view key) const {
  if (const Value* value = find(key)) {
    return *value;
  }
  if (type_ != Type::Object) {
    wrongType("an object", type_);
  }
  throw Error(ErrorCode::InvalidArgument, text("the key '%1' is missing", {std::string(key)}));
}

std::size_t Value::size() const noexcept {
  if (type_ == Type::Array) {
    return array_->size();
  }
  return type_ == Type::Object ? object_->size() : 0;
}

Value& Value::set(std::string key, Value value) {
  if (isNull()) {
    *this = object();
  }
  if (Value* present = findMutable(key)) {
    *present = std::move(value);
  } else {
    mutableObject().emplace_back(std::move(key), std::move(value));
  }
  return *this;
}

bool Value::remove(std::string_view key) {
  if (find(key) == nullptr) {
    return false;
  }
  return std::erase_if(mutableObject(), [key](const Member& m) { return m.first == key; }) > 0;
}

Value& Value::push(Value value) {
  if (isNull()) {
    *this = array();
  }
  mutableArray().push_back(std::move(value));
  return *this;
}

Value::Array& Value::mutableArray() {
  if (type_ != Type::Array) {
    wrongType("a list", type_);
  }
  if (array_.use_count() > 1) {
    array_ = std::make_shared<Array>(*array_);
  }
  return *array_;
}

Value::Object& Value::mutableObject() {
  if (type_ != Type::Object) {
    wrongType("an object", type_);
  }
  if (object_.use_count() > 1) {
    object_ = std::make_shared<Object>(*object_);
  }
  return *object_;
}

Value* Value::findMutable(std::string_view key) {
  if (find(key) == nullptr) {
    return nullptr;
  }
  for (Member& member : mutableObject()) {
    if (member.first == key) {
      return &member.second;
    }
  }
  return nullptr;
}

bool operator==(const Value& a, const Value& b) {
  if (a.type_ != b.type_) {
    return false;
  }
  switch (a.type_) {
    case Value::Type::Null:
      return true;
    case Value::Type::Bool:
    case Value::Type::Integer:
      return a.integer_ == b.integer_;
    case Value::Type::Real:
      return a.real_ == b.real_;
    case Value::Type::String:
      return *a.string_ == *b.string_;
    case Value::Type::Array:
      return a.array_ == b.array_ || *a.array_ == *b.array_;
    case Value::Type::Object:
      return a.object_ == b.object_ || *a.object_ == *b.object_;
  }
  return false;
}

}  // namespace wcam
