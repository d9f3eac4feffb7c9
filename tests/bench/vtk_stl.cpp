// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_stl.hpp"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

namespace wcam::bench {

VtkCounts readWithVtk(const std::string& file) {
  const vtkNew<vtkSTLReader> reader;
  reader->SetFileName(file.c_str());
  reader->MergingOn();
  reader->Update();
  return {static_cast<std::size_t>(reader->GetOutput()->GetNumberOfPoints()),
          static_cast<std::size_t>(reader->GetOutput()->GetNumberOfCells())};
}

}  // namespace wcam::bench
