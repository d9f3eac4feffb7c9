// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>

namespace wcam {

/// Closes on scope exit.
class Descriptor {
public:
  explicit Descriptor(int fd) : fd_(fd) {}

  ~Descriptor() {
    if (fd_ >= 0) {
      ::close(fd_);
    }
  }

  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int get() const { return fd_; }

private:
  int fd_;
};

inline std::string causeOf(int error) {
  return std::generic_category().message(error);
}

/// Writes all of it. @return errno, 0 for success
inline int writeAll(int fd, std::string_view content) {
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t put = ::write(fd, content.data() + done, content.size() - done);
    if (put < 0 && errno != EINTR) {
      return errno;
    }
    done += put > 0 ? static_cast<std::size_t>(put) : 0;
  }
  return 0;
}

}  // namespace wcam
