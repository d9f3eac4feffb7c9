// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/base/quantity.hpp"
#include "wcam/geometry/mesh.hpp"

#include <cmath>
#include <random>

namespace wcam::test {

/// Closed torus about z: tube radius r around a circle R, outward triangles.
inline geometry::TriangleMesh torusMesh(double R, double r, int around, int along) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      const double u = 2.0 * kPi * i / along;
      const double v = 2.0 * kPi * j / around;
      const double rho = R + r * std::cos(v);
      mesh.vertices.emplace_back(rho * std::cos(u), rho * std::sin(u), r * std::sin(v));
    }
  }
  const auto index = [&](int i, int j) {
    return static_cast<std::uint32_t>((i % along) * around + j % around);
  };
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return mesh;
}

/// Open tube about z from z = 0 to z = height, outward triangles.
inline geometry::TriangleMesh tubeMesh(double radius, double height, int around, int rows) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j < around; ++j) {
      const double v = 2.0 * kPi * j / around;
      mesh.vertices.emplace_back(radius * std::cos(v), radius * std::sin(v), height * i / rows);
    }
  }
  const auto index = [&](int i, int j) {
    return static_cast<std::uint32_t>(i * around + j % around);
  };
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < around; ++j) {
      mesh.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
    }
  }
  return mesh;
}

/// Axis-parallel box, outward triangles.
inline geometry::TriangleMesh boxMesh(const geometry::Vec3& min, const geometry::Vec3& max) {
  geometry::TriangleMesh mesh;
  for (int k = 0; k < 8; ++k) {
    mesh.vertices.emplace_back(k & 1 ? max.x() : min.x(), k & 2 ? max.y() : min.y(),
                               k & 4 ? max.z() : min.z());
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

}  // namespace wcam::test
