// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/mesh.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace wcam::io {

/// A mesh as a mesh file has it, in file units: equal points joined, nothing else repaired.
struct ParsedMesh {
  geometry::TriangleMesh mesh;
  std::size_t weldedPoints = 0;  ///< points of the file that were equal to another
  std::size_t trailingBytes = 0;
  bool endMissing = false;  ///< an ASCII file without its last line
  std::string name;         ///< of the solid, may be empty
};

/// True when the bytes are a binary STL file of exactly the size that its header tells, or text
/// that starts like an ASCII one.
bool looksLikeStl(std::string_view bytes);

/// Reads a binary or an ASCII STL file. A pure function of the bytes; O(n), memory about twice the
/// file. Vertices come in Morton order and triangles by their lowest vertex, so that neighbours lie
/// close in memory.
/// @param file for messages
/// @throws Error(InputInvalid) naming triangle or line; CancelledError
ParsedMesh parseStl(std::string_view bytes, const std::string& file, const JobContext& context);

}  // namespace wcam::io
