// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_format.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/text.hpp"
#include "wcam/io/import.hpp"

#include "foreign_format.hpp"
#include "stl_parser.hpp"
#include "text_scanner.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace wcam::io {

namespace {

struct Extension {
  const char* text;
  FileFormat format;
};

constexpr std::array<Extension, 14> kExtensions{{{".step", FileFormat::Step},
                                                 {".stp", FileFormat::Step},
                                                 {".p21", FileFormat::Step},
                                                 {".iges", FileFormat::Iges},
                                                 {".igs", FileFormat::Iges},
                                                 {".brep", FileFormat::BrepText},
                                                 {".brp", FileFormat::BrepText},
                                                 {".rle", FileFormat::BrepText},
                                                 {".bbrep", FileFormat::BrepBinary},
                                                 {".stl", FileFormat::Stl},
                                                 {".obj", FileFormat::Obj},
                                                 {".ply", FileFormat::Ply},
                                                 {".3mf", FileFormat::ThreeMf},
                                                 {".wsurf", FileFormat::Formula}}};

/// Signatures stand within this distance of the start, after blanks or a comment.
constexpr std::size_t kHeadSize = 512;

std::optional<FileFormat> byExtension(const std::filesystem::path& file) {
  const std::string extension = pathText(file.extension());
  for (const Extension& known : kExtensions) {
    if (equalNoCase(extension, known.text)) {
      return known.format;
    }
  }
  return std::nullopt;
}

/// First line of an IGES file: column 73 is 'S' (start section), columns 74 to 80 hold the
/// number 1.
bool looksLikeIges(std::string_view bytes) {
  constexpr std::size_t kSectionColumn = 72;
  constexpr std::size_t kLineSize = 80;
  if (bytes.size() < kLineSize || bytes[kSectionColumn] != 'S' ||
      bytes.substr(0, kLineSize).find('\n') != std::string_view::npos) {
    return false;
  }
  const std::string_view number = bytes.substr(kSectionColumn + 1, kLineSize - kSectionColumn - 1);
  return number.find_first_not_of(" 0") == number.size() - 1 && number.back() == '1';
}

/// The first word, whatever line end follows it.
bool startsWithPly(std::string_view text) {
  TextScanner scanner(text);
  return text.starts_with("ply") && scanner.word() == "ply" && scanner.atLineEnd();
}

std::optional<FileFormat> byContent(std::string_view bytes) {
  const PlainText plain(bytes.substr(0, std::min(bytes.size(), kHeadSize)));
  const std::string_view head = plain.view();
  const auto has = [&](std::string_view text) { return head.find(text) != std::string_view::npos; };
  if (head.starts_with("PK\x03\x04") || head.starts_with("PK\x05\x06")) {
    return FileFormat::ThreeMf;
  }
  if (startsWithPly(head)) {
    return FileFormat::Ply;
  }
  if (has("ISO-10303-21")) {
    return FileFormat::Step;
  }
  if (head.find("Open CASCADE Topology V") <= 1) {
    return FileFormat::BrepBinary;
  }
  if (head.starts_with("DBRep_DrawableShape") || has("CASCADE Topology V")) {
    return FileFormat::BrepText;
  }
  if (looksLikeStl(bytes)) {
    return FileFormat::Stl;
  }
  if (foreignFormat(bytes)) {
    return std::nullopt;
  }
  if (TextScanner(head).peekWord().starts_with('{')) {
    return FileFormat::Formula;
  }
  if (looksLikeIges(withoutByteOrderMark(bytes))) {
    return FileFormat::Iges;
  }
  return std::nullopt;
}

/// Formats that byContent() always knows when the file is what its extension says.
bool hasSignature(FileFormat format) {
  return format != FileFormat::Stl && format != FileFormat::Obj;
}

}  // namespace

const char* toString(FileFormat format) noexcept {
  switch (format) {
    case FileFormat::Step:
      return "STEP";
    case FileFormat::Iges:
      return "IGES";
    case FileFormat::BrepText:
    case FileFormat::BrepBinary:
      return "BREP";
    case FileFormat::Stl:
      return "STL";
    case FileFormat::Obj:
      return "OBJ";
    case FileFormat::Ply:
      return "PLY";
    case FileFormat::ThreeMf:
      return "3MF";
    case FileFormat::Formula:
      return "formula";
  }
  return "";
}

FileFormat detectFormat(const std::filesystem::path& file, std::string_view bytes) {
  const std::optional<FileFormat> extension = byExtension(file);
  const std::optional<FileFormat> content = byContent(bytes);
  if (content) {
    return *content;
  }
  if (const auto foreign = foreignFormat(bytes)) {
    throw Error(ErrorCode::InputInvalid,
                extension ? text("is %1, not a part in the format %2",
                                 {foreign->name, toString(*extension)})
                          : text("is %1, not a part", {foreign->name}),
                pathText(file), foreign->remedy);
  }
  if (!extension) {
    throw Error(ErrorCode::InputInvalid, "the format of the file is not known", pathText(file),
                "parts can be read from STEP, IGES, BREP, STL, OBJ, PLY, 3MF and wsurf files");
  }
  if (hasSignature(*extension)) {
    throw Error(ErrorCode::InputInvalid,
                text("is not a %1 file: it does not start like one", {toString(*extension)}),
                pathText(file), "the file is damaged or has the wrong extension");
  }
  return *extension;
}

const std::vector<std::string>& importExtensions() {
  static const std::vector<std::string> extensions = [] {
    std::vector<std::string> list;
    for (const Extension& known : kExtensions) {
      list.emplace_back(known.text);
    }
    return list;
  }();
  return extensions;
}

}  // namespace wcam::io
