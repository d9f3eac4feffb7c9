// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/log.hpp"

#include <deque>
#include <mutex>

namespace wcam::log {

namespace {
constexpr std::size_t kKept = 1000;

struct State {
  std::mutex mutex;
  Sink sink;
  std::deque<Record> kept;
};

State& state() {
  static State instance;
  return instance;
}
}  // namespace

void setSink(Sink sink) {
  State& s = state();
  const std::lock_guard lock(s.mutex);
  s.sink = std::move(sink);
  if (s.sink) {
    for (const Record& record : s.kept) {
      s.sink(record);
    }
    s.kept.clear();
  }
}

void write(Level level, std::string_view domain, std::string_view message) {
  State& s = state();
  const std::lock_guard lock(s.mutex);
  Record record{level, std::string(domain), std::string(message)};
  if (s.sink) {
    s.sink(record);
    return;
  }
  if (s.kept.size() == kKept) {
    s.kept.pop_front();
  }
  s.kept.push_back(std::move(record));
}

}  // namespace wcam::log
