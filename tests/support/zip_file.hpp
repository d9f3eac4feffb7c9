// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/json.hpp"
#include "wcam/geometry/mesh.hpp"

#include <minizip/zip.h>
#include <zlib.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace wcam::test {

inline void writeZip(const std::filesystem::path& file,
                     const std::vector<std::pair<std::string, std::string>>& parts) {
  zipFile zip = zipOpen64(file.c_str(), APPEND_STATUS_CREATE);
  for (const auto& [name, content] : parts) {
    zipOpenNewFileInZip(zip, name.c_str(), nullptr, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED,
                        Z_DEFAULT_COMPRESSION);
    zipWriteInFileInZip(zip, content.data(), static_cast<unsigned>(content.size()));
    zipCloseFileInZip(zip);
  }
  zipClose(zip, nullptr);
}

inline std::string threeMfRelations(const std::string& model) {
  return "<?xml version=\"1.0\"?><Relationships xmlns=\"http://schemas.openxmlformats.org/package/"
         "2006/relationships\"><Relationship Id=\"r\" Type=\"http://schemas.microsoft.com/"
         "3dmanufacturing/2013/01/3dmodel\" Target=\"" +
         model + "\"/></Relationships>";
}

inline std::string threeMfMesh(const geometry::TriangleMesh& mesh) {
  std::string text = "<mesh><vertices>";
  for (const geometry::Vec3& p : mesh.vertices) {
    text += "<vertex x=\"" + formatReal(p.x()) + "\" y=\"" + formatReal(p.y()) + "\" z=\"" +
            formatReal(p.z()) + "\"/>";
  }
  text += "</vertices><triangles>";
  for (const auto& t : mesh.triangles) {
    text += "<triangle v1=\"" + std::to_string(t[0]) + "\" v2=\"" + std::to_string(t[1]) +
            "\" v3=\"" + std::to_string(t[2]) + "\"/>\n";
  }
  return text + "</triangles></mesh>";
}

inline void writeThreeMf(const std::filesystem::path& file,
                         const geometry::TriangleMesh& mesh,
                         const std::string& unit) {
  writeZip(file, {{"_rels/.rels", threeMfRelations("/3D/3dmodel.model")},
                  {"3D/3dmodel.model",
                   "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"" + unit +
                       "\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">"
                       "<resources><object id=\"1\" type=\"model\">" +
                       threeMfMesh(mesh) +
                       "</object></resources><build><item objectid=\"1\"/></build></model>"}});
}

}  // namespace wcam::test
