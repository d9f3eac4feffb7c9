// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/text.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace wcam {

/// What a path really names, whatever the spelling: the file itself where it exists (links
/// followed, hard links alike), else its name in the folder that exists. Equal for two paths that
/// hit the same file.
std::string fileIdentity(const std::filesystem::path& file);

/// Which files a run reads and which it writes: the one place that decides what an output may hit.
class OutputPlan {
public:
  /// A file that the run reads or that must stay. An empty path is none.
  /// @throws Error(OutputConflict) when the run writes it already
  void keep(const std::filesystem::path& file, const Text& what);
  /// A file that the run writes. @throws Error(OutputConflict) when it would replace one that is
  /// kept, or one that the run writes already. Pipes and devices replace nothing.
  void write(const std::filesystem::path& file, const Text& what);

private:
  struct Entry {
    Text what;
    bool written = false;
  };

  std::map<std::string, Entry> entries_;
};

/// "-": standard output instead of a file.
inline constexpr const char* kStandardOutput = "-";

/// Writes a result that stands alone: to standard output for "-", in place to what is no regular
/// file (a pipe, a device), else as writeFileAtomically. @throws Error(OutputConflict)
void writeResult(const std::filesystem::path& file, std::string_view content);

/// Files of one folder that are replaced together, or not at all.
///
/// prepare() writes them all into a folder of their own within the target and flushes them; until
/// then the target is as it was. swap() renames that folder, after which the set is decided, and
/// moves the files to their places. What an interruption leaves in between is finished by the next
/// prepare(), and unfinished() tells it. Links within the folder are not followed.
class OutputSet {
public:
  explicit OutputSet(std::filesystem::path folder);
  /// Takes back what was not swapped.
  ~OutputSet();
  OutputSet(const OutputSet&) = delete;
  OutputSet& operator=(const OutputSet&) = delete;

  /// @param path relative to the folder, without ".."
  void add(std::string path, std::string content);
  /// Makes the folder when it is missing, waits for another run that writes there, and writes
  /// everything beside. @throws Error(OutputConflict); nothing has changed then
  void prepare();
  /// @throws Error(OutputConflict)
  void swap();

  /// Has a run been interrupted while its files took their places?
  [[nodiscard]] static bool unfinished(const std::filesystem::path& folder);

private:
  struct File {
    std::string path;
    std::string content;
  };

  void stage(const File& file) const;

  std::filesystem::path folder_;
  std::vector<File> files_;
  std::vector<std::filesystem::path> made_;  ///< folders made for the set, the innermost first
  int lock_ = -1;
  bool staged_ = false;
};

}  // namespace wcam
