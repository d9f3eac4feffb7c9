// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trust.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/plugin/locations.hpp"

#include <sys/stat.h>
#include <unistd.h>

namespace wcam::plugin {

namespace fs = std::filesystem;

namespace {

/// Owner of the engine: who could replace it need not replace a plugin.
uid_t engineOwner() {
  struct stat status {};

  return ::stat(engineFolder().c_str(), &status) == 0 ? status.st_uid : 0;
}

/// @param through whether the path only leads to the file: a folder such as /tmp, in which
/// everybody may write but only the owner may replace, is then no danger
Text writerOf(const fs::path& path, bool through) {
  struct stat status {};

  if (::stat(path.c_str(), &status) != 0) {
    return {};
  }
  const std::string name = pathText(path);
  if (status.st_uid != 0 && status.st_uid != ::geteuid() && status.st_uid != engineOwner()) {
    return text("%1 belongs to another user, who could change it", {name});
  }
  if (through && (status.st_mode & S_ISVTX) != 0) {
    return {};
  }
  if ((status.st_mode & S_IWOTH) != 0) {
    return text("everybody can write %1; take that right away (chmod o-w)", {name});
  }
  if ((status.st_mode & S_IWGRP) != 0 && status.st_gid != 0 && status.st_gid != ::getegid()) {
    return text("another group can write %1; take that right away (chmod g-w)", {name});
  }
  return {};
}

}  // namespace

Text trustProblem(const fs::path& library) {
  std::error_code error;
  const fs::path real = fs::canonical(library, error);
  if (error) {
    return {};
  }
  const fs::path folder = fs::canonical(fs::absolute(library).parent_path(), error);
  if (error || real.parent_path() != folder) {
    return text("it is a link out of its folder, to %1", {pathText(real)});
  }
  if (Text problem = writerOf(real, false); !problem.empty()) {
    return problem;
  }
  if (Text problem = writerOf(folder, false); !problem.empty()) {
    return problem;
  }
  for (fs::path above = folder; above.has_relative_path();) {
    above = above.parent_path();
    if (Text problem = writerOf(above, true); !problem.empty()) {
      return problem;
    }
  }
  return {};
}

}  // namespace wcam::plugin
