// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/mesh.hpp"

namespace wcam::io {

/// Numbers the vertices along a Morton curve (2^10 cells per axis, ties keep their order) and sorts
/// the triangles by their lowest vertex. O(n). The coordinates must be finite.
void sortForLocality(geometry::TriangleMesh& mesh);

}  // namespace wcam::io
