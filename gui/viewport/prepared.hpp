// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene_data.hpp"

#include <memory>

namespace wcam::viewport {

/// A mesh ready to be shown. Made in the background, so that the thread of the view only hands it
/// on.
class PreparedMesh;
std::shared_ptr<const PreparedMesh> prepare(MeshData mesh);

/// A path ready to be shown: solids of its beads, or lines when it has too many moves. It belongs
/// to one scene at a time.
class PreparedPath;
std::shared_ptr<PreparedPath> prepare(std::shared_ptr<const PathData> path);

}  // namespace wcam::viewport
