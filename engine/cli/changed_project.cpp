// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "changed_project.hpp"

#include "wcam/base/file_io.hpp"

#include <system_error>

namespace wcam::cli {

namespace {

/// A file that does not exist needs no lock: reading it tells what is wrong.
std::unique_ptr<project::ProjectLock> lockOf(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored) ? project::ProjectLock::take(file)
                                                         : nullptr;
}

}  // namespace

ChangedProject::ChangedProject(const std::filesystem::path& file)
    : lock(lockOf(file)), loaded(project::loadProject(file)) {}

void ChangedProject::save(const Session& session, const project::Document& document) const {
  project::saveProject(document, loaded.file, loaded.sha256);
  const std::filesystem::path autosave = project::autosavePath(loaded.file);
  std::error_code ignored;
  if (std::filesystem::exists(autosave, ignored)) {
    session.console.complain("camcli: warning: " + pathText(autosave) +
                             " holds changes of a window that ended before it saved them; they do "
                             "not contain this change");
  }
}

}  // namespace wcam::cli
