// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/brep.hpp"

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <memory>
#include <string>
#include <vector>

namespace wcam::geometry {

/// The OpenCASCADE side of a Brep: for module geometry and the CAD readers of module io only.
struct Brep::Impl {
  std::vector<BrepFaceInfo> faceInfos;
  std::vector<BrepEdgeInfo> edgeInfos;
  std::vector<TopoDS_Face> faces;  ///< with location and orientation, part frame
  std::vector<TopoDS_Edge> edges;  ///< forward, without degenerated edges, part frame
};

/// All faces and edges of a shape that stands in the part frame, each once, in the order of the
/// shape. Names stay empty. May throw Standard_Failure.
std::unique_ptr<Brep::Impl> makeBrepImpl(const TopoDS_Shape& shape);

}  // namespace wcam::geometry
