// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/toolpath/slicing.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace wcam::toolpath {

/// A path that was planned elsewhere: layers of contours as the file gives them, part frame. What
/// the file does not tell stays unset: height, width and axis 0, normals as the flags say.
struct ImportedPath {
  std::vector<std::vector<Contour>> layers;
  bool hasNormals = false;  ///< ContourPoint::n is from the file
  bool hasAxes = false;     ///< ContourPoint::axis is from the file
};

/// Reads the table of points that the program writes for an operation: CSV with a header line that
/// names the columns with their units. Needed: layer, bead, x_mm, y_mm, z_mm. Used when there:
/// op, nx, ny, nz, bx, by, bz, ax, ay, az, height_mm, width_mm, arc. Others are left out: speeds
/// and joints follow from the process and the cell of the project. Lines that are empty or begin
/// with
/// '#' are left out.
///
/// A row with arc 0 is reached without the arc: such moves are left out, and one inside a bead
/// parts it in two. A bead that ends where it starts is closed.
/// @param source named in errors
/// @throws Error(InputInvalid) with the line: a missing or repeated column, a unit that is not
/// read, a wrong number of cells, what is no finite number, layers or beads that do not ascend,
/// several operations, vectors without length, no bead of two points
ImportedPath readPathTable(std::string_view text,
                           const std::string& source,
                           const JobContext& context = JobContext());

}  // namespace wcam::toolpath
