// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/error.hpp"

#include "mesh_readers.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace wcam::fuzz {

/// Triangles name vertices that exist and are finite.
inline void checkMesh(const geometry::TriangleMesh& mesh) {
  for (const auto& vertex : mesh.vertices) {
    WCAM_ASSERT(vertex.allFinite());
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      WCAM_ASSERT(corner < mesh.vertices.size());
    }
  }
}

template <class Reader>
void checkReader(Reader read, const std::uint8_t* data, std::size_t size, const std::string& file) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    checkMesh(read(bytes, file, JobContext()).mesh);
  } catch (const Error& error) {
    WCAM_ASSERT(error.code() == ErrorCode::InputInvalid);
  }
}

}  // namespace wcam::fuzz
