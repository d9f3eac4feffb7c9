// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/text.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace wcam::project {

/// The right to write a project file, held by one program at a time: camcli while it changes the
/// file, a window while the project is open. A lock on `.<name>.lock` in the folder of the file;
/// links to the file share it. It ends with the program, however that ends.
class ProjectLock {
public:
  enum class Use {
    Change,  ///< for moments: others wait
    Open     ///< for long: others are refused at once
  };

  /// Result of an attempt: the lock, or who holds it, or why there is none.
  struct Attempt {
    std::unique_ptr<ProjectLock> lock;
    Text holder;          ///< "process 12 on host"; empty when nobody holds it
    bool isOpen = false;  ///< the holder has the project open
    int error = 0;  ///< errno when the lock file cannot be made, such as in a read-only folder
  };

  static Attempt attempt(const std::filesystem::path& project, Use use);

  /// Waits for a change to end. @throws Error(OutputConflict) when a window has the project open,
  /// another program holds the lock for long, or the lock file cannot be made
  static std::unique_ptr<ProjectLock> take(const std::filesystem::path& project,
                                           Use use = Use::Change);

  ~ProjectLock();
  ProjectLock(const ProjectLock&) = delete;
  ProjectLock& operator=(const ProjectLock&) = delete;

private:
  ProjectLock(int fd, std::filesystem::path file) : fd_(fd), file_(std::move(file)) {}

  int fd_;
  std::filesystem::path file_;
};

}  // namespace wcam::project
