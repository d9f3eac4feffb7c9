// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/output_set.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"

#include "descriptor.hpp"
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <set>
#include <system_error>
#include <thread>

namespace wcam {

namespace fs = std::filesystem;

namespace {

constexpr const char* kStaged = ".wcam-new";     ///< being written
constexpr const char* kDecided = ".wcam-ready";  ///< complete, on its way to the places

[[noreturn]] void refuse(const Text& message, const fs::path& file, const Text& hint) {
  throw Error(ErrorCode::OutputConflict, message, pathText(file), hint);
}

/// The file that a chain of links ends at, which need not exist.
fs::path linkTarget(fs::path file) {
  constexpr int kMostLinks = 40;  // as the kernel
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(file, error)); ++i) {
    const fs::path target = fs::read_symlink(file, error);
    if (error) {
      break;
    }
    file = target.is_absolute() ? target : file.parent_path() / target;
  }
  return file;
}

/// Missing folders of a path, the innermost first.
std::vector<fs::path> missingFolders(const fs::path& folder) {
  std::vector<fs::path> missing;
  std::error_code ignored;
  for (fs::path path = fs::absolute(folder, ignored).lexically_normal();
       !fs::exists(path, ignored) && path.has_relative_path(); path = path.parent_path()) {
    missing.push_back(path);
  }
  return missing;
}

void flushFolder(const fs::path& folder) {
  const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd >= 0) {
    ::fsync(fd);
    ::close(fd);
  }
}

void writeOrRefuse(int fd, std::string_view content, const fs::path& named) {
  if (const int error = writeAll(fd, content); error != 0) {
    refuse(text("cannot be written: %1", {causeOf(error)}), named,
           error == ENOSPC || error == EFBIG || error == EDQUOT
               ? text("free some space on the disk and try again")
               : text("choose another place"));
  }
}

/// Refuses what must not be replaced, and links on the way.
void checkPlace(const fs::path& folder, const fs::path& relative) {
  fs::path path = folder;
  for (auto part = relative.begin(); part != relative.end(); ++part) {
    path /= *part;
    const bool last = std::next(part) == relative.end();
    std::error_code error;
    const fs::file_status status = fs::symlink_status(path, error);
    if (!fs::exists(status)) {
      return;
    }
    if (fs::is_symlink(status)) {
      refuse("is a link, and links within an output folder are not followed", path,
             "remove the link, or choose another output folder");
    }
    if (!last && !fs::is_directory(status)) {
      refuse("the folder cannot be made: a file has this name", path,
             "choose a folder that you may write to");
    }
    if (!last && ::access(path.c_str(), W_OK | X_OK) != 0) {
      const int cause = errno;
      refuse(text("the folder cannot be written to: %1", {causeOf(cause)}), path,
             "choose a folder that you may write to");
    }
    if (last && !fs::is_regular_file(status)) {
      refuse("is not a regular file and is not replaced", path,
             "remove it, or choose another output folder");
    }
    if (last && !mayReplace(path)) {
      refuse("is read-only and is not replaced", path,
             "make it writable, or choose another output folder");
    }
  }
}

/// Moves what a decided set has not moved yet.
void moveToPlaces(const fs::path& folder) {
  const fs::path decided = folder / kDecided;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(decided)) {
    if (!entry.is_symlink() && entry.is_regular_file()) {
      files.push_back(entry.path().lexically_relative(decided));
    }
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    checkPlace(folder, file);
  }
  std::set<fs::path> folders;
  for (const fs::path& file : files) {
    const fs::path target = folder / file;
    std::error_code error;
    fs::create_directories(target.parent_path(), error);
    if (::rename((decided / file).c_str(), target.c_str()) != 0) {
      const int cause = errno;
      refuse(text("cannot be replaced: %1; the folder holds files of two runs", {causeOf(cause)}),
             target, "make the file and its folder writable and export again");
    }
    folders.insert(target.parent_path());
  }
  for (const fs::path& changed : folders) {
    flushFolder(changed);
  }
  std::error_code ignored;
  fs::remove_all(decided, ignored);
  flushFolder(folder);
}

}  // namespace

std::string fileIdentity(const fs::path& file) {
  std::error_code ignored;
  fs::path path = fs::absolute(linkTarget(file), ignored);
  std::string rest;

  struct stat info {};

  while (::stat(path.c_str(), &info) != 0 && path.has_relative_path()) {
    const fs::path name = path.filename();
    if (name == "..") {
      // Of a folder that does not exist: the spelling decides.
      path = path.lexically_normal();
      continue;
    }
    if (!name.empty() && name != ".") {
      rest = "/" + name.native() + rest;
    }
    path = path.parent_path();
  }
  if (!rest.empty()) {
    // By the folder's one real name: the rest may come to exist between two looks.
    const fs::path real = fs::canonical(path, ignored);
    return "/" + pathText((ignored ? path : real).relative_path()) + rest;
  }
  return std::to_string(info.st_dev) + ":" + std::to_string(info.st_ino);
}

void OutputPlan::keep(const fs::path& file, const Text& what) {
  if (file.empty()) {
    return;
  }
  const auto [entry, fresh] = entries_.emplace(fileIdentity(file), Entry{what, false});
  if (!fresh && entry->second.written) {
    refuse(text("%1 would replace %2", {entry->second.what, what}), file,
           "choose another name or folder");
  }
}

void OutputPlan::write(const fs::path& file, const Text& what) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (file.empty() || file == kStandardOutput ||
      (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))) {
    return;
  }
  const auto [entry, fresh] = entries_.emplace(fileIdentity(file), Entry{what, true});
  if (fresh) {
    return;
  }
  if (entry->second.written) {
    refuse(text("%1 and %2 both write %3", {entry->second.what, what, pathText(file.filename())}),
           file, "give one of them another name or folder");
  }
  refuse(text("%1 would replace %2", {what, entry->second.what}), file,
         "choose another name or folder");
}

void writeResult(const fs::path& file, std::string_view content) {
  if (file == kStandardOutput) {
    std::fwrite(content.data(), 1, content.size(), stdout);
    return;
  }
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status)) {
    writeFileAtomically(file, content);
    return;
  }
  const Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
  if (out.get() < 0) {
    const int cause = errno;
    refuse(text("cannot be written: %1", {causeOf(cause)}), file, "choose another place");
  }
  writeOrRefuse(out.get(), content, file);
}

OutputSet::OutputSet(fs::path folder)
    : folder_(folder.empty() ? fs::path(".") : std::move(folder)) {}

OutputSet::~OutputSet() {
  std::error_code ignored;
  if (staged_) {
    fs::remove_all(folder_ / kStaged, ignored);
  }
  for (const fs::path& path : made_) {
    // Removes empty folders only.
    fs::remove(path, ignored);
  }
  if (lock_ >= 0) {
    ::close(lock_);
  }
}

void OutputSet::add(std::string path, std::string content) {
  files_.push_back({std::move(path), std::move(content)});
}

void OutputSet::stage(const File& file) const {
  const fs::path target = folder_ / pathFromText(file.path);
  const fs::path staged = folder_ / kStaged / pathFromText(file.path);
  createFolder(staged.parent_path());
  const Descriptor out(
      ::open(staged.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (out.get() < 0) {
    const int cause = errno;
    refuse(text("cannot be written: %1", {causeOf(cause)}), target, "choose another place");
  }

  struct stat old {};

  if (::stat(target.c_str(), &old) == 0) {
    ::fchmod(out.get(), old.st_mode & 07777);
  }
  writeOrRefuse(out.get(), file.content, target);
  if (::fsync(out.get()) != 0) {
    const int cause = errno;
    refuse(text("cannot be written: %1", {causeOf(cause)}), target,
           "free some space on the disk and try again");
  }
}

void OutputSet::prepare() {
  made_ = missingFolders(folder_);
  createFolder(folder_);
  lock_ = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // Writing takes moments; who holds the lock for longer is stuck.
  constexpr int kTries = 1000;
  constexpr std::chrono::milliseconds kPause(10);
  for (int i = 0; ::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK; ++i) {
    if (i == kTries) {
      refuse("another run is writing to the folder", folder_,
             "wait until it has ended, or choose another output folder");
    }
    std::this_thread::sleep_for(kPause);
  }
  if (unfinished(folder_)) {
    moveToPlaces(folder_);
  }
  for (const File& file : files_) {
    checkPlace(folder_, pathFromText(file.path));
  }
  std::error_code ignored;
  fs::remove_all(folder_ / kStaged, ignored);
  staged_ = true;
  for (const File& file : files_) {
    stage(file);
  }
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / kStaged, ignored)) {
    if (entry.is_directory()) {
      flushFolder(entry.path());
    }
  }
  flushFolder(folder_ / kStaged);
}

void OutputSet::swap() {
  if (::rename((folder_ / kStaged).c_str(), (folder_ / kDecided).c_str()) != 0) {
    const int cause = errno;
    refuse(text("cannot be written: %1", {causeOf(cause)}), folder_, "choose another place");
  }
  staged_ = false;
  flushFolder(folder_);
  moveToPlaces(folder_);
}

bool OutputSet::unfinished(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(fs::symlink_status(folder / kDecided, ignored));
}

}  // namespace wcam
