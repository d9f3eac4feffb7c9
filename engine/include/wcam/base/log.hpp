// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace wcam::log {

enum class Level { Debug, Info, Warning, Error };

struct Record {
  Level level;
  std::string domain;  ///< module, for example "io"
  std::string message;
};

using Sink = std::function<void(const Record&)>;

/// Installs where records go (thread-safe; calls are serialised). Records written before are kept,
/// at most 1000 of them, and handed over. An empty sink returns to keeping.
void setSink(Sink sink);
void write(Level level, std::string_view domain, std::string_view message);

inline void debug(std::string_view domain, std::string_view message) {
  write(Level::Debug, domain, message);
}

inline void info(std::string_view domain, std::string_view message) {
  write(Level::Info, domain, message);
}

inline void warning(std::string_view domain, std::string_view message) {
  write(Level::Warning, domain, message);
}

}  // namespace wcam::log
