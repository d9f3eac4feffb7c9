// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/project_lock.hpp"

#include "test_folder.hpp"
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

namespace wcam::project {
namespace {

/// Reads one byte. @return false at the end of the pipe
bool readByte(int fd) {
  char byte = 0;
  return ::read(fd, &byte, 1) == 1;
}

// A process that was killed keeps what it holds until the system has taken it apart: here a zombie
// whose file is held open a little longer by its child.
TEST(ProjectLock, OfAProcessThatEndsIsWaitedFor) {
  const testing::TestFolder folder;
  const std::filesystem::path file = folder / "part.wcam";
  std::array<int, 2> ready{};
  std::array<int, 2> release{};
  ASSERT_EQ(::pipe(ready.data()), 0);
  ASSERT_EQ(::pipe(release.data()), 0);
  const pid_t holder = ::fork();
  ASSERT_GE(holder, 0);
  if (holder == 0) {
    ProjectLock::Attempt taken = ProjectLock::attempt(file, ProjectLock::Use::Open);
    if (::fork() == 0) {
      ::close(release[1]);
      (void)::write(ready[1], "r", 1);
      readByte(release[0]);  // until the test has seen the lock
      ::usleep(200 * 1000);
      ::_exit(0);  // without the destructor: the file stays
    }
    (void)taken.lock.release();
    ::_exit(0);
  }
  ASSERT_TRUE(readByte(ready[0]));
  // A zombie from now on: it is not waited for.
  siginfo_t info{};
  ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(holder), &info, WEXITED | WNOWAIT), 0);
  ASSERT_EQ(::write(release[1], "g", 1), 1);
  const ProjectLock::Attempt taken = ProjectLock::attempt(file, ProjectLock::Use::Open);
  EXPECT_NE(taken.lock, nullptr) << taken.holder.str();
  ::waitpid(holder, nullptr, 0);
  for (const int fd : {ready[0], ready[1], release[0], release[1]}) {
    ::close(fd);
  }
}

TEST(ProjectLock, OfALivingProcessIsRefusedAtOnceWithItsName) {
  const testing::TestFolder folder;
  const std::filesystem::path file = folder / "part.wcam";
  const ProjectLock::Attempt own = ProjectLock::attempt(file, ProjectLock::Use::Open);
  ASSERT_NE(own.lock, nullptr);
  const ProjectLock::Attempt second = ProjectLock::attempt(file, ProjectLock::Use::Open);
  EXPECT_EQ(second.lock, nullptr);
  EXPECT_TRUE(second.isOpen);
  EXPECT_NE(second.holder.str().find(std::to_string(::getpid())), std::string::npos);
}

}  // namespace
}  // namespace wcam::project
