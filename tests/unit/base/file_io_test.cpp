// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"

#include "error_matchers.hpp"
#include "test_folder.hpp"
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

namespace wcam {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using wcam::testing::errorOf;
using wcam::testing::TestFolder;

std::size_t entriesOf(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder),
                                                std::filesystem::directory_iterator()));
}

TEST(FileIo, PipesAndDevicesAreRefusedAtOnce) {
  const TestFolder folder;
  const std::filesystem::path pipe = folder / "pipe.json";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::filesystem::path& file :
       {pipe, std::filesystem::path("/dev/zero"), std::filesystem::path("/dev/null")}) {
    EXPECT_THAT(errorOf(ErrorCode::InputInvalid, [&] { (void)readFile(file); }),
                AllOf(HasSubstr("a device or a pipe"), HasSubstr(file.string())));
  }
}

TEST(FileIo, WritesAndReadsBytes) {
  const TestFolder folder;
  const std::string bytes("a\0\xff\r\n", 5);
  writeFileAtomically(folder / "é .bin", bytes);
  EXPECT_EQ(readFile(folder / "é .bin"), bytes);
  writeFileAtomically(folder / "é .bin", "");
  EXPECT_EQ(readFile(folder / "é .bin"), "");
  EXPECT_EQ(entriesOf(folder.path()), 1U);
}

TEST(FileIo, LongestNameCanBeWritten) {
  const TestFolder folder;
  const std::string name(255, 'n');
  writeFileAtomically(folder / name, "x");
  EXPECT_EQ(readFile(folder / name), "x");
}

TEST(FileIo, MissingFileAndFolderAreNamed) {
  const TestFolder folder;
  EXPECT_THAT(errorOf(ErrorCode::InputNotFound, [&] { (void)readFile(folder / "none"); }),
              AllOf(HasSubstr(pathText(folder / "none")), HasSubstr("does not exist")));
  EXPECT_THAT(errorOf(ErrorCode::InputInvalid, [&] { (void)readFile(folder.path()); }),
              HasSubstr("folder"));
  EXPECT_THAT(
      errorOf(ErrorCode::OutputConflict, [&] { writeFileAtomically(folder / "no/x", "x"); }),
      HasSubstr(pathText(folder / "no/x")));
  EXPECT_THAT(errorOf(ErrorCode::OutputConflict, [&] { writeFileAtomically(folder.path(), "x"); }),
              HasSubstr(pathText(folder.path())));
  EXPECT_EQ(entriesOf(folder.path()), 0U);
}

TEST(FileIo, KeepsPermissionsAndLinks) {
  const TestFolder folder;
  const mode_t mask = ::umask(022);
  writeFileAtomically(folder / "new", "x");
  ::umask(mask);

  struct stat info {};

  ASSERT_EQ(::stat((folder / "new").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777U, 0644U);
  ASSERT_EQ(::chmod((folder / "new").c_str(), 0600), 0);
  std::filesystem::create_symlink("new", folder / "link");
  writeFileAtomically(folder / "link", "y");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(readFile(folder / "new"), "y");
  ASSERT_EQ(::stat((folder / "new").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777U, 0600U);
}

TEST(FileIo, UnwritableFolderIsNamed) {
  const TestFolder folder;
  const auto blocked = folder / "file";
  writeFileAtomically(blocked, "x");
  // A file stands where a folder would be needed: this fails for every user, also for root.
  EXPECT_THAT(errorOf(ErrorCode::OutputConflict, [&] { writeFileAtomically(blocked / "x", "x"); }),
              HasSubstr(pathText(blocked / "x")));
  EXPECT_THAT(errorOf(ErrorCode::OutputConflict, [&] { createFolder(blocked / "sub"); }),
              HasSubstr("cannot be made"));
  EXPECT_THAT(errorOf(ErrorCode::OutputConflict, [&] { createFolder(blocked); }),
              HasSubstr(pathText(blocked)));
  createFolder(folder / "a/b/c");
  createFolder(folder / "a/b/c");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b/c"));
}

/// A file system of 64 KiB on a folder, seen by this process only. False where the system does not
/// allow that.
bool mountSmallDisk(const std::filesystem::path& folder) {
  return (::unshare(CLONE_NEWNS) == 0 || ::unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0) &&
         ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
         ::mount("wcam-test", folder.c_str(), "tmpfs", 0, "size=64k") == 0;
}

/// From now on write() fails beyond a size, in the middle of a file.
void limitFileSize() {
  ::signal(SIGXFSZ, SIG_IGN);
  const rlimit most{65536, 65536};
  ::setrlimit(RLIMIT_FSIZE, &most);
}

/// Runs in a child process, which may lose its rights and its disk. @return empty when all is right
std::string saveOnFullDisk(const std::filesystem::path& folder, bool smallDisk) {
  if (!smallDisk || !mountSmallDisk(folder)) {
    smallDisk = false;
    limitFileSize();
  }
  const auto file = folder / "project.wcam";
  writeFileAtomically(file, "old content");
  try {
    writeFileAtomically(file, std::string(1000000, 'n'));
    return "the write did not fail";
  } catch (const Error& error) {
    if (error.code() != ErrorCode::OutputConflict || error.context() != pathText(file) ||
        error.hint().empty()) {
      return error.what();
    }
    if (smallDisk && error.hint().find("free some space") == std::string::npos) {
      return error.hint();
    }
  }
  if (readFile(file) != "old content") {
    return "the old file is lost";
  }
  return entriesOf(folder) == 1 ? "" : "a temporary file stayed";
}

void expectOldFileStays(bool smallDisk) {
  const TestFolder folder;
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    std::string found;
    try {
      found = saveOnFullDisk(folder.path(), smallDisk);
    } catch (const std::exception& error) {
      found = error.what();
    }
    // Not written is noticed as well: the exit status says that something was found.
    const ssize_t written = ::write(ends[1], found.data(), found.size());
    ::_exit(found.empty() && written == 0 ? 0 : 1);
  }
  ::close(ends[1]);
  std::string found(4096, ' ');
  found.resize(
      static_cast<std::size_t>(std::max<ssize_t>(0, ::read(ends[0], found.data(), found.size()))));
  ::close(ends[0]);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << found;
}

TEST(FileIo, FullDiskKeepsTheOldFile) {
  expectOldFileStays(true);
}

TEST(FileIo, AWriteThatFailsHalfwayKeepsTheOldFile) {
  expectOldFileStays(false);
}

}  // namespace
}  // namespace wcam
