// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/text.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace wcam::io {

struct ZipEntry {
  std::string name;  ///< as written
  std::uint16_t method = 0;
  bool encrypted = false;
  std::uint32_t crc = 0;
  std::uint64_t packed = 0;
  std::uint64_t unpacked = 0;
  std::uint64_t header = 0;  ///< position of its local header
};

/// A ZIP archive in memory, by its central directory; with ZIP64, and with bytes before or after
/// the archive. Stored and deflated entries.
class ZipArchive {
public:
  /// @throws Error(InputInvalid) naming the file
  ZipArchive(std::string_view bytes, std::string file);

  [[nodiscard]] const std::vector<ZipEntry>& entries() const noexcept { return entries_; }

  /// Calls `use` with the unpacked bytes piece by piece, at last with none and `last`. Entries that
  /// grow beyond all measure, other sizes and checksums than told are refused.
  /// @throws Error(InputInvalid) naming the file and the entry; CancelledError
  void read(const ZipEntry& entry,
            const JobContext& context,
            const std::function<void(const char*, std::size_t, bool)>& use) const;

  /// @param remedy empty: the file is damaged
  [[noreturn]] void fail(const Text& what, const Text& remedy = {}) const;

private:
  class Reader;

  void readDirectory();
  [[nodiscard]] std::string_view packedBytes(const ZipEntry& entry) const;

  std::string_view bytes_;
  std::string file_;
  std::vector<ZipEntry> entries_;
};

/// "3.9 MB": a number of bytes for people.
std::string sizeText(std::uint64_t bytes);

}  // namespace wcam::io
