// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/stage_cache.hpp"

#include "wcam/base/json.hpp"

#include <algorithm>

namespace wcam::project {

StageCache::StageCache(std::size_t capacity) : capacity_(std::max<std::size_t>(capacity, 1)) {}

std::shared_ptr<const StageCache::Entry> StageCache::find(const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto slot = slots_.find(key);
  if (slot == slots_.end()) {
    return nullptr;
  }
  slot->second.lastUse = ++clock_;
  return std::make_shared<const Entry>(slot->second.entry);
}

void StageCache::store(const std::string& stage, const std::string& key, Entry entry) {
  const std::lock_guard lock(mutex_);
  ++runs_[stage];
  if (slots_.size() >= capacity_ && slots_.find(key) == slots_.end()) {
    slots_.erase(std::min_element(slots_.begin(), slots_.end(), [](const auto& a, const auto& b) {
      return a.second.lastUse < b.second.lastUse;
    }));
  }
  slots_[key] = {std::move(entry), ++clock_};
}

std::size_t StageCache::runs(const std::string& stage) const {
  const std::lock_guard lock(mutex_);
  const auto count = runs_.find(stage);
  return count == runs_.end() ? 0 : count->second;
}

StageKey& StageKey::params(const Value& value) {
  hash_.text(toCompactJson(value));
  return *this;
}

}  // namespace wcam::project
