// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "foreign_format.hpp"

#include "text_scanner.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace wcam::io {

namespace {

using namespace std::string_view_literals;

enum class Remedy { Download, Export, Unpack, ExportMesh };

struct Signature {
  std::string_view bytes;  ///< lower case where it is text
  const char* name;
  Remedy remedy;
  bool text = false;  ///< letters in any case, after blanks
};

constexpr std::array kSignatures = {
    Signature{"<!doctype html", "an HTML page", Remedy::Download, true},
    Signature{"<html", "an HTML page", Remedy::Download, true},
    Signature{"version https://git-lfs"sv, "a pointer of Git LFS", Remedy::Download, true},
    Signature{"%pdf-", "a PDF document", Remedy::Export, true},
    Signature{"{\\rtf", "an RTF document", Remedy::Export, true},
    Signature{"%!ps", "a PostScript document", Remedy::Export, true},
    Signature{"\x89PNG"sv, "a PNG picture", Remedy::Export},
    Signature{"\xFF\xD8\xFF"sv, "a JPEG picture", Remedy::Export},
    Signature{"GIF8"sv, "a GIF picture", Remedy::Export},
    Signature{"II*\0"sv, "a TIFF picture", Remedy::Export},
    Signature{"MM\0*"sv, "a TIFF picture", Remedy::Export},
    Signature{"\x1F\x8B"sv, "a gzip archive", Remedy::Unpack},
    Signature{"7z\xBC\xAF\x27\x1C"sv, "a 7-Zip archive", Remedy::Unpack},
    Signature{"Rar!\x1A\x07"sv, "a RAR archive", Remedy::Unpack},
    Signature{"\xFD\x37zXZ"sv, "an xz archive", Remedy::Unpack},
    Signature{"\x28\xB5\x2F\xFD"sv, "a Zstandard archive", Remedy::Unpack},
    Signature{"BZh"sv, "a bzip2 archive", Remedy::Unpack},
    Signature{"\x7F"
              "ELF"sv,
              "a program", Remedy::Export},
    Signature{"MZ\x90\0"sv, "a program of Windows", Remedy::Export},
    Signature{"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv,
              "a compound document (such as SolidWorks, Inventor or older Office files)",
              Remedy::Export},
    Signature{"Kaydara FBX"sv, "an FBX scene", Remedy::ExportMesh},
    Signature{"; fbx", "an FBX scene", Remedy::ExportMesh, true},
    Signature{"BLENDER"sv, "a Blender scene", Remedy::ExportMesh},
    Signature{"glTF"sv, "a glTF scene", Remedy::ExportMesh},
    Signature{"#vrml", "a VRML scene", Remedy::ExportMesh, true},
    Signature{"3D Geometry File Format"sv, "a Rhino model", Remedy::Export},
    Signature{"**abcdefghijklmnopqrstuvwxyz", "a Parasolid model", Remedy::Export, true},
    Signature{"PS\0"sv, "a Parasolid model", Remedy::Export},
    Signature{"V5_CFV2"sv, "a CATIA document", Remedy::Export},
    Signature{"V_CFV2"sv, "a CATIA document", Remedy::Export},
    Signature{"#ugc:", "a Creo model", Remedy::Export, true},
    Signature{"acis binaryfile", "an ACIS model", Remedy::Export, true},
    Signature{"AC10"sv, "a DWG drawing", Remedy::Export},
    Signature{"autocad binary dxf", "a DXF drawing", Remedy::Export, true},
    Signature{"astm-e57", "an E57 point cloud", Remedy::ExportMesh, true},
    Signature{"LASF"sv, "a LAS point cloud", Remedy::ExportMesh},
    Signature{"# .pcd", "a PCD point cloud", Remedy::ExportMesh, true},
    Signature{"# vtk datafile", "a VTK file", Remedy::ExportMesh, true},
    Signature{"$meshformat", "a Gmsh mesh", Remedy::ExportMesh, true},
    Signature{"off\n", "an OFF mesh", Remedy::ExportMesh, true},
    Signature{"off\r", "an OFF mesh", Remedy::ExportMesh, true},
};

/// Roots of XML documents.
constexpr std::array kXmlRoots = {
    Signature{"<html", "an HTML page", Remedy::Download},
    Signature{"<amf", "an AMF model", Remedy::ExportMesh},
    Signature{"<collada", "a COLLADA scene", Remedy::ExportMesh},
    Signature{"<x3d", "an X3D scene", Remedy::ExportMesh},
    Signature{"<svg", "an SVG drawing", Remedy::Export},
    Signature{"<vtkfile", "a VTK file", Remedy::ExportMesh},
    Signature{"<model", "the model part of a 3MF package without its package", Remedy::Export},
    Signature{"<", "an XML document", Remedy::Export},
};

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
    return ForeignFormat{"a file of zeros only", "its content was lost; take another copy of it"};
  }
  const std::string_view head = bytes.substr(0, kHeadSize);
  const std::string text = lowerText(PlainText(head).view());
  for (const Signature& signature : kSignatures) {
    const std::string_view where = signature.text ? std::string_view(text) : head;
    if (where.starts_with(signature.bytes)) {
      return of(signature);
    }
  }
  if (text.starts_with("<?xml") || text.starts_with("<!--")) {
    for (const Signature& root : kXmlRoots) {
      if (text.find(root.bytes, 1) != std::string::npos) {
        return of(root);
      }
    }
  }
  if (looksLikeDxf(PlainText(head).view())) {
    return ForeignFormat{"a DXF drawing", remedyText(Remedy::Export)};
  }
  if (head.substr(0, kJtVersion).find(" JT ") != std::string_view::npos &&
      head.starts_with("Version ")) {
    return ForeignFormat{"a JT model", remedyText(Remedy::Export)};
  }
  return std::nullopt;
}

}  // namespace wcam::io
