// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/json.hpp"

#include "wcam/base/budget.hpp"
#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <unordered_set>

namespace wcam {

namespace {

constexpr std::size_t kMaxDepth = 200;

/// Iterator over the text that tells how far the parser has read, so that errors of meaning (a key
/// twice, too deep nesting) can name their line.
class TrackedIterator {
public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  TrackedIterator(const char* at, const char** reached) : at_(at), reached_(reached) {}

  reference operator*() const { return *at_; }

  TrackedIterator& operator++() {
    *reached_ = ++at_;
    return *this;
  }

  TrackedIterator operator++(int) {
    TrackedIterator before(*this);
    ++*this;
    return before;
  }

  friend bool operator==(const TrackedIterator& a, const TrackedIterator& b) {
    return a.at_ == b.at_;
  }

private:
  const char* at_;
  const char** reached_;
};

/// Keys of an object are looked up one by one: no file of ours has more than some hundred in one.
constexpr std::size_t kMostKeys = 10000;

/// Builds a Value from the parser's events; no recursion, so that deep nesting cannot exhaust the
/// stack.
class Builder : public nlohmann::json_sax<nlohmann::json> {
public:
  Builder(std::string_view text, std::string context)
      : text_(text), reached_(text.data()), context_(std::move(context)) {}

  TrackedIterator begin() { return {text_.data(), &reached_}; }

  TrackedIterator end() { return {text_.data() + text_.size(), &reached_}; }

  bool null() override { return put(Value()); }

  bool boolean(bool v) override { return put(Value(v)); }

  bool number_integer(number_integer_t v) override {
    return put(Value(static_cast<std::int64_t>(v)));
  }

  bool number_unsigned(number_unsigned_t v) override {
    if (v > static_cast<number_unsigned_t>(std::numeric_limits<std::int64_t>::max())) {
      return put(Value(static_cast<double>(v)));
    }
    return put(Value(static_cast<std::int64_t>(v)));
  }

  bool number_float(number_float_t v, const string_t&) override {
    if (!std::isfinite(v)) {
      fail("a number is too large");
    }
    return put(Value(v));
  }

  bool string(string_t& v) override { return put(Value(std::move(v))); }

  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(Value::object()); }

  bool start_array(std::size_t) override { return open(Value::array()); }

  bool end_object() override { return close(); }

  bool end_array() override { return close(); }

  bool key(string_t& v) override {
    if (!stack_.back().keys.insert(v).second) {
      fail(text("the key '%1' stands twice in one object", {v}));
    }
    if (stack_.back().keys.size() > kMostKeys) {
      fail(text("an object has more than %1 keys", {std::to_string(kMostKeys)}));
    }
    stack_.back().key = std::move(v);
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& e) override {
    // nlohmann: "[json.exception.parse_error.101] parse error at line 3, column 4: ..."
    std::string message = e.what();
    if (const std::size_t end = message.find("] "); end != std::string::npos) {
      message.erase(0, end + 2);
    }
    if (message.find(" at line ") == std::string::npos) {
      fail(message);
    }
    const bool encoding = message.find("UTF-8") != std::string::npos;
    throw Error(ErrorCode::InputInvalid, message, context_,
                encoding ? text("the file must be UTF-8 JSON") : syntaxHint());
  }

  Value take() { return std::move(result_); }

private:
  struct Level {
    Value value;
    std::string key;
    std::unordered_set<std::string> keys;  ///< only asked, so that its order does not matter
  };

  static Text syntaxHint() {
    return text(
        "correct the file at this place: in JSON numbers are finite and have a decimal point, "
        "texts "
        "stand in double quotes, and every key stands once in its object");
  }

  [[noreturn]] void fail(const Text& message) const {
    // The parser has read one character past the token, or is right behind it.
    const std::string_view done(text_.data(), static_cast<std::size_t>(reached_ - text_.data()));
    const auto line = 1 + std::count(done.begin(), done.end() - (done.empty() ? 0 : 1), '\n');
    throw Error(ErrorCode::InputInvalid, text("line %1: %2", {std::to_string(line), message}),
                context_, syntaxHint());
  }

  bool open(Value container) {
    if (stack_.size() >= kMaxDepth) {
      fail("nested deeper than 200 levels");
    }
    stack_.push_back({std::move(container), {}, {}});
    return true;
  }

  bool close() {
    Value done = std::move(stack_.back().value);
    stack_.pop_back();
    return put(std::move(done));
  }

  bool put(Value value) {
    if (++count_ > budget().jsonValues) {
      requireBudget(count_, "json_values", wcam::text("the file holds too many values"), context_);
    }
    if (stack_.empty()) {
      result_ = std::move(value);
    } else if (stack_.back().value.isArray()) {
      stack_.back().value.push(std::move(value));
    } else {
      stack_.back().value.mutableObject().emplace_back(std::move(stack_.back().key),
                                                       std::move(value));
    }
    return true;
  }

  std::string_view text_;
  const char* reached_;
  std::string context_;
  std::vector<Level> stack_;
  Value result_;
  std::uint64_t count_ = 0;
};

void writeText(std::string& out, const std::string& text) {
  // Keeps UTF-8 as it is; throws on invalid UTF-8, which parse cannot produce.
  out += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void writeScalar(std::string& out, const Value& value) {
  switch (value.type()) {
    case Value::Type::Null:
      out += "null";
      return;
    case Value::Type::Bool:
      out += value.asBool() ? "true" : "false";
      return;
    case Value::Type::Integer:
      out += std::to_string(value.asInteger());
      return;
    case Value::Type::Real:
      out += formatReal(value.asReal());
      return;
    case Value::Type::String:
      writeText(out, value.asString());
      return;
    case Value::Type::Array:
    case Value::Type::Object:
      return;
  }
}

bool isScalar(const Value& value) {
  return !value.isArray() && !value.isObject();
}

/// @param indent current indentation, or -1 for one line
void write(std::string& out, const Value& value, int indent) {
  if (isScalar(value)) {
    writeScalar(out, value);
    return;
  }
  const bool object = value.isObject();
  if (value.size() == 0) {
    out += object ? "{}" : "[]";
    return;
  }
  const bool oneLine = indent < 0 || (!object && std::all_of(value.asArray().begin(),
                                                             value.asArray().end(), isScalar));
  const auto newline = [&](int depth) {
    if (!oneLine) {
      out += '\n';
      out.append(static_cast<std::size_t>(depth), ' ');
    }
  };
  out += object ? '{' : '[';
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (i > 0) {
      out += oneLine ? ", " : ",";
    }
    newline(indent + 2);
    if (object) {
      writeText(out, value.asObject()[i].first);
      out += ": ";
    }
    write(out, object ? value.asObject()[i].second : value.asArray()[i], oneLine ? -1 : indent + 2);
  }
  newline(indent);
  out += object ? '}' : ']';
}

}  // namespace

Value parseJson(std::string_view text, const std::string& context) {
  if (trimText(text).empty()) {
    throw Error(ErrorCode::InputInvalid, "the file is empty", context,
                "the file must be UTF-8 JSON");
  }
  // The parser takes a zero byte for the end, and would drop what follows.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n');
    throw Error(ErrorCode::InputInvalid, wcam::text("line %1: a zero byte", {std::to_string(line)}),
                context, "the file must be UTF-8 JSON");
  }
  Builder builder(text, context);
  if (!nlohmann::json::sax_parse(builder.begin(), builder.end(), &builder)) {
    throw Error(ErrorCode::InputInvalid, "not JSON", context);
  }
  return builder.take();
}

std::string toCanonicalJson(const Value& value) {
  std::string out;
  write(out, value, 0);
  out += '\n';
  return out;
}

std::string toCompactJson(const Value& value) {
  std::string out;
  write(out, value, -1);
  return out;
}

std::string formatReal(double number) {
  if (!std::isfinite(number)) {
    throw Error(ErrorCode::Internal, "a number that is not finite cannot be written");
  }
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, number);
  std::string text(buffer, end);
  if (text.find_first_of(".e") == std::string::npos) {
    text += ".0";
  }
  return text;
}

}  // namespace wcam
