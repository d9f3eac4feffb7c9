// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/brep.hpp"
#include "wcam/geometry/mesh.hpp"

#include <memory>
#include <optional>
#include <string>

namespace wcam::geometry {

/// The surface that is sliced: a mesh with its half-edges and, for CAD parts, the exact geometry
/// behind it. Immutable once built; shared by content hash.
struct PartSurface {
  TriangleMesh mesh;
  HalfEdges halfEdges;
  std::shared_ptr<const Brep> brep;  ///< null for mesh files
  BrepBinding binding;               ///< empty for mesh files
  std::string hash;                  ///< SHA-256 over file, options and placement

  [[nodiscard]] bool exact() const noexcept { return brep != nullptr; }
};

/// The triangles of some faces only (working surface picked by the user). @throws
/// Error(InvalidArgument) when a face does not exist or the part is a mesh without faces.
PartSurface selectFaces(const PartSurface& surface, const std::vector<int>& faces);

}  // namespace wcam::geometry
