// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brep_impl.hpp"
#include "cad_reader.hpp"
#include <TopoDS_Shape.hxx>

#include <vector>

namespace wcam::io {

/// Makes the curves of seams in the parameters of faces exactly straight: rounding that tilts them
/// by 1e-14 keeps OpenCASCADE 7.6 from tessellating cones. In place; seams that are truly curved
/// stay.
/// @param faces indices of faces in `brep`
void straightenSeams(const geometry::Brep::Impl& brep, const std::vector<int>& faces);

/// Divides faces that close in themselves, so that they have no seams. The pieces keep the names of
/// their faces. May throw Standard_Failure.
TopoDS_Shape divideClosedFaces(const TopoDS_Shape& shape, CadModel& model);

}  // namespace wcam::io
