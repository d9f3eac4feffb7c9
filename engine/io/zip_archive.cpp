// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "zip_archive.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"

#include "text_scanner.hpp"
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>

namespace wcam::io {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view kEndSignature = "PK\x05\x06"sv;
constexpr std::string_view kEnd64Signature = "PK\x06\x06"sv;
constexpr std::string_view kLocator64Signature = "PK\x06\x07"sv;
constexpr std::string_view kEntrySignature = "PK\x01\x02"sv;
constexpr std::string_view kLocalSignature = "PK\x03\x04"sv;
constexpr std::size_t kEndSize = 22;
constexpr std::size_t kLocator64Size = 20;
constexpr std::size_t kEntrySize = 46;
constexpr std::size_t kLocalSize = 30;
/// A comment of at most this length follows the end of the directory.
constexpr std::size_t kMaxComment = 0xFFFF;
constexpr std::uint16_t kZip64Extra = 0x0001;
constexpr std::uint16_t kSaturated16 = 0xFFFF;
constexpr std::uint32_t kSaturated32 = 0xFFFFFFFF;
constexpr std::uint16_t kStored = 0;
constexpr std::uint16_t kDeflated = 8;

constexpr std::size_t kChunk = 1 << 16;
/// Models shrink about eightfold, very regular ones thirtyfold; what grows more than this, and
/// beyond the size, was made to fill the memory.
constexpr std::uint64_t kMaxGrowth = 250;
constexpr std::uint64_t kHarmlessSize = std::uint64_t{64} << 20U;

}  // namespace

/// Little-endian numbers at a position; out of bounds is damage.
class ZipArchive::Reader {
public:
  Reader(const ZipArchive& archive, std::uint64_t position)
      : archive_(archive), position_(position) {}

  std::string_view take(std::uint64_t size) {
    if (position_ > archive_.bytes_.size() || size > archive_.bytes_.size() - position_) {
      archive_.fail("the ZIP archive is cut off");
    }
    const std::string_view part = archive_.bytes_.substr(position_, size);
    position_ += size;
    return part;
  }

  template <class T>
  T number() {
    const std::string_view raw = take(sizeof(T));
    T value = 0;
    for (std::size_t k = sizeof(T); k-- > 0;) {
      value = static_cast<T>(static_cast<std::uint64_t>(value) << 8U |
                             static_cast<unsigned char>(raw[k]));
    }
    return value;
  }

  std::uint16_t n16() { return number<std::uint16_t>(); }

  std::uint32_t n32() { return number<std::uint32_t>(); }

  std::uint64_t n64() { return number<std::uint64_t>(); }

  void skip(std::uint64_t size) { take(size); }

  void expect(std::string_view signature) {
    if (take(signature.size()) != signature) {
      archive_.fail("the directory of the ZIP archive is damaged");
    }
  }

  [[nodiscard]] std::uint64_t position() const { return position_; }

private:
  const ZipArchive& archive_;
  std::uint64_t position_;
};

ZipArchive::ZipArchive(std::string_view bytes, std::string file)
    : bytes_(bytes), file_(std::move(file)) {
  readDirectory();
}

void ZipArchive::fail(const Text& what, const Text& remedy) const {
  throw Error(ErrorCode::InputInvalid, what, file_,
              remedy.empty() ? text("the file is damaged or cut off; export it again") : remedy);
}

void ZipArchive::readDirectory() {
  const std::size_t tail = std::min(bytes_.size(), kEndSize + kMaxComment);
  const std::size_t inTail = bytes_.substr(bytes_.size() - tail).rfind(kEndSignature);
  if (inTail == std::string_view::npos) {
    fail("is not a readable ZIP package: its directory is missing");
  }
  const std::uint64_t end = bytes_.size() - tail + inTail;
  Reader reader(*this, end + kEndSignature.size());
  const std::uint16_t disk = reader.n16();
  const std::uint16_t firstDisk = reader.n16();
  reader.skip(2);
  std::uint64_t count = reader.n16();
  std::uint64_t size = reader.n32();
  std::uint64_t start = reader.n32();
  std::uint64_t directoryEnd = end;
  const bool has64 =
      end >= kLocator64Size && bytes_.substr(end - kLocator64Size, 4) == kLocator64Signature;
  if (has64) {
    Reader locator(*this, end - kLocator64Size + 8);
    directoryEnd = locator.n64();
    Reader end64(*this, directoryEnd);
    end64.expect(kEnd64Signature);
    end64.skip(8 + 2 + 2 + 4 + 4 + 8);
    count = end64.n64();
    size = end64.n64();
    start = end64.n64();
  } else if ((disk != 0 && disk != kSaturated16) || (firstDisk != 0 && firstDisk != kSaturated16)) {
    fail("is one volume of a divided ZIP archive", "join the volumes and open the whole archive");
  }
  if (size > directoryEnd || count > size / kEntrySize) {
    fail("the directory of the ZIP archive is damaged");
  }
  // Bytes before the archive move it; positions in it are counted from its own beginning.
  const std::uint64_t found = directoryEnd - size;
  const std::uint64_t shift = !has64 && found >= start ? found - start : 0;
  Reader directory(*this, start + shift);
  entries_.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    directory.expect(kEntrySignature);
    ZipEntry entry;
    directory.skip(2 + 2);
    entry.encrypted = (directory.n16() & 1U) != 0;
    entry.method = directory.n16();
    directory.skip(4);
    entry.crc = directory.n32();
    entry.packed = directory.n32();
    entry.unpacked = directory.n32();
    const std::uint16_t nameSize = directory.n16();
    const std::uint16_t extraSize = directory.n16();
    const std::uint16_t commentSize = directory.n16();
    directory.skip(2 + 2 + 4);
    entry.header = directory.n32();
    entry.name = directory.take(nameSize);
    const std::uint64_t extraEnd = directory.position() + extraSize;
    while (directory.position() + 4 <= extraEnd) {
      const std::uint16_t kind = directory.n16();
      const std::uint16_t length = directory.n16();
      Reader field(*this, directory.position());
      directory.skip(std::min<std::uint64_t>(length, extraEnd - directory.position()));
      std::uint64_t left = length;
      for (std::uint64_t* value : {&entry.unpacked, &entry.packed, &entry.header}) {
        if (kind == kZip64Extra && *value == kSaturated32 && left >= 8) {
          *value = field.n64();
          left -= 8;
        }
      }
    }
    directory.skip(extraEnd - directory.position() + commentSize);
    entry.header += shift;
    entries_.push_back(std::move(entry));
  }
}

std::string_view ZipArchive::packedBytes(const ZipEntry& entry) const {
  Reader local(*this, entry.header);
  local.expect(kLocalSignature);
  local.skip(kLocalSize - 4 - 2 - 2);
  const std::uint16_t nameSize = local.n16();
  const std::uint16_t extraSize = local.n16();
  local.skip(std::uint64_t{nameSize} + extraSize);
  return local.take(entry.packed);
}

void ZipArchive::read(const ZipEntry& entry,
                      const JobContext& context,
                      const std::function<void(const char*, std::size_t, bool)>& use) const {
  const std::string name = printableName(entry.name);
  if (entry.encrypted) {
    fail(text("part '%1' is encrypted", {name}), "save the package without a password");
  }
  if (entry.method != kStored && entry.method != kDeflated) {
    fail(text("part '%1' is packed by method %2; only deflate is known",
              {name, std::to_string(entry.method)}),
         "pack it with deflate, or export it again");
  }
  if (entry.unpacked > kHarmlessSize && entry.unpacked / kMaxGrowth > entry.packed) {
    throw Error(
        ErrorCode::InputInvalid,
        text("part '%1' grows from %2 to %3 when it is unpacked; at most %4 times its "
             "size is taken",
             {name, sizeText(entry.packed), sizeText(entry.unpacked), std::to_string(kMaxGrowth)}),
        file_, "the file was made to fill the memory; do not use it");
  }
  const std::string_view packed = packedBytes(entry);
  std::uint64_t done = 0;
  uLong crc = crc32(0, nullptr, 0);
  const auto give = [&](const char* data, std::size_t size) {
    context.check();
    done += size;
    if (done > entry.unpacked) {
      fail(text("part '%1' is damaged: it has more than the %2 bytes that the directory tells",
                {name, std::to_string(entry.unpacked)}));
    }
    crc = crc32(crc, reinterpret_cast<const Bytef*>(data), static_cast<uInt>(size));
    use(data, size, false);
  };
  if (entry.method == kStored) {
    for (std::size_t at = 0; at < packed.size(); at += kChunk) {
      give(packed.data() + at, std::min(kChunk, packed.size() - at));
    }
  } else {
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) {
      fail(text("part '%1' cannot be unpacked", {name}));
    }
    const std::unique_ptr<z_stream, int (*)(z_stream*)> closer(&stream, inflateEnd);
    std::vector<char> chunk(kChunk);
    std::size_t given = 0;
    int status = Z_OK;
    while (status != Z_STREAM_END) {
      if (stream.avail_in == 0) {
        const std::size_t more =
            std::min(packed.size() - given, std::size_t{std::numeric_limits<uInt>::max()});
        stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(packed.data() + given));
        stream.avail_in = static_cast<uInt>(more);
        given += more;
      }
      stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
      stream.avail_out = static_cast<uInt>(chunk.size());
      status = inflate(&stream, Z_NO_FLUSH);
      if (status != Z_OK && status != Z_STREAM_END) {
        fail(text("part '%1' is damaged: it cannot be unpacked beyond %2 bytes",
                  {name, std::to_string(done)}));
      }
      if (const std::size_t size = chunk.size() - stream.avail_out; size > 0) {
        give(chunk.data(), size);
      }
    }
  }
  if (done != entry.unpacked || crc != entry.crc) {
    fail(done != entry.unpacked ? text("part '%1' is damaged: it has %2 bytes instead of %3",
                                       {name, std::to_string(done), std::to_string(entry.unpacked)})
                                : text("part '%1' is damaged: its checksum is wrong", {name}));
  }
  use(nullptr, 0, true);
}

std::string sizeText(std::uint64_t bytes) {
  constexpr double kKilo = 1e3;
  constexpr double kMega = 1e6;
  constexpr double kGiga = 1e9;
  const auto size = static_cast<double>(bytes);
  if (size >= kGiga) {
    return formatFixed(size / kGiga, 1) + " GB";
  }
  return size >= kMega ? formatFixed(size / kMega, 1) + " MB"
                       : formatFixed(size / kKilo, 1) + " kB";
}

}  // namespace wcam::io
