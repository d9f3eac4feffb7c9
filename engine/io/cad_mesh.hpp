// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/brep.hpp"
#include "wcam/geometry/mesh.hpp"

#include "brep_impl.hpp"
#include <TopoDS_Shape.hxx>

#include <vector>

namespace wcam::io {

/// A tessellated shape, tied to its faces and edges.
struct CadMesh {
  geometry::TriangleMesh mesh;
  geometry::BrepBinding binding;
  std::vector<int> unmeshedFaces;
};

/// Triangulates the faces of a shape and joins them by their common edges and vertices: a shell
/// that is closed by topology gives a closed mesh, whatever the gaps inside its tolerances. Poles
/// become one vertex. Replaces stored triangulations. One thread, so that the result depends on the
/// input only.
/// @param angle in rad
/// @throws CancelledError, Standard_Failure
CadMesh meshShape(const TopoDS_Shape& shape,
                  const geometry::Brep::Impl& brep,
                  double chord,
                  double angle,
                  const JobContext& context);

}  // namespace wcam::io
