// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"

#include "part_builder.hpp"

#include <string>
#include <string_view>

namespace wcam::io {

/// What a STEP file has of tessellated shapes (AP242), which the CAD library does not read.
enum class Tessellation {
  None,
  Beside,  ///< beside exact faces
  Only     ///< and no exact face
};

/// From the names of the entities, without taking the file apart.
Tessellation tessellationOf(std::string_view text);

/// Reads the triangles of the tessellated shape representations: solids, shells and sets of
/// triangulated faces with their strips and fans; units as the file tells them. Annotations are
/// not shapes. Assemblies and shapes that are placed apart are refused.
/// @throws Error(InputInvalid) naming the entity
RawMesh parseTessellatedStep(std::string_view text,
                             const std::string& file,
                             const JobContext& context);

}  // namespace wcam::io
