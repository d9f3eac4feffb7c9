// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace wcam::test {

/// How a ZIP archive is written by hand.
struct ZipDress {
  bool sizes64 = false;        ///< sizes in ZIP64 fields, as .NET and 3D Builder write them
  bool directory64 = false;    ///< the end of the directory as ZIP64 too
  bool descriptor = false;     ///< sizes after the data
  bool stored = false;         ///< not deflated
  std::string before;          ///< bytes before the archive
  std::string after;           ///< comment of the archive
  int method = -1;             ///< a wrong method
  bool encrypted = false;      ///< only the mark
  std::int64_t unpacked = -1;  ///< a wrong size
};

class RawZip {
public:
  explicit RawZip(ZipDress dress) : dress_(std::move(dress)), bytes_(dress_.before) {}

  void add(const std::string& name, const std::string& content) {
    const std::string packed = dress_.stored ? content : deflated(content);
    const std::uint64_t offset = bytes_.size() - dress_.before.size();
    const std::uint32_t crc = static_cast<std::uint32_t>(crc32(
        0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size())));
    const std::uint64_t unpacked =
        dress_.unpacked >= 0 ? static_cast<std::uint64_t>(dress_.unpacked) : content.size();
    const int method = dress_.method >= 0 ? dress_.method : dress_.stored ? 0 : 8;
    const std::uint64_t flags = (dress_.descriptor ? 8U : 0U) | (dress_.encrypted ? 1U : 0U);
    const auto head = [&](std::string& to, bool local) {
      put(to, 45, 2);
      put(to, flags, 2);
      put(to, static_cast<std::uint64_t>(method), 2);
      put(to, 0, 4);
      const bool later = local && dress_.descriptor;
      put(to, later ? 0 : crc, 4);
      put(to, later ? 0 : dress_.sizes64 ? 0xFFFFFFFFU : packed.size(), 4);
      put(to, later ? 0 : dress_.sizes64 ? 0xFFFFFFFFU : unpacked, 4);
      put(to, name.size(), 2);
      put(to, dress_.sizes64 ? 20 : 0, 2);
    };
    const auto extra = [&](std::string& to) {
      if (dress_.sizes64) {
        put(to, 1, 2);
        put(to, 16, 2);
        put(to, unpacked, 8);
        put(to, packed.size(), 8);
      }
    };
    bytes_ += "PK\3\4";
    head(bytes_, true);
    bytes_ += name;
    extra(bytes_);
    bytes_ += packed;
    if (dress_.descriptor) {
      bytes_ += "PK\7\x8";
      put(bytes_, crc, 4);
      put(bytes_, packed.size(), dress_.sizes64 ? 8 : 4);
      put(bytes_, unpacked, dress_.sizes64 ? 8 : 4);
    }
    directory_ += "PK\1\2";
    put(directory_, 45, 2);
    head(directory_, false);
    put(directory_, 0, 2 + 2 + 2);
    put(directory_, 0, 4);
    put(directory_, offset, 4);
    directory_ += name;
    extra(directory_);
    ++count_;
  }

  std::string finish() {
    const std::uint64_t start = bytes_.size() - dress_.before.size();
    bytes_ += directory_;
    if (dress_.directory64) {
      const std::uint64_t end = bytes_.size();
      bytes_ += "PK\6\6";
      put(bytes_, 44, 8);
      put(bytes_, 45, 2);
      put(bytes_, 45, 2);
      put(bytes_, 0, 8);
      put(bytes_, count_, 8);
      put(bytes_, count_, 8);
      put(bytes_, directory_.size(), 8);
      put(bytes_, start, 8);
      bytes_ += "PK\6\7";
      put(bytes_, 0, 4);
      put(bytes_, end, 8);
      put(bytes_, 1, 4);
    }
    bytes_ += "PK\5\6";
    put(bytes_, 0, 4);
    put(bytes_, dress_.directory64 ? 0xFFFF : count_, 2);
    put(bytes_, dress_.directory64 ? 0xFFFF : count_, 2);
    put(bytes_, dress_.directory64 ? 0xFFFFFFFFU : directory_.size(), 4);
    put(bytes_, dress_.directory64 ? 0xFFFFFFFFU : start, 4);
    put(bytes_, dress_.after.size(), 2);
    return bytes_ + dress_.after;
  }

private:
  static void put(std::string& bytes, std::uint64_t value, int size) {
    for (int k = 0; k < size; ++k) {
      bytes.push_back(
          static_cast<char>(k < 8 ? value >> 8U * static_cast<unsigned>(k) & 0xFFU : 0));
    }
  }

  static std::string deflated(const std::string& content) {
    z_stream stream{};
    deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, content.size()), '\0');
    stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(packed.size() - stream.avail_out);
    deflateEnd(&stream);
    return packed;
  }

  ZipDress dress_;
  std::string bytes_;
  std::string directory_;
  std::uint64_t count_ = 0;
};

inline std::string rawZip(const std::vector<std::pair<std::string, std::string>>& parts,
                          const ZipDress& dress = {}) {
  RawZip zip(dress);
  for (const auto& [name, content] : parts) {
    zip.add(name, content);
  }
  return zip.finish();
}

}  // namespace wcam::test
