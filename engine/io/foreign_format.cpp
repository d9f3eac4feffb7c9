// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "foreign_format.hpp"

#include "text_scanner.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace wcam::io {

namespace {

using namespace std::string_view_literals;

enum class Remedy { Download, Export, Unpack, ExportMesh };

struct Signature {
  std::string_view bytes;  ///< lower case where it is text
  Text name;
  Remedy remedy;
  bool letters = false;  ///< letters in any case, after blanks
};

const std::vector<Signature>& signatures() {
  static const std::vector<Signature> kSignatures = {
      Signature{"<!doctype html", text("an HTML page"), Remedy::Download, true},
      Signature{"<html", text("an HTML page"), Remedy::Download, true},
      Signature{"version https://git-lfs"sv, text("a pointer of Git LFS"), Remedy::Download, true},
      Signature{"%pdf-", text("a PDF document"), Remedy::Export, true},
      Signature{"{\\rtf", text("an RTF document"), Remedy::Export, true},
      Signature{"%!ps", text("a PostScript document"), Remedy::Export, true},
      Signature{"\x89PNG"sv, text("a PNG picture"), Remedy::Export},
      Signature{"\xFF\xD8\xFF"sv, text("a JPEG picture"), Remedy::Export},
      Signature{"RIFF"sv, text("a RIFF file (a WebP picture, a sound or a film)"), Remedy::Export},
      Signature{"GIF8"sv, text("a GIF picture"), Remedy::Export},
      Signature{"II*\0"sv, text("a TIFF picture"), Remedy::Export},
      Signature{"MM\0*"sv, text("a TIFF picture"), Remedy::Export},
      Signature{"\x1F\x8B"sv, text("a gzip archive"), Remedy::Unpack},
      Signature{"7z\xBC\xAF\x27\x1C"sv, text("a 7-Zip archive"), Remedy::Unpack},
      Signature{"Rar!\x1A\x07"sv, text("a RAR archive"), Remedy::Unpack},
      Signature{"\xFD\x37zXZ"sv, text("an xz archive"), Remedy::Unpack},
      Signature{"\x28\xB5\x2F\xFD"sv, text("a Zstandard archive"), Remedy::Unpack},
      Signature{"BZh"sv, text("a bzip2 archive"), Remedy::Unpack},
      Signature{"\x7F"
                "ELF"sv,
                text("a program"), Remedy::Export},
      Signature{"MZ\x90\0"sv, text("a program of Windows"), Remedy::Export},
      Signature{"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv,
                text("a compound document (such as SolidWorks, Inventor or older Office files)"),
                Remedy::Export},
      Signature{"Kaydara FBX"sv, text("an FBX scene"), Remedy::ExportMesh},
      Signature{"; fbx", text("an FBX scene"), Remedy::ExportMesh, true},
      Signature{"BLENDER"sv, text("a Blender scene"), Remedy::ExportMesh},
      Signature{"glTF"sv, text("a glTF scene"), Remedy::ExportMesh},
      Signature{"#vrml", text("a VRML scene"), Remedy::ExportMesh, true},
      Signature{"3D Geometry File Format"sv, text("a Rhino model"), Remedy::Export},
      Signature{"**abcdefghijklmnopqrstuvwxyz", text("a Parasolid model"), Remedy::Export, true},
      Signature{"PS\0"sv, text("a Parasolid model"), Remedy::Export},
      Signature{"V5_CFV2"sv, text("a CATIA document"), Remedy::Export},
      Signature{"V_CFV2"sv, text("a CATIA document"), Remedy::Export},
      Signature{"#ugc:", text("a Creo model"), Remedy::Export, true},
      Signature{"acis binaryfile", text("an ACIS model"), Remedy::Export, true},
      Signature{"AC10"sv, text("a DWG drawing"), Remedy::Export},
      Signature{"autocad binary dxf", text("a DXF drawing"), Remedy::Export, true},
      Signature{"astm-e57", text("an E57 point cloud"), Remedy::ExportMesh, true},
      Signature{"LASF"sv, text("a LAS point cloud"), Remedy::ExportMesh},
      Signature{"# .pcd", text("a PCD point cloud"), Remedy::ExportMesh, true},
      Signature{"# vtk datafile", text("a VTK file"), Remedy::ExportMesh, true},
      Signature{"$meshformat", text("a Gmsh mesh"), Remedy::ExportMesh, true},
      Signature{"off\n", text("an OFF mesh"), Remedy::ExportMesh, true},
      Signature{"off\r", text("an OFF mesh"), Remedy::ExportMesh, true},
  };
  return kSignatures;
}

/// Roots of XML documents.
const std::vector<Signature>& xmlRoots() {
  static const std::vector<Signature> kXmlRoots = {
      Signature{"<html", text("an HTML page"), Remedy::Download},
      Signature{"<amf", text("an AMF model"), Remedy::ExportMesh},
      Signature{"<collada", text("a COLLADA scene"), Remedy::ExportMesh},
      Signature{"<x3d", text("an X3D scene"), Remedy::ExportMesh},
      Signature{"<svg", text("an SVG drawing"), Remedy::Export},
      Signature{"<vtkfile", text("a VTK file"), Remedy::ExportMesh},
      Signature{"<model", text("the model part of a 3MF package without its package"),
                Remedy::Export},
      Signature{"<", text("an XML document"), Remedy::Export},
  };
  return kXmlRoots;
}

constexpr std::size_t kHeadSize = 1024;
constexpr std::size_t kJtVersion = 80;

Text remedyText(Remedy remedy) {
  switch (remedy) {
    case Remedy::Download:
      return "download the file itself, not the page that shows it";
    case Remedy::Unpack:
      return "unpack the archive and open the part in it";
    case Remedy::ExportMesh:
      return "save it as STL, OBJ, PLY or 3MF with the program that made it";
    case Remedy::Export:
      break;
  }
  return "export the part as STEP, or as STL, OBJ, PLY or 3MF";
}

ForeignFormat of(const Signature& signature) {
  return {signature.name, remedyText(signature.remedy)};
}

std::string lowerText(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
  lower.erase(0, lower.find_first_not_of(" \t\r\n"));
  return lower;
}

/// "  0", "SECTION" on the first two lines.
bool looksLikeDxf(std::string_view head) {
  TextScanner scanner(head);
  return scanner.word() == "0" && scanner.word() == "SECTION";
}

}  // namespace

std::optional<ForeignFormat> foreignFormat(std::string_view bytes) {
  if (!bytes.empty() && bytes.find_first_not_of('\0') == std::string_view::npos) {
    return ForeignFormat{text("a file of zeros only"),
                         text("its content was lost; take another copy of it")};
  }
  const std::string_view head = bytes.substr(0, kHeadSize);
  const std::string lower = lowerText(PlainText(head).view());
  for (const Signature& signature : signatures()) {
    const std::string_view where = signature.letters ? std::string_view(lower) : head;
    if (where.starts_with(signature.bytes)) {
      return of(signature);
    }
  }
  if (lower.starts_with("<?xml") || lower.starts_with("<!--")) {
    for (const Signature& root : xmlRoots()) {
      if (lower.find(root.bytes, 1) != std::string::npos) {
        return of(root);
      }
    }
  }
  if (looksLikeDxf(PlainText(head).view())) {
    return ForeignFormat{text("a DXF drawing"), remedyText(Remedy::Export)};
  }
  if (head.substr(0, kJtVersion).find(" JT ") != std::string_view::npos &&
      head.starts_with("Version ")) {
    return ForeignFormat{text("a JT model"), remedyText(Remedy::Export)};
  }
  return std::nullopt;
}

}  // namespace wcam::io
