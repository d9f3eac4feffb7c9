// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace wcam::bench {

/// What VTK made of the level sets.
struct VtkContours {
  std::size_t polylines = 0;
  std::size_t points = 0;
  double length = 0.0;
};

/// vtkContourFilter and vtkStripper on a mesh with a scalar per vertex. The header names no VTK
/// type: VTK 9.1 does not compile as C++20.
class VtkContourer {
public:
  /// @param positions x, y, z per vertex; @param triangles three indices each
  VtkContourer(const std::vector<double>& positions,
               const std::vector<unsigned>& triangles,
               const std::vector<double>& scalar);
  ~VtkContourer();
  /// Runs both filters; kept until measure().
  void run(const std::vector<double>& levels);
  [[nodiscard]] VtkContours measure() const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wcam::bench
