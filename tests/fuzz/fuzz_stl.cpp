// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"

#include "stl_parser.hpp"

#include <cstdint>
#include <string_view>

namespace {

/// Triangles name vertices that exist and are finite, and every corner of the file is counted.
void checkMesh(const wcam::io::ParsedMesh& parsed, std::size_t bytes) {
  const wcam::geometry::TriangleMesh& mesh = parsed.mesh;
  WCAM_ASSERT(mesh.vertices.size() + parsed.weldedPoints == 3 * mesh.triangles.size());
  WCAM_ASSERT(parsed.trailingBytes <= bytes);
  for (const auto& vertex : mesh.vertices) {
    WCAM_ASSERT(vertex.allFinite());
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      WCAM_ASSERT(corner < mesh.vertices.size());
    }
  }
}

}  // namespace

/// A sound mesh comes out, or an error of the file's kind.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  (void)wcam::io::looksLikeStl(bytes);
  try {
    checkMesh(wcam::io::parseStl(bytes, "fuzz.stl", wcam::JobContext()), size);
  } catch (const wcam::Error& error) {
    WCAM_ASSERT(error.code() == wcam::ErrorCode::InputInvalid);
  }
  return 0;
}
