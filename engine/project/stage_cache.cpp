// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/stage_cache.hpp"

#include "wcam/base/budget.hpp"
#include "wcam/base/json.hpp"

#include <algorithm>

namespace wcam::project {

StageCache::StageCache(std::size_t capacity, std::size_t bytes)
    : capacity_(std::max<std::size_t>(capacity, 1)),
      mostBytes_(bytes > 0 ? bytes : static_cast<std::size_t>(budget().memoryMb << 20U) / 16) {}

std::shared_ptr<const StageCache::Entry> StageCache::find(const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto slot = slots_.find(key);
  if (slot == slots_.end()) {
    return nullptr;
  }
  slot->second.lastUse = ++clock_;
  return std::make_shared<const Entry>(slot->second.entry);
}

void StageCache::store(const std::string& stage,
                       const std::string& key,
                       Entry entry,
                       std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  ++runs_[stage];
  if (const auto same = slots_.find(key); same != slots_.end()) {
    bytes_ -= same->second.bytes;
    slots_.erase(same);
  }
  if (bytes > mostBytes_) {
    return;
  }
  while (!slots_.empty() && (slots_.size() >= capacity_ || bytes_ + bytes > mostBytes_)) {
    forgetOldest();
  }
  bytes_ += bytes;
  slots_[key] = {std::move(entry), bytes, ++clock_};
}

void StageCache::forgetOldest() {
  const auto oldest = std::min_element(
      slots_.begin(), slots_.end(),
      [](const auto& a, const auto& b) { return a.second.lastUse < b.second.lastUse; });
  bytes_ -= oldest->second.bytes;
  slots_.erase(oldest);
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
