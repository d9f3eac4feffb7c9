// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/cell.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/substrate.hpp"

#include "viewport/scene_data.hpp"

#include <vector>

namespace wcam::gui {

/// Triangles with faces, and CAD edges; of a mesh file the borders and sharp edges.
viewport::MeshData meshOf(const geometry::PartSurface& surface);
/// Plate or body in the part frame.
viewport::MeshData meshOf(const toolpath::Substrate& substrate);

viewport::Matrix matrixOf(const geometry::Pose& pose);

/// The cell as solids: one body per joint frame of the robot, then of the positioner, then base,
/// table, world, flange and tcp. The collision shapes of the cell file where it has some, else
/// capsules along the links. Bodies are moved by bodyPoses().
std::vector<viewport::Body> bodiesOf(const cell::Cell& cell);
/// Poses of the bodies in the base frame.
std::vector<geometry::Pose> bodyPoses(const cell::Cell& cell, const cell::JointVector& q);

}  // namespace wcam::gui
