// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"

#include "part_builder.hpp"

#include <string>
#include <string_view>

namespace wcam::io {

/// Wavefront OBJ: vertices, faces and lines' names, in any order; polygons are divided. Lines,
/// points and free forms are left out and told, colours and the like skipped.
/// @throws Error(InputInvalid) naming the line
RawMesh parseObj(std::string_view bytes, const std::string& file, const JobContext& context);

/// PLY in its three encodings; the elements "vertex", "face" and "tristrips" in any order, all
/// others are skipped. The counts of the header are compared with the size of the file first.
/// @throws Error(InputInvalid) naming element and number
RawMesh parsePly(std::string_view bytes, const std::string& file, const JobContext& context);

/// 3MF: the items of the build with their components and transforms, also those in other model
/// parts of the package (production extension); units as the file tells them. Negative volumes of
/// slicers are cut out; what is not to be built and shapes that are no meshes are left out and
/// told. @throws Error(InputInvalid) naming the part of the package and the line
RawMesh parseThreeMf(std::string_view bytes, const std::string& file, const JobContext& context);

}  // namespace wcam::io
