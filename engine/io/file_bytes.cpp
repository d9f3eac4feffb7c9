// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_bytes.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace wcam::io {

namespace {

constexpr std::size_t kChunk = std::size_t{16} << 20;

std::size_t regularFileSize(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    const bool missing = status.type() == std::filesystem::file_type::not_found;
    throw Error(
        ErrorCode::InputNotFound,
        missing ? text("the file does not exist") : text("cannot be read: %1", {error.message()}),
        pathText(file), "check the path and the permissions");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw Error(ErrorCode::InputInvalid,
                std::filesystem::is_directory(status) ? text("is a folder, not a file")
                                                      : text("is a device or a pipe, not a file"),
                pathText(file), "name the file of the part");
  }
  const auto size = std::filesystem::file_size(file, error);
  if (error) {
    throw Error(ErrorCode::InputNotFound, text("cannot be read: %1", {error.message()}),
                pathText(file));
  }
  requireFileSize(size, file);
  if (size == 0) {
    throw Error(ErrorCode::InputInvalid, "the file is empty", pathText(file),
                "export the part again");
  }
  return size;
}

}  // namespace

FileBytes::FileBytes(const std::filesystem::path& file, const JobContext& context)
    : size_(regularFileSize(file)) {
  std::ifstream stream;
  stream.rdbuf()->pubsetbuf(nullptr, 0);  // large reads go straight into the buffer
  stream.open(file, std::ios::binary);
  if (!stream) {
    throw Error(ErrorCode::InputNotFound, "cannot be opened", pathText(file),
                "check the permissions");
  }
  data_ = std::make_unique_for_overwrite<char[]>(size_);
  for (std::size_t done = 0; done < size_;) {
    context.check();
    const std::size_t want = std::min(kChunk, size_ - done);
    if (!stream.read(data_.get() + done, static_cast<std::streamsize>(want))) {
      throw Error(ErrorCode::InputInvalid, "the file became shorter while it was read",
                  pathText(file), "try again");
    }
    done += want;
    context.report(static_cast<double>(done) / static_cast<double>(size_));
  }
}

}  // namespace wcam::io
