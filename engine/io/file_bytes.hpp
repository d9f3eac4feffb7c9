// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

namespace wcam::io {

/// The bytes of a file in memory of exactly its size. It is read, not mapped, since a mapped file
/// that another program shortens would end this one with a bus error.
class FileBytes {
public:
  /// Looks at the cancel request every 16 MiB.
  /// @throws Error(InputNotFound / InputInvalid) naming the file; CancelledError
  FileBytes(const std::filesystem::path& file, const JobContext& context);

  [[nodiscard]] std::string_view view() const noexcept { return {data_.get(), size_}; }

private:
  std::unique_ptr<char[]> data_;
  std::size_t size_ = 0;
};

}  // namespace wcam::io
