// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/diagnostic.hpp"
#include "wcam/project/document.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wcam::project {

/// One step of the file format: turns a tree of version `from` into one of version `from` + 1 (the
/// number itself is set by the caller).
struct Migration {
  int from = 0;
  std::string summary;  ///< what changed, for the user: "'speed' is now 'travel_speed'"
  std::function<Value(Value tree)> apply;
};

/// The steps of the released formats, in order. Version 1 is the first one, so there is none yet.
const std::vector<Migration>& releasedMigrations();

struct LoadedProject {
  Document document;
  std::filesystem::path file;
  std::vector<Diagnostic> findings;  ///< of the document, and `project.migrated` per step
  bool migrated = false;             ///< saving changes the format version of the file
  std::string sha256 = {};           ///< of the file as it was read
};

/// Parses the text of a project file; migrates older versions in memory.
/// @throws Error(InputInvalid) for text that is no JSON, Error(ProjectInvalid) listing all problems
LoadedProject parseProject(std::string_view text,
                           const std::filesystem::path& file,
                           const std::vector<Migration>& migrations = releasedMigrations());

/// Reads a project file. @throws also Error(InputNotFound)
LoadedProject loadProject(const std::filesystem::path& file,
                          const std::vector<Migration>& migrations = releasedMigrations());

/// Writes the canonical text atomically, under a ProjectLock of the caller. The autosave is that of
/// a window, which drops it itself.
/// @param expected hash of the file as the document was read from it; empty: whatever is there
/// @throws Error(ProjectReadOnly) for a document of a newer version, Error(OutputConflict), also
///   when the file is not what was read; the old file stays then.
void saveProject(const Document& document,
                 const std::filesystem::path& file,
                 const std::string& expected = {});

/// Empty when saving the loaded file would change no byte, else where it would, with the line.
/// @throws as loadProject
std::string checkCanonical(const std::filesystem::path& file);

/// `.<name>.autosave` in the folder of the project file.
std::filesystem::path autosavePath(const std::filesystem::path& file);
/// Atomic; does nothing for a read-only document.
void autosave(const Document& document, const std::filesystem::path& file);
void dropAutosave(const std::filesystem::path& file) noexcept;

/// The autosave to offer after a crash: it exists, is not older than the project file, holds
/// another content and can be read. Never throws for a damaged autosave: there is nothing to offer
/// then.
std::optional<LoadedProject> recoverable(const std::filesystem::path& file);

/// A file that the document names.
struct UsedFile {
  Text owner;            ///< "part 'elbow'", "cell"
  std::string jsonPath;  ///< "parts[0].file"
  FileRef ref;
};

/// All files of a document, in the order of the tree; each once per place.
std::vector<UsedFile> usedFiles(const Document& document);

/// Where a file of the project lies. `project` is the project file.
std::filesystem::path resolvePath(const std::filesystem::path& project, const FileRef& ref);

/// Looks at every file of the document: present, and with the pinned content.
/// @return findings `project.hash_changed` (warnings)
/// @throws Error(InputNotFound) naming every missing file with its owner
std::vector<Diagnostic> checkFiles(const Document& document, const std::filesystem::path& project);

/// SHA-256 of every file of the document by its path as written in the project.
/// @throws Error(InputNotFound)
std::map<std::string, std::string> hashFiles(const Document& document,
                                             const std::filesystem::path& project);

}  // namespace wcam::project
