// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/diagnostic.hpp"

#include <algorithm>

namespace wcam {

const char* toString(Severity severity) noexcept {
  switch (severity) {
    case Severity::Information:
      return "information";
    case Severity::Warning:
      return "warning";
    case Severity::Violation:
      return "violation";
  }
  return "information";
}

Value toValue(const Diagnostic& diagnostic) {
  Value result = Value::object({{"severity", toString(diagnostic.severity)},
                                {"code", diagnostic.code},
                                {"message", diagnostic.message.str()}});
  if (!diagnostic.remedy.empty()) {
    result.set("remedy", diagnostic.remedy.str());
  }
  const Place& place = diagnostic.place;
  if (place != Place{}) {
    Value where = Value::object();
    if (!place.operation.empty()) {
      where.set("operation", place.operation);
    }
    const auto put = [&where](const char* key, int index) {
      if (index >= 0) {
        where.set(key, index);
      }
    };
    put("layer", place.layer);
    put("bead", place.bead);
    put("point", place.point);
    result.set("place", where);
  }
  if (!diagnostic.data.empty()) {
    Value data = Value::object();
    for (const auto& [key, number] : diagnostic.data) {
      data.set(key, number);
    }
    result.set("data", data);
  }
  return result;
}

namespace {

/// "elbow layer 4 bead 1 point 13": people count from 1, files from 0.
std::string placeText(const Place& place) {
  std::string where = place.operation;
  const auto put = [&where](const char* name, int index) {
    if (index >= 0) {
      where += (where.empty() ? "" : " ") + std::string(name) + " " + std::to_string(index + 1);
    }
  };
  put("layer", place.layer);
  put("bead", place.bead);
  put("point", place.point);
  return where;
}

}  // namespace

std::string toLine(const Diagnostic& diagnostic) {
  std::string line = std::string(toString(diagnostic.severity)) + " " + diagnostic.code;
  if (diagnostic.place != Place{}) {
    line += " [" + placeText(diagnostic.place) + "]";
  }
  line += ": " + diagnostic.message.str();
  if (!diagnostic.remedy.empty()) {
    line += " (" + diagnostic.remedy.str() + ")";
  }
  return line;
}

Diagnostics::Diagnostics(const Diagnostics& other) {
  *this = other;
}

Diagnostics& Diagnostics::operator=(const Diagnostics& other) {
  if (this != &other) {
    const std::scoped_lock lock(mutex_, other.mutex_);
    items_ = other.items_;
    kinds_ = other.kinds_;
  }
  return *this;
}

void Diagnostics::addLocked(Diagnostic diagnostic) {
  Kind& kind = kinds_[{diagnostic.code, diagnostic.severity}];
  ++kind.count;
  if (kind.count <= kMostOfOneKind) {
    items_.push_back(std::move(diagnostic));
    return;
  }
  if (kind.count == kMostOfOneKind + 1) {
    kind.more = items_.size();
    items_.push_back({diagnostic.severity, "findings.more", {}, {}, {}, {}});
    items_.back().place.operation = diagnostic.place.operation;
  }
  const std::size_t beyond = kind.count - kMostOfOneKind;
  Diagnostic& more = items_[kind.more];
  more.message = text("%1 more findings of the kind %2 are not listed",
                      {std::to_string(beyond), diagnostic.code});
  more.data = {{"findings", static_cast<double>(beyond)}};
}

void Diagnostics::add(Diagnostic diagnostic) {
  const std::lock_guard lock(mutex_);
  addLocked(std::move(diagnostic));
}

void Diagnostics::append(const std::vector<Diagnostic>& items) {
  const std::lock_guard lock(mutex_);
  for (const Diagnostic& diagnostic : items) {
    addLocked(diagnostic);
  }
}

std::vector<Diagnostic> Diagnostics::items() const {
  const std::lock_guard lock(mutex_);
  return items_;
}

std::size_t Diagnostics::count(Severity severity) const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(std::count_if(
      items_.begin(), items_.end(), [&](const Diagnostic& d) { return d.severity == severity; }));
}

std::size_t Diagnostics::count(std::string_view code) const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(std::count_if(
      items_.begin(), items_.end(), [&](const Diagnostic& d) { return d.code == code; }));
}

}  // namespace wcam
