// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene_data.hpp"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace wcam::viewport {

vtkSmartPointer<vtkFloatArray> vectorsOf(const std::vector<float>& values);
vtkSmartPointer<vtkPoints> pointsOf(const std::vector<float>& positions);
vtkSmartPointer<vtkCellArray> cellsOf(const std::vector<long long>& offsets,
                                      const std::vector<long long>& corners);
/// Cells [first, last) of an array.
vtkSmartPointer<vtkCellArray> cellRange(vtkCellArray* cells, std::size_t first, std::size_t last);

/// Triangles with vertex normals; corners at sharp edges and borders of faces get normals of their
/// own.
vtkSmartPointer<vtkPolyData> surfaceOf(const MeshData& mesh);
/// The edges as polylines.
vtkSmartPointer<vtkPolyData> edgesOf(const MeshData& mesh);

}  // namespace wcam::viewport
