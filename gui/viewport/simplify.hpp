// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene_data.hpp"

#include <cstddef>

namespace wcam::viewport {

/// A mesh of about `most` triangles that looks like the given one: vertices in the same cell of a
/// grid become their mean, triangles that lose an edge go (vertex clustering). Faces stay with
/// their triangles, edges as they are. What has no more than `most` triangles comes back unchanged.
/// n·log n.
MeshData simplified(MeshData mesh, std::size_t most);

}  // namespace wcam::viewport
