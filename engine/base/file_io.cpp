// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"

#include "wcam/base/budget.hpp"
#include "wcam/base/error.hpp"

#include "descriptor.hpp"
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace wcam {

namespace {

[[noreturn]] void cannotWrite(const std::filesystem::path& file, int error) {
  const Text hint = text(error == ENOSPC   ? "free some space on the disk and try again"
                         : error == EACCES ? "choose a folder that you may write to"
                                           : "choose another place");
  throw Error(ErrorCode::OutputConflict, text("cannot be written: %1", {causeOf(error)}),
              pathText(file), hint);
}

}  // namespace

void requireFileSize(std::uint64_t bytes, const std::filesystem::path& file) {
  constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20U;
  if (const std::uint64_t size = (bytes + kMebibyte - 1) / kMebibyte; size > budget().fileMb) {
    requireBudget(size, "file_mb", text("the file has %1 MiB", {std::to_string(size)}),
                  pathText(file));
  }
}

std::string readFile(const std::filesystem::path& file) {
  // Opening a pipe would wait for its writer.
  const Descriptor fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));

  struct stat info {};

  if (fd.get() < 0 || ::fstat(fd.get(), &info) != 0) {
    const int error = errno;
    throw Error(ErrorCode::InputNotFound,
                error == ENOENT ? text("the file does not exist")
                                : text("cannot be read: %1", {causeOf(error)}),
                pathText(file), "check the path and the permissions");
  }
  if (S_ISDIR(info.st_mode)) {
    throw Error(ErrorCode::InputInvalid, "is a folder, not a file", pathText(file));
  }
  if (!S_ISREG(info.st_mode)) {
    throw Error(ErrorCode::InputInvalid, "is a device or a pipe, not a file", pathText(file),
                "save the content in a file first");
  }
  requireFileSize(static_cast<std::uint64_t>(info.st_size > 0 ? info.st_size : 0), file);
  std::string content;
  content.resize(static_cast<std::size_t>(info.st_size > 0 ? info.st_size : 0));
  std::size_t done = 0;
  // The size is only a hint: files may grow.
  while (true) {
    if (done == content.size()) {
      requireFileSize(done, file);
      content.resize(done + 65536);
    }
    const ssize_t got = ::read(fd.get(), content.data() + done, content.size() - done);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      throw Error(ErrorCode::InputInvalid, text("cannot be read: %1", {causeOf(errno)}),
                  pathText(file));
    }
    if (got == 0) {
      content.resize(done);
      return content;
    }
    done += static_cast<std::size_t>(got);
  }
}

void writeFileAtomically(const std::filesystem::path& named, std::string_view content) {
  // A link keeps pointing to the file that it points to.
  std::error_code unresolved;
  const std::filesystem::path file =
      std::filesystem::is_symlink(std::filesystem::symlink_status(named, unresolved))
          ? std::filesystem::weakly_canonical(named, unresolved)
          : named;
  if (file.empty()) {
    cannotWrite(named, unresolved.value());
  }
  if (!mayReplace(file)) {
    throw Error(ErrorCode::OutputConflict, "is read-only and is not replaced", pathText(named),
                "make it writable, or choose another name");
  }
  // Short, so that it fits where the file's own name is of the longest kind.
  std::string temporary = (file.parent_path() / ".wcam-XXXXXX").native();
  const int rawFd = ::mkostemp(temporary.data(), O_CLOEXEC);
  if (rawFd < 0) {
    cannotWrite(file, errno);
  }
  int error = 0;
  {
    const Descriptor fd(rawFd);

    // A new file gets the usual permissions, a replaced one keeps its own.
    struct stat old {};

    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::fchmod(fd.get(), ::stat(file.c_str(), &old) == 0 ? (old.st_mode & 07777) : (0666 & ~mask));
    error = writeAll(fd.get(), content);
    if (error == 0 && ::fsync(fd.get()) != 0) {
      error = errno;
    }
  }
  if (error == 0 && ::rename(temporary.c_str(), file.c_str()) != 0) {
    error = errno;
  }
  if (error != 0) {
    ::unlink(temporary.c_str());
    cannotWrite(file, error);
  }
  const std::filesystem::path folder =
      file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  const Descriptor folderFd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folderFd.get() >= 0) {
    ::fsync(folderFd.get());
  }
}

bool mayReplace(const std::filesystem::path& file) {
  struct stat info {};

  // Who may write everything still does not mean to replace what is marked as read-only.
  return ::stat(file.c_str(), &info) != 0 ||
         ((info.st_mode & 0222) != 0 && ::access(file.c_str(), W_OK) == 0);
}

void createFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw Error(ErrorCode::OutputConflict,
                error ? text("the folder cannot be made: %1", {error.message()})
                      : text("the folder cannot be made: a file has this name"),
                pathText(folder), "choose a folder that you may write to");
  }
}

std::string pathText(const std::filesystem::path& path) {
  return path.native();
}

std::filesystem::path pathFromText(std::string_view text) {
  return std::filesystem::path(std::string(text));
}

}  // namespace wcam
