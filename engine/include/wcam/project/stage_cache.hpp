// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/sha256.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace wcam::project {

/// Result of a stage: the value, the key it was made under, and what was found on the way.
template <class T>
struct Staged {
  std::shared_ptr<const T> value;
  std::string key;
  std::vector<Diagnostic> findings;
};

/// Results of pipeline stages by the hash of everything they depend on (DESIGN 4): stage, its
/// version, the keys of its inputs, its parameters. Equal key, equal result. Thread-safe; the least
/// recently used results go first.
class StageCache {
public:
  /// @param capacity number of results kept
  /// @param bytes that they may take together, see Pipeline; 0: a sixteenth of the budget's memory
  explicit StageCache(std::size_t capacity = 256, std::size_t bytes = 0);

  /// The stored result, or the one that `make` gives. Findings of a stored result are the ones of
  /// its making.
  /// @param bytesOf about how much memory a value takes; a value beyond the cache's is not stored
  template <class T>
  Staged<T> get(const std::string& stage,
                std::string key,
                const JobContext& context,
                const std::function<T(const JobContext&)>& make,
                const std::function<std::size_t(const T&)>& bytesOf = {}) {
    if (const auto hit = find(key)) {
      return {std::static_pointer_cast<const T>(hit->value), std::move(key), hit->findings};
    }
    const JobContext own = context.withOwnDiagnostics();
    auto value = std::make_shared<const T>(make(own));
    const std::vector<Diagnostic> findings = own.diagnostics().items();
    store(stage, key, {value, findings}, bytesOf ? bytesOf(*value) : 0);
    return {std::move(value), std::move(key), findings};
  }

  /// How often a stage was computed, not found: tells tests and users what a change costs.
  [[nodiscard]] std::size_t runs(const std::string& stage) const;

private:
  struct Entry {
    std::shared_ptr<const void> value;
    std::vector<Diagnostic> findings;
  };

  struct Slot {
    Entry entry;
    std::size_t bytes = 0;
    std::size_t lastUse = 0;
  };

  std::shared_ptr<const Entry> find(const std::string& key);
  void store(const std::string& stage, const std::string& key, Entry entry, std::size_t bytes);
  void forgetOldest();

  mutable std::mutex mutex_;
  std::size_t capacity_;
  std::size_t mostBytes_;
  std::size_t bytes_ = 0;
  std::size_t clock_ = 0;
  std::map<std::string, Slot> slots_;
  std::map<std::string, std::size_t> runs_;
};

/// Feeds for stage keys: the stage's name and version first.
class StageKey {
public:
  StageKey(const std::string& stage, int version) { hash_.text(stage).integer(version); }

  StageKey& text(std::string_view text) {
    hash_.text(text);
    return *this;
  }

  StageKey& params(const Value& value);

  std::string hex() { return hash_.hex(); }

private:
  Sha256 hash_;
};

}  // namespace wcam::project
