// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/project/project_file.hpp"
#include "wcam/project/project_lock.hpp"

#include "verbs.hpp"

#include <filesystem>
#include <memory>

namespace wcam::cli {

/// A project file between being read and being saved. No other program writes it meanwhile.
struct ChangedProject {
  /// @throws as ProjectLock::take and project::loadProject
  explicit ChangedProject(const std::filesystem::path& file);

  /// Saves the document in its file.
  void save(const Session& session, const project::Document& document) const;

  std::unique_ptr<project::ProjectLock> lock;
  project::LoadedProject loaded;
};

}  // namespace wcam::cli
