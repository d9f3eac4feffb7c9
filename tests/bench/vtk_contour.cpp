// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vtk_contour.hpp"

#include <vtkCellArray.h>
#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStripper.h>

#include <cmath>

namespace wcam::bench {

struct VtkContourer::Impl {
  vtkNew<vtkPolyData> mesh;
  vtkSmartPointer<vtkPolyData> lines;
};

VtkContourer::VtkContourer(const std::vector<double>& positions,
                           const std::vector<unsigned>& triangles,
                           const std::vector<double>& scalar)
    : impl_(std::make_unique<Impl>()) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(positions.size() / 3));
  for (std::size_t v = 0; v < positions.size() / 3; ++v) {
    points->SetPoint(static_cast<vtkIdType>(v), positions.data() + 3 * v);
  }
  vtkNew<vtkCellArray> cells;
  for (std::size_t t = 0; t < triangles.size() / 3; ++t) {
    const vtkIdType corners[3] = {triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]};
    cells->InsertNextCell(3, corners);
  }
  vtkNew<vtkDoubleArray> values;
  values->SetName("distance");
  for (const double value : scalar) {
    values->InsertNextValue(value);
  }
  impl_->mesh->SetPoints(points);
  impl_->mesh->SetPolys(cells);
  impl_->mesh->GetPointData()->SetScalars(values);
}

VtkContourer::~VtkContourer() = default;

void VtkContourer::run(const std::vector<double>& levels) {
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(impl_->mesh);
  contour->SetNumberOfContours(static_cast<int>(levels.size()));
  for (std::size_t k = 0; k < levels.size(); ++k) {
    contour->SetValue(static_cast<int>(k), levels[k]);
  }
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(contour->GetOutputPort());
  // The default cuts polylines to 1000 points.
  stripper->SetMaximumLength(100000000);
  stripper->Update();
  impl_->lines = stripper->GetOutput();
}

VtkContours VtkContourer::measure() const {
  VtkContours result;
  vtkCellArray* lines = impl_->lines->GetLines();
  const vtkIdType* ids = nullptr;
  vtkIdType count = 0;
  for (lines->InitTraversal(); lines->GetNextCell(count, ids) != 0;) {
    ++result.polylines;
    result.points += static_cast<std::size_t>(count);
    for (vtkIdType i = 1; i < count; ++i) {
      double a[3];
      double b[3];
      impl_->lines->GetPoint(ids[i - 1], a);
      impl_->lines->GetPoint(ids[i], b);
      result.length += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
    }
  }
  return result;
}

}  // namespace wcam::bench
