// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene_data.hpp"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace wcam::viewport {

vtkSmartPointer<vtkPolyData> solidMesh(const Solid& solid);
vtkSmartPointer<vtkPolyData> sphereMesh(double radius);
/// A torch whose wire tip is the origin and whose axis is z.
std::vector<Solid> torchSolids();

}  // namespace wcam::viewport
