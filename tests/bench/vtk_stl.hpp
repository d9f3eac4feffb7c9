// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace wcam::bench {

struct VtkCounts {
  std::size_t points = 0;
  std::size_t triangles = 0;
};

/// Reads with vtkSTLReader, points merged. In a file of its own, since VTK 9.1 is built as C++17.
VtkCounts readWithVtk(const std::string& file);

}  // namespace wcam::bench
